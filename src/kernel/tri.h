/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Complex tridiagonal and cyclic tridiagonal systems, by Gaussian elimination
 * with partial pivoting, in one pass over rows that the caller makes as it
 * goes: O(n) time, 32 bytes an unknown (64 in the part that the corner entries
 * reach or where rows are interchanged), no matrix in memory.
 *
 *   row i:   lo x[i-1] + di x[i] + up x[i+1] = f,   indices modulo n
 *
 * An open (tridiagonal) system is one whose corner entries, lo of row 0 and
 * up of row n-1, are zero: one code path serves both.
 *
 * Method.  When column k is eliminated, three rows can hold it:
 *   near   what is left of the rows above,           columns k, k+1, n-2, n-1
 *   last   the last row, for its corner entry,       columns k, k+1, n-2, n-1
 *   row    the new row k+1,                          columns k, k+1, k+2
 * The one with the largest entry in column k becomes pivot row k, divided by
 * that entry, so that its fill stays inside columns k+1, k+2, n-2, n-1.  The
 * last four unknowns are solved densely.  (Ordering the unknowns 1, n, 2, n-1,
 * ... and factoring the resulting band does the same at twice the work; the
 * Sherman-Morrison formula can meet a singular core although the matrix is
 * regular.)
 *
 * The corner entries decay geometrically along a matrix that is anything like
 * diagonally dominant.  Once they are below NEGLIGIBLE of their neighbours
 * they are dropped, a change of the matrix far below rounding, and from there
 * on a cyclic row costs what an open one does.
 */
#ifndef PH_KERNEL_TRI_H
#define PH_KERNEL_TRI_H

#include "base/mem.h"
#include "kernel/cplx.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_tri_row {
  ph_cplx lo, di, up, f;
};

/* A row under elimination: entries in columns k, k+1, n-2, n-1. */
struct ph_tri_active {
  ph_cplx c0, c1, e, l, f;
};

/* A pivot row k, divided by its pivot: the entry in column k+1. */
struct ph_tri_pivot {
  ph_cplx c1, f;
};

/* The entry in column k+2 of a pivot row that was not `near` or `last`. */
struct ph_tri_fill {
  size_t k;
  ph_cplx c2;
};

struct ph_tri {
  size_t n;      /* unknowns */
  size_t k;      /* columns eliminated so far */
  size_t stop;   /* columns before the dense tail: n - min(n, 4) */
  size_t far_n;  /* pivot rows that have entries in columns n-2, n-1 */
  size_t fill_n; /* pivot rows that have one in column k+2 */
  bool last_far; /* the last row's corner entry still matters */
  bool near_far; /* so do the near row's entries in columns n-2, n-1 */
  struct ph_tri_active near, last;
  struct ph_tri_row tail[2];
  size_t tail_n;
  struct ph_tri_pivot *pivot; /* [n] */
  ph_cplx *far;               /* [n][2], valid below far_n */
  struct ph_tri_fill *fill;   /* [n], valid below fill_n, k increasing */
};

/*
 * ph_tri_alloc: workspace for systems of up to n unknowns, from an arena.
 *
 * ret  false when memory is exhausted
 */
bool ph_tri_alloc(struct ph_tri *t, struct ph_arena *arena, size_t n);

/* ph_tri_begin: starts a system of n >= 3 unknowns with its rows 0 and n-1. */
void ph_tri_begin(struct ph_tri *t, size_t n, struct ph_tri_row first,
                  struct ph_tri_row last);

/* ph_tri_push_any: ph_tri_push for every case. */
void ph_tri_push_any(struct ph_tri *t, const struct ph_tri_row *row);

/* ph_tri_push: the next row: 1, 2, ..., n-2. */
static inline void ph_tri_push(struct ph_tri *t, const struct ph_tri_row *row) {
  ph_cplx c0 = t->near.c0, c1 = t->near.c1, conj = ph_cplx_conj(c0);
  double size2 = ph_cplx_norm2(c0), inverse2;
  if (t->last_far || t->near_far || t->k == t->stop ||
      !(size2 >= ph_cplx_norm2(row->lo))) {
    ph_tri_push_any(t, row);
    return;
  }
  /* c0 is the pivot, as nearly always.  The next c0 waits for this one: the
   * quotient is formed last, from a product that did not have to wait. */
  inverse2 = 1 / size2;
  t->near.c0 = ph_cplx_sub(
      row->di,
      ph_cplx_scale(inverse2, ph_cplx_mul(ph_cplx_mul(row->lo, c1), conj)));
  conj = ph_cplx_scale(inverse2, conj);
  t->pivot[t->k].c1 = ph_cplx_mul(c1, conj);
  t->pivot[t->k].f = ph_cplx_mul(t->near.f, conj);
  t->near.c1 = row->up;
  t->near.f = ph_cplx_sub(row->f, ph_cplx_mul(row->lo, t->pivot[t->k].f));
  t->k++;
}

/*
 * ph_tri_finish: the solution, after all n rows; may be called again.
 *
 * out  x[n]   not finite where the matrix is singular: the caller tests
 */
void ph_tri_finish(struct ph_tri *t, ph_cplx *x);

/* ph_tri_finish_here: the same, once, in the place of the right-hand side:
 * x[k] is t->pivot[k].f. */
void ph_tri_finish_here(struct ph_tri *t);

#endif
