/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cyclic block tridiagonal elimination (method in block2.h): the steps in
 * which rows are interchanged or a corner block takes part, the dense tail,
 * and back substitution.
 */
#include "kernel/block2.h"

#include <string.h>

/* Columns of a scalar row in a step: its size, blocks k, k+1, k+2, the
 * right-hand side, blocks n-2 and n-1.  Those from E on are empty in all rows
 * but far ones. */
enum { SIZE = 0, C0 = 1, C1 = 3, C2 = 5, F = 7, E = 8, L = 10, WIDTH = 12 };

/* Rows of a step. */
enum { NEAR = 0, NEW = 2, LAST = 4, ROWS = 6 };

/* Blocks and scalars of the dense tail. */
enum { TAIL = 4, TAIL2 = 2 * TAIL, TAIL_WIDTH = TAIL2 + 2 };

/* 1e-32 is eps^2: even unknowns whose scales differ by 1e16 do not feel it. */
static const double NEGLIGIBLE = 1e-32;

bool ph_block2_alloc(struct ph_block2 *t, struct ph_arena *arena, size_t n) {
  t->pivot = ph_arena_array(arena, n, sizeof *t->pivot);
  t->far = ph_arena_array(arena, n, sizeof *t->far);
  t->fill = ph_arena_array(arena, n, sizeof *t->fill);
  return t->pivot && t->far && t->fill;
}

static bool is_zero(const double block[4]) {
  return fabs(block[0]) <= 0 && fabs(block[1]) <= 0 && fabs(block[2]) <= 0 &&
         fabs(block[3]) <= 0;
}

void ph_block2_begin(struct ph_block2 *t, size_t n,
                     const struct ph_block2_row *first,
                     const struct ph_block2_row *last) {
  t->n = n;
  t->k = 0;
  t->stop = n > TAIL ? n - TAIL : 0;
  t->far_n = 0;
  t->fill_n = 0;
  t->tail_n = 0;
  for (int i = 0; i < 2; i++) {
    struct ph_block2_active *a = &t->near[i], *z = &t->last[i];
    a->f = first->f[i];
    z->f = last->f[i];
    a->size = ph_block2_size(first, i);
    z->size = ph_block2_size(last, i);
    for (int j = 0; j < 2; j++) {
      a->c0[j] = first->di[2 * i + j];
      a->c1[j] = first->up[2 * i + j];
      a->e[j] = 0;
      a->l[j] = first->lo[2 * i + j];
      z->c0[j] = last->up[2 * i + j];
      z->c1[j] = 0;
      z->e[j] = last->lo[2 * i + j];
      z->l[j] = last->di[2 * i + j];
    }
  }
  t->near_far = !is_zero(first->lo);
  t->last_far = !is_zero(last->up);
}

/* ---- a step in general --------------------------------------------------- */

static void spread(const struct ph_block2_active *a, double w[WIDTH]) {
  for (int j = 0; j < 2; j++) {
    w[C0 + j] = a->c0[j];
    w[C1 + j] = a->c1[j];
    w[C2 + j] = 0;
    w[E + j] = a->e[j];
    w[L + j] = a->l[j];
  }
  w[F] = a->f;
  w[SIZE] = a->size;
}

static void spread_row(const struct ph_block2_row *row, int i,
                       double w[WIDTH]) {
  for (int j = 0; j < 2; j++) {
    w[C0 + j] = row->lo[2 * i + j];
    w[C1 + j] = row->di[2 * i + j];
    w[C2 + j] = row->up[2 * i + j];
    w[E + j] = w[L + j] = 0;
  }
  w[F] = row->f[i];
  w[SIZE] = ph_block2_size(row, i);
}

/* A row without its columns of block k: the window moves on by a block. */
static void gather(const double w[WIDTH], struct ph_block2_active *a) {
  for (int j = 0; j < 2; j++) {
    a->c0[j] = w[C1 + j];
    a->c1[j] = w[C2 + j];
    a->e[j] = w[E + j];
    a->l[j] = w[L + j];
  }
  a->f = w[F];
  a->size = w[SIZE];
}

static void swap_rows(double *a, double *b, size_t n) {
  for (size_t c = 0; c < n; c++) {
    double keep = a[c];
    a[c] = b[c];
    b[c] = keep;
  }
}

/* Brings the largest entry of unknown k, in units of its row's size, from rows
 * k, k+1, ... into row k, divides that row by it, and clears it below.  Element
 * 0 of a row is its size, element 1 that of unknown 0. */
static void eliminate(double *w, size_t width, size_t rows, size_t columns,
                      size_t k) {
  double *top = w + k * width, *best = top, inverse;
  for (size_t r = k + 1; r < rows; r++) {
    double *row = w + r * width;
    if (fabs(row[k + 1]) * best[SIZE] > fabs(best[k + 1]) * row[SIZE]) {
      best = row;
    }
  }
  if (best != top) {
    swap_rows(top, best, columns);
  }
  inverse = 1 / top[k + 1];
  for (size_t c = k + 2; c < columns; c++) {
    top[c] *= inverse;
  }
  for (size_t r = k + 1; r < rows; r++) {
    double *row = w + r * width, m = row[k + 1];
    for (size_t c = k + 2; c < columns; c++) {
      row[c] -= m * top[c];
    }
  }
}

/* Keeps the pivot rows of block k. */
static void store(struct ph_block2 *t, const double a[WIDTH],
                  const double b[WIDTH]) {
  struct ph_block2_pivot *p = &t->pivot[t->k];
  const double c2[4] = {a[C2], a[C2 + 1], b[C2], b[C2 + 1]};
  p->u = a[C0 + 1];
  p->fa = a[F];
  p->fb = b[F];
  memcpy(p->a, a + C1, sizeof p->a);
  memcpy(p->b, b + C1, sizeof p->b);
  if (t->last_far || t->near_far) {
    memcpy(t->far[t->k].a, a + E, sizeof t->far[t->k].a);
    memcpy(t->far[t->k].b, b + E, sizeof t->far[t->k].b);
    t->far_n = t->k + 1;
  }
  if (!is_zero(c2)) {
    struct ph_block2_fill *fill = &t->fill[t->fill_n++];
    fill->k = t->k;
    memcpy(fill->a, a + C2, sizeof fill->a);
    memcpy(fill->b, b + C2, sizeof fill->b);
  }
}

/* Drops what has decayed, so that later steps need not look at it. */
static void drop_negligible(struct ph_block2 *t) {
  bool last_far = false, near_far = false;
  for (int i = 0; i < 2; i++) {
    const struct ph_block2_active *a = &t->near[i], *z = &t->last[i];
    double inner = fabs(a->c0[0]) + fabs(a->c0[1]);
    double outer = fabs(a->e[0]) + fabs(a->e[1]) + fabs(a->l[0]);
    double corner = fabs(z->c0[0]) + fabs(z->c0[1]) + fabs(z->c1[0]);
    double own = fabs(z->e[0]) + fabs(z->e[1]) + fabs(z->l[0]);
    inner += fabs(a->c1[0]) + fabs(a->c1[1]);
    outer += fabs(a->l[1]);
    corner += fabs(z->c1[1]);
    own += fabs(z->l[1]);
    near_far = near_far || !(outer <= NEGLIGIBLE * inner);
    last_far = last_far || !(corner <= NEGLIGIBLE * own);
  }
  for (int i = 0; i < 2; i++) {
    struct ph_block2_active *a = &t->near[i], *z = &t->last[i];
    for (int j = 0; j < 2; j++) {
      a->e[j] = near_far ? a->e[j] : 0;
      a->l[j] = near_far ? a->l[j] : 0;
      z->c0[j] = last_far ? z->c0[j] : 0;
      z->c1[j] = last_far ? z->c1[j] : 0;
    }
  }
  t->near_far = near_far;
  t->last_far = last_far;
}

void ph_block2_push_any(struct ph_block2 *t, const struct ph_block2_row *row) {
  double w[ROWS][WIDTH];
  const bool far = t->near_far || t->last_far;
  const size_t rows = t->last_far ? ROWS : LAST;
  const size_t columns = far ? WIDTH : E;
  if (t->k == t->stop) {
    t->tail[t->tail_n++] = *row;
    return;
  }
  for (int i = 0; i < 2; i++) {
    spread(&t->near[i], w[NEAR + i]);
    spread_row(row, i, w[NEW + i]);
    spread(&t->last[i], w[LAST + i]);
  }
  eliminate(w[0], WIDTH, rows, columns, 0);
  eliminate(w[0], WIDTH, rows, columns, 1);
  store(t, w[0], w[1]);
  for (int i = 0; i < 2; i++) {
    gather(w[NEW + i], &t->near[i]);
    gather(w[LAST + i], &t->last[i]);
  }
  t->k++;
  if (far) {
    drop_negligible(t);
  }
}

/* ---- the end ------------------------------------------------------------- */

/* Adds a row of a block to the scalar row `row`, at block c. */
static void add(double *row, size_t c, const double half[2]) {
  row[2 * c + 1] += half[0];
  row[2 * c + 2] += half[1];
}

/* The scalar rows of the tail's m blocks: size, unknowns, right-hand side. */
static void gather_tail(const struct ph_block2 *t, size_t m,
                        double a[TAIL2][TAIL_WIDTH]) {
  memset(a, 0, TAIL2 * sizeof a[0]);
  for (size_t i = 0; i < 2; i++) {
    const struct ph_block2_active *active[2] = {&t->near[i], &t->last[i]};
    for (size_t r = 0; r < (m > 1 ? 2 : 1); r++) {
      double *row = a[r == 0 ? i : 2 * m - 2 + i];
      row[SIZE] = active[r]->size;
      add(row, 0, active[r]->c0);
      add(row, m > 1 ? 1 : 0, active[r]->c1);
      add(row, m > 1 ? m - 2 : 0, active[r]->e);
      add(row, m - 1, active[r]->l);
      row[2 * m + 1] = active[r]->f;
    }
    for (size_t r = 0; r + 2 < m; r++) {
      double *row = a[2 * r + 2 + i];
      row[SIZE] = ph_block2_size(&t->tail[r], (int)i);
      add(row, r, &t->tail[r].lo[2 * i]);
      add(row, r + 1, &t->tail[r].di[2 * i]);
      add(row, r + 2, &t->tail[r].up[2 * i]);
      row[2 * m + 1] = t->tail[r].f[i];
    }
  }
}

static void solve_tail(double a[TAIL2][TAIL_WIDTH], size_t m, double (*x)[2]) {
  for (size_t k = 0; k < 2 * m; k++) {
    eliminate(a[0], TAIL_WIDTH, 2 * m, 2 * m + 2, k);
  }
  for (size_t k = 2 * m; k-- > 0;) {
    double sum = a[k][2 * m + 1];
    for (size_t c = k + 1; c < 2 * m; c++) {
      sum -= a[k][c + 1] * x[c / 2][c % 2];
    }
    x[k / 2][k % 2] = sum;
  }
}

static double dot(const double a[2], const double x[2]) {
  return a[0] * x[0] + a[1] * x[1];
}

void ph_block2_finish(const struct ph_block2 *t, double (*x)[2]) {
  double a[TAIL2][TAIL_WIDTH], next[2];
  const size_t m = t->n - t->stop;
  size_t fill_n = t->fill_n;
  gather_tail(t, m, a);
  solve_tail(a, m, x + t->stop);
  memcpy(next, x[t->stop], sizeof next);
  for (size_t k = t->stop; k-- > 0;) {
    const struct ph_block2_pivot *p = &t->pivot[k];
    double fa = p->fa, fb = p->fb;
    if (k < t->far_n) {
      const struct ph_block2_far *far = &t->far[k];
      fa -= dot(far->a, x[t->n - 2]) + dot(far->a + 2, x[t->n - 1]);
      fb -= dot(far->b, x[t->n - 2]) + dot(far->b + 2, x[t->n - 1]);
    }
    if (fill_n > 0 && t->fill[fill_n - 1].k == k) {
      const struct ph_block2_fill *fill = &t->fill[--fill_n];
      fa -= dot(fill->a, x[k + 2]);
      fb -= dot(fill->b, x[k + 2]);
    }
    fa -= dot(p->a, next);
    fb -= dot(p->b, next);
    next[1] = fb;
    next[0] = fa - p->u * fb;
    memcpy(x[k], next, sizeof next);
  }
}
