/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fuzz targets on their committed inputs, also with compilers and in builds
 * that cannot fuzz.  A target aborts where a promise is broken.
 */
#include "unit.h"

#include <dirent.h>

#define LLVMFuzzerTestOneInput corpus_json
#include "../../fuzz/json.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_csv
#include "../../fuzz/csv.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_number
#include "../../fuzz/number.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_options
#include "../../fuzz/options.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_planar
#include "../../fuzz/planar.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_spatial
#include "../../fuzz/spatial.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_arclength
#include "../../fuzz/arclength.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_sphere
#include "../../fuzz/sphere.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_tc
#include "../../fuzz/tc.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput corpus_result
#include "../../fuzz/result.c"
#undef LLVMFuzzerTestOneInput

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

static void replay_all(const char *name, target_fn *target) {
  const char *source = getenv("srcdir");
  char directory[1024], path[2048];
  struct dirent *entry;
  size_t count = 0;
  DIR *list;
  snprintf(directory, sizeof directory, "%s/tests/fuzz/corpus/%s",
           source ? source : ".", name);
  list = opendir(directory);
  ck_assert_msg(list != NULL, "no directory %s", directory);
  while ((entry = readdir(list))) {
    if (entry->d_name[0] != '.') {
      snprintf(path, sizeof path, "%s/%s", directory, entry->d_name);
      replay(path, target);
      count++;
    }
  }
  closedir(list);
  ck_assert_uint_ge(count, INPUTS_MIN);
}

PH_TEST(json) {
  replay_all("json", corpus_json);
}

PH_TEST(csv) {
  replay_all("csv", corpus_csv);
}

PH_TEST(number) {
  replay_all("number", corpus_number);
}

PH_TEST(options) {
  replay_all("options", corpus_options);
}

PH_TEST(planar) {
  replay_all("planar", corpus_planar);
}

PH_TEST(spatial) {
  replay_all("spatial", corpus_spatial);
}

PH_TEST(arclength) {
  replay_all("arclength", corpus_arclength);
}

PH_TEST(sphere) {
  replay_all("sphere", corpus_sphere);
}

PH_TEST(tc) {
  replay_all("tc", corpus_tc);
}

PH_TEST(result) {
  replay_all("result", corpus_result);
}
