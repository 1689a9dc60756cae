/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of tables, cell by cell (see csv_out.h). */
#ifndef PH_IO_CSV_CELL_H
#define PH_IO_CSV_CELL_H

#include "io/csv_out.h"

/* A row in the making: its cells are separated by `between`. */
struct ph_csv_row {
  struct ph_buf *buf;
  const struct ph_csv_shape *shape;
  const struct ph_csv_heading *heading;
  char between;
};

/* ph_csv_row_of: rows of a table that go into a buffer; the heading may be NULL
 * where none begins. */
struct ph_csv_row ph_csv_row_of(struct ph_buf *buf,
                                const struct ph_csv_shape *shape,
                                const struct ph_csv_heading *heading);

/* ph_csv_begin_row, ph_csv_end_row: the cells that every row has. */
void ph_csv_begin_row(const struct ph_csv_row *row);
void ph_csv_end_row(const struct ph_csv_row *row);

/* ph_csv_between: what stands before a cell. */
void ph_csv_between(const struct ph_csv_row *row);

/* ph_csv_text_cell: n bytes, quoted where they need it; not what is between. */
void ph_csv_text_cell(const struct ph_csv_row *row, const char *text, size_t n);

/* ph_csv_number_cell: a number; what is none is an empty cell, or NaN. */
void ph_csv_number_cell(const struct ph_csv_row *row, double x);

/* ph_csv_number_cells: n of them. */
void ph_csv_number_cells(const struct ph_csv_row *row, const double *v,
                         size_t n);

/* ph_csv_end_curve: between two curves, or parts of one, that no line should
 * join. */
void ph_csv_end_curve(const struct ph_csv_row *row);

#endif
