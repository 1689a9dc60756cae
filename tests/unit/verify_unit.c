/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results to be verified (see verify_unit.h). */
#include "verify_unit.h"

#include "check/certify.h"
#include "io/json_in.h"
#include "unit.h"

static enum ph_status convert(struct ph_arena *arena, struct ph_curve *curve,
                              struct ph_diagnostics *diagnostics,
                              struct ph_diag *diag) {
  struct ph_curve bezier;
  double error;
  enum ph_status status = ph_bezier_curve(curve, 1e-9 * ph_curve_size(curve),
                                          arena, &bezier, &error, diag);
  if (status == PH_OK) {
    *curve = bezier;
    ph_diagnostics_set(diagnostics, PH_D_CONVERSION_ERROR, error);
  }
  return status;
}

static enum ph_status offset(const struct unit_wanted *wanted,
                             struct ph_arena *arena, struct ph_result *r,
                             struct ph_diag *diag) {
  struct ph_offset_rules rules = {.tolerance = 1e-9 * ph_curve_size(&r->curve),
                                  .samples = wanted->samples};
  if (ph_kind_of(&r->curve)->on_sphere && rules.samples.how == PH_SAMPLE_NONE) {
    rules.samples.how = PH_SAMPLE_PARAMETER;
    rules.samples.n = 16;
  }
  r->offsets_n = ph_kind_offsets(ph_kind_of(&r->curve), r->curve.dimension);
  r->offsets = ph_arena_array(arena, r->offsets_n, sizeof *r->offsets);
  return ph_offset(&r->curve, wanted->offset, &rules, arena, r->offsets, diag);
}

enum ph_status unit_derive(const struct unit_wanted *wanted,
                           struct ph_arena *arena, struct ph_result *r,
                           struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  if (fabs(wanted->offset) > 0) {
    status = offset(wanted, arena, r, diag);
  }
  if (status == PH_OK && wanted->bezier) {
    status = convert(arena, &r->curve, &r->diagnostics, diag);
  }
  for (size_t i = 0; status == PH_OK && wanted->bezier && i < r->solutions_n;
       i++) {
    status = convert(arena, &r->solutions[i].curve,
                     &r->solutions[i].diagnostics, diag);
  }
  if (status == PH_OK && wanted->samples.how) {
    status =
        ph_sample_curve(&r->curve, &wanted->samples, arena, &r->samples, diag);
  }
  return status;
}

static enum ph_status certify_curve(struct unit_claim *c,
                                    const struct ph_curve *curve,
                                    struct ph_diagnostics *d) {
  enum ph_status status = ph_certify(c->command->schema->command, &c->problem,
                                     curve, &c->scratch, d, &c->diag);
  return status == PH_OK && c->command->describe
             ? c->command->describe(curve, &c->scratch, d, &c->diag)
             : status;
}

static enum ph_status certify(struct unit_claim *c) {
  struct ph_result *r = &c->result;
  enum ph_status status = certify_curve(c, &r->curve, &r->diagnostics);
  for (size_t i = 0; status == PH_OK && i < r->solutions_n; i++) {
    status =
        certify_curve(c, &r->solutions[i].curve, &r->solutions[i].diagnostics);
  }
  return status;
}

void unit_claim_make(struct unit_claim *c, const char *command,
                     const char *json, const struct unit_wanted *wanted) {
  const struct ph_record record = {.text = json, .n = strlen(json)};
  struct ph_echo echo;
  enum ph_status status;
  unit_claim_free(c);
  c->command = ph_command_find(command);
  ck_assert_ptr_nonnull(c->command);
  status = ph_json_in(&record, &c->command->method->schema, &c->arena,
                      &c->problem, &echo, &c->diag);
  if (status == PH_OK) {
    status = c->command->method->solve(&c->problem, &c->arena, &c->scratch,
                                       &c->result, &c->diag);
    c->result.area = (double)NAN; /* it is not told */
  }
  if (status == PH_OK) {
    status = certify(c);
  }
  if (status == PH_OK && wanted) {
    status = unit_derive(wanted, &c->arena, &c->result, &c->diag);
  }
  ck_assert_msg(status == PH_OK, "%s: %s %s", json, c->diag.field,
                c->diag.message);
}

void unit_claim_verify(struct unit_claim *c, bool with_problem) {
  enum ph_status status =
      ph_check_result(&c->result, with_problem ? &c->problem : NULL,
                      ph_promise_of(c->command->schema->command), &c->scratch,
                      &c->verdict, &c->diag);
  ck_assert_int_eq(status, PH_OK);
}

double unit_worst(const struct ph_verdict *verdict) {
  return verdict->worst == PH_CHECK_N ? 0
                                      : verdict->check[verdict->worst].error;
}

void unit_claim_free(struct unit_claim *c) {
  ph_arena_free(&c->arena);
  ph_arena_free(&c->scratch);
  *c = (struct unit_claim){0};
}
