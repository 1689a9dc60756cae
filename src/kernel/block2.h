/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Real block tridiagonal and cyclic block tridiagonal systems with blocks of
 * 2 x 2, by Gaussian elimination with partial pivoting, in one pass over rows
 * that the caller makes as it goes: O(n) time, 56 bytes a block row (more in
 * the part that the corner blocks reach or where rows are interchanged), no
 * matrix in memory.
 *
 *   row i:   lo x[i-1] + di x[i] + up x[i+1] = f,   indices modulo n
 *
 * x[i] and f have two elements; blocks are stored by rows.  An open system is
 * one whose corner blocks, lo of row 0 and up of row n-1, are zero: one code
 * path serves both.  With n = 2, lo and up of a row both act on the other
 * unknown; with n = 1, on the same one as di.
 *
 * Method (that of kernel/tri.h).  When the two columns of block k are
 * eliminated, six scalar rows can hold them:
 *   near   what is left of the rows above,           blocks k, k+1, n-2, n-1
 *   row    the new block row k+1,                    blocks k, k+1, k+2
 *   last   the last block row, for its corner block, blocks k, k+1, n-2, n-1
 * The pivot of each column is the largest of its entries in all of them, each
 * measured in the largest entry that its row had at first, as in a scalar band
 * matrix: neither a singular diagonal block nor rows of different sizes do
 * harm.  (Elimination by blocks, with pivoting inside them only, would divide
 * by a singular block.)  Both pivot rows are divided by their pivots; their
 * fill stays inside blocks k+1, k+2, n-2, n-1.  The last four blocks are solved
 * densely.
 *
 * What lies in blocks n-2 and n-1 of the near rows and outside them in the
 * last row decays geometrically along a matrix that is anything like
 * diagonally dominant.  Below 1e-32 of the rest of its row it is dropped, and
 * from there on a cyclic row costs what an open one does.
 */
#ifndef PH_KERNEL_BLOCK2_H
#define PH_KERNEL_BLOCK2_H

#include "base/mem.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct ph_block2_row {
  double lo[4], di[4], up[4], f[2];
};

/* A scalar row under elimination: blocks k and k+1, its right-hand side, blocks
 * n-2 and n-1, and the largest entry that the row had at first. */
struct ph_block2_active {
  double c0[2], c1[2], f, e[2], l[2], size;
};

/* The pivot rows of block k, both divided by their pivots:
 *   x0 + u x1 + a . x[k+1] = fa,   x1 + b . x[k+1] = fb */
struct ph_block2_pivot {
  double u, a[2], b[2], fa, fb;
};

/* Their entries in block k+2, where a new row became one of them. */
struct ph_block2_fill {
  size_t k;
  double a[2], b[2];
};

/* Their entries in blocks n-2 and n-1. */
struct ph_block2_far {
  double a[4], b[4];
};

struct ph_block2 {
  size_t n;      /* block rows */
  size_t k;      /* blocks eliminated so far */
  size_t stop;   /* blocks before the dense tail: n - min(n, 4) */
  size_t far_n;  /* pivot rows that have entries in blocks n-2, n-1 */
  size_t fill_n; /* pivot rows that have some in block k+2 */
  bool last_far; /* the last rows' entries in blocks k, k+1 still matter */
  bool near_far; /* so do the near rows' entries in blocks n-2, n-1 */
  struct ph_block2_active near[2], last[2];
  struct ph_block2_row tail[2];
  size_t tail_n;
  struct ph_block2_pivot *pivot; /* [n] */
  struct ph_block2_far *far;     /* [n], valid below far_n */
  struct ph_block2_fill *fill;   /* [n], valid below fill_n, k increasing */
};

/*
 * ph_block2_alloc: workspace for systems of up to n block rows, from an arena.
 *
 * ret  false when memory is exhausted
 */
bool ph_block2_alloc(struct ph_block2 *t, struct ph_arena *arena, size_t n);

/* ph_block2_begin: starts a system of n >= 1 block rows with its rows 0 and
 * n-1, which are the same row where n = 1. */
void ph_block2_begin(struct ph_block2 *t, size_t n,
                     const struct ph_block2_row *first,
                     const struct ph_block2_row *last);

/* ph_block2_push_any: ph_block2_push for every case. */
void ph_block2_push_any(struct ph_block2 *t, const struct ph_block2_row *row);

/* ph_block2_size: the largest entry of scalar row i of a block row. */
static inline double ph_block2_size(const struct ph_block2_row *row, int i) {
  double size = 0;
  for (int j = 2 * i; j < 2 * i + 2; j++) {
    size = fabs(row->lo[j]) > size ? fabs(row->lo[j]) : size;
    size = fabs(row->di[j]) > size ? fabs(row->di[j]) : size;
    size = fabs(row->up[j]) > size ? fabs(row->up[j]) : size;
  }
  return size;
}

/* ph_block2_push: the next row: 1, 2, ..., n-2. */
static inline void ph_block2_push(struct ph_block2 *t,
                                  const struct ph_block2_row *row) {
  const double *lo = row->lo;
  const struct ph_block2_active *p = &t->near[0], *q = &t->near[1];
  const double size[2] = {ph_block2_size(row, 0), ph_block2_size(row, 1)};
  double inverse = 1 / p->c0[0], m = q->c0[0] * inverse;
  double u = p->c0[1] * inverse, v = q->c0[1] - m * p->c0[1];
  const double d[2] = {lo[1] - lo[0] * u, lo[3] - lo[2] * u};
  double first = fabs(p->c0[0]), second = fabs(v);
  struct ph_block2_pivot pivot;
  if (t->last_far || t->near_far || t->k == t->stop ||
      !(first * q->size >= fabs(q->c0[0]) * p->size &&
        first * size[0] >= fabs(lo[0]) * p->size &&
        first * size[1] >= fabs(lo[2]) * p->size &&
        second * size[0] >= fabs(d[0]) * q->size &&
        second * size[1] >= fabs(d[1]) * q->size)) {
    ph_block2_push_any(t, row);
    return;
  }
  /* The near rows have both pivots in their order, as nearly always. */
  v = 1 / v;
  pivot.u = u;
  pivot.a[0] = p->c1[0] * inverse;
  pivot.a[1] = p->c1[1] * inverse;
  pivot.fa = p->f * inverse;
  pivot.b[0] = (q->c1[0] - m * p->c1[0]) * v;
  pivot.b[1] = (q->c1[1] - m * p->c1[1]) * v;
  pivot.fb = (q->f - m * p->f) * v;
  for (int i = 0; i < 2; i++) {
    const double c = lo[2 * i];
    struct ph_block2_active *near = &t->near[i];
    near->c0[0] = row->di[2 * i] - c * pivot.a[0] - d[i] * pivot.b[0];
    near->c0[1] = row->di[2 * i + 1] - c * pivot.a[1] - d[i] * pivot.b[1];
    near->f = row->f[i] - c * pivot.fa - d[i] * pivot.fb;
    near->c1[0] = row->up[2 * i];
    near->c1[1] = row->up[2 * i + 1];
    near->size = size[i];
  }
  t->pivot[t->k++] = pivot;
}

/*
 * ph_block2_finish: the solution, after all n rows; may be called again.
 *
 * out  x[n]   not finite where the matrix is singular: the caller tests
 */
void ph_block2_finish(const struct ph_block2 *t, double (*x)[2]);

#endif
