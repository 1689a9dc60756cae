/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steps of Catmull and Clark on meshes of any polygons (see bubble.h): a step
 * puts a point on each face, the mean of its points, and one on each edge, and
 * moves the points that there were; faces become as many quadrilaterals as
 * they have corners.  Normals move by the same weights.
 *
 *   edge      (both ends + both points of faces) / 4, at a boundary the middle
 *   point     (Q + 2 R + (k - 3) P) / k, of k edges: Q the mean of the points
 * of its faces, R that of the middles of its edges; at a boundary 3/4 P + 1/8
 * of both neighbours there; where it belongs to one face, or to more than two
 * edges of boundaries, or the boundary is fixed, P
 *
 * Points keep their numbers; those of faces follow, then those of edges.
 */
#include "solve/bubble/bubble.h"

#include <stdlib.h>
#include <string.h>

/* Numbers of a point: of its normal as well. */
enum { WIDTH = 6 };

/* A side of a face: its points in order, and its corner. */
struct side {
  size_t low, high, corner;
};

struct step {
  const struct ph_polygons *from;
  struct side *sides;
  size_t *edge; /* [corners] from the corner to the next */
  size_t *face; /* [corners] */
  size_t edges_n;
  /* of each point, sums over its */
  double (*middles)[WIDTH], (*centers)[WIDTH], (*beside)[WIDTH];
  size_t *edges, *faces, *open; /* edges, faces, edges at the boundary */
};

static int by_points(const void *left, const void *right) {
  const struct side *a = left, *b = right;
  return a->low != b->low ? (a->low > b->low) - (a->low < b->low)
         : a->high != b->high
             ? (a->high > b->high) - (a->high < b->high)
             : (a->corner > b->corner) - (a->corner < b->corner);
}

static void add(double *to, double factor, const double *x) {
  for (size_t i = 0; i < WIDTH; i++) {
    to[i] += factor * x[i];
  }
}

static bool allocate(struct step *s, struct ph_arena *arena) {
  const size_t n = s->from->points_n,
               corners = s->from->first[s->from->faces_n];
  s->sides = ph_arena_array(arena, corners, sizeof *s->sides);
  s->edge = ph_arena_array(arena, corners, sizeof *s->edge);
  s->face = ph_arena_array(arena, corners, sizeof *s->face);
  s->middles = ph_arena_array(arena, n, sizeof *s->middles);
  s->centers = ph_arena_array(arena, n, sizeof *s->centers);
  s->beside = ph_arena_array(arena, n, sizeof *s->beside);
  s->edges = ph_arena_array(arena, n, sizeof *s->edges);
  s->faces = ph_arena_array(arena, n, sizeof *s->faces);
  s->open = ph_arena_array(arena, n, sizeof *s->open);
  if (!s->sides || !s->edge || !s->face || !s->middles || !s->centers ||
      !s->beside || !s->edges || !s->faces || !s->open) {
    return false;
  }
  memset(s->middles, 0, n * sizeof *s->middles);
  memset(s->centers, 0, n * sizeof *s->centers);
  memset(s->beside, 0, n * sizeof *s->beside);
  memset(s->edges, 0, n * sizeof *s->edges);
  memset(s->faces, 0, n * sizeof *s->faces);
  memset(s->open, 0, n * sizeof *s->open);
  return true;
}

/* The corner that follows in its face. */
static size_t next_of(const struct step *s, size_t corner) {
  const size_t *first = s->from->first + s->face[corner];
  return corner + 1 < first[1] ? corner + 1 : first[0];
}

static enum ph_status find_edges(struct step *s, struct ph_diag *diag) {
  const struct ph_polygons *from = s->from;
  const size_t corners = from->first[from->faces_n];
  for (size_t f = 0; f < from->faces_n; f++) {
    for (size_t c = from->first[f]; c < from->first[f + 1]; c++) {
      s->face[c] = f;
    }
  }
  for (size_t c = 0; c < corners; c++) {
    const size_t a = from->corner[c], b = from->corner[next_of(s, c)];
    s->sides[c] = (struct side){a < b ? a : b, a < b ? b : a, c};
  }
  qsort(s->sides, corners, sizeof *s->sides, by_points);
  s->edges_n = 0;
  for (size_t i = 0, run = 0; i < corners; i++) {
    const struct side *side = &s->sides[i];
    const bool same =
        i > 0 && side[-1].low == side->low && side[-1].high == side->high;
    run = same ? run + 1 : 1;
    if (run > 2) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "faces", s->face[side->corner],
                        "is the third one at the edge of points %zu and %zu, "
                        "after faces %zu and %zu; two are allowed",
                        side->low, side->high, s->face[side[-2].corner],
                        s->face[side[-1].corner]);
    }
    s->edges_n += !same;
    s->edge[side->corner] = s->edges_n - 1;
  }
  return PH_OK;
}

/* Points of faces, and what their corners have of them. */
static void set_centers(struct step *s, double (*to)[WIDTH]) {
  const struct ph_polygons *from = s->from;
  memset(to, 0, from->faces_n * sizeof *to);
  for (size_t f = 0; f < from->faces_n; f++) {
    const size_t n = from->first[f + 1] - from->first[f];
    for (size_t c = from->first[f]; c < from->first[f + 1]; c++) {
      add(to[f], 1 / (double)n, from->x[from->corner[c]]);
    }
    for (size_t c = from->first[f]; c < from->first[f + 1]; c++) {
      add(s->centers[from->corner[c]], 1, to[f]);
      s->faces[from->corner[c]]++;
    }
  }
}

/* Points of edges, and what their ends have of them. */
static void set_middles(struct step *s, const double (*centers)[WIDTH],
                        double (*to)[WIDTH]) {
  const struct ph_polygons *from = s->from;
  const size_t corners = from->first[from->faces_n];
  memset(to, 0, s->edges_n * sizeof *to);
  for (size_t i = 0; i < corners; i++) {
    const struct side *side = &s->sides[i];
    const size_t ends[] = {side->low, side->high};
    const size_t e = s->edge[side->corner];
    const bool two = i + 1 < corners && s->edge[side[1].corner] == e;
    for (size_t k = 0; k < 2; k++) {
      const double *x = from->x[ends[k]];
      add(to[e], two ? 0.25 : 0.5, x);
      for (size_t j = 0; j < 2; j++) {
        add(s->middles[ends[j]], 0.5, x);
      }
      s->edges[ends[k]]++;
      if (!two) {
        add(s->beside[ends[1 - k]], 1, x);
        s->open[ends[k]]++;
      }
    }
    if (two) {
      add(to[e], 0.25, centers[s->face[side->corner]]);
      add(to[e], 0.25, centers[s->face[side[1].corner]]);
      i++;
    }
  }
}

static void set_points(const struct step *s, bool fixed, double (*to)[WIDTH]) {
  for (size_t i = 0; i < s->from->points_n; i++) {
    const double k = (double)s->edges[i];
    memset(to[i], 0, sizeof to[i]);
    if (!s->open[i]) {
      add(to[i], (k - 3) / k, s->from->x[i]);
      add(to[i], 1 / (k * (double)s->faces[i]), s->centers[i]);
      add(to[i], 2 / (k * k), s->middles[i]);
    } else if (s->open[i] == 2 && s->faces[i] > 1 && !fixed) {
      add(to[i], 0.75, s->from->x[i]);
      add(to[i], 0.125, s->beside[i]);
    } else {
      add(to[i], 1, s->from->x[i]);
    }
  }
}

enum ph_status ph_bubble_subdivide(const struct ph_polygons *from, bool fixed,
                                   struct ph_arena *arena,
                                   struct ph_polygons *to,
                                   struct ph_diag *diag) {
  struct ph_arena scratch = ph_arena_beside(arena);
  struct step s = {.from = from};
  const size_t corners = from->first[from->faces_n];
  const size_t points = from->points_n, faces = from->faces_n;
  enum ph_status status =
      allocate(&s, &scratch) ? find_edges(&s, diag) : ph_fail_memory(diag);
  if (status == PH_OK) {
    *to = (struct ph_polygons){.points_n = points + faces + s.edges_n,
                               .faces_n = corners};
    to->x = ph_arena_array(arena, to->points_n, sizeof *to->x);
    to->first = ph_arena_array(arena, corners + 1, sizeof *to->first);
    to->corner = ph_arena_array(arena, 4 * corners, sizeof *to->corner);
    status = to->x && to->first && to->corner ? PH_OK : ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    set_centers(&s, to->x + points);
    set_middles(&s, (const double(*)[WIDTH])(to->x + points),
                to->x + points + faces);
    set_points(&s, fixed, to->x);
    for (size_t f = 0, c = 0; f < faces; f++) {
      size_t last = s.edge[from->first[f + 1] - 1];
      for (; c < from->first[f + 1]; c++) {
        size_t *corner = to->corner + 4 * c;
        to->first[c] = 4 * c;
        corner[0] = from->corner[c];
        corner[1] = points + faces + s.edge[c];
        corner[2] = points + f;
        corner[3] = points + faces + last;
        last = s.edge[c];
      }
    }
    to->first[corners] = 4 * corners;
  }
  ph_arena_free(&scratch);
  return status;
}
