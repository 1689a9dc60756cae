// SPDX-License-Identifier: GPL-3.0-or-later
/*
 * Writes coastline.csv: the outline of Sicily from Natural Earth 1:50m.
 *
 * Run it in any folder that holds the two npm packages:
 *
 *   npm install world-atlas@2.0.2 topojson-client@3.1.0
 *   node PATH/TO/data/coastline.mjs >coastline.csv
 *
 * world-atlas is Natural Earth 4.1.0 (public domain) as TopoJSON; its
 * coordinates are rounded to a grid of 0.0036 by 0.0017 degrees.
 *
 * The ring of the land layer that contains (LON0, LAT0) is mapped to
 * kilometres by Lambert's azimuthal equal-area projection of the sphere
 * (Snyder 1987, eqs. 22-4, 22-5 and 24-2), rounded to a metre, freed of
 * repeated points and turned counter-clockwise.  Nothing is smoothed or left
 * out.
 */
import { createRequire } from 'node:module';

const LON0 = 14;        // degrees east, a round number inside the island
const LAT0 = 37.5;      // degrees north
const RADIUS = 6371.007; // km: the sphere with the area of the WGS 84 ellipsoid

// The packages are those of the working folder, not of this file's folder.
const require = createRequire(process.cwd() + '/');
const topojson = require('topojson-client');
const world = require('world-atlas/land-50m.json');

function contains(ring, x, y) {
  let inside = false;
  for (let i = 1; i < ring.length; i++) {
    const [ax, ay] = ring[i - 1];
    const [bx, by] = ring[i];
    if (ay > y !== by > y && x < ax + ((y - ay) * (bx - ax)) / (by - ay)) {
      inside = !inside;
    }
  }
  return inside;
}

function project([lon, lat]) {
  const rad = Math.PI / 180;
  const l = (lon - LON0) * rad;
  const s = Math.sin(lat * rad);
  const c = Math.cos(lat * rad);
  const s0 = Math.sin(LAT0 * rad);
  const c0 = Math.cos(LAT0 * rad);
  const k = RADIUS * Math.sqrt(2 / (1 + s0 * s + c0 * c * Math.cos(l)));
  return [k * c * Math.sin(l), k * (c0 * s - s0 * c * Math.cos(l))];
}

const { features } = topojson.feature(world, world.objects.land);
const rings = features
  .flatMap(({ geometry: g }) =>
    g.type === 'Polygon' ? [g.coordinates] : g.coordinates)
  .map((polygon) => polygon[0])
  .filter((ring) => contains(ring, LON0, LAT0));
if (rings.length !== 1) {
  throw new Error(`${rings.length} rings contain (${LON0}, ${LAT0}), not 1`);
}

// Rounding before toFixed keeps it from writing -0.000.
const metre = (v) => (Math.round(v * 1000) / 1000).toFixed(3);
const rows = rings[0].map((p) => project(p).map(metre).join(','));
let points = rows.filter((row, i) => row !== rows[(i + 1) % rows.length]);
const xy = points.map((row) => row.split(',').map(Number));
const area = xy.reduce((sum, [x, y], i) => {
  const [u, v] = xy[(i + 1) % xy.length];
  return sum + (x * v - u * y) / 2;
}, 0);
if (area < 0) {
  points = points.reverse();
}

console.log(`# Sicily, ${points.length} points, closed, counter-clockwise; \
made by coastline.mjs
# Natural Earth 4.1.0, 1:50m land (public domain), from world-atlas 2.0.2
# kilometres east and north of ${LON0} E, ${LAT0} N: Lambert azimuthal
# equal-area projection of the sphere of radius ${RADIUS} km
x,y`);
console.log(points.join('\n'));
