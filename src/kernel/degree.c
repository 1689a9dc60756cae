/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Longitude and latitude (see degree.h). */
#include "kernel/degree.h"

#include "kernel/pi.h"

/* Sine and cosine of an angle in degrees; 0 is never -0. */
static void circle(double degrees, double *sine, double *cosine) {
  int quadrant;
  double rest = remquo(degrees, 90, &quadrant) * (PH_PI / 180);
  double s = sin(rest), c = cos(rest);
  switch ((unsigned)quadrant & 3) {
  case 0:
    *sine = 0 + s;
    *cosine = c;
    break;
  case 1:
    *sine = c;
    *cosine = 0 - s;
    break;
  case 2:
    *sine = 0 - s;
    *cosine = -c;
    break;
  default:
    *sine = -c;
    *cosine = 0 + s;
  }
}

ph_vec3 ph_degree_to_unit(double lon, double lat) {
  double sine, cosine, up, out;
  circle(lon, &sine, &cosine);
  circle(lat, &up, &out);
  return ph_vec3_of(0 + out * cosine, 0 + out * sine, up);
}

void ph_degree_of_unit(ph_vec3 u, double lonlat[2]) {
  double lon = atan2(u.y, u.x) * (180 / PH_PI);
  double lat = atan2(u.z, sqrt(u.x * u.x + u.y * u.y)) * (180 / PH_PI);
  /* -180 is that of y = -0, or of a y that is too small to matter. */
  lon = lon <= -180 ? 180 : lon;
  /* At a pole the signs of zeros, which say nothing, would make it +-180. */
  lonlat[0] = fabs(u.x) > 0 || fabs(u.y) > 0 ? lon : 0;
  lonlat[1] = lat;
}
