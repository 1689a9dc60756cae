/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The JSON writer and the two shapes of record (see json_out.h).
 *
 * The writer keeps one bit of state for each level, whether a comma is due.
 * Numbers and vectors of numbers stay on one line even when indented.
 */
#include "io/json_out.h"

#include "io/json_text.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

enum { DEPTH_MAX = 16 };

struct writer {
  struct ph_buf *buf;
  bool pretty;
  size_t depth;
  bool comma[DEPTH_MAX];
};

static void put(struct writer *w, char c) {
  char *to = ph_buf_reserve(w->buf, 1);
  if (to) {
    *to = c;
    w->buf->n++;
  }
}

static void new_line(struct writer *w) {
  if (w->pretty) {
    put(w, '\n');
    for (size_t i = 0; i < w->depth; i++) {
      ph_buf_put(w->buf, "  ", 2);
    }
  }
}

/* Before an element of an array or the key of an object. */
static void element(struct writer *w) {
  if (w->comma[w->depth]) {
    put(w, ',');
  }
  w->comma[w->depth] = true;
  if (w->depth > 0) {
    new_line(w);
  }
}

static void begin(struct writer *w, char bracket) {
  put(w, bracket);
  w->depth++;
  w->comma[w->depth] = false;
}

static void end(struct writer *w, char bracket) {
  bool empty = !w->comma[w->depth];
  w->depth--;
  if (!empty) {
    new_line(w);
  }
  put(w, bracket);
}

static void string(struct writer *w, const char *text) {
  size_t n = strlen(text);
  char *to = ph_buf_reserve(w->buf, PH_JSON_QUOTED_MAX(n));
  if (to) {
    w->buf->n += ph_json_quote(to, text, n);
  }
}

/* Names of members are ours: nothing in them needs an escape. */
static void key(struct writer *w, const char *name) {
  size_t n = strlen(name);
  char *to;
  element(w);
  to = ph_buf_reserve(w->buf, n + 4);
  if (to) {
    *to++ = '"';
    memcpy(to, name, n);
    memcpy(to + n, "\": ", 3);
    w->buf->n += n + (w->pretty ? 4 : 3);
  }
}

static void number(struct writer *w, double x) {
  char *to = ph_buf_reserve(w->buf, PH_NUMBER_MAX);
  if (to) {
    w->buf->n += ph_number_write(to, x);
  }
}

/* [a,b,c] in one piece; the bulk of all output passes through here. */
static void numbers(struct writer *w, const double *v, size_t n) {
  char *to = ph_buf_reserve(w->buf, n * (PH_NUMBER_MAX + 1) + 2);
  char *start = to;
  if (!to) {
    return;
  }
  *to++ = '[';
  for (size_t i = 0; i < n; i++) {
    if (i > 0) {
      *to++ = ',';
    }
    to += ph_number_write(to, v[i]);
  }
  *to++ = ']';
  w->buf->n += (size_t)(to - start);
}

/* [[a,b],[c,d]] */
static void vectors(struct writer *w, const double *v, size_t n,
                    size_t dimension) {
  begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    element(w);
    numbers(w, v + i * dimension, dimension);
  }
  end(w, ']');
}

static void key_string(struct writer *w, const char *name, const char *text) {
  key(w, name);
  string(w, text);
}

static void key_number(struct writer *w, const char *name, double x) {
  key(w, name);
  number(w, x);
}

static void key_raw(struct writer *w, const char *name, const char *json,
                    size_t n) {
  if (json) {
    key(w, name);
    ph_buf_put(w->buf, json, n);
  }
}

static void write_heading(struct writer *w, const struct ph_heading *heading,
                          const char *status) {
  const struct ph_echo *echo = heading->echo;
  key_raw(w, "id", echo->id, echo->id_n);
  key_string(w, "command", heading->command);
  key_string(w, "status", status);
  key_raw(w, "meta", echo->meta, echo->meta_n);
  if (heading->swept_n) {
    key(w, "sweep");
    begin(w, '{');
    for (size_t i = 0; i < heading->swept_n; i++) {
      const struct ph_swept *swept = &heading->swept[i];
      key_raw(w, swept->name, swept->value, strlen(swept->value));
    }
    end(w, '}');
  }
}

static void key_flag(struct writer *w, const char *name, bool flag) {
  key(w, name);
  ph_buf_puts(w->buf, flag ? "true" : "false");
}

/* What was chosen for segment k; angles that do not exist are left out. */
static void write_choice(struct writer *w, const struct ph_curve *c, size_t k) {
  if (c->tension) {
    key_number(w, "tension", c->tension[k]);
  }
  if (c->angles && !isnan(c->angles[2 * k])) {
    key(w, "angles");
    numbers(w, c->angles + 2 * k, 2);
  }
  if (c->shape_ok) {
    key_flag(w, "shape_ok", c->shape_ok[k]);
  }
}

static void write_segments(struct writer *w, const struct ph_curve *c) {
  size_t stride = (c->degree + 1) * c->dimension;
  size_t preimage_stride = c->preimage_n * c->preimage_dimension;
  key(w, "segments");
  begin(w, '[');
  for (size_t k = 0; k < c->n; k++) {
    element(w);
    begin(w, '{');
    key(w, "interval");
    numbers(w, c->knots + k, 2);
    if (c->alpha) {
      key_number(w, "alpha", c->alpha[k]);
    }
    key(w, "control_points");
    vectors(w, c->control_points + k * stride, c->degree + 1, c->dimension);
    if (c->preimage) {
      key(w, "preimage");
      vectors(w, c->preimage + k * preimage_stride, c->preimage_n,
              c->preimage_dimension);
    }
    key_number(w, "length", c->lengths[k]);
    write_choice(w, c, k);
    end(w, '}');
  }
  end(w, ']');
}

/* Where an interval of the data lies among the segments. */
static void write_intervals(struct writer *w, const struct ph_result *result) {
  key(w, "intervals");
  begin(w, '[');
  for (size_t i = 0; i < result->intervals_n; i++) {
    const struct ph_interval *interval = &result->intervals[i];
    const double segments[] = {(double)interval->first, (double)interval->last};
    element(w);
    begin(w, '{');
    key_number(w, "length", interval->length);
    if (!isnan(interval->natural_length)) {
      key_number(w, "natural_length", interval->natural_length);
    }
    key(w, "segments");
    numbers(w, segments, 2);
    end(w, '}');
  }
  end(w, ']');
}

/* What every piece begins with: its segment and its part of it. */
static void begin_piece(struct writer *w, size_t segment,
                        const double *interval) {
  element(w);
  begin(w, '{');
  key_number(w, "segment", (double)segment);
  key(w, "interval");
  numbers(w, interval, 2);
}

static void write_offset_piece(struct writer *w, const struct ph_offset *o,
                               size_t i) {
  size_t n = o->degree + 1, dimension = o->dimension;
  if (o->weights) {
    key(w, "control_points");
    vectors(w, o->control_points + i * n * dimension, n, dimension);
    key(w, "weights");
    numbers(w, o->weights + i * n, n);
  } else {
    key(w, "numerator");
    vectors(w, o->numerator + i * n * dimension, n, dimension);
    key(w, "denominator");
    numbers(w, o->denominator + i * n, n);
  }
}

static void write_pieces(struct writer *w, const struct ph_pieces *pieces) {
  size_t stride = (pieces->degree + 1) * pieces->dimension;
  key(w, "beziers");
  begin(w, '[');
  for (size_t i = 0; i < pieces->n; i++) {
    begin_piece(w, pieces->segment[i], pieces->interval + 2 * i);
    key(w, "control_points");
    vectors(w, pieces->control_points + i * stride, pieces->degree + 1,
            pieces->dimension);
    end(w, '}');
  }
  end(w, ']');
  key_number(w, "error", pieces->error);
}

static void write_offset(struct writer *w, const struct ph_offset *o) {
  begin(w, '{');
  key_number(w, "distance", o->distance);
  if (o->vector) {
    key_string(w, "vector", o->vector);
  }
  key_number(w, "degree", (double)o->degree);
  key(w, "segments");
  begin(w, '[');
  for (size_t i = 0; i < o->n; i++) {
    begin_piece(w, o->segment[i], o->interval + 2 * i);
    write_offset_piece(w, o, i);
    end(w, '}');
  }
  end(w, ']');
  if (o->pieces.n) {
    write_pieces(w, &o->pieces);
  }
  end(w, '}');
}

static void write_diagnostics(struct writer *w,
                              const struct ph_diagnostics *diagnostics) {
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    enum ph_diagnostic which = (enum ph_diagnostic)i;
    double value = diagnostics->value[i];
    if (diagnostics->known >> i & 1) {
      if (ph_diagnostic_is_flag(which)) {
        key_flag(w, ph_diagnostic_name(which), value > 0);
      } else if (ph_diagnostic_is_outcome(which)) {
        key_string(w, ph_diagnostic_name(which),
                   ph_outcome_name((enum ph_outcome)value));
      } else {
        key_number(w, ph_diagnostic_name(which), value);
      }
    }
  }
}

/* {"b":...}: numbers that are not finite are left out. */
static void write_kantorovich(struct writer *w,
                              const struct ph_kantorovich *k) {
  const struct {
    const char *name;
    double value;
  } numbers_of[] = {{"B", k->b},
                    {"C", k->c},
                    {"K", k->k},
                    {"h", k->h},
                    {"radius", k->radius}};
  key(w, "kantorovich");
  begin(w, '{');
  for (size_t i = 0; i < sizeof numbers_of / sizeof numbers_of[0]; i++) {
    if (isfinite(numbers_of[i].value)) {
      key_number(w, numbers_of[i].name, numbers_of[i].value);
    }
  }
  key_flag(w, "certified", k->certified);
  end(w, '}');
}

/* The lengths of the curve with free lengths, if it is known everywhere. */
static void write_natural_lengths(struct writer *w,
                                  const struct ph_result *result) {
  for (size_t i = 0; i < result->intervals_n; i++) {
    if (isnan(result->intervals[i].natural_length)) {
      return;
    }
  }
  key(w, "natural_lengths");
  put(w, '[');
  for (size_t i = 0; i < result->intervals_n; i++) {
    if (i > 0) {
      put(w, ',');
    }
    number(w, result->intervals[i].natural_length);
  }
  put(w, ']');
}

/* The starts that were tried, after the name of the one that won. */
static void write_starts(struct writer *w, const struct ph_result *result) {
  key_string(w, "start", result->starts[result->start].name);
  key(w, "starts");
  begin(w, '[');
  for (size_t i = 0; i < result->starts_n; i++) {
    const struct ph_start *start = &result->starts[i];
    element(w);
    begin(w, '{');
    key_string(w, "start", start->name);
    key_string(w, "outcome", ph_outcome_name(start->outcome));
    if (!isnan(start->f)) {
      key_number(w, "F", start->f);
    }
    key_number(w, "iterations", (double)start->iterations);
    end(w, '}');
  }
  end(w, ']');
}

/* The certificate of the curve, and how it was found. */
static void write_certificate(struct writer *w,
                              const struct ph_result *result) {
  key(w, "diagnostics");
  begin(w, '{');
  write_diagnostics(w, &result->diagnostics);
  if (result->intervals_n) {
    write_natural_lengths(w, result);
  }
  if (result->starts_n) {
    write_starts(w, result);
  }
  if (result->has_kantorovich) {
    write_kantorovich(w, &result->kantorovich);
  }
  end(w, '}');
}

static void write_solutions(struct writer *w, const struct ph_result *result) {
  key(w, "solutions");
  begin(w, '[');
  for (size_t i = 0; i < result->solutions_n; i++) {
    const struct ph_solution *solution = &result->solutions[i];
    element(w);
    begin(w, '{');
    key_flag(w, "good", solution->good);
    write_segments(w, &solution->curve);
    key_number(w, "length", solution->curve.length);
    key(w, "diagnostics");
    begin(w, '{');
    write_diagnostics(w, &solution->diagnostics);
    end(w, '}');
    end(w, '}');
  }
  end(w, ']');
}

static void write_warnings(struct writer *w, const struct ph_result *result) {
  key(w, "warnings");
  begin(w, '[');
  for (size_t i = 0; i < result->warnings_n; i++) {
    const struct ph_warning *warning = &result->warnings[i];
    element(w);
    begin(w, '{');
    key_string(w, "code", ph_status_code(warning->diag.status));
    if (warning->segment != PH_NO_SEGMENT) {
      key_number(w, "segment", (double)warning->segment);
    }
    key_string(w, "message", warning->diag.message);
    end(w, '}');
  }
  end(w, ']');
}

static void finish(struct writer *w) {
  end(w, '}');
  put(w, '\n');
}

void ph_json_result(struct ph_buf *buf, const struct ph_heading *heading,
                    const struct ph_result *result, bool pretty) {
  struct writer w = {.buf = buf, .pretty = pretty};
  const struct ph_curve *curve = &result->curve;
  begin(&w, '{');
  write_heading(&w, heading, "ok");
  key_string(&w, "curve", ph_curve_name(curve->kind));
  key_number(&w, "dimension", (double)curve->dimension);
  key_number(&w, "degree", (double)curve->degree);
  key_flag(&w, "closed", curve->closed);
  write_segments(&w, curve);
  if (result->intervals_n) {
    write_intervals(&w, result);
  }
  key_number(&w, "length", curve->length);
  if (result->offsets_n) {
    key(&w, "offsets");
    begin(&w, '[');
    for (size_t i = 0; i < result->offsets_n; i++) {
      element(&w);
      write_offset(&w, &result->offsets[i]);
    }
    end(&w, ']');
  }
  write_certificate(&w, result);
  if (result->solutions_n) {
    write_solutions(&w, result);
  }
  if (result->warnings_n) {
    write_warnings(&w, result);
  }
  finish(&w);
}

void ph_json_error(struct ph_buf *buf, const struct ph_heading *heading,
                   const struct ph_diag *diag, const char *file, bool pretty) {
  struct writer w = {.buf = buf, .pretty = pretty};
  char sentence[PH_DIAG_FIELD_MAX + PH_DIAG_MESSAGE_MAX];
  ph_diag_sentence(diag, sentence, sizeof sentence);
  begin(&w, '{');
  write_heading(&w, heading, "error");
  key(&w, "error");
  begin(&w, '{');
  key_string(&w, "code", ph_status_code(diag->status));
  key_string(&w, "message", sentence);
  if (diag->field[0]) {
    key_string(&w, "field", diag->field);
  }
  if (file) {
    key_string(&w, "file", file);
  }
  if (diag->line) {
    key_number(&w, "line", (double)diag->line);
  }
  if (diag->column) {
    key_number(&w, "column", (double)diag->column);
  }
  end(&w, '}');
  finish(&w);
}
