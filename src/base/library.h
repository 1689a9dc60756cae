/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shared libraries that few runs need: they are loaded when they are asked for,
 * and stay until the program ends.  To load cairo and teem takes longer than
 * all else that a small problem needs.
 *
 * Who uses one lists what it uses of it as X(name), keeps a struct of these
 * members, and fills it by the list of symbols, or, where the library is
 * linked, by their addresses.
 */
#ifndef PH_BASE_LIBRARY_H
#define PH_BASE_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

/* A member of such a struct: a pointer to a function or variable. */
#define PH_LIBRARY_MEMBER(name) __typeof__(&(name)) name;

/* Where a pointer of that name belongs. */
struct ph_library_symbol {
  const char *name;
  size_t offset;
};

/*
 * ph_library_load: the pointers of a shared library.
 *
 * in   library  its name, as a linked program knows it
 * out  to       the struct; of no use on failure
 * out  why      on failure what the system says, until the next call
 * ret  whether all are there
 */
bool ph_library_load(const char *library,
                     const struct ph_library_symbol *symbols, size_t n,
                     void *to, const char **why);

#endif
