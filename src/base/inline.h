/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Functions that are compiled anew wherever they are called, as arguments that
 * are constants there (a degree, a dimension, an order) decide which of their
 * loops stay.
 */
#ifndef PH_BASE_INLINE_H
#define PH_BASE_INLINE_H

#ifdef __GNUC__
#define PH_INLINE static inline __attribute__((always_inline))
#else
#define PH_INLINE static inline
#endif

#endif
