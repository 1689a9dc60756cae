/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes problems for the benchmarks of the whole program to standard output:
 *
 *   generate csv N              one closed curve of N points
 *   generate json N             the same as one JSON object
 *   generate lines RECORDS N    so many small open curves of N points each, as
 *                               JSON Lines
 *   generate array RECORDS N    the same as one JSON array
 */
#include "bench.h"

#include "base/buf.h"
#include "io/number.h"

#include <string.h>

static const double TWO_PI = 6.283185307179586;

enum { FLUSH_BYTES = 1 << 16 };

/* Writes out what is in the buffer if it is large enough. */
static void flush(struct ph_buf *buf, size_t at_least) {
  if (buf->failed) {
    bench_die("out of memory");
  }
  if (buf->n >= at_least && buf->n > 0) {
    if (fwrite(buf->data, 1, buf->n, stdout) != buf->n) {
      bench_die("cannot write");
    }
    buf->n = 0;
  }
}

static void put_number(struct ph_buf *buf, double x) {
  char text[PH_NUMBER_MAX];
  ph_buf_put(buf, text, ph_number_write(text, x));
}

static void put_point(struct ph_buf *buf, const double *p) {
  put_number(buf, p[0]);
  ph_buf_puts(buf, ",");
  put_number(buf, p[1]);
}

static void write_curve(struct ph_buf *buf, size_t n, bool json) {
  ph_buf_puts(buf, json ? "{\"closed\":true,\"points\":[" : "x,y\n");
  for (size_t k = 0; k < n; k++) {
    double p[2];
    bench_wobble(TWO_PI * (double)k / (double)n, 0, p);
    ph_buf_puts(buf, !json ? "" : k > 0 ? ",[" : "[");
    put_point(buf, p);
    ph_buf_puts(buf, json ? "]" : "\n");
    flush(buf, FLUSH_BYTES);
  }
  ph_buf_puts(buf, json ? "]}\n" : "");
}

/* Walks with random turns of at most a quarter; every record is another. */
static void write_walk(struct ph_buf *buf, size_t number, size_t n,
                       uint64_t *state) {
  double p[2] = {0, 0}, heading = 0;
  ph_buf_puts(buf, "{\"id\":");
  put_number(buf, (double)number);
  ph_buf_puts(buf, ",\"points\":[");
  for (size_t k = 0; k < n; k++) {
    ph_buf_puts(buf, k > 0 ? ",[" : "[");
    put_point(buf, p);
    ph_buf_puts(buf, "]");
    heading +=
        TWO_PI / 4 * (ldexp((double)(bench_random(state) >> 11), -52) - 1);
    p[0] += cos(heading);
    p[1] += sin(heading);
  }
  ph_buf_puts(buf, "]}");
}

static void write_records(struct ph_buf *buf, size_t records, size_t n,
                          bool array) {
  uint64_t state = 5;
  ph_buf_puts(buf, array ? "[" : "");
  for (size_t i = 0; i < records; i++) {
    ph_buf_puts(buf, array && i > 0 ? ",\n" : "");
    write_walk(buf, i + 1, n, &state);
    ph_buf_puts(buf, array ? "" : "\n");
    flush(buf, FLUSH_BYTES);
  }
  ph_buf_puts(buf, array ? "]\n" : "");
}

int main(int argc, char **argv) {
  struct ph_buf buf = {0};
  const char *what = argc > 1 ? argv[1] : "";
  size_t first = argc > 2 ? (size_t)strtoull(argv[2], NULL, 10) : 0;
  size_t second = argc > 3 ? (size_t)strtoull(argv[3], NULL, 10) : 0;
  if (strcmp(what, "csv") == 0 || strcmp(what, "json") == 0) {
    write_curve(&buf, first, what[0] == 'j');
  } else if (strcmp(what, "lines") == 0 || strcmp(what, "array") == 0) {
    write_records(&buf, first, second, what[0] == 'a');
  } else {
    bench_die("generate csv|json N, or lines|array RECORDS N");
  }
  flush(&buf, 0);
  ph_buf_free(&buf);
  if (fflush(stdout) != 0) {
    bench_die("cannot write");
  }
  return 0;
}
