/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables as NumPy arrays: a file of format NPY 1.0 [NumPy, NEP 1] with one
 * structured array of rows of doubles.  The columns are those of csv_out.h, but
 * for the first: in place of the id `result', the number of the result in the
 * stream, from 1.  What is not defined is NaN; the vector of an offset is 2 or
 * 3.  The rows themselves are written by csv_out.c.
 */
#ifndef PH_IO_NPY_OUT_H
#define PH_IO_NPY_OUT_H

#include "base/buf.h"
#include "io/csv_out.h"

/* ph_npy_header: appends what stands before the rows, which are so many bytes:
 * the same number of bytes for all. */
void ph_npy_header(struct ph_buf *buf, const struct ph_csv_shape *shape,
                   size_t bytes);

#endif
