/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cusps of offsets (see cusp.h).
 *
 * With m = c a1, W = vect(conj(A) A') and all derivatives by u [derived here]:
 * (1) S0 S1' - S0' S1 = 1 / sinc,  sinc = sin(a/2) / (a/2)
 * (2) W = (2/sinc) vect(conj(a0) m S0^2 + conj(a0) a2 S0 S1 + conj(m) a2 S1^2)
 * (3) With W = x i + p j + q k, e2' . e1 = -2 q / sigma and e3' . e1 = 2 p /
 *     sigma (curve/segment/seg3.h), so that
 *     g = sigma^2 - 2 d q  or  sigma^2 + 2 d p
 *     has the sign of the offset's speed along e1; in the plane, that of
 *     1 - d kappa.
 * (4) 1 = (S0^2 + 2 c S0 S1 + S1^2)^3 makes (2) a form of degree 8, as sigma^2.
 * The signs of its Bernstein coefficients (kernel/form.h) bound the number of
 * roots; halving isolates them.  Tested by t_cusp.c: the form, against
 * 1 - d kappa and the derivatives of the frame at many u.
 */
#include "curve/offset/cusp.h"

#include "kernel/form.h"

#include <math.h>

/* Halvings until v is known to rounding; room at first. */
enum { DEGREE = PH_CUSP_DEGREE, HALVINGS_MAX = 50, ROOM = 16 };

/* What rounding may add to a bound. */
static const double ROUNDING = 1e-9;

struct form {
  double b[DEGREE + 1]; /* Bernstein coefficients */
};

/* Of conj(a) b, what stands in (3) beside -2 d. */
static double turning(enum ph_normal normal, ph_quat a, ph_quat b) {
  ph_quat w = ph_quat_between(a, b);
  return normal == PH_E2 ? w.q : -w.p;
}

/* Of 2, the power at the scale of A, so that fourth powers are in range. */
static int exponent_of(const ph_quat a[3]) {
  double largest = 0;
  for (size_t i = 0; i < 3; i++) {
    largest = fmax(largest, ph_quat_abs(a[i]));
  }
  return largest > 0 ? ilogb(largest) : 0;
}

/* sigma and the form in (2), of A that is scaled. */
static void products_of(const struct ph_seg3 *seg, enum ph_normal normal,
                        double scale, double speed[5], double cross[3]) {
  const ph_quat a0 = ph_quat_scale(scale, seg->a[0]);
  const ph_quat a2 = ph_quat_scale(scale, seg->a[2]);
  const ph_quat m =
      ph_quat_scale(seg->space.c, ph_quat_scale(scale, seg->a[1]));
  speed[0] = ph_quat_dot(a0, a0);
  speed[1] = 4 * ph_quat_dot(a0, m);
  speed[2] = 4 * ph_quat_dot(m, m) + 2 * ph_quat_dot(a0, a2);
  speed[3] = 4 * ph_quat_dot(m, a2);
  speed[4] = ph_quat_dot(a2, a2);
  cross[0] = turning(normal, a0, m);
  cross[1] = turning(normal, a0, a2);
  cross[2] = turning(normal, m, a2);
}

/* Whether g > 0 everywhere, by the quotients of these and of powers of (4): as
 * these are 1, sigma is no less than the least, W no more than the largest.
 * Neither is scaled: what leaves the range says nothing wrong. */
static bool is_forward(const struct ph_seg3 *seg, enum ph_normal normal,
                       double distance) {
  const double c = seg->space.c, one[3] = {1, 2 * c, 1};
  const double square[5] = {1, 4 * c, 2 + 4 * c * c, 4 * c, 1};
  const double factor = (1 + ROUNDING) * 4 / seg->space.sinc * distance;
  double speed[5], cross[3], least = HUGE_VAL;
  bool forward = true;
  products_of(seg, normal, 1, speed, cross);
  for (size_t i = 0; i < 5; i++) {
    const double to = speed[i] / square[i];
    forward = forward && to > 0;
    least = to < least ? to : least;
  }
  for (size_t i = 0; i < 3; i++) {
    forward = forward && least * least > factor * cross[i] / one[i];
  }
  return forward;
}

void ph_cusp_forms_of(const struct ph_seg3 *seg, enum ph_normal normal,
                      struct ph_cusp_forms *forms) {
  const int exponent = exponent_of(seg->a); /* A at unit scale */
  const double one[3] = {1, 2 * seg->space.c, 1};
  const double factor = 4 / seg->space.sinc;
  double speed[5], cross[3], raised4[5], raised6[7];
  products_of(seg, normal, ldexp(1, -exponent), speed, cross);
  ph_form_multiply(cross, 2, one, 2, raised4);
  ph_form_multiply(raised4, 4, one, 2, raised6);
  ph_form_multiply(raised6, 6, one, 2, forms->bend);
  ph_form_multiply(speed, 4, speed, 4, forms->square);
  for (size_t k = 0; k <= DEGREE; k++) {
    forms->bend[k] *= factor;
  }
  ph_form_bernstein(forms->bend, DEGREE, forms->bend);
  ph_form_bernstein(forms->square, DEGREE, forms->square);
  forms->exponent = 2 * exponent;
}

static struct form form_of(const struct ph_seg3 *seg, double distance,
                           enum ph_normal normal) {
  struct ph_cusp_forms forms;
  struct form form;
  double d;
  ph_cusp_forms_of(seg, normal, &forms);
  d = ldexp(distance, -forms.exponent);
  for (size_t k = 0; k <= DEGREE; k++) {
    form.b[k] = forms.square[k] - d * forms.bend[k];
  }
  return form;
}

/* The local parameter at which S1 : S0 = v : 1 - v. */
static double parameter_of(double angle, double v) {
  double half = angle / 2;
  return half > 0 ? atan2(v * sin(half), 1 - v + v * cos(half)) / half : v;
}

/* The signs of g along the curve so far. */
struct walk {
  struct ph_cusps cusps;
  struct ph_arena *arena;
  size_t room; /* of cusps.at */
  bool memory; /* is exhausted */
  size_t segment;
  double angle; /* of the space of the segment */
  double range; /* of the local parameter */
  int sign;     /* the last one seen, 0 before any */
};

static int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/* An interval from v on that has one sign, or none. */
static void see(struct walk *walk, int sign, double v) {
  struct ph_cusps *cusps = &walk->cusps;
  if (sign * walk->sign < 0) {
    struct ph_place *at = ph_arena_grow(walk->arena, cusps->at, cusps->n,
                                        sizeof *at, ROOM, &walk->room);
    walk->memory |= !at;
    if (at) {
      cusps->at = at;
      at[cusps->n].segment = walk->segment;
      at[cusps->n].u = parameter_of(walk->angle, v);
      at[cusps->n].t = at[cusps->n].u * walk->range;
      cusps->n++;
    }
  }
  walk->sign = sign ? sign : walk->sign;
}

/* Visits intervals without a change of sign, in order. */
static void visit(struct walk *walk, const struct form *form, double v0,
                  double v1, int depth) {
  struct form half[2];
  double root;
  int sign = 0;
  for (size_t k = 0; k <= DEGREE && sign == 0; k++) {
    sign = sign_of(form->b[k]);
  }
  if (!ph_form_is_mixed(form->b, DEGREE)) {
    see(walk, sign, v0);
  } else if (ph_form_root(form->b, DEGREE, &root)) {
    see(walk, sign, v0);
    see(walk, sign_of(form->b[DEGREE]), v0 + root * (v1 - v0));
  } else if (depth == HALVINGS_MAX) {
    see(walk, sign, v0);
    see(walk, sign_of(form->b[DEGREE]), v1);
  } else {
    ph_form_halve(form->b, DEGREE, half[0].b, half[1].b);
    visit(walk, &half[0], v0, 0.5 * (v0 + v1), depth + 1);
    visit(walk, &half[1], 0.5 * (v0 + v1), v1, depth + 1);
  }
}

enum ph_status ph_cusps_of(const struct ph_curve *curve, double distance,
                           enum ph_normal normal, struct ph_arena *arena,
                           struct ph_cusps *cusps, struct ph_diag *diag) {
  struct walk walk = {.arena = arena};
  int first = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct ph_seg3 seg = ph_seg3_of(curve, k);
    walk.segment = k;
    walk.range = ph_curve_range(curve, k);
    walk.angle = seg.space.angle;
    if (is_forward(&seg, normal, distance)) {
      first = k == 0 ? 1 : first;
      see(&walk, 1, 0);
    } else {
      const struct form form = form_of(&seg, distance, normal);
      first = k == 0 ? sign_of(form.b[0]) : first;
      visit(&walk, &form, 0, 1, 0);
    }
  }
  /* In space the frame comes back turned, and the offset does not close. */
  if (curve->closed && curve->dimension == 2 && first != 0) {
    walk.segment = 0;
    see(&walk, first, 0);
  }
  *cusps = walk.cusps;
  return walk.memory ? ph_fail_memory(diag) : PH_OK;
}
