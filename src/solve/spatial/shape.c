/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape of spatial Hermite segments (see spatial.h).
 *
 * The form (3), derived here.  With m = c A1 and the quaternions w01 = A0* m,
 * w02 = A0* A2, w12 = m* A2,
 *
 *   W = vect(A* A') = (2/sinc) vect(w01 S0^2 + w02 S0 S1 + w12 S1^2)      (4)
 *
 * because S0 S1' - S0' S1 = 1/sinc, as in curve/offset/cusp.c.  Let x and z be
 * the parts of (4) by i and by j, without the factor 2/sinc.  The Wronskian of
 * the two coordinates of z is, again for that reason,
 *
 *   Im(conj(z) z') = (1/sinc) (Im(conj(z0) z1) S0^2 + 2 Im(conj(z0) z2) S0 S1
 *                              + Im(conj(z1) z2) S1^2)                    (5)
 *
 * and N = (4/sinc^3) (sigma sinc Im(conj(z) z') + 4 x |z|^2).  (Tested by
 * t_spatial_shape.c: against the torsion at many u.)
 */
#include "solve/spatial/spatial.h"

#include "kernel/form.h"

/* Of zero, relative: of a convexity, of Ni and Nf, and of the torsion. */
static const double NOT_CONVEX = 1e-12;
static const double NO_NORMAL = 1e-12;
static const double NO_TORSION = 1e-14;

/* The factors tried first. */
static const double FACTOR = 0.95;
static const double FACTOR_MIN = 1.0 / 64;

/* Factors that are tried are multiples of a power of 2 near this part of the
 * tolerance: slacks differ by rounding where data are scaled, and with the same
 * factors minima of functionals are the same. */
static const double GRID = 1.0 / 64;

/* ---- constraints ---------------------------------------------------- */

void ph_spatial_torsion_form(const struct ph_atph *space, const ph_quat a[3],
                             double form[7]) {
  ph_quat m = ph_quat_scale(space->c, a[1]);
  ph_quat w[3] = {ph_quat_between(a[0], m), ph_quat_between(a[0], a[2]),
                  ph_quat_between(m, a[2])};
  ph_cplx z[3] = {{w[0].p, w[0].q}, {w[1].p, w[1].q}, {w[2].p, w[2].q}};
  /* The real parts of w01, w02, w12 are scalar products. */
  double speed[5] = {ph_quat_dot(a[0], a[0]), 4 * w[0].u,
                     4 * ph_quat_dot(m, m) + 2 * w[1].u, 4 * w[2].u,
                     ph_quat_dot(a[2], a[2])};
  double cross[3] = {ph_cplx_cross(z[0], z[1]), 2 * ph_cplx_cross(z[0], z[2]),
                     ph_cplx_cross(z[1], z[2])};
  double x[3] = {4 * w[0].v, 4 * w[1].v, 4 * w[2].v};
  double z2[5] = {ph_cplx_norm2(z[0]), 2 * ph_cplx_dot(z[0], z[1]),
                  ph_cplx_norm2(z[1]) + 2 * ph_cplx_dot(z[0], z[2]),
                  2 * ph_cplx_dot(z[1], z[2]), ph_cplx_norm2(z[2])};
  double turn[7];
  ph_form_multiply(speed, 4, cross, 2, form);
  ph_form_multiply(z2, 4, x, 2, turn);
  for (size_t k = 0; k < 7; k++) {
    form[k] += turn[k];
  }
}

static ph_vec3 start_tangent(const struct ph_spatial_family *f) {
  return ph_vec3_of(f->c, -f->s, 0);
}

static ph_vec3 end_tangent(const struct ph_spatial_family *f) {
  return ph_vec3_of(f->c, f->s, 0);
}

/* Whether n, Ni or Nf, has a direction. */
static bool is_normal(const struct ph_spatial_family *f, ph_vec3 n) {
  return ph_vec3_abs(n) > NO_NORMAL * f->h + f->noise;
}

/* By how much the cross product of a unit leg and one more points as n does;
 * infinite where n has no direction. */
static double convexity(const struct ph_spatial_family *f, ph_vec3 cross,
                        ph_vec3 leg, ph_vec3 n) {
  return is_normal(f, n) ? ph_vec3_dot(cross, n) -
                               NOT_CONVEX * ph_vec3_abs(leg) * ph_vec3_abs(n)
                         : HUGE_VAL;
}

/* Of g1 and g2: g1 is along the tangent. */
static double start_convexity(const struct ph_spatial_family *f,
                              const ph_quat a[3]) {
  ph_vec3 tangent = start_tangent(f), second = ph_quat_i(a[0], a[1]);
  return convexity(f, ph_vec3_cross(tangent, second), second,
                   ph_vec3_cross(tangent, f->dp));
}

/* Of g4 and g5. */
static double end_convexity(const struct ph_spatial_family *f,
                            const ph_quat a[3]) {
  ph_vec3 tangent = end_tangent(f), fourth = ph_quat_i(a[1], a[2]);
  return convexity(f, ph_vec3_cross(fourth, tangent), fourth,
                   ph_vec3_cross(f->dp, tangent));
}

unsigned ph_spatial_constraints(const struct ph_spatial_family *f) {
  ph_vec3 ni = ph_vec3_cross(start_tangent(f), f->dp);
  ph_vec3 nf = ph_vec3_cross(f->dp, end_tangent(f));
  return (is_normal(f, ni) ? PH_SHAPE_START : 0u) |
         (is_normal(f, nf) ? PH_SHAPE_END : 0u) |
         (ph_spatial_is_twisted(f) ? PH_SHAPE_TORSION
          : f->has_plane           ? PH_SHAPE_PLANE
                                   : 0u);
}

/* The sign that the torsion is to have, where it is to have one. */
static int sign_of(const struct ph_spatial_family *f) {
  return f->dp.z > 0 ? -1 : 1;
}

unsigned ph_spatial_violations(const struct ph_spatial_family *f,
                               const ph_quat a[3]) {
  unsigned violated = (start_convexity(f, a) > 0 ? 0u : PH_SHAPE_START) |
                      (end_convexity(f, a) > 0 ? 0u : PH_SHAPE_END);
  if (ph_spatial_is_twisted(f)) {
    double form[7];
    ph_spatial_torsion_form(&f->space, a, form);
    if (ph_form_sign(form, 6, NO_TORSION) != sign_of(f)) {
      violated |= PH_SHAPE_TORSION;
    }
  } else if (f->has_plane && !ph_spatial_is_plane(f, a)) {
    violated |= PH_SHAPE_PLANE;
  }
  return violated;
}

/* ---- tension -------------------------------------------------------- */

enum ph_status ph_spatial_fit_of(const struct ph_spatial_data *data,
                                 const struct ph_atph *space,
                                 ph_spatial_choice *choose, void *context,
                                 struct ph_spatial_fit *fit) {
  enum ph_status status;
  fit->violated = 0;
  fit->functional = 0;
  fit->cut_short = false;
  fit->family = ph_spatial_family_of(data, space);
  status = choose(fit, context);
  if (status == PH_OK) {
    ph_spatial_preimage(&fit->family, fit->member, fit->a);
    fit->violated = ph_spatial_violations(&fit->family, fit->a);
  }
  return status;
}

/* What a factor is tried with. */
struct search {
  const struct ph_spatial_data *data;
  const struct ph_atph *space;
  ph_spatial_choice *choose;
  void *context;
  double tolerance;
  size_t tried;
};

static enum ph_status try_factor(struct search *search, double factor,
                                 struct ph_spatial_fit *fit) {
  struct ph_spatial_data data = *search->data;
  enum ph_status status;
  data.ni *= factor * factor;
  data.nf *= factor * factor;
  search->tried++;
  status = ph_spatial_fit_of(&data, search->space, search->choose,
                             search->context, fit);
  if ((status == PH_E_INFEASIBLE || status == PH_E_NO_CONVERGENCE) &&
      factor < 1) {
    fit->violated = PH_SHAPE_NOTHING;
    return PH_OK;
  }
  return status;
}

/* The first power of FACTOR, from the first one on, that violates nothing; 0
 * where none does.  fit: there; before: at the power before. */
static enum ph_status scan(struct search *search, double *factor,
                           struct ph_spatial_fit *fit,
                           struct ph_spatial_fit *before) {
  enum ph_status status = PH_OK;
  for (*factor = FACTOR; *factor >= FACTOR_MIN; *factor *= FACTOR) {
    status = try_factor(search, *factor, fit);
    if (status != PH_OK || !fit->violated) {
      return status;
    }
    *before = *fit;
  }
  *factor = 0;
  return status;
}

/* By how much convexity, and torsion at the ends, are kept; negative if one is
 * not, and no number if there is no segment. */
static double slack_of(const struct ph_spatial_fit *fit) {
  const struct ph_spatial_family *f = &fit->family;
  double slack, form[7];
  if (fit->violated & PH_SHAPE_NOTHING) {
    return (double)NAN;
  }
  slack = fmin(start_convexity(f, fit->a), end_convexity(f, fit->a));
  if (ph_spatial_is_twisted(f)) {
    ph_spatial_torsion_form(&f->space, fit->a, form);
    /* as convexity, of the second power of lengths */
    slack = fmin(
        slack, fmin(sign_of(f) * form[0] / f->h, sign_of(f) * form[6] / f->h));
  }
  return slack;
}

/*
 * The largest factor from *factor to *factor / FACTOR that violates nothing, to
 * the tolerance.
 *
 * By the false position (Illinois) of the slack, with a bisection in every
 * third step and where the slack does not say what is violated.
 *
 * in   before  at *factor / FACTOR, violates something
 * io   fit     at *factor
 */
static enum ph_status refine(struct search *search, double *factor,
                             const struct ph_spatial_fit *before,
                             struct ph_spatial_fit *fit) {
  const double margin = 0.4 * search->tolerance;
  const double grid = ldexp(1, ilogb(GRID * search->tolerance));
  double low = *factor, high = low / FACTOR;
  double above = slack_of(fit), below = slack_of(before);
  int side = 0; /* which end was moved last */
  for (int step = 1; high - low > search->tolerance; step++) {
    struct ph_spatial_fit middle;
    double at = 0.5 * (low + high);
    enum ph_status status;
    if (step % 3 != 0 && above > 0 && below < 0) {
      at = low + (high - low) * (above / (above - below));
      at = fmin(fmax(at, low + margin), high - margin);
    }
    at = grid * nearbyint(at / grid);
    status = try_factor(search, at, &middle);
    if (status != PH_OK) {
      return status;
    }
    if (middle.violated) {
      high = at;
      below = slack_of(&middle);
      above *= side < 0 ? 0.5 : 1;
      side = -1;
    } else {
      low = at;
      above = slack_of(&middle);
      below *= side > 0 ? 0.5 : 1;
      side = 1;
      *fit = middle;
    }
  }
  *factor = low;
  return PH_OK;
}

/* A little less of a factor, if that violates nothing either: then the tension
 * does what it says also when it is given in digits. */
static enum ph_status step_back(struct search *search, double *factor,
                                struct ph_spatial_fit *fit) {
  struct ph_spatial_fit less;
  double at = *factor - search->tolerance;
  enum ph_status status = try_factor(search, at, &less);
  if (status == PH_OK && !less.violated) {
    *factor = at;
    *fit = less;
  }
  return status;
}

enum ph_status ph_spatial_tension(const struct ph_spatial_data *data,
                                  const struct ph_atph *space,
                                  ph_spatial_choice *choose, void *context,
                                  double tolerance,
                                  struct ph_spatial_tension *tension) {
  struct search search = {data, space, choose, context, tolerance, 0};
  struct ph_spatial_fit fit, before;
  double factor = 1;
  enum ph_status status = try_factor(&search, 1, &tension->fit);
  tension->factor = 1;
  tension->without = tension->fit.violated;
  if (status == PH_OK && tension->without) {
    before = tension->fit;
    status = scan(&search, &factor, &fit, &before);
    if (status == PH_OK && factor > 0) {
      status = refine(&search, &factor, &before, &fit);
      if (status == PH_OK) {
        status = step_back(&search, &factor, &fit);
      }
      tension->factor = factor;
      tension->fit = fit;
    }
  }
  tension->tried = search.tried;
  return status;
}
