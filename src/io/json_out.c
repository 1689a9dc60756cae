/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two shapes of record (see json_out.h). */
#include "io/json_out.h"

#include "curve/kind/kind.h"

#include "io/json_curve.h"
#include "io/json_write.h"

#include <math.h>
#include <string.h>

/* {"FIELD":VALUE,...}, unless it is empty. */
static void write_fields(struct ph_json_writer *w, const char *name,
                         const struct ph_swept *fields, size_t n) {
  if (n == 0) {
    return;
  }
  ph_write_key(w, name);
  ph_write_begin(w, '{');
  for (size_t i = 0; i < n; i++) {
    ph_write_key_raw(w, fields[i].name, fields[i].value,
                     strlen(fields[i].value));
  }
  ph_write_end(w, '}');
}

void ph_json_heading(struct ph_json_writer *w, const struct ph_heading *heading,
                     const char *status) {
  const struct ph_echo *echo = heading->echo;
  ph_write_key_raw(w, "id", echo->id, echo->id_n);
  ph_write_key_string(w, "command", heading->command);
  ph_write_key_string(w, "status", status);
  ph_write_key_raw(w, "meta", echo->meta, echo->meta_n);
  write_fields(w, "sweep", heading->swept, heading->swept_n);
  write_fields(w, "set", heading->set, heading->set_n);
}

/* What is not known is left out. */
static void write_known(struct ph_json_writer *w, const char *name, double x) {
  if (!isnan(x)) {
    ph_write_key_number(w, name, x);
  }
}

/* Where an interval of the data lies among the segments, and what was found for
 * it. */
static void write_intervals(struct ph_json_writer *w,
                            const struct ph_interval *intervals, size_t n) {
  ph_write_key(w, "intervals");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    const struct ph_interval *interval = &intervals[i];
    const double segments[] = {(double)interval->first, (double)interval->last};
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_number(w, "length", interval->length);
    write_known(w, "natural_length", interval->natural_length);
    ph_write_key_numbers(w, "segments", segments, 2);
    if (interval->root != PH_ROOT_N) {
      ph_write_key_string(w, "root", ph_root_name(interval->root));
    }
    write_known(w, "D", interval->ratio);
    write_known(w, "lambda", interval->lambda);
    write_known(w, "joint_angle", interval->joint_angle);
    write_known(w, "joint_position", interval->joint_position);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

static void write_diagnostics(struct ph_json_writer *w,
                              const struct ph_diagnostics *diagnostics) {
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    enum ph_diagnostic which = (enum ph_diagnostic)i;
    const char *name = ph_diagnostic_name(which);
    const char *type = ph_diagnostic_type(which);
    const char *const *words = ph_words(type);
    double value = diagnostics->value[i];
    if (!(diagnostics->known >> i & 1)) {
      continue;
    }
    if (words) {
      ph_write_key_string(w, name, words[(size_t)value]);
    } else if (strcmp(type, "flag") == 0) {
      ph_write_key_flag(w, name, value > 0);
    } else {
      ph_write_key_number(w, name, value);
    }
  }
}

/* {"b":...}: numbers that are not finite are left out. */
static void write_kantorovich(struct ph_json_writer *w,
                              const struct ph_kantorovich *k) {
  const struct {
    const char *name;
    double value;
  } numbers_of[] = {{"B", k->b},
                    {"C", k->c},
                    {"K", k->k},
                    {"h", k->h},
                    {"radius", k->radius}};
  ph_write_key(w, "kantorovich");
  ph_write_begin(w, '{');
  for (size_t i = 0; i < sizeof numbers_of / sizeof numbers_of[0]; i++) {
    if (isfinite(numbers_of[i].value)) {
      ph_write_key_number(w, numbers_of[i].name, numbers_of[i].value);
    }
  }
  ph_write_key_flag(w, "certified", k->certified);
  ph_write_end(w, '}');
}

/* The lengths of the curve with free lengths, if it is known everywhere. */
static void write_natural_lengths(struct ph_json_writer *w,
                                  const struct ph_result *result) {
  for (size_t i = 0; i < result->intervals_n; i++) {
    if (isnan(result->intervals[i].natural_length)) {
      return;
    }
  }
  ph_write_key(w, "natural_lengths");
  ph_write_put(w, '[');
  for (size_t i = 0; i < result->intervals_n; i++) {
    if (i > 0) {
      ph_write_put(w, ',');
    }
    ph_write_number(w, result->intervals[i].natural_length);
  }
  ph_write_put(w, ']');
}

/* The starts that were tried, after the name of the one that won. */
static void write_starts(struct ph_json_writer *w,
                         const struct ph_result *result) {
  ph_write_key_string(w, "start", result->starts[result->start].name);
  ph_write_key(w, "starts");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < result->starts_n; i++) {
    const struct ph_start *start = &result->starts[i];
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_string(w, "start", start->name);
    ph_write_key_string(w, "outcome", ph_outcome_name(start->outcome));
    write_known(w, "F", start->f);
    ph_write_key_number(w, "iterations", (double)start->iterations);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

/* The certificate of the curve, and how it was found. */
static void write_certificate(struct ph_json_writer *w,
                              const struct ph_result *result) {
  ph_write_key(w, "diagnostics");
  ph_write_begin(w, '{');
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
  ph_write_end(w, '}');
}

static void write_solutions(struct ph_json_writer *w,
                            const struct ph_result *result) {
  ph_write_key(w, "solutions");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < result->solutions_n; i++) {
    const struct ph_solution *solution = &result->solutions[i];
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_flag(w, "good", solution->good);
    ph_write_segments(w, &solution->curve);
    if (solution->intervals) {
      write_intervals(w, solution->intervals, result->intervals_n);
    }
    ph_write_key_number(w, "length", solution->curve.length);
    ph_write_key(w, "diagnostics");
    ph_write_begin(w, '{');
    write_diagnostics(w, &solution->diagnostics);
    ph_write_end(w, '}');
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

static void write_warnings(struct ph_json_writer *w,
                           const struct ph_result *result) {
  ph_write_key(w, "warnings");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < result->warnings_n; i++) {
    const struct ph_warning *warning = &result->warnings[i];
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_string(w, "code", ph_status_code(warning->diag.status));
    if (warning->segment != PH_NO_SEGMENT) {
      ph_write_key_number(w, "segment", (double)warning->segment);
    }
    ph_write_key_string(w, "message", warning->diag.message);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

static void finish(struct ph_json_writer *w) {
  ph_write_end(w, '}');
  ph_write_put(w, '\n');
}

void ph_json_result(struct ph_buf *buf, const struct ph_heading *heading,
                    const struct ph_result *result, bool pretty) {
  struct ph_json_writer w = {.buf = buf, .pretty = pretty};
  const struct ph_curve *curve = &result->curve;
  ph_write_begin(&w, '{');
  ph_json_heading(&w, heading, "ok");
  ph_write_key_string(&w, "curve", ph_curve_name(curve->kind));
  ph_write_key_number(&w, "dimension", (double)curve->dimension);
  ph_write_key_number(&w, "degree", (double)curve->degree);
  ph_write_key_flag(&w, "closed", curve->closed);
  ph_write_segments(&w, curve);
  if (ph_kind_of(curve)->on_sphere) {
    ph_write_sphere(&w, curve);
  }
  if (result->intervals_n) {
    write_intervals(&w, result->intervals, result->intervals_n);
  }
  ph_write_key_number(&w, "length", curve->length);
  if (result->offsets_n) {
    ph_write_offsets(&w, result->offsets, result->offsets_n);
  }
  if (result->samples.frame) {
    ph_write_key_string(&w, "frame", ph_frame_name(result->samples.frame));
  }
  if (result->samples.n) {
    ph_write_samples(&w, &result->samples);
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

void ph_json_failure(struct ph_json_writer *w, const struct ph_diag *diag,
                     const char *file) {
  char sentence[PH_DIAG_FIELD_MAX + PH_DIAG_MESSAGE_MAX];
  ph_diag_sentence(diag, sentence, sizeof sentence);
  ph_write_key(w, "error");
  ph_write_begin(w, '{');
  ph_write_key_string(w, "code", ph_status_code(diag->status));
  ph_write_key_string(w, "message", sentence);
  if (diag->field[0]) {
    ph_write_key_string(w, "field", diag->field);
  }
  if (file) {
    ph_write_key_string(w, "file", file);
  }
  if (diag->line) {
    ph_write_key_number(w, "line", (double)diag->line);
  }
  if (diag->column) {
    ph_write_key_number(w, "column", (double)diag->column);
  }
  ph_write_end(w, '}');
}

void ph_json_error(struct ph_buf *buf, const struct ph_heading *heading,
                   const struct ph_diag *diag, const char *file, bool pretty) {
  struct ph_json_writer w = {.buf = buf, .pretty = pretty};
  ph_write_begin(&w, '{');
  ph_json_heading(&w, heading, "error");
  ph_json_failure(&w, diag, file);
  finish(&w);
}
