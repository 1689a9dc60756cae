/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fuzz targets on their committed inputs, also with compilers and in builds
 * that cannot fuzz.  A target aborts where a promise is broken.
 */
#include "unit.h"

#include <dirent.h>

#define FUZZ_ENTRY(name) corpus_##name
#include "../../fuzz/json.c"
#include "../../fuzz/csv.c"
#include "../../fuzz/number.c"
#include "../../fuzz/options.c"
#include "../../fuzz/planar.c"
#include "../../fuzz/spatial.c"
#include "../../fuzz/arclength.c"
#include "../../fuzz/sphere.c"
#include "../../fuzz/tc.c"
#include "../../fuzz/bubble.c"
#include "../../fuzz/cone.c"
#include "../../fuzz/offset.c"
#include "../../fuzz/result.c"
#include "../../fuzz/xml.c"

/* Inputs are small; each target has at least so many. */
enum { INPUT_MAX = 1 << 16, INPUTS_MIN = 12 };

typedef int target_fn(const uint8_t *data, size_t n);

/* Runs one file, in memory of its own size: reading beyond it is seen. */
static void replay(const char *path, target_fn *target) {
  static uint8_t room[INPUT_MAX];
  FILE *file = fopen(path, "rb");
  uint8_t *data;
  size_t n;
  ck_assert_ptr_nonnull(file);
  n = fread(room, 1, sizeof room, file);
  ck_assert_uint_lt(n, sizeof room);
  ck_assert_int_eq(ferror(file), 0);
  fclose(file);
  data = malloc(n + !n);
  ck_assert_ptr_nonnull(data);
  memcpy(data, room, n);
  ck_assert_int_eq(target(data, n), 0);
  free(data);
}

static const struct {
  const char *name;
  target_fn *target;
} targets[] = {
    {"json", corpus_json},
    {"csv", corpus_csv},
    {"number", corpus_number},
    {"options", corpus_options},
    {"planar", corpus_planar},
    {"spatial", corpus_spatial},
    {"arclength", corpus_arclength},
    {"sphere", corpus_sphere},
    {"tc", corpus_tc},
    {"bubble", corpus_bubble},
    {"cone", corpus_cone},
    {"offset", corpus_offset},
    {"result", corpus_result},
    {"xml", corpus_xml},
};

static DIR *corpus_of(const char *target, char *directory, size_t n) {
  const char *source = getenv("srcdir");
  DIR *list;
  snprintf(directory, n, "%s/tests/fuzz/corpus/%s", source ? source : ".",
           target);
  list = opendir(directory);
  ck_assert_msg(list != NULL, "no directory %s", directory);
  return list;
}

/* Inputs of every target are replayed. */
PH_TEST(test_targets) {
  char directory[1024];
  DIR *list = corpus_of("", directory, sizeof directory);
  struct dirent *entry;
  size_t count = 0;
  while ((entry = readdir(list))) {
    size_t i = 0;
    if (entry->d_name[0] != '.') {
      while (i < COUNT(targets) && strcmp(targets[i].name, entry->d_name)) {
        i++;
      }
      ck_assert_msg(i < COUNT(targets), "%s is not replayed", entry->d_name);
      count++;
    }
  }
  closedir(list);
  ck_assert_uint_eq(count, COUNT(targets));
}

PH_TEST_EACH(test_corpus, COUNT(targets)) {
  char directory[1024], path[2048];
  DIR *list = corpus_of(targets[_i].name, directory, sizeof directory);
  struct dirent *entry;
  size_t count = 0;
  while ((entry = readdir(list))) {
    if (entry->d_name[0] != '.') {
      snprintf(path, sizeof path, "%s/%s", directory, entry->d_name);
      replay(path, targets[_i].target);
      count++;
    }
  }
  closedir(list);
  ck_assert_uint_ge(count, INPUTS_MIN);
}
