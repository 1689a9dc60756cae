# SPDX-License-Identifier: GPL-3.0-or-later
#
# C2 curves of prescribed arc lengths: what their results hold, and what each
# field does.  (CSV, sweeps and options: arclength-csv.t; errors and warnings:
# arclength-errors.t.)
#
# Data are those of Huard et al. 2014, most with their uniform knots, and the
# functional F is their eq. (19); minima of it were found by another program.
. "$srcdir/tests/cli/lib.sh"

fig5='"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]]'
fig5_lengths="$fig5,\"lengths\":[4.9,2.5,2]"
fig7='"points":[[0,0,0],[0,1,0],[1,1,0],[1,1,1]]'
fig13='"derivatives":[[-2,-1,-1],[1,0.5,0.5],[0,1,0.5],[0,-1,-0.5]],'\
'"lengths":[1.2,1.4,0.7]'
fig14='"derivatives":[[1,0,0],[0,1,0],[0,0,1],[1,0,0]],"lengths":[1,1,1]'
# section 5.3: what the sensors of a ribbon measure
ribbon='"tangents":[[0.3862,-0.0315,0.9219],[0.3775,-0.1613,0.9118],'\
'[0.4077,-0.1947,0.8921],[0.4444,-0.3071,0.8415],[0.3224,-0.4485,0.8336],'\
'[0.3913,-0.4889,0.7797],[0.2771,-0.5945,0.7548],[0.171,-0.7053,0.688]],'\
'"lengths":[170.05,169.5,168.26,169.33,169.53,168.82,170.1]'
hexagon='"closed":true,"points":[[1,0],[0.5,0.8660254037844386],'\
'[-0.5,0.8660254037844386],[-1,0],[-0.5,-0.8660254037844386],'\
'[0.5,-0.8660254037844386]]'
uniform='"knots":"uniform"'

# solve PROBLEM [ARGUMENT...]: its members, without warnings
solve() {
  text="{$1}"
  shift
  feed "$text" arclength -q "$@"
}

# curve_of FILE PROBLEM [ARGUMENT...]: its control points as CSV
curve_of() {
  file=$1
  shift
  solve "$@" -f csv
  mv out "$file"
}

# same NAME PROBLEM PROBLEM: two problems have the same result, to the byte
same() {
  solve "$2"
  mv out one
  solve "$3"
  expect "$1: solved" 0
  equal_files "$1" one out
}

# minimum NAME F PROBLEM: the minimum that was found is F, or a smaller one
minimum() {
  solve "$3"
  expect "$1" 0
  get diagnostics.F |
    holds "$1: F" "n == 1 && x[1] > 0 && x[1] <= $2 * (1 + 1e-6)"
  equal "$1: a minimiser" '"minimiser"' "$(get diagnostics.second_order)"
  for error in $errors; do
    get "diagnostics.$error" | holds "$1: $error" 'n == 1 && x[1] <= 1e-11'
  done
}

# each COUNT PATH: one number a line, @ in the path counts from 0
each() {
  i=0
  while [ $i -lt "$1" ]; do
    floats "$(printf %s "$2" | sed "s/@/$i/")"
    i=$((i + 1))
  done
}

# ---- records -----------------------------------------------------------------

begin='command:string,status:string,curve:string,dimension:number,'\
'degree:number,closed:bool'
segments='segments:[{interval:[number],control_points:[[number]],'\
'preimage:[[number]],length:number}]'
intervals='intervals:[{length:number,natural_length:number,segments:[number]}]'

# member NAME PATH...: results have these members
members() {
  of=$1
  shift
  for path; do
    true_that "$of: $path" [ "$(get "$path")" != absent ]
  done
}

solve "$fig5_lengths,\"id\":7,\"meta\":[1]"
expect 'a record' 0
true_that 'a record: a line of JSON' json lines out
equal 'constants' '7 "arclength" "ok" [1] "ph" 3 5 false' \
  "$(get id) $(get command) $(get status) $(get meta) $(get curve) $(
    get dimension) $(get degree) $(get closed)"
case $(json shape out) in
"{id:number,${begin%%,*},status:string,meta:[number],"*"$segments,$intervals,"*)
  pass 'a record: segments and intervals' ;;
*) fail 'a record: segments and intervals' "$(json shape out)" ;;
esac
members 'diagnostics' diagnostics.iterations diagnostics.residual \
  diagnostics.interpolation_error diagnostics.pythagorean_error \
  diagnostics.continuity_error diagnostics.length_error diagnostics.F \
  diagnostics.F_relaxed diagnostics.kkt_error diagnostics.second_order \
  diagnostics.min_speed diagnostics.natural_lengths diagnostics.start \
  'diagnostics.starts[0].start' \
  'diagnostics.starts[0].outcome' 'diagnostics.starts[0].iterations'
equal 'the start that won has led to a minimiser' 1 "$(
  json get diagnostics.starts out | tr '{' '\n' |
    grep -c "\"start\":$(get diagnostics.start),\"outcome\":\"minimiser\"")"
equal 'two segments for each interval' '[0,1] [2,3] [4,5] absent' \
  "$(get 'intervals[0].segments') $(get 'intervals[1].segments') $(
    get 'intervals[2].segments') $(get 'intervals[3]')"
printf '%s\n' 4.9 2.5 2 >want
each 3 'intervals[@].length' >found
numbers 'lengths of intervals are those prescribed' 1e-12 want found
each 6 'segments[@].length' | awk '
  { sum += $1 } NR % 2 == 0 { printf "%.17g\n", sum; sum = 0 }' >found
numbers 'segments add up to their interval' 1e-12 want found
get length | holds 'the length of the curve' '(x[1] - 9.4)^2 < 1e-24'
each 3 'intervals[@].natural_length' >want
floats diagnostics.natural_lengths >found
equal_files 'natural lengths, twice' want found
equal 'the points are met' \
  '[1,1,0] [0,4,3] [0,4,3] [2,4,2] [2,4,2] [3,3,3]' \
  "$(for k in 0 2 4; do
    get "segments[$k].control_points[0]"
    printf ' '
    get "segments[$((k + 1))].control_points[5]"
    printf ' '
  done | sed 's/ $//')"

# ---- modes -------------------------------------------------------------------

errors='interpolation_error length_error'
minimum 'points, figure 5' 4.885241990954134 "$fig5_lengths,$uniform"
minimum 'points, figure 7' 1.309264571999852 \
  "$fig7,\"lengths\":[1.15,1.08,1.15],$uniform"
minimum 'points, figure 7, long' 230.03550047825078 \
  "$fig7,\"lengths\":[5,2,5],$uniform"
minimum 'points, figure 5, 1 segment' 5.288130760899513 \
  "$fig5_lengths,$uniform,\"refine\":1"
minimum 'points, figure 7, 1 segment' 1.376294433 \
  "$fig7,\"lengths\":[1.15,1.08,1.15],$uniform,\"refine\":1"
errors='length_error'
minimum 'derivatives, figure 14' 2.580180791215482 "$fig14,$uniform"
minimum 'derivatives, figure 14, 1 segment' 3.076799571 \
  "$fig14,$uniform,\"refine\":1"
minimum 'derivatives, figure 13' 6.9538503429069785 \
  "$fig13,$uniform,\"planar\":\"free\""
minimum 'derivatives, figure 13, 1 segment' 9.435399431 \
  "$fig13,$uniform,\"refine\":1"
minimum 'tangents, figure 10' 15.912880542101554 "$ribbon,$uniform"
minimum 'tangents, figure 10, 1 segment' 62.58157295 \
  "$ribbon,$uniform,\"refine\":1"
errors='interpolation_error'
minimum 'free lengths, figure 5' 5.219940493 "$fig5,$uniform"
minimum 'free lengths, figure 5, 2 segments' 4.8752283795161775 \
  "$fig5,$uniform,\"refine\":2"
minimum 'free lengths, figure 7' 1.363138784 "$fig7,$uniform"

solve "$fig5,$uniform"
printf '%s\n' 4.90044643 2.51488793 1.98150754 >want
floats diagnostics.natural_lengths >found
numbers 'natural lengths, figure 5' 1e-8 want found
each 3 'intervals[@].length' >want
numbers 'free lengths are natural' 1e-12 want found
equal 'free lengths: 1 segment' '[0,0] [2,2]' \
  "$(get 'intervals[0].segments') $(get 'intervals[2].segments')"
equal 'free lengths: there is no other F to compare with' absent \
  "$(get diagnostics.F_relaxed)"

# legs FILE: the derivatives dr/dt at both ends of each segment of out, in order
legs() {
  n=$(json get segments out | tr '{' '\n' | grep -c interval)
  k=0
  while [ $k -lt "$n" ]; do
    {
      floats "segments[$k].interval"
      floats "segments[$k].control_points"
    } | awk '{ p[NR] = $1 } END {
      h = p[2] - p[1]
      for (i = 3; i < 6; i++) printf "%.17g\n", 5 * (p[i + 3] - p[i]) / h
      for (i = 18; i < 21; i++) printf "%.17g\n", 5 * (p[i] - p[i - 3]) / h
    }'
    k=$((k + 1))
  done
}

solve "$fig14,$uniform,\"refine\":1"
legs >found
printf '%s\n' 1 0 0 0 1 0 0 1 0 0 0 1 0 0 1 1 0 0 >want
numbers 'derivatives are by the parameter of the knots' 1e-12 want found
equal 'derivatives: the curve begins in 0' '[0,0,0]' \
  "$(get 'segments[0].control_points[0]')"
equal 'uniform knots' '[0,1] [1,2] [2,3]' "$(get 'segments[0].interval') $(
  get 'segments[1].interval') $(get 'segments[2].interval')"
solve "$ribbon"
legs | awk '{ p[NR % 3] = $1 } NR % 3 == 0 {
  s = sqrt(p[0]^2 + p[1]^2 + p[2]^2)
  printf "%.12f %.12f %.12f\n", p[1] / s, p[2] / s, p[0] / s }' |
  awk 'NR == 1 || NR % 4 == 0' >found
printf %s "$ribbon" | sed 's/,"lengths.*//; s/.*:\[\[//; s/\]\]//
  s/\],\[/ /g' | tr ' ' '\n' | awk -F, '{ s = sqrt($1^2 + $2^2 + $3^2)
  printf "%.12f %.12f %.12f\n", $1 / s, $2 / s, $3 / s }' >want
numbers 'tangents are directions' 1e-11 want found
get diagnostics.min_speed | holds 'tangents: no cusp' 'x[1] > 0'

# ---- magnitudes, start -------------------------------------------------------

same 'free is the default of magnitudes' "$ribbon" \
  "$ribbon,\"magnitudes\":\"free\""
solve "$ribbon,$uniform,\"magnitudes\":\"mean\",\"refine\":1"
expect 'magnitudes: mean' 0
get diagnostics.F | holds 'magnitudes: mean, figure 10' \
  'x[1] > 62.6 && x[1] < 196.6'
# the speed at the first, the second and the last tangent
legs | awk '{ v[NR] = $1 } END { for (i = 1; i <= NR; i += 3)
  printf "%.17g\n", sqrt(v[i]^2 + v[i + 1]^2 + v[i + 2]^2) }' |
  awk 'NR == 1 || NR == 2 || NR == 14' >found
printf '%s\n' 170.05 169.775 170.1 >want
numbers 'magnitudes: the mean of the lengths beside the tangent' 1e-12 want found
for given in "$fig14" "$ribbon"; do
  curve_of one "$given"
  curve_of two "$given,\"start\":[10,20,-30]"
  awk -F, 'NR == 1 { print; next } {
    printf "%s,%s,%s,%.17g,%.17g,%.17g\n", $1, $2, $3, $4 + 10, $5 + 20, $6 - 30
  }' one >want
  numbers 'start moves the curve' 1e-12 want two
  same 'start is [0,0,0]' "$given" "$given,\"start\":[0,0,0]"
  same 'start in the plane' "$given,\"start\":[1,2]" "$given,\"start\":[1,2,0]"
done

# ---- refine, knots -----------------------------------------------------------

same 'refine: 2 with lengths' "$fig5_lengths" "$fig5_lengths,\"refine\":2"
same 'refine: auto is the default' "$fig5_lengths" \
  "$fig5_lengths,\"refine\":\"auto\""
same 'refine: 1 without' "$fig5" "$fig5,\"refine\":1"
same 'refine: 2 with few tangents' "$ribbon" "$ribbon,\"refine\":2"
dense=$(awk 'BEGIN {
  for (i = 0; i <= 50; i++) {
    t = i / 10
    tangents = tangents sprintf("%s[%.17g,%.17g,0.5]", i ? "," : "",
      cos(t), sin(t))
    lengths = lengths (i > 1 ? "," : "") (i ? "0.1" : "")
  }
  print "\"tangents\":[" tangents "],\"lengths\":[" lengths "]"
}')
same 'refine: 2 with many tangents' "$dense" "$dense,\"refine\":2"
for refine in 1 2 3; do
  solve "$fig5_lengths,\"refine\":$refine"
  equal "refine: $refine segments each" \
    "[0,$((refine - 1))] [$((2 * refine)),$((3 * refine - 1))]" \
    "$(get 'intervals[0].segments') $(get 'intervals[2].segments')"
  json get diagnostics.F out >f.$refine
done
cat f.1 f.2 f.3 | holds 'refine: more segments, a smaller F' \
  'n == 3 && x[1] > x[2] && x[2] > x[3]'

same 'knots: lengths is the default with lengths' "$fig5_lengths" \
  "$fig5_lengths,\"knots\":\"lengths\""
same 'knots: chordal is the default without' "$fig5" \
  "$fig5,\"knots\":\"chordal\""

# knots_are NAME KNOTS PROBLEM: of 1 segment for each interval
knots_are() {
  solve "$3,\"refine\":1"
  printf '%s\n' "$2" | tr ' ' '\n' >want
  {
    each 1 'segments[@].interval[0]'
    each 3 'segments[@].interval[1]'
  } >found
  numbers "knots: $1" 1e-14 want found
}
knots_are 'lengths, mean 1' \
  '0 1.5638297872340425 2.3617021276595747 3' "$fig5_lengths"
knots_are 'uniform' '0 1 2 3' "$fig5_lengths,$uniform"
knots_are 'numbers' '-1 0.5 2 3' "$fig5_lengths,\"knots\":[-1,0.5,2,3]"
solve '"points":[[0,0,0],[2,3,6],[2,3,7],[2,4,7]]'
printf '%s\n' 0 2.3333333333333335 2.6666666666666665 3 >want
{
  each 1 'segments[@].interval[0]'
  each 3 'segments[@].interval[1]'
} >found
numbers 'knots: chordal, mean 1' 1e-14 want found
curve_of one "$fig5_lengths,\"knots\":[0,1,2,3]"
curve_of two "$fig5_lengths,$uniform"
numbers 'knots: uniform, as numbers' 1e-10 one two
# F is by knots of mean spacing 1: it does not depend on their unit.
solve "$fig5_lengths,\"knots\":[0,1,2,3]"
get diagnostics.F >want
solve "$fig5_lengths,\"knots\":[5,15,25,35]"
get diagnostics.F >found
numbers 'knots: F has no unit of them' 1e-9 want found

# ---- soft lengths ------------------------------------------------------------

solve "$fig5_lengths,\"length_sigma\":1e-6"
expect 'length_sigma: small' 0
each 3 'intervals[@].length' >found
printf '%s\n' 4.9 2.5 2 >want
numbers 'length_sigma: small, nearly those lengths' 1e-4 want found
solve "$fig5_lengths,\"length_sigma\":1000"
each 3 'intervals[@].length' >found
each 3 'intervals[@].natural_length' >want
numbers 'length_sigma: large, nearly natural' 1e-4 want found
members 'length_sigma' diagnostics.length_rms
get diagnostics.interpolation_error |
  holds 'length_sigma: points are exact' 'x[1] <= 1e-12'
solve "$fig5,\"lengths\":[4.9,2.5,1.7],\"length_sigma\":0.01"
expect 'length_sigma: a length below its chord' 0
each 3 'intervals[@].length' |
  holds 'length_sigma: and above it in the result' 'x[3] > sqrt(3) && x[3] < 2'

# ---- closed ------------------------------------------------------------------

solve "$hexagon"
expect 'closed' 0
equal 'closed: it leads back' \
  'true [0.5,-0.8660254037844386,0] [1,0,0] absent' \
  "$(get closed) $(get 'segments[5].control_points[0]') $(
    get 'segments[5].control_points[5]') $(get 'segments[6]')"
get diagnostics.continuity_error | holds 'closed: C2' 'x[1] <= 1e-11'
solve "$hexagon,\"lengths\":[1.1,1.05,1.05,1.1,1.05,1.05]"
expect 'closed, with lengths' 0
each 6 'intervals[@].length' >found
printf '%s\n' 1.1 1.05 1.05 1.1 1.05 1.05 >want
numbers 'closed, with lengths: they are' 1e-12 want found
get diagnostics.continuity_error | holds 'closed, with lengths: C2' \
  'x[1] <= 1e-11'
same 'closed: a repeated point is dropped' \
  "$(printf %s "$hexagon" | sed 's/\]\]$/],[1,0]]/')" "$hexagon"

# ---- plane data --------------------------------------------------------------

# plane FILE: whether all z of a table are 0
plane() {
  awk -F, 'NR > 1 && $6 + 0 != 0 { bad = 1 } END { exit bad || NR < 7 }' "$1"
}

arch='"points":[[0,0],[1,0.8],[2,1],[3,0.7]]'
for more in '' ',"lengths":[1.35,1.04,1.07]'; do
  same "points of two coordinates have z = 0 $more" "$arch$more" \
    "$(printf %s "$arch" | sed 's/\]/,0]/g; s/,0\],0\]/,0]]/')$more"
  same "planar: keep is the default $more" "$arch$more" \
    "$arch$more,\"planar\":\"keep\""
  curve_of one "$arch$more"
  true_that "planar: a plane curve $more" plane one
  solve "$arch$more"
  equal "planar: the diagnostic $more" 'true' "$(get diagnostics.planar)"
done
solve "$fig5_lengths"
equal 'planar: data in space have no such diagnostic' absent \
  "$(get diagnostics.planar)"
# Figure 3 with 1 segment each: the plane curve is a saddle, and there are two
# minimisers, mirror images of each other.
sine='"points":[[0,0],[1.0471975511965976,0.8660254037844386],'\
'[2.0943951023931953,0.8660254037844387],[3.141592653589793,0]],'\
'"lengths":[1.364647438430407,1.0909029121668972,1.3646474384304073],'\
'"refine":1,"knots":"uniform"'
solve "$sine"
equal 'figure 3, in the plane: a saddle' '"ok" true "saddle" "saddle"' \
  "$(get status) $(get diagnostics.planar) $(get diagnostics.second_order) $(
    get 'warnings[0].code')"
get diagnostics.F | holds 'figure 3, in the plane: F' \
  'x[1] > 0 && x[1] < 2.2463116061'
solve "$sine,\"planar\":\"free\""
equal 'figure 3, in space: a minimiser' '"ok" false "minimiser" "wiggle"' \
  "$(get status) $(get diagnostics.planar) $(get diagnostics.second_order) $(
    get 'warnings[0].code')"
get diagnostics.F | holds 'figure 3, in space: F' \
  'x[1] > 0 && x[1] < 1.155086978'

# ---- starts, all minima ------------------------------------------------------

fig8="$fig5,\"lengths\":[9.25,4.75,3.7],$uniform,\"refine\":1"
solve "$fig8"
json get diagnostics.starts out | tr '{' '\n' | grep -c '"start"' >one
solve "$fig8,\"starts\":3"
json get diagnostics.starts out | tr '{' '\n' | grep -c '"start"' >two
paste -sd ' ' one two | tr ' ' '\n' | holds 'starts: so many more' \
  'n == 2 && x[2] == x[1] + 3'
same 'starts: 0 is the default' "$fig8" "$fig8,\"starts\":0"
solve "$fig8,\"starts\":3"
mv out one
solve "$fig8,\"starts\":3"
equal_files 'starts: they are the same each time' one out
equal 'no solutions unless asked for' absent "$(get solutions)"
same 'all_minima: false is the default' "$fig8" "$fig8,\"all_minima\":false"
solve "$fig8,\"all_minima\":true,\"starts\":10"
expect 'all_minima' 0
equal 'all_minima: the first is the curve' \
  "$(get length) $(get segments) $(get diagnostics.F)" \
  "$(get 'solutions[0].length') $(get 'solutions[0].segments') $(
    get 'solutions[0].diagnostics.F')"
n=$(json get solutions out | tr '{' '\n' | grep -c '"good"')
each "$n" 'solutions[@].diagnostics.F' | holds 'all_minima: the best first' \
  'n >= 2 && x[1] < x[2] && (n < 3 || x[2] < x[3]) && x[1] < 497'
i=0
while [ $i -lt "$n" ]; do
  get "solutions[$i].diagnostics.second_order"
  echo
  i=$((i + 1))
done | sort -u >found
equal 'all_minima: minimisers' '"minimiser"' "$(cat found)"

# ---- straight data -----------------------------------------------------------

solve '"points":[[0,0,0],[1,2,2],[2,4,4]],"lengths":[3,3]'
expect 'a line of its own length' 0
get diagnostics.F | holds 'a line: F is 0' 'x[1] >= 0 && x[1] < 1e-20'
each 4 'segments[@].length' >found
printf '%s\n' 1.5 1.5 1.5 1.5 >want
numbers 'a line: lengths' 1e-12 want found
