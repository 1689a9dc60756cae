/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The matrix [H J^T; J D] of a curve under constraints: H the Hessian of
 * F + y . c by the unknowns, which are the nodes of check/spinor.h and, of a
 * closed curve, the phase chi at its seam; J the gradients of the rows c.
 *
 * Unknowns and rows are numbered along the curve, those of a closed one from
 * the seam in both directions at once, so that what belongs together is within
 * a band; chi is the first of them, and rows follow the last of their nodes.
 */
#ifndef PH_CHECK_KKT_H
#define PH_CHECK_KKT_H

#include "check/spinor.h"
#include "kernel/band.h"

#include <stdint.h>

struct ph_kkt {
  struct ph_spinor spline;
  size_t rows;
  uint32_t *node; /* [stored] place of its first component */
  uint32_t *row;  /* [rows] place */
  bool *is_row;   /* [n] whether a place is of a row */
  size_t n, band; /* places, and the half bandwidth */
  double *matrix; /* symmetric band matrix of n rows */
  double *g;      /* [n] gradient of F; 0 at rows */
  double *y;      /* [n] multipliers, at the places of the rows */
};

/* ph_kkt_at: the element (i, j) of the matrix, within the band. */
static inline double *ph_kkt_at(const struct ph_kkt *kkt, size_t i, size_t j) {
  return i > j ? ph_sym_at(kkt->matrix, kkt->band, i, j)
               : ph_sym_at(kkt->matrix, kkt->band, j, i);
}

/* ph_kkt_first, ph_kkt_end: the places that may be coupled to place i. */
static inline size_t ph_kkt_first(const struct ph_kkt *kkt, size_t i) {
  return i > kkt->band ? i - kkt->band : 0;
}

static inline size_t ph_kkt_end(const struct ph_kkt *kkt, size_t i) {
  return i + kkt->band < kkt->n ? i + kkt->band + 1 : kkt->n;
}

/* ph_kkt_has_chi: whether the phase at the seam is unknown: place 0. */
static inline bool ph_kkt_has_chi(const struct ph_kkt *kkt) {
  return kkt->spline.stored == kkt->spline.segments;
}

/* ph_kkt_stored: the stored node that a node is, or repeats. */
static inline size_t ph_kkt_stored(const struct ph_kkt *kkt, size_t node) {
  return node < kkt->spline.stored ? node : node - kkt->spline.segments;
}

/* ph_kkt_of: g, and the matrix with J alone; y = 0.  The spline is given.
 * ret  false when memory is exhausted */
bool ph_kkt_of(struct ph_kkt *kkt, struct ph_arena *arena);

/* ph_kkt_add_hessian: adds H. */
void ph_kkt_add_hessian(struct ph_kkt *kkt);

#endif
