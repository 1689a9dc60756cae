/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Buffers of polygons by GEOS and Clipper, for comparison with trimmed offsets:
 *
 *   trim_peers geos|clipper D TOLERANCE [line] < POLYGON
 *
 * reads points x y of a closed curve and prints the processor seconds of its
 * offset at distance D to the left, the loops, their points, and the signed
 * area; with `line', of both sides.  Arcs are within the tolerance.
 */
#include <polyclipping/clipper.hpp>

#include <geos_c.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

static double cpu() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct point {
  double x, y;
};

struct buffer {
  double seconds, area;
  size_t loops, points;
};

static double area_of(const std::vector<point> &p) {
  double area = 0;
  for (size_t i = 0; i < p.size(); i++) {
    const point &a = p[i], &b = p[(i + 1) % p.size()];
    area +=
        ((a.x - p[0].x) * (b.y - p[0].y) - (a.y - p[0].y) * (b.x - p[0].x)) / 2;
  }
  return area;
}

/* A growth of the polygon by `grow', at integer coordinates of 2^53 its size.
 */
static buffer clipper(const std::vector<point> &p, double grow,
                      double tolerance, bool line) {
  double size = 0;
  ClipperLib::Path path;
  ClipperLib::Paths out;
  ClipperLib::ClipperOffset offset;
  buffer found = {};
  for (const point &a : p) {
    size = fmax(size, fmax(fabs(a.x), fabs(a.y)));
  }
  const double unit = ldexp(1, 53) / (size + fabs(grow));
  for (const point &a : p) {
    path.push_back(ClipperLib::IntPoint((ClipperLib::cInt)(a.x * unit),
                                        (ClipperLib::cInt)(a.y * unit)));
  }
  const double start = cpu();
  offset.ArcTolerance = tolerance * unit;
  offset.AddPath(path, ClipperLib::jtRound,
                 line ? ClipperLib::etClosedLine : ClipperLib::etClosedPolygon);
  offset.Execute(out, grow * unit);
  found.seconds = cpu() - start;
  found.loops = out.size();
  for (const ClipperLib::Path &q : out) {
    found.area += ClipperLib::Area(q) / unit / unit;
    found.points += q.size();
  }
  return found;
}

static buffer geos(const std::vector<point> &p, double grow, double tolerance,
                   bool line) {
  GEOSContextHandle_t h = GEOS_init_r();
  GEOSCoordSequence *s = GEOSCoordSeq_create_r(h, (unsigned)p.size() + 1, 2);
  buffer found = {};
  for (size_t i = 0; i <= p.size(); i++) {
    const point &a = p[i % p.size()];
    GEOSCoordSeq_setXY_r(h, s, (unsigned)i, a.x, a.y);
  }
  GEOSGeometry *given =
      line ? GEOSGeom_createLineString_r(h, s)
           : GEOSGeom_createPolygon_r(h, GEOSGeom_createLinearRing_r(h, s),
                                      NULL, 0);
  const double step = 2 * acos(1 - fmin(tolerance / fabs(grow), 1));
  const int quarter = (int)ceil(acos(0) / step);
  const double start = cpu();
  GEOSGeometry *out = GEOSBuffer_r(h, given, grow, quarter);
  found.seconds = cpu() - start;
  GEOSArea_r(h, out, &found.area);
  for (int i = 0; i < GEOSGetNumGeometries_r(h, out); i++) {
    const GEOSGeometry *part = GEOSGetGeometryN_r(h, out, i);
    const bool empty = GEOSisEmpty_r(h, part);
    found.points += empty ? 0 : (size_t)GEOSGetNumCoordinates_r(h, part);
    found.loops += empty ? 0 : 1 + (size_t)GEOSGetNumInteriorRings_r(h, part);
  }
  GEOSGeom_destroy_r(h, out);
  GEOSGeom_destroy_r(h, given);
  GEOS_finish_r(h);
  return found;
}

int main(int argc, char **argv) {
  std::vector<point> p;
  point a;
  if (argc < 4) {
    fputs("trim_peers geos|clipper D TOLERANCE [line] < POLYGON\n", stderr);
    return 1;
  }
  while (scanf("%lf %lf", &a.x, &a.y) == 2) {
    p.push_back(a);
  }
  const bool line = argc > 4;
  const double d = strtod(argv[2], NULL), tolerance = strtod(argv[3], NULL);
  const double side = line || area_of(p) > 0 ? 1 : -1;
  const double grow = line ? fabs(d) : -side * d;
  if (side < 0) {
    p = std::vector<point>(p.rbegin(), p.rend());
  }
  const buffer found = strcmp(argv[1], "geos") == 0
                           ? geos(p, grow, tolerance, line)
                           : clipper(p, grow, tolerance, line);
  printf("%.9g %zu %zu %.17g\n", found.seconds, found.loops, found.points,
         side * found.area);
  return 0;
}
