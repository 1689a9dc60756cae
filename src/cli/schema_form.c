/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which members the records of a form have (see schema_form.h). */
#include "cli/schema_form.h"

#include <stdlib.h>
#include <string.h>

bool ph_schema_has_quotients(const struct ph_schema_form *f) {
  const struct ph_kind *kind = ph_kinds[f->kind];
  return kind->angles || (kind->bernstein && !kind->erf);
}

/* Whether offsets may be loops in place of segments. */
static bool has_loops(const struct ph_schema_form *f) {
  return ph_kind_space(ph_kinds[f->kind], f->promise->dimension) == PH_PLANE;
}

bool ph_schema_has(const struct ph_schema_form *f,
                   const struct ph_member *member) {
  const struct ph_promise *promise = f->promise;
  const struct ph_kind *kind = promise ? ph_kinds[f->kind] : NULL;
  switch (member->of) {
  case PH_OF_ANY:
  case PH_OF_RAW:
  case PH_OF_CIRCULAR: /* of each strip, one or the other */
  case PH_OF_GENERAL:
  case PH_OF_DIRECTRIX:
    return true;
  case PH_OF_ATPH:
    return kind->angles;
  case PH_OF_SQUARE:
    return kind->erf;
  case PH_OF_CUBIC:
    return promise->given == PH_GIVEN_CUBIC;
  case PH_OF_SPHERE:
    return ph_kind_space(kind, promise->dimension) == PH_SPHERE;
  case PH_OF_FLAT:
    return ph_kind_space(kind, promise->dimension) != PH_SPHERE;
  case PH_OF_SPACE:
    return ph_kind_space(kind, promise->dimension) == PH_SPACE;
  case PH_OF_LOOPS:
    return has_loops(f);
  case PH_OF_RATIONAL:
    return kind->erf && !kind->angles;
  case PH_OF_QUOTIENT:
    return ph_schema_has_quotients(f);
  case PH_OF_TENSION:
    return promise->tension && kind->erf;
  case PH_OF_INTERVALS:
    return promise->intervals;
  case PH_OF_SURFACE:
    return promise->parts == PH_STRIPS_PARTS;
  default:
    return promise->lengths;
  }
}

/* The control points of an offset's piece: of a rational one by the degrees of
 * numerator and speed (curve/offset/offset.h), of a quotient in its B-basis. */
static size_t offset_points(const struct ph_schema_form *f) {
  return ph_schema_has_quotients(f) ? 5 : 2 * f->promise->degree;
}

size_t ph_schema_size(const struct ph_schema_form *f, const char *text) {
  switch (*text) {
  case 'D':
    return f->promise->dimension;
  case 'P':
    return f->promise->degree + 1;
  case 'W':
    return (f->promise->degree + 1) / 2;
  case 'Q':
    return f->promise->dimension == 2 ? 2 : 4;
  case 'O':
    return offset_points(f);
  case 'L':
    return ph_schema_has_quotients(f) ? 6 : offset_points(f);
  default: /* also of ], +, N and I */
    return strtoul(text, NULL, 10);
  }
}

bool ph_schema_may_lack(const struct ph_schema_form *f,
                        const struct ph_member *row) {
  bool raw = row->of == PH_OF_RAW || strcmp(row->type, "[+]piece") == 0;
  return row->need == PH_MAY || row->of == PH_OF_CIRCULAR ||
         row->of == PH_OF_GENERAL || row->of == PH_OF_DIRECTRIX ||
         (raw && has_loops(f));
}
