# SPDX-License-Identifier: GPL-3.0-or-later
#
# Data of arclength that formulas divide by: few intervals, straight and plane
# data, reversals, equal and opposite tangents, huge and tiny sizes, far from
# the origin, and many of them.  A curve that comes out has a certificate, which
# the program has checked itself.
. "$srcdir/tests/cli/lib.sh"

# solve PROBLEM [ARGUMENT...]: its members, without warnings
solve() {
  text="{$1}"
  shift
  feed "$text" arclength -q "$@"
}

# curve NAME PROBLEM: there is a curve, and its lengths, where they are given,
# are those
curve() {
  solve "$2"
  expect "$1" 0
  case $2 in
  *sigma*) ;;
  *'"lengths":['*)
    printf '%s\n' "$2" | tr -d '\n' |
      sed 's/.*"lengths":\[\([^]]*\)\].*/\1/' | tr ',' '\n' >want
    json get intervals out | tr '{' '\n' | sed -n 's/"length":\([^,]*\),.*/\1/p' \
      >found
    paste want found | awk '{
      if (($2 / $1 - 1)^2 > 1e-20) bad = 1
    } END { exit bad || NR < 1 }'
    equal "$1: lengths" 0 $?
    ;;
  esac
}

# minimum NAME F PROBLEM: a minimum in space, F at most that
minimum() {
  curve "$1" "$3"
  equal "$1: a minimiser" '"minimiser"' "$(get diagnostics.second_order)"
  get diagnostics.F | holds "$1: F" "n == 1 && x[1] >= 0 && x[1] <= $2"
}

# flat NAME PROBLEM: the curve has z = 0, exactly
flat() {
  solve "$2" -f csv
  expect "$1" 0
  awk -F, 'NR > 1 && $6 != "0" { bad = 1 } END { exit bad || NR < 7 }' out
  equal "$1: z is 0" 0 $?
}

# line NAME PROBLEM: the curve runs straight on along (1, 2, 2)
line() {
  solve "$2" -f csv
  expect "$1" 0
  awk -F, 'NR > 1 {
    t = ($4 + 2 * $5 + 2 * $6) / 9
    if (($4 - t)^2 + ($5 - 2 * t)^2 + ($6 - 2 * t)^2 > 1e-24) bad = 1
    if ($3 > 0 && t <= last) bad = 1
    last = t
  } END { exit bad || NR < 7 }' out
  equal "$1: straight on" 0 $?
}

# ---- one interval ------------------------------------------------------------

echo '{"points":[[0,0],[1,0]],"lengths":[2]}' >single
echo '{"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]],"lengths":[5,3,2]}' |
  cat - single >two
run arclength -q single
mv out alone
run arclength -q -j 1 two
sed -n 2p out >behind
equal_files 'behind another problem as alone' alone behind

# The curve between two points is known: F is 0, and it is symmetric.
two='"points":[[0,0,0],[1,2,2]]'
minimum 'two points' 1e-25 "$two"
line 'two points: a line' "$two"
for refine in 1 2 3; do
  minimum "two points, a length, refine $refine" 1e-25 \
    "$two,\"lengths\":[4],\"refine\":$refine"
  line "two points, the chord, refine $refine" \
    "$two,\"lengths\":[3],\"refine\":$refine"
done
for length in 3.0000000000015 3.000000001 3.000003 30 3e6 3e11; do
  minimum "two points, length $length" "1e-28 * $length" "$two,\"lengths\":[$length]"
done
# Below the chord by less than 1e-12 of it is the chord.
line 'two points, hardly below the chord' "$two,\"lengths\":[2.9999999999985]"
minimum 'two points, a length to fit' 1e-25 \
  "$two,\"lengths\":[4],\"length_sigma\":0.1"
get 'intervals[0].length' | holds 'two points: it fits' '(x[1] - 4)^2 < 1e-24'
line 'two points, a length below the chord to fit' \
  "$two,\"lengths\":[2],\"length_sigma\":0.1"
solve "$two,\"lengths\":[2],\"length_sigma\":0.1"
get diagnostics.length_rms |
  holds 'two points: what is missed, in sigmas' '(x[1] - 5)^2 < 1e-20'
solve "$two,\"lengths\":[4],\"all_minima\":true,\"starts\":3"
equal 'two points, all minima: one' '1 "exact"' \
  "$(json get solutions out | tr '{' '\n' | grep -c '"good"') $(
    get diagnostics.start)"
flat 'two points in the plane' '"points":[[0,0],[1,0]],"lengths":[1.5]'
minimum 'two tangents' 1e-25 '"tangents":[[1,0,0],[0,1,0]],"lengths":[2]'
minimum 'two tangents, equal' 1e-25 \
  '"tangents":[[1,2,2],[1,2,2]],"lengths":[3]'
line 'two tangents, equal: a line' '"tangents":[[1,2,2],[1,2,2]],"lengths":[3]'
minimum 'two tangents, opposite' 1e-25 \
  '"tangents":[[1,2,2],[-1,-2,-2]],"lengths":[3]'
minimum 'two derivatives' 0.375701333 \
  '"derivatives":[[1,0,0],[0,1,0]],"lengths":[1]'
minimum 'two derivatives, equal' 1e-25 \
  '"derivatives":[[1,2,2],[1,2,2]],"lengths":[3]'
line 'two derivatives, equal: a line' \
  '"derivatives":[[1,2,2],[1,2,2]],"lengths":[3]'
minimum 'two derivatives, opposite' 5.784785419 \
  '"derivatives":[[1,0,0],[-1,0,0]],"lengths":[1]'

# ---- a line ------------------------------------------------------------------

row='"points":[[0,0,0],[1,2,2],[2,4,4],[4,8,8]]'
for refine in 1 2 3; do
  line "points on a line, refine $refine" "$row,\"refine\":$refine"
  line "points on a line, their chords, refine $refine" \
    "$row,\"lengths\":[3,3,6],\"refine\":$refine"
  line "tangents that are equal, refine $refine" \
    "\"tangents\":[[1,2,2],[1,2,2],[2,4,4]],\"lengths\":[3,1],
\"refine\":$refine"
  line "derivatives that are equal, refine $refine" \
    "\"derivatives\":[[1,2,2],[1,2,2],[1,2,2]],\"lengths\":[3,3],
\"refine\":$refine"
done
line 'points on a line, uniform knots' "$row,\"knots\":\"uniform\""
line 'points on a line, their chords, uniform knots' \
  "$row,\"lengths\":[3,3,6],\"knots\":\"uniform\""
line 'points on a line, in space' "$row,\"lengths\":[3,3,6],\"planar\":\"free\""
for more in 1.1 1.000001 1.0000000001; do
  lengths=$(echo "3 3 6" | awk "{ printf \"%.17g,%.17g,%.17g\",
    $more * \$1, $more * \$2, $more * \$3 }")
  curve "points on a line, lengths $more times" "$row,\"lengths\":[$lengths]"
  equal "points on a line, lengths $more times: in a plane" true \
    "$(get diagnostics.planar)"
done
curve 'points on a line, long' "$row,\"lengths\":[4,4,8],\"planar\":\"free\""
equal 'points on a line, long: in space' 'false "minimiser"' \
  "$(get diagnostics.planar) $(get diagnostics.second_order)"
curve 'points on a line, some lengths to fit' \
  "$row,\"lengths\":[3,4,5],\"length_sigma\":0.1"

# ---- reversals ---------------------------------------------------------------

for more in '' ',"planar":"free"'; do
  curve "forth and back $more" "\"points\":[[0,0,0],[1,0,0],[0,0,0]]$more"
  curve "forth and back, lengths $more" \
    "\"points\":[[0,0,0],[1,0,0],[0,0,0]],\"lengths\":[1.5,1.5]$more"
  curve "forth and back unevenly $more" \
    "\"points\":[[0,0,0],[2,0,0],[1,0,0],[3,0,0]]$more"
  curve "forth and back unevenly, lengths $more" \
    "\"points\":[[0,0,0],[2,0,0],[1,0,0],[3,0,0]],\"lengths\":[2.5,1.5,2.5]$more"
  curve "forth, back and aside $more" \
    "\"points\":[[0,0,0],[1,0,0],[0,0,0],[0,1,1]]$more"
  curve "opposite derivatives $more" \
    "\"derivatives\":[[1,2,3],[-1,-2,-3],[1,2,3]],\"lengths\":[4,4]$more"
  curve "opposite tangents of mean magnitudes $more" \
    "\"tangents\":[[1,0,0],[-1,0,0],[1,0,0]],\"lengths\":[1,2],
\"magnitudes\":\"mean\"$more"
  curve "three reversals of tangents $more" \
    "\"tangents\":[[1,0,0],[-1,0,0],[1,0,0],[-1,0,0]],\"lengths\":[1,1,1]$more"
done

# ---- closed ------------------------------------------------------------------

minimum 'a triangle' 7.1479816037 '"points":[[0,0],[1,0],[0,1]],"closed":true'
minimum 'a triangle, lengths' 8.6391036306 \
  '"points":[[0,0],[1,0],[0,1]],"closed":true,"lengths":[1.2,1.7,1.2]'
minimum 'a triangle, tilted' 12.928553025 '"points":[[0,0,1],[1,0,1],[0,1,2]],
"closed":true,"lengths":[1.2,2.0,1.7]'
minimum 'a triangle, in space' 12.928553025 '"points":[[0,0,1],[1,0,1],[0,1,2]],
"closed":true,"lengths":[1.2,2.0,1.7],"planar":"free"'
curve 'a triangle, long' \
  '"points":[[0,0],[1,0],[0,1]],"closed":true,"lengths":[100,100,100]'
curve 'three points on a line, closed' '"points":[[0,0],[1,0],[2,0]],"closed":true'
curve 'three points on a line, closed, lengths' \
  '"points":[[0,0],[1,0],[2,0]],"closed":true,"lengths":[1.2,1.2,2.5]'
curve 'the same two points twice, closed' \
  '"points":[[0,0,0],[1,0,0],[0,0,0],[1,0,0]],"closed":true'
# a figure of 8 turns by 0, a circle by 360 degrees
curve 'a figure of 8' '"points":[[0,0],[1,1],[2,0],[1,-1],[0,0.001],[-1,1],
[-2,0],[-1,-1]],"closed":true'
curve 'a circle' '"points":[[1,0],[0,1],[-1,0],[0,-1]],"closed":true,
"lengths":[1.57,1.57,1.57,1.57]'
get 'diagnostics.frame_turn' |
  holds 'a circle: the frame comes back' 'n == 1 && x[1]^2 < 1e-20'

# As sin and cos of 2 pi give it: the last point repeats the first.
curve 'a circle that nearly comes back' '"points":[[1,0],[0,1],[-1,0],[0,-1],
[1,-2.4e-16]],"closed":true,"lengths":[1.57,1.57,1.57,1.57]'
equal 'a circle that nearly comes back: four intervals' '[6,7] absent' \
  "$(get 'intervals[3].segments') $(get 'intervals[4]')"

# ---- planes ------------------------------------------------------------------

for lengths in '' ',"lengths":[1.35,1.04,1.07]'; do
  flat "the plane z = 0 $lengths" \
    "\"points\":[[0,0],[1,0.8],[2,1],[3,0.7]]$lengths"
  flat "the plane z = 0, far away $lengths" "\"points\":[[1000000,1000000],
[1000001,1000000.8],[1000002,1000001],[1000003,1000000.7]]$lengths"
done
flat 'tangents in the plane' \
  '"tangents":[[1,0],[1,1],[0,1],[-1,0.1]],"lengths":[1,2,3]'
flat 'derivatives in the plane' \
  '"derivatives":[[1,0],[1,1],[0,1],[-1,0.1]],"lengths":[1,1.2,0.8]'

# A plane through the origin that is tilted, z = x + y; the curve stays in it to
# rounding, also far from the origin.
for offset in 0 1048576; do
  points=$(echo "0 0 1 0.75 2 1 3 0.75" | awk "{
    for (i = 1; i < NF; i += 2)
      printf(\"%s[%.17g,%.17g,%.17g]\", i > 1 ? \",\" : \"\", \$i + $offset,
        \$(i + 1) + $offset, \$i + \$(i + 1) + $offset) }")
  for lengths in '' ',"lengths":[2.4,1.7,1.4]'; do
    curve "a tilted plane at $offset $lengths" "\"points\":[$points]$lengths"
    equal "a tilted plane at $offset: it is seen $lengths" true \
      "$(get diagnostics.planar)"
    solve "\"points\":[$points]$lengths" -f csv
    awk -F, "NR > 1 {
      d = (\$4 - $offset) + (\$5 - $offset) - (\$6 - $offset)
      if (d * d > (1e-14 * (4 + 4 * $offset))^2) bad = 1
    } END { exit bad || NR < 7 }" out
    equal "a tilted plane at $offset: the curve is in it $lengths" 0 $?
  done
done

# ---- sizes and places --------------------------------------------------------

# The same curve 2^k times as large, or moved by what is no rounding.
fig5='[1,1,0],[0,4,3],[2,4,2],[3,3,3]'
solve "\"points\":[$fig5],\"lengths\":[4.875,2.5,2]" -f csv
mv out one
for k in -500 -100 100 500; do
  echo "$fig5,4.875,2.5,2" | tr -d '[]' | tr ',' '\n' |
    awk "{ printf \"%.17g \", \$1 * 2^($k) } END { print \"\" }" |
    awk '{ printf "\"points\":[[%s,%s,%s],[%s,%s,%s],[%s,%s,%s],[%s,%s,%s]],",
      $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12
      printf "\"lengths\":[%s,%s,%s]\n", $13, $14, $15 }' >scaled
  solve "$(cat scaled)" -f csv
  expect "2^$k times as large" 0
  awk -F, "NR == 1 { print; next } { printf \"%s,%s,%s,%.17g,%.17g,%.17g\\n\",
    \$1, \$2, \$3, \$4 * 2^(-($k)), \$5 * 2^(-($k)), \$6 * 2^(-($k)) }" out >two
  numbers "2^$k times as large: the same curve" 1e-12 one two
done
for offset in 1048576 -1073741824; do
  echo "$fig5" | tr -d '[]' | tr ',' '\n' |
    awk "{ printf \"%.17g \", \$1 + $offset } END { print \"\" }" |
    awk '{ printf "\"points\":[[%s,%s,%s],[%s,%s,%s],[%s,%s,%s],[%s,%s,%s]]",
      $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12 }' >moved
  solve "$(cat moved),\"lengths\":[4.875,2.5,2]" -f csv
  expect "$offset away" 0
  awk -F, "NR == 1 { print; next } { printf \"%s,%s,%s,%.17g,%.17g,%.17g\n\",
    \$1, \$2, \$3, \$4 - $offset, \$5 - $offset, \$6 - $offset }" out >two
  numbers "$offset away: the same curve" 2e-6 one two
done
minimum 'tiny derivatives' 1.6458990775e-300 '"derivatives":[[1e-300,0,0],
[0,1e-300,0],[0,0,1e-300]],"lengths":[1e-300,1e-300]'
minimum 'huge derivatives' 1.6458990775e300 '"derivatives":[[1e300,0,0],
[0,1e300,0],[0,0,1e300]],"lengths":[1e300,1e300]'
fig5_300='"points":[[1e300,1e300,0],[0,4e300,3e300],[2e300,4e300,2e300],
[3e300,3e300,3e300]]'
curve 'huge points' "$fig5_300"
curve 'huge points, lengths' "$fig5_300,\"lengths\":[4.9e300,2.5e300,2e300]"
curve 'tiny points' '"points":[[1e-300,1e-300,0],[0,4e-300,3e-300],
[2e-300,4e-300,2e-300],[3e-300,3e-300,3e-300]],"lengths":[4.9e-300,2.5e-300,2e-300]'
curve 'a chord of 1e-9 others' \
  '"points":[[0,0,0],[1,0,0],[1,1e-9,0],[2,1,1]]'
curve 'a road that is nearly straight' \
  '"points":[[0,0,0],[1,1e-6,0],[2,0,1e-6],[3,1e-6,1e-6],[4,0,0]]'
curve 'a long way to go' '"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]],
"lengths":[490,250,200]'
feed '{"points":[[-1.7e308,0,0],[1.7e308,0,0],[1.7e308,1.7e308,0]]}' arclength
expect 'more than a double holds' 1 "phspline: -:1: record 1: the curve \
exceeds the range of a double [too-large]
$(failed 1 1)"

# ---- many --------------------------------------------------------------------

# A helix, with free lengths and with lengths that fit it.
if instrumented; then
  free=2000 given=1000
else
  free=30000 given=5000
fi
awk "BEGIN {
  print \"x,y,z,length\"
  for (i = 0; i <= $free; i++) {
    t = i * 0.01
    printf \"%.17g,%.17g,%.17g,%s\\n\", cos(t), sin(t), t / 10,
      i ? \"0.010049875621120891\" : \"\"
  }
}" >many.csv
run arclength -q -f csv --table=lengths --columns=x,y,z,- many.csv
expect 'many points' 0
true_that 'many points: a segment each' count $((free + 1)) out

# Phases that grow from datum to datum add up to hundreds of turns.
awk 'BEGIN { for (i = 0; i < 2000; i++) {
  t = i * 0.8
  printf "%.17g,%.17g,%.17g\n", cos(t), sin(t), 0.3 * t } }' >helix.csv
run arclength -q helix.csv
expect 'many turns' 0
true_that 'many turns: few steps' test "$(get diagnostics.iterations)" -le 20

sed "$((given + 3)),\$d" many.csv >some.csv
run arclength -q -f csv --table=lengths some.csv
expect 'many lengths' 0
true_that 'many lengths: two segments each' count $((2 * given + 1)) out
awk -F, 'NR > 1 && NR % 2 { d = $6 / ((NR - 1) / 2 * 0.010049875621120891) - 1
  if (d * d > 1e-22) bad = 1 } END { exit bad || NR < 3 }' out
equal 'many lengths: those of the table' 0 $?

# ---- near-cusps ----------------------------------------------------------------

# Free lengths, and chords that differ by factors of 6000 and of 2000: there was
# no answer, though starts led to curves.
cusp() {
  feed "$2" arclength
  equal "$1" "0 $3" "$status $(get diagnostics.second_order)"
  mv err told
  mv out r
  run verify r
  expect "$1: verified" 0
}
cusp 'a near-cusp: a minimum' '{"points":[[0,0,0],[-0.30904,-0.04992,0.31352],
[-0.31922,-0.05505,0.30742],[-0.31918,-0.05512,0.30744],
[-0.31753,-0.05755,0.30754],[-0.32303,-0.05989,0.30807]]}' '"minimiser"'
cusp 'near-cusps: a minimum' '{"points":[[0,0,0],[-0.00271,-0.00356,0.00047],
[-0.07043,-0.02027,0.14893],[0.21585,-0.11862,0.25382],
[0.21306,-0.11846,0.25049],[0.21271,-0.11963,0.24981],
[0.21261,-0.11971,0.24981],[0.21296,-0.12024,0.24937]]}' '"minimiser"'
# multipliers of 1e9
cusp 'near-cusps: a saddle' '{"points":[[0,0,0],[0.00155,0.00159,0.00191],
[0.00178,0.00153,0.00197],[-0.05851,0.03158,-0.04125],[-0.13942,0.15967,-0.10968],
[-0.23715,0.15823,-0.61994]],"lengths":[0.00296,0.00025,0.08084,0.16791,0.52474]}' \
  '"saddle"'
true_that 'near-cusps: a saddle: told' grep -q 'is stationary.*\[saddle\]' told
