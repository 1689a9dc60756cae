/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading alone: from the bytes of a file to the problems, beside what reads
 * the same text from memory: strtod each number of a table, cJSON a tree of
 * each JSON text.  Checks of the values, which come later, are not in it.
 *
 *   read         a row for each kind of input
 *   read NAME    that one once, without its peer: to count instructions
 */
#include "bench.h"

#include "base/buf.h"
#include "io/number.h"
#include "io/split.h"
#include "solve/method.h"

#include <cjson/cJSON.h>
#include <string.h>
#include <unistd.h>

enum { POINTS = 100000, ROUNDS = 9 };

/* What stands before, between and behind the numbers of records of so many
 * points each. */
struct form {
  const char *name;
  enum ph_split_format format;
  size_t points;
  const char *header, *begin, *row, *comma, *between, *end, *apart, *footer;
  bool numbered; /* a row begins with the number of its record */
};

/* header; of each record begin, then row X comma Y for each point, with
 * `between' between two of them, then end, with `apart' between records;
 * footer */
static const struct form forms[] = {
    {"csv", PH_SPLIT_CSV, POINTS, "x,y\n", "", "", ",", "\n", "", "", "\n",
     false},
    {"csv-ids", PH_SPLIT_CSV, 10, "id,x,y\n", "", "", ",", "\n", "", "\n", "\n",
     true},
    {"text", PH_SPLIT_TEXT, POINTS, "", "", "", " ", "\n", "", "", "\n", false},
    {"json", PH_SPLIT_JSON, POINTS, "", "{\"points\":[", "[", ",", "],", "]]}",
     "", "\n", false},
    {"jsonl", PH_SPLIT_JSON, 10, "", "{\"points\":[", "[", ",", "],", "]]}",
     "\n", "\n", false},
    {"geojson", PH_SPLIT_GEOJSON, 10,
     "{\"type\":\"FeatureCollection\",\"features\":[",
     "{\"type\":\"Feature\",\"properties\":{},\"geometry\":"
     "{\"type\":\"LineString\",\"coordinates\":[",
     "[", ",", "],", "]]}}", ",", "]}\n", false},
};

struct data {
  const struct form *form;
  struct ph_buf text;
  struct ph_arena arena;
  size_t points; /* read */
};

static void put_number(struct ph_buf *buf, double x) {
  char text[PH_NUMBER_MAX];
  ph_buf_put(buf, text, ph_number_write(text, x));
}

static void write_text(struct data *d) {
  const struct form *f = d->form;
  struct ph_buf *buf = &d->text;
  ph_buf_puts(buf, f->header);
  for (size_t i = 0; i < POINTS; i++) {
    const bool first = i % f->points == 0;
    double p[2];
    bench_wobble(2 * acos(-1) * (double)i / POINTS, 0, p);
    ph_buf_puts(buf, first && i > 0 ? f->apart : "");
    ph_buf_puts(buf, first ? f->begin : f->between);
    ph_buf_puts(buf, f->row);
    if (f->numbered) {
      put_number(buf, (double)(i / f->points));
      ph_buf_puts(buf, f->comma);
    }
    put_number(buf, p[0]);
    ph_buf_puts(buf, f->comma);
    put_number(buf, p[1]);
    ph_buf_puts(buf, (i + 1) % f->points == 0 ? f->end : "");
  }
  ph_buf_puts(buf, f->footer);
  ph_buf_put(buf, "", 1); /* for strtod and cJSON */
}

/* The text becomes the standard input. */
static void feed(const struct data *d) {
  FILE *file = tmpfile();
  if (d->text.failed || !file ||
      fwrite(d->text.data, 1, d->text.n - 1, file) != d->text.n - 1 ||
      fflush(file) != 0 || dup2(fileno(file), STDIN_FILENO) < 0) {
    bench_die("cannot write a temporary file");
  }
  fclose(file);
}

static void read_ours(void *data) {
  static const char *const input[] = {"-"};
  const struct ph_schema *schema = &ph_method_planar.schema;
  struct data *d = data;
  const struct ph_split_options options = {.format = d->form->format};
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag;
  d->points = 0;
  if (lseek(STDIN_FILENO, 0, SEEK_SET) != 0 ||
      ph_split_init(&split, input, 1, &options, schema, &diag) != PH_OK) {
    bench_die("cannot begin to read");
  }
  while (ph_split_next(&split, true, &record, &diag) == PH_SPLIT_RECORD) {
    struct ph_problem problem = {0};
    struct ph_echo echo = {0};
    if (record.status != PH_OK ||
        ph_record_read(&record, schema, &d->arena, &problem, &echo, &diag) !=
            PH_OK) {
      bench_die(diag.message);
    }
    d->points += problem.field[PH_F_POINTS].n;
    ph_arena_reset(&d->arena);
  }
  ph_split_free(&split);
}

/* Every number of the text, whatever is between. */
static void read_strtod(void *data) {
  struct data *d = data;
  const char *p = d->text.data;
  double sum = 0;
  while (*p) {
    char *end;
    const double x = strtod(p, &end);
    sum += end > p ? x : 0;
    p = end > p ? end : p + 1;
  }
  d->points = isfinite(sum) ? POINTS : 0;
}

/* Line by line. */
static void read_cjson(void *data) {
  struct data *d = data;
  const char *p = d->text.data, *newline;
  for (; (newline = strchr(p, '\n')) != NULL; p = newline + 1) {
    cJSON *tree = cJSON_ParseWithLength(p, (size_t)(newline - p));
    if (!tree) {
      bench_die("cJSON cannot read it");
    }
    cJSON_Delete(tree);
  }
  d->points = POINTS;
}

static void measure(const struct form *form, bool once) {
  const bool table =
      form->format == PH_SPLIT_CSV || form->format == PH_SPLIT_TEXT;
  struct data d = {.form = form};
  struct bench_contender c[2] = {{read_ours, &d, 0},
                                 {table ? read_strtod : read_cjson, &d, 0}};
  write_text(&d);
  feed(&d);
  read_ours(&d);
  if (d.points != POINTS) {
    bench_die("points are missing");
  }
  if (!once) {
    bench_alternate(c, 2, ROUNDS, 1);
    printf("  %-8s %7zu %6zu %7.2f %8.1f %8.1f   %-6s %7.1f %6.2f\n",
           form->name, POINTS / form->points, form->points,
           1e-6 * (double)d.text.n, 1e-6 * (double)d.text.n / c[0].best,
           1e9 / POINTS * c[0].best, table ? "strtod" : "cJSON",
           1e9 / POINTS * c[1].best, c[1].best / c[0].best);
  }
  ph_arena_free(&d.arena);
  ph_buf_free(&d.text);
}

int main(int argc, char **argv) {
  const size_t n = sizeof forms / sizeof forms[0];
  if (argc == 1) {
    printf("Reading alone, 100000 points; processor time, best of %d\n\n"
           "                             phspline"
           "                 peer\n"
           "  input    records points      MB     MB/s   ns/pt."
           "          ns/pt.  ratio\n",
           ROUNDS);
  }
  for (size_t i = 0; i < n; i++) {
    if (argc == 1 || strcmp(argv[1], forms[i].name) == 0) {
      measure(&forms[i], argc > 1);
    }
  }
  return EXIT_SUCCESS;
}
