/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The same problem, larger by a power of two, turned by a quarter, mirrored, or
 * run through from its end, has the same solution there (see gate.h).  All of
 * that is exact, so that no digit of the data changes; but rounding in the
 * solver does, so that lengths may differ by what one of the data makes of
 * them.
 */
#include "gate.h"

enum motion { LARGER, TURNED, MIRRORED, REVERSED, MOTION_N };

static const char *const ways[] = {"moved larger", "moved turned",
                                   "moved mirrored", "moved reversed"};

/* Lengths of segments may differ by this part of that of the curve. */
static const double SAME = 1e-7;

/* How often data are shaken, and how many roundings of them a solver may have.
 */
enum { SHAKES = 4, ROUNDINGS = 8 };

/* Symmetric data have two curves that are as good, mirrored or reversed: the
 * solver takes the same one each time, so that rounding of the data shows
 * nothing.  Nor does it where convergence is a matter of luck.  Where data
 * shaken by this part of their size make a length jump, or have another
 * outcome, or lengths that are much nearer to those of the moved data than to
 * the solution, in one of so many trials, nothing is compared.  Lengths that
 * differ little are shaken by less than that, by a small part of their
 * difference. */
enum { TIES = 8 };
static const double TIED = 1e-6, JUMP = 1e-3, NEARER = 0.25, LESS = 0.01;

/* Which of two curves in a plane is nearer to its tangents is not told by data
 * that leave the plane by as much; so much more tells it. */
static const double OUTSIDE = 4;

/* Scales beyond which rounding of small numbers may be another. */
static const double HIGH = 1e100, LOW = 1e-100;

enum nature { SCALAR, LENGTH, POSITION, DIRECTION, DERIVATIVE, OTHER };

static enum nature nature_of(const struct gate_case *c, size_t field) {
  bool cone = strcmp(gate_schema(c)->command, "cone") == 0;
  switch (field) {
  case PH_F_POINTS:
  case PH_F_CURVE:
  case PH_F_CENTER:
  case PH_F_START:
  case PH_F_TRANSLATE:
    return POSITION;
  case PH_F_TANGENTS:
  case PH_F_END_TANGENTS:
  case PH_F_RULINGS:
  case PH_F_NORMALS:
    return DIRECTION;
  case PH_F_DERIVATIVES:
  case PH_F_END_DERIVATIVES:
    return DERIVATIVE;
  case PH_F_LENGTHS:
  case PH_F_RADIUS:
  case PH_F_APEXES:
  case PH_F_HEIGHT:
  case PH_F_FLAT:
  case PH_F_MERGE:
    return LENGTH;
  case PH_F_TOLERANCE: /* of meshes an angle */
    return gate_has(c, PH_F_FACES) ? SCALAR : LENGTH;
  case PH_F_LAMBDA:
    return cone ? LENGTH : SCALAR;
  case PH_F_LONLAT:
  case PH_F_ANGLES:
    return OTHER;
  default:
    return SCALAR;
  }
}

static bool in_range(const struct gate_case *c) {
  const struct ph_value *data = &c->problem.field[gate_data(c)];
  double largest = 0;
  for (size_t i = 0; i < data->n * data->dimension; i++) {
    double x = fabs(data->v[i]);
    largest = x > largest ? x : largest;
  }
  return largest > LOW && largest < HIGH;
}

/* Whether the motion takes solutions to solutions, and the solver has no choice
 * between several. */
static bool applies(const struct gate_case *c, enum motion motion) {
  const char *command = gate_schema(c)->command;
  bool planar = strcmp(command, "planar") == 0;
  bool sphere = strcmp(command, "sphere") == 0;
  bool space = strcmp(command, "spatial-hermite") == 0;
  bool closed = gate_has(c, PH_F_CLOSED);
  bool raised = sphere && !(c->problem.field[PH_F_SHAPE].kind == PH_BOOL &&
                            !c->problem.field[PH_F_SHAPE].flag);
  bool searched = raised || gate_has(c, PH_F_MINIMIZE) ||
                  gate_has(c, PH_F_LENGTHS) || gate_has(c, PH_F_ALL_MINIMA) ||
                  gate_has(c, PH_F_STARTS);
  if (searched || !in_range(c) || gate_has(c, PH_F_LONLAT)) {
    return false;
  }
  if (motion == LARGER) { /* by which parameter, is said by the knots */
    return !gate_is(c, PH_F_TANGENT_SCALE, "unit") &&
           !(planar && gate_has(c, PH_F_END_DERIVATIVES)) &&
           !(space && gate_has(c, PH_F_KNOTS)) &&
           !(sphere && !gate_has(c, PH_F_RADIUS));
  }
  if (gate_has(c, PH_F_ANGLES) || gate_has(c, PH_F_AXIS) ||
      gate_is(c, PH_F_CRITERION, "zero")) {
    return false;
  }
  return motion != REVERSED ||
         !(closed || gate_has(c, PH_F_FACES) || gate_has(c, PH_F_LAMBDA) ||
           gate_has(c, PH_F_CONTACT_POINT) || gate_has(c, PH_F_FLAT) ||
           gate_has(c, PH_F_CURVE) || gate_has(c, PH_F_KNOTS) ||
           gate_has(c, PH_F_JOINT_ANGLE) || gate_has(c, PH_F_JOINT_POSITION));
}

static void move_vector(double *x, size_t n, enum motion motion) {
  double first = x[0];
  if (motion == MIRRORED) {
    x[1] = -x[1];
  } else if (motion == TURNED && n == 2) {
    x[0] = -x[1];
    x[1] = first;
  } else if (motion == TURNED) {
    x[0] = x[1];
    x[1] = x[2];
    x[2] = first;
  }
}

static void reverse(struct ph_value *value, bool negate) {
  size_t d = value->dimension;
  for (size_t i = 0, j = value->n - 1; i < j; i++, j--) {
    for (size_t k = 0; k < d; k++) {
      double x = value->v[d * i + k];
      value->v[d * i + k] = value->v[d * j + k];
      value->v[d * j + k] = x;
    }
  }
  for (size_t i = 0; i < value->n * d && negate; i++) {
    value->v[i] = -value->v[i];
  }
}

static void move_field(struct gate_case *c, size_t field, enum motion motion) {
  struct ph_value *value = &c->problem.field[field];
  enum nature nature = nature_of(c, field);
  bool vectors =
      nature == POSITION || nature == DIRECTION || nature == DERIVATIVE;
  bool array = value->kind == PH_NUMBERS || value->kind == PH_VECTORS;
  bool one =
      field == PH_F_CENTER || field == PH_F_START || field == PH_F_TRANSLATE;
  size_t d = one ? 3 : value->dimension;
  if (motion == LARGER &&
      (nature == LENGTH || nature == POSITION || nature == DERIVATIVE)) {
    value->number = ldexp(value->number, 5);
    for (size_t i = 0; array && i < value->n * value->dimension; i++) {
      value->v[i] = ldexp(value->v[i], 5);
    }
  }
  for (size_t i = 0; array && vectors && i < value->n * value->dimension;
       i += d) {
    move_vector(value->v + i, d, motion);
  }
  if (motion == MIRRORED && field == PH_F_JOINT_ANGLE) { /* to the left */
    value->number = -value->number;
  }
  if (motion == REVERSED && array && d == value->dimension) {
    bool across = field == PH_F_RULINGS || field == PH_F_NORMALS;
    if (field != PH_F_HEIGHT) {
      reverse(value, !across && (nature == DIRECTION || nature == DERIVATIVE));
    }
  }
}

/* Every number of the data becomes one of its neighbours, or stays; or it
 * changes by less than a part of the largest one of its field. */
static void shake(struct gate_case *c, struct unit_random *r, double part) {
  for (size_t field = 0; field < PH_FIELD_N; field++) {
    struct ph_value *value = &c->problem.field[field];
    bool array = value->kind == PH_NUMBERS || value->kind == PH_VECTORS;
    bool data = nature_of(c, field) != SCALAR && nature_of(c, field) != OTHER;
    double size = 0;
    for (size_t i = 0; array && data && i < value->n * value->dimension; i++) {
      size = fmax(size, part * fabs(value->v[i]));
    }
    for (size_t i = 0; array && data && i < value->n * value->dimension; i++) {
      double x = value->v[i];
      const double to[] = {-HUGE_VAL, x, HUGE_VAL};
      value->v[i] = size > 0 ? x + size * unit_random_in(r, -1, 1)
                             : nextafter(x, to[unit_random_below(r, 3)]);
    }
  }
}

/* The length of segment i of the solution of moved data, where the data are. */
static double length_of(const struct gate_outcome *moved, enum motion motion,
                        size_t i) {
  double scale = motion == LARGER ? ldexp(1, -5) : 1;
  size_t at = motion == REVERSED ? moved->segments - 1 - i : i;
  return scale * moved->lengths[at];
}

/* The largest change of a length, to data that are moved or, MOTION_N, not. */
static double change_of(const struct gate_outcome *a,
                        const struct gate_outcome *b, enum motion motion) {
  double scale = motion == LARGER ? ldexp(1, -5) : 1;
  double change = fabs(a->length - scale * b->length);
  if (a->fate != b->fate || a->segments != b->segments) {
    return HUGE_VAL;
  }
  for (size_t i = 0; i < a->segments && a->segments <= GATE_POINTS; i++) {
    change = fmax(change, fabs(a->lengths[i] - length_of(b, motion, i)));
  }
  return change;
}

/* By which part of their size data are shaken. */
static double tied_within(const struct gate_case *c, double difference) {
  const struct ph_value *planarity = &c->problem.field[PH_F_PLANARITY];
  double part = fmin(TIED, LESS * difference);
  double outside =
      planarity->kind == PH_NUMBER ? planarity->number : PH_PLANARITY;
  bool space = strcmp(gate_schema(c)->command, "spatial-hermite") == 0;
  return space ? fmax(part, OUTSIDE * outside) : part;
}

/* Whether there is another solution, or none, beside the data. */
static bool is_tied(struct gate_lab *lab, const struct gate_case *c,
                    const struct gate_outcome *plain,
                    const struct gate_outcome *moved, enum motion motion) {
  static _Thread_local struct gate_case shaken;
  struct unit_random r = unit_random_of(2);
  double difference = change_of(plain, moved, motion) / plain->length;
  double part = tied_within(c, difference);
  struct gate_outcome there;
  for (int i = 0; i < TIES; i++) {
    double change;
    gate_copy(&shaken, c);
    shake(&shaken, &r, part);
    gate_run(lab, &shaken, GATE_MEASURED, &there);
    change = change_of(plain, &there, MOTION_N);
    if (!(change <= JUMP * plain->length) ||
        change_of(&there, moved, motion) < NEARER * change) {
      return true;
    }
  }
  return false;
}

/* By how much lengths may differ, as the data are known to rounding. */
static double allowance(struct gate_lab *lab, const struct gate_case *c,
                        const struct gate_outcome *plain) {
  static _Thread_local struct gate_case shaken;
  struct unit_random r = unit_random_of(1);
  struct gate_outcome there;
  double change = 0;
  for (int i = 0; i < SHAKES; i++) {
    gate_copy(&shaken, c);
    shake(&shaken, &r, 0);
    gate_run(lab, &shaken, GATE_MEASURED, &there);
    change = fmax(change, change_of(plain, &there, MOTION_N));
  }
  return ROUNDINGS * change;
}

static void compare(const struct gate_outcome *a, const struct gate_outcome *b,
                    enum motion motion, double allowed,
                    struct gate_outcome *outcome) {
  double scale = motion == LARGER ? ldexp(1, -5) : 1;
  size_t n = a->segments;
  if (a->fate != b->fate && isfinite(allowed)) {
    gate_wrong(outcome, ways[motion], "%s becomes %s",
               a->fate == GATE_SOLVED ? "solved" : ph_status_code(a->code),
               b->fate == GATE_SOLVED ? "solved" : ph_status_code(b->code));
    return;
  }
  if (a->fate != GATE_SOLVED || a->ambiguous || b->ambiguous) {
    return;
  }
  if (!(fabs(a->length - scale * b->length) <= SAME * a->length + allowed)) {
    gate_wrong(outcome, ways[motion], "the length %.17g becomes %.17g",
               a->length, scale * b->length);
  }
  for (size_t i = 0; n == b->segments && n <= GATE_POINTS && i < n; i++) {
    double other = length_of(b, motion, i);
    if (!(fabs(a->lengths[i] - other) <= SAME * a->length + allowed)) {
      gate_wrong(outcome, ways[motion],
                 "the length %.17g of segment %zu becomes %.17g", a->lengths[i],
                 i, other);
    }
  }
}

void gate_moved(struct gate_lab *lab, const struct gate_case *c,
                struct gate_outcome *outcome) {
  static _Thread_local struct gate_case here, moved;
  struct gate_outcome plain, there, found;
  bool run = false;
  gate_copy(&here, c);
  here.options_n = 0;
  for (int motion = 0; motion < MOTION_N; motion++) {
    if (outcome->fate == GATE_WRONG || !applies(c, (enum motion)motion)) {
      continue;
    }
    if (!run) {
      gate_run(lab, &here, GATE_MEASURED, &plain);
      run = true;
    }
    gate_copy(&moved, &here);
    for (size_t i = 0; i < PH_FIELD_N; i++) {
      if (gate_has(c, (enum ph_field_id)i)) {
        move_field(&moved, i, (enum motion)motion);
      }
    }
    gate_run(lab, &moved, GATE_MEASURED, &there);
    if (plain.fate != GATE_WRONG && there.fate != GATE_WRONG) {
      found = *outcome;
      compare(&plain, &there, (enum motion)motion, 0, &found);
      if (found.fate == GATE_WRONG &&
          !is_tied(lab, &here, &plain, &there, (enum motion)motion)) {
        compare(&plain, &there, (enum motion)motion,
                allowance(lab, &here, &plain), outcome);
      }
    }
  }
}
