/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the tests of a file are run, and the case that a failure names. */
#include "unit.h"

#include <gsl/gsl_errno.h>
#include <stdarg.h>

struct ph_arena unit_arena;

void (*unit_begin)(void), (*unit_finish)(void);

static char current[200];
static struct unit_test *first, **last = &first;

void unit_add(struct unit_test *test) {
  *last = test;
  last = &test->next;
}

const struct ph_quad *unit_quad(size_t n) {
  static struct ph_quad rules[PH_QUAD_MAX + 1];
  ck_assert_uint_le(n, PH_QUAD_MAX);
  ck_assert(rules[n].n == n || ph_quad_gauss(&rules[n], n));
  return &rules[n];
}

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
int main(int argc, char **argv) {
  const char *name = argc > 0 ? argv[0] : "";
  Suite *suite = suite_create(name);
  TCase *all = tcase_create(name);
  SRunner *runner = srunner_create(suite);
  int failed;
  tcase_set_timeout(all, 0);
  tcase_add_checked_fixture(all, unit_begin, unit_finish);
  tcase_add_checked_fixture(all, NULL, clean);
  for (const struct unit_test *t = first; t; t = t->next) {
    tcase_add_loop_test(all, t->check, 0, t->n);
  }
  suite_add_tcase(suite, all);
  gsl_set_error_handler_off();
  srunner_run_all(runner, CK_ENV);
  failed = srunner_ntests_failed(runner);
  srunner_free(runner);
  return failed == 0 && first ? EXIT_SUCCESS : EXIT_FAILURE;
}
