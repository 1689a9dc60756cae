/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of every method share: a problem's fields, and its solution. */
#ifndef PH_TESTS_PROBLEM_UNIT_H
#define PH_TESTS_PROBLEM_UNIT_H

#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "solve/method.h"

#include <stdbool.h>
#include <stddef.h>

/* Fields; a word that is NULL and a number that is NaN are left out. */
void unit_set_word(struct ph_problem *problem, enum ph_field_id id,
                   const char *word);
void unit_set_number(struct ph_problem *problem, enum ph_field_id id, double x);
void unit_set_flag(struct ph_problem *problem, enum ph_field_id id, bool flag);

/* n vectors, or numbers where the dimension is 1; they stay where they are. */
void unit_set_array(struct ph_problem *problem, enum ph_field_id id, double *v,
                    size_t n, size_t dimension);

/* A problem and what became of it.  {0} is none. */
struct unit_solution {
  struct ph_problem problem;
  struct ph_result result; /* after a solution */
  struct ph_diag diag;     /* after a failure */
  bool refused;            /* it is the certificate that failed */
  struct ph_arena arena;   /* of both, and of the fields' values */
  struct ph_arena scratch;
};

/* unit_numbers: memory for n numbers of a solution. */
double *unit_numbers(struct unit_solution *s, size_t n);

/* unit_set_copy: as unit_set_array, of a copy. */
void unit_set_copy(struct unit_solution *s, enum ph_field_id id,
                   const double *v, size_t n, size_t dimension);

/* unit_put_apart: copies the control points of curves that are `joined', so
 * that they are no longer. */
void unit_put_apart(struct unit_solution *s);

/* unit_solve: as the program does; the method's scratch memory must have been
 * given back.  Curves are put apart.  May be called again. */
enum ph_status unit_solve(const struct ph_method *method,
                          struct unit_solution *s);

/* unit_certify: then, whether the command may print it. */
enum ph_status unit_certify(const char *command, struct unit_solution *s);

/* unit_solution_free: gives its memory back; {0} remains. */
void unit_solution_free(struct unit_solution *s);

/* unit_diagnostic: a number that must be known. */
double unit_diagnostic(const struct ph_diagnostics *diagnostics,
                       enum ph_diagnostic which);

#endif
