/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape of spherical splines (see shape_sphere.h).
 *
 * At P_i the data turn by tau_i, from the direction of the great circle that
 * comes from P_{i-1} to that of the one that goes to P_{i+1}.  They do not turn
 * where |sin tau_i| is at most
 *
 *   max(min(1e-4, epsilon (theta_i + theta_{i+1}) / 8),
 *       8e-15 (1 / theta_i + 1 / theta_{i+1})):                           (1)
 *
 * by an angle that nobody sees, which for close data means a curvature below
 * epsilon as well; or by rounding of coordinates, and then there is nothing to
 * keep.
 */
#include "check/shape_sphere.h"

#include "check/error.h"

static const double ANGLE = 1e-4, SHARE = 0.125, ROUNDING = 8e-15;

/* Of (1), in units of the rounding of a point: more than any code that takes
 * the rounding of the user's coordinates for 1e-15 allows for. */
static const double UNSURE = 64;

/* What an epsilon may differ by that was met by search. */
static const double MET = 1e-9;

/* ---- the data -------------------------------------------------------- */

/* The part of q - p that is normal to p, of length sin(theta). */
static ph_vec3 towards(ph_vec3 p, ph_vec3 q) {
  ph_vec3 d = ph_vec3_sub(q, p);
  return ph_vec3_along(d, ph_vec3_dot(d, d) / 2, p);
}

void ph_check_nu_node_turn(struct ph_check_nu_node *node, double epsilon) {
  ph_vec3 p = node->right->p[0];
  ph_vec3 in = ph_vec3_scale(-1, towards(p, node->left->p[0]));
  ph_vec3 out = towards(p, node->right->p[3]);
  double hl = node->left->angle, hr = node->right->angle;
  double size = ph_vec3_abs(in) * ph_vec3_abs(out), inverse = 1 / hl + 1 / hr;
  double seen = ph_check_smaller(ANGLE, SHARE * epsilon * (hl + hr));
  node->sine = ph_vec3_triple(p, in, out) / size;
  node->cosine = ph_vec3_dot(in, out) / size;
  node->limit = ph_check_larger(seen, ROUNDING * inverse);
  node->limit_unsure =
      UNSURE * node->right->rounding * inverse + MET * node->limit;
  node->told = node->limit_unsure <= seen;
}

bool ph_check_nu_node_indicates(const struct ph_check_nu_node *node) {
  double size = fabs(node->sine);
  return node->indicator == 0
             ? size <= node->limit + node->limit_unsure
             : (node->indicator == 1 || node->indicator == -1) &&
                   node->indicator * node->sine > 0 &&
                   size >= node->limit - node->limit_unsure;
}

/* Whether data on a great circle go on in their direction, by their tangents
 * and, in the thesis, by their distances too. */
static bool in_order(const struct ph_check_nu_node *node, bool legacy) {
  double hl = node->left->angle, hr = node->right->angle;
  return node->told && node->cosine > 0 &&
         (!legacy || ph_s2_angle(node->left->p[0], node->right->p[3]) >
                         ph_check_larger(hl, hr));
}

/* ---- the criteria ---------------------------------------------------- */

static bool is_straight(const struct ph_check_nu_end *e, double epsilon) {
  return fabs(e->curvature) <= epsilon * (1 + MET) + e->curvature_error;
}

/* K after the node, by the knots. */
static bool is_straight_legacy(const struct ph_check_nu_node *node,
                               const struct ph_check_nu_rule *rule) {
  double error, k = ph_check_nu_numerator_end(node->right, 0, &error);
  double h = node->spacing, unit = rule->first * rule->first / (h * h * h);
  return unit * fabs(k) <= rule->epsilon * (1 + MET) + unit * error;
}

static bool bends_to(const struct ph_check_nu_segment *s, size_t end,
                     int side) {
  double error, k = side * ph_check_nu_numerator_end(s, end, &error);
  return k >= -error;
}

enum ph_check_nu_fault
ph_check_nu_node_fault(const struct ph_check_nu_node *node,
                       const struct ph_check_nu_rule *rule) {
  int q = node->indicator;
  if (q == 0) {
    bool fine =
        !in_order(node, rule->legacy) ||
        (rule->legacy ? is_straight_legacy(node, rule)
                      : is_straight(&node->left->end[1], rule->epsilon) &&
                            is_straight(&node->right->end[0], rule->epsilon));
    return fine ? PH_CHECK_NU_NO_FAULT : PH_CHECK_NU_COCIRCULARITY;
  }
  return bends_to(node->right, 0, q) &&
                 (rule->legacy || bends_to(node->left, 1, q))
             ? PH_CHECK_NU_NO_FAULT
             : PH_CHECK_NU_NODAL;
}

enum ph_check_nu_fault
ph_check_nu_segment_fault(const struct ph_check_nu_segment *s, int from,
                          int to) {
  return from * to <= 0 || ph_check_nu_turns(s, from) ? PH_CHECK_NU_NO_FAULT
                                                      : PH_CHECK_NU_CONVEXITY;
}

/* ---- what was waived ------------------------------------------------- */

bool ph_check_nu_is_waived(const struct ph_sphere *sphere, size_t i) {
  size_t from = 0, to = sphere->waived_n;
  while (from < to) {
    size_t middle = from + (to - from) / 2;
    if (sphere->waived[middle] < i) {
      from = middle + 1;
    } else {
      to = middle;
    }
  }
  return from < sphere->waived_n && sphere->waived[from] == i;
}

bool ph_check_nu_waived_fit(const struct ph_sphere *sphere, size_t n) {
  bool fit = sphere->waived_n == 0 || sphere->waived[sphere->waived_n - 1] < n;
  for (size_t i = 1; fit && i < sphere->waived_n; i++) {
    fit = sphere->waived[i - 1] < sphere->waived[i];
  }
  return fit;
}

const char *ph_check_nu_fault_name(enum ph_check_nu_fault fault) {
  static const char *const name[] = {
      [PH_CHECK_NU_NO_FAULT] = "nothing",
      [PH_CHECK_NU_COCIRCULARITY] = "co-circularity",
      [PH_CHECK_NU_NODAL] = "nodal convexity",
      [PH_CHECK_NU_CONVEXITY] = "segment convexity"};
  return name[fault];
}

double ph_check_nu_add_tension(struct ph_check_nu_tensions *tensions,
                               const struct ph_curve *curve, size_t i) {
  const double *t = curve->knots, nu = curve->sphere.tensions[i];
  size_t left = (i > 0 ? i : curve->n) - 1, right = i % curve->n;
  double h[2] = {t[left + 1] - t[left], t[right + 1] - t[right]};
  double relative = nu * (2 / (1 / h[0] + 1 / h[1]));
  ph_sum_add(&tensions->sum, nu);
  ph_sum_add(&tensions->relative, relative);
  tensions->largest = ph_check_larger(tensions->largest, relative);
  return relative;
}
