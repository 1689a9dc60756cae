/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of promises: a row for each command that solves, and no other. */
#include "unit.h"

#include "cli/command.h"
#include "check/promise.h"

#include <string.h>

PH_TEST(every_command_has_one) {
  size_t solve = 0;
  for (size_t i = 0; i < ph_commands_n; i++) {
    const char *name = ph_commands[i].schema->command;
    const struct ph_promise *promise = ph_promise_of(name);
    if (ph_commands[i].use == PH_USE_SOLVE) {
      solve++;
      ck_assert_ptr_nonnull(promise);
      ck_assert_str_eq(promise->command, name);
      ck_assert(promise->kinds != 0);
      ck_assert(promise->kinds < PH_KIND(N));
      ck_assert(promise->dimension == 2 || promise->dimension == 3);
    } else {
      ck_assert_ptr_null(promise);
    }
  }
  ck_assert_uint_eq(solve, ph_promises_n);
  ck_assert_ptr_null(ph_promise_of(""));
  ck_assert_ptr_null(ph_promise_of("plana"));
  ck_assert_ptr_null(ph_promise_of("planar "));
}

PH_TESTS(every_command_has_one)
