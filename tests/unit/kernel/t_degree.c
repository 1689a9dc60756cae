/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Degrees: exact where they can be, symmetric, and back. */
#include "unit.h"

#include "kernel/degree.h"
#include "kernel/pi.h"

static void ck_unit(double lon, double lat, double x, double y, double z,
                    double tol) {
  ph_vec3 u = ph_degree_to_unit(lon, lat);
  ck_abs(u.x, x, tol);
  ck_abs(u.y, y, tol);
  ck_abs(u.z, z, tol);
}

PH_TEST(test_multiples) {
  for (int turn = -3; turn <= 3; turn++) {
    double round = 360.0 * turn;
    ck_unit(round, 0, 1, 0, 0, 0);
    ck_unit(90 + round, 0, 0, 1, 0, 0);
    ck_unit(180 + round, 0, -1, 0, 0, 0);
    ck_unit(270 + round, 0, 0, -1, 0, 0);
    ck_unit(round, 90, 0, 0, 1, 0);
    ck_unit(123 + round, -90, 0, 0, -1, 0);
  }
  ck_unit(45, 0, sqrt(0.5), sqrt(0.5), 0, 2e-16);
  ck_unit(0, 30, sqrt(0.75), 0, 0.5, 2e-16);
  ck_unit(60, 45, sqrt(0.125), sqrt(0.375), sqrt(0.5), 3e-16);
}

/* Zeros are no -0: it would be written. */
PH_TEST(test_zeros) {
  for (int lon = -360; lon <= 360; lon += 90) {
    for (int lat = -90; lat <= 90; lat += 90) {
      ph_vec3 u = ph_degree_to_unit(lon, lat);
      ck_assert(fabs(u.x) > 0 || !signbit(u.x));
      ck_assert(fabs(u.y) > 0 || !signbit(u.y));
      ck_assert(fabs(u.z) > 0 || !signbit(u.z));
    }
  }
}

/* To the last bit; whole degrees, so that 180 - lon is exact. */
PH_TEST(test_symmetry) {
  for (int lon = 0; lon < 360; lon += 360 / unit_count(360)) {
    for (int lat = -90; lat <= 90; lat += 5) {
      ph_vec3 u = ph_degree_to_unit(lon, lat);
      ck_unit(lon, -lat, u.x, u.y, -u.z, 0);
      ck_unit(-lon, lat, u.x, -u.y, u.z, 0);
      ck_unit(180 - lon, lat, -u.x, u.y, u.z, 0);
      ck_unit(90 + lon, lat, -u.y, u.x, u.z, 3e-16); /* 45 is no multiple */
      ck_unit(lon - 360, lat, u.x, u.y, u.z, 0);
    }
  }
}

PH_TEST(test_back) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < unit_count(2000); i++) {
    double lon = unit_random_in(&r, -180, 180);
    double lat = unit_random_in(&r, -90, 90), back[2];
    ph_vec3 u = ph_degree_to_unit(lon, lat), v;
    ck_abs(ph_vec3_dot(u, u), 1, 1e-15);
    ph_degree_of_unit(u, back);
    ck_abs(back[0], lon, 1e-15 * 180);
    ck_abs(back[1], lat, 1e-15 * 180);
    v = ph_degree_to_unit(back[0], back[1]);
    ck_abs(v.x, u.x, 1e-15);
    ck_abs(v.y, u.y, 1e-15);
    ck_abs(v.z, u.z, 1e-15);
  }
}

/* Next to a pole latitude has all its digits, where asin would lose half. */
PH_TEST(test_pole) {
  double lonlat[2];
  for (int e = -40; e <= -1; e++) {
    ph_vec3 u = ph_vec3_unit(ph_vec3_of(0, -ldexp(1, e), 1));
    ph_degree_of_unit(u, lonlat);
    ck_abs(lonlat[0], -90, 0);
    ck_abs(90 - lonlat[1], atan(ldexp(1, e)) * (180 / PH_PI), 2e-14);
  }
}

static void ck_lonlat(double x, double y, double z, double lon, double lat) {
  double lonlat[2];
  ph_degree_of_unit(ph_vec3_of(x, y, z), lonlat);
  ck_abs(lonlat[0], lon, 0);
  ck_abs(lonlat[1], lat, 0);
}

PH_TEST(test_ends) {
  ck_lonlat(1, 0, 0, 0, 0);
  ck_lonlat(0, 1, 0, 90, 0);
  ck_lonlat(0, -1, 0, -90, 0);
  ck_lonlat(-1, 0, 0, 180, 0);
  ck_lonlat(-1, -0.0, 0, 180, 0);
  ck_lonlat(-1, -1e-20, 0, 180, 0);
  ck_lonlat(0, 0, 1, 0, 90);
  ck_lonlat(-0.0, 0, 1, 0, 90);
  ck_lonlat(-0.0, -0.0, -1, 0, -90);
  ck_lonlat(0, 0, 7, 0, 90);
}
