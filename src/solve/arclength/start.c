/* SPDX-License-Identifier: GPL-3.0-or-later */
/* First iterates of arclength (see arclength_start.h). */
#include "solve/arclength/start.h"

#include "kernel/pi.h"
#include "solve/arclength/form.h"

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

static void set_support(const struct ph_arc_data *d, struct support *p) {
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
      if (n >= MANY) {
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
    } else {
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
    set_support(d, &p);
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
