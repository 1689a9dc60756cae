/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves from solutions of the C2 equations (see planar.h): first preimages and
 * lengths, then the control points, so that what only preimages are found from
 * need not be there beside these.
 */
#include "solve/planar/planar.h"

#include "base/sum.h"
#include "base/team.h"
#include "curve/segment/seg2.h"
#include "kernel/pi.h"

#include <math.h>
#include <stdatomic.h>
#include <stdint.h>
#include <string.h>

/* Segments that are filled together; so many, 1 ms, are worth another thread.
 */
enum { PART = 1024, WORTH = 8192 };

enum ph_status ph_planar_curve_alloc(const struct ph_planar_data *d,
                                     struct ph_arena *arena,
                                     struct ph_curve *curve,
                                     struct ph_diag *diag) {
  *curve = (struct ph_curve){.kind = d->atph ? PH_CURVE_ATPH : PH_CURVE_PH,
                             .closed = d->closed,
                             .dimension = 2,
                             .joined = true,
                             .degree = 5,
                             .n = d->n,
                             .preimage.n = 3,
                             .preimage.dimension = 2};
  return ph_curve_alloc(curve, arena, diag);
}

/* Whether a segment stands still (NaN), or turns by more than half a turn. */
static inline bool has_loop(const struct ph_atph *space, const ph_cplx w[3],
                            double *angle) {
  struct ph_seg2 seg;
  if (ph_seg2_moves_on(w)) {
    return false;
  }
  seg = (struct ph_seg2){*space, {w[0], w[1], w[2]}, {0, 0}, {0, 0}};
  *angle = ph_seg2_stands_still(&seg, NULL) ? (double)NAN
           : ph_seg2_is_monotone(w)         ? 0
                                            : ph_seg2_rotation(&seg, NULL);
  return !(fabs(*angle) <= PH_PI);
}

/* Segment k of the preimage w with respect to u in [0,1], in the root of the
 * user's unit. */
static inline void fill_root(size_t k, const struct ph_atph *space,
                             const ph_cplx w[3], struct ph_curve *curve) {
  curve->lengths[k] = ph_seg2_length(space, w);
  if (curve->preimage.alpha) {
    curve->preimage.alpha[k] = space->angle;
  }
  memcpy(curve->preimage.v + 6 * k, w, 3 * sizeof *w);
}

/* The control points of segment k, the last of which are the first of the next
 * one; and the preimage of an atph curve with respect to t, as it is written.
 */
static inline void fill_points(const struct ph_planar_data *d, size_t k,
                               struct ph_curve *curve) {
  const struct ph_atph *space = ph_planar_space(&d->c2, k);
  const size_t last = k + 1 == d->n;
  double *v = curve->preimage.v + 6 * k;
  ph_cplx w[3], p[6];
  memcpy(w, v, sizeof w);
  ph_seg2_control_points(space, w, ph_planar_point(d, k),
                         ph_planar_point(d, k + 1), p);
  memcpy(curve->control_points + ph_curve_stride(curve) * k, p,
         (5 + last) * sizeof *p);
  if (d->atph) {
    for (int i = 0; i < 3; i++) {
      w[i] = ph_cplx_scale(1 / sqrt(space->angle), w[i]);
    }
    memcpy(v, w, sizeof w);
  }
}

/* A curve that is being filled. */
struct filling {
  const struct ph_planar_data *data;
  const ph_cplx *b;
  struct ph_curve *curve;
  atomic_size_t loops, first_loop;
};

static void note_loop(struct filling *f, size_t k) {
  size_t first = atomic_load(&f->first_loop);
  atomic_fetch_add(&f->loops, 1);
  while (k < first &&
         !atomic_compare_exchange_weak(&f->first_loop, &first, k)) {
  }
}

static bool fill_roots(void *context, size_t thread, size_t begin, size_t end) {
  struct filling *f = context;
  const struct ph_planar_data *d = f->data;
  const struct ph_planar_c2 *c2 = &d->c2;
  const ph_cplx *mine = d->closed ? f->b : f->b + 1;
  const double root = ldexp(1, -d->exponent / 2);
  ph_cplx w[3];
  double angle;
  (void)thread;
  for (size_t k = begin; k < end; k++) {
    const struct ph_atph *space = ph_planar_space(c2, k);
    const double size = root * sqrt(d->h[k]);
    ph_cplx scaled[3];
    if (k > begin && k + 1 < d->n) { /* half of it: of the segment before */
      w[0] = w[2];
      w[1] = mine[k];
      w[2] = ph_planar_at_knot(c2->y[k + 1], mine[k], mine[k + 1]);
    } else {
      ph_planar_preimage(c2, f->b, k, w);
    }
    if (has_loop(space, w, &angle)) {
      note_loop(f, k);
    }
    for (int i = 0; i < 3; i++) {
      scaled[i] = ph_cplx_scale(size, w[i]);
    }
    fill_root(k, space, scaled, f->curve);
  }
  return true;
}

void ph_planar_curve_roots(const struct ph_planar_data *d, const ph_cplx *b,
                           const struct ph_arena *arena, struct ph_curve *curve,
                           struct ph_planar_loops *loops) {
  struct filling f = {.data = d, .b = b, .curve = curve};
  struct ph_sum length = {0, 0};
  atomic_init(&f.loops, 0);
  atomic_init(&f.first_loop, SIZE_MAX);
  memcpy(curve->knots, d->knots, (d->n + 1) * sizeof *d->knots);
  ph_team_share(arena, d->n, WORTH, PART, fill_roots, &f);
  for (size_t k = 0; k < d->n; k++) {
    ph_sum_add(&length, curve->lengths[k]);
  }
  curve->length = ph_sum_value(&length);
  *loops = (struct ph_planar_loops){atomic_load(&f.loops), 0, 0};
  if (loops->n > 0) {
    ph_cplx w[3];
    loops->first = atomic_load(&f.first_loop);
    ph_planar_preimage(&d->c2, b, loops->first, w);
    (void)has_loop(ph_planar_space(&d->c2, loops->first), w, &loops->angle);
  }
}

static bool fill_some(void *context, size_t thread, size_t begin, size_t end) {
  const struct filling *f = context;
  (void)thread;
  for (size_t k = begin; k < end; k++) {
    fill_points(f->data, k, f->curve);
  }
  return true;
}

void ph_planar_curve_points(const struct ph_planar_data *d,
                            const struct ph_arena *arena,
                            struct ph_curve *curve) {
  struct filling f = {.data = d, .curve = curve};
  ph_team_share(arena, d->n, WORTH, PART, fill_some, &f);
}

void ph_planar_curve_fill(const struct ph_planar_data *d, const ph_cplx *b,
                          const struct ph_arena *arena, struct ph_curve *curve,
                          struct ph_planar_loops *loops) {
  ph_planar_curve_roots(d, b, arena, curve, loops);
  ph_planar_curve_points(d, arena, curve);
}
