/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves and what is derived from them as JSON (see json_curve.h). */
#include "io/json_curve.h"

#include <math.h>

/* What was chosen for segment k; angles that do not exist are left out. */
static void write_choice(struct ph_json_writer *w, const struct ph_curve *c,
                         size_t k) {
  if (c->choice.tension) {
    ph_write_key_number(w, "tension", c->choice.tension[k]);
  }
  if (c->choice.angles && !isnan(c->choice.angles[2 * k])) {
    ph_write_key_numbers(w, "angles", c->choice.angles + 2 * k, 2);
  }
  if (c->choice.shape_ok) {
    ph_write_key_flag(w, "shape_ok", c->choice.shape_ok[k]);
  }
}

/* The pieces of the image of segment k, from piece i on.  ret the next piece */
static size_t write_blaschke(struct ph_json_writer *w, const struct ph_curve *c,
                             size_t k, size_t i) {
  ph_write_key(w, "blaschke");
  ph_write_begin(w, '[');
  for (; i < c->blaschke.n && c->blaschke.v[i].segment == k; i++) {
    const struct ph_blaschke *piece = &c->blaschke.v[i];
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_numbers(w, "interval", piece->interval, 2);
    ph_write_key_vectors(w, "control_points", piece->control_points[0], 6, 3);
    ph_write_key_numbers(w, "weights", piece->weights, 6);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
  return i;
}

void ph_write_segments(struct ph_json_writer *w, const struct ph_curve *c) {
  size_t stride = (c->degree + 1) * c->dimension;
  size_t preimage_stride = c->preimage.n * c->preimage.dimension;
  size_t blaschke = 0;
  ph_write_key(w, "segments");
  ph_write_begin(w, '[');
  for (size_t k = 0; k < c->n; k++) {
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_numbers(w, "interval", c->knots + k, 2);
    if (c->preimage.alpha) {
      ph_write_key_number(w, "alpha", c->preimage.alpha[k]);
    }
    ph_write_key_vectors(w, "control_points", c->control_points + k * stride,
                         c->degree + 1, c->dimension);
    if (c->preimage.v) {
      ph_write_key_vectors(w, "preimage", c->preimage.v + k * preimage_stride,
                           c->preimage.n, c->preimage.dimension);
    }
    ph_write_key_number(w, "length", c->lengths[k]);
    write_choice(w, c, k);
    if (c->blaschke.v) {
      blaschke = write_blaschke(w, c, k, blaschke);
    }
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

void ph_write_sphere(struct ph_json_writer *w, const struct ph_curve *c) {
  size_t nodes = c->closed ? c->n : c->n + 1;
  ph_write_key_numbers(w, "center", c->sphere.center, 3);
  ph_write_key_number(w, "radius", c->sphere.radius);
  ph_write_key_numbers(w, "tensions", c->sphere.tensions, nodes);
  ph_write_key(w, "indicators");
  ph_write_put(w, '[');
  for (size_t i = 0; i < nodes; i++) {
    if (i > 0) {
      ph_write_put(w, ',');
    }
    ph_write_number(w, c->sphere.indicators[i]);
  }
  ph_write_put(w, ']');
}

/* What every piece begins with: its segment and its part of it. */
static void begin_piece(struct ph_json_writer *w, size_t segment,
                        const double *interval) {
  ph_write_element(w);
  ph_write_begin(w, '{');
  ph_write_key_number(w, "segment", (double)segment);
  ph_write_key_numbers(w, "interval", interval, 2);
}

static void write_offset_piece(struct ph_json_writer *w,
                               const struct ph_offset *o, size_t i) {
  size_t n = o->degree + 1, dimension = o->dimension;
  if (o->weights) {
    ph_write_key_vectors(w, "control_points",
                         o->control_points + i * n * dimension, n, dimension);
    ph_write_key_numbers(w, "weights", o->weights + i * n, n);
  } else {
    ph_write_key_vectors(w, "numerator", o->numerator + i * n * dimension, n,
                         dimension);
    ph_write_key_numbers(w, "denominator", o->denominator + i * n, n);
  }
}

static void write_pieces(struct ph_json_writer *w,
                         const struct ph_pieces *pieces) {
  size_t stride = (pieces->degree + 1) * pieces->dimension;
  ph_write_key(w, "beziers");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < pieces->n; i++) {
    begin_piece(w, pieces->segment[i], pieces->interval + 2 * i);
    ph_write_key_vectors(w, "control_points",
                         pieces->control_points + i * stride,
                         pieces->degree + 1, pieces->dimension);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
  ph_write_key_number(w, "error", pieces->error);
}

static void write_place(struct ph_json_writer *w, size_t segment, double t) {
  ph_write_key_number(w, "segment", (double)segment);
  ph_write_key_number(w, "t", t);
}

static void write_finite(struct ph_json_writer *w, const char *name, double x) {
  if (isfinite(x)) {
    ph_write_key_number(w, name, x);
  }
}

void ph_write_samples(struct ph_json_writer *w, const struct ph_samples *s) {
  size_t d = s->dimension;
  ph_write_key(w, "samples");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < s->n; i++) {
    ph_write_element(w);
    ph_write_begin(w, '{');
    write_place(w, s->segment[i], s->t[i]);
    ph_write_key_number(w, "s", s->s[i]);
    ph_write_key_numbers(w, "point", s->point + d * i, d);
    if (isfinite(s->tangent[d * i])) {
      ph_write_key_numbers(w, "tangent", s->tangent + d * i, d);
    }
    write_finite(w, "curvature", s->curvature[i]);
    if (s->torsion) {
      write_finite(w, "torsion", s->torsion[i]);
    }
    if (s->lonlat) {
      ph_write_key_numbers(w, "lonlat", s->lonlat + 2 * i, 2);
    }
    if (s->normal && isfinite(s->normal[3 * i])) {
      ph_write_key_numbers(w, "normal", s->normal + 3 * i, 3);
      ph_write_key_numbers(w, "binormal", s->binormal + 3 * i, 3);
    }
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

static void write_cusps(struct ph_json_writer *w, const struct ph_offset *o) {
  ph_write_key(w, "cusps");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < o->cusps.n; i++) {
    ph_write_element(w);
    ph_write_begin(w, '{');
    write_place(w, o->cusps.at[i].segment, o->cusps.at[i].t);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

static void write_gaps(struct ph_json_writer *w, const struct ph_gaps *gaps) {
  ph_write_key(w, "gaps");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < gaps->n; i++) {
    ph_write_element(w);
    ph_write_number(w, (double)gaps->before[i]);
  }
  ph_write_end(w, ']');
}

static void write_offset_pieces(struct ph_json_writer *w,
                                const struct ph_offset *o) {
  ph_write_key_number(w, "degree", (double)o->degree);
  ph_write_key(w, "segments");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < o->n; i++) {
    begin_piece(w, o->segment[i], o->interval + 2 * i);
    write_offset_piece(w, o, i);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
  if (o->pieces.n) {
    write_pieces(w, &o->pieces);
  }
}

void ph_write_offsets(struct ph_json_writer *w, const struct ph_offset *offsets,
                      size_t n) {
  ph_write_key(w, "offsets");
  ph_write_begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    const struct ph_offset *o = &offsets[i];
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_number(w, "distance", o->distance);
    if (o->vector) {
      ph_write_key_string(w, "vector", o->vector);
    }
    if (o->n) {
      write_offset_pieces(w, o);
    }
    write_finite(w, "length", o->length);
    write_cusps(w, o);
    write_gaps(w, &o->gaps);
    if (o->samples.n) {
      ph_write_samples(w, &o->samples);
    }
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}
