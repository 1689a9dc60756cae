/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * spatial_min [N]: the fairest ATPH segments for N random data (100): what one
 * takes, and how often it is the global minimum.
 *
 * The judge is the best of the descents from the local minima of a grid of
 * 40 x 40 x 10 points over (b, phi, alpha).
 */
#include "spatial.h"

#include "solve/spatial/fairest.h"

#include <gsl/gsl_errno.h>

enum { GRID = 40, GRID_ALPHA = 10, DESCENTS = 60, SEED = 1 };

static const double TURN = 6.283185307179586;
static const double SAME = 1e-6; /* relative */

struct judge {
  struct ph_fair3_rules rules;
  struct ph_arena scratch;
  double value[GRID_ALPHA][GRID][GRID];
};

struct place {
  size_t k, i, j;
  double value;
};

static struct ph_spatial_point point_of(struct place at) {
  struct ph_spatial_point point = {
      TURN * ((double)at.i + 0.5) / GRID, TURN * ((double)at.j + 0.5) / GRID,
      ((double)at.k + 0.5) / GRID_ALPHA * PH_SPATIAL_ALPHA_MAX};
  return point;
}

static void fill(struct judge *judge, const struct ph_spatial_search *search) {
  struct ph_atph space = ph_atph_of(1);
  struct ph_spatial_family family = ph_spatial_family_of(search->data, &space);
  struct ph_spatial_target target = {&judge->rules.rule, &family, true,
                                     search->functional};
  struct place at = {0};
  for (at.k = 0; at.k < GRID_ALPHA; at.k++) {
    for (at.i = 0; at.i < GRID; at.i++) {
      for (at.j = 0; at.j < GRID; at.j++) {
        struct ph_spatial_point point = point_of(at);
        judge->value[at.k][at.i][at.j] =
            ph_spatial_fair(&target, 2, &point, NULL);
      }
    }
  }
}

static bool is_least(const struct judge *judge, struct place at) {
  const size_t i = at.i, j = at.j, k = at.k;
  const double(*v)[GRID] = judge->value[k];
  const double here = v[i][j];
  return here <= v[(i + 1) % GRID][j] && here <= v[(i + GRID - 1) % GRID][j] &&
         here <= v[i][(j + 1) % GRID] && here <= v[i][(j + GRID - 1) % GRID] &&
         (k == 0 || here <= judge->value[k - 1][i][j]) &&
         (k + 1 == GRID_ALPHA || here <= judge->value[k + 1][i][j]);
}

/* The best local minima of the grid, in order. */
static size_t places(const struct judge *judge, struct place *list) {
  size_t n = 0;
  for (size_t m = 0; m < (size_t)GRID_ALPHA * GRID * GRID; m++) {
    struct place at = {m / (GRID * GRID), m / GRID % GRID, m % GRID, 0};
    size_t to;
    at.value = judge->value[at.k][at.i][at.j];
    if (!is_least(judge, at) ||
        (n == DESCENTS && at.value >= list[n - 1].value)) {
      continue;
    }
    n += n < DESCENTS ? 1 : 0;
    for (to = n - 1; to > 0 && at.value < list[to - 1].value; to--) {
      list[to] = list[to - 1];
    }
    list[to] = at;
  }
  return n;
}

static double least(struct judge *judge,
                    const struct ph_spatial_search *search) {
  struct place list[DESCENTS];
  double best = (double)INFINITY;
  size_t n;
  fill(judge, search);
  n = places(judge, list);
  for (size_t i = 0; i < n; i++) {
    struct ph_spatial_point at = point_of(list[i]);
    struct ph_spatial_minimum found = {
        .member = {ph_cplx_polar(at.b), ph_cplx_polar(at.phi)},
        .alpha = at.alpha};
    if (ph_spatial_descend(search, &judge->rules, &judge->scratch, &found) !=
        PH_OK) {
      bench_die("out of memory");
    }
    best = found.value < best ? found.value : best;
  }
  return best;
}

static void measure(struct judge *judge, int functional, size_t n) {
  uint64_t state = SEED;
  size_t same = 0, better = 0;
  double time = 0, worst = 0, evaluations = 0;
  for (size_t i = 0; i < n; i++) {
    struct ph_spatial_data data = bench_hermite(&state);
    struct ph_spatial_search search = {
        &data,      true, PH_SPATIAL_ALPHA_MIN, PH_SPATIAL_ALPHA_MAX,
        functional, false};
    struct ph_spatial_minimum found;
    double start = bench_cpu(), taken, judged;
    if (ph_spatial_minimize(&search, &judge->rules, &judge->scratch, &found) !=
        PH_OK) {
      bench_die("out of memory");
    }
    taken = bench_cpu() - start;
    time += taken;
    worst = taken > worst ? taken : worst;
    evaluations += (double)found.evaluations;
    judged = least(judge, &search);
    same += found.value <= judged * (1 + SAME) ? 1 : 0;
    better += found.value < judged * (1 - SAME) ? 1 : 0;
  }
  printf("  F%d %7zu %8.2f %8.2f %8.0f %11.1f %% %9.1f %%\n", functional, n,
         1e3 * time / (double)n, 1e3 * worst, evaluations / (double)n,
         100 * (double)same / (double)n, 100 * (double)better / (double)n);
  fflush(stdout);
}

int main(int argc, char **argv) {
  struct judge *judge = bench_malloc(1, sizeof *judge);
  unsigned long n = argc > 1 ? strtoul(argv[1], NULL, 10) : 100;
  gsl_set_error_handler_off();
  if (!ph_fair3_begin(&judge->rules)) {
    bench_die("out of memory");
  }
  puts("Fairest ATPH segments with a free alpha, random data; processor ms, "
       "against\nthe best descent from a grid of 40 x 40 x 10\n\n"
       "  of    data  ms mean   ms max    evals.  not worse      better");
  for (int functional = 1; functional <= 3; functional++) {
    measure(judge, functional, n);
  }
  puts("\n  Target for F1: at most 5 ms, not worse in 99 %.");
  ph_arena_free(&judge->scratch);
  free(judge);
  return 0;
}
