/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How members are in memory (see members.h). */
#include "io/members.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

void ph_sizes_enter(struct ph_sizes *sizes, enum ph_form form,
                    const void *from) {
#define SIZE(letter) sizes->of[(letter) - 'A']
  if (form == PH_AS_SEGMENTS) {
    const struct ph_curve *curve = from;
    SIZE('D') = curve->dimension;
    SIZE('P') = curve->degree + 1;
    SIZE('W') = curve->preimage.n;
    SIZE('Q') = curve->preimage.dimension;
    SIZE('S') = curve->n;
    SIZE('N') = curve->n + (curve->closed ? 0 : 1);
    sizes->joined = curve->joined;
  } else if (form == PH_AS_PIECES) {
    const struct ph_offset *o = from;
    SIZE('D') = o->dimension;
    SIZE('O') = SIZE('L') = o->degree + 1;
  } else if (form == PH_AS_BEZIERS) {
    const struct ph_pieces *pieces = from;
    SIZE('D') = pieces->dimension;
    SIZE('P') = pieces->degree + 1;
  } else if (form == PH_AS_SAMPLES) {
    SIZE('D') = ((const struct ph_samples *)from)->dimension;
  }
}

/* The number between brackets that text begins with; 0: any. */
static size_t size_of(const struct ph_sizes *sizes, const char *text) {
  char c = text[1];
  return c >= 'A' && c <= 'Z'   ? SIZE(c)
         : c >= '0' && c <= '9' ? (size_t)(c - '0')
                                : 0;
}
#undef SIZE

/* Words are read and written as what enumerations are. */
static_assert(sizeof(enum ph_root) == sizeof(unsigned), "enumerations");

size_t ph_slots(const struct ph_members *of, const struct ph_sizes *sizes,
                struct ph_slot slots[PH_SLOTS_MAX]) {
  size_t n = 0;
  for (const struct ph_member *row = of->rows; row->name; row++) {
    struct ph_slot *slot = &slots[n];
    const struct ph_type *type = row->as;
    const char *text = row->type;
    if (!type) {
      continue;
    }
    assert(n < PH_SLOTS_MAX);
    n++;
    *slot = (struct ph_slot){.row = row, .form = type->form};
    if (*text == '[') {
      slot->n = size_of(sizes, text);
      text = strchr(text, ']') + 1;
    }
    if (*text == '[') {
      slot->dimension = size_of(sizes, text);
    }
    slot->size = type->size * (slot->n ? slot->n : 1) *
                 (slot->dimension ? slot->dimension : 1);
    slot->stride = slot->size;
    if (row->where.joined && sizes->joined) {
      slot->stride -= type->size * slot->dimension;
    }
    slot->most = type->most < SIZE_MAX ? type->most : sizes->of['S' - 'A'] - 1;
    slot->numbers =
        type->form == PH_AS_DOUBLE && strncmp(row->type, "[+]", 3) == 0;
    slot->indirect =
        row->where.how == PH_EACH || type->form == PH_AS_LIST ||
        (type->form == PH_AS_SIZE && *row->type == '[' && slot->n == 0) ||
        slot->numbers;
  }
  return n;
}
