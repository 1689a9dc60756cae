/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random fields and options (see gate.h).
 *
 * Words are taken from the fields of the command, so that a new one is tried
 * as soon as there is one.  Some combinations are refused: that is tried, too.
 */
#include "gate.h"

/* The data of a case, that its fields are made for. */
struct data {
  struct unit_random *r;
  struct gate_case *c;
  double points[3 * GATE_POINTS];
  size_t n, dimension;
  double size; /* the longest chord, or 1 */
  bool wild;   /* the curve may be much larger than that */
};

static bool chance(struct unit_random *r, size_t n) {
  return unit_random_below(r, n) == 0;
}

static size_t intervals(const struct data *d) {
  const struct ph_value *closed = &d->c->problem.field[PH_F_CLOSED];
  return d->n - (closed->kind == PH_BOOL && closed->flag ? 0 : 1);
}

/* From point k to the next. */
static double chord(const struct data *d, size_t k) {
  const double *a = d->points + d->dimension * k;
  const double *b = d->points + d->dimension * (k + 1 < d->n ? k + 1 : 0);
  double sum = 0;
  for (size_t i = 0; i < d->dimension; i++) {
    sum = hypot(sum, b[i] - a[i]);
  }
  return sum;
}

static double extent(const struct data *d) {
  double largest = 0;
  for (size_t k = 0; k + 1 < d->n; k++) {
    double x = chord(d, k);
    largest = x > largest ? x : largest;
  }
  return largest > 0 && isfinite(largest) ? largest : 1;
}

/* ---- values ----------------------------------------------------------- */

static void word(struct data *d, enum ph_field_id id) {
  gate_word(d->r, d->c, id);
}

static double number_of(struct data *d, enum ph_field_id id) {
  struct unit_random *r = d->r;
  switch (id) {
  case PH_F_ALPHA:
    if (chance(r, 4)) { /* next to a longer one */
      d->wild = true;
      return gate_power(r, -9, 0.4);
    }
    return unit_random_in(r, 0.1, 3.1);
  case PH_F_TENSION: /* of spheres to be added, else to be multiplied */
    return strcmp(gate_schema(d->c)->command, "sphere") == 0
               ? gate_power(r, -2, 3)
           : chance(r, 4) ? gate_power(r, -4, 2)
                          : unit_random_in(r, 0.3, 1.3);
  case PH_F_PLANARITY:
  case PH_F_LENGTH_SIGMA:
  case PH_F_EPSILON:
    return gate_power(r, -8, -0.5);
  case PH_F_RADIUS_TOLERANCE:
    return gate_power(r, -6, -1);
  case PH_F_LAMBDA:
    return unit_random_in(r, 0.05, 1.5);
  case PH_F_JOINT_ANGLE:
    return unit_random_in(r, -2, 2);
  case PH_F_JOINT_POSITION:
    return unit_random_in(r, 0, 1);
  case PH_F_TOLERANCE:
    return d->size * gate_power(r, -5, -0.5);
  case PH_F_PIECES:
    return (double)(1 + unit_random_below(r, 12));
  case PH_F_STARTS:
    return (double)unit_random_below(r, 4);
  default:
    return (double)(1 + unit_random_below(r, 3)); /* refine */
  }
}

static double maybe_rounded(struct data *d, double x) {
  return chance(d->r, 2) && fabs(x) > 0.01 ? gate_decimals(x, 2) : x;
}

static void number(struct data *d, enum ph_field_id id) {
  gate_set_number(d->c, id, maybe_rounded(d, number_of(d, id)));
}

/* One number, or one each. */
static void numbers(struct data *d, enum ph_field_id id, size_t n) {
  double v[GATE_POINTS];
  for (size_t k = 0; k < n; k++) {
    v[k] = maybe_rounded(d, number_of(d, id));
  }
  if (chance(d->r, 2)) {
    gate_set_number(d->c, id, v[0]);
  } else {
    gate_set_numbers(d->c, id, v, n, 1);
  }
}

/* Knots by their chords, or by nothing. */
static void knots(struct data *d) {
  double v[GATE_POINTS + 1] = {chance(d->r, 2) ? 0
                                               : unit_random_in(d->r, -9, 9)};
  size_t n = intervals(d), how = unit_random_below(d->r, 4);
  for (size_t k = 0; k < n; k++) {
    double step = how == 0   ? 1
                  : how == 1 ? gate_power(d->r, -3, 0)
                             : chord(d, k) * unit_random_in(d->r, 0.7, 1.4);
    v[k + 1] = v[k] + step;
  }
  gate_set_numbers(d->c, PH_F_KNOTS, v, n + 1, 1);
}

/* Derivatives, of the size of a chord, or any. */
static void derivatives(struct data *d, enum ph_field_id id, size_t n) {
  double v[3 * GATE_POINTS];
  bool wild = chance(d->r, 8);
  d->wild = d->wild || wild;
  gate_directions(d->r, d->points, d->n, d->dimension, v);
  for (size_t k = 0; k < n; k++) {
    double at = chord(d, k + 1 < d->n ? k : 0);
    double size =
        at * (wild ? gate_power(d->r, -8, 8) : gate_power(d->r, -0.5, 0.5));
    for (size_t i = 0; i < d->dimension; i++) {
      v[d->dimension * k + i] *= size;
    }
  }
  gate_set_numbers(d->c, id, v, n, d->dimension);
}

static void directions(struct data *d, enum ph_field_id id, size_t n) {
  double v[3 * GATE_POINTS];
  gate_directions(d->r, d->points, d->n, d->dimension, v);
  gate_set_numbers(d->c, id, v, n, d->dimension);
}

static void flag(struct data *d, enum ph_field_id id) {
  gate_set_flag(d->c, id, chance(d->r, 2));
}

static void points(struct data *d, size_t dimension) {
  d->dimension = dimension;
  d->n = gate_points(d->r, dimension, d->points);
  if (d->n * dimension > GATE_NUMBERS) {
    d->n = GATE_NUMBERS / dimension;
  }
  d->size = extent(d);
  gate_set_numbers(d->c, PH_F_POINTS, d->points, d->n, dimension);
  if (chance(d->r, 3)) {
    gate_set_flag(d->c, PH_F_CLOSED, true);
  }
}

/* ---- commands -------------------------------------------------------------
 */

static void planar(struct data *d) {
  bool atph;
  points(d, 2);
  atph = chance(d->r, 3);
  if (atph) {
    gate_set_word(d->c, PH_F_BASIS, "atph", 0);
  }
  if (atph && chance(d->r, 2)) {
    if (chance(d->r, 2)) {
      numbers(d, PH_F_ALPHA, intervals(d));
    } else {
      word(d, PH_F_ALPHA);
    }
  } else if (chance(d->r, 4)) {
    knots(d);
  } else if (chance(d->r, 4)) {
    word(d, PH_F_KNOTS);
  }
  if (chance(d->r, 6)) {
    derivatives(d, PH_F_END_DERIVATIVES, 2);
  }
  if (chance(d->r, 12) && d->n <= 7) {
    word(d, PH_F_MINIMIZE);
    if (chance(d->r, 3)) {
      word(d, PH_F_FREE);
    }
  } else if (chance(d->r, 6) && d->n <= 6) {
    word(d, PH_F_SOLUTIONS);
  }
}

/* Segments of which a functional is minimised; each takes up to a second. */
enum { MINIMISED = 4 };

static void criterion(struct data *d) {
  static const char *const quick[] = {"cc", "hc", "bv", "zero"};
  bool few = d->n <= MINIMISED && chance(d->r, 8);
  if (few) {
    word(d, PH_F_CRITERION);
  } else {
    gate_set_word(d->c, PH_F_CRITERION, quick[unit_random_below(d->r, 4)], 0);
    if (gate_is(d->c, PH_F_BASIS, "atph")) {
      numbers(d, PH_F_ALPHA, intervals(d));
    }
  }
}

static void spatial(struct data *d) {
  struct unit_random *r = d->r;
  points(d, chance(r, 10) ? 2 : 3);
  if (chance(r, 3)) {
    directions(d, PH_F_TANGENTS, d->n);
  } else if (chance(r, 3)) {
    derivatives(d, PH_F_DERIVATIVES, d->n);
  }
  if (chance(r, 3)) {
    gate_set_word(d->c, PH_F_BASIS, "atph", 0);
    if (chance(r, 2)) {
      numbers(d, PH_F_ALPHA, intervals(d));
    }
  }
  if (chance(r, 4)) {
    double v[2 * GATE_POINTS];
    size_t n = chance(r, 2) ? 1 : intervals(d);
    for (size_t i = 0; i < 2 * n; i++) {
      v[i] = maybe_rounded(d, unit_random_in(r, -3.2, 3.2));
    }
    gate_set_numbers(d->c, PH_F_ANGLES, v, n, 2);
  } else if (chance(r, 2) || gate_is(d->c, PH_F_BASIS, "atph")) {
    criterion(d);
  }
  if (chance(r, 6)) {
    word(d, PH_F_AXIS);
  }
  if (chance(r, 6)) {
    knots(d);
  }
  if (chance(r, 6)) {
    numbers(d, PH_F_TENSION, intervals(d));
  }
  if (chance(r, 4)) {
    flag(d, PH_F_SHAPE);
  }
  if (chance(r, 10)) {
    number(d, PH_F_PLANARITY);
  }
}

/* Lengths of the chords, and more. */
static void lengths(struct data *d) {
  double v[GATE_POINTS], largest = 0;
  size_t n = intervals(d), how = unit_random_below(d->r, 4);
  for (size_t k = 0; k < n; k++) {
    double more = how == 0   ? gate_power(d->r, -6, 1)
                  : how == 1 ? gate_power(d->r, -3, -1)
                             : unit_random_in(d->r, 0.01, 0.5);
    v[k] = chord(d, k) * (1 + more);
    largest = v[k] > largest ? v[k] : largest;
  }
  if (chance(d->r, 8)) {
    gate_set_number(d->c, PH_F_LENGTHS, largest);
  } else {
    gate_set_numbers(d->c, PH_F_LENGTHS, v, n, 1);
  }
}

/* Vectors in the place of points. */
static void vectors(struct data *d) {
  struct ph_value *field = d->c->problem.field;
  bool tangents = chance(d->r, 2);
  field[PH_F_CLOSED].kind = PH_ABSENT;
  if (tangents) {
    directions(d, PH_F_TANGENTS, d->n);
  } else {
    derivatives(d, PH_F_DERIVATIVES, d->n);
  }
  lengths(d);
  field[PH_F_POINTS].kind = PH_ABSENT;
  if (chance(d->r, 4)) {
    gate_set_numbers(d->c, PH_F_START, d->points, 3, 1);
  }
  if (tangents && chance(d->r, 3)) {
    word(d, PH_F_MAGNITUDES);
  }
}

static void arclength(struct data *d) {
  struct unit_random *r = d->r;
  points(d, chance(r, 5) ? 2 : 3);
  if (chance(r, 4) && d->dimension == 3) {
    vectors(d);
  } else if (chance(r, 2)) {
    lengths(d);
    if (chance(r, 4)) {
      number(d, PH_F_LENGTH_SIGMA);
    }
  }
  if (chance(r, 6)) {
    word(d, PH_F_KNOTS);
  } else if (chance(r, 8)) {
    knots(d);
  }
  if (chance(r, 8)) {
    number(d, PH_F_REFINE);
  }
  if (chance(r, 8)) {
    word(d, PH_F_PLANAR);
  }
  if (chance(r, 10) && d->n <= 6) {
    number(d, PH_F_STARTS);
  }
  if (chance(r, 10) && d->n <= 6) {
    flag(d, PH_F_ALL_MINIMA);
  }
}

/* Points on the sphere as they are given. */
static void sphere_points(struct data *d) {
  struct unit_random *r = d->r;
  double v[3 * GATE_POINTS], center[3] = {0, 0, 0}, radius = 1;
  int decimals = 1 + (int)unit_random_below(r, 6);
  if (chance(r, 3)) {
    radius = chance(r, 2) ? 6371 : gate_power(r, -9, 9);
    radius = chance(r, 15) ? gate_power(r, -200, 200) : radius;
    gate_set_number(d->c, PH_F_RADIUS, radius);
  }
  for (size_t i = 0; i < 3 && chance(r, 5); i++) {
    center[i] = radius * unit_random_in(r, -1, 1) * gate_power(r, -1, 3);
    gate_set_numbers(d->c, PH_F_CENTER, center, 3, 1);
  }
  d->size *= radius;
  if (chance(r, 3)) {
    for (size_t k = 0; k < d->n; k++) {
      const double *p = d->points + 3 * k;
      double to_degrees = 57.29577951308232;
      v[2 * k] = gate_decimals(atan2(p[1], p[0]) * to_degrees, decimals);
      v[2 * k + 1] =
          gate_decimals(atan2(p[2], hypot(p[0], p[1])) * to_degrees, decimals);
    }
    gate_set_numbers(d->c, PH_F_LONLAT, v, d->n, 2);
    return;
  }
  for (size_t i = 0; i < 3 * d->n; i++) {
    double x = chance(r, 4) ? gate_decimals(d->points[i], 6) : d->points[i];
    v[i] = center[i % 3] + radius * x;
  }
  gate_set_numbers(d->c, PH_F_POINTS, v, d->n, 3);
}

static void sphere(struct data *d) {
  struct unit_random *r = d->r;
  d->dimension = 3;
  d->n = gate_sphere_points(r, d->points);
  d->size = extent(d);
  sphere_points(d);
  if (chance(r, 3)) {
    gate_set_flag(d->c, PH_F_CLOSED, true);
  } else if (chance(r, 4)) {
    directions(d, PH_F_END_TANGENTS, 2);
  } else if (chance(r, 4)) {
    word(d, PH_F_ENDS);
  }
  if (chance(r, 6)) {
    number(d, PH_F_RADIUS_TOLERANCE);
  }
  if (chance(r, 3)) {
    word(d, PH_F_MODEL);
  }
  if (chance(r, 4)) {
    word(d, PH_F_KNOTS);
  } else if (chance(r, 6)) {
    knots(d);
  }
  if (chance(r, 4)) {
    numbers(d, PH_F_TENSION, d->n);
  }
  if (chance(r, 3)) {
    flag(d, PH_F_SHAPE);
  } else if (chance(r, 3)) {
    word(d, PH_F_SHAPE);
  }
  if (chance(r, 4)) {
    word(d, PH_F_INCREASE);
  }
  if (chance(r, 6)) {
    word(d, PH_F_CRITERION);
  }
  if (chance(r, 6)) {
    number(d, PH_F_EPSILON);
  }
}

static void tc_pair(struct data *d) {
  if (chance(d->r, 2)) {
    gate_set_word(d->c, PH_F_JOINT, "chord", 0);
    if (chance(d->r, 2)) {
      number(d, PH_F_JOINT_ANGLE);
    }
    if (chance(d->r, 3)) {
      number(d, PH_F_JOINT_POSITION);
    }
  }
}

static void tc_spline(struct data *d, bool g2) {
  const char *rule = g2 ? "smooth" : "chord";
  if (!g2 && chance(d->r, 3)) {
    number(d, PH_F_LAMBDA);
  }
  if (gate_has(d->c, PH_F_CLOSED)) {
    return;
  }
  if (chance(d->r, 3)) {
    gate_set_word(d->c, PH_F_ENDS, chance(d->r, 2) ? rule : "circle", 0);
  } else if (chance(d->r, 4)) {
    directions(d, PH_F_END_TANGENTS, 2);
  } else if (!g2 && chance(d->r, 4)) {
    derivatives(d, PH_F_END_DERIVATIVES, 2);
  }
}

static void tc_approximate(struct data *d) {
  struct ph_value *field = d->c->problem.field;
  size_t n = d->n < 8 ? d->n : 8;
  gate_set_numbers(d->c, PH_F_CURVE, d->points, n, 2);
  field[PH_F_POINTS].kind = PH_ABSENT;
  field[PH_F_CLOSED].kind = PH_ABSENT;
  number(d, chance(d->r, 3) ? PH_F_PIECES : PH_F_TOLERANCE);
}

static void tc(struct data *d) {
  struct unit_random *r = d->r;
  size_t how = unit_random_below(r, 8);
  points(d, 2);
  if (how == 0) {
    tc_approximate(d);
  } else if (how == 1) {
    derivatives(d, PH_F_DERIVATIVES, d->n);
  } else if (how < 4) {
    gate_set_word(d->c, PH_F_MODE, how == 3 ? "g2" : "spline", 0);
    tc_spline(d, how == 3);
  } else {
    directions(d, PH_F_TANGENTS, d->n);
    if (how > 4) {
      word(d, PH_F_MODE);
    }
    if (gate_is(d->c, PH_F_MODE, "g1-pair")) {
      tc_pair(d);
    } else if (chance(r, 3)) {
      number(d, PH_F_LAMBDA);
    }
  }
  if (chance(r, 4) && d->n <= 4) { /* up to 4^n */
    word(d, PH_F_SOLUTIONS);
  }
  if (chance(r, 6)) {
    flag(d, PH_F_BLASCHKE);
  }
}

/* ---- options ------------------------------------------------------------ */

/* A length, rounded to two digits as people write it. */
static double length(struct data *d, double low, double high) {
  double x = d->size * gate_power(d->r, low, high);
  double unit = pow(10, floor(log10(x)) - 1);
  return chance(d->r, 2) && unit > 0 ? round(x / unit) * unit : x;
}

static void offsets(struct data *d) {
  struct gate_option *o = gate_add_option(d->c, "--offset=");
  size_t n = 1 + (chance(d->r, 4) ? unit_random_below(d->r, GATE_VALUES) : 0);
  bool wild = chance(d->r, 5);
  while (o->n < n) {
    double x = wild              ? length(d, -7, 4)
               : chance(d->r, 4) ? unit_random_in(d->r, 0.1, 2)
                                 : length(d, -2, 0.5);
    o->v[o->n++] = chance(d->r, 2) ? x : -x;
  }
  for (size_t i = 0; i < n; i++) { /* samples of it are not to be too many */
    d->size = fabs(o->v[i]) > d->size ? fabs(o->v[i]) : d->size;
  }
}

/* Samples, at most: the ten million that the program allows would be a minute
 * and gigabytes of text each. */
static const double SAMPLES = 1e5;

static void samples(struct data *d, bool space) {
  static const char *const frames[] = {"--frame=frenet", "--frame=erf",
                                       "--frame=rmf"};
  switch (d->wild ? 0 : unit_random_below(d->r, 3)) {
  case 0:
    gate_add_number(d->c,
                    "--sample=", (double)(1 + unit_random_below(d->r, 6)));
    break;
  case 1:
    gate_add_number(d->c, "--spacing=", length(d, -1.2, 0));
    break;
  default:
    gate_add_number(d->c, "--chord-error=", length(d, -3, -1));
  }
  gate_add_number(d->c, "--max-samples=", SAMPLES);
  if (space && chance(d->r, 2)) {
    gate_add_option(d->c, frames[unit_random_below(d->r, 3)]);
  }
}

static void sweep(struct data *d) {
  if (gate_has(d->c, PH_F_ALPHA) || !gate_has(d->c, PH_F_POINTS)) {
    return;
  }
  d->wild = true;
  if (chance(d->r, 2)) {
    struct gate_option *o = gate_add_option(d->c, "--sweep=points[1][0]*=");
    o->v[o->n++] = 1;
    o->v[o->n++] = gate_decimals(unit_random_in(d->r, 0.5, 1.5), 2);
  } else {
    gate_add_option(d->c, "--sweep=closed=false,true");
  }
}

static void options(struct data *d) {
  struct unit_random *r = d->r;
  const char *command = gate_schema(d->c)->command;
  bool space = strcmp(command, "spatial-hermite") == 0 ||
               strcmp(command, "arclength") == 0;
  if (chance(r, 6)) { /* the costliest option */
    offsets(d);
  }
  if (chance(r, 20)) {
    sweep(d);
  }
  if (chance(r, 3)) {
    samples(d, space);
  }
  if (gate_is(d->c, PH_F_BASIS, "atph") && chance(r, 3)) {
    gate_add_option(d->c, "--convert=bezier");
    if (chance(r, 3) && !d->wild) {
      gate_add_number(d->c, "--tolerance=", length(d, -8, -2));
    }
  }
}

/* What has no field or option of its own. */
static void rest(struct unit_random *r, struct gate_case *c) {
  if (chance(r, 20)) {
    gate_add_option(c, "--strict");
  }
  if (chance(r, 20)) {
    gate_add_option(c, "--pretty");
  }
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    c->set[i] = i != (size_t)gate_data(c) && chance(r, 20);
  }
}

void gate_random(struct unit_random *r, size_t command, struct gate_case *c) {
  static void (*const curves[GATE_CURVES])(struct data *) = {
      planar, spatial, arclength, sphere, tc};
  static void (*const surfaces[])(struct unit_random *, struct gate_case *) = {
      gate_cone, gate_bubble};
  static const char *const names[GATE_COMMANDS] = {
      "planar", "spatial-hermite", "arclength", "sphere", "tc",
      "cone",   "bubble"};
  struct data d = {.r = r, .c = c};
  memset(c, 0, sizeof *c);
  c->command = (size_t)(ph_command_find(names[command]) - ph_commands);
  if (command < GATE_CURVES) {
    curves[command](&d);
    options(&d);
  } else {
    surfaces[command - GATE_CURVES](r, c);
  }
  rest(r, c);
}
