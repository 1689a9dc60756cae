/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The reference cases of planar splines: values of [GON18, ch. 2] that were
 * recomputed by an independent program, lengths also in 40 digits, with the
 * names and tolerances they came with.  The case of Table 2.5 is in
 * t_kantorovich.c.
 */
#include "table21_unit.h"
#include "unit.h"
#include "planar_unit.h"

#include "curve/fair/energy.h"
#include "curve/segment/seg2.h"
#include "kernel/atph.h"

enum { POINTS_MAX = 5, NEWTON_MAX = 12 };

static const double PI = 3.14159265358979323846;

/* Tolerances; all but those of curvature and R_abs are relative. */
static const double TOL_LENGTH = 1e-11, TOL_ENERGY = 1e-9, TOL_VARYING = 1e-7,
                    TOL_TURNS = 1e-9, TOL_KAPPA = 1e-9, TOL_RESIDUAL = 1e-12;

/* Knots are the sums of the angles.  The derivatives are by t. */
struct reference {
  const char *name;
  double points[2 * POINTS_MAX];
  size_t points_n;
  bool closed;
  double alpha[POINTS_MAX];
  double ends[4]; /* open */
  double length, energy, mv, ies, imv, turns, rotation;
  double derivatives[4]; /* at both ends */
  double kappa[2];       /* at both ends */
};

static const struct reference SPLINES[] = {
    {.name = "table2.2-open",
     .points = {-2.1, 1.8, -0.8333, -0.1, 0.9833, 1.4167, 2.5667, 0.6},
     .points_n = 4,
     .closed = false,
     .alpha = {1.153278663132813, 2.094499822148315, 1.183123793341916},
     .ends = {0.9918, -3.6084, 1.4668, -1.9834},
     .length = 6.786232472191832,
     .energy = 3.7688056330155444,
     .mv = 4.7990400510844315,
     .ies = 25.57599116814958,
     .imv = 1499.824947680698,
     .turns = 0.6698960862547645,
     .rotation = 0.05865449131063766,
     .derivatives = {0.9918, -3.608400000000001, 1.4668, -1.9834000000000005},
     .kappa = {0.0845360499908713, -0.20912526433247589}},
    {.name = "table2.2-closed",
     .points = {6.667, 0.6667, 8.5, 4.667, 2.1667, 4.5, 0.3333, 2.5, 2.3333,
                -0.3333},
     .points_n = 5,
     .closed = true,
     .alpha = {0.6999468432198059, 0.7200530362027805, 0.8249822308326796,
               0.8099025860954486, 0.8199556825869361},
     .length = 22.92807002924179,
     .energy = 2.452936317249267,
     .mv = 0.9918623626770751,
     .ies = 56.241095659161644,
     .imv = 11955.11916395754,
     .turns = 1.0,
     .rotation = 1.0,
     .derivatives = {6.053171847851056, 3.880473240350956, 6.053171847851056,
                     3.880473240350956},
     .kappa = {0.05175238645927262, 0.051752386459272604}},
    {.name = "table2.1-points-uniform-pi/3",
     .points = {1.0, 2.0, 3.0, 5.0, 6.0, 4.0, 7.0, 3.0, 9.0, 4.0},
     .points_n = 5,
     .closed = false,
     .alpha = {1.0471975511965976, 1.0471975511965976, 1.0471975511965976,
               1.0471975511965976},
     .ends = {1.5, 5.0, 2.5, 2.0},
     .length = 10.812386261795568,
     .energy = 2.458518288081197,
     .mv = 7.555019656602437,
     .ies = 26.58244936242229,
     .imv = 9549.931462131863,
     .turns = 0.6144009973818729,
     .rotation = -0.09622485419976749,
     .derivatives = {1.5000000000000004, 5.0, 2.5, 2.0},
     .kappa = {-0.006908206781998037, 0.04007276652578568}},
    {.name = "circle-alpha=dtheta",
     .points = {1.0, 0.0, 0.7071067811865476, 0.7071067811865475,
                0.5000000000000001, 0.8660254037844386, 6.123233995736766e-17,
                1.0, -0.4999999999999998, 0.8660254037844387},
     .points_n = 5,
     .closed = false,
     .alpha = {0.7853981633974483, 0.26179938779914935, 0.5235987755982989,
               0.5235987755982987},
     .ends = {0.0, 1.0, -0.8660254037844387, -0.4999999999999998},
     .length = 2.094923249077154,
     .energy = 2.0942523211206243,
     .mv = 0.03860114779088311,
     .ies = 4.38729787694939,
     .imv = 0.3548988303027336,
     .turns = 0.33333333333333326,
     .rotation = 0.33333333333333326,
     .derivatives = {0.0, 0.9999999999999998, -0.8660254037844386,
                     -0.4999999999999998},
     .kappa = {0.9565310920611044, 0.9835160758409967}},
    {.name = "circle-alpha=dtheta/2",
     .points = {1.0, 0.0, 0.7071067811865476, 0.7071067811865475,
                0.5000000000000001, 0.8660254037844386, 6.123233995736766e-17,
                1.0, -0.4999999999999998, 0.8660254037844387},
     .points_n = 5,
     .closed = false,
     .alpha = {0.39269908169872414, 0.13089969389957468, 0.26179938779914946,
               0.26179938779914935},
     .ends = {0.0, 2.0, -1.7320508075688774, -0.9999999999999996},
     .length = 2.0943951023931953,
     .energy = 2.094395102393195,
     .mv = 2.4127721613123195e-29,
     .ies = 4.386490844928602,
     .imv = 2.2166246281533254e-28,
     .turns = 0.3333333333333333,
     .rotation = 0.3333333333333333,
     .derivatives = {0.0, 2.0, -1.7320508075688774, -0.9999999999999996},
     .kappa = {1.0, 1.0}},
    {.name = "limacon",
     .points = {1.4622501868990583, 0.25783416049629954, 0.853553390593274,
                0.8535533905932738, 0.5000000000000001, 0.8660254037844386,
                3.0616169978683836e-17, 0.5000000000000001,
                -1.3877787807814452e-16, 2.403703357979455e-16},
     .points_n = 5,
     .closed = false,
     .alpha = {0.6108652381980153, 0.26179938779914935, 0.5235987755982989,
               0.5235987755982987},
     .ends = {-0.4288442321591339, 1.4320964972920125, 0.43301270189221897,
              -0.7500000000000002},
     .length = 2.4091021412907483,
     .energy = 4.944534789204811,
     .mv = 1.2375765641249545,
     .ies = 11.911889348359905,
     .imv = 17.30364981752184,
     .turns = 0.5370265640425064,
     .rotation = 0.5370265640425064,
     .derivatives = {-0.4288442321591339, 1.4320964972920125,
                     0.43301270189221885, -0.75},
     .kappa = {1.1150522190197547, 2.3101574931300344}},
};

enum { SPLINES_N = COUNT(SPLINES) };

static struct unit_solution u;
static struct ph_quad rule;

static void begin(void) {
  ck_assert(ph_quad_gauss(&rule, 12));
}

static void finish(void) {
  unit_solution_free(&u);
}

static void problem_of(const struct reference *r) {
  size_t n = r->points_n - !r->closed;
  u = unit_planar_of(r->points, r->points_n, r->closed);
  unit_planar_atph(&u, r->alpha, n);
  if (!r->closed) {
    unit_planar_ends(&u, r->ends);
  }
}

static void solve(const char *name) {
  enum ph_status status = unit_planar_solve(&u);
  ck_assert_msg(status == PH_OK, "%s: %s %s", name, u.diag.field,
                u.diag.message);
}

static double known(const struct ph_diagnostics *d, enum ph_diagnostic which) {
  ck_assert(d->known >> which & 1);
  return d->value[which];
}

static const struct reference *named(const char *name) {
  for (size_t i = 0; i < SPLINES_N; i++) {
    if (strcmp(SPLINES[i].name, name) == 0) {
      return &SPLINES[i];
    }
  }
  ck_abort_msg("no case %s", name);
  return NULL;
}

/* ---- the basis ---------------------------------------------------------- */

/* J_j(u) = (1/mu_j) integral of S0^(4-j) S1^j over [0,u]. */
static double share(const struct ph_atph *space, size_t j, double at) {
  double sum = 0, all = 0;
  for (size_t i = 0; i < rule.n; i++) {
    double s[2], part[2];
    ph_atph_basis(space, at * rule.node[i], part);
    ph_atph_basis(space, rule.node[i], s);
    sum += at * rule.weight[i] * pow(part[0], 4 - (double)j) *
           pow(part[1], (double)j);
    all += rule.weight[i] * pow(s[0], 4 - (double)j) * pow(s[1], (double)j);
  }
  return sum / all;
}

static void ck_basis(double alpha, const double b5[6], const double mu[3]) {
  struct ph_atph space = ph_atph_of(alpha);
  const double c = cos(alpha / 2);
  const double at = 0.3 / alpha; /* t = 0.3 */
  double before = 1;
  ck_rel(space.q[0], mu[0], 1e-14);
  ck_rel(space.q[1] / (4 * c), mu[1], 1e-14);
  ck_rel(space.q[2] / (4 * c * c), mu[2], 1e-14);
  ck_rel(space.q[3] / 2, mu[2], 1e-14);
  for (size_t j = 0; j < 6; j++) {
    double after = j < 5 ? share(&space, j, at) : 0;
    ck_abs(before - after, b5[j], 1e-14);
    before = after;
  }
}

PH_TEST(test_basis) {
  static const double third[] = {0.19720431899603022, 0.3697811010690974,
                                 0.2887996148805795,  0.11728023116196691,
                                 0.02475915095359091, 0.0021755829387350733};
  static const double third_mu[] = {0.21104659807118348, 0.0559606993259142,
                                    0.03803994120387155};
  static const double one[] = {0.1786081944070773,   0.35945270780718486,
                               0.30019526853256134,  0.12990949450221456,
                               0.029125939958355728, 0.002708394792606226};
  static const double one_mu[] = {0.2100225882462494, 0.05540060825411108,
                                  0.03759512426746464};
  ck_basis(1.0471975511965976, third, third_mu);
  ck_basis(1, one, one_mu);
}

/* ---- splines ------------------------------------------------------------ */

static ph_cplx derivative(const struct ph_curve *curve, size_t k, size_t i) {
  const double *w = curve->preimage.v + 6 * k + 2 * i;
  ph_cplx z = ph_cplx_of(w[0], w[1]);
  return ph_cplx_mul(z, z);
}

static void ck_ends(const struct reference *r) {
  const struct ph_curve *curve = &u.result.curve;
  for (size_t i = 0; i < 2; i++) {
    const size_t k = i ? curve->n - 1 : 0;
    struct ph_seg2 seg = ph_seg2_of(curve, k);
    ph_cplx d = derivative(curve, k, 2 * i);
    ck_abs(d.re, r->derivatives[2 * i], 1e-11);
    ck_abs(d.im, r->derivatives[2 * i + 1], 1e-11);
    ck_abs(ph_seg2_curvature(&seg, (double)i).curvature, r->kappa[i],
           TOL_KAPPA);
  }
}

PH_TEST_EACH(test_spline, SPLINES_N) {
  const struct reference *r = &SPLINES[_i];
  const struct ph_diagnostics *d = &u.result.diagnostics;
  struct ph_energy energy;
  double length;
  problem_of(r);
  solve(r->name);
  length = u.result.curve.length;
  ck_rel(length, r->length, TOL_LENGTH);
  ck_assert(ph_energy_planar(&u.result.curve, &energy));
  ck_rel(energy.bending, r->energy, TOL_ENERGY);
  ck_rel(energy.bending * length, r->ies, TOL_ENERGY);
  ck_rel(known(d, PH_D_ENERGY), r->energy, TOL_ENERGY);
  if (r->mv > 1e-20) {
    ck_rel(energy.varying, r->mv, TOL_VARYING);
    ck_rel(energy.varying * pow(length, 3), r->imv, TOL_VARYING);
  } else { /* a circle: rounding errors squared */
    ck_assert_double_le(energy.varying, 1e-20);
  }
  ck_abs(energy.absolute_rotation, r->turns, TOL_TURNS);
  ck_abs(known(d, PH_D_ABSOLUTE_ROTATION_INDEX), r->turns, TOL_TURNS);
  ck_abs(energy.rotation, r->rotation, TOL_TURNS);
  ck_ends(r);
  ck_assert_double_le(known(d, PH_D_RESIDUAL), TOL_RESIDUAL);
  ck_assert_double_le(known(d, PH_D_ITERATIONS), NEWTON_MAX);
}

/* ---- circle and limacon ------------------------------------------------- */

/* Angles that are half the turn of the tangent: the circle itself. */
PH_TEST(test_circle) {
  const struct reference *r = named("circle-alpha=dtheta/2");
  problem_of(r);
  solve(r->name);
  for (size_t k = 0; k < u.result.curve.n; k++) {
    struct ph_seg2 seg = ph_seg2_of(&u.result.curve, k);
    for (size_t i = 0; i <= 1000; i++) {
      const double at = (double)i / 1000;
      ck_abs(ph_cplx_abs(ph_seg2_point(&seg, &rule, at)), 1, 1e-14);
      ck_abs(ph_seg2_curvature(&seg, at).curvature, 1, 1e-12);
    }
  }
}

static ph_cplx limacon(double theta) {
  double radius = 0.5 + cos(theta);
  return ph_cplx_of(radius * cos(theta), radius * sin(theta));
}

static double apart2(ph_cplx p, double theta) {
  return ph_cplx_norm2(ph_cplx_sub(limacon(theta), p));
}

/* The squared distance of a point from the limacon near theta: by thirds, the
 * root of what rounding leaves of it being far below that distance. */
static double distance2(ph_cplx p, double theta) {
  double low = theta - 0.05, high = theta + 0.05;
  for (size_t i = 0; i < 80; i++) {
    double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (apart2(p, a) < apart2(p, b)) {
      high = b;
    } else {
      low = a;
    }
  }
  return apart2(p, (low + high) / 2);
}

/* Printed: 1.1151 <= kappa <= 2.3102, and the mean square distance of the
 * segments' middles from the limacon, 1.0347e-10. */
PH_TEST(test_limacon) {
  const struct reference *r = named("limacon");
  double least = HUGE_VAL, greatest = 0, sum = 0;
  double theta = PI / 18; /* of the first point */
  problem_of(r);
  solve(r->name);
  for (size_t k = 0; k < 4; k++) {
    struct ph_seg2 seg = ph_seg2_of(&u.result.curve, k);
    for (size_t i = 0; i <= 1000; i++) {
      double kappa = ph_seg2_curvature(&seg, (double)i / 1000).curvature;
      least = fmin(least, kappa);
      greatest = fmax(greatest, kappa);
    }
    sum += distance2(ph_seg2_point(&seg, &rule, 0.5), theta + r->alpha[k] / 2);
    theta += r->alpha[k];
  }
  ck_abs(least, 1.1151, 0.5e-4);
  ck_abs(greatest, 2.3102, 0.5e-4);
  ck_abs(sum / 4, 1.0347e-10, 0.5e-14);
}

/* ---- all solutions ------------------------------------------------------ */

static int by_turns(const void *a, const void *b) {
  const double *x = a, *y = b;
  return (x[0] > y[0]) - (x[0] < y[0]);
}

/* table2.1-all-solutions */
PH_TEST(test_all) {
  double found[32][2];
  problem_of(named("table2.1-points-uniform-pi/3"));
  unit_set_word(&u.problem, PH_F_SOLUTIONS, "all");
  solve("table2.1-all-solutions");
  ck_assert_uint_eq(u.result.solutions_n, 32);
  for (size_t i = 0; i < 32; i++) {
    const struct ph_solution *s = &u.result.solutions[i];
    struct ph_energy energy;
    ck_assert(ph_energy_planar(&s->curve, &energy));
    found[i][0] = energy.absolute_rotation;
    found[i][1] = s->curve.length;
    if (s->good) { /* min_Rabs_is_newton_solution */
      ck_abs(found[i][0], table21_unit[0][0], 1e-8);
    }
  }
  qsort(found, 32, sizeof found[0], by_turns);
  for (size_t i = 0; i < 32; i++) {
    ck_abs(found[i][0], table21_unit[i][0], 1e-8);
    ck_rel(found[i][1], table21_unit[i][1], 1e-9);
  }
}

/* ---- minima ------------------------------------------------------------- */

static void minimize(const char *functional) {
  const struct reference *r = named("table2.2-open");
  u = unit_planar_of(r->points, r->points_n, false);
  unit_set_word(&u.problem, PH_F_BASIS, "atph");
  unit_set_word(&u.problem, PH_F_MINIMIZE, functional);
  unit_planar_ends(&u, r->ends);
  solve(functional);
}

/* fig2.17-open-IES */
PH_TEST(test_ies) {
  static const double alpha[] = {0.1440, 0.1277, 0.1311};
  minimize("IES");
  ck_abs(known(&u.result.diagnostics, PH_D_FUNCTIONAL), 25.0506578, 2e-6);
  for (size_t k = 0; k < 3; k++) {
    ck_abs(u.result.curve.preimage.alpha[k] / PI, alpha[k], 0.002);
  }
}

/* table2.2-alpha-origin: the angles of Table 2.2 minimise the integral of
 * (dkappa/dt)^2 |r'| dt, where MV has dkappa/ds: no functional of ours leads to
 * them.  So MV has to be less at its own minimum than at theirs. */
PH_TEST(test_mv) {
  static const double printed[] = {0.3671, 0.6667, 0.3766};
  const struct reference *r = named("table2.2-open");
  double alpha[3], ours;
  minimize("MV");
  ours = known(&u.result.diagnostics, PH_D_FUNCTIONAL);
  unit_solution_free(&u);
  for (size_t k = 0; k < 3; k++) {
    alpha[k] = printed[k] * PI;
  }
  u = unit_planar_of(r->points, r->points_n, false);
  unit_planar_atph(&u, alpha, 3);
  unit_planar_ends(&u, r->ends);
  solve("table2.2-alpha-origin");
  ck_assert_double_lt(ours, known(&u.result.diagnostics, PH_D_MV));
}

/* ---- small angles ------------------------------------------------------- */

/* The length through the points of Table 2.1 with all angles alpha, or of the
 * PH quintic; uniform knots in either case. */
static double length_of(double alpha) {
  static const double knots[] = {0, 1, 2, 3, 4};
  static const double ends[] = {1.5, 5, 2.5, 2};
  const struct reference *r = named("table2.1-points-uniform-pi/3");
  const double all[] = {alpha, alpha, alpha, alpha};
  double length;
  u = unit_planar_of(r->points, r->points_n, false);
  if (alpha > 0) {
    unit_planar_atph(&u, all, 4);
  }
  unit_planar_knots(&u, knots, 5);
  unit_planar_ends(&u, ends);
  solve("small angle");
  length = u.result.curve.length;
  unit_solution_free(&u);
  return length;
}

/* L(a) = L(0) + a^2 times a constant + O(a^4), and no digit is lost. */
PH_TEST(test_small_angles) {
  const double ph = length_of(0), slope = (length_of(0.01) - ph) / 1e-4;
  double alpha = 1;
  ck_assert_double_gt(fabs(slope), 1e-3);
  for (size_t i = 1; i <= 8; i++) {
    const double a2 = pow(alpha = alpha / 10, 2);
    ck_abs(length_of(alpha), ph + slope * a2, 2 * a2 * a2 + 1e-13);
  }
  ck_rel(length_of(1e-6), ph, 1e-11);
}

PH_FIXTURE(begin, finish)
