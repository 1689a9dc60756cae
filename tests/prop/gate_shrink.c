/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Smaller cases that go wrong in the same way: fewer options, fields, points
 * and digits, as long as any of that can be had (see gate.h).
 */
#include "gate.h"

#include <time.h>

/* Runs, at most, and seconds of them: those of what is slow to solve would keep
 * a long run from going on. */
enum { RUNS = 4000, SECONDS = 10 };

struct shrink {
  struct gate_lab *lab;
  struct gate_case *c;
  struct gate_outcome *outcome;
  struct gate_case trial;
  size_t runs;
  clock_t start;
};

static bool is_over(const struct shrink *s) {
  return s->runs >= RUNS || clock() - s->start > SECONDS * CLOCKS_PER_SEC;
}

/* Whether the trial is wrong in the same way; then it takes the place. */
static bool accept(struct shrink *s) {
  struct gate_outcome outcome;
  if (is_over(s)) {
    return false;
  }
  s->runs++;
  gate_run(s->lab, &s->trial, GATE_CLOSELY, &outcome);
  gate_moved(s->lab, &s->trial, &outcome);
  if (outcome.fate != GATE_WRONG || strcmp(outcome.way, s->outcome->way) != 0) {
    return false;
  }
  gate_copy(s->c, &s->trial);
  *s->outcome = outcome;
  return true;
}

static bool without_options(struct shrink *s) {
  bool any = false;
  for (size_t i = s->c->options_n; i-- > 0;) {
    gate_copy(&s->trial, s->c);
    s->trial.options_n--;
    memmove(&s->trial.option[i], &s->trial.option[i + 1],
            (s->trial.options_n - i) * sizeof s->trial.option[0]);
    any = accept(s) || any;
  }
  for (size_t i = 0; i < s->c->options_n; i++) {
    for (size_t k = s->c->option[i].n; k-- > 0 && s->c->option[i].n > 1;) {
      struct gate_option *o = &s->trial.option[i];
      gate_copy(&s->trial, s->c);
      o->n--;
      memmove(&o->v[k], &o->v[k + 1], (o->n - k) * sizeof o->v[0]);
      any = accept(s) || any;
    }
  }
  return any;
}

static bool without_fields(struct shrink *s) {
  bool any = false;
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    if (s->c->set[i]) {
      gate_copy(&s->trial, s->c);
      s->trial.set[i] = false;
      any = accept(s) || any;
    }
    if (gate_has(s->c, (enum ph_field_id)i) && i != (size_t)gate_data(s->c)) {
      gate_copy(&s->trial, s->c);
      s->trial.problem.field[i].kind = PH_ABSENT;
      any = accept(s) || any;
    }
  }
  return any;
}

/* Takes one element out of every array that has one for each point, segment or
 * knot. */
static void take_out(struct gate_case *c, size_t at) {
  size_t n = c->problem.field[gate_data(c)].n;
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    struct ph_value *value = &c->problem.field[i];
    bool array = value->kind == PH_NUMBERS || value->kind == PH_VECTORS;
    bool ends = i == PH_F_END_DERIVATIVES || i == PH_F_END_TANGENTS ||
                i == PH_F_START || i == PH_F_CENTER;
    if (array && !ends && value->n + 1 >= n && value->n > 1) {
      size_t k = at < value->n ? at : value->n - 1, d = value->dimension;
      value->n--;
      memmove(value->v + d * k, value->v + d * (k + 1),
              d * (value->n - k) * sizeof *value->v);
    }
  }
}

/* Takes the last face out, and points behind those that are left. */
static bool without_faces(struct shrink *s) {
  bool any = false;
  while (s->c->problem.field[PH_F_FACES].sizes_n > 1) {
    struct ph_value *faces = &s->trial.problem.field[PH_F_FACES];
    size_t n = 0;
    gate_copy(&s->trial, s->c);
    faces->n -= faces->sizes[--faces->sizes_n];
    for (size_t i = 0; i < faces->n; i++) {
      size_t k = (size_t)faces->v[i] + 1;
      n = k > n ? k : n;
    }
    s->trial.problem.field[PH_F_POINTS].n = n;
    s->trial.problem.field[PH_F_NORMALS].n = n;
    if (!accept(s)) {
      break;
    }
    any = true;
  }
  return any;
}

static bool without_points(struct shrink *s) {
  bool any = false;
  if (gate_has(s->c, PH_F_FACES)) {
    return without_faces(s);
  }
  for (size_t k = s->c->problem.field[gate_data(s->c)].n; k-- > 0;) {
    gate_copy(&s->trial, s->c);
    if (k < s->trial.problem.field[gate_data(s->c)].n) {
      take_out(&s->trial, k);
      any = accept(s) || any;
    }
  }
  return any;
}

/* x with so many digits. */
static double rounded(double x, int digits) {
  char text[40];
  snprintf(text, sizeof text, "%.*e", digits - 1, x);
  return strtod(text, NULL);
}

/* The number with the fewest digits; at is where it is in the trial. */
static bool fewer_digits(struct shrink *s, double *at, const double *now) {
  double x = *now;
  for (int digits = 0; digits < 16; digits++) {
    double y = digits ? rounded(x, digits) : 0;
    if (fabs(y - x) <= 0) {
      return false;
    }
    gate_copy(&s->trial, s->c);
    *at = y;
    if (accept(s)) {
      return true;
    }
  }
  return false;
}

static bool simpler_numbers(struct shrink *s) {
  bool any = false;
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    struct ph_value *now = &s->c->problem.field[i];
    struct ph_value *trial = &s->trial.problem.field[i];
    size_t n = now->kind == PH_NUMBERS || now->kind == PH_VECTORS
                   ? now->n * now->dimension
                   : 0;
    for (size_t k = 0; k < n; k++) {
      any = fewer_digits(s, &s->trial.v[i][k], &now->v[k]) || any;
    }
    if (now->kind == PH_NUMBER) {
      any = fewer_digits(s, &trial->number, &now->number) || any;
    }
  }
  for (size_t i = 0; i < s->c->options_n; i++) {
    for (size_t k = 0; k < s->c->option[i].n; k++) {
      any = fewer_digits(s, &s->trial.option[i].v[k], &s->c->option[i].v[k]) ||
            any;
    }
  }
  return any;
}

void gate_shrink(struct gate_lab *lab, struct gate_case *c,
                 struct gate_outcome *outcome) {
  static _Thread_local struct shrink s;
  bool again = true;
  s.lab = lab;
  s.c = c;
  s.outcome = outcome;
  s.runs = 0;
  s.start = clock();
  while (again && !is_over(&s)) {
    again = without_options(&s);
    again = without_fields(&s) || again;
    again = without_points(&s) || again;
    again = simpler_numbers(&s) || again;
  }
}
