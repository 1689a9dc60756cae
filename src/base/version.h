/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The version of the program, and the only place that states it.
 *
 * Makefile and configure.ac extract the string from this line, so its form
 * (one space, double quotes, nothing after) must stay as it is.
 */
#ifndef PH_BASE_VERSION_H
#define PH_BASE_VERSION_H

#define PH_VERSION "0.1.0"

#endif
