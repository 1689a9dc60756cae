/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How fair a curve is, against quadrature of what follows from its preimage, or
 * its control points.  With sigma = |r'|, and kappa', tau' by u (bend.h),
 *
 *   energy   E   = integral of kappa^2 sigma
 *            MV  = integral of kappa'^2 / sigma
 *   IES = E L,  IMV = MV L^3
 *   F1, F2   sums of IES and IMV of the segments; F3 = F2 + L^3 times the
 *            integral of tau'^2 / sigma, summed
 *   rotation_index, absolute   integrals of kappa sigma, |kappa| sigma / 2 pi
 *
 * Where a curve nearly stops, these are large, and rounding changes them: by
 * how much is integrated, too.
 */
#include "check/bend.h"
#include "check/checks.h"

#include "base/sum.h"
#include "base/team.h"
#include "kernel/pi.h"

#include <string.h>

/* Integrals, relative. */
static const double INTEGRAL = 1e-11;

/* Segments that a thread takes at a time. */
enum { PART = 64 };

/* Claims that were integrated to less are not looked at closer. */
static const double CLAIMED = 1e-10;

/* To how much claims of space curves are integrated (curve/fair/fair3.h), and
 * the torsion where |C| / sigma^2 falls to this part of its largest: near to an
 * inflection, where tau' has a peak that is as high as that is near. */
static const double CLOSED = 1e-9, PEAKED = 1e-8, INFLECTION = 1e-2;

/* A segment in space whose r' leaves a line by no more than this part of it may
 * be told to be straight (curve/fair/fair3.h), with energies that are 0. */
static const double STRAIGHT = 1e-11;

enum integral { BENDING, VARYING, TWISTING, TURNING, ABSOLUTE, INTEGRALS };

/* A segment, and what is integrated: the value of each, then its error. */
struct integrand {
  struct ph_check_bent bent;
  enum integral what[INTEGRALS];
  size_t n;
};

/* x^2 and by how much it may be off, times a factor. */
static void put_square(double x, double error, double factor, double *value,
                       double *uncertain) {
  *value = x * x * factor;
  *uncertain = (2 * fabs(x) + error) * error * factor;
}

static void values_at(const void *context, double u, double *value) {
  const struct integrand *in = context;
  const struct ph_check_bend b = ph_check_bend_at(&in->bent, u);
  for (size_t i = 0; i < in->n; i++) {
    double *x = &value[i], *error = &value[in->n + i];
    switch (in->what[i]) {
    case BENDING:
      put_square(b.kappa, b.kappa_error, b.speed, x, error);
      break;
    case VARYING:
      put_square(b.rate, b.rate_error, 1 / b.speed, x, error);
      break;
    case TWISTING:
      put_square(b.twist, b.twist_error, 1 / b.speed, x, error);
      break;
    default:
      *x = (in->what[i] == TURNING ? b.kappa : fabs(b.kappa)) * b.speed;
      *error = b.kappa_error * b.speed;
    }
  }
}

/* ---- sums over the segments --------------------------------------------- */

/* A sum, and by how much it may be off. */
struct total {
  struct ph_sum sum;
  double error;
};

struct fair {
  struct ph_check *v;
  struct total of[INTEGRALS]; /* integrals over the curve */
  struct total f[3];          /* F1, F2, F3 */
  struct total length;
  bool wanted[INTEGRALS]; /* and found in all segments so far */
  bool stands;            /* nearly still: nothing can be said */
};

static void add(struct total *total, double x, double error) {
  ph_sum_add(&total->sum, x);
  total->error += error;
}

/* Whether a segment may be told to be straight. */
static bool is_line(const struct ph_check_segment *s) {
  ph_vec3 along = {0, 0, 0};
  double least = STRAIGHT * s->speed + s->noise;
  for (size_t j = 0; j <= s->m; j++) {
    along = ph_vec3_abs(s->h[j]) > ph_vec3_abs(along) ? s->h[j] : along;
  }
  along = ph_vec3_unit(along);
  for (size_t j = 0; j <= s->m; j++) {
    if (!(ph_vec3_abs(ph_vec3_cross(s->h[j], along)) <= least)) {
      return false;
    }
  }
  return true;
}

/* Where integrals are cut, in order: 0, dips, 1; at most so many.  At a dip of
 * the speed energies have a peak, which is seen at an end of an interval, and
 * at one of |C| / sigma^2 torsions. */
enum { CUTS = 2 * PH_CHECK_DIPS + 2 };

struct cuts {
  double x[CUTS];
  size_t n;
};

static void cut_at(struct cuts *cuts, const double *x, size_t n) {
  for (size_t i = 0; i < n; i++) {
    size_t k = cuts->n++;
    for (; k > 0 && cuts->x[k - 1] > x[i]; k--) {
      cuts->x[k] = cuts->x[k - 1];
    }
    cuts->x[k] = x[i];
  }
}

/* The integrals from..to over a segment, between cuts, that are wanted. */
static void integrate_some(const struct fair *fair, struct integrand *in,
                           enum integral from, enum integral to,
                           const struct cuts *cuts, double *value,
                           double *error) {
  struct ph_check_integrands of = {values_at, in, 0, 0, 0, INTEGRAL};
  double sum[PH_CHECK_TOGETHER];
  in->n = 0;
  for (size_t i = from; i <= to; i++) {
    value[i] = error[i] = 0;
    if (fair->wanted[i]) {
      in->what[in->n++] = (enum integral)i;
    }
  }
  in->bent.twists = in->n > 0 && in->what[0] == TWISTING;
  of.n = 2 * in->n;
  of.uncertain = in->n;
  for (size_t k = 0; in->n > 0 && k + 1 < cuts->n; k++) {
    ph_check_integral(&fair->v->rule, &of, cuts->x[k], cuts->x[k + 1], sum);
    for (size_t i = 0; i < in->n; i++) {
      value[in->what[i]] += sum[i];
      error[in->what[i]] += sum[in->n + i] + 4 * INTEGRAL * fabs(sum[i]);
    }
  }
}

/* The integrals over a segment; that of the torsion by itself, as it may take
 * more intervals than there are. */
static void integrate(const struct fair *fair, const struct ph_check_bent *bent,
                      double *value, double *error) {
  struct integrand in = {.bent = *bent};
  struct cuts cuts = {{0, 1}, 2}, none = {.n = 0};
  struct ph_check_dips turns = {.low = 1, .high = 1};
  bool straight = false;
  if (!bent->plane) {
    turns = ph_check_dips_of(ph_check_bending, bent);
    cut_at(&cuts, turns.x, turns.n);
  }
  for (size_t i = 0; i < cuts.n; i++) {
    straight = straight || ph_check_bent_straight(bent, cuts.x[i]);
  }
  cut_at(&cuts, bent->slow.x, bent->slow.n);
  integrate_some(fair, &in, BENDING, VARYING, &cuts, value, error);
  integrate_some(fair, &in, TWISTING, TWISTING, straight ? &none : &cuts, value,
                 error);
  integrate_some(fair, &in, TURNING, ABSOLUTE, &cuts, value, error);
  if (!bent->plane) {
    double depth = sqrt(turns.low / turns.high);
    double part = is_line(bent->s) ? 1 : CLOSED;
    error[BENDING] += part * value[BENDING];
    error[VARYING] += part * value[VARYING];
    error[TWISTING] +=
        straight ? HUGE_VAL
                 : (depth > INFLECTION ? CLOSED : PEAKED) * value[TWISTING];
  }
}

static void add_segment(struct fair *fair, const struct ph_check_bent *bent) {
  double value[INTEGRALS], error[INTEGRALS], short_of;
  double l = ph_check_bent_length(fair->v, bent, &short_of), cube = l * l * l;
  integrate(fair, bent, value, error);
  for (size_t i = 0; i < INTEGRALS; i++) {
    add(&fair->of[i], value[i], error[i]);
    fair->wanted[i] = fair->wanted[i] && isfinite(value[i] + error[i]);
  }
  add(&fair->length, l, short_of);
  add(&fair->f[0], l * value[BENDING],
      l * error[BENDING] + short_of * value[BENDING]);
  short_of *= 3 * l * l;
  add(&fair->f[1], cube * value[VARYING],
      cube * error[VARYING] + short_of * value[VARYING]);
  add(&fair->f[2], cube * (value[VARYING] + value[TWISTING]),
      cube * (error[VARYING] + error[TWISTING]) +
          short_of * (value[VARYING] + value[TWISTING]));
}

/* ---- claims ------------------------------------------------------------- */

/* What a number is: a sum times a power of the length and of the scale. */
struct claim {
  enum ph_diagnostic which;
  const struct total *total;
  double factor; /* of the sum, at unit scale */
  int power;     /* of the scale, to the unit of the record */
  double loose;  /* by how much the factor may be off, relative */
};

/* The claims that can be found; at most these. */
enum { CLAIMS = 9 };

static size_t claims_of(const struct fair *fair, struct claim *claim) {
  const struct ph_check *v = fair->v;
  bool plane = v->curve->dimension == 2;
  const double l = ph_sum_value(&fair->length.sum);
  const double loose = fair->length.error / l, turn = 1 / (2 * PH_PI);
  const struct claim all[CLAIMS] = {
      {PH_D_ENERGY, &fair->of[BENDING], 1, 1, 0},
      {PH_D_F1, &fair->f[0], 1, 0, 0},
      {PH_D_F2, &fair->f[1], 1, 0, 0},
      {PH_D_F3, &fair->f[2], 1, 0, 0},
      {PH_D_ROTATION_INDEX, &fair->of[TURNING], turn, 0, 0},
      {PH_D_ABSOLUTE_ROTATION_INDEX, &fair->of[ABSOLUTE], turn, 0, 0},
      {PH_D_MV, &fair->of[VARYING], 1, 3, 0},
      {PH_D_IES, &fair->of[BENDING], 1, 0, 0},
      {PH_D_IMV, &fair->of[VARYING], 1, 0, 0}};
  size_t n = plane ? CLAIMS : 4;
  for (size_t i = 0; i < n; i++) {
    claim[i] = all[i];
  }
  if (plane) {
    claim[7].factor = l;
    claim[7].loose = loose;
    claim[8].factor = l * l * l;
    claim[8].loose = 3 * loose;
  }
  return n;
}

/* A sum at unit scale, in the unit of the record.  One power after another: out
 * of range only where the whole is. */
static double claimed_of(const struct ph_check *v, const struct claim *claim,
                         double sum) {
  double x = claim->factor * sum;
  for (int i = 0; i < claim->power; i++) {
    x = ph_check_scaled(v, x);
  }
  return x;
}

/* By how much a claim may be off. */
static double error_of(const struct ph_check *v, const struct claim *claim) {
  const double sum = ph_sum_value(&claim->total->sum);
  return claimed_of(v, claim, claim->total->error + claim->loose * fabs(sum));
}

/* How far a number is from what a claim must be; where that was not found, from
 * what is claimed. */
static double excess_of(const struct ph_check *v, const struct claim *claim,
                        double claimed) {
  double found = claimed_of(v, claim, ph_sum_value(&claim->total->sum));
  double error = error_of(v, claim);
  if (!isfinite(found + error) && ph_check_known(v, claim->which)) {
    found = v->diagnostics->value[claim->which];
    error = 0;
  }
  return ph_check_excess(fabs(claimed - found), fabs(found),
                         error + CLAIMED * fabs(found));
}

static void check_claim(struct ph_check *v, const struct claim *claim,
                        enum ph_diagnostic which) {
  double claimed = v->diagnostics->value[which];
  double found = claimed_of(v, claim, ph_sum_value(&claim->total->sum));
  double error = error_of(v, claim);
  double unit = fabs(found);
  if (claim->which == PH_D_ROTATION_INDEX ||
      claim->which == PH_D_ABSOLUTE_ROTATION_INDEX) {
    unit = ph_check_larger(unit, 1);
  }
  if (isfinite(found) && isfinite(error)) {
    ph_check_number(
        v, PH_CHECK_DIAGNOSTIC,
        ph_check_of("diagnostics", PH_CHECK_ONE, ph_diagnostic_name(which)),
        claimed, found, unit, error + CLAIMED * unit);
  }
}

/* Whether this may be what was minimised: in the plane an energy, in space one
 * of F1 to F3, that of the problem if there is one. */
static bool is_minimised(const struct ph_check *v, enum ph_diagnostic which) {
  const struct ph_value *criterion;
  if (v->curve->dimension == 2) {
    return which == PH_D_ENERGY || which == PH_D_MV || which == PH_D_IES ||
           which == PH_D_IMV;
  }
  if (which != PH_D_F1 && which != PH_D_F2 && which != PH_D_F3) {
    return false;
  }
  if (!v->problem) {
    return true;
  }
  criterion = &v->problem->field[PH_F_CRITERION];
  return strcmp(ph_diagnostic_name(which), criterion->kind == PH_WORD
                                               ? criterion->word
                                           : v->promise->parts ? "F1"
                                                               : "F3") == 0;
}

/* The same number twice: as far apart as either may be from what is found. */
static void check_same(struct ph_check *v, const struct claim *claim,
                       double claimed) {
  double same = v->diagnostics->value[claim->which];
  double error = error_of(v, claim);
  if (isfinite(error)) {
    ph_check_number(v, PH_CHECK_DIAGNOSTIC,
                    ph_check_of("diagnostics", PH_CHECK_ONE,
                                ph_diagnostic_name(PH_D_FUNCTIONAL)),
                    claimed, same, fabs(same), error + CLAIMED * fabs(same));
  }
}

/* The minimised functional is one of those that a curve of its kind has, and
 * that which is claimed of it. */
static void check_functional(struct ph_check *v, const struct claim *claim,
                             size_t n) {
  double claimed = v->diagnostics->value[PH_D_FUNCTIONAL];
  size_t best = n;
  for (size_t i = 0; i < n; i++) {
    if (is_minimised(v, claim[i].which) &&
        (best == n || !(excess_of(v, &claim[i], claimed) >=
                        excess_of(v, &claim[best], claimed)))) {
      best = i;
    }
  }
  if (best < n) {
    check_claim(v, &claim[best], PH_D_FUNCTIONAL);
    if (ph_check_known(v, claim[best].which)) {
      check_same(v, &claim[best], claimed);
    }
  }
}

static void set_wanted(struct fair *fair) {
  const struct ph_check *v = fair->v;
  bool plane = v->curve->dimension == 2;
  bool functional = ph_check_known(v, PH_D_FUNCTIONAL);
  bool f3 = ph_check_known(v, PH_D_F3) || functional;
  fair->wanted[BENDING] = functional || ph_check_known(v, PH_D_ENERGY) ||
                          ph_check_known(v, PH_D_IES) ||
                          ph_check_known(v, PH_D_F1);
  fair->wanted[VARYING] = functional || ph_check_known(v, PH_D_MV) ||
                          ph_check_known(v, PH_D_IMV) ||
                          ph_check_known(v, PH_D_F2) || f3;
  fair->wanted[TWISTING] = !plane && f3;
  fair->wanted[TURNING] = plane && ph_check_known(v, PH_D_ROTATION_INDEX);
  fair->wanted[ABSOLUTE] =
      plane && ph_check_known(v, PH_D_ABSOLUTE_ROTATION_INDEX);
}

/* The sums of a curve in parts, which are put together in their order. */
struct parts {
  const struct fair *none;
  struct fair *part;
};

static bool add_part(void *context, size_t thread, size_t first, size_t end) {
  const struct parts *parts = context;
  struct fair *fair = &parts->part[first / PART];
  (void)thread;
  *fair = *parts->none;
  for (size_t k = first; k < end && !ph_arena_late(fair->v->scratch); k++) {
    struct ph_check_segment s;
    struct ph_check_bent bent;
    ph_check_load(fair->v, k, &s);
    bent = ph_check_bent_of(fair->v, &s);
    if (ph_check_bent_stands(&bent)) {
      fair->stands = true;
      return false;
    }
    add_segment(fair, &bent);
  }
  return true;
}

static void join(struct total *total, const struct total *more) {
  ph_sum_join(&total->sum, &more->sum);
  total->error += more->error;
}

/* Sums over all segments, by all threads that there are; false: no memory. */
static bool add_segments(struct fair *fair) {
  const struct ph_check *v = fair->v;
  const size_t n = v->curve->n, parts_n = (n + PART - 1) / PART;
  const struct fair none = *fair;
  struct parts parts = {
      &none, ph_arena_array(v->scratch, parts_n, sizeof *parts.part)};
  if (!parts.part) {
    return false;
  }
  memset(parts.part, 0, parts_n * sizeof *parts.part);
  ph_team_share(v->scratch, n, 2 * PART, PART, add_part, &parts);
  for (size_t i = 0; i < parts_n; i++) {
    const struct fair *part = &parts.part[i];
    join(&fair->length, &part->length);
    for (size_t j = 0; j < INTEGRALS; j++) {
      join(&fair->of[j], &part->of[j]);
      fair->wanted[j] = fair->wanted[j] && part->wanted[j];
    }
    for (size_t j = 0; j < 3; j++) {
      join(&fair->f[j], &part->f[j]);
    }
    fair->stands = fair->stands || part->stands;
  }
  return true;
}

void ph_check_fairness(struct ph_check *v) {
  struct fair fair = {.v = v};
  struct claim claim[CLAIMS];
  bool any = false;
  size_t n;
  set_wanted(&fair);
  for (size_t i = 0; i < INTEGRALS; i++) {
    any = any || fair.wanted[i];
  }
  if (!any || !v->kind->square) {
    return; /* Bezier curves stand for another */
  }
  if (!add_segments(&fair)) {
    v->status = ph_fail_memory(v->diag);
    return;
  }
  if (fair.stands) {
    return;
  }
  n = claims_of(&fair, claim);
  for (size_t i = 0; i < n; i++) {
    if (ph_check_known(v, claim[i].which)) {
      check_claim(v, &claim[i], claim[i].which);
    }
  }
  if (ph_check_known(v, PH_D_FUNCTIONAL)) {
    check_functional(v, claim, n);
  }
}
