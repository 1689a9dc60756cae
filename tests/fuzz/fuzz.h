/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the fuzz targets share.
 *
 * A target is tests/fuzz/NAME.c with FUZZ_TARGET(NAME, data, n) {...}; its
 * inputs are in tests/fuzz/corpus/NAME/.  It gives any bytes to the program's
 * own functions and requires what their headers promise.
 * tests/unit/cli/t_corpus.c includes all targets, to run them on their corpora
 * wherever the tests run: names of file scope begin with the target's.
 */
#ifndef PH_TESTS_FUZZ_FUZZ_H
#define PH_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* What the entry of a target is called, and how much time of a processor, under
 * sanitizers, an input may take: none takes more than half of it.  What replays
 * inputs elsewhere, as valgrind does, has no limit. */
#ifndef FUZZ_ENTRY
#define FUZZ_ENTRY(name) LLVMFuzzerTestOneInput
#define FUZZ_SECONDS 3
#else
#define FUZZ_SECONDS 1e9
#endif

#define FUZZ_TARGET(name, data, n)                                           \
  static int name##_target(const uint8_t *data, size_t n);                   \
  int FUZZ_ENTRY(name)(const uint8_t *data, size_t n);                       \
  int FUZZ_ENTRY(name)(const uint8_t *data, size_t n) {                      \
    const clock_t begin = clock();                                           \
    const int status = name##_target(data, n);                               \
    FUZZ_REQUIRE((double)(clock() - begin) / CLOCKS_PER_SEC < FUZZ_SECONDS); \
    return status;                                                           \
  }                                                                          \
  static int name##_target(const uint8_t *data, size_t n)

/* Not assert(): a build with NDEBUG must not be one that checks nothing. */
#define FUZZ_REQUIRE(condition)                                       \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      abort();                                                        \
    }                                                                 \
  } while (0)

#endif
