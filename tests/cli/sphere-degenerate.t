# SPDX-License-Identifier: GPL-3.0-or-later
#
# Data on a sphere at the edge of what makes sense: few points, great circles,
# poles, points that come again or nearly coincide, extreme sizes and tensions.
#
# shellcheck disable=SC2034  # rough is for sphere.sh
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/sphere.sh"

# length_is NAME WANTED [RELATIVE]: of the curve in out
length_is() {
  get length | holds "$1: the length" \
    "n == 1 && (x[1] / ($2) - 1)^2 <= (${3-1e-13})^2"
}

degree=0.017453292519943295
pi=3.141592653589793

# ---- few points --------------------------------------------------------------

for model in exact nielson; do
  for ends in natural rest; do
    curve "two points, $model, $ends" '"lonlat":[[0,0],[10,20]]' \
      --model=$model --ends=$ends
    length_is "two points, $model, $ends" 0.3886629117282935
    curve "two points near each other, $model, $ends" \
      '"points":[[1,0,0],[1,2e-8,0]]' --model=$model --ends=$ends
    length_is "two points near each other, $model, $ends" 2e-8
  done
  curve "three points, $model" '"lonlat":[[0,0],[10,20],[20,0]]' --model=$model
  curve "three points, closed, $model" \
    '"points":[[1,0,0],[0,1,0],[0,0,1]],"closed":true' --model=$model
done
curve 'two points, a tension' '"lonlat":[[0,0],[10,20]],"tension":7'
equal 'two points, a tension: it has no effect at the ends' '[0,0]' \
  "$(get tensions)"

# ---- the first point again ---------------------------------------------------

square='[0,0],[10,0],[10,10],[0,10]'
curve 'closed' "\"lonlat\":[$square],\"closed\":true"
mv out closed
for last in '[0,0]' '[360,0]'; do
  curve "closed, $last again" "\"lonlat\":[$square,$last],\"closed\":true"
  equal_files "closed, $last again: it is dropped" closed out
done
curve 'closed, with a tension for the point that is dropped' \
  "\"lonlat\":[$square,[0,0]],\"closed\":true,\"tension\":[1,2,3,4,1]"
mv out five
curve 'closed, with four tensions for five points' \
  "\"lonlat\":[$square,[0,0]],\"closed\":true,\"tension\":[1,2,3,4]"
equal_files 'closed, with four tensions for five points: the same' five out
equal 'closed, tensions: one for each node' '[1,2,3,4]' "$(get tensions)"
curve 'open, the first point again' "\"lonlat\":[$square,[0,0]]"
joints >found
printf '%s\n' 0,0 10,0 10,10 0,10 0,0 | awk -F, -v d=$degree '{
  printf "%.17g,%.17g,%.17g\n", cos($2 * d) * cos($1 * d),
    cos($2 * d) * sin($1 * d), sin($2 * d) }' >want
numbers 'open, the first point again: five joints' 1e-15 want found
curve 'a point that comes again' \
  '"lonlat":[[0,0],[10,10],[20,0],[10,10],[0,20]]'
curve 'a figure of eight' '"lonlat":[[0,0],[10,10],[20,0],[10,-10],[0,0],
  [-10,10],[-20,0],[-10,-10]],"closed":true'

# ---- great circles -----------------------------------------------------------

# circle NAME LENGTH POINTS [ARGUMENT...]: the curve stays on the great circle
# of the points, by no tension; where every step takes long, in either model for
# one in three circles.
circle() {
  name=$1 wanted=$2
  points=$3
  shift 3
  for model in exact nielson; do
    one_in 3 || continue
    curve "$name, $model" "\"lonlat\":[$points]" --model=$model "$@"
    length_is "$name, $model" "$wanted"
    floats tensions | awk '$1 != 0 { bad = 1 } END { exit bad }'
    equal "$name, $model: tensions" 0 $?
    equal "$name, $model: shape" true "$(get diagnostics.shape_ok)"
    cut -d, -f11 samples.csv | sed 1d |
      awk '!($1 * $1 < 1e-22) { bad = 1 } END { exit bad || NR < 9 }'
    equal "$name, $model: no curvature" 0 $?
  done
}

circle 'along the equator' "150 * $degree" '[0,0],[1,0],[40,0],[100,0],[150,0]'
circle 'more than once around' "450 * $degree" \
  '[0,0],[100,0],[200,0],[300,0],[40,0],[90,0]'
circle 'along a meridian' "170 * $degree" '[30,-80],[30,-20],[30,0],[30,90]'
circle 'over a pole' "100 * $degree" '[20,60],[20,80],[-160,70],[-160,20]'
circle 'through both poles' "270 * $degree" '[0,0],[77,90],[180,0],[-77,-90]'
circle 'along the date line' "80 * $degree" '[180,-40],[-180,0],[180,40]'
circle 'over the date line' "30 * $degree" '[170,0],[175,0],[-175,0],[-160,0]'
circle 'the equator' "2 * $pi" '[0,0],[90,0],[180,0],[270,0]' --closed
circle 'the equator, three points' "2 * $pi" '[0,0],[120,0],[240,0]' --closed
circle 'the equator, uneven' "2 * $pi" '[0,0],[1,0],[150,0],[300,0]' --closed
circle 'a meridian, over the poles' "2 * $pi" \
  '[50,0],[50,60],[-130,80],[-130,0],[-130,-60],[50,-80]' --closed
circle 'twice around' "4 * $pi" \
  '[0,0],[120,0],[240,0],[0,0],[120,0],[240,0]' --closed
points=$(awk 'BEGIN { for (i = 0; i < 400; i++) printf "%s[%.17g,0]",
  i ? "," : "", 0.9 * i }')
circle 'the equator, 400 points' "2 * $pi" "$points" --closed

# ---- poles, the date line ----------------------------------------------------

curve 'a pole between' '"lonlat":[[0,80],[50,90],[90,80]]'
curve 'a pole of any longitude' '"lonlat":[[0,80],[-123,90],[90,80]]'
mv out any
curve 'a pole without a longitude' '"lonlat":[[0,80],[0,90],[90,80]]'
get length >found
mv out none
mv any out
get length >want
numbers 'the longitude of a pole has no effect' 1e-14 want found
curve 'around a pole' \
  '"lonlat":[[0,85],[90,86],[180,85],[-90,84]],"closed":true'
cut -d, -f11 samples.csv | sed 1d |
  holds 'around a pole: always to the left' 'n == 36 && x[1] > 0 && x[9] > 0 &&
    x[17] > 0 && x[28] > 0 && x[36] > 0'
curve 'over the date line' '"lonlat":[[170,10],[-170,10],[-150,20]]'
get length >want
curve 'over no date line' '"lonlat":[[20,10],[40,10],[60,20]]'
get length >found
numbers 'the date line has no effect' 1e-14 want found

# ---- data that turn back -----------------------------------------------------

rough=1
curve 'to and fro' '"lonlat":[[0,0],[10,0],[0,0]]'
length_is 'to and fro' "20 * $degree"
curve 'to and fro, closed' \
  '"lonlat":[[0,0],[10,0],[20,0],[10,0]],"closed":true'
length_is 'to and fro, closed' "40 * $degree"
curve 'to and not as far fro' '"lonlat":[[0,0],[10,0],[5,0]]'
floats indicators | holds 'to and not as far fro: no side to turn to' \
  'n == 3 && x[2] == 0'
rough=1e-9

# ---- wide and narrow spacings ------------------------------------------------

for gap in 1e-1 1e-2 1e-3 1e-4; do
  wide=$(awk "BEGIN { printf \"%.17g\", 180 - $gap / $degree }")
  curve "$gap less than half around" "\"lonlat\":[[0,0],[$wide,0],[$wide,30]]"
  get length | holds "$gap less than half around: not another way" \
    "n == 1 && x[1] < 1.1 * ($pi - $gap + 30 * $degree)"
done
for size in 1 1e-2 1e-3; do
  case $size in 1) rough=1e-9 ;; 1e-2) rough=1e-6 ;; *) rough=1e-4 ;; esac
  # an arc of a circle of latitude 45: its curvature is 1
  points=$(awk "BEGIN { for (i = 0; i < 40; i++)
    printf \"%s[%.17g,45]\", i ? \",\" : \"\", $size * i }")
  curve "40 points, $size degrees apart" "\"lonlat\":[$points]"
  awk -F, '$2 == 20 { print $11 }' samples.csv |
    holds "40 points, $size degrees apart: curvature" \
      'n == 9 && (x[1] - 1)^2 < 1e-4 && (x[5] - 1)^2 < 1e-4'
done
rough=1e-9
points=$(awk 'BEGIN { for (i = 0; i < 2000; i++)
  printf "%s[%.17g,%.17g]", i ? "," : "", 0.1 * i, 50 * sin(i / 200) }')
curve 'a dense track' "\"lonlat\":[$points]"
floats indicators | sort -n | uniq -c | holds \
  'a dense track: it is not taken for great circles' \
  'n == 3 && x[1] > 900 && x[2] < 50 && x[3] > 900'
floats tensions | holds 'a dense track: smooth data need no tension' \
  'n == 2000 && x[500] == 0 && x[1000] == 0 && x[1500] == 0'

# Where steps are longer than 1/100 each tension was solved by Newton's method
# anew, in thousands of iterations, and took three times as long.
for step in 1e-5 0.012 0.1; do
  case $step in 1e-5) rough=1e-4 ;; *) rough=1e-9 ;; esac
  points=$(awk -v h=$step 'function noise() {
    seed = (seed * 9301 + 49297) % 233280
    return (seed / 233280 - 0.5) * h / 3
  }
  BEGIN { for (i = 0; i < 200; i++) {
    lon = h * i + noise()
    lat = 0.5 * sin(0.7 * h * i) + noise()
    printf "%s[%.17g,%.17g,%.17g]", i ? "," : "", cos(lat) * cos(lon),
      cos(lat) * sin(lon), sin(lat)
  } }')
  curve "a noisy track, steps of $step" "\"points\":[$points]"
  floats diagnostics.tension_sum | holds \
    "a noisy track, steps of $step: some are raised" 'n == 1 && x[1] > 100'
  floats diagnostics.iterations | holds "a noisy track, steps of $step: iterations" \
    'n == 1 && x[1] < 200'
done

# ---- sizes -------------------------------------------------------------------

# The same points, times a power of two: the same curve, times that, exactly.
scale='BEGIN { half = int(p / 2); a = 2^half; b = 2^(p - half) }'
printf '1 0 0\n0.6 0.8 0\n0 0.6 0.8\n-0.6 0 0.8\n' >unit
points_of() {
  awk -v p="$1" "$scale"'{
    printf "%s[%.17g,%.17g,%.17g]", (NR > 1 ? "," : ""), $1 * a * b, $2 * a * b,
      $3 * a * b }' unit
}
radius_of() {
  awk -v p="$1" "$scale"'END { printf "%.17g", a * b }' unit
}
for more in '' ',"model":"nielson","ends":"rest"' ',"closed":true'; do
  case $more in *nielson*) rough=0.5 ;; *) rough=1e-9 ;; esac
  curve "size 1 $more" "\"points\":[$(points_of 0)]$more"
  joints | tr ',' '\n' >base
  get length >>base
  for power in -990 -30 30 990; do
    curve "size 2^$power $more" \
      "\"points\":[$(points_of $power)],\"radius\":$(radius_of $power)$more"
    { joints | tr ',' '\n'; get length; echo; } |
      awk -v p=$((-power)) "$scale"'NF { printf "%.17g\n", $1 * a * b }' |
      sed 's/^-0$/0/' >found
    { cat base; echo; } | awk 'NF { printf "%.17g\n", $1 }' |
      sed 's/^-0$/0/' >want
    numbers "size 2^$power $more: the same curve" 0 want found
  done
done
for radius in 1e-9 1e9; do
  curve "radius $radius" \
    "\"lonlat\":[[0,0],[10,20],[40,30]],\"radius\":$radius"
done
rough=1e-6
curve 'a center far away' '"lonlat":[[0,0],[10,20],[40,30]],
  "center":[1e6,-1e6,1e6]'
get length >found
rough=1e-9
curve 'a center at the origin' '"lonlat":[[0,0],[10,20],[40,30]]'
get length >want
numbers 'a center far away: the same length' 1e-14 want found

# ---- tensions ----------------------------------------------------------------

some='"lonlat":[[0,0],[10,20],[40,30],[60,-10],[100,-20]]'
some_angles=$(awk -v d=$degree "$sphere_awk"'
  BEGIN {
    split("0 10 40 60 100", lon, " ")
    split("0 20 30 -10 -20", lat, " ")
    for (i = 1; i <= 5; i++) {
      q[1] = cos(lat[i] * d) * cos(lon[i] * d)
      q[2] = cos(lat[i] * d) * sin(lon[i] * d)
      q[3] = sin(lat[i] * d)
      if (i > 1) sum += angle(p, q)
      for (k = 1; k <= 3; k++) p[k] = q[k]
    }
    printf "%.17g", sum
  }')
for model in exact nielson; do
  rough=1e-7
  curve "tension 1e8, $model" "$some,\"tension\":1e8" --model=$model
  length_is "tension 1e8, $model: great circles" "$some_angles" 1e-7
  equal "tension 1e8, $model: tensions" \
    '[0,100000000,100000000,100000000,0]' "$(get tensions)"
done
# A turn by nearly pi takes a tension that is 4265 over the spacing: the curve is
# the same at every step, and for a radius in metres.
hook() {
  awk -v h="$1" -v r="$2" 'BEGIN {
    split("0 1 2e-4 -0.55 0.3 0.95 1.2 2.1", x, " ")
    split("0 0 2.5e-4 0.83 1.35 2.1 3.07 2.6", y, " ")
    printf "{\"radius\":%s,\"points\":[", r
    for (i = 1; i <= 8; i++) {
      a = sin(h * x[i]); b = sin(h * y[i]); c = (1 - a * a - b * b)^0.5
      printf "%s[%.17g,%.17g,%.17g]", (i > 1 ? "," : ""), r * a, r * b, r * c
    }
    print "]}" }'
}
for step in 1e-3 1e-5 1e-7; do
  for radius in 1 6371000; do
    feed "$(hook "$step" "$radius")" sphere --strict
    expect "steps of $step, radius $radius" 0
    get diagnostics.tension_relative_sum |
      holds "steps of $step, radius $radius: tension" \
        '(x[1] - 4265.2) ^ 2 < 0.4 ^ 2'
    get length | holds "steps of $step, radius $radius: length" \
      "(x[1] / $step / $radius - 7.2149003) ^ 2 < 1e-6 ^ 2"
  done
done

curve 'tensions of all sizes' "$some,\"tension\":[1,1e8,1e-8,5e-324,0]"
equal 'tensions of all sizes: they are kept' '[1,100000000,1e-8,5e-324,0]' \
  "$(get tensions)"
curve 'an epsilon that all curves have' "$some,\"epsilon\":1e300"
curve 'knots that differ much' \
  "$some,\"shape\":false,\"knots\":[0,0.1,1,3,3.5]"
curve 'knots far apart' "$some,\"knots\":[1e49,2e49,3e49,4e49,5e49]"
curve 'knots near each other' "$some,\"knots\":[-1e-49,0,1e-49,2e-49,3e-49]"

# Random points, up to half a great circle apart: a fold at one of them does not
# lose the others.  (The generator of Park and Miller.)
awk -v n=400 'function uniform() {
    state = (state * 16807) % 2147483647
    return state / 2147483647
  }
  BEGIN {
    state = 6 * 1000003 + n
    for (i = 0; i < 10; i++) uniform()
    for (i = 0; i < n; i++) {
      z = 2 * uniform() - 1
      t = 6.283185307179586 * uniform()
      r = sqrt(1 - z * z)
      data = data (i ? "," : "") \
        sprintf("[%.17g,%.17g,%.17g]", r * cos(t), r * sin(t), z)
    }
    print "{\"points\":[" data "]}"
  }' >random.json
run sphere -q random.json
equal 'random points' '0 true' "$status $(get diagnostics.shape_ok)"
mv out r
run verify -q r
expect 'random points: verified' 0
