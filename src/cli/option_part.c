/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the input: --shard and --range (see option_value.h). */
#include "cli/option_value.h"

#include "base/suggest.h"

#include <getopt.h>
#include <stdint.h>
#include <string.h>

/* More shards than this are a slip of the keyboard. */
#define SHARDS_MAX 1000000000

/* The digits at p as a number; NULL: there are none, or too many. */
static const char *read_whole(const char *p, size_t *x) {
  const char *end = p + strspn(p, "0123456789");
  *x = 0;
  for (const char *digit = p; digit < end; digit++) {
    if (*x > (SIZE_MAX - 9) / 10) {
      return NULL;
    }
    *x = 10 * *x + (size_t)(*digit - '0');
  }
  return end > p ? end : NULL;
}

static enum ph_status refuse(struct ph_option_parser *p, const char *must) {
  char excerpt[PH_EXCERPT_MAX];
  return ph_fail(p->diag, PH_E_USAGE, NULL, "%s, found '%s'", must,
                 ph_excerpt(optarg, strlen(optarg), excerpt));
}

static enum ph_status read_shard(struct ph_option_parser *p,
                                 struct ph_split_part *part) {
  const char *at = read_whole(optarg, &part->shard);
  at = at && *at == '/' ? read_whole(at + 1, &part->shards) : NULL;
  return at && !*at && part->shard < part->shards && part->shards <= SHARDS_MAX
             ? PH_OK
             : refuse(p, "--shard must be K/N, whole numbers with K, from 0, "
                         "below N, and N at most " PH_TEXT(SHARDS_MAX));
}

static enum ph_status read_range(struct ph_option_parser *p,
                                 struct ph_split_part *part) {
  const char *at = read_whole(optarg, &part->begin);
  at = at && *at == ':' ? at + 1 : NULL;
  part->end = SIZE_MAX;
  if (at && *at) {
    at = read_whole(at, &part->end);
  }
  return at && !*at && part->begin <= part->end
             ? PH_OK
             : refuse(p, "--range must be FROM:TO, bytes from 0, or FROM:");
}

enum ph_status ph_option_read_part(struct ph_option_parser *p,
                                   enum ph_option_id id) {
  struct ph_split_part *part = &p->options->input.part;
  const bool shard = id == PH_O_SHARD;
  if (part->how == (shard ? PH_PART_RANGE : PH_PART_SHARD)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--shard and --range are alternatives");
  }
  part->how = shard ? PH_PART_SHARD : PH_PART_RANGE;
  return shard ? read_shard(p, part) : read_range(p, part);
}

enum ph_status ph_option_check_part(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  const struct ph_format_row *format = &ph_formats[o->format];
  const char *name = o->input.part.how == PH_PART_SHARD ? "shard" : "range";
  if (o->input.part.how == PH_PART_ALL) {
    return PH_OK;
  }
  if (o->problems) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--%s does not go with --problems, of which each result "
                   "may need any",
                   name);
  }
  if (o->plot || o->panorama) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--%s does not go with --%s, which is of the whole run",
                   name, o->plot ? "plot" : "panorama");
  }
  if (!format->is_parted) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--%s needs --format=json, csv, text or svg-path: files of "
                   "%s are no parts of one",
                   name, ph_format_name(o->format));
  }
  return PH_OK;
}
