/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads the files of tests/vectors: planar problems with their solutions, and
 * the words and numbers of others.
 *
 * A file is a sequence of words; "#" begins a comment that goes to the end of
 * its line.  A planar problem is
 *
 *   problem NAME
 *   closed                  optional
 *   points X Y ...
 *   rule NAME               optional: knots by rule, or
 *   knots T ...             optional
 *   ends DX DY DX DY        optional
 *   tolerance E             of all that follows, relative to half the diagonal
 *                           of the points' bounding box
 *   control X Y ...         six control points for each segment
 *   lengths L ...           of the segments
 *   length L                of the curve
 */
#ifndef PH_TESTS_VECTORS_UNIT_H
#define PH_TESTS_VECTORS_UNIT_H

#include "planar_unit.h"

#include <stddef.h>

/* Numbers that grow. */
struct unit_numbers {
  double *v;
  size_t n, capacity;
};

struct unit_vector {
  char name[64];
  char rule[16]; /* "" if none */
  bool closed;
  double tolerance;
  struct unit_numbers points, knots, ends, control, lengths, length;
};

struct unit_vectors {
  char *text, *at;  /* the file, and what of it is still to be read */
  const char *path; /* for messages */
};

/* unit_vectors_open: a file below the source directory; a failure to read it
 * fails the test. */
struct unit_vectors unit_vectors_open(const char *path);

/* unit_vectors_word: the next word, NUL-terminated; NULL at the end. */
char *unit_vectors_word(struct unit_vectors *vectors);

/* unit_vectors_numbers: appends the numbers up to the next word that is none.
 */
void unit_vectors_numbers(struct unit_vectors *vectors,
                          struct unit_numbers *numbers);

/* unit_vectors_next: the next problem, in place of the one in *vector, which
 * is {0} at first; false at the end of the file.  What is not a problem, or
 * not a whole one, fails the test. */
bool unit_vectors_next(struct unit_vectors *vectors,
                       struct unit_vector *vector);

/* unit_vectors_close: frees the file and the last problem. */
void unit_vectors_close(struct unit_vectors *vectors,
                        struct unit_vector *vector);

/* unit_vector_problem: the problem of a vector, for unit_planar_solve. */
struct unit_solution unit_vector_problem(const struct unit_vector *vector);

#endif
