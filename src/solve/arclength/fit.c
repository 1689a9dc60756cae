/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Directions that were measured (see arclength.h). */
#include "solve/arclength/arclength.h"

#include <math.h>
#include <string.h>

/* Steps for one weight, and weights that are tried. */
enum { STEPS = 150, TRIALS = 60, FAILURES = 6 };

/* The root mean square is 1 to this. */
static const double CLOSE = 1e-7;

/* From one trial to the next the weight changes by no more than this, the
 * second where a fit begins at a first iterate: with 30 the matrix is not
 * convex there, and 3200 directions take 58 Cholesky factors, with 10 36. */
static const double FAR[2] = {30, 10};

/* The root mean square of the angles themselves is at most this. */
static const double DODGED = 3;

/* A curve whose rows hold to this has multipliers that tell the first weight,
 * whether it is a minimum or not. */
static const double NEAR = 1e-4;

/* The largest compliance: less weight than that does not make a curve any
 * straighter. */
static const double COMPLIANCE_MAX = 1e8;

struct fit {
  struct ph_arc_system soft;
  struct ph_arc_newton work;
  struct ph_arc_point point; /* of the current trial */
  struct ph_arc_point good;  /* of the last that led to a minimum */
  double *c;                 /* [y_n] rows of good */
  size_t terms;              /* directions and lengths that were measured */
  double most;               /* the largest 1 / weight */
  double far;                /* see FAR */
  double found;              /* that of good; 0: there is none */
  double rms;                /* there */
};

/* ---- the system ---------------------------------------------------------- */

/* Compliances for the weight 1: e^2 is c^2 over twice that, of both rows of a
 * direction together. */
static double of_length(const struct ph_arc_data *d, size_t i) {
  double deviation = d->sigma * d->length[i];
  return deviation * deviation / 2;
}

static double of_direction(const struct ph_arc_data *d, size_t j) {
  double sigma = d->tangent_sigma[j];
  return sigma * sigma * ph_arc_data_speed(d, j) / 8;
}

void ph_arc_weigh(struct ph_arc_system *s, double weight) {
  const struct ph_arc_data *d = s->data;
  for (size_t i = 0; s->compliance && i < d->n; i++) {
    s->compliance[i] = of_length(d, i) / weight;
  }
  for (size_t j = 0; j <= d->n; j++) {
    s->knot_compliance[j] = of_direction(d, j) / weight;
  }
}

static bool allocate(const struct ph_arc_data *d, struct ph_arena *arena,
                     const struct ph_arc_search *search, struct fit *f) {
  struct ph_arc_system *s = &f->soft;
  double largest = 0;
  *f = (struct fit){.soft = search->system};
  s->data = d;
  f->c = ph_arena_array(arena, s->y_n, sizeof *f->c);
  s->knot_compliance = ph_arena_array(arena, d->n + 1, sizeof(double));
  s->compliance =
      d->sigma > 0 ? ph_arena_array(arena, d->n, sizeof(double)) : NULL;
  for (size_t i = 0; d->sigma > 0 && i < d->n; i++) {
    largest = fmax(of_length(d, i), largest);
    f->terms++;
  }
  for (size_t j = 0; j <= d->n; j++) {
    largest = fmax(of_direction(d, j), largest);
    f->terms += d->tangent_sigma[j] > 0;
  }
  f->most = COMPLIANCE_MAX / largest;
  return f->c && s->knot_compliance && (s->compliance || !(d->sigma > 0)) &&
         ph_arc_newton_alloc(s, arena, &f->work) &&
         ph_arc_point_alloc(s, arena, &f->point) &&
         ph_arc_point_alloc(s, arena, &f->good);
}

/* The root mean square of e, from rows v; or, with multipliers in their place,
 * its increase by 1 / weight where the weight is large: there a row is the
 * compliance times its multiplier. */
static double spread(const struct fit *f, const double *v, bool multipliers) {
  const struct ph_arc_system *s = &f->soft;
  size_t n = s->data->n, forms = s->forms_n;
  double sum = 0;
  for (size_t i = 0; s->compliance && i < n; i++) {
    double u = v[i * forms], base = of_length(s->data, i);
    sum += multipliers ? u * u * base / 2 : u * u / (2 * base);
  }
  for (size_t r = 0; r < (n + 1) * s->knot_rows; r++) {
    double u = v[n * forms + r], base = of_direction(s->data, r / s->knot_rows);
    sum += multipliers ? u * u * base / 2 : base > 0 ? u * u / (2 * base) : 0;
  }
  return sqrt(sum / (double)f->terms);
}

/* Whether a curve dodges its directions: it all but stops where they are, so
 * that they weigh nothing. */
static bool dodges(const struct ph_arc_system *s, const double *x) {
  double sum = 0, terms = 0;
  for (size_t j = 0; j <= s->data->n; j++) {
    double sigma = s->data->tangent_sigma[j];
    double off = sigma > 0 ? ph_arc_deviation(s, x, j) / sigma : 0;
    sum += off * off;
    terms += sigma > 0;
  }
  return !(sum <= DODGED * DODGED * terms);
}

/* ---- the weight ---------------------------------------------------------- */

/* Solves for 1 / weight = p from the last good point; false: to no minimum. */
static bool try_weight(struct fit *f, double p) {
  struct ph_arc_system *s = &f->soft;
  ph_arc_weigh(s, 1 / p);
  ph_arc_point_copy(s, &f->good, &f->point);
  ph_arc_newton_solve(s, &f->work, STEPS, &f->point);
  f->good.iterations = f->point.iterations;
  if (!f->point.minimiser) {
    return false;
  }
  ph_arc_point_copy(s, &f->point, &f->good);
  ph_arc_residual(s, f->good.x, f->c);
  f->found = p;
  f->rms = spread(f, f->c, false);
  return true;
}

/* What is known of the root mean square, which grows with p: 1 / rms is nearly
 * linear in 1 / p. */
struct bracket {
  double low, high; /* p below and above; 0, infinity */
  double slope;     /* of 1 / rms by 1 / p */
};

/* The next p. */
static double next(const struct fit *f, const struct bracket *b) {
  double at = 1 / f->found, q = at + (1 - 1 / f->rms) / b->slope;
  double p = q * f->far > at ? 1 / q : f->far * f->found;
  p = fmin(fmax(p, f->found / f->far), f->most);
  return p > b->low && p < b->high ? p
         : isinf(b->high)          ? fmin(f->far * b->low, f->most)
                          : sqrt(fmax(b->low, b->high / f->far) * b->high);
}

/* Whether the weight is as it should be: with no less of it there is a curve
 * that is straighter. */
static bool is_right(const struct fit *f) {
  return fabs(f->rms - 1) <= CLOSE || (f->rms < 1 && f->found >= f->most);
}

/* From a first p; false: no curve was found. */
static bool find_weight(struct fit *f, double p) {
  struct bracket b = {0, (double)INFINITY, 1 / p};
  size_t failures = 0;
  for (size_t k = 0;
       k < TRIALS && failures < FAILURES && !ph_arena_late(f->work.arena);
       k++) {
    double q = f->found > 0 ? 1 / f->found : 0, inverse = 1 / f->rms, slope;
    if (!try_weight(f, p)) {
      p = f->found > 0 ? sqrt(p * f->found) : p / f->far;
      failures++;
      continue;
    }
    if (is_right(f)) {
      return true;
    }
    b.low = f->rms < 1 ? f->found : b.low;
    b.high = f->rms < 1 ? b.high : f->found;
    slope = (1 / f->rms - inverse) / (1 / f->found - q);
    b.slope = q > 0 && slope > 0 ? slope : b.slope;
    p = next(f, &b);
  }
  return f->found > 0 && f->rms <= 1;
}

/* ---- the whole ----------------------------------------------------------- */

/* Fits the curve of a point with exact directions, or one without: this begins
 * with the weight for which F there is FAR times what the rows may cost. */
static bool fit_point(struct fit *f, struct ph_arc_point *p) {
  bool near = p->converged || p->residual <= NEAR;
  double slope = near ? spread(f, p->y, true) : 0;
  f->found = 0;
  f->rms = 1;
  f->far = FAR[slope > 0 ? 0 : 1];
  ph_arc_point_copy(&f->soft, p, &f->good);
  if (p->converged && !(slope * f->most > CLOSE)) {
    return try_weight(f, f->most); /* straight, and as it was measured */
  }
  if (!near) {
    memset(f->good.y, 0, f->soft.y_n * sizeof *f->good.y);
  }
  return find_weight(
      f,
      fmin(slope > 0 ? 1 / slope : f->far * (double)f->terms / p->f, f->most));
}

/* Keeps a minimum, the lowest first. */
static void keep(struct ph_arc_search *search, struct ph_arc_found found) {
  size_t at = search->found_n++;
  for (; at > 0 && search->found[at - 1].point.f > found.point.f; at--) {
    search->found[at] = search->found[at - 1];
  }
  search->found[at] = found;
}

bool ph_arc_fit(const struct ph_arc_data *data, struct ph_arena *arena,
                struct ph_arc_search *search) {
  struct fit f;
  size_t n = search->found_n;
  if (search->system.knot_rows == 0) { /* on a line */
    return true;
  }
  if (!allocate(data, arena, search, &f)) {
    return false;
  }
  if (n == 0) { /* the curve that is nearest to one */
    search->found[n++] =
        search->has_saddle
            ? search->saddle
            : (struct ph_arc_found){search->nearest, search->starts_n - 1, 0};
  }
  search->found_n = 0;
  for (size_t i = 0; i < n; i++) {
    struct ph_arc_found found = search->found[i];
    struct ph_start *start = &search->starts[found.start];
    bool fitted = fit_point(&f, &found.point);
    bool dodged = fitted && dodges(&f.soft, f.good.x);
    search->stood_still = search->stood_still || dodged;
    if (fitted && !dodged) {
      ph_arc_point_copy(&f.soft, &f.good, &found.point);
      found.weight = 1 / f.found;
      *start = (struct ph_start){start->name, PH_OUTCOME_MINIMISER, f.good.f,
                                 f.good.iterations};
      keep(search, found);
    }
  }
  search->system = f.soft;
  return true;
}
