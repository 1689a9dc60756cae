/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the fuzz targets share.
 *
 * A target is tests/fuzz/NAME.c with LLVMFuzzerTestOneInput; its inputs are in
 * tests/fuzz/corpus/NAME/.  It gives any bytes to the program's own functions
 * and requires what their headers promise.  tests/unit/cli/t_corpus.c includes
 * all targets, to run them on their corpora wherever the tests run: names of
 * file scope begin with the target's, and each declares its own entry.
 */
#ifndef PH_TESTS_FUZZ_FUZZ_H
#define PH_TESTS_FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Not assert(): a build with NDEBUG must not be one that checks nothing. */
#define FUZZ_REQUIRE(condition)                                       \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      abort();                                                        \
    }                                                                 \
  } while (0)

#endif
