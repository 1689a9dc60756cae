/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whatever the program answers, verification accepts it: random problems of all
 * commands, with all their fields and what can be derived from their curves
 * (gate.h).
 *
 * The seed is 1, or PH_SEED.  `make check-long' takes many, PH_TRIALS=N in
 * PH_JOBS threads, and tells while it goes what became of them, a line for each
 * thousand, and by commands, fields and options.  PH_FROM=I begins at problem
 * I, to go on with a run that ended, up to N; PH_TRIAL=I takes problem I alone,
 * and prints it as it is, and smaller where it is wrong.  PH_GATE=curves or
 * surfaces: only the problems of these, each of which have numbers of their
 * own.
 */
#include "gate.h"
#include "unit.h"

#include <pthread.h>
#include <time.h>

enum {
  TRIALS = 800,
  SURFACES = 160,
  JOBS = 64,
  WAYS = 100,
  OPTIONS = 24,
  TELL = 20000,
  TELL_SHORTLY = 1000
};

/* One in so many is looked at closely, of those of make check, and of a million
 * that are to be seen in an hour. */
enum { CLOSELY = 8, CLOSELY_LONG = 64 };

struct count {
  const char *name;
  size_t trials, fate[GATE_WRONG + 1], disputed, refused[PH_STATUS_N];
  double seconds, slowest;
  size_t slowest_at;
};

/* Wrong in one way. */
struct way {
  char way[112];
  size_t n, first;
};

/* All that has been found, shared by the threads. */
struct gate {
  pthread_mutex_t lock;
  const char *name;      /* of what it tries: */
  size_t from, commands; /* so many commands, from that one on */
  size_t next, done, trials, only;
  bool tell;
  struct count command[GATE_COMMANDS], field[PH_FIELD_N], option[OPTIONS];
  struct way ways[WAYS];
  size_t ways_n;
};

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- counts ---------------------------------------------------------------
 */

static void add(struct count *count, const char *name,
                const struct gate_outcome *outcome, size_t which,
                double seconds) {
  count->name = name;
  count->trials++;
  count->fate[outcome->fate]++;
  count->disputed += outcome->fate == GATE_WRONG && outcome->disputed;
  if (outcome->fate == GATE_REFUSED) {
    count->refused[outcome->code]++;
  }
  count->seconds += seconds;
  if (seconds > count->slowest) {
    count->slowest = seconds;
    count->slowest_at = which;
  }
}

static void add_all(struct gate *gate, const struct gate_case *c,
                    const struct gate_outcome *outcome, size_t which,
                    double seconds) {
  add(&gate->command[which % gate->commands], gate_schema(c)->command, outcome,
      which, seconds);
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    if (gate_has(c, (enum ph_field_id)i)) {
      add(&gate->field[i], ph_field_name((enum ph_field_id)i), outcome, which,
          seconds);
    }
  }
  for (size_t i = 0; i < c->options_n; i++) {
    struct count *o = gate->option, *end = o + OPTIONS - 1;
    while (o < end && o->name && strcmp(o->name, c->option[i].text) != 0) {
      o++;
    }
    add(o, c->option[i].text, outcome, which, seconds);
  }
}

static void tell_count(const struct count *n) {
  if (!n->name) {
    return;
  }
  printf("%-16s %8zu %8zu %6zu %6zu %8.1f %6.2f %8zu", n->name, n->trials,
         n->fate[GATE_SOLVED], n->fate[GATE_WRONG], n->disputed, n->seconds,
         n->slowest, n->slowest_at);
  for (size_t k = 0; k < PH_STATUS_N; k++) {
    if (n->refused[k]) {
      printf(" %s %zu", ph_status_code((enum ph_status)k), n->refused[k]);
    }
  }
  printf("\n");
}

/* One line. */
static void tell_shortly(const struct gate *gate) {
  size_t fate[GATE_WRONG + 1] = {0}, disputed = 0;
  for (size_t i = 0; i < gate->commands; i++) {
    for (size_t k = 0; k <= GATE_WRONG; k++) {
      fate[k] += gate->command[i].fate[k];
    }
    disputed += gate->command[i].disputed;
  }
  printf("%s: %zu problems to number %zu: %zu solved, %zu refused, %zu wrong, "
         "of which %zu are right by brute force\n",
         gate->name, gate->done, gate->next, fate[GATE_SOLVED],
         fate[GATE_REFUSED], fate[GATE_WRONG], disputed);
  fflush(stdout);
}

static void tell(const struct gate *gate) {
  printf("\n%-16s %8s %8s %6s %6s %8s %6s %8s refused\n", "", "problems",
         "solved", "wrong", "though", "seconds", "most", "of");
  for (size_t i = 0; i < gate->commands; i++) {
    tell_count(&gate->command[i]);
  }
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    tell_count(&gate->field[i]);
  }
  for (size_t i = 0; i < OPTIONS; i++) {
    tell_count(&gate->option[i]);
  }
  for (size_t i = 0; i < gate->ways_n; i++) {
    printf("%6zu times, first problem %zu: %s\n", gate->ways[i].n,
           gate->ways[i].first, gate->ways[i].way);
  }
  fflush(stdout);
}

/* ---- what is wrong --------------------------------------------------------
 */

/* Whether nothing was wrong in this way before. */
static bool is_new(struct gate *gate, const char *command,
                   const struct gate_outcome *outcome, size_t which) {
  char way[112];
  snprintf(way, sizeof way, "%s: %s", command, outcome->way);
  for (size_t i = 0; i < gate->ways_n; i++) {
    if (strcmp(gate->ways[i].way, way) == 0) {
      gate->ways[i].n++;
      return false;
    }
  }
  if (gate->ways_n < WAYS) {
    struct way *w = &gate->ways[gate->ways_n++];
    *w = (struct way){.n = 1, .first = which};
    memcpy(w->way, way, sizeof way);
  }
  return true;
}

static void print_case(const struct gate_case *c) {
  struct ph_buf line = {0};
  gate_command_line(&line, c);
  ph_buf_put(&line, "", 1);
  printf("  %s\n", line.data);
  fflush(stdout);
  ph_buf_free(&line);
}

static void explain(const char *name, struct gate_lab *lab,
                    const struct gate_case *c,
                    const struct gate_outcome *outcome, size_t which) {
  static _Thread_local struct gate_case smaller;
  struct gate_outcome end = *outcome;
  printf("PH_GATE=%s PH_SEED=%lu, problem %zu: %s\n", name, unit_seed(), which,
         end.way);
  fflush(stdout);
  gate_copy(&smaller, c);
  gate_shrink(lab, &smaller, &end);
  printf("PH_GATE=%s PH_SEED=%lu, problem %zu: %s: %s\n", name, unit_seed(),
         which, end.way, end.message);
  print_case(&smaller);
}

/* ---- trials ---------------------------------------------------------------
 */

static void trial(struct gate *gate, struct gate_lab *lab, size_t which) {
  static _Thread_local struct gate_case c;
  struct unit_random r = unit_random_of(1000 + 7919 * which);
  struct gate_outcome outcome;
  size_t rare = gate->tell ? CLOSELY_LONG : CLOSELY;
  bool closely = gate->only == which || which / gate->commands % rare == 0;
  bool new = false;
  double start = now(), seconds;
  gate_random(&r, gate->from + which % gate->commands, &c);
  if (gate->only == which) {
    print_case(&c);
  }
  gate_run(lab, &c, closely ? GATE_CLOSELY : GATE_VERIFIED, &outcome);
  if (closely) {
    gate_moved(lab, &c, &outcome);
  }
  seconds = now() - start;
  pthread_mutex_lock(&gate->lock);
  add_all(gate, &c, &outcome, which, seconds);
  new = outcome.fate ==
        GATE_WRONG &&is_new(gate, gate_schema(&c)->command, &outcome, which);
  if (++gate->done % TELL_SHORTLY == 0 && gate->tell) {
    tell_shortly(gate);
  }
  if (gate->done % TELL == 0 && gate->tell) {
    tell(gate);
  }
  pthread_mutex_unlock(&gate->lock);
  if (gate->only == which) {
    printf("problem %zu: %s, %.3g s\n", which,
           outcome.fate == GATE_WRONG     ? outcome.way
           : outcome.fate == GATE_REFUSED ? ph_status_code(outcome.code)
                                          : "solved",
           seconds);
  }
  if (new) {
    explain(gate->name, lab, &c, &outcome, which);
  } else if (outcome.fate == GATE_WRONG) { /* as one before, or not */
    printf("PH_GATE=%s PH_SEED=%lu, problem %zu: %s\n", gate->name, unit_seed(),
           which, outcome.way);
  }
}

static void *work(void *context) {
  struct gate *gate = context;
  struct gate_lab lab = {0};
  for (;;) {
    size_t which;
    pthread_mutex_lock(&gate->lock);
    which = gate->next++;
    pthread_mutex_unlock(&gate->lock);
    if (which >= gate->trials) {
      break;
    }
    trial(gate, &lab, which);
  }
  gate_lab_free(&lab);
  return NULL;
}

static size_t number(const char *name, size_t otherwise) {
  const char *text = getenv(name);
  return text && *text ? (size_t)strtoul(text, NULL, 10) : otherwise;
}

static void run(struct gate *gate, size_t trials) {
  const char *name = getenv("PH_GATE");
  pthread_t thread[JOBS];
  size_t jobs = number("PH_JOBS", 1);
  if (name && *name && strcmp(name, gate->name) != 0) {
    return;
  }
  gate->trials = number("PH_TRIALS", trials);
  gate->next = number("PH_FROM", 0);
  gate->only = number("PH_TRIAL", SIZE_MAX);
  gate->tell = getenv("PH_TRIALS") != NULL;
  if (gate->only != SIZE_MAX) {
    gate->next = gate->only;
    gate->trials = gate->only + 1;
  }
  ck_assert_msg(gate->next < gate->trials, "PH_FROM must be below PH_TRIALS");
  jobs = jobs < JOBS ? jobs : JOBS;
  for (size_t i = 0; i < jobs; i++) {
    ck_assert_int_eq(pthread_create(&thread[i], NULL, work, gate), 0);
  }
  for (size_t i = 0; i < jobs; i++) {
    pthread_join(thread[i], NULL);
  }
  if (gate->tell) {
    tell(gate);
    tell_shortly(gate);
  }
  ck_assert_uint_eq(gate->ways_n, 0);
}

PH_TEST(whatever_is_solved_is_right) {
  static struct gate gate = {.lock = PTHREAD_MUTEX_INITIALIZER,
                             .name = "curves",
                             .commands = GATE_CURVES};
  run(&gate, (size_t)unit_count(TRIALS));
}

PH_TEST(surfaces_are_right) {
  static struct gate gate = {.lock = PTHREAD_MUTEX_INITIALIZER,
                             .name = "surfaces",
                             .from = GATE_CURVES,
                             .commands = GATE_COMMANDS - GATE_CURVES};
  run(&gate, (size_t)unit_count(SURFACES));
}
