# SPDX-License-Identifier: GPL-3.0-or-later
#
# Offsets of curves on a sphere: points at a geodesic distance from the curve,
# their curvature, length and cusps.  (As tables: sphere-csv.t.)
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/sphere.sh"

some='"lonlat":[[0,0],[10,20],[40,30],[60,-10],[100,-20]]'
ring='"lonlat":[[0,0],[30,20],[70,10],[80,-30],[20,-40]],"closed":true'
pi=3.141592653589793
degree=0.017453292519943295

# Beside the samples of a curve (the first file) those of an offset: each is at
# the distance, at a right angle to the left, tangents are parallel, and its
# curvature is (cos d k + sin d) / |cos d - k sin d|.
{
  printf '%s' "$sphere_awk"
  cat <<'EOF'
BEGIN { FS = "," }
FNR == 1 { file++; next }
file == 1 {
  n++
  for (i = 1; i <= 3; i++) {
    p[n, i] = ($(4 + i) - center * i) / r
    t[n, i] = $(7 + i)
  }
  k[n] = $11 * r
  segment[n] = $2
  u[n] = $3
  next
}
{
  m++
  for (i = 1; i <= 3; i++) {
    q[i] = ($(5 + i) - center * i) / r
    v[i] = $(8 + i)
    a[i] = p[m, i]
    b[i] = t[m, i]
  }
  left[1] = a[2] * b[3] - a[3] * b[2]
  left[2] = a[3] * b[1] - a[1] * b[3]
  left[3] = a[1] * b[2] - a[2] * b[1]
  near("the distance", $2, d * r, 0)
  near("the segment", $3, segment[m], 0)
  near("the parameter", $4, u[m], 1e-15)
  near("the size", dot(q, q), 1, 1e-14)
  near("the angle", angle(a, q), d < 0 ? -d : d, 1e-13)
  near("the side", dot(q, left), sin(d), 1e-13)
  near("the part along", dot(q, b), 0, 1e-13)
  g = cos(d) - k[m] * sin(d)
  near("the tangent", dot(v, b), g < 0 ? -1 : 1, 1e-13)
  size = g < 0 ? -g : g
  wanted = (cos(d) * k[m] + sin(d)) / size
  near("the curvature", $12 * r, wanted, 1e-11 * (1 + 1 / size) ^ 2)
  if (m == 1) near("s", $5, 0, 0)
  else if (!($5 / r - s >= angle(q, was) * (1 - 1e-12) - 1e-14)) {
    print "line " FNR ": s grows by too little"
    failed = 1
  }
  s = $5 / r
  for (i = 1; i <= 3; i++) was[i] = q[i]
}
END {
  near("the number of samples", m, n, 0)
  near("the length", s, length_ / r, 1e-14 * s)
  exit failed || n < 9
}
EOF
} >offset.awk

# offset NAME MEMBERS ANGLE [RADIUS [CENTER]]: the center is (1, 2, 3) times that
offset() {
  name=$1 radius=${4-1} center=${5-0}
  members="$2,\"radius\":$radius,\"center\":[$center,$(awk "BEGIN {
    print 2 * $center \",\" 3 * $center }")]"
  distance=$(awk "BEGIN { printf \"%.17g\", $3 * $radius }")
  feed "{$members}" sphere -q -n 8 -f csv --table=samples
  mv out samples.csv
  feed "{$members}" sphere -q -n 8 -d "$distance" -f csv --table=offsets
  mv out offset.csv
  feed "{$members}" sphere -q -n 8 -d "$distance"
  expect "$name, at $3" 0
  true_that "$name, at $3: its samples" awk -v d="$3" -v r="$radius" \
    -v center="$center" -v length_="$(get 'offsets[0].length')" \
    -f offset.awk samples.csv offset.csv
}

# ---- samples -----------------------------------------------------------------

for d in 0 1e-9 0.125 -0.125 0.5 -0.5 1 -1.5 3; do
  offset 'open' "$some" $d
  offset 'closed' "$ring" $d
done
for d in 0.125 -0.5; do
  offset 'radius 6371' "$some" $d 6371
  offset 'radius 2^-20' "$some" $d 9.5367431640625e-07
  offset 'a center' "$ring" $d 4 0.5
  offset 'nielson' "$some,\"model\":\"nielson\"" $d
  offset 'a tension' "$some,\"tension\":50" $d
  offset 'clamped' "$some,\"ends\":\"clamped\",\"end_tangents\":[[0,1,0],
    [1,0,1]]" $d
done

# ---- lengths -----------------------------------------------------------------

# A great circle's offsets are circles of latitude.
for d in 30 -60 89; do
  feed '{"lonlat":[[0,0],[70,0],[150,0],[200,0]],"radius":57.29577951308232}' \
    sphere -d $d --strict
  expect "the equator, at $d degrees" 0
  get 'offsets[0].length' | holds "the equator, at $d degrees: the length" \
    "n == 1 && (x[1] / (200 * cos($d * $degree)) - 1)^2 < 1e-24"
  tangent="sin($d * $degree) / cos($d * $degree)"
  floats 'offsets[0].samples[7].curvature' |
    holds "the equator, at $d degrees: the curvature" "n == 1 &&
      (x[1] * 57.29577951308232 - $tangent)^2 < 1e-20"
  equal "the equator, at $d degrees: the latitude" "$d" \
    "$(get 'offsets[0].samples[7].lonlat[1]' | awk '{ printf "%.10g", $1 }')"
done

# Of a simple closed curve without cusps L(d) = L cos d - sin d K, K being its
# total curvature; two distances give K, a third checks it.
feed "{$ring}" sphere -q -d 0.05,-0.05,0.1,-0.1
equal 'a closed curve: no cusps' '[][][][]' "$(get 'offsets[0].cusps')$(
  get 'offsets[1].cusps')$(get 'offsets[2].cusps')$(get 'offsets[3].cusps')"
for i in 0 1 2 3; do
  get "offsets[$i].length"
  echo
done >lengths
{ cat lengths; get length; echo; } | holds 'a closed curve: lengths' 'n == 5 &&
  (x[1] + x[2] - 2 * x[5] * cos(0.05))^2 < 1e-24 &&
  (x[3] + x[4] - 2 * x[5] * cos(0.1))^2 < 1e-24 &&
  ((x[2] - x[1]) / sin(0.05) - (x[4] - x[3]) / sin(0.1))^2 < 1e-20'

# ---- several, and none -------------------------------------------------------

feed "{$some}" sphere -q -d 0.1 -d -0.2,0.3
equal 'several' '0.1 -0.2 0.3 absent' "$(get 'offsets[0].distance') $(
  get 'offsets[1].distance') $(get 'offsets[2].distance') $(get 'offsets[3]')"
equal 'without --sample 17 samples a segment' 68 \
  "$(get 'offsets[0].samples' | grep -o '"t"' | wc -l | tr -d ' ')"
feed "{$some}" sphere -q -d 0.1 -n 1
equal 'with --sample as many as the curve has' 8 \
  "$(get 'offsets[0].samples' | grep -o '"t"' | wc -l | tr -d ' ')"

# ---- cusps -------------------------------------------------------------------

# The curve of a turn to the right: its offsets to the right have two cusps from
# the smallest radius of curvature on, acot of the largest curvature.
turn='"lonlat":[[0,0],[10,20],[20,0]],"shape":false'
feed "{$turn}" sphere -n 64 -f csv --table=samples
limit=$(awk -F, 'NR > 1 && -$11 > most { most = -$11 }
  END { printf "%.17g", atan2(1, most) }' out)
for part in 0.99 1.01; do
  d=$(awk "BEGIN { printf \"%.17g\", -$part * $limit }")
  feed "{$turn}" sphere --offset="$d"
  equal "cusps, at $part of the smallest radius" \
    "$(case $part in 0.99) echo 0 absent ;; *) echo 2 '"offset-cusp"' ;; esac)" \
    "$(get 'offsets[0].cusps' | grep -o '"t"' | wc -l | tr -d ' ') $(
      get 'warnings[0].code')"
  equal "cusps, at $part of the smallest radius: messages" \
    "$(case $part in 0.99) echo 0 ;; *) echo 1 ;; esac)" \
    "$(wc -l <err | tr -d ' ')"
done
equal 'cusps: what is said' "phspline: -:1: record 1: warning: the offset at \
distance D has cusps, where the curve bends as a circle of that radius on the \
sphere: 2, the first in segment 0 at U of its interval [offset-cusp]" \
  "$(sed 's/distance [-0-9.e]* /distance D /; s/ at [0-9.]* of/ at U of/' err)"
equal 'cusps: the warning' '0 "offset-cusp" 0 absent' "$status $(
  get 'warnings[0].code') $(get 'warnings[0].segment') $(get 'warnings[1]')"
# where they are: the curvature is cot d there, on either side of the top
equal 'cusps: one in each segment' '0 1' \
  "$(get 'offsets[0].cusps[0].segment') $(get 'offsets[0].cusps[1].segment')"
{
  get 'offsets[0].cusps[0].t'
  echo
  get 'offsets[0].cusps[1].t'
  echo
} | holds 'cusps: as the turn is symmetric, so are they' \
  'n == 2 && x[1] > 0.5 && x[1] < 1 && (x[1] + x[2] - 1)^2 < 1e-18'
feed "{$turn}" sphere --offset="$d" --strict
equal 'cusps: --strict' '1 "offset-cusp" absent' \
  "$status $(get error.code) $(get offsets)"
feed "{$turn}" sphere -d 0.1 -d "$d"
equal 'cusps: one warning for all offsets, of the first that has any' \
  '1 2' "$(grep -c offset-cusp err) $(get 'offsets[1].cusps' | grep -o '"t"' |
    wc -l | tr -d ' ')"

# a hairpin within rounding of the points: half a circle around its tip
feed '{"points":[[6370,0,0],[6370,0.0002,0],[5810,600,2530]],"radius":6370,
  "end_tangents":[[0,-1,0],[-1,0,0]]}' sphere -q --offset=600 --sample=16
floats 'offsets[0].samples[3].s' >s
holds 'a hairpin: half a circle' \
  "(x[1] / ($pi * 6370 * sin(600 / 6370)) - 1) ^ 2 < 1e-10" <s
mv out r
run verify r
equal 'a hairpin: verified' 0 "$status"

# Two pairs of points that are all but one, and neighbours a third of the sphere
# away: what rounding of the long legs leaves must not turn the short ones
feed '{"points":[[0.576271,0.6476973321640934,0.498397],
  [0.5762709287396113,0.6476973,0.49839741426183937],
  [0.487903,-0.2546053614390359,-0.8349410842275974],
  [0.487903,-0.25460536156524965,-0.8349410842450684],
  [-0.6849059516297654,-0.377137,-0.623435]],"closed":true,"shape":false,
  "model":"nielson"}' sphere -q --offset=1.7239214438040447
equal 'points that are all but one: no gap' '0 []' \
  "$status $(get 'offsets[0].gaps')"
mv out r
run verify r
equal 'points that are all but one: verified' 0 "$status"

# ---- too far -----------------------------------------------------------------

for radius in 1 2; do
  half=$(awk "BEGIN { print $pi * $radius }")
  for part in 1 1.001 5; do
    for sign in '' -; do
      d=$sign$(awk "BEGIN { printf \"%.17g\", $part * $pi * $radius }")
      feed "{$turn,\"radius\":$radius}" sphere --offset="$d"
      equal "half the circumference, times $sign$part, radius $radius" \
        "1 \"bad-value\" the offset distance $(printf %s "$d" |
          awk '{ printf "%g", $1 }') is not less than half the circumference \
of the sphere, $half" "$status $(get error.code) $(get error.message |
          tr -d '"')"
    done
  done
  d=$(awk "BEGIN { printf \"%.17g\", 0.999999 * $pi * $radius }")
  feed "{$turn,\"radius\":$radius}" sphere -q --offset="$d"
  expect "nearly half the circumference, radius $radius" 0
done
for value in '' x '1,' 0x1 1e999; do
  feed "{$turn}" sphere --offset="$value"
  equal "--offset=$value" 2 "$status"
done
