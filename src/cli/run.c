/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The pipeline (see run.h).
 *
 * Batches grow from one item to BATCH_ITEMS as the stream goes on: a handful
 * of hard problems is spread over all workers, and a million easy ones do not
 * pay for a lock each.  A batch also ends where the input would have to be
 * waited for, so that a slow producer sees its results at once.
 */
#include "cli/run.h"

#include "base/team.h"
#include "cli/document.h"
#include "cli/message.h"
#include "cli/outlet.h"
#include "cli/output.h"
#include "cli/pairing.h"
#include "cli/panorama.h"
#include "cli/plot.h"
#include "cli/progress.h"
#include "cli/work.h"

#include "io/nrrd.h"
#include "io/svg_out.h"

#include <math.h>
#include <pthread.h>
#include <string.h>
#include <unistd.h>

enum { BATCH_ITEMS = 64, BATCH_BYTES = 64 << 10, SLOTS_PER_JOB = 4 };

/* Buffers larger than this are given back after use. */
enum { KEEP_BYTES = 1 << 20 };

enum slot_state { SLOT_FREE, SLOT_FILLED, SLOT_DONE };

struct slot {
  enum slot_state state;
  struct ph_buf text; /* of the records */
  struct ph_item items[BATCH_ITEMS];
  size_t text_at[BATCH_ITEMS];
  size_t n;
  struct ph_buf out, err;
  struct ph_spout spout;
  size_t out_end[BATCH_ITEMS], err_end[BATCH_ITEMS];
};

struct run {
  const struct ph_options *options;
  struct ph_split split;
  struct ph_pairing pairing; /* with --problems */
  struct ph_output output;
  struct ph_plot plot;
  struct ph_output picture;     /* of --panorama */
  struct ph_panorama *panorama; /* NULL: no result has one */
  struct ph_progress progress;
  double bytes; /* of all files; NaN: they are not all files */
  struct ph_document document;
  struct ph_buf message;
  enum ph_class class; /* the worst so far */

  struct slot *slots;
  size_t slots_n;
  size_t filled, taken;    /* counts of slots, ever */
  struct ph_outlet outlet; /* of the slots that are not written */

  bool input_ended;
  bool input_failed;            /* told when all before it is written */
  struct ph_diag input_failure; /* why */
  bool stopped;                 /* fail-fast, or a failure that ends the run */
  /* The record whose sweep is being handed out. */
  struct ph_item current;
  size_t current_left; /* combinations that remain */

  struct ph_worker *workers;
  atomic_int spare; /* threads that do not work (base/team.h) */
  pthread_t *threads;
  size_t threads_n; /* started; 0: the main thread works */
  bool quit;
};

static struct slot *slot_at(struct run *r, size_t number) {
  return &r->slots[number % r->slots_n];
}

/* Sends what there is to say. */
static void send(struct run *r) {
  if (r->message.failed) {
    r->class = PH_CLASS_INTERNAL;
  }
  ph_message_send(&r->message);
}

static void worsen(struct run *r, enum ph_class class) {
  r->class = class > r->class ? class : r->class;
}

/* A failure that is not a record's. */
static void complain(struct run *r, const struct ph_diag *diag) {
  ph_message_failure(&r->message, diag, r->options->command->schema->command);
  worsen(r, ph_status_class(diag->status));
}

/* ---- reading ---------------------------------------------------------- */

/* Reading ends here; how far writing is, depends on the number of jobs. */
static void fail_input(struct run *r, const struct ph_diag *diag) {
  r->input_failed = true;
  r->input_failure = *diag;
  r->input_ended = true;
  r->current_left = 0;
}

/* Finds the problem of the current record, a result; false if the problems
 * cannot be read. */
static bool find_problem(struct run *r) {
  struct ph_diag diag = {.line = 0};
  struct ph_diag *why =
      r->current.record.status == PH_OK ? &r->current.diag : &diag;
  enum ph_status status = ph_pairing_find(
      &r->pairing, r->options, &r->current.record, &r->current.paired, why);
  if (status != PH_OK) {
    fail_input(r, why);
  }
  return status == PH_OK;
}

/* Whether all problems had results; not after --fail-fast or a failure. */
static void finish_pairing(struct run *r) {
  struct ph_diag diag;
  if (r->options->problems && !r->stopped && r->class < PH_CLASS_USAGE &&
      ph_pairing_finish(&r->pairing, r->options, &diag) != PH_OK) {
    complain(r, &diag);
  }
}

/* Gets the next record, if there is one now; false ends the batch. */
static bool next_record(struct run *r, bool may_wait) {
  struct ph_diag diag;
  if (r->current_left) {
    return true;
  }
  if (r->input_ended) {
    return false;
  }
  memset(&r->current, 0, sizeof r->current);
  switch (ph_split_next(&r->split, may_wait, &r->current.record, &diag)) {
  case PH_SPLIT_RECORD:
    r->current.diag = diag;
    r->current.cut_off = ph_split_stopped(&r->split);
    r->current_left =
        r->current.record.status == PH_OK ? r->options->sweep_count : 1;
    return !r->options->problems || find_problem(r);
  case PH_SPLIT_WAIT:
    return false;
  case PH_SPLIT_FAILED:
    fail_input(r, &diag);
    return false;
  case PH_SPLIT_END:
    break;
  }
  r->input_ended = true;
  return false;
}

/* Puts one item into a slot, with its text unless the slot has it already. */
static bool add_item(struct run *r, struct slot *slot) {
  struct ph_item *item = &slot->items[slot->n];
  bool same = slot->n > 0 && r->current.sweep > 0;
  size_t at = same ? slot->text_at[slot->n - 1] : slot->text.n;
  if (!same) {
    ph_buf_put(&slot->text, r->current.record.text, r->current.record.n);
    if (slot->text.failed) {
      return false;
    }
  }
  *item = r->current;
  item->draw = ph_plot_wants(&r->plot, r->current.record.number);
  slot->text_at[slot->n] = at;
  slot->n++;
  r->progress.read++;
  r->current.sweep++;
  r->current_left--;
  if (!r->current_left) {
    ph_split_release(&r->split);
  }
  return true;
}

static size_t batch_limit(const struct run *r) {
  size_t limit = 1 + r->filled / (2 * r->slots_n);
  return limit < BATCH_ITEMS ? limit : BATCH_ITEMS;
}

/* Fills the next slot; false if there was nothing to fill it with. */
static bool fill_slot(struct run *r, bool may_wait) {
  struct slot *slot = slot_at(r, r->filled);
  size_t limit = batch_limit(r);
  slot->n = 0;
  slot->spout = (struct ph_spout){&r->outlet, r->filled, &r->spare};
  ph_buf_clear(&slot->text, KEEP_BYTES);
  while (slot->n < limit && slot->text.n < BATCH_BYTES &&
         next_record(r, may_wait && slot->n == 0)) {
    if (!add_item(r, slot)) {
      struct ph_diag diag;
      ph_fail_memory(&diag);
      fail_input(r, &diag);
      break;
    }
  }
  for (size_t i = 0; i < slot->n; i++) { /* the text has stopped moving */
    slot->items[i].record.text = slot->text.data + slot->text_at[i];
    slot->items[i].held = slot->n == 1 ? &slot->text : NULL;
  }
  return slot->n > 0;
}

/* ---- working ---------------------------------------------------------- */

static void work_slot(const struct ph_options *options,
                      struct ph_worker *worker, struct slot *slot) {
  ph_buf_clear(&slot->out, KEEP_BYTES);
  ph_buf_clear(&slot->err, KEEP_BYTES);
  slot->out.spill = ph_spout_spill;
  slot->out.context = &slot->spout;
  ph_team_enter(worker->budget.spare);
  for (size_t i = 0; i < slot->n; i++) {
    options->command->work(options, worker, &slot->items[i], &slot->out,
                           &slot->err);
    slot->out_end[i] = slot->out.n;
    slot->err_end[i] = slot->err.n;
    if (options->fail_fast && slot->items[i].status != PH_OK) {
      break; /* nothing behind it may leave */
    }
  }
  ph_team_leave(worker->budget.spare);
}

struct thread_start {
  struct run *run;
  struct ph_worker *worker;
};

static void *worker_main(void *argument) {
  struct thread_start *start = argument;
  struct run *r = start->run;
  pthread_mutex_lock(&r->outlet.lock);
  while (!r->quit) {
    if (r->taken < r->filled) {
      struct slot *slot = slot_at(r, r->taken++);
      pthread_mutex_unlock(&r->outlet.lock);
      work_slot(r->options, start->worker, slot);
      pthread_mutex_lock(&r->outlet.lock);
      slot->state = SLOT_DONE;
      pthread_cond_broadcast(&r->outlet.changed);
    } else {
      pthread_cond_wait(&r->outlet.changed, &r->outlet.lock);
    }
  }
  pthread_mutex_unlock(&r->outlet.lock);
  return NULL;
}

/* Makes a filled slot known to the workers, or works on it here. */
static void hand_over(struct run *r) {
  struct slot *slot = slot_at(r, r->filled);
  if (r->threads_n == 0) {
    work_slot(r->options, &r->workers[0], slot);
    slot->state = SLOT_DONE;
    r->filled++;
    r->taken++;
    return;
  }
  pthread_mutex_lock(&r->outlet.lock);
  slot->state = SLOT_FILLED;
  r->filled++;
  pthread_cond_broadcast(&r->outlet.changed);
  pthread_mutex_unlock(&r->outlet.lock);
}

/* ---- writing ---------------------------------------------------------- */

/* Counts outcomes up to and including the first failure under --fail-fast;
 * returns how many items of the slot are to be written. */
static size_t count_outcomes(struct run *r, const struct slot *slot) {
  for (size_t i = 0; i < slot->n; i++) {
    enum ph_status status = slot->items[i].status;
    r->progress.records++;
    if (slot->items[i].cut_off) {
      worsen(r, PH_CLASS_INPUT);
    }
    if (status != PH_OK) {
      r->progress.failed++;
      /* memory that one record lacks is there for the next one */
      worsen(r, status == PH_E_NO_MEMORY ? PH_CLASS_RECORD
                                         : ph_status_class(status));
      if (r->options->fail_fast) {
        r->stopped = true;
        return i + 1;
      }
    }
  }
  return slot->n;
}

/* Takes the drawings and panoramas of the first n items of a slot. */
static void collect_drawings(struct run *r, struct slot *slot, size_t n) {
  struct ph_diag diag;
  for (size_t i = 0; i < n; i++) {
    struct ph_item *item = &slot->items[i];
    struct ph_drawing *drawing = item->drawing;
    item->drawing = NULL;
    if (item->status == PH_OK) {
      ph_svg_join(r->document.box, item->box);
    }
    if (item->panorama) {
      r->panorama = item->panorama;
      item->panorama = NULL;
    }
    if (item->status == PH_OK &&
        ph_plot_add(&r->plot, drawing, &diag) != PH_OK) {
      complain(r, &diag);
      r->stopped = true;
      return;
    }
  }
}

static void write_slot(struct run *r, struct slot *slot) {
  size_t n = count_outcomes(r, slot);
  struct ph_diag diag;
  if (slot->out.failed || slot->err.failed) {
    ph_fail_memory(&diag);
    complain(r, &diag);
    r->stopped = true;
  } else {
    if (ph_outlet_put(&r->outlet, slot->out.data, slot->out_end[n - 1]) !=
        PH_OK) {
      complain(r, &r->outlet.diag);
      r->stopped = true;
    }
    ph_buf_put(&r->message, slot->err.data, slot->err_end[n - 1]);
    collect_drawings(r, slot, n);
  }
  send(r);
  slot->state = SLOT_FREE;
  r->progress.all = r->input_ended && !r->current_left;
  r->progress.total = (double)r->progress.read * r->bytes /
                      (double)(r->split.passed + r->split.done);
  ph_progress_show(&r->progress);
  ph_outlet_next(&r->outlet, r->stopped);
}

/* Waits until the oldest slot is done, if `wait`; whether it is. */
static bool oldest_is_done(struct run *r, bool wait) {
  struct slot *slot = slot_at(r, r->outlet.turn);
  bool done;
  if (r->outlet.turn == r->filled) {
    return false;
  }
  pthread_mutex_lock(&r->outlet.lock);
  while (wait && slot->state != SLOT_DONE) {
    pthread_cond_wait(&r->outlet.changed, &r->outlet.lock);
  }
  done = slot->state == SLOT_DONE;
  pthread_mutex_unlock(&r->outlet.lock);
  return done;
}

static void pump(struct run *r) {
  while (!r->stopped) {
    bool room = r->filled - r->outlet.turn < r->slots_n;
    bool idle = r->filled == r->outlet.turn;
    if (room && (!r->input_ended || r->current_left) && fill_slot(r, idle)) {
      hand_over(r);
    } else if (idle && r->input_ended && !r->current_left) {
      return;
    } else if (oldest_is_done(r, true)) {
      write_slot(r, slot_at(r, r->outlet.turn));
      continue;
    }
    while (!r->stopped && oldest_is_done(r, false)) {
      write_slot(r, slot_at(r, r->outlet.turn));
    }
  }
}

/* ---- beginning and end ------------------------------------------------ */

static struct thread_start *start_threads(struct run *r) {
  size_t jobs = r->options->jobs;
  struct thread_start *starts;
  if (jobs < 2) {
    return NULL;
  }
  r->threads = ph_malloc(jobs * sizeof *r->threads);
  starts = ph_malloc(jobs * sizeof *starts);
  if (!r->threads || !starts) {
    return starts; /* one thread will do */
  }
  for (size_t i = 0; i < jobs; i++) {
    starts[i].run = r;
    starts[i].worker = &r->workers[i];
    if (pthread_create(&r->threads[i], NULL, worker_main, &starts[i]) != 0) {
      break;
    }
    r->threads_n++;
  }
  return starts;
}

static void stop_threads(struct run *r) {
  pthread_mutex_lock(&r->outlet.lock);
  r->quit = true;
  pthread_cond_broadcast(&r->outlet.changed);
  pthread_mutex_unlock(&r->outlet.lock);
  for (size_t i = 0; i < r->threads_n; i++) {
    pthread_join(r->threads[i], NULL);
  }
}

static bool allocate(struct run *r) {
  size_t jobs = r->options->jobs;
  r->slots_n = jobs * SLOTS_PER_JOB;
  r->slots = ph_malloc(r->slots_n * sizeof *r->slots);
  for (size_t i = 0; r->slots && i < r->slots_n; i++) {
    r->slots[i].state = SLOT_FREE;
    r->slots[i].n = 0;
    r->slots[i].text = r->slots[i].out = r->slots[i].err = (struct ph_buf){0};
  }
  r->workers = ph_malloc(jobs * sizeof *r->workers);
  if (r->workers) {
    memset(r->workers, 0, jobs * sizeof *r->workers);
    atomic_init(&r->spare, (int)jobs);
    for (size_t i = 0; i < jobs; i++) {
      r->workers[i].budget.spare = &r->spare;
    }
  }
  return r->slots && r->workers;
}

static void release(struct run *r) {
  for (size_t i = 0; r->slots && i < r->slots_n; i++) {
    for (size_t k = 0; k < r->slots[i].n; k++) {
      ph_drawing_free(r->slots[i].items[k].drawing);
      ph_free(r->slots[i].items[k].panorama);
    }
    ph_buf_free(&r->slots[i].text);
    ph_buf_free(&r->slots[i].out);
    ph_buf_free(&r->slots[i].err);
  }
  for (size_t i = 0; r->workers && i < r->options->jobs; i++) {
    ph_worker_free(&r->workers[i]);
  }
  ph_free(r->slots);
  ph_free(r->workers);
  ph_free(r->threads);
  ph_buf_free(&r->message);
  ph_document_free(&r->document);
  ph_split_free(&r->split);
  ph_pairing_free(&r->pairing);
  ph_plot_free(&r->plot);
  ph_output_discard(&r->output);
  ph_output_discard(&r->picture);
  ph_free(r->panorama);
}

/* The output ends as its format wants, also where not all was written. */
static void end_document(struct run *r) {
  struct ph_diag diag;
  if (r->class != PH_CLASS_OUTPUT &&
      ph_document_end(&r->document, &diag) != PH_OK) {
    complain(r, &diag);
  }
}

/* Results are complete: the figure. */
static void finish_plot(struct run *r) {
  const struct ph_plot *plot = &r->plot;
  struct ph_diag diag;
  if (ph_plot_write(&r->plot, &diag) != PH_OK) {
    complain(r, &diag);
  } else if (r->options->plot && plot->n < plot->solved && !r->options->quiet) {
    ph_message_printf(
        &r->message, "phspline: warning: --plot shows %zu of %zu %s\n", plot->n,
        plot->solved, r->options->sweeps_n ? "results" : "problems");
  }
}

/* A file gets its name when all results are in it: not after a failure of the
 * run itself, and not when --fail-fast broke off. */
static void conclude(struct run *r) {
  struct ph_diag diag;
  bool whole =
      r->class < PH_CLASS_OUTPUT && r->class != PH_CLASS_USAGE && !r->stopped;
  if ((whole || !r->output.temporary) && r->class != PH_CLASS_OUTPUT &&
      ph_output_commit(&r->output, &diag) != PH_OK) {
    complain(r, &diag);
  }
  if (whole && r->class < PH_CLASS_OUTPUT) {
    finish_plot(r);
    if (ph_panorama_write(r->options, r->panorama, &r->picture, &diag) !=
        PH_OK) {
      complain(r, &diag);
    }
  }
  if (r->progress.failed && !r->options->quiet) {
    ph_message_printf(&r->message, "phspline: %zu of %zu records failed\n",
                      r->progress.failed, r->progress.records);
  }
}

/* Files without any record are told. */
static void tell_empty(struct run *r) {
  const struct ph_options *o = r->options;
  if (o->input.part.how == PH_PART_ALL && r->split.empty.n > 0 && !o->quiet) {
    ph_message_empty(&r->message,
                     o->command->use == PH_USE_VERIFY ? "result" : "problem",
                     &r->split.empty, o->assignments_n > 0);
  }
}

/* Opens what is written, none of which may be what is read. */
static enum ph_status open_outputs(struct run *r, struct ph_diag *diag) {
  const struct ph_options *o = r->options;
  enum ph_status status =
      ph_output_open(&r->output, o->output, !o->no_sync, diag);
  r->output.if_changed = o->if_changed;
  if (status == PH_OK && o->problems) {
    status = ph_output_unlike(&r->output, o->problems, diag);
  }
  for (size_t i = 0; status == PH_OK && i < o->files_n; i++) {
    status = ph_output_unlike(&r->output, o->files[i], diag);
  }
  if (status == PH_OK) {
    status = ph_plot_open(&r->plot, o, diag);
  }
  return status == PH_OK && o->panorama
             ? ph_output_open(&r->picture, o->panorama, !o->no_sync, diag)
             : status;
}

int ph_run(const struct ph_options *options) {
  struct ph_options with = *options; /* ... the volume */
  const struct ph_options *o = &with;
  struct run r = {.options = o,
                  .output = {.descriptor = -1},
                  .picture = {.descriptor = -1},
                  .plot = {.output = {.descriptor = -1}},
                  .outlet = {.document = &r.document, .progress = &r.progress}};
  struct thread_start *starts = NULL;
  struct ph_diag diag;
  enum ph_status status;
  pthread_mutex_init(&r.outlet.lock, NULL);
  pthread_cond_init(&r.outlet.changed, NULL);
  r.bytes = ph_progress_bytes(o->files, o->files_n);
  ph_progress_init(&r.progress, o->progress, o->quiet);
  status = ph_split_init(&r.split, o->files, o->files_n, &o->input,
                         o->command->schema, &diag);
  if (o->input.part.how != PH_PART_ALL) { /* as far as it is in the files */
    r.bytes = fmin((double)r.split.options.part.end, r.bytes) -
              fmin((double)r.split.options.part.begin, r.bytes);
  }
  if (status == PH_OK && !allocate(&r)) {
    status = ph_fail_memory(&diag);
  }
  if (status == PH_OK && o->volume_file) {
    status = ph_nrrd_read(o->volume_file, o->max_memory, &with.volume, &diag);
  }
  if (status == PH_OK) {
    status = open_outputs(&r, &diag);
  }
  if (status == PH_OK) {
    status = ph_document_begin(&r.document, o, &r.output, &diag);
  }
  if (status == PH_OK) {
    starts = start_threads(&r);
    pump(&r);
    stop_threads(&r);
    if (r.input_failed && !r.stopped) {
      complain(&r, &r.input_failure);
    }
    finish_pairing(&r);
    tell_empty(&r);
    end_document(&r);
    ph_progress_finish(&r.progress);
    conclude(&r);
  } else {
    complain(&r, &diag);
  }
  send(&r);
  ph_free(starts);
  release(&r);
  ph_nrrd_free(&with.volume);
  pthread_cond_destroy(&r.outlet.changed);
  pthread_mutex_destroy(&r.outlet.lock);
  return (int)r.class;
}
