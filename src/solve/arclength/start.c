/* SPDX-License-Identifier: GPL-3.0-or-later */
/* First iterates of arclength (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "kernel/pi.h"
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* Of so many data the phases are those of a helix: what they lack adds up. */
enum { MANY = 100 };

enum { FREQUENCIES = 4 };

/* Spinors at places t, between which the nodes are interpolated. */
struct support {
  size_t n;
  double *t;      /* [n] increasing */
  double (*w)[4]; /* [n], in space; in the plane and on a line its real part */
};

/* conj(u) . v */
static ph_cplx product(const double u[4], const double v[4]) {
  double iu[4];
  ph_arc_turned(u, iu);
  return ph_cplx_of(ph_arc_dot(4, u, v), ph_arc_dot(4, iu, v));
}

/* Turns the phase of v as near to that of u as it can be: the minimum of
 * [HUA14, (22)] without its branches; a reversal of direction has none. */
static void align(const double u[4], double v[4]) {
  ph_cplx c = product(u, v);
  double size = ph_cplx_abs(c);
  if (size > 1e-12 * sqrt(ph_arc_dot(4, u, u) * ph_arc_dot(4, v, v))) {
    ph_arc_phase(c.re / size, -c.im / size, v, v);
  }
}

static void set_spinor(ph_vec3 direction, double size, double w[4]) {
  ph_arc_spinor(direction, w);
  for (size_t k = 0; k < 4; k++) {
    w[k] *= size;
  }
}

/* Direction k of the data. */
static ph_vec3 direction(const struct ph_arc_data *d, size_t k) {
  return ph_vec3_unit(d->step ? d->step[k] : d->given[k]);
}

/* The angle from the plane of directions k - 1 and k to that of k and k + 1, of
 * n; at the ends that of the neighbours. */
static double torsion(const struct ph_arc_data *d, size_t n, size_t k) {
  size_t at = k < 1 ? 1 : k + 2 > n ? n - 2 : k;
  ph_vec3 a, b, before, after;
  if (n < 3) {
    return 0;
  }
  b = direction(d, at);
  before = ph_vec3_cross(direction(d, at - 1), b);
  after = ph_vec3_cross(b, direction(d, at + 1));
  a = ph_vec3_cross(before, after);
  return atan2(ph_vec3_dot(a, b), ph_vec3_dot(before, after));
}

/*
 * How much the phase of a curve of least F grows from direction k to the next.
 * With constant curvature kappa, torsion tau and twist c of the frame, twice
 * the growth of the phase,
 *
 *   16 |w''|^2 / |w|^2 = (c^2 + kappa^2)^2 + 4 kappa^2 (tau - c)^2
 *
 * is least at c^3 + 3 kappa^2 c = 2 kappa^2 tau: c = 2 kappa sinh u with
 * sinh 3 u = tau / kappa.
 */
static double twist(const struct ph_arc_data *d, size_t n, size_t k) {
  ph_vec3 u = direction(d, k), v = direction(d, k + 1);
  double turn = atan2(ph_vec3_abs(ph_vec3_cross(u, v)), ph_vec3_dot(u, v));
  double angle = (torsion(d, n, k) + torsion(d, n, k + 1)) / 2;
  return turn > 0 ? turn * sinh(asinh(angle / turn) / 3) : 0;
}

/* In a plane there are no phases: of twisted spinors only a part is left. */
static void set_support(const struct ph_arc_data *d, bool twisted,
                        struct support *p) {
  double t = 0;
  size_t n = d->mode == PH_ARC_POINTS ? d->n : d->n + 1;
  for (size_t i = 0; i < n; i++) {
    double speed;
    ph_vec3 v;
    if (d->mode == PH_ARC_POINTS) {
      v = d->step[i];
      speed = (d->length ? d->length[i] : d->chord[i]) / d->h[i];
      p->t[p->n] = t + d->h[i] / 2;
    } else {
      v = d->given[i];
      speed =
          d->mode == PH_ARC_TANGENTS ? ph_arc_data_speed(d, i) : ph_vec3_abs(v);
      p->t[p->n] = t;
    }
    set_spinor(ph_vec3_unit(v), sqrt(speed), p->w[p->n]);
    if (p->n > 0) {
      align(p->w[p->n - 1], p->w[p->n]);
      if (twisted && n >= MANY) {
        double grown = twist(d, n, p->n - 1);
        ph_arc_phase(cos(grown), sin(grown), p->w[p->n], p->w[p->n]);
      }
    }
    t += i < d->n ? d->h[i] : 0;
    p->n++;
  }
}

/* A closed curve has the last spinor before the first, and the first after the
 * last, each turned by chi. */
static double close_support(struct support *p, double period) {
  ph_cplx c = product(p->w[p->n - 1], p->w[0]);
  double chi = -atan2(c.im, c.re);
  memmove(p->t + 1, p->t, p->n * sizeof *p->t);
  memmove(p->w + 1, p->w, p->n * sizeof *p->w);
  p->t[0] = p->t[p->n] - period;
  p->t[p->n + 1] = p->t[1] + period;
  ph_arc_phase(cos(chi), -sin(chi), p->w[p->n], p->w[0]);
  ph_arc_phase(cos(chi), sin(chi), p->w[1], p->w[p->n + 1]);
  p->n += 2;
  return chi;
}

static void put(const struct ph_arc_system *s, const double w[4], double *x) {
  if (s->dim == 4) {
    memcpy(x, w, 4 * sizeof *x);
  } else {
    for (size_t k = 0; k < s->dim; k++) {
      x[k] = w[2 * k];
    }
  }
}

/* Node j is at the centre of segment j - 1, beyond the ends half a segment
 * away. */
static void interpolate(const struct ph_arc_system *s, const struct support *p,
                        double *x) {
  const struct ph_arc_data *d = s->data;
  size_t k = 0;
  double r = (double)s->refine, half = d->h[0] / (2 * r);
  double t = d->closed ? -d->h[d->n - 1] / (2 * r) : -half;
  for (size_t j = 0; j < s->nodes; j++) {
    double w[4], f;
    size_t next = j < s->segments ? j : s->segments - 1;
    while (k + 2 < p->n && p->t[k + 1] <= t) {
      k++;
    }
    f = p->n > 1 ? (t - p->t[k]) / (p->t[k + 1] - p->t[k]) : 0;
    for (size_t c = 0; c < 4; c++) {
      w[c] = p->w[k][c] + (p->n > 1 ? f * (p->w[k + 1][c] - p->w[k][c]) : 0);
    }
    put(s, w, x + j * s->dim);
    if (j == 0) {
      t = half;
    } else if (j + 1 < s->nodes) {
      size_t here = j - 1;
      t += (d->h[here / s->refine] + d->h[next / s->refine]) / (2 * r);
    }
  }
}

/* Data on a line with lengths above the chords: out of the axis. */
static void leave_axis(const struct ph_arc_system *s, double *x) {
  const struct ph_arc_data *d = s->data;
  double most = 0;
  for (size_t i = 0; d->length && i < d->n; i++) {
    double more = d->length[i] - d->chord[i];
    most = more > most ? more : most;
  }
  for (size_t j = 0; j < s->nodes; j++) {
    double at = 2 * (double)j / (double)(s->nodes - 1) - 1;
    x[j * s->dim + s->dim / 2] += at * sqrt(1.5 * most);
  }
}

bool ph_arc_start(struct ph_arc_system *s, struct ph_arena *scratch,
                  double *x) {
  const struct ph_arc_data *d = s->data;
  struct ph_mark mark = ph_arena_mark(scratch);
  struct support p = {
      0, ph_arena_array(scratch, d->n + 3, sizeof(double)),
      (double(*)[4])ph_arena_array(scratch, d->n + 3, 4 * sizeof(double))};
  bool ok = p.t && p.w;
  if (ok) {
    set_support(d, s->dim == 4, &p);
    if (d->closed) {
      double chi = close_support(&p, (double)d->n);
      if (s->turn) {
        x[s->x_n - 1] = chi;
      } else {
        s->sign = cos(chi) < 0 ? -1 : 1;
      }
    }
    interpolate(s, &p, x);
    if (d->line && !d->straight && d->mode == PH_ARC_POINTS) {
      leave_axis(s, x);
    }
  }
  ph_arena_release(scratch, mark);
  return ok;
}

/* ---- waves --------------------------------------------------------------- */

/* The tilt of a node that makes an interval longer by the part e is TILT
 * sqrt(e): a node tilts its curve by 1 - u^2 of that, which adds 4/15 of its
 * square [MOST is the largest tilt].  The waves lie across the curve at PLANE
 * from its frame: any angle will do but 0, where planar data would stay so. */
static const double TILT = 1.94, MOST = 1.2, PLANE = 0.6;

/* cos(half) w + sin(half) e^(i PLANE) J w, J(a, b) = (-conj b, conj a): tilts
 * the image of a node by 2 half. */
static void tilt(size_t dim, double half, double size, double *w) {
  double cosine = size * cos(half), sine = size * sin(half), v[4];
  if (dim == 2) {
    double a = w[0], b = w[1];
    w[0] = cosine * a - sine * b;
    w[1] = cosine * b + sine * a;
    return;
  }
  v[0] = -w[2];
  v[1] = w[3];
  v[2] = w[0];
  v[3] = -w[1];
  ph_arc_phase(cos(PLANE), sin(PLANE), v, v);
  for (size_t k = 0; k < 4; k++) {
    w[k] = cosine * w[k] + sine * v[k];
  }
}

void ph_arc_wiggle(const struct ph_arc_system *s, const double *natural,
                   double *x) {
  const struct ph_arc_data *d = s->data;
  size_t r = s->refine;
  for (size_t q = 0; q < s->segments; q++) {
    size_t i = q / r, at = q % r, j = (q + 1) % s->nodes;
    double ratio = d->length[i] / natural[i], e = ratio - 1, half;
    if (e > 0) {
      half = fmin(TILT * sqrt(e), MOST) / 2;
      half *= 2 * at + 1 == r ? 0 : (2 * at < r) == (i % 2 == 0) ? 1 : -1;
      tilt(s->dim, half, sqrt(ratio), x + j * s->dim);
    }
  }
}

/* Uniform in [-1, 1]: the generator splitmix64 [STE14]. */
static double uniform(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return (double)(int64_t)z / 9223372036854775808.0;
}

void ph_arc_perturb(const struct ph_arc_system *s, double size, uint64_t *state,
                    double *x) {
  double most = 0, factor[FREQUENCIES][4];
  for (size_t k = 0; k < s->nodes * s->dim; k++) {
    most = fabs(x[k]) > most ? fabs(x[k]) : most;
  }
  for (size_t f = 0; f < FREQUENCIES; f++) {
    for (size_t k = 0; k < 4; k++) {
      factor[f][k] = size * most * sqrt(3) * uniform(state);
    }
  }
  for (size_t j = 0; j < s->nodes; j++) {
    double at = (double)j / (double)(s->nodes - 1);
    for (size_t f = 0; f < FREQUENCIES; f++) {
      double wave = cos(PH_PI * (double)f * at);
      for (size_t k = 0; k < s->dim; k++) {
        x[j * s->dim + k] += wave * factor[f][k];
      }
    }
  }
}

/* ---- pose ---------------------------------------------------------------- */

/* Sequences that differ by less are the same backwards, data that turn by less
 * have no sense of rotation. */
static const double EQUAL = 1e-9;

/* A direction within this of vertical has no left. */
static const double VERTICAL = 1e-8;

/* The vectors that the pose is about: steps, or what is given. */
static ph_vec3 *vectors(const struct ph_arc_data *d, size_t *n) {
  *n = d->step ? d->n : d->n + 1;
  return d->step ? d->step : d->given;
}

/* ---- reversal ------------------------------------------------------------ */

/* Whether v backwards is smaller (-1), larger (1) or the same. */
static int compare_backwards(const double *v, size_t n) {
  for (size_t i = 0; v && i < n; i++) {
    double difference = v[n - 1 - i] - v[i];
    if (fabs(difference) > EQUAL * (fabs(v[i]) + fabs(v[n - 1 - i]))) {
      return difference < 0 ? -1 : 1;
    }
  }
  return 0;
}

/* The same of the lengths of vectors, and of products of neighbours. */
static int compare_vectors_backwards(const ph_vec3 *v, size_t n) {
  for (size_t i = 0; i < n; i++) {
    double a = ph_vec3_abs(v[i]), b = ph_vec3_abs(v[n - 1 - i]);
    if (fabs(b - a) > EQUAL * (a + b)) {
      return b < a ? -1 : 1;
    }
  }
  for (size_t i = 0; i + 1 < n; i++) {
    size_t j = n - 2 - i;
    double a = ph_vec3_dot(v[i], v[i + 1]), b = ph_vec3_dot(v[j], v[j + 1]);
    double size = ph_vec3_abs(v[i]) * ph_vec3_abs(v[i + 1]);
    if (fabs(b - a) > EQUAL * size) {
      return b < a ? -1 : 1;
    }
  }
  return 0;
}

static void reverse_numbers(double *v, size_t n) {
  for (size_t i = 0; v && i < n / 2; i++) {
    double first = v[i];
    v[i] = v[n - 1 - i];
    v[n - 1 - i] = first;
  }
}

static void reverse_order(ph_vec3 *v, size_t n) {
  for (size_t i = 0; i < n / 2; i++) {
    ph_vec3 first = v[i];
    v[i] = v[n - 1 - i];
    v[n - 1 - i] = first;
  }
}

/* A curve that is gone along backwards: the order and the vectors. */
static void reverse_vectors(ph_vec3 *v, size_t n) {
  reverse_order(v, n);
  for (size_t i = 0; i < n; i++) {
    v[i] = ph_vec3_scale(-1, v[i]);
  }
}

static void set_sense(struct ph_arc_data *d) {
  size_t n;
  ph_vec3 *v = vectors(d, &n);
  int order = compare_backwards(d->length, d->n);
  order = order ? order : compare_backwards(d->h, d->n);
  order = order ? order : compare_vectors_backwards(v, n);
  d->reversed = order < 0;
}

/* ---- closed data -------------------------------------------------------- */

/* The products of step i with its neighbours. */
static double turning(const struct ph_arc_data *d, size_t i) {
  size_t n = d->n;
  ph_vec3 sum = ph_vec3_add(d->step[(i + 1) % n], d->step[(i + n - 1) % n]);
  return ph_vec3_dot(d->step[i], sum);
}

/* Which of intervals i and j is the longer: by length, chord, turning. */
static int compare_intervals(const struct ph_arc_data *d, size_t i, size_t j) {
  const double by[3][2] = {
      {d->length ? d->length[i] : 0, d->length ? d->length[j] : 0},
      {d->chord[i], d->chord[j]},
      {turning(d, i), turning(d, j)}};
  for (size_t k = 0; k < 3; k++) {
    double difference = by[k][0] - by[k][1];
    if (fabs(difference) > EQUAL * (fabs(by[k][0]) + fabs(by[k][1]))) {
      return difference < 0 ? -1 : 1;
    }
  }
  return 0;
}

/* The longest interval is the first, and from it the sense is that of the
 * longer intervals. */
static void set_first(struct ph_arc_data *d) {
  size_t n = d->n, longest = 0;
  int order = 0;
  for (size_t i = 1; i < n; i++) {
    if (compare_intervals(d, i, longest) > 0) {
      longest = i;
    }
  }
  for (size_t k = 1; k < n && order == 0; k++) {
    order = compare_intervals(d, (longest + k) % n, (longest + n - k) % n);
  }
  d->reversed = order < 0;
  d->first = d->reversed ? (longest + 1) % n : longest;
}

/* Begins with interval `first`: three reversals. */
static void shift_numbers(double *v, size_t n, size_t first) {
  reverse_numbers(v, first);
  reverse_numbers(v ? v + first : NULL, n - first);
  reverse_numbers(v, n);
}

static void shift(struct ph_arc_data *d) {
  shift_numbers(d->length, d->n, d->first);
  shift_numbers(d->h, d->n, d->first);
  shift_numbers(d->chord, d->n, d->first);
  reverse_order(d->step, d->first);
  reverse_order(d->step + d->first, d->n - d->first);
  reverse_order(d->step, d->n);
}

/* Puts the sequence into its order. */
static void set_order(struct ph_arc_data *d) {
  size_t n;
  ph_vec3 *v = vectors(d, &n);
  if (d->closed) {
    set_first(d);
    shift(d);
  } else {
    set_sense(d);
  }
  if (d->reversed) {
    reverse_numbers(d->length, d->n);
    reverse_numbers(d->h, d->n);
    reverse_numbers(d->chord, d->n);
    reverse_numbers(d->tangent_sigma, d->n + 1);
    reverse_vectors(v, n);
  }
}

/* ---- frame --------------------------------------------------------------- */

/* The first vector that leaves the line of u by at least half as much as the
 * one that leaves it most; NULL: none leaves it. */
static const ph_vec3 *second_vector(const struct ph_arc_data *d, ph_vec3 u) {
  size_t n;
  const ph_vec3 *v = vectors(d, &n);
  double most = 0;
  for (size_t i = 0; i < n; i++) {
    double away = ph_vec3_abs(ph_vec3_normal(v[i], u));
    most = away > most ? away : most;
  }
  for (size_t i = 0; most > d->rounding && i < n; i++) {
    if (ph_vec3_abs(ph_vec3_normal(v[i], u)) >= most / 2) {
      return &v[i];
    }
  }
  return NULL;
}

/* Data on a line: e3 as near to z as it can be. */
static ph_vec3 upright(ph_vec3 e1) {
  bool vertical = hypot(e1.x, e1.y) <= VERTICAL;
  ph_vec3 up = vertical ? ph_vec3_of(1, 0, 0) : ph_vec3_of(0, 0, 1);
  ph_vec3 e3 = ph_vec3_unit(ph_vec3_normal(up, e1));
  return ph_vec3_unit(ph_vec3_cross(e3, e1));
}

static double chirality(const ph_vec3 *v, size_t n) {
  double sum = 0;
  for (size_t i = 2; i < n; i++) {
    sum += ph_vec3_triple(v[i - 2], v[i - 1], v[i]);
  }
  return sum;
}

void ph_arc_data_pose(struct ph_arc_data *d) {
  size_t n;
  ph_vec3 *v = vectors(d, &n), e1, e2, e3;
  const ph_vec3 *second;
  double handed = 0;
  set_order(d);
  e1 = ph_vec3_unit(v[0]);
  second = second_vector(d, e1);
  e2 = second ? ph_vec3_unit(ph_vec3_normal(*second, e1)) : upright(e1);
  e3 = ph_vec3_unit(ph_vec3_cross(e1, e2));
  e2 = ph_vec3_cross(e3,
                     e1); /* where all hardly leave a line e2 is not normal */
  d->turn = ph_quat_of_frame(e1, e2, e3);
  d->plane = true;
  d->line = d->straight = !second;
  for (size_t i = 0; i < n; i++) {
    v[i] = ph_vec3_of(ph_vec3_dot(e1, v[i]), ph_vec3_dot(e2, v[i]),
                      ph_vec3_dot(e3, v[i]));
    d->plane = d->plane && fabs(v[i].z) <= d->rounding;
    d->straight = d->straight && v[i].x > 0;
  }
  for (size_t i = 0; i < n; i++) {
    v[i].z = d->plane ? 0 : v[i].z;
    v[i].y = d->line ? 0 : v[i].y;
  }
  handed = chirality(v, n);
  d->mirrored = handed < -EQUAL;
  for (size_t i = 0; d->mirrored && i < n; i++) {
    v[i].z = -v[i].z;
  }
}
