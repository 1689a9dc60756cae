/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random surfaces (see gate.h): contact elements that are scattered, or of one
 * developable surface, and small meshes, closed and with boundaries, with all
 * fields and options that they may have.
 */
#include "gate.h"

#include "kernel/vec3.h"

static const double TURN = 6.283185307179586;

static bool chance(struct unit_random *r, size_t n) {
  return unit_random_below(r, n) == 0;
}

static ph_vec3 any(struct unit_random *r, double size) {
  const double x = unit_random_in(r, -size, size);
  const double y = unit_random_in(r, -size, size);
  return ph_vec3_of(x, y, unit_random_in(r, -size, size));
}

static ph_vec3 get(const double *v, size_t i) {
  return ph_vec3_get(v + 3 * i, 3);
}

static void put(double *v, size_t i, ph_vec3 a) {
  ph_vec3_put(a, 3, v + 3 * i);
}

/* The largest distance from the first point, or 1. */
static double extent(const double *v, size_t n) {
  double size = 0;
  for (size_t i = 1; i < n; i++) {
    size = fmax(size, ph_vec3_abs(ph_vec3_sub(get(v, i), get(v, 0))));
  }
  return size > 0 && isfinite(size) ? size : 1;
}

/* Numbers of about that size, of both signs or of one. */
static double about(struct unit_random *r, double size) {
  double x = size * gate_power(r, -2, 1);
  x = chance(r, 2) ? gate_decimals(x, 2) : x;
  return chance(r, 2) ? x : -x;
}

static void add_offsets(struct unit_random *r, struct gate_case *c,
                        double size) {
  struct gate_option *o = gate_add_option(c, "--offset=");
  size_t n = chance(r, 3) ? 2 : 1;
  while (o->n < n) {
    double x = chance(r, 4) ? size * gate_power(r, -9, 3) : about(r, size / 4);
    o->v[o->n++] = x;
  }
}

/* ---- contact elements -----------------------------------------------------
 */

enum { ELEMENTS = 12 };

/* Points, rulings, tangents. */
struct elements {
  size_t n;
  double p[3 * ELEMENTS], e[3 * ELEMENTS], d[3 * ELEMENTS];
};

/* A tangent along its ruling stays there: it is for the program to say so. */
static void set_frame(struct elements *s, size_t i, ph_vec3 e, ph_vec3 d) {
  ph_vec3 across;
  e = ph_vec3_unit(e);
  across = ph_vec3_normal(d, e);
  put(s->e, i, e);
  put(s->d, i, ph_vec3_abs(across) > 0 ? ph_vec3_unit(across) : d);
}

static void scatter(struct unit_random *r, struct elements *s) {
  for (size_t i = 0; i < s->n; i++) {
    put(s->p, i, any(r, 1));
    set_frame(s, i, any(r, 1), any(r, 1));
  }
}

/* Along a polygon: rulings anywhere, or all the same; or the second element
 * is the first one, turned about its ruling or its tangent. */
static void along(struct unit_random *r, struct elements *s) {
  double v[3 * GATE_POINTS], t[3 * GATE_POINTS];
  size_t n = gate_points(r, 3, v), how = unit_random_below(r, 4);
  s->n = n < s->n ? n : s->n;
  gate_directions(r, v, n, 3, t);
  memcpy(s->p, v, 3 * s->n * sizeof *v);
  for (size_t i = 0; i < s->n; i++) {
    ph_vec3 e = i > 0 && how < 2 ? get(s->e, i - 1) : any(r, 1);
    set_frame(s, i, e, get(t, i));
  }
  if (how == 3 && s->n > 1) {
    double sign = chance(r, 2) ? 1 : -1;
    put(s->e, 1, ph_vec3_scale(sign, get(s->e, 0)));
    put(s->d, 1, ph_vec3_scale(-sign, get(s->d, 0)));
  }
}

/* Each element from the one before along a strip of a circular cone, of one
 * cone or of others, a cylinder or a plane where k or kn is 0; the point is
 * moved along its ruling. */
static void strips(struct unit_random *r, struct elements *s) {
  double k = unit_random_in(r, -1, 1), kn = unit_random_in(r, -1, 1);
  bool same = chance(r, 2);
  size_t flat = unit_random_below(r, 5);
  put(s->p, 0, any(r, 1));
  set_frame(s, 0, any(r, 1), any(r, 1));
  for (size_t i = 1; i < s->n; i++) {
    ph_vec3 e = get(s->e, i - 1), d = get(s->d, i - 1);
    ph_vec3 n = ph_vec3_cross(e, d), bend, way, to;
    double a = flat == 0 ? 0 : k, b = flat == 1 ? 0 : kn;
    double h = fmax(hypot(a, b), 1e-6), length = unit_random_in(r, 0.05, 2);
    double S = sin(h * length) / h, Q = (1 - cos(h * length)) / (h * h);
    bend = ph_vec3_along(ph_vec3_scale(a, e), b, n);
    way = ph_vec3_along(ph_vec3_scale(S, d), Q, bend);
    to = ph_vec3_along(e, -a, way);
    put(s->p, i,
        ph_vec3_along(ph_vec3_add(get(s->p, i - 1), way),
                      chance(r, 2) ? 0 : unit_random_in(r, -1, 1), to));
    set_frame(s, i, to,
              ph_vec3_along(ph_vec3_scale(cos(h * length), d), S, bend));
    k = same ? k : unit_random_in(r, -1, 1);
    kn = same ? kn : unit_random_in(r, -1, 1);
  }
}

/* Of the tangents of a helix. */
static void helix(struct unit_random *r, struct elements *s) {
  double pitch = unit_random_in(r, 0.2, 2), step = gate_power(r, -3, 0.3);
  for (size_t i = 0; i < s->n; i++) {
    double t = step * (double)i;
    ph_vec3 e = ph_vec3_of(-sin(t), cos(t), pitch);
    put(s->p, i, ph_vec3_along(ph_vec3_of(cos(t), sin(t), pitch * t), 1, e));
    set_frame(s, i, e, ph_vec3_of(-cos(t), -sin(t), 0));
  }
}

/* Noise, few digits, another scale; frames are made orthogonal again, mostly.
 */
static void spoil(struct unit_random *r, struct elements *s) {
  bool noise = chance(r, 3), rounded = chance(r, 3);
  double size = gate_power(r, -16, -1);
  int decimals = 3 + (int)unit_random_below(r, 6);
  for (size_t i = 0; i < s->n && noise; i++) {
    ph_vec3 e = ph_vec3_add(get(s->e, i), any(r, size));
    put(s->p, i, ph_vec3_add(get(s->p, i), any(r, size)));
    set_frame(s, i, e, ph_vec3_add(get(s->d, i), any(r, size)));
  }
  for (size_t i = 0; i < 3 * s->n && rounded; i++) {
    s->p[i] = gate_decimals(s->p[i], decimals);
    s->e[i] = gate_decimals(s->e[i], decimals);
    s->d[i] = gate_decimals(s->d[i], decimals);
  }
  gate_place(r, s->n, 3, s->p);
}

static void normals(struct unit_random *r, struct gate_case *c,
                    const struct elements *s) {
  double v[3 * ELEMENTS], sign = chance(r, 2) ? 1 : -1;
  for (size_t i = 0; i < s->n; i++) {
    ph_vec3 n = ph_vec3_cross(get(s->e, i), get(s->d, i));
    put(v, i, ph_vec3_add(ph_vec3_scale(sign, n), any(r, 1e-4)));
  }
  gate_set_numbers(c, PH_F_NORMALS, v, s->n, 3);
}

/* One number, or n. */
static void numbers(struct unit_random *r, struct gate_case *c,
                    enum ph_field_id id, double *v, size_t n) {
  if (chance(r, 2)) {
    gate_set_number(c, id, v[0]);
  } else {
    gate_set_numbers(c, id, v, n, 1);
  }
}

static void circular(struct unit_random *r, struct gate_case *c, size_t pairs,
                     double size) {
  double v[ELEMENTS];
  for (size_t i = 0; i < pairs; i++) {
    v[i] = fabs(about(r, size));
  }
  if (chance(r, 4)) {
    numbers(r, c, PH_F_LAMBDA, v, pairs);
  } else if (chance(r, 8)) {
    gate_word(r, c, PH_F_LAMBDA);
  }
  if (chance(r, 8)) {
    gate_set_number(c, PH_F_DEGENERATE, gate_power(r, -14, -1.5));
  }
}

static void general(struct unit_random *r, struct gate_case *c, size_t pairs,
                    const struct elements *s) {
  double v[4 * ELEMENTS], size = extent(s->p, s->n);
  bool one_side = chance(r, 2);
  gate_set_word(c, PH_F_METHOD, "atph", 0);
  for (size_t i = 0; i < s->n; i++) {
    v[i] = about(r, 3 * size);
    v[i] = one_side ? fabs(v[i]) : v[i];
  }
  gate_set_numbers(c, PH_F_APEXES, v, s->n, 1);
  if (chance(r, 4)) {
    gate_set_number(c, PH_F_CONTACT_POINT, unit_random_in(r, -0.5, 1.5));
  } else if (chance(r, 3)) {
    gate_word(r, c, PH_F_CONTACT_POINT);
  }
  if (chance(r, 4)) {
    gate_word(r, c, PH_F_TANGENT_SCALE);
  }
  for (size_t i = 0; i < 2 * pairs; i++) {
    v[i] = unit_random_in(r, 0.1, 3.1);
  }
  if (chance(r, 2)) {
    numbers(r, c, PH_F_ALPHA, v, 2 * pairs);
  }
  for (size_t i = 0; i < 4 * pairs; i++) {
    v[i] = unit_random_in(r, -3.2, 3.2);
  }
  if (chance(r, 3)) {
    gate_set_numbers(c, PH_F_ANGLES, v, chance(r, 2) ? 1 : 2 * pairs, 2);
  } else if (chance(r, 3)) {
    gate_word(r, c, PH_F_CRITERION);
  }
}

/* Fields of both methods. */
static void anyway(struct unit_random *r, struct gate_case *c,
                   const struct elements *s, double size) {
  double v[8];
  if (chance(r, 3)) {
    v[0] = about(r, size);
    v[1] = v[0] + fabs(about(r, size));
    gate_set_numbers(c, PH_F_HEIGHT, v, 2, 1);
  }
  if (chance(r, 6)) {
    for (size_t i = 0; i < 8; i++) {
      v[i] = unit_random_in(r, -size, size);
    }
    gate_set_numbers(c, PH_F_FLAT, v, 1 + unit_random_below(r, 4), 2);
  }
  if (chance(r, 8)) {
    put(v, 0, any(r, size * gate_power(r, -3, 3)));
    gate_set_numbers(c, PH_F_TRANSLATE, v, 3, 1);
  }
  if (chance(r, 6)) {
    normals(r, c, s);
  }
  if (chance(r, 10)) {
    gate_set_number(c, PH_F_MERGE, size * gate_power(r, -9, -1));
  }
}

static void cone_options(struct unit_random *r, struct gate_case *c,
                         double size) {
  static const char *const samples[] = {"--sample=3", "--sample=2x3",
                                        "--sample=7x1"};
  if (chance(r, 3)) {
    add_offsets(r, c, size);
  }
  if (chance(r, 4)) {
    gate_add_option(c, samples[unit_random_below(r, 3)]);
  }
  if (gate_has(c, PH_F_METHOD) && chance(r, 4)) {
    gate_add_number(c, "--tolerance=", size * gate_power(r, -7, -2));
  }
  if (chance(r, 20)) {
    gate_add_option(c, "--sweep=closed=false,true");
  }
}

void gate_cone(struct unit_random *r, struct gate_case *c) {
  static void (*const families[])(struct unit_random *, struct elements *) = {
      scatter, along, strips, helix, strips};
  struct elements s;
  size_t pairs;
  double size;
  s.n = chance(r, 30) ? 2 + unit_random_below(r, ELEMENTS - 1)
                      : 2 + unit_random_below(r, 3);
  families[unit_random_below(r, COUNT(families))](r, &s);
  spoil(r, &s);
  size = extent(s.p, s.n);
  pairs = s.n - 1;
  gate_set_numbers(c, PH_F_POINTS, s.p, s.n, 3);
  gate_set_numbers(c, PH_F_RULINGS, s.e, s.n, 3);
  gate_set_numbers(c, PH_F_TANGENTS, s.d, s.n, 3);
  if (s.n > 2 && chance(r, 4)) {
    gate_set_flag(c, PH_F_CLOSED, true);
    pairs = s.n;
  }
  if (chance(r, 2)) {
    circular(r, c, pairs, size);
  } else {
    general(r, c, pairs, &s);
  }
  anyway(r, c, &s, size);
  cone_options(r, c, size);
}

/* ---- meshes ---------------------------------------------------------------
 */

struct mesh {
  double p[GATE_NUMBERS], corner[GATE_NUMBERS];
  size_t points, faces, sizes[GATE_FACES];
};

static void face(struct mesh *m, size_t a, size_t b, size_t c, size_t d) {
  double *at = m->corner + 4 * m->faces;
  at[0] = (double)a;
  at[1] = (double)b;
  at[2] = (double)c;
  at[3] = (double)d;
  m->sizes[m->faces++] = 4;
}

/* rows x columns faces; of a tube the columns close, of a torus both. */
static void grid(struct unit_random *r, struct mesh *m) {
  size_t how = unit_random_below(r, 4);
  bool tube = how == 0, torus = how == 1;
  size_t rows = 1 + unit_random_below(r, 3), columns = rows;
  size_t high, wide;
  columns =
      tube || torus ? 3 + unit_random_below(r, 2) : 1 + unit_random_below(r, 3);
  rows = torus ? 3 : rows;
  high = torus ? rows : rows + 1;
  wide = tube || torus ? columns : columns + 1;
  for (size_t i = 0; i < high; i++) {
    for (size_t j = 0; j < wide; j++) {
      double u = TURN * (double)i / (double)high;
      double v = TURN * (double)j / (double)wide;
      double far = torus ? 2 + cos(u) : 1;
      put(m->p, m->points++,
          tube || torus
              ? ph_vec3_of(far * cos(v), far * sin(v), torus ? sin(u) : u)
              : ph_vec3_of((double)j, (double)i, unit_random_in(r, -0.5, 0.5)));
    }
  }
  for (size_t i = 0; i < rows; i++) {
    for (size_t j = 0; j < columns; j++) {
      size_t below = i * wide, above = (i + 1) % high * wide;
      size_t next = (j + 1) % wide;
      face(m, below + j, below + next, above + next, above + j);
    }
  }
}

/* k faces around a point. */
static void fan(struct unit_random *r, struct mesh *m) {
  size_t k = 3 + unit_random_below(r, 4);
  put(m->p, m->points++, ph_vec3_of(0, 0, unit_random_in(r, -1, 1)));
  for (size_t i = 0; i < 2 * k; i++) {
    double t = TURN * (double)i / (double)(2 * k);
    put(m->p, m->points++,
        ph_vec3_of(cos(t), sin(t), unit_random_in(r, -0.5, 0.5)));
  }
  for (size_t i = 0; i < k; i++) {
    face(m, 0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % (2 * k));
  }
}

static void cube(struct unit_random *r, struct mesh *m) {
  size_t without = unit_random_below(r, 3);
  for (size_t i = 0; i < 8; i++) {
    put(m->p, m->points++,
        ph_vec3_of(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  face(m, 0, 2, 3, 1);
  face(m, 4, 5, 7, 6);
  face(m, 0, 1, 5, 4);
  face(m, 2, 6, 7, 3);
  face(m, 0, 4, 6, 2);
  face(m, 1, 3, 7, 5);
  m->faces -= without;
}

/* Faces of 3 points, to be subdivided. */
static void triangles(struct unit_random *r, struct mesh *m) {
  static const double corner[] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  for (size_t i = 0; i < 4; i++) {
    put(m->p, m->points++, ph_vec3_of(i == 1, i == 2, i == 3));
  }
  memcpy(m->corner, corner, sizeof corner);
  m->faces = chance(r, 2) ? 4 : 3;
  for (size_t i = 0; i < m->faces; i++) {
    m->sizes[i] = 3;
  }
}

/* Points moved a little or much, or only so far that they are no more exact;
 * a face that looks to the other side; another scale. */
static void deform(struct unit_random *r, struct mesh *m) {
  bool rounded = chance(r, 3);
  double size = chance(r, 3)   ? 0
                : chance(r, 4) ? gate_power(r, -16, 1)
                               : gate_power(r, -1.5, -0.3);
  for (size_t i = 0; i < m->points; i++) {
    put(m->p, i, ph_vec3_add(get(m->p, i), any(r, size)));
  }
  for (size_t i = 0; i < 3 * m->points && rounded; i++) {
    m->p[i] = gate_decimals(m->p[i], 1);
  }
  if (chance(r, 20) && m->sizes[0] == 4) {
    double swap = m->corner[1];
    m->corner[1] = m->corner[3];
    m->corner[3] = swap;
  }
  gate_place(r, m->points, 3, m->p);
}

static void bubble_fields(struct unit_random *r, struct gate_case *c,
                          const struct mesh *m) {
  double v[GATE_NUMBERS];
  bool steps = m->sizes[0] == 3 || chance(r, 12), longer = chance(r, 2);
  if (chance(r, 4)) {
    gate_directions(r, m->p, m->points, 3, v);
    for (size_t i = 0; i < m->points && longer; i++) {
      put(v, i, ph_vec3_scale(gate_power(r, -3, 3), get(v, i)));
    }
    gate_set_numbers(c, PH_F_NORMALS, v, m->points, 3);
  }
  if (!chance(r, 3)) {
    gate_set_number(c, PH_F_CONTINUITY, (double)unit_random_below(r, 3));
  }
  if (chance(r, 3)) {
    gate_set_number(c, PH_F_DEGREE, (double)(1 + unit_random_below(r, 16)));
  } else if (chance(r, 3)) {
    gate_word(r, c, PH_F_DEGREE);
  }
  if (chance(r, 6)) {
    gate_set_number(c, PH_F_TOLERANCE, gate_power(r, -8, -1));
  }
  if (steps) {
    size_t most = m->faces < 5 ? 2 : 1;
    gate_set_number(c, PH_F_SUBDIVIDE,
                    (double)(1 + unit_random_below(r, most)));
    if (chance(r, 2)) {
      gate_word(r, c, PH_F_BOUNDARY);
    }
  }
}

void gate_bubble(struct unit_random *r, struct gate_case *c) {
  static void (*const families[])(struct unit_random *, struct mesh *) = {
      grid, grid, grid, fan, cube, triangles};
  struct mesh m = {.points = 0};
  families[unit_random_below(r, COUNT(families))](r, &m);
  deform(r, &m);
  gate_set_numbers(c, PH_F_POINTS, m.p, m.points, 3);
  gate_set_lists(c, PH_F_FACES, m.corner, m.sizes, m.faces);
  bubble_fields(r, c, &m);
  if (chance(r, 3)) {
    gate_add_number(c, "--sample=", (double)(1 + unit_random_below(r, 4)));
    if (chance(r, 3)) {
      add_offsets(r, c, extent(m.p, m.points));
    }
  }
  if (chance(r, 4)) {
    gate_add_option(c, "--edges");
  }
  if (chance(r, 20)) {
    gate_add_option(c, "--sweep=continuity=0,1,2");
    c->problem.field[PH_F_CONTINUITY].kind = PH_ABSENT;
  }
}
