# SPDX-License-Identifier: GPL-3.0-or-later
#
# Spatial Hermite interpolation: what its results hold, and what each of its
# fields does.  (CSV: spatial-csv.t; errors and warnings: spatial-errors.t;
# degenerate data: spatial-degenerate.t.)
. "$srcdir/tests/cli/lib.sh"

points='"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,3]]'
tangents='"tangents":[[1,0,0],[0,1,1],[1,-2,0],[0,0,3]]'
derivatives='"derivatives":[[1,0,0],[0,1,1],[1,-2,0],[0,0,3]]'
hermite="$points,$tangents"

# solve TEXT [ARGUMENT...]: without warnings
solve() {
  text=$1
  shift
  feed "$text" spatial-hermite -q "$@"
}

# curve_of FILE PROBLEM [ARGUMENT...]: its control points as CSV
curve_of() {
  file=$1 text=$2
  shift 2
  solve "{$text}" -f csv "$@"
  mv out "$file"
}

# same NAME PROBLEM PROBLEM: two problems have the same result, to the byte
same() {
  solve "{$2}"
  mv out one
  solve "{$3}"
  expect "$1: solved" 0
  equal_files "$1" one out
}

# other NAME PROBLEM PROBLEM: two problems have different curves
other() {
  curve_of one "$2"
  curve_of two "$3"
  if cmp -s one two; then
    fail "$1" 'the curves are the same'
  else
    true_that "$1" count "$(wc -l <one)" two
  fi
}

# ---- records -----------------------------------------------------------------

begin='command:string,status:string,curve:string,dimension:number,'\
'degree:number,closed:bool'
segments='segments:[{interval:[number],control_points:[[number]],'\
'preimage:[[number]],length:number,tension:number,angles:[number],'\
'shape_ok:bool}]'
segments_atph='segments:[{interval:[number],alpha:number,'\
'control_points:[[number]],preimage:[[number]],length:number,tension:number,'\
'angles:[number],shape_ok:bool}]'
fair='shape_ok:bool,reduced:number,energy:number,F1:number,F2:number,F3:number'
found='iterations:number,residual:number,interpolation_error:number'
errors='pythagorean_error:number,continuity_error:number,length_error:number'

# record NAME SEGMENTS DIAGNOSTICS PROBLEM
record() {
  solve "{$4}"
  expect "$1" 0
  equal "$1: its record" \
    "{$begin,$2,length:number,diagnostics:{$3}}" "$(json shape out)"
  true_that "$1: a line of JSON" json lines out
}

record 'points alone' "$segments" "$found,$errors,$fair" "$points"
record 'tangents' "$segments" "$found,tangent_error:number,$errors,$fair" \
  "$hermite"
record 'derivatives' "$segments" "$found,tangent_error:number,$errors,$fair" \
  "$points,$derivatives"
record 'a functional' "$segments" \
  "$found,$errors,functional:number,$fair" "$points,\"criterion\":\"F1\""
record 'atph' "$segments_atph" "$found,$errors,$fair" \
  "$points,\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"cc\""
record 'atph, alpha by a functional' "$segments_atph" \
  "$found,$errors,functional:number,at_bound:bool,$fair" \
  "$points,\"basis\":\"atph\""
record 'atph, alpha given, a functional' "$segments_atph" \
  "$found,$errors,functional:number,$fair" \
  "$points,\"basis\":\"atph\",\"alpha\":1"
solve "{$points,\"id\":7,\"meta\":[1]}"
equal 'constants' '7 "spatial-hermite" "ok" [1] "ph" 3 5 false' \
  "$(get id) $(get command) $(get status) $(get meta) $(get curve) $(
    get dimension) $(get degree) $(get closed)"

# segment K: what its numbers have to do with each other: the end derivatives
# are A i A*, the parameter is u, and the length that of the preimage and
# between chord and polygon.
segment() {
  {
    floats "segments[$1].control_points"
    floats "segments[$1].preimage"
    floats "segments[$1].length"
  } | awk '
    function near(a, b) { d = a - b; return d * d < 1e-24 }
    function apart(i, j,   k, sum) {
      for (k = 0; k < 3; k++) sum += (p[3*i+k] - p[3*j+k]) ^ 2
      return sqrt(sum)
    }
    function dot(i, j,   k, sum) {
      for (k = 0; k < 4; k++) sum += p[18+4*i+k] * p[18+4*j+k]
      return sum
    }
    function hodograph(at, x, y, z,   u, v, q) {
      u = p[18+4*at]; v = p[19+4*at]; q = p[20+4*at]; k = p[21+4*at]
      return near(x, u * u + v * v - q * q - k * k) &&
        near(y, 2 * (v * q + u * k)) && near(z, 2 * (v * k - u * q))
    }
    { p[NR - 1] = $1 }
    END {
      if (NR != 31) { print NR " numbers"; exit 1 }
      for (i = 0; i < 5; i++) polygon += apart(i, i + 1)
      if (!hodograph(0, 5*(p[3]-p[0]), 5*(p[4]-p[1]), 5*(p[5]-p[2])) ||
          !hodograph(2, 5*(p[15]-p[12]), 5*(p[16]-p[13]), 5*(p[17]-p[14]))) {
        print "the preimage does not give the end derivatives"; exit 1
      }
      sum = dot(0, 0) + dot(0, 1) + (2 * dot(1, 1) + dot(0, 2)) / 3
      sum += dot(1, 2) + dot(2, 2)
      if (!near(sum / 5, p[30])) { print "the length is wrong"; exit 1 }
      if (p[30] < apart(0, 5) || p[30] > polygon) {
        print "length " p[30] " of " apart(0, 5) " to " polygon; exit 1
      }
    }'
}

solve "{$hermite}"
for k in 0 1 2; do
  true_that "segment $k: its numbers fit each other" segment $k
done
equal 'the points are met' '[0,0,0] [1,1,0] [1,1,0] [2,0,1] [2,0,1] [3,1,3]' \
  "$(for k in 0 1 2; do
    get "segments[$k].control_points[0]"
    printf ' '
    get "segments[$k].control_points[5]"
    printf ' '
  done | sed 's/ $//')"
for k in 0 1 2; do
  floats "segments[$k].length"
done | awk '{ sum += $1 } END { printf "%.17g\n", sum }' >want
json get length out >sum
numbers 'the length is the sum of lengths' 1e-15 want sum
for name in residual interpolation_error tangent_error pythagorean_error \
  continuity_error length_error; do
  get diagnostics.$name | holds "$name is small" 'n == 1 && x[1] < 1e-12'
done

# ---- tangents and derivatives ------------------------------------------------

same 'tangents of any length' "$hermite" \
  "$points,\"tangents\":[[8,0,0],[0,64,64],[0.25,-0.5,0],[0,0,0.75]]"
curve_of one "$hermite"
curve_of two \
  "$points,\"tangents\":[[1e308,0,0],[0,7,7],[1e-323,-2e-323,0],[0,0,1e-300]]"
numbers 'tangents of any length: huge and tiny' 1e-15 one two

# legs K: the end derivatives of a segment
legs() {
  floats "segments[$1].control_points" |
    awk '{ p[NR - 1] = $1 } END {
      for (i = 0; i < 3; i++) printf "%.17g\n", 5 * (p[3 + i] - p[i])
      for (i = 0; i < 3; i++) printf "%.17g\n", 5 * (p[15 + i] - p[12 + i])
    }'
}

# kept NAME FACTOR: whether the end derivatives are those given times a factor
kept() {
  for k in 0 1 2; do
    legs $k
  done >found.legs
  awk -v s="$2" 'BEGIN {
    n = split("1 0 0 0 1 1 0 1 1 1 -2 0 1 -2 0 0 0 3", d)
    for (i = 1; i <= n; i++) printf "%.17g\n", d[i] * s
  }' >want.legs
  numbers "$1" 1e-13 want.legs found.legs
}

for criterion in cc hc bv zero F1; do
  solve "{$points,$derivatives,\"criterion\":\"$criterion\"}"
  kept "derivatives are kept, $criterion" 1
done
solve "{$points,$derivatives,\"tension\":0.5}"
kept 'derivatives and tension' 0.25
solve "{$points,$derivatives,\"knots\":[0,1,3,9]}"
kept 'derivatives are by the parameter of the segment, not by knots' 1
# Farouki et al. 2015, example 3, with derivatives: reduced only on demand.
example3='"points":[[0,0,0],[1,1,1]],"derivatives":[[0.4,-1.5,-1.2],[-2,-1,-2]]'
solve "{$example3}"
equal 'derivatives: shape is false' '1 false false 0' \
  "$(get 'segments[0].tension') $(get 'segments[0].shape_ok') $(
    get diagnostics.shape_ok) $(get diagnostics.reduced)"
same 'derivatives: shape false is the default' "$example3" \
  "$example3,\"shape\":false"
solve "{$example3,\"shape\":true}"
equal 'derivatives: shape on demand' 'true true 1' \
  "$(get 'segments[0].shape_ok') $(get diagnostics.shape_ok) $(
    get diagnostics.reduced)"
{
  floats 'segments[0].tension'
  legs 0
} | holds 'derivatives: reduced by the square of the tension' \
  'x[1] < 1 && x[1] > 0.5 && (x[2] / x[1]^2 - 0.4)^2 < 1e-26 &&
  (x[7] / x[1]^2 + 2)^2 < 1e-26'

# Of atph they are by t in [0,alpha]: those by u are alpha times that.
solve "{$points,$derivatives,\"basis\":\"atph\",\"alpha\":[1,0.5,1.5],
  \"criterion\":\"cc\"}"
{
  floats 'segments[1].preimage[0]'
  floats 'segments[1].preimage[2]'
} | awk '
  { a[NR] = $1 }
  END {
    for (i = 1; i < 9; i += 4) {
      u = a[i]; v = a[i + 1]; p = a[i + 2]; q = a[i + 3]
      printf "%.17g\n", u * u + v * v - p * p - q * q
      printf "%.17g\n%.17g\n", 2 * (v * p + u * q), 2 * (v * q - u * p)
    }
  }' >found.legs
printf '%s\n' 0 1 1 1 -2 0 >want.legs
numbers 'derivatives of atph are by t' 1e-13 want.legs found.legs

# ---- criteria, angles, axes --------------------------------------------------

same 'cc is the default' "$hermite" "$hermite,\"criterion\":\"cc\""
same 'F3 is the default of atph' "$hermite,\"basis\":\"atph\"" \
  "$hermite,\"basis\":\"atph\",\"criterion\":\"F3\""
same 'ph is the default' "$hermite" "$hermite,\"basis\":\"ph\""
same 'the axis does not change cc' "$hermite,\"axis\":\"chord\"" "$hermite"
for pair in cc,hc cc,bv cc,zero hc,bv cc,F1 F1,F2 F2,F3; do
  other "$pair are not the same" "$hermite,\"criterion\":\"${pair%,*}\"" \
    "$hermite,\"criterion\":\"${pair#*,}\""
done
other 'zero depends on the axis' "$hermite,\"criterion\":\"zero\"" \
  "$hermite,\"criterion\":\"zero\",\"axis\":\"bisector\""
for criterion in cc hc bv zero; do
  solve "{$hermite,\"shape\":false,\"criterion\":\"$criterion\"}"
  get length
  echo
done >lengths
holds 'hc is the longest' 'n == 4 && x[2] >= x[1] && x[2] >= x[3] &&
  x[2] >= x[4] - 1e-12' <lengths
for criterion in F1 F2 F3 cc; do
  solve "{$hermite,\"shape\":false,\"criterion\":\"$criterion\"}"
  for k in 1 2 3; do
    get diagnostics.F$k
    echo
  done
done >functionals
for k in 1 2 3; do
  solve "{$hermite,\"criterion\":\"F$k\"}"
  {
    get diagnostics.functional && echo
    get diagnostics.F$k
  } | holds "F$k is the functional" \
    'n == 2 && (x[1] / x[2] - 1)^2 < 1e-20'
  holds "F$k is the least of itself" \
    "n == 12 && x[$k] > 0 && x[$((4 * k - 3))] <= x[$((k + 3))] &&
    x[$((4 * k - 3))] <= x[$((k + 6))] && x[$((4 * k - 3))] < x[$((k + 9))] &&
    x[$((4 * k - 3))] <= x[$k]" <functionals
done
solve "{$points,\"criterion\":\"zero\"}"
equal 'zero: both angles' '[0,0] [0,0] [0,0]' "$(get 'segments[0].angles') $(
  get 'segments[1].angles') $(get 'segments[2].angles')"

# again NAME PROBLEM [MORE]: the angles of a result, with its tensions (and
# alpha), in the place of the criterion, give its curve
again() {
  solve "{$2${3:+,$3}}"
  for path in angles tension alpha; do
    for k in 0 1 2; do
      get "segments[$k].$path"
      echo
    done | paste -sd , - | sed "s/.*/\"$path\":[&]/" >$path.json
  done
  fields=$(cat angles.json),$(cat tension.json)
  case $2 in *atph*) fields=$fields,$(cat alpha.json) ;; esac
  curve_of want.csv "$2${3:+,$3}"
  curve_of found.csv "$2,\"shape\":false,$fields"
  true_that "$1: there is a curve" count 19 want.csv
  numbers "$1: the angles again" 1e-12 want.csv found.csv
}

for axis in chord x bisector; do
  for criterion in cc hc bv F1; do
    again "$criterion, $axis" "$hermite,\"axis\":\"$axis\"" \
      "\"criterion\":\"$criterion\""
  done
  again "atph, $axis" "$hermite,\"basis\":\"atph\",\"axis\":\"$axis\""
done
again 'points alone' "$points"
again 'derivatives' "$points,$derivatives"
same 'one pair for all' "$hermite,\"angles\":[[1,2],[1,2],[1,2]]" \
  "$hermite,\"angles\":[1,2]"
same 'one pair for all, as a list of one' "$hermite,\"angles\":[[1,2]]" \
  "$hermite,\"angles\":[1,2]"
curve_of one "$hermite,\"angles\":[1,2]"
curve_of two "$hermite,\"angles\":[-5.283185307179586,14.566370614359172]"
numbers 'angles are periodic: beta after 4 pi' 1e-13 one two
same 'zero is the angles 0, 0' "$hermite,\"criterion\":\"zero\"" \
  "$hermite,\"angles\":[0,0]"
same 'x is the default axis of atph' \
  "$hermite,\"basis\":\"atph\",\"alpha\":1,\"angles\":[1,2]" \
  "$hermite,\"basis\":\"atph\",\"alpha\":1,\"angles\":[1,2],\"axis\":\"x\""
curve_of one "$hermite,\"angles\":[1,2],\"axis\":\"x\""
curve_of two "$hermite,\"angles\":[1,2],\"axis\":\"x\",\"basis\":\"atph\",
  \"alpha\":1e-5"
numbers 'atph of a small alpha is ph' 1e-9 one two

# ---- alpha, knots, tension, shape --------------------------------------------

solve "{$hermite,\"basis\":\"atph\",\"alpha\":[0.5,1,2],\"criterion\":\"cc\"}"
equal 'an angle for each segment' '0.5 1 2' "$(get 'segments[0].alpha') $(
  get 'segments[1].alpha') $(get 'segments[2].alpha')"
same 'one angle for all' \
  "$hermite,\"basis\":\"atph\",\"alpha\":[1,1,1],\"criterion\":\"hc\"" \
  "$hermite,\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"hc\""
solve "{$hermite,\"basis\":\"atph\"}"
for k in 0 1 2; do
  get "segments[$k].alpha"
  echo
done | holds 'angles that are chosen' 'n == 3 && x[1] >= 1e-3 &&
  x[1] <= 2.0944 && x[2] >= 1e-3 && x[2] <= 2.0944 && x[3] >= 1e-3 &&
  x[3] <= 2.0944'

solve '{"points":[[0,0,0],[2,3,6],[2,3,7]]}'
equal 'chordal knots are distances' '[0,7] [7,8]' \
  "$(get 'segments[0].interval') $(get 'segments[1].interval')"
same 'chordal is the default' "$hermite" "$hermite,\"knots\":\"chordal\""
solve "{$hermite,\"knots\":[-1,1,2,5]}"
equal 'knots are intervals' '[-1,1] [1,2] [2,5]' "$(
  get 'segments[0].interval') $(get 'segments[1].interval') $(
  get 'segments[2].interval')"
legs 0 | holds 'knots are the speeds where directions are given' \
  'n == 6 && x[1] > 1.99999 && x[1] < 2.00001'
curve_of one "$hermite,\"knots\":[0,2,3,6]"
curve_of two "$hermite,\"knots\":[-1,1,2,5]"
equal_files 'only differences of knots count' one two

curve_of one "$hermite,\"knots\":[0,1,2,3],\"tension\":0.5,\"shape\":false"
curve_of two "$hermite,\"knots\":[0,0.25,0.5,0.75],\"shape\":false"
equal_files 'the square of the tension scales the speeds' one two
same 'one tension for all' "$hermite,\"tension\":[0.5,0.5,0.5]" \
  "$hermite,\"tension\":0.5"
solve "{$hermite,\"tension\":[0.5,1,2],\"shape\":false}"
equal 'a tension for each segment' '0.5 1 2' "$(get 'segments[0].tension') $(
  get 'segments[1].tension') $(get 'segments[2].tension')"
example3='"points":[[0,0,0],[1,1,1]],"tangents":[[0.4,-1.5,-1.2],[-2,-1,-2]]'
same 'shape true is the default' "$example3" "$example3,\"shape\":true"
solve "{$example3,\"shape\":false}"
equal 'shape false' '1 false 0' "$(get 'segments[0].tension') $(
  get diagnostics.shape_ok) $(get diagnostics.reduced)"
solve "{$example3,\"tension\":0.5}"
equal 'a tension that does' '0.5 true 0' "$(get 'segments[0].tension') $(
  get diagnostics.shape_ok) $(get diagnostics.reduced)"

# ---- closed curves, plane data -----------------------------------------------

square='[0,0,0],[2,0,0],[2,2,1],[0,2,0]'
solve "{\"points\":[$square],\"closed\":true}"
expect 'closed' 0
equal 'closed: the last segment leads back' 'true [0,2,0] [0,0,0] absent' \
  "$(get closed) $(get 'segments[3].control_points[0]') $(
    get 'segments[3].control_points[5]') $(get 'segments[4]')"
same 'closed: a repeated point is dropped' \
  "\"closed\":true,\"points\":[$square,[0,0,0]]" \
  "\"closed\":true,\"points\":[$square]"
turns='[1,0,0],[0,1,0],[-1,0,0],[0,-1,0]'
for what in tangents derivatives; do
  same "closed: and what belongs to it, $what" \
    "\"closed\":true,\"points\":[$square,[0,0,0]],\"$what\":[$turns,[1,0,0]]" \
    "\"closed\":true,\"points\":[$square],\"$what\":[$turns]"
  same "closed: it need not be given, $what" \
    "\"closed\":true,\"points\":[$square,[0,0,0]],\"$what\":[$turns]" \
    "\"closed\":true,\"points\":[$square],\"$what\":[$turns]"
done
# Repeated as cosines and sines repeat themselves: not to the last bit.
same 'closed: a point repeated up to rounding, and its tangent' \
  "\"closed\":true,\"points\":[$square,[0,-4e-16,0]],
  \"tangents\":[$turns,[1,-2e-16,-0.0]]" \
  "\"closed\":true,\"points\":[$square],\"tangents\":[$turns]"
solve "{\"points\":[$square],\"closed\":true,\"knots\":[0,1,2,3,4]}"
equal 'closed: one knot more' '[3,4]' "$(get 'segments[3].interval')"

for more in '' ',"closed":true' ',"criterion":"hc"' ',"criterion":"bv"' \
  ',"criterion":"F1"' ',"basis":"atph","alpha":1' \
  ',"tangents":[[1,0,2],[1,2,0],[1,0,1],[-1,3,0]]'; do
  same "points of two coordinates have z = 0 $more" \
    "\"points\":[[0,0],[1,1],[2,0],[3,1]]$more" \
    "\"points\":[[0,0,0],[1,1,0],[2,0,0],[3,1,0]]$more"
done
for what in tangents derivatives; do
  same "$what of two coordinates have z = 0" \
    "\"points\":[[0,0],[1,1],[2,0]],\"$what\":[[1,0],[0,1],[-1,2]]" \
    "\"points\":[[0,0],[1,1],[2,0]],\"$what\":[[1,0,0],[0,1,0],[-1,2,0]]"
done
for more in '' ',"closed":true' ',"tangents":[[1,0],[-1,2],[1,0],[-1,3]]' \
  ',"derivatives":[[4,0],[1,9],[1,0],[-1,-7]]' ',"basis":"atph","alpha":1,
  "criterion":"cc"' ',"closed":true,"tangents":[[0,1],[1,1],[-1,-1],[0,-2]]'; do
  curve_of one "\"points\":[[0,0],[1,1],[2,0],[3,1.5]]$more"
  awk -F, 'NR > 1 && $6 != "0" { print; bad = 1 }
    END { exit bad || NR < 19 }' one >cmd.out 2>&1
  equal "plane data have a plane curve $more" '0 ' "$? $(cat cmd.out)"
done

# A tangent that is repeated with its point has the same direction.
solve '{"points":[[0,0,0],[1,1,1],[0,0,1],[0,0,0]],"closed":true,
  "tangents":[[1,0,0],[0,1,0],[0,0,1],[2,0,0]]}'
equal 'a repeated tangent of another length' '"ok"' "$(get status)"

# ---- tensions come back ------------------------------------------------------

# A tension that was reduced for the shape, given with the data: the same curve.
for criterion in cc F1; do
  case $criterion in
  cc) data='"points":[[0,0,0],[1,1,1]],
    "tangents":[[0.4,-1.5,-1.2],[-1.2,-0.6,-1.2]]' ;;
  *) data='"points":[[0,0,0],[2,-2.6,0.4]],
    "tangents":[[1.4,-3.1,0.2],[0,-2.8,-0.5]]' ;;
  esac
  solve "{$data,\"criterion\":\"$criterion\"}"
  floats 'segments[0].control_points' >before
  tension=$(get 'segments[0].tension')
  functional=$(get diagnostics.functional)
  printf '%s\n' "$tension" | holds "$criterion: a tension that was reduced" \
    'x[1] < 1 && x[1] > 0.1'
  solve "{$data,\"criterion\":\"$criterion\",\"tension\":$tension,
    \"shape\":false}"
  equal "$criterion: the tension keeps the shape" true \
    "$(get 'segments[0].shape_ok')"
  floats 'segments[0].control_points' >after
  paste before after | awk '{ d = $1 - $2; if (d < 0) d = -d; print d }' |
    holds "$criterion: the same curve" \
      'n == 18 && x[4] + x[8] + x[9] + x[12] + x[15] < 1e-6'
  test "$functional" = absent || printf '%s\n%s\n' "$functional" \
    "$(get diagnostics.functional)" | holds "$criterion: the same minimum" \
    'x[1] > 0 && x[1] / x[2] - 1 < 1e-6 && x[2] / x[1] - 1 < 1e-6'
done

# ---- published values --------------------------------------------------------

# Each problem brings what is known about it in `meta'.  A functional may come
# out lower than known, but no higher; the curve then is another one.
run spatial-hermite -q "$srcdir/tests/vectors/spatial.jsonl"
expect 'published examples' 0
for path in id length meta.length 'segments[0].tension' meta.tension \
  diagnostics.functional meta.functional_at_most diagnostics.shape_ok \
  meta.satisfiable; do
  json get "$path" out >"$path.column"
done
paste id.column length.column meta.length.column 'segments[0].tension.column' \
  meta.tension.column diagnostics.functional.column \
  meta.functional_at_most.column diagnostics.shape_ok.column \
  meta.satisfiable.column | awk '
  function near(a, b, tol) { return (a - b) ^ 2 <= (tol * b) ^ 2 }
  {
    why = ""
    if ($7 == "absent") {
      if (!near($2, $3, 1e-9)) why = "length " $2 ", wanted " $3
      if (!near($4, $5, 1e-6)) why = "tension " $4 ", wanted " $5
      if ($8 != $9) why = "shape_ok " $8 ", wanted " $9
    } else {
      if (!near($2, $3, 2e-3) && !($6 < 0.99 * $7))
        why = "length " $2 ", wanted " $3
      if (!($6 <= $7 * (1 + 1e-5) + 1e-10)) why = $6 ", at most " $7
    }
    print (why == "" ? "ok " : "not ok ") $1 (why == "" ? "" : ": " why)
  }
  END { print (NR == 15 ? "" : "not ") "ok all of them" }'

# ---- sweeps, settings, options -----------------------------------------------

solve "{$points}" --basis=atph --alpha=1 --criterion=hc --axis=bisector \
  --tension=0.5 --shape=false --knots='[0,1,2,3]' --closed=false
expect 'fields as options' 0
mv out options
solve "{$points,\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"hc\",
  \"axis\":\"bisector\",\"tension\":0.5,\"shape\":false,\"knots\":[0,1,2,3]}"
equal_but_set 'fields as options: the same' options out
solve "{$points}" --tangents='[[1,0,0],[0,1,1],[1,-2,0],[0,0,3]]' \
  --angles='[[0,1],[1,2],[2,3]]'
mv out options
solve "{$hermite,\"angles\":[[0,1],[1,2],[2,3]]}"
equal_but_set 'arrays as options' options out
solve "{$points,\"criterion\":\"hc\"}" --set=criterion=bv --set tension=0.5
mv out set
solve "{$points,\"criterion\":\"hc\",\"tension\":0.5}"
equal_but_set '--set does not change what is there' out set
solve "{$points,\"criterion\":\"hc\"}" --override=criterion=bv
mv out set
solve "{$points,\"criterion\":\"bv\"}"
equal_but_set '--override does' out set

# swept NAME WANTED PATH ARGUMENT...: the values at a path of all records
swept() {
  name=$1 wanted=$2 path=$3
  shift 3
  solve "{$points,\"angles\":[[0,0.5],[0,1],[0,0]]}" "$@"
  expect "$name" 0
  equal "$name: its values" "$wanted" "$(get "$path")"
}

swept 'a sweep of tensions' '{"tension":0.5} {"tension":0.75} {"tension":1}' \
  sweep --sweep=tension=0.5:1:3
swept 'a sweep of one tension' '0.5 0.75 1' 'segments[1].tension' \
  -S 'tension[1]=0.5:1:3' --tension='[1,1,1]' --shape=false
swept 'a sweep of a coordinate of a tangent' '3' \
  'segments[0].control_points[0][0]' -S 'points[0][0]=3' \
  --tangents='[[1,0,0],[0,1,1],[1,-2,0],[0,0,3]]' -S 'tangents[0][2]=0.25'
swept 'a sweep of an angle' '[0,0] [0,1] [0,2]' 'segments[0].angles' \
  -S 'angles[0][1]=0,1,2'
solve "{$points,\"angles\":[0.5,3]}" -S 'angles[1]=0.25,10'
equal 'a sweep of an angle of all' '[0.5,0.25] [0.5,10] [0.5,0.25] [0.5,10]' \
  "$(get 'segments[0].angles') $(get 'segments[2].angles')"
solve "{$points}" -S criterion=cc,hc,bv,zero,F1 -S axis=x,bisector
equal 'a sweep of words' '10 {"criterion":"hc","axis":"x"}' \
  "$(wc -l <out | tr -d ' ') $(sed -n 3p out | json get sweep)"
json get length out >lengths
holds 'a sweep of words: each has its curve' 'n == 10 && x[1] == x[2] &&
  x[3] == x[4] && x[3] > x[1] && x[5] < x[3] && x[7] != x[8]' <lengths
for sweep in 'angles[3][0]=1' 'angles[0][2]=1' 'tension[0]=1' 'angles[0]=1'; do
  solve "{$points,\"angles\":[[0,0],[0,1],[0,0]],\"tension\":1}" -S "$sweep"
  equal "a sweep of what is not there: $sweep" '1 "bad-shape"' \
    "$status $(get error.code)"
done

# ---- Bezier curves -----------------------------------------------------------

atph="$hermite,\"basis\":\"atph\",\"alpha\":[1,0.5,2],\"criterion\":\"cc\""
solve "{$atph}"
get length >atph.length
solve "{$atph}" --convert=bezier --tolerance=1e-6
expect 'convert' 0
equal 'convert: what it is' '"bezier" 3 5 [{interval:[number],'\
'control_points:[[number]],length:number}]' \
  "$(get curve) $(get dimension) $(get degree) $(shape_of segments)"
get diagnostics.conversion_error |
  holds 'convert: within the tolerance' 'n == 1 && x[1] > 0 && x[1] <= 1e-6'
equal 'convert: the length stays' "$(cat atph.length)" "$(get length)"
json get segments out | sed 's/},{/}\n{/g' |
  sed 's/"length":[^}]*//; s/"[a-z_]*"//g; s/[^-+0-9.e]/ /g' >pieces
cat >joints.awk <<'EOF'
# Each line: an interval and six points.  Pieces of a segment join with first
# and second derivatives, those of different ones with their tangents.
function near(a, b, tol) { if ((a - b) ^ 2 > tol ^ 2) bad = NR }
{
  h = $2 - $1
  if (NF != 20) bad = NR
  for (c = 0; c < 3; c++) {
    r = $(3 + c)
    d[c] = 5 * ($(6 + c) - r) / h
    dd[c] = 20 * ($(9 + c) - 2 * $(6 + c) + r) / h ^ 2
    if (NR > 1) near(r, end[c], 0)
  }
  size = sqrt(d[0] ^ 2 + d[1] ^ 2 + d[2] ^ 2)
  knot = ($3 "," $4 "," $5) in points
  for (c = 0; NR > 1 && c < 3; c++) {
    near(d[c] / size, end1[c] / size1, 1e-12)
    if (!knot) { near(d[c], end1[c], 1e-11); near(dd[c], end2[c], 1e-8) }
  }
  met += knot
  for (c = 0; c < 3; c++) {
    end[c] = $(18 + c)
    end1[c] = 5 * ($(18 + c) - $(15 + c)) / h
    end2[c] = 20 * ($(18 + c) - 2 * $(15 + c) + $(12 + c)) / h ^ 2
  }
  size1 = sqrt(end1[0] ^ 2 + end1[1] ^ 2 + end1[2] ^ 2)
}
BEGIN { points["0,0,0"]; points["1,1,0"]; points["2,0,1"] }
END {
  if (bad || NR < 6 || met != 3 || end[2] != 3) {
    print "line " bad " of " NR ", " met " points"
    exit 1
  }
}
EOF
true_that 'convert: through the points, joints are smooth' \
  awk -f joints.awk pieces
solve "{$hermite}"
mv out ph
solve "{$hermite}" --convert=bezier
expect 'convert: a PH curve' 0
equal 'convert: a PH curve is its own' \
  "$(json get 'segments[1].control_points' ph) 0" \
  "$(get 'segments[1].control_points') $(get diagnostics.conversion_error)"
