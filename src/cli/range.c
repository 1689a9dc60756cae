/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ranges of numbers (see range.h). */
#include "cli/range.h"

#include "base/suggest.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

enum { PARTS = 3 };

/* The first parts, between colons; what is left after them. */
static bool read_parts(const char *text, const char *end, double *part,
                       const char **rest) {
  for (size_t i = 0; i < PARTS; i++) {
    const char *colon = memchr(text, ':', (size_t)(end - text));
    const char *to = colon ? colon : end;
    if (to == text || ph_number_read_text(text, to, &part[i]) != to ||
        !isfinite(part[i]) || (!colon && i + 1 < PARTS)) {
      return false;
    }
    text = colon ? colon + 1 : end;
    *rest = to;
  }
  return true;
}

enum ph_status ph_range_read(const char *text, size_t n, double most,
                             const char *option, struct ph_range *range,
                             struct ph_diag *diag) {
  const char *end = text + n, *rest = end;
  double part[PARTS] = {0, 0, 0};
  char excerpt[PH_EXCERPT_MAX];
  bool read = read_parts(text, end, part, &rest);
  *range = (struct ph_range){part[0], part[1], 1, false};
  range->log = end - rest == 4 && memcmp(rest, ":log", 4) == 0;
  if (!read || (rest < end && !range->log) || !(part[2] >= 1) ||
      part[2] > most || floor(part[2]) < part[2]) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "%s: '%s' is not START:STOP:COUNT[:log] with a COUNT "
                   "from 1 to %.0f",
                   option, ph_excerpt(text, n, excerpt), most);
  }
  if (range->log && (!(range->start > 0) || !(range->stop > 0))) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "%s: '%s' has no logarithms: START and STOP must be "
                   "greater than 0",
                   option, ph_excerpt(text, n, excerpt));
  }
  range->n = (size_t)part[2];
  return PH_OK;
}

double ph_range_at(const struct ph_range *range, size_t i) {
  double part, width = range->stop - range->start;
  if (i == 0) {
    return range->start;
  }
  if (i + 1 == range->n) {
    return range->stop;
  }
  part = (double)i / (double)(range->n - 1);
  if (range->log) {
    return exp((1 - part) * log(range->start) + part * log(range->stop));
  }
  return isfinite(width) ? range->start + part * width
                         : (1 - part) * range->start + part * range->stop;
}
