/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names of curve kinds and diagnostics; the list of warnings (see result.h). */
#include "curve/result.h"

#include "curve/kind/kind.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

#define NAME(symbol, name) name,
#define CURVE(symbol, kind, name) name,
static const char *const curve_names[] = {PH_CURVES(CURVE) NULL};
static const char *const frame_names[] = {PH_FRAMES(NAME, NAME) NULL};
static const char *const outcome_names[] = {PH_OUTCOMES(NAME) NULL};
static const char *const joint_names[] = {PH_JOINTS(NAME) NULL};
static const char *const root_names[] = {PH_ROOTS(NAME) NULL};
static const char *const strip_names[] = {PH_STRIP_METHODS(NAME) NULL};
static const char *const case_names[] = {PH_PAIR_CASES(NAME) NULL};

static const struct {
  const char *name, *type, *what;
} diagnostics[] = {
#define X(symbol, name, type, what) {name, type, what},
    PH_DIAGNOSTICS(X)
#undef X
};

static const char *const parts_names[] = {
#define X(symbol, name) name,
    PH_PARTS(X)
#undef X
};

const char *ph_parts_name(enum ph_parts parts) {
  return parts_names[parts];
}

const char *ph_curve_name(enum ph_curve_kind kind) {
  return curve_names[kind];
}

const char *ph_outcome_name(enum ph_outcome outcome) {
  return outcome_names[outcome];
}

const char *const *ph_words(const char *type) {
  static const struct {
    const char *type;
    const char *const *words;
  } lists[] = {{"kind", curve_names},         {"frame", frame_names},
               {"root", root_names},          {"outcome", outcome_names},
               {"strip_method", strip_names}, {"case", case_names},
               {"joint_kind", joint_names}};
  for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
    if (strcmp(lists[i].type, type) == 0) {
      return lists[i].words;
    }
  }
  return NULL;
}

const char *ph_diagnostic_name(enum ph_diagnostic which) {
  return diagnostics[which].name;
}

const char *ph_diagnostic_type(enum ph_diagnostic which) {
  return diagnostics[which].type;
}

const char *ph_diagnostic_meaning(enum ph_diagnostic which) {
  return diagnostics[which].what;
}

enum ph_status ph_curve_alloc(struct ph_curve *c, struct ph_arena *arena,
                              struct ph_diag *diag) {
  size_t number = sizeof(double);
  size_t preimage = c->preimage.n * c->preimage.dimension;
  bool angles = ph_kinds[c->kind]->angles;
  if (!c->knots) {
    c->knots = ph_arena_array(arena, c->n + 1, number);
  }
  c->control_points =
      ph_arena_array(arena, ph_curve_points_n(c), c->dimension * number);
  c->preimage.v =
      preimage ? ph_arena_array(arena, c->n, preimage * number) : NULL;
  c->lengths = ph_arena_array(arena, c->n, number);
  c->preimage.alpha = angles ? ph_arena_array(arena, c->n, number) : NULL;
  return c->knots && c->control_points && (c->preimage.v || !preimage) &&
                 c->lengths && (c->preimage.alpha || !angles)
             ? PH_OK
             : ph_fail_memory(diag);
}

double ph_curve_size(const struct ph_curve *curve) {
  size_t dimension = curve->dimension;
  const size_t end = curve->degree * dimension;
  double sum = 0;
  for (size_t j = 0; j < dimension; j++) {
    double low = curve->control_points[j], high = low;
    for (size_t k = 0; k < curve->n; k++) {
      double x = ph_curve_points(curve, k)[end + j];
      low = x < low ? x : low;
      high = x > high ? x : high;
    }
    sum = hypot(sum, high / 2 - low / 2);
  }
  return sum;
}

double ph_curve_rounding(const struct ph_curve *curve) {
  /* of de Casteljau's algorithm for both, in steps of half a unit in the last
   * place, and of their difference */
  static const double steps = 16;
  const size_t n = ph_curve_points_n(curve) * curve->dimension;
  double largest = 0;
  for (size_t i = 0; i < n; i++) {
    largest = fmax(largest, fabs(curve->control_points[i]));
  }
  return steps * DBL_EPSILON * largest;
}

enum ph_status ph_rounding_allows(double rounding, double tolerance,
                                  struct ph_diag *diag) {
  return !(tolerance >= rounding)
             ? ph_fail(diag, PH_E_NO_CONVERGENCE, "tolerance",
                       "is %.3g, and coordinates are rounded by up to %.3g: no "
                       "approximation is known to be nearer",
                       tolerance, rounding)
             : PH_OK;
}

void ph_warn(struct ph_result *result, size_t segment, enum ph_status status,
             const char *format, ...) {
  struct ph_warning *warning = &result->warnings[result->warnings_n];
  va_list args;
  assert(result->warnings_n < PH_WARNINGS_MAX);
  result->warnings_n++;
  warning->segment = segment;
  va_start(args, format);
  ph_diag_set(&warning->diag, status, format, args);
  va_end(args);
}
