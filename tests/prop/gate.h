/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The gate: random problems of all commands, with all their fields and the
 * options that derive something, each solved as the program does it, from
 * bytes to bytes, and each result given to `phspline verify' with its problem.
 * What fails is made smaller while it fails in the same way, and printed as one
 * command line.
 *
 *   gate_case.c    problems as values, and as text
 *   gate_points.c  points that are hard in some way
 *   gate_fields.c  random fields and options
 *   gate_surfaces.c  ... of surfaces: contact elements, and meshes
 *   gate_run.c     from problem to verdict
 *   gate_brute.c   diagnostics, by brute force
 *   gate_moved.c   problems turned, mirrored, reversed, scaled
 *   gate_shrink.c  smaller problems
 */
#ifndef PH_TESTS_PROP_GATE_H
#define PH_TESTS_PROP_GATE_H

#include "unit.h"

#include "base/buf.h"
#include "cli/option.h"
#include "cli/work.h"

enum {
  GATE_POINTS = 48,   /* points, at most */
  GATE_NUMBERS = 160, /* numbers of a field */
  GATE_WORD = 16,     /* bytes of a word */
  GATE_OPTIONS = 9,   /* options, at most */
  GATE_VALUES = 4,    /* numbers of an option */
  GATE_FACES = 40,    /* faces of a mesh, at most */
  GATE_CURVES = 5,    /* commands that solve by curves, the first ones, */
  GATE_COMMANDS = 7,  /* all that solve: those by surfaces, too */
  GATE_MESSAGE = 400
};

/* An option: its text, and numbers that follow, separated by commas. */
struct gate_option {
  const char *text;
  double v[GATE_VALUES];
  size_t n;
};

/* A problem and what is asked for; its values are its own (gate_copy). */
struct gate_case {
  size_t command; /* of ph_commands */
  struct ph_problem problem;
  bool set[PH_FIELD_N]; /* the field is an option, --FIELD=VALUE */
  struct gate_option option[GATE_OPTIONS];
  size_t options_n;
  double v[PH_FIELD_N][GATE_NUMBERS]; /* numbers of fields, */
  char word[PH_FIELD_N][GATE_WORD];   /* words */
  size_t sizes[GATE_FACES];           /* of lists: only one field has these */
};

/* What became of it. */
enum gate_fate { GATE_SOLVED, GATE_REFUSED, GATE_WRONG };

struct gate_outcome {
  enum gate_fate fate;
  enum ph_status code; /* GATE_REFUSED: why */
  bool ambiguous;      /* GATE_MEASURED: there is another good curve, or may be,
                          as the search was cut short */
  double length;       /* ... of the first result, and those of its segments, */
  double lengths[GATE_POINTS]; /* as far as they fit */
  size_t segments;
  bool disputed; /* GATE_WRONG: verify refuses what brute force agrees with */
  char way[96];  /* GATE_WRONG: in which way; without numbers */
  char message[GATE_MESSAGE];
};

/* What trials work with: a worker each for the program, for the same again, and
 * for verification. */
struct gate_lab {
  struct ph_worker first, again, verifier;
  struct ph_arena arena;
  struct ph_buf problem, out, err, repeated, complaints, verdict;
};

/* ---- cases ----------------------------------------------------------------
 */

/* gate_schema: the fields of the command of a case. */
const struct ph_schema *gate_schema(const struct gate_case *c);

/* gate_copy: to = from. */
void gate_copy(struct gate_case *to, const struct gate_case *from);

/* gate_set_numbers: a field of vectors v[n][dimension]; dimension 1: numbers.
 * What does not fit is cut off. */
void gate_set_numbers(struct gate_case *c, enum ph_field_id id, const double *v,
                      size_t n, size_t dimension);

void gate_set_number(struct gate_case *c, enum ph_field_id id, double x);
void gate_set_word(struct gate_case *c, enum ph_field_id id, const char *word,
                   double number);
void gate_set_flag(struct gate_case *c, enum ph_field_id id, bool flag);

/* gate_set_lists: v[] as lists of so many numbers. */
void gate_set_lists(struct gate_case *c, enum ph_field_id id, const double *v,
                    const size_t *sizes, size_t sizes_n);

/* gate_add_option: an option without a number, or the first one of it. */
struct gate_option *gate_add_option(struct gate_case *c, const char *text);
void gate_add_number(struct gate_case *c, const char *text, double x);

static inline bool gate_has(const struct gate_case *c, enum ph_field_id id) {
  return c->problem.field[id].kind != PH_ABSENT;
}

static inline bool gate_is(const struct gate_case *c, enum ph_field_id id,
                           const char *word) {
  const struct ph_value *value = &c->problem.field[id];
  return value->kind == PH_WORD && strcmp(value->word, word) == 0;
}

/* gate_data: the field whose vectors are the data: points, lonlat, curve, or
 * vectors in the place of points. */
enum ph_field_id gate_data(const struct gate_case *c);

/* gate_value: a value as JSON. */
void gate_value(struct ph_buf *buf, const struct ph_value *value);

/* gate_problem: the record, without the fields that are options. */
void gate_problem(struct ph_buf *buf, const struct gate_case *c);

/* gate_arguments: the options of the case, or of verify for it; NUL-terminated
 * texts in the arena.
 * out  argv[GATE_ARGUMENTS]
 * ret  how many */
enum { GATE_ARGUMENTS = 4 + GATE_OPTIONS + PH_FIELD_N };
int gate_arguments(const struct gate_case *c, bool verify,
                   struct ph_arena *arena, char **argv);

/* gate_command_line: what reproduces the case. */
void gate_command_line(struct ph_buf *buf, const struct gate_case *c);

/* ---- random cases ---------------------------------------------------------
 */

/* gate_points: 2 or more points of some family, of about unit size.
 * out  v[n][dimension], n <= GATE_POINTS
 * ret  n */
size_t gate_points(struct unit_random *r, size_t dimension, double *v);

/* gate_sphere_points: unit vectors v[n][3]. */
size_t gate_sphere_points(struct unit_random *r, double *v);

/* gate_place: v[n][dimension] at another scale, or far away, or as they are. */
void gate_place(struct unit_random *r, size_t n, size_t dimension, double *v);

/* gate_directions: n unit vectors, some exactly along axes or equal. */
void gate_directions(struct unit_random *r, const double *points, size_t n,
                     size_t dimension, double *v);

/* gate_power: 10^x, x uniform. */
double gate_power(struct unit_random *r, double low, double high);

/* gate_decimals: x, rounded to some decimals. */
double gate_decimals(double x, int decimals);

/* gate_word: one of the words that a field may have, "a|b|plus:V". */
void gate_word(struct unit_random *r, struct gate_case *c, enum ph_field_id id);

/* gate_cone, gate_bubble: any contact elements, any mesh, with fields and
 * options. */
void gate_cone(struct unit_random *r, struct gate_case *c);
void gate_bubble(struct unit_random *r, struct gate_case *c);

/* gate_random: any case of command 0 <= command < GATE_COMMANDS. */
void gate_random(struct unit_random *r, size_t command, struct gate_case *c);

/* ---- trials ---------------------------------------------------------------
 */

/* What a result is for: only to be verified; also to be compared with others,
 * so that its lengths are wanted; or all there is: the same again, verified
 * without its problem, and brute force. */
enum gate_look { GATE_VERIFIED, GATE_MEASURED, GATE_CLOSELY };

/* gate_run: solves and verifies. */
void gate_run(struct gate_lab *lab, const struct gate_case *c,
              enum gate_look look, struct gate_outcome *outcome);

/* gate_wrong: something is wrong, in a way; the first one counts. */
void gate_wrong(struct gate_outcome *outcome, const char *way,
                const char *format, ...) PH_PRINTF(3, 4);

/* gate_brute: diagnostics of a result that verify leaves alone. */
void gate_brute(const struct ph_result *result, struct gate_outcome *outcome);

/* gate_moved: the same problem elsewhere, without options, has the same
 * solution.
 * inout outcome  wrong if another is found elsewhere */
void gate_moved(struct gate_lab *lab, const struct gate_case *c,
                struct gate_outcome *outcome);

/* gate_shrink: a smaller case that goes wrong in the same way.
 * inout c, outcome */
void gate_shrink(struct gate_lab *lab, struct gate_case *c,
                 struct gate_outcome *outcome);

void gate_lab_free(struct gate_lab *lab);

#endif
