/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that C11 does not name: pi and the square root of 3. */
#ifndef PH_KERNEL_PI_H
#define PH_KERNEL_PI_H

#define PH_PI 3.14159265358979323846
#define PH_SQRT3 1.73205080756887729353

#endif
