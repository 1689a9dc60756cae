# SPDX-License-Identifier: GPL-3.0-or-later
#
# Families of random data: long ones are solved as short ones are, and where
# fewer segments in an interval lead nowhere there are more.
. "$srcdir/tests/cli/lib.sh"

# A problem of a family: N intervals, each length FACTOR to FACTOR + WIDTH
# chords, none if FACTOR is 0.  (The generator of Park and Miller.)
cat >family.awk <<'EOF'
function uniform() {
  state = (state * 16807) % 2147483647
  return state / 2147483647
}
function normal(   k, sum) {
  for (k = 0; k < 12; k++) sum += uniform()
  return sum - 6
}
function vector(x, y, z) { return sprintf("[%.17g,%.17g,%.17g]", x, y, z) }
# A point of a smooth curve at t.
function smooth(t, c,   k, sum) {
  for (k = 0; k < 4; k++)
    sum += wave[c, k] / pace[c, k] * sin(pace[c, k] * t + shift[c, k])
  return sum + 0.03 * c * t
}
BEGIN {
  state = seed * 1000003 + n
  for (i = 0; i < 10; i++) uniform()
  for (c = 0; c < 3; c++) for (k = 0; k < 4; k++) {
    wave[c, k] = 0.05 * normal()
    pace[c, k] = 0.02 + 0.1 * uniform()
    shift[c, k] = 6.28 * uniform()
  }
  for (i = 0; i <= n; i++) {
    for (c = 0; c < 3; c++) {
      old[c] = p[c]
      p[c] = family == "walk" ? p[c] + normal() : smooth(i, c)
    }
    if (family == "ribbon") {
      t = 0.02 * i
      row = vector(cos(t) + noise * normal(), sin(2 * t) + noise * normal(),
        1 + 0.3 * cos(3 * t) + noise * normal())
      length_ = 1 + width * (2 * uniform() - 1)
    } else {
      row = vector(p[0], p[1], p[2])
      square = (p[0] - old[0]) ^ 2 + (p[1] - old[1]) ^ 2 + (p[2] - old[2]) ^ 2
      length_ = sqrt(square) * (factor + width * uniform())
    }
    data = data (i ? "," : "") row
    if (i) lengths = lengths (i > 1 ? "," : "") sprintf("%.17g", length_)
  }
  printf "{\"id\":\"%s %d, %d\",\"%s\":[%s]", family, n, seed,
    family == "ribbon" ? "tangents" : "points", data
  print (factor ? ",\"lengths\":[" lengths "]" : "") more "}"
}
EOF

# How many of a kind: fewer where every step takes long.
seeds='1 2 3'
[ "${PH_SHORT-}" != 1 ] || seeds=1

# family NAME FAMILY N FACTOR WIDTH [MORE [NOISE]]: some of a kind, all solved
family() {
  minimisers=
  for seed in $seeds; do
    minimisers="$minimisers \"minimiser\""
    awk -v family="$2" -v n="$3" -v factor="$4" -v width="$5" -v more="${6-}" \
      -v noise="${7-0}" -v seed="$seed" -f family.awk
  done >family.jsonl
  run arclength -q family.jsonl
  equal "$1" "0$minimisers" \
    "$status $(get diagnostics.second_order)"
}

for n in 99 100 150; do
  family "walks, free, $n" walk "$n" 0 0
  family "cables, $n" smooth "$n" 1.01 0.02
done
# What leads near a minimum ends there, and where it creeps.
family 'walks, free, 300' walk 300 0 0
get diagnostics.iterations | tr ' ' '\n' |
  holds 'walks, free, 300: steps' 'x[1] < 100 && x[n] < 100'
# One place where steps are short does not shorten all others: one start, and
# hardly more steps than of shorter walks.
family 'walks, free, 500' walk 500 0 0
get diagnostics.iterations | tr ' ' '\n' |
  holds 'walks, free, 500: steps' 'x[1] < 45 && x[n] < 45'
# What lies on one side of a place turns about it, however much that is.
family 'smooth, free, 500' smooth 500 0 0
get diagnostics.iterations | tr ' ' '\n' |
  holds 'smooth, free, 500: steps' 'x[1] < 10 && x[n] < 10'
# In a plane no phase turns: F was 400 and more.
awk -v seed=1 '
  function normal(   k, sum) {
    for (k = 0; k < 12; k++) {
      seed = (seed * 16807) % 2147483647
      sum += seed / 2147483647
    }
    return sum - 6
  }
  BEGIN {
    for (i = 0; i <= 130; i++) {
      data = data sprintf("%s[%.17g,%.17g,0]", i ? "," : "", x, y)
      turn += 0.6 * normal()
      x += cos(turn)
      y += sin(turn)
    }
    print "{\"points\":[" data "]}"
  }' >flat.json
run arclength -q flat.json
get diagnostics.F | holds 'a walk in the plane: F' 'x[1] < 200'
family 'walks, 300' walk 300 1.2 0.4
equal 'walks, 300: the start' '"wiggle"' \
  "$(get diagnostics.start | tr ' ' '\n' | sort -u)"
# The few places where steps are not small after the first ones are solved alone:
# as many steps as of shorter walks.
if [ "${PH_SHORT-}" != 1 ]; then
  family 'walks, 1000' walk 1000 1.2 0.4
  get diagnostics.iterations | tr ' ' '\n' |
    holds 'walks, 1000: steps' 'x[1] < 60 && x[2] < 60 && x[n] < 60'
fi
# What nearly holds after the steps of a start goes on.
family 'cables, 200' smooth 200 1.01 0.02
equal 'cables, 200: the start' '"wiggle"' \
  "$(get diagnostics.start | tr ' ' '\n' | sort -u)"
family 'walks, 150' walk 150 1.2 0.4
family 'smooth, free' smooth 150 0 0
equal 'smooth, free: the start, which needs no help' '"init"' \
  "$(get diagnostics.start | tr ' ' '\n' | sort -u)"
family 'cables, measured' smooth 150 1.01 0.02 ',"length_sigma":0.01'
# One place that nearly is a cusp does not slow all others: long steps were
# refused everywhere, and no start came to its end.
if [ "${PH_SHORT-}" != 1 ]; then
  all=$seeds
  seeds=41
  family 'a cable, measured, with a sharp place' smooth 500 1.01 0.02 \
    ',"length_sigma":0.01'
  seeds=$all
fi
family 'walks, measured' walk 150 1.2 0.4 ',"length_sigma":0.1'
equal 'walks, measured: the start' '"wiggle"' \
  "$(get diagnostics.start | tr ' ' '\n' | sort -u)"
for width in 0.001 0.01 0.2; do
  family "ribbons, lengths off by $width" ribbon 1000 1 "$width"
done
family 'ribbons, directions off' ribbon 1000 1 0 '' 1e-3
# Where phases turn, so do the multipliers of directions.
family 'ribbons, 3000' ribbon 3000 1 0.001
get diagnostics.iterations | tr ' ' '\n' |
  holds 'ribbons, 3000: steps' 'x[1] < 8 && x[n] < 8'
equal 'ribbons have two segments from datum to datum' '[0,1]' \
  "$(get 'intervals[0].segments' | tr ' ' '\n' | sort -u)"
# Bends of a radian, straight between: the Hessian is nearly singular.
awk 'BEGIN {
  printf "{\"tangents\":["
  for (i = 0; i < 2000; i++) {
    k = int(i / 97)
    printf "%s[%.17g,%.17g,%.17g]", i ? "," : "", cos(k), sin(k), sin(k * k)
  }
  print "],\"lengths\":1}"
}' >bends.json
run arclength --quiet bends.json
equal 'ribbons, sharp bends: the first start is a minimum' '0 "init" "minimiser"' \
  "$status $(get 'diagnostics.starts[@].start' <out) $(
    get diagnostics.second_order <out)"
for factor in 1.0001 1.001 1.01; do
  family "8 points, $factor of the chords" walk 7 "$factor" 0
  # Steps of any length are taken back onto the rows: where lengths are short
  # whole ones are too long, and the first start ended in nothing.
  equal "8 points, $factor of the chords: the first start" '"init"' \
    "$(get diagnostics.start | tr ' ' '\n' | head -n 1)"
done

# Exact directions that are off wind the curve, and need not be kept for those
# that are measured: the fit begins where the start does.
family 'ribbons, directions measured' ribbon 1600 1 0.001 \
  ',"tangent_sigma":0.05' 0.05
get diagnostics.iterations | tr ' ' '\n' |
  holds 'ribbons, directions measured: steps' \
    'x[1] < 70 && x[n] < 70'
equal 'ribbons, directions measured: starts' '"init"' \
  "$(get 'diagnostics.starts[@].start' | tr ' ' '\n' | sort -u)"
