/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Complex tridiagonal and cyclic tridiagonal systems, by Gaussian elimination
 * with partial pivoting, in one pass over rows that the caller makes as it
 * goes: O(n) time, 64 bytes an unknown (96 in the part that the corner
 * entries reach), no matrix in memory.
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
 * The one with the largest entry in column k becomes pivot row k, so that its
 * fill stays inside columns k+1, k+2, n-2, n-1.  The last four unknowns are
 * solved densely.  (Ordering the unknowns 1, n, 2, n-1, ... and factoring the
 * resulting band does the same at twice the work; the Sherman-Morrison formula
 * can meet a singular core although the matrix is regular.)
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

/* A finished pivot row: 1/pivot, entries in columns k+1 and k+2. */
struct ph_tri_pivot {
  ph_cplx inverse, c1, c2, f;
};

struct ph_tri {
  size_t n;      /* unknowns */
  size_t k;      /* columns eliminated so far */
  size_t stop;   /* columns before the dense tail: n - min(n, 4) */
  size_t far_n;  /* pivot rows that have entries in columns n-2, n-1 */
  bool last_far; /* the last row's corner entry still matters */
  bool near_far; /* so do the near row's entries in columns n-2, n-1 */
  struct ph_tri_active near, last;
  struct ph_tri_row tail[2];
  size_t tail_n;
  struct ph_tri_pivot *pivot; /* [n] */
  ph_cplx *far;               /* [n][2], valid below far_n */
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

/* ph_tri_push_far: ph_tri_push where a corner entry takes part. */
void ph_tri_push_far(struct ph_tri *t, const struct ph_tri_row *row);

/* ph_tri_push: the next row: 1, 2, ..., n-2. */
static inline void ph_tri_push(struct ph_tri *t, const struct ph_tri_row *row) {
  struct ph_tri_pivot *p = &t->pivot[t->k];
  ph_cplx c0 = t->near.c0;
  if (t->k == t->stop) {
    t->tail[t->tail_n++] = *row;
    return;
  }
  if (t->last_far || t->near_far) {
    ph_tri_push_far(t, row);
    return;
  }
  t->k++;
  if (ph_cplx_norm2(c0) >= ph_cplx_norm2(row->lo)) {
    ph_cplx inverse = ph_cplx_inverse(c0);
    ph_cplx m = ph_cplx_mul(row->lo, inverse);
    p->inverse = inverse;
    p->c1 = t->near.c1;
    p->c2 = ph_cplx_of(0, 0);
    p->f = t->near.f;
    t->near.c0 = ph_cplx_sub(row->di, ph_cplx_mul(m, p->c1));
    t->near.c1 = row->up;
    t->near.f = ph_cplx_sub(row->f, ph_cplx_mul(m, p->f));
  } else {
    ph_cplx m = ph_cplx_mul(c0, ph_cplx_inverse(row->lo));
    p->inverse = ph_cplx_inverse(row->lo);
    p->c1 = row->di;
    p->c2 = row->up;
    p->f = row->f;
    t->near.c0 = ph_cplx_sub(t->near.c1, ph_cplx_mul(m, p->c1));
    t->near.c1 = ph_cplx_scale(-1, ph_cplx_mul(m, p->c2));
    t->near.f = ph_cplx_sub(t->near.f, ph_cplx_mul(m, p->f));
  }
}

/*
 * ph_tri_finish: the solution, after all n rows.
 *
 * out  x[n]   not finite where the matrix is singular: the caller tests
 */
void ph_tri_finish(struct ph_tri *t, ph_cplx *x);

#endif
