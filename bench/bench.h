/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the benchmarks share: processor time, a generator of numbers, and the
 * best of many runs.
 *
 * Processor time of the process, not wall time: other work on the machine
 * then counts only through caches and memory.  Contenders are timed in turn,
 * round after round, so that what disturbs one disturbs the others, too.
 */
#ifndef PH_BENCH_BENCH_H
#define PH_BENCH_BENCH_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* bench_cpu: processor seconds that this process has used. */
static inline double bench_cpu(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* bench_random: the next of a sequence of 64 random bits [Vigna, splitmix64];
 * any state begins one. */
static inline uint64_t bench_random(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
  return z ^ z >> 31;
}

/* bench_uniform: in [low, high). */
static inline double bench_uniform(uint64_t *state, double low, double high) {
  return low + (high - low) * (double)(bench_random(state) >> 11) * 0x1p-53;
}

/*
 * bench_wobble: the point at angle t of a circle with a few harmonics, and, if
 * there are any, so many waves that turn by about a third of a right angle
 * whatever their number.
 */
static inline void bench_wobble(double t, double waves, double p[2]) {
  double r = 1 + 0.15 * cos(3 * t + 0.4) + 0.06 * sin(7 * t);
  r += waves > 0 ? 0.3 / waves * cos(waves * t) : 0;
  p[0] = r * cos(t);
  p[1] = r * sin(t);
}

/* bench_die: ends the program, which has nothing to measure. */
static inline _Noreturn void bench_die(const char *message) {
  fprintf(stderr, "bench: %s\n", message);
  exit(EXIT_FAILURE);
}

/* bench_malloc: zeroed memory, or the end. */
static inline void *bench_malloc(size_t n, size_t size) {
  void *memory = calloc(n ? n : 1, size);
  if (!memory) {
    bench_die("out of memory");
  }
  return memory;
}

/* One thing to be timed, `times` times in a row for one reading. */
struct bench_contender {
  void (*run)(void *data);
  void *data;
  double best; /* out: seconds for one run */
};

/* bench_alternate: the best of so many rounds for each of n contenders. */
static inline void bench_alternate(struct bench_contender *c, size_t n,
                                   int rounds, int times) {
  for (int round = 0; round < rounds; round++) {
    for (size_t i = 0; i < n; i++) {
      double start = bench_cpu(), each;
      for (int k = 0; k < times; k++) {
        c[i].run(c[i].data);
      }
      each = (bench_cpu() - start) / times;
      if (round == 0 || each < c[i].best) {
        c[i].best = each;
      }
    }
  }
}

#endif
