# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of `sphere' share: solving, and what holds for every sample of
# a curve on a sphere.  Read after lib.sh.

# Angles are 2 atan2(|p - q|, |p + q|), which is exact for near points.
sphere_awk='
function angle(a, b,   c, d, s) {
  for (c = 1; c <= 3; c++) {
    d += (a[c] - b[c])^2
    s += (a[c] + b[c])^2
  }
  return 2 * atan2(sqrt(d), sqrt(s))
}
function dot(a, b) { return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] }
function near(name, x, y, most) {
  if (!((x - y)^2 <= most^2)) {
    print "line " NR ": " name " " x " is not " y
    failed = 1
  }
}
'

# Of the table `samples`: points are on the sphere, tangents along it and of
# length 1; along the curve it is no nearer than along the great circle; at the
# joints all of it goes on.
{
  printf '%s' "$sphere_awk"
  cat <<'EOF'
BEGIN {
  FS = ","
  split(center, c, " ")
  far = ((c[1] / r)^2 + (c[2] / r)^2 + (c[3] / r)^2 + 1)^0.5
}
NR == 1 { next }
{
  for (i = 1; i <= 3; i++) {
    p[i] = ($(4 + i) - c[i]) / r
    t[i] = $(7 + i)
  }
  near("the radius", dot(p, p), 1, 2e-15 * far)
  near("the size of the tangent", dot(t, t), 1, 2e-15)
  near("the radial part of the tangent", dot(p, t), 0, 2e-15 * far)
  step = $4 / r - s
  if (NR == 2) near("s", $4, 0, 0)
  else if (!(step >= angle(p, p0) * (1 - 1e-12) - 1e-14 * (far + s))) {
    print "line " NR ": s grows by " step ", the angle is " angle(p, p0)
    failed = 1
  }
  if (NR > 2 && $2 != segment) {
    near("the angle at a joint", angle(p, p0), 0, 1e-14 * far)
    near("s at a joint", step, 0, 1e-14 * s)
    if (rough < 1) near("the turn at a joint", angle(t, t0), 0, 1e-8 * far)
    if (rough < 1 && $11 != "" && k != "")
      near("the curvature at a joint", $11 * r, k, rough * (1 + k^2)^0.5)
  }
  for (i = 1; i <= 3; i++) { p0[i] = p[i]; t0[i] = t[i] }
  segment = $2
  s = $4 / r
  k = $11 == "" ? "" : $11 * r
}
END {
  near("the length", s, length_ / r, 1e-14 * s)
  if (NR < 3) print "no samples"
  exit failed || NR < 3
}
EOF
} >samples.awk

# curve NAME MEMBERS [ARGUMENT...]: it is solved, and its samples are sound; the
# record is left in out.  $rough is by how much its curvature may jump at the
# joints, for rounding or for model=nielson; if 1, tangents may turn as well.
rough=1e-9
curve() {
  title=$1 members=$2
  shift 2
  feed "{$members}" sphere -q -n 8 -f csv --table=samples "$@"
  mv out samples.csv
  feed "{$members}" sphere -q "$@"
  expect "$title" 0
  if [ "$status" -eq 0 ]; then
    true_that "$title: samples" awk -v center="$(floats center | tr '\n' ' ')" \
      -v r="$(get radius)" -v length_="$(get length)" -v rough="$rough" \
      -f samples.awk samples.csv
  fi
}

# joints: the points of the curve in out at its knots
joints() {
  get segments | grep -o '"control_points":\[\[[^]]*\]' | sed 's/.*\[//; s/\]//'
  get segments | grep -o ',\[[^]]*\]\],"length"' | tail -n 1 |
    sed 's/,\[//; s/\].*//'
}
