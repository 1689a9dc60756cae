/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SVG path data (see svg_path.h). */
#include "io/svg_path.h"

#include "base/suggest.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

/* ---- what is drawn ------------------------------------------------------ */

/* Of the curves that stand for arcs. */
enum { DEGREE = 15, ORDER = 7 };

enum { POINTS = 64, PIECES = 16, PARTS = 4 };

static void add_point(struct ph_trace *t, const double p[2]) {
  const double *a = t->affine;
  t->v =
      ph_arena_grow(t->arena, t->v, t->n, 2 * sizeof *t->v, POINTS, &t->room);
  if (!t->v) {
    t->failed = true;
    return;
  }
  t->v[2 * t->n] = a[0] * p[0] + a[2] * p[1] + a[4];
  t->v[2 * t->n + 1] = a[1] * p[0] + a[3] * p[1] + a[5];
  t->n++;
}

static void begin_part(struct ph_trace *t) {
  if (t->drawing || t->failed) {
    return;
  }
  t->part = ph_arena_grow(t->arena, t->part, t->parts_n, sizeof *t->part, PARTS,
                          &t->parts_room);
  if (!t->part) {
    t->failed = true;
    return;
  }
  t->part[t->parts_n++] = (struct ph_trace_part){t->pieces_n, t->n, false};
  t->drawing = true;
}

static bool same(const double *a, const double *b) {
  return !(a[0] < b[0]) && !(a[0] > b[0]) && !(a[1] < b[1]) && !(a[1] > b[1]);
}

/* p[degree][2]: the control points behind the pen. */
static void trace_bezier(struct ph_trace *t, const double *p, size_t degree) {
  bool point = true;
  for (size_t i = 0; i < degree; i++) {
    point = point && same(p + 2 * i, t->at);
  }
  if (point) {
    return;
  }
  begin_part(t);
  if (t->failed) {
    return;
  }
  t->sizes = ph_arena_grow(t->arena, t->sizes, t->pieces_n, sizeof *t->sizes,
                           PIECES, &t->sizes_room);
  if (!t->sizes) {
    t->failed = true;
    return;
  }
  t->sizes[t->pieces_n++] = degree + 1;
  add_point(t, t->at);
  for (size_t i = 0; i < degree && !t->failed; i++) {
    add_point(t, p + 2 * i);
  }
  memcpy(t->at, p + 2 * (degree - 1), sizeof t->at);
}

void ph_trace_move(struct ph_trace *t, double x, double y) {
  t->at[0] = t->start[0] = x;
  t->at[1] = t->start[1] = y;
  t->drawing = false;
}

void ph_trace_line(struct ph_trace *t, double x, double y) {
  const double p[2] = {x, y};
  trace_bezier(t, p, 1);
}

void ph_trace_close(struct ph_trace *t) {
  ph_trace_line(t, t->start[0], t->start[1]);
  if (t->drawing && t->parts_n > 0) {
    t->part[t->parts_n - 1].closed = true;
  }
  t->drawing = false;
}

/* ---- arcs ---------------------------------------------------------------- */

/* Coefficient k, from the end at angle `at`, of the curve of the unit circle
 * whose angle goes by h from there: sum of C(k,j) (m - j)!/m! f^(j). */
static void coefficient(double at, double h, size_t k, double b[2]) {
  double factor = 1; /* C(k,j) (m - j)!/m! h^j */
  b[0] = b[1] = 0;
  for (size_t j = 0; j <= k; j++) {
    /* the j-th derivative of (cos, sin) is it, turned by j right angles */
    const double c = cos(at), s = sin(at);
    const double turned[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
    b[0] += factor * turned[j % 4][0];
    b[1] += factor * turned[j % 4][1];
    factor *= h * (double)(k - j) / ((double)(j + 1) * (double)(DEGREE - j));
  }
}

/* An ellipse as the image of the unit circle. */
struct ellipse {
  double center[2], x[2], y[2];
};

static void put(const struct ellipse *e, const double b[2], double *p) {
  for (size_t k = 0; k < 2; k++) {
    p[k] = e->center[k] + b[0] * e->x[k] + b[1] * e->y[k];
  }
}

/* The arc by the angle `turn` from `from`, which ends at `to`. */
static void add_arc(struct ph_trace *t, const struct ellipse *e, double from,
                    double turn, const double to[2]) {
  const double quarters = fabs(turn) / acos(0);
  const size_t n = quarters > 1 ? (size_t)ceil(quarters - 1e-9) : 1;
  const double h = turn / (double)n;
  for (size_t i = 0; i < n && !t->failed; i++) {
    const double begin = from + (double)i * h, end = from + (double)(i + 1) * h;
    double p[DEGREE][2], b[2];
    for (size_t k = 1; k <= ORDER; k++) {
      coefficient(begin, h, k, b);
      put(e, b, p[k - 1]);
    }
    for (size_t k = 0; k <= ORDER; k++) {
      coefficient(end, -h, k, b);
      put(e, b, p[DEGREE - k - 1]);
    }
    if (i + 1 == n) {
      memcpy(p[DEGREE - 1], to, sizeof p[0]);
    }
    trace_bezier(t, p[0], DEGREE);
  }
}

/* By SVG 1.1, appendix F.6.5. */
void ph_trace_arc(struct ph_trace *t, const double radii[2], double rotation,
                  bool large, bool sweep, double x, double y) {
  const double to[2] = {x, y}, pi = acos(-1);
  const double c = cos(rotation * (pi / 180)), s = sin(rotation * (pi / 180));
  double rx = fabs(radii[0]), ry = fabs(radii[1]);
  const double dx = (t->at[0] - x) / 2, dy = (t->at[1] - y) / 2;
  const double px = c * dx + s * dy, py = c * dy - s * dx;
  double reach, w, cx, cy, from, turn;
  struct ellipse e;
  if (same(to, t->at)) {
    return;
  }
  if (!(rx > 0 && ry > 0)) {
    ph_trace_line(t, x, y);
    return;
  }
  reach = hypot(px / rx, py / ry);
  if (reach > 1) {
    rx *= reach;
    ry *= reach;
    reach = 1;
  }
  w = sqrt((1 - reach) * (1 + reach)) / reach * (large == sweep ? -1 : 1);
  cx = w * rx * (py / ry);
  cy = -w * ry * (px / rx);
  from = atan2((py - cy) / ry, (px - cx) / rx);
  turn = atan2((-py - cy) / ry, (-px - cx) / rx) - from;
  turn += sweep && turn < 0 ? 2 * pi : !sweep && turn > 0 ? -2 * pi : 0;
  e = (struct ellipse){{c * cx - s * cy + (t->at[0] + x) / 2,
                        s * cx + c * cy + (t->at[1] + y) / 2},
                       {rx * c, rx * s},
                       {-ry * s, ry * c}};
  add_arc(t, &e, from, turn, to);
}

/* ---- path data ------------------------------------------------------------
 */

/* Path data that are read. */
struct reader {
  struct ph_trace *trace;
  const char *text, *p, *end;
  const char *field;
  struct ph_diag *diag;
  char last;         /* command, in capitals */
  double control[2]; /* the last control point of the piece before, for S, T */
};

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

/* Skips blanks, and with them a comma. */
static void skip(struct reader *r, bool comma) {
  while (r->p < r->end && (is_blank(*r->p) || (comma && *r->p == ','))) {
    comma = comma && *r->p != ',';
    r->p++;
  }
}

static enum ph_status unexpected(struct reader *r, const char *wanted) {
  char excerpt[PH_EXCERPT_MAX];
  const size_t at = (size_t)(r->p - r->text) + 1;
  if (r->p >= r->end) {
    return ph_fail(r->diag, PH_E_SYNTAX, r->field,
                   "ends where %s is due in the path", wanted);
  }
  return ph_fail(
      r->diag, PH_E_SYNTAX, r->field,
      "has \"%s\" at character %zu, where %s is due in the path",
      ph_excerpt(r->p,
                 (size_t)(r->end - r->p) < 8 ? (size_t)(r->end - r->p) : 8,
                 excerpt),
      at, wanted);
}

/* Arguments of a command, [n]; those of which bit i is set are flags. */
static enum ph_status read_numbers(struct reader *r, size_t n, unsigned flags,
                                   double *x) {
  for (size_t i = 0; i < n; i++) {
    const char *after;
    skip(r, i > 0);
    if (flags >> i & 1) {
      if (r->p >= r->end || (*r->p != '0' && *r->p != '1')) {
        return unexpected(r, "0 or 1");
      }
      x[i] = *r->p++ - '0';
      continue;
    }
    after = ph_number_read_text(r->p, r->end, &x[i]);
    if (!after) {
      return unexpected(r, "a number");
    }
    if (!isfinite(x[i])) {
      return ph_fail(r->diag, PH_E_NOT_FINITE, r->field,
                     "has a number at character %zu that overflows a double",
                     (size_t)(r->p - r->text) + 1);
    }
    r->p = after;
  }
  return PH_OK;
}

/* Draws one command with its arguments, which are absolute. */
static void draw(struct reader *r, char command, double *x) {
  struct ph_trace *t = r->trace;
  const bool cubic = r->last == 'C' || r->last == 'S';
  const bool quadratic = r->last == 'Q' || r->last == 'T';
  double p[6];
  memcpy(p, t->at, sizeof t->at); /* of S and T: the reflected point */
  if ((command == 'S' && cubic) || (command == 'T' && quadratic)) {
    p[0] = 2 * t->at[0] - r->control[0];
    p[1] = 2 * t->at[1] - r->control[1];
  }
  switch (command) {
  case 'M':
    ph_trace_move(t, x[0], x[1]);
    break;
  case 'L':
    ph_trace_line(t, x[0], x[1]);
    break;
  case 'C':
    memcpy(r->control, x + 2, sizeof r->control);
    trace_bezier(t, x, 3);
    break;
  case 'S':
    memcpy(p + 2, x, 4 * sizeof *x);
    memcpy(r->control, x, sizeof r->control);
    trace_bezier(t, p, 3);
    break;
  case 'Q':
    memcpy(r->control, x, sizeof r->control);
    trace_bezier(t, x, 2);
    break;
  case 'T':
    memcpy(p + 2, x, 2 * sizeof *x);
    memcpy(r->control, p, sizeof r->control);
    trace_bezier(t, p, 2);
    break;
  default:
    ph_trace_arc(t, x, x[2], x[3] > 0, x[4] > 0, x[5], x[6]);
  }
  r->last = command;
}

/* What commands take: how many numbers, which are flags, and from which on
 * they are coordinates. */
static const struct form {
  char command;
  unsigned char n, flags, points;
} forms[] = {{'M', 2, 0, 0}, {'L', 2, 0, 0}, {'H', 1, 0, 0},
             {'V', 1, 0, 0}, {'C', 6, 0, 0}, {'S', 4, 0, 0},
             {'Q', 4, 0, 0}, {'T', 2, 0, 0}, {'A', 7, 3 << 3, 5}};

/* One set of arguments of a command. */
static enum ph_status read_set(struct reader *r, const struct form *form,
                               bool relative) {
  const double *at = r->trace->at;
  double x[7];
  enum ph_status status = read_numbers(r, form->n, form->flags, x);
  if (status != PH_OK) {
    return status;
  }
  if (form->command == 'H' || form->command == 'V') {
    const size_t k = form->command == 'V';
    const double to = x[0] + (relative ? at[k] : 0);
    x[0] = k == 0 ? to : at[0];
    x[1] = k == 0 ? at[1] : to;
    draw(r, 'L', x);
    return PH_OK;
  }
  for (size_t i = form->points; relative && i < form->n; i++) {
    x[i] += at[(i - form->points) % 2];
  }
  draw(r, form->command, x);
  return PH_OK;
}

/* A command with all its sets of arguments; further ones of M are those of L.
 */
static enum ph_status read_command(struct reader *r) {
  static const char commands[] = "MLHVCSQTA";
  const char letter = *r->p;
  const bool relative = letter >= 'a' && letter <= 'z';
  const char command = relative ? (char)(letter - 'a' + 'A') : letter;
  const char *found = memchr(commands, command, sizeof commands - 1);
  const struct form *form = found ? &forms[found - commands] : NULL;
  enum ph_status status;
  if (!form && command != 'Z') {
    return unexpected(r, r->last ? "a command" : "the command M");
  }
  if (!r->last && command != 'M') {
    return unexpected(r, "the command M");
  }
  r->p++;
  if (!form) {
    ph_trace_close(r->trace);
    r->last = 'Z';
    return PH_OK;
  }
  do {
    status = read_set(r, form, relative);
    form = form == forms ? &forms[1] : form;
    skip(r, true);
  } while (status == PH_OK && r->p < r->end &&
           (memchr("+-.", *r->p, 3) || (*r->p >= '0' && *r->p <= '9')));
  return status;
}

enum ph_status ph_svg_path_read(struct ph_trace *trace, const char *text,
                                size_t n, const char *field,
                                struct ph_diag *diag) {
  struct reader r = {trace, text, text, text + n, field, diag, '\0', {0, 0}};
  enum ph_status status = PH_OK;
  skip(&r, false);
  while (status == PH_OK && r.p < r.end) {
    status = read_command(&r);
    skip(&r, false);
  }
  if (status == PH_OK && trace->failed) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < 2 * trace->n; i++) {
    if (!isfinite(trace->v[i])) {
      return ph_fail(diag, PH_E_NOT_FINITE, field,
                     "goes beyond what a double can have");
    }
  }
  return status;
}

/* Whether a text is a document, or the name of a file that is one. */
static bool is_document(const char *text, size_t n) {
  return (n > 0 && *text == '<') ||
         (n > 4 && ph_word_is(text + n - 4, 4, ".svg"));
}

enum ph_status ph_svg_path_value(const char *text, size_t n, const char *field,
                                 struct ph_arena *arena, struct ph_value *value,
                                 struct ph_diag *diag) {
  struct ph_trace trace = {.arena = arena, .affine = PH_TRACE_AS_IS};
  enum ph_status status;
  char *word;
  if (is_document(text, n)) {
    return ph_fail(diag, PH_E_BAD_VALUE, field,
                   "is path data, as \"M0,0 L1,1\": a whole SVG file is read "
                   "as input, and gives a problem for each path");
  }
  status = ph_svg_path_read(&trace, text, n, field, diag);
  word = ph_arena_array(arena, n + 1, 1);
  if (status != PH_OK) {
    return status;
  }
  if (!word) {
    return ph_fail_memory(diag);
  }
  if (trace.parts_n != 1) {
    return ph_fail(diag, PH_E_BAD_VALUE, field,
                   trace.parts_n
                       ? "has %zu subpaths: a problem has one, an SVG "
                         "file may have any number"
                       : "draws nothing (%zu subpaths)",
                   trace.parts_n);
  }
  for (size_t i = 0; i < n; i++) {
    word[i] = is_blank(text[i]) ? ' ' : text[i];
  }
  word[n] = '\0';
  *value = (struct ph_value){.kind = PH_POLYLINE,
                             .flag = trace.part[0].closed,
                             .word = word,
                             .v = trace.v,
                             .n = trace.n,
                             .dimension = 2,
                             .sizes = trace.sizes,
                             .sizes_n = trace.pieces_n};
  return PH_OK;
}
