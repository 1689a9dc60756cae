/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments prepared for many places (see seg3_fast.h). */
#include "curve/segment/seg3_fast.h"

/*
 * Printed by Python with fractions.Fraction as F and math.factorial as f,
 * correctly rounded; with s = (-1)**n, for n = 2 row and 2 row + 1:
 *   float(F(s, f(2*n + 3))), float(F(s, f(2*n + 2))),
 *   float(F(s * (2**(2*n + 3) - 2), f(2*n + 5)))
 * The next row is less than 2e-17 of the first for every angle below pi.
 */
const double ph_fast3_table[PH_FAST3_ROWS][6] = {
    {0.16666666666666666, -0.008333333333333333, 0.5, -0.041666666666666664,
     0.05, -0.005952380952380952},
    {0.0001984126984126984, -2.7557319223985893e-06, 0.001388888888888889,
     -2.48015873015873e-05, 0.00034722222222222224, -1.2776575276575277e-05},
    {2.505210838544172e-08, -1.6059043836821613e-10, 2.755731922398589e-07,
     -2.08767569878681e-09, 3.285680369013702e-07, -6.26302709636043e-09},
    {7.647163731819816e-13, -2.8114572543455206e-15, 1.1470745597729725e-11,
     -4.779477332387385e-14, 9.212020839588534e-11, -1.077478661775051e-12},
    {8.22063524662433e-18, -1.9572941063391263e-20, 1.5619206968586225e-16,
     -4.110317623312165e-19, 1.026181897836115e-14, -8.112133073338138e-17},
    {3.868170170630684e-23, -6.446950284384474e-26, 8.896791392450574e-22,
     -1.6117375710961184e-24, 5.40809258372893e-19, -3.0815347867643718e-21}};

/* Rows that matter up to x = 1/2: what is left of the series of k, the slowest,
 * is less than this of it. */
static const double NEGLIGIBLE = 2e-17;

static size_t rows_for(double angle2) {
  double y = angle2 / 4, power = y * y;
  size_t rows = 1;
  while (rows < PH_FAST3_ROWS &&
         ph_fast3_table[rows][4] * power > NEGLIGIBLE * ph_fast3_table[0][4]) {
    power *= y * y;
    rows++;
  }
  return rows;
}

/*
 * A0'' by (3), in the one of two forms that cancels less: differences next to
 * a = 0, where A1 is near A0 and A2; without a difference of A1 next to a = pi,
 * where A1 is large.
 */
static ph_quat second_of(const struct ph_atph *space, ph_quat a0, ph_quat a1,
                         ph_quat a2) {
  const ph_quat d = ph_quat_sub(a1, a0);
  const double half = 0.5 * space->angle * space->sinc; /* sin(a/2) */
  const double c2 = space->c * space->c;
  const double scale = 2 / (space->sinc * space->sinc);
  ph_quat sum =
      c2 > 0.5 ? ph_quat_add(ph_quat_sub(ph_quat_sub(a2, a1), d),
                             ph_quat_scale(2 * half * half, d))
               : ph_quat_sub(ph_quat_sub(a2, a0), ph_quat_scale(2 * c2, d));
  return ph_quat_scale(scale, sum);
}

/* (4), by one coordinate of f, which is given by its products: f(A0,A0),
 * f(A0,A0'), f(A0,A0''), f(A0',A0'), f(A0',A0''), f(A0'',A0''). */
static void form_of(const double f[6], double angle2, double c[5]) {
  c[0] = f[0];
  c[1] = 2 * f[1];
  c[2] = 2 * (f[2] + f[3]);
  c[3] = 2 * f[4];
  c[4] = f[5] - angle2 * f[3];
}

static void fill(struct ph_fast3_end *end, double angle2) {
  static const size_t pairs[6][2] = {{0, 0}, {0, 1}, {0, 2},
                                     {1, 1}, {1, 2}, {2, 2}};
  double s[6], x[6], y[6], z[6];
  for (size_t i = 0; i < 6; i++) {
    ph_quat a = end->a[pairs[i][0]], b = end->a[pairs[i][1]];
    ph_vec3 r = ph_quat_i(a, b);
    s[i] = ph_quat_dot(a, b);
    x[i] = r.x;
    y[i] = r.y;
    z[i] = r.z;
  }
  form_of(s, angle2, end->s);
  form_of(x, angle2, end->x);
  form_of(y, angle2, end->y);
  form_of(z, angle2, end->z);
}

void ph_fast3_of(const struct ph_curve *curve, size_t k,
                 struct ph_fast3 *fast) {
  struct ph_fast3_end *end = fast->end;
  const struct ph_atph *space = &fast->seg.space;
  const ph_quat *a = fast->seg.a;
  fast->seg = ph_seg3_of(curve, k);
  fast->exponent = 2 * ph_seg3_rescale(&fast->seg);
  fast->grow = ph_pow2_of(fast->exponent);
  fast->shrink = ph_pow2_of(-fast->exponent);
  fast->angle2 = space->angle * space->angle;
  fast->rows = rows_for(fast->angle2);
  end[0].point = fast->seg.start;
  end[0].a[0] = a[0];
  end[0].a[1] = ph_quat_scale(2 * space->slope, ph_quat_sub(a[1], a[0]));
  end[0].a[2] = second_of(space, a[0], a[1], a[2]);
  end[1].point = fast->seg.end;
  end[1].a[0] = a[2];
  end[1].a[1] = ph_quat_scale(2 * space->slope, ph_quat_sub(a[2], a[1]));
  end[1].a[2] = second_of(space, a[2], a[1], a[0]);
  fill(&end[0], fast->angle2);
  fill(&end[1], fast->angle2);
}
