/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A quadric at each point (see bubble.h).
 *
 * In coordinates from the point, over the mean length of its edges, f = 0 and
 * grad f = n at every point around it are four equations for the six numbers
 * of the Hessian.  As unknowns, those that are there twice count times sqrt 2,
 * so that their norm is that of the matrix, whatever the axes.  A flat part
 * leaves one direction undetermined: there the least norm makes it 0.
 */
#include "base/team.h"
#include "solve/bubble/bubble.h"

#include <gsl/gsl_linalg.h>

#include <math.h>
#include <string.h>

enum { UNKNOWNS = 6 };

/* Points that a thread takes at once, and as many as are worth a thread. */
enum { CHUNK = 64, WORTH = 1024 };

/* Singular values below this part of the largest are none. */
static const double CUT = 1e-8;

/* Room for the rows of one point. */
struct room {
  size_t points;          /* around it, at most */
  double *matrix, *right; /* [4 points][UNKNOWNS], [4 points] */
  size_t *ring;           /* [points] */
  size_t *seen;           /* of each point, the last one it was around */
};

/* The other points of the faces of a point, each once. */
static size_t ring_of(const struct ph_mesh *mesh, size_t at,
                      struct room *room) {
  size_t n = 0;
  room->seen[at] = at;
  for (size_t i = mesh->first[at]; i < mesh->first[at + 1]; i++) {
    for (size_t k = 0; k < 4; k++) {
      const size_t point = mesh->face[mesh->around[i]][k];
      if (room->seen[point] != at) {
        room->seen[point] = at;
        room->ring[n++] = point;
      }
    }
  }
  return n;
}

/* The mean length of the edges at a point, each of them counted by the first
 * of its faces. */
static double scale_of(const struct ph_bubble_data *data, size_t at) {
  const struct ph_mesh *mesh = &data->mesh;
  double sum = 0;
  size_t n = 0;
  for (size_t i = mesh->first[at]; i < mesh->first[at + 1]; i++) {
    const size_t face = mesh->around[i];
    for (size_t k = 0; k < 4; k++) {
      const struct ph_mesh_edge *e = &mesh->edge[mesh->side[face][k]];
      if ((e->point[0] == at || e->point[1] == at) && e->face[0] == face) {
        sum += ph_vec3_abs(
            ph_vec3_sub(data->at[e->point[1]].p, data->at[e->point[0]].p));
        n++;
      }
    }
  }
  return sum / (double)n;
}

/* The four rows of a point at x. */
static void set_rows(ph_vec3 x, double value, ph_vec3 gradient, double *rows,
                     double *right) {
  const double r = sqrt(2);
  const double a[4][UNKNOWNS] = {{x.x * x.x, x.y * x.y, x.z * x.z,
                                  r * x.x * x.y, r * x.x * x.z, r * x.y * x.z},
                                 {2 * x.x, 0, 0, r * x.y, r * x.z, 0},
                                 {0, 2 * x.y, 0, r * x.x, 0, r * x.z},
                                 {0, 0, 2 * x.z, 0, r * x.x, r * x.y}};
  const double b[] = {value, gradient.x, gradient.y, gradient.z};
  for (size_t i = 0; i < 4; i++) {
    for (size_t j = 0; j < UNKNOWNS; j++) {
      rows[UNKNOWNS * i + j] = a[i][j];
    }
    right[i] = b[i];
  }
}

/* The least squares solution of least norm; the matrix is lost.  The rows
 * become triangular before their singular values are found, by Jacobi's method,
 * as neither takes memory: GSL's other methods do, and use what they did not
 * get.
 */
static bool solve(struct room *room, size_t rows, double *x) {
  double v[UNKNOWNS * UNKNOWNS], s[UNKNOWNS], u[UNKNOWNS * UNKNOWNS];
  gsl_matrix_view A = gsl_matrix_view_array(room->matrix, rows, UNKNOWNS);
  gsl_matrix_view U = gsl_matrix_view_array(u, UNKNOWNS, UNKNOWNS);
  gsl_matrix_view V = gsl_matrix_view_array(v, UNKNOWNS, UNKNOWNS);
  gsl_vector_view b = gsl_vector_view_array(room->right, rows);
  gsl_vector_view S = gsl_vector_view_array(s, UNKNOWNS);
  if (gsl_linalg_QR_decomp(&A.matrix, &S.vector) != 0 ||
      gsl_linalg_QR_QTvec(&A.matrix, &S.vector, &b.vector) != 0) {
    return false;
  }
  for (size_t i = 0; i < UNKNOWNS * UNKNOWNS; i++) {
    u[i] = i % UNKNOWNS < i / UNKNOWNS ? 0 : room->matrix[i];
  }
  if (gsl_linalg_SV_decomp_jacobi(&U.matrix, &V.matrix, &S.vector) != 0) {
    return false;
  }
  for (size_t j = 0; j < UNKNOWNS; j++) {
    x[j] = 0;
  }
  for (size_t k = 0; k < UNKNOWNS && s[k] > CUT * s[0]; k++) {
    double along = 0;
    for (size_t i = 0; i < UNKNOWNS; i++) {
      along += u[UNKNOWNS * i + k] * room->right[i];
    }
    for (size_t j = 0; j < UNKNOWNS; j++) {
      x[j] += v[UNKNOWNS * j + k] * (along / s[k]);
    }
  }
  return true;
}

static bool fit_point(struct ph_bubble_data *data, size_t at,
                      struct room *room) {
  struct ph_quadric *q = &data->at[at];
  const double scale = scale_of(data, at), r = sqrt(2);
  const size_t n = ring_of(&data->mesh, at, room);
  double c[UNKNOWNS];
  for (size_t i = 0; i < n; i++) {
    const struct ph_quadric *w = &data->at[room->ring[i]];
    const ph_vec3 x = ph_vec3_scale(1 / scale, ph_vec3_sub(w->p, q->p));
    set_rows(x, -ph_vec3_dot(q->g, x), ph_vec3_sub(w->g, q->g),
             room->matrix + 4 * UNKNOWNS * i, room->right + 4 * i);
  }
  if (!solve(room, 4 * n, c)) {
    return false;
  }
  for (size_t j = 0; j < UNKNOWNS; j++) {
    q->H.c[j] = (j < 3 ? 2 : r) * c[j] / scale;
  }
  return true;
}

/* Quadrics on their way. */
struct fitter {
  struct ph_bubble_data *data;
  const struct ph_arena *arena;
  struct room *rooms;   /* [threads] */
  atomic_bool late;     /* out of room or time */
  atomic_size_t failed; /* the first point whose quadric is not found */
};

static void note_failed(struct fitter *f, size_t at) {
  size_t was = atomic_load(&f->failed);
  while (at < was && !atomic_compare_exchange_weak(&f->failed, &was, at)) {
    /* another thread was first */
  }
}

static bool fit_some(void *context, size_t thread, size_t first, size_t end) {
  struct fitter *f = context;
  if (!thread && ph_arena_late(f->arena)) { /* it is for one to ask */
    atomic_store(&f->late, true);
    return false;
  }
  for (size_t i = first; i < end; i++) {
    if (!fit_point(f->data, i, &f->rooms[thread])) {
      note_failed(f, i);
      return false;
    }
  }
  return true;
}

static bool set_room(const struct ph_mesh *mesh, struct ph_arena *scratch,
                     struct room *room) {
  *room = (struct room){0, NULL, NULL, NULL, NULL};
  for (size_t i = 0; i < mesh->points_n; i++) {
    const size_t n = 3 * (mesh->first[i + 1] - mesh->first[i]);
    room->points = n > room->points ? n : room->points;
  }
  room->matrix = ph_arena_array(scratch, room->points,
                                4 * UNKNOWNS * sizeof *room->matrix);
  room->right = ph_arena_array(scratch, room->points, 4 * sizeof *room->right);
  room->ring = ph_arena_array(scratch, room->points, sizeof *room->ring);
  room->seen = ph_arena_array(scratch, mesh->points_n, sizeof *room->seen);
  if (!room->matrix || !room->right || !room->ring || !room->seen) {
    return false;
  }
  memset(room->seen, 0xff, mesh->points_n * sizeof *room->seen);
  return true;
}

enum ph_status ph_bubble_fit(struct ph_bubble_data *data,
                             struct ph_arena *scratch, struct ph_diag *diag) {
  const size_t n = data->mesh.points_n;
  struct ph_mark mark = ph_arena_mark(scratch);
  atomic_int *spare = scratch->budget ? scratch->budget->spare : NULL;
  const size_t threads = ph_team_take(spare, n / WORTH);
  struct fitter f = {.data = data, .arena = scratch};
  size_t failed;
  bool good;
  f.rooms = ph_arena_array(scratch, threads, sizeof *f.rooms);
  good = f.rooms != NULL;
  for (size_t i = 0; good && i < threads; i++) {
    good = set_room(&data->mesh, scratch, &f.rooms[i]);
  }
  atomic_init(&f.late, !good);
  atomic_init(&f.failed, SIZE_MAX);
  /* where there is no room the threads are given back all the same */
  ph_team_spread(spare, threads, good ? n : 0, CHUNK, fit_some, &f);
  good = !atomic_load(&f.late);
  failed = atomic_load(&f.failed);
  ph_arena_release(scratch, mark);
  if (good && failed < n) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "points", failed,
                      "has points around it that are too uneven for a quadric");
  }
  return good ? PH_OK : ph_fail_memory(diag);
}
