/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The number pi, which C11 does not name. */
#ifndef PH_KERNEL_PI_H
#define PH_KERNEL_PI_H

#define PH_PI 3.14159265358979323846

#endif
