/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The objects that records consist of, and who has their members (see
 * schema_table.h). */
#include "cli/schema_table.h"

#include "check/verify.h"
#include "curve/kind/kind.h"
#include "io/members.h"

#include <string.h>

/* What has a member. */
enum of {
  ANY,
  ATPH,
  SQUARE,   /* curves with a preimage */
  CUBIC,    /* of Tschirnhausen */
  SPHERE,   /* curves on one */
  FLAT,     /* all others */
  SPACE,    /* of these, those in space */
  RATIONAL, /* curves with rational offsets */
  QUOTIENT, /* those with quotients in their place */
  TENSION,  /* segments that have one */
  INTERVALS,
  LENGTHS /* curves of prescribed lengths */
};

#define MAY false
#define MUST true
#define LAST \
  { NULL, MAY, ANY, NULL, NULL }
#define ROW(symbol, name, must, of, type, what) {name, must, of, type, what},
#define CHECK(symbol, name) {name, MAY, ANY, "number", NULL},
#define DIAGNOSTIC(symbol, name, type, what) {name, MAY, ANY, type, what},
#define ROWS(...) ((const struct ph_member[]){__VA_ARGS__ LAST})
#define RECORD(...) ROWS(PH_HEADING_MEMBERS(ROW) __VA_ARGS__)

static const struct ph_members objects[] = {
    {"result", false, RECORD(PH_RESULT_MEMBERS(ROW))},
    {"failure", false, RECORD(PH_FAILURE_MEMBERS(ROW))},
    {"segment", false, ROWS(PH_SEGMENT_MEMBERS(ROW))},
    {"image", true, ROWS(PH_IMAGE_MEMBERS(ROW))},
    {"interval", false, ROWS(PH_INTERVAL_MEMBERS(ROW))},
    {"solution", false, ROWS(PH_SOLUTION_MEMBERS(ROW))},
    {"offset", false, ROWS(PH_OFFSET_MEMBERS(ROW))},
    {"piece", false, ROWS(PH_PIECE_MEMBERS(ROW))},
    {"bezier", false, ROWS(PH_BEZIER_MEMBERS(ROW))},
    {"cusp", true, ROWS(PH_CUSP_MEMBERS(ROW))},
    {"sample", false, ROWS(PH_SAMPLE_MEMBERS(ROW))},
    {"diagnostics", true, ROWS(PH_DIAGNOSTICS(DIAGNOSTIC))},
    {"certificate", false,
     ROWS(PH_DIAGNOSTICS(DIAGNOSTIC) PH_CERTIFICATE_MEMBERS(ROW))},
    {"kantorovich", true, ROWS(PH_KANTOROVICH_MEMBERS(ROW))},
    {"start", true, ROWS(PH_START_MEMBERS(ROW))},
    {"warning", true, ROWS(PH_WARNING_MEMBERS(ROW))},
    {"error", true, ROWS(PH_ERROR_MEMBERS(ROW))},
    /* of verify: what is right, what claims nothing; what is wrong, what
     * should not claim nothing, what cannot be looked at */
    {"verdict", false, RECORD(PH_OF_MEMBERS(ROW) PH_VERDICT_MEMBERS(ROW))},
    {"none", false, RECORD(PH_OF_MEMBERS(ROW) PH_CLAIMS_MEMBERS(ROW))},
    {"wrong", false,
     RECORD(PH_FAILURE_MEMBERS(ROW) PH_OF_MEMBERS(ROW)
                PH_VERDICT_MEMBERS(ROW))},
    {"wrong-none", false,
     RECORD(PH_FAILURE_MEMBERS(ROW) PH_NAMED_MEMBERS(ROW)
                PH_CLAIMS_MEMBERS(ROW))},
    {"unknown", false, RECORD(PH_FAILURE_MEMBERS(ROW) PH_NAMED_MEMBERS(ROW))},
    {"worst", true, ROWS(PH_WORST_MEMBERS(ROW))},
    {"checks", true, ROWS(PH_CHECKS(CHECK))},
};

const struct ph_members *ph_members_of(const char *name) {
  size_t i = 0;
  while (strcmp(objects[i].name, name) != 0) {
    i++;
  }
  return &objects[i];
}

bool ph_form_quotients(const struct ph_form *f) {
  const struct ph_kind *kind = ph_kinds[f->kind];
  return kind->angles || (kind->bernstein && !kind->erf);
}

bool ph_form_has(const struct ph_form *f, const struct ph_member *member) {
  const struct ph_promise *promise = f->promise;
  const struct ph_kind *kind = promise ? ph_kinds[f->kind] : NULL;
  switch ((enum of)member->of) {
  case ANY:
    return true;
  case ATPH:
    return kind->angles;
  case SQUARE:
    return kind->erf;
  case CUBIC:
    return promise->given == PH_GIVEN_CUBIC;
  case SPHERE:
    return ph_kind_space(kind, promise->dimension) == PH_SPHERE;
  case FLAT:
    return ph_kind_space(kind, promise->dimension) != PH_SPHERE;
  case SPACE:
    return ph_kind_space(kind, promise->dimension) == PH_SPACE;
  case RATIONAL:
    return kind->erf && !kind->angles;
  case QUOTIENT:
    return ph_form_quotients(f);
  case TENSION:
    return promise->tension && kind->erf;
  case INTERVALS:
    return promise->intervals;
  default:
    return promise->lengths;
  }
}
