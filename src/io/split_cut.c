/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts of the input (see split.h): which bytes of which file they are, what is
 * read of the head of each file, and the line that they begin with.
 *
 * Parts of JSON are cut at the ends of lines.  In CSV a row begins a record or
 * not by the row before it; so splitting begins at the last line before the
 * part that is no comment.
 */
#define _XOPEN_SOURCE 700 /* pread */
#include "io/split.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Bytes that are read at once, backwards, and of a first line at most. */
enum { BLOCK = 1 << 12, FIRST_LINE = 1 << 20 };

bool ph_split_is_part(const struct ph_split *split) {
  return split->options.part.how != PH_PART_ALL;
}

/* ---- which bytes ------------------------------------------------------ */

/* What stat says of a file; false, with errno. */
static bool look_at(const char *name, struct stat *info) {
  return (strcmp(name, "-") == 0 ? fstat(STDIN_FILENO, info)
                                 : stat(name, info)) == 0;
}

/* The offset that the k-th of n equal ranges of so many bytes begins at. */
static size_t cut_at(size_t bytes, size_t k, size_t n) {
  return bytes / n * k + bytes % n * k / n;
}

enum ph_status ph_split_cut_init(struct ph_split *split, struct ph_diag *diag) {
  struct ph_split_part *part = &split->options.part;
  const char *option = part->how == PH_PART_SHARD ? "--shard" : "--range";
  size_t bytes = 0;
  for (size_t i = 0; i < split->files_n; i++) {
    const char *name = split->files[i];
    struct stat info;
    if (!look_at(name, &info)) {
      return ph_fail(diag, PH_E_INPUT, NULL, "cannot open %s: %s", name,
                     strerror(errno));
    }
    if (!S_ISREG(info.st_mode)) {
      return ph_fail(diag, PH_E_INPUT, NULL,
                     "%s needs regular files: %s is not one", option,
                     strcmp(name, "-") == 0 ? "standard input" : name);
    }
    bytes += (size_t)info.st_size;
  }
  if (part->how == PH_PART_SHARD) {
    part->begin = cut_at(bytes, part->shard, part->shards);
    part->end = cut_at(bytes, part->shard + 1, part->shards);
  }
  return PH_OK;
}

bool ph_split_cut_skip(struct ph_split *split) {
  const struct ph_split_part *part = &split->options.part;
  struct ph_split_cut *cut = &split->cut;
  for (;; split->next_file++) {
    struct stat info;
    size_t end;
    cut->before += cut->size;
    cut->size = 0;
    if (split->next_file == split->files_n) {
      return false;
    }
    if (look_at(split->files[split->next_file], &info)) {
      cut->size = (size_t)info.st_size; /* else opening it fails */
    }
    end = cut->before + cut->size;
    if (part->begin < end && part->end > cut->before &&
        part->begin < part->end) {
      cut->begin = part->begin > cut->before ? part->begin - cut->before : 0;
      cut->end = part->end < end ? part->end - cut->before : cut->size;
      cut->sought = false;
      return true;
    }
  }
}

/* ---- the head of a file ----------------------------------------------- */

static enum ph_split_state fail(struct ph_split *split, const char *why,
                                struct ph_diag *diag) {
  split->ended = true;
  ph_fail(diag, PH_E_INPUT, NULL, "cannot cut %s: %s", split->name, why);
  return PH_SPLIT_FAILED;
}

static enum ph_split_state fail_read(struct ph_split *split,
                                     struct ph_diag *diag) {
  return fail(split, strerror(errno), diag);
}

/* The first byte of the window from `at` on that is no blank, or the end of
 * what may be looked at. */
static enum ph_split_state first_from(struct ph_split *split, bool may_wait,
                                      size_t *at, struct ph_diag *diag) {
  for (;;) {
    const char *text = split->data + split->start;
    const size_t n = split->fill - split->start;
    enum ph_split_state state;
    *at = (size_t)(ph_json_blanks(text + *at, text + n) - text);
    if (*at < n || n > FIRST_LINE) {
      return PH_SPLIT_RECORD;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
}

/* The end of the line at byte `at` of the window, as far as it is looked at. */
static enum ph_split_state line_end(struct ph_split *split, bool may_wait,
                                    size_t at, size_t *end,
                                    struct ph_diag *diag) {
  for (;;) {
    const char *text = split->data + split->start;
    const size_t n = split->fill - split->start;
    const char *found = at < n ? memchr(text + at, '\n', n - at) : NULL;
    enum ph_split_state state;
    *end = found ? (size_t)(found - text) : n;
    if (found || n > FIRST_LINE) {
      return PH_SPLIT_RECORD;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
}

/* Whether a file is JSON Lines, as far as its first two lines tell; its name
 * may say it. */
static enum ph_split_state check_lines(struct ph_split *split, bool may_wait,
                                       struct ph_diag *diag) {
  struct ph_json_scan scan = {0};
  size_t at = 0, end = 0;
  enum ph_split_state state = first_from(split, may_wait, &at, diag);
  if (state == PH_SPLIT_RECORD && split->data[split->start + at] == '[') {
    return fail(split, "it is an array; --shard and --range are of JSON Lines",
                diag);
  }
  if (state == PH_SPLIT_RECORD) {
    state = line_end(split, may_wait, at, &end, diag);
  }
  if (state == PH_SPLIT_RECORD && end - at <= FIRST_LINE &&
      ph_json_scan(&scan, split->data + split->start + at, end - at, true) ==
          PH_JSON_ERROR) {
    state = first_from(split, may_wait, &end, diag);
    if (state == PH_SPLIT_RECORD && split->data[split->start + end] != '{') {
      return fail(split,
                  "its first line is no whole value; --shard and --range are "
                  "of JSON Lines",
                  diag);
    }
  }
  return state == PH_SPLIT_END ? PH_SPLIT_RECORD : state;
}

/* ---- the first line --------------------------------------------------- */

/* Finds the start of the line that byte `at` is in; false, with errno. */
static bool line_start(int fd, size_t at, size_t *start) {
  char block[BLOCK];
  while (at > 0) {
    const size_t want = at < BLOCK ? at : BLOCK;
    const ssize_t n = pread(fd, block, want, (off_t)(at - want));
    if (n != (ssize_t)want) {
      errno = n < 0 ? errno : EIO; /* it is shorter than it was */
      return false;
    }
    for (size_t i = want; i > 0; i--) {
      if (block[i - 1] == '\n') {
        *start = at - want + i;
        return true;
      }
    }
    at -= want;
  }
  *start = 0;
  return true;
}

/* The window is empty, and the file is read from byte `at`, which is none of
 * its first line. */
static bool seek(struct ph_split *split, size_t at) {
  split->start = split->fill = 0;
  split->end_of_file = false;
  split->offset = at;
  split->place = (struct ph_split_place){2, 1};
  return lseek(split->fd, (off_t)at, SEEK_SET) == (off_t)at;
}

/* JSON: the first line that begins in the part. */
static enum ph_split_state seek_line(struct ph_split *split, bool may_wait,
                                     struct ph_diag *diag) {
  const struct ph_split_cut *cut = &split->cut;
  split->lines_suffix = true;
  if (cut->begin == 0) {
    return PH_SPLIT_RECORD;
  }
  if (!seek(split, cut->begin - 1)) {
    return fail_read(split, diag);
  }
  while (split->offset < cut->end) {
    const char *text = split->data + split->start;
    const size_t n = split->fill - split->start;
    const char *end = n ? memchr(text, '\n', n) : NULL;
    enum ph_split_state state;
    ph_split_drop(split, end ? (size_t)(end + 1 - text) : n);
    if (end) {
      split->place = (struct ph_split_place){2, 1};
      return PH_SPLIT_RECORD;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
  return PH_SPLIT_END;
}

/* CSV: the last line before the part that is no comment, behind the header. */
static enum ph_split_state seek_row(struct ph_split *split,
                                    struct ph_diag *diag) {
  const size_t head = split->offset; /* its end */
  size_t at = split->cut.begin;
  char first = '#';
  while (first == '#' && at > head) {
    if (!line_start(split->fd, at - 1, &at) ||
        pread(split->fd, &first, 1, (off_t)at) != 1) {
      return fail_read(split, diag);
    }
  }
  if (!seek(split, at > head ? at : head)) {
    return fail_read(split, diag);
  }
  ph_buf_clear(&split->csv.id, 0);
  split->csv = (struct ph_split_csv){.columns = split->csv.columns};
  return PH_SPLIT_RECORD;
}

enum ph_split_state ph_split_cut_seek(struct ph_split *split, bool may_wait,
                                      struct ph_diag *diag) {
  struct ph_record none;
  enum ph_split_state state;
  switch (split->format) {
  case PH_SPLIT_JSON:
    state = split->lines_suffix ? PH_SPLIT_RECORD
                                : check_lines(split, may_wait, diag);
    if (state == PH_SPLIT_RECORD) {
      state = seek_line(split, may_wait, diag);
    }
    break;
  case PH_SPLIT_CSV:
  case PH_SPLIT_TEXT:
    state = ph_split_csv(split, may_wait, &none, diag);
    if (state == PH_SPLIT_RECORD) {
      state = seek_row(split, diag);
    }
    break;
  default:
    return fail(split,
                "it is neither JSON Lines nor CSV, which --shard and --range "
                "are of",
                diag);
  }
  split->cut.sought = state == PH_SPLIT_RECORD;
  return state;
}
