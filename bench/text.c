/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers to text and back, beside printf("%.17g") and strtod.
 *
 * Both readers read what %.17g wrote.  Every number must come back, also from
 * the text that we wrote, or the figures would mean nothing.
 */
#include "bench.h"

#include "io/number.h"

#include <string.h>

enum { NUMBERS = 100000, ROUNDS = 9, TEXT_MAX = PH_NUMBER_MAX + 1 };

struct data {
  double x[NUMBERS], back[NUMBERS];
  char text[NUMBERS][TEXT_MAX]; /* of %.17g, NUL-terminated */
  char ours[NUMBERS][TEXT_MAX];
};

/* Uniform in [0, 1), in steps of 2^-53. */
static double uniform(uint64_t *state) {
  return ldexp((double)(bench_random(state) >> 11), -53);
}

/* A coordinate: 16 or 17 digits. */
static double make_digits(uint64_t *state) {
  return 200 * uniform(state) - 100;
}

/* Any finite double. */
static double make_any(uint64_t *state) {
  for (;;) {
    uint64_t bits = bench_random(state);
    double x;
    memcpy(&x, &bits, sizeof x);
    if (isfinite(x)) {
      return x;
    }
  }
}

static double make_decimals(uint64_t *state) {
  return (double)(bench_random(state) % 200000000) / 1e6 - 100;
}

static double make_integer(uint64_t *state) {
  return (double)(bench_random(state) % 1000000);
}

static void write_ours(void *data) {
  struct data *d = data;
  for (size_t i = 0; i < NUMBERS; i++) {
    d->ours[i][ph_number_write(d->ours[i], d->x[i])] = '\0';
  }
}

static void write_printf(void *data) {
  struct data *d = data;
  for (size_t i = 0; i < NUMBERS; i++) {
    snprintf(d->text[i], TEXT_MAX, "%.17g", d->x[i]);
  }
}

static void read_ours(void *data) {
  struct data *d = data;
  for (size_t i = 0; i < NUMBERS; i++) {
    ph_number_read_text(d->text[i], d->text[i] + TEXT_MAX, &d->back[i]);
  }
}

static void read_strtod(void *data) {
  struct data *d = data;
  for (size_t i = 0; i < NUMBERS; i++) {
    d->back[i] = strtod(d->text[i], NULL);
  }
}

static void check(struct data *d, void (*read)(void *data)) {
  read(d);
  if (memcmp(d->x, d->back, sizeof d->x) != 0) {
    bench_die("a number did not read back");
  }
}

static void read_our_text(void *data) {
  struct data *d = data;
  for (size_t i = 0; i < NUMBERS; i++) {
    d->back[i] = strtod(d->ours[i], NULL);
  }
}

static void row(const char *name, double (*make)(uint64_t *),
                const char *at_most) {
  static struct data d;
  struct bench_contender c[4] = {{write_ours, &d, 0},
                                 {write_printf, &d, 0},
                                 {read_ours, &d, 0},
                                 {read_strtod, &d, 0}};
  const double scale = 1e9 / NUMBERS;
  uint64_t state = 17;
  for (size_t i = 0; i < NUMBERS; i++) {
    d.x[i] = make(&state);
  }
  bench_alternate(c, 2, ROUNDS, 1);
  bench_alternate(c + 2, 2, ROUNDS, 1);
  check(&d, read_ours);
  check(&d, read_strtod);
  check(&d, read_our_text);
  printf("  %-20s %7.1f %8.1f %6.2f %9.1f %8.1f %6.2f   %s\n", name,
         scale * c[0].best, scale * c[1].best, c[0].best / c[1].best,
         scale * c[2].best, scale * c[3].best, c[2].best / c[3].best, at_most);
}

int main(void) {
  puts("Numbers: writing beside printf(\"%.17g\"), reading beside strtod, "
       "processor ns a\nnumber, best of many runs\n");
  puts("                           write                     read\n"
       "  numbers                 ours   printf  ratio      ours   strtod  "
       "ratio   target");
  row("16 or 17 digits", make_digits, "write <= 60, read <= 45");
  row("random bits", make_any, "");
  row("6 decimals", make_decimals, "");
  row("integers < 10^6", make_integer, "");
  return 0;
}
