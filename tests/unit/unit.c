/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the tests of a file are run, and the case that a failure names. */
#include "unit.h"

#include <gsl/gsl_errno.h>
#include <stdarg.h>
#include <stdio.h>

struct ph_arena unit_arena;

static char current[200];

void unit_case(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(current, sizeof current, format, arguments);
  va_end(arguments);
}

void unit_case_print(void) {
  if (current[0] != '\0') {
    fprintf(stderr, "case: %s\n", current);
  }
}

static void clean(void) {
  ph_arena_free(&unit_arena);
  current[0] = '\0';
}

/* No test has a time of its own: tests/run limits that of the file.  GSL's
 * handler is off, as in the program: by default it aborts. */
int unit_main(const char *file, const struct unit_test *const *tests, size_t n,
              void (*begin)(void), void (*finish)(void)) {
  Suite *suite = suite_create(file);
  TCase *all = tcase_create(file);
  SRunner *runner = srunner_create(suite);
  int failed;

  tcase_set_timeout(all, 0);
  tcase_add_checked_fixture(all, begin, finish);
  tcase_add_checked_fixture(all, NULL, clean);
  for (size_t i = 0; i < n; i++) {
    tcase_add_loop_test(all, &tests[i]->check, 0, tests[i]->n);
  }
  suite_add_tcase(suite, all);
  gsl_set_error_handler_off();
  srunner_run_all(runner, CK_ENV);
  failed = srunner_ntests_failed(runner);
  srunner_free(runner);
  return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
