# SPDX-License-Identifier: GPL-3.0-or-later
#
# `sphere' against simple truths: circles, ends, symmetries, units, tensions,
# sweeps.  (Its errors: sphere-errors.t; data at the edge: sphere-degenerate.t;
# offsets: sphere-offset.t; CSV: sphere-csv.t.)
#
# shellcheck disable=SC2034  # rough is for sphere.sh
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/sphere.sh"

# samples COLUMNS: of the table that curve() left
samples() {
  cut -d, -f"$1" samples.csv | sed 1d
}

pi=3.141592653589793
degree=0.017453292519943295
some='"lonlat":[[0,0],[10,20],[40,30],[60,-10],[100,-20]]'
ring='"lonlat":[[0,0],[30,20],[70,10],[80,-30],[20,-40]],"closed":true'

# ---- records -----------------------------------------------------------------

feed "{\"id\":7,\"meta\":[1],$some}" sphere
expect 'a record' 0
equal 'a record: its members' '{id:number,command:string,status:string,'\
'meta:[number],curve:string,dimension:number,degree:number,closed:bool,'\
'segments:[{interval:[number],control_points:[[number]],length:number}],'\
'center:[number],radius:number,tensions:[number],indicators:[number],'\
'length:number,diagnostics:{iterations:number,residual:number,'\
'interpolation_error:number,end_derivative_error:number,'\
'continuity_error:number,length_error:number,sphere_error:number,'\
'curvature_jump:number,max_curvature:number,tension_sum:number,'\
'tension_relative_sum:number,max_tension_relative:number,shape_ok:bool}}' \
  "$(json shape <out)"
equal 'a record: values' '"spherical-nu" 3 3 false' \
  "$(get curve) $(get dimension) $(get degree) $(get closed)"
equal 'a record: the knots' 0 "$(get 'segments[0].interval[0]')"
for i in 0 1 2; do
  equal "a record: interval $((i + 1)) follows" \
    "$(get "segments[$i].interval[1]")" \
    "$(get "segments[$((i + 1))].interval[0]")"
done
floats 'segments[0].interval' | holds 'a record: intervals are angles' \
  'n == 2 && (x[2] - 0.3886629117282935)^2 < 1e-30'
{
  get length
  echo
  get segments | grep -o '"length":[-0-9.e]*' | sed 's/.*://'
} | holds 'a record: lengths add up' \
  'n == 5 && (x[1] - x[2] - x[3] - x[4] - x[5])^2 < 1e-28'
get diagnostics.curvature_jump |
  holds 'a record: no jump of the curvature' 'n == 1 && x[1] < 1e-10'
get diagnostics.sphere_error | holds 'a record: on the sphere' \
  'n == 1 && x[1] < 1e-14'

# ---- circles -----------------------------------------------------------------

# A great circle: its length is the angle times the radius.
for radius in 1 6371 1e-9 1e9; do
  curve "a great circle, radius $radius" \
    "\"lonlat\":[[10,20],[50,-60]],\"radius\":$radius"
  get length | holds "a great circle, radius $radius: its length" \
    "n == 1 && (x[1] / $radius - 1.5070280953891477)^2 < 1e-26"
done

# Circles of latitude: their length is 2 pi cos(lat), their geodesic curvature
# tan(lat); the error falls with the fourth power of the spacing.
for latitude in 30 -60; do
  for n in 12 24 48; do
    points=$(awk "BEGIN { for (i = 0; i < $n; i++)
      printf \"%s[%.17g,$latitude]\", i ? \",\" : \"\", 360 * i / $n }")
    curve "latitude $latitude, $n points" "\"lonlat\":[$points],\"closed\":true"
    { get length; echo; samples 11; } | awk -v n=$n -v lat=$latitude \
      -v d=$degree -v pi=$pi '
      NR == 1 { length_ = $1 }
      NR > 1 {
        off = $1 - sin(lat * d) / cos(lat * d)
        if (off < 0) off = -off
        if (off > worst) worst = off
      }
      END { off = length_ / (2 * pi * cos(lat * d)) - 1
        printf "%.17g\n%.17g\n", (off < 0 ? -off : off), worst }' >errors.$n
  done
  cat errors.12 errors.24 errors.48 |
    holds "latitude $latitude: the length" 'n == 6 && x[1] < 1e-2 &&
      x[3] < x[1] / 12 && x[5] < x[3] / 12'
  cat errors.12 errors.24 errors.48 |
    holds "latitude $latitude: the curvature" 'n == 6 && x[2] < 0.2 &&
      x[4] < x[2] / 3.5 && x[6] < x[4] / 3.5'
done

# ---- ends --------------------------------------------------------------------

curve 'natural ends' "$some"
mv out natural
samples 11 | holds 'natural ends: no curvature' \
  'n == 36 && x[1]^2 < 1e-24 && x[36]^2 < 1e-24 && x[9]^2 > 1e-4'
curve 'natural ends, by name' "$some,\"ends\":\"natural\""
equal_files 'natural ends, by name' natural out
curve 'rest ends' "$some,\"ends\":\"rest\""
equal 'rest ends: two control points are one' \
  "$(get 'segments[0].control_points[0]') $(get 'segments[3].control_points[3]')" \
  "$(get 'segments[0].control_points[1]') $(get 'segments[3].control_points[2]')"
samples 11 | sed -n '1p;36p' >found
printf '\n\n' >want
equal_files 'rest ends: no curvature there' want found

# The end tangents: east at 0,0 and south at 100,-20.
ends="$some,\"ends\":\"clamped\",\"end_tangents\":"
east='[0,1,0]'
south=$(awk -v d=$degree 'BEGIN { printf "[%.17g,%.17g,%.17g]",
  sin(-20 * d) * cos(100 * d), sin(-20 * d) * sin(100 * d), -cos(20 * d) }')
curve 'clamped ends' "${ends}[$east,$south]"
mv out clamped
printf '%s\n' "$east" "$south" | tr -d '[]' | tr ',' '\n' >want
samples 8-10 | sed -n '1p;36p' | tr ',' '\n' >found
numbers 'clamped ends: the tangents' 1e-15 want found
curve 'clamped ends, because of tangents' \
  "$some,\"end_tangents\":[$east,$south]"
equal_files 'clamped ends, because of tangents' clamped out
curve 'clamped ends, other sizes, other parts along the radius' \
  "${ends}[[-7,128,0],$(printf %s "$south" | tr -d '[]' | awk -F, '{
    printf "[%.17g,%.17g,%.17g]", $1 / 16, $2 / 16, $3 / 16 }')]"
joints >found
get length >>found
mv clamped out
joints >want
get length >>want
numbers 'clamped ends, other sizes: the same curve' 1e-14 want found

# ---- units, symmetries -------------------------------------------------------

# numbers_of: control points, lengths, tensions of the record in out
numbers_of() {
  get segments | tr -d '{}[]"a-z_:' | tr ',' '\n' | sed '/^$/d'
  floats tensions
  get length
  echo
}

# xyz RADIUS X Y Z [ROW]: the points of $some on that sphere, by a rotation of
# the axes (cyclic, an even power of it) or a mirror image
xyz() {
  printf '0 0\n10 20\n40 30\n60 -10\n100 -20\n' | awk -v d=$degree -v r="$1" \
    -v x="$2" -v y="$3" -v z="$4" -v how="${5-}" '
    {
      p[1] = cos($2 * d) * cos($1 * d)
      p[2] = cos($2 * d) * sin($1 * d)
      p[3] = sin($2 * d)
      if (how == "turn") { t = p[1]; p[1] = p[2]; p[2] = p[3]; p[3] = t }
      if (how == "mirror") p[3] = -p[3]
      row[NR] = sprintf("[%.17g,%.17g,%.17g]", x + r * p[1], y + r * p[2],
        z + r * p[3])
    }
    END {
      for (i = 1; i <= NR; i++)
        printf "%s%s", (i > 1 ? "," : ""), row[how == "back" ? NR + 1 - i : i]
    }'
}

for more in '' ',"ends":"rest"' ',"model":"nielson"' ',"tension":3' \
  ',"shape":false,"closed":true'; do
  case $more in *nielson*) rough=0.5 ;; *) rough=1e-9 ;; esac
  curve "degrees $more" "$some$more"
  numbers_of >want
  equal "degrees $more: the sphere" '[0,0,0] 1' "$(get center) $(get radius)"
  curve "coordinates $more" "\"points\":[$(xyz 1 0 0 0)]$more"
  numbers_of >found
  numbers "coordinates $more: the same" 1e-13 want found
  curve "another sphere $more" \
    "\"points\":[$(xyz 8 1 -2 4)],\"center\":[1,-2,4],\"radius\":8$more"
  joints | awk -F, '{ printf "%.17g,%.17g,%.17g\n", ($1 - 1) / 8,
    ($2 + 2) / 8, ($3 - 4) / 8 }' >found
  { get length; echo; } | awk '{ printf "%.17g\n", $1 / 8 }' >>found
  curve "degrees again $more" "$some$more"
  joints >want
  { get length; echo; } >>want
  numbers "another sphere $more: the same" 1e-13 want found
  samples 11 >want
  curve "the axes renamed $more" "\"points\":[$(xyz 1 0 0 0 turn)]$more"
  samples 11 >found
  numbers "the axes renamed $more: the same curvature" 1e-11 want found
  indicators=$(get indicators)
  curve "mirrored $more" "\"points\":[$(xyz 1 0 0 0 mirror)]$more"
  samples 11 | sed 's/^/-/; s/^--//; s/^-$//; s/^-0$/0/' >found
  numbers "mirrored $more: the curvature, of the other sign" 1e-11 want found
  equal "mirrored $more: the indicators, of the other sign" \
    "$(printf %s "$indicators" | sed 's/1/+1/g; s/-+1/1/g; s/+1/-1/g')" \
    "$(get indicators)"
done
for more in '' ',"ends":"rest"' ',"model":"nielson"' ',"tension":3'; do
  case $more in *nielson*) rough=0.5 ;; *) rough=1e-9 ;; esac
  curve "forwards $more" "$some$more"
  samples 5-7,11 | sed 's/,$/,0/' >want
  curve "backwards $more" "\"points\":[$(xyz 1 0 0 0 back)]$more"
  samples 5-7,11 | sed 's/,$/,0/' | awk -F, '{ row[NR] = $0 }
    END { for (i = NR; i > 0; i--) { split(row[i], x, ",")
      printf "%s,%s,%s,%.17g\n", x[1], x[2], x[3], -x[4] } }' >found
  numbers "backwards $more: the same curve" 1e-11 want found
done
rough=1e-9

# The nodes of a closed curve may be counted from any of them.
curve 'closed' "$ring"
get length >want
equal 'closed: a tension and an indicator for each point' 5,5 \
  "$(floats tensions | wc -l | tr -d ' '),$(floats indicators | wc -l |
    tr -d ' ')"
samples 11 | sed -n '19,36p' >part.want
curve 'closed, from the third point' \
  '"lonlat":[[70,10],[80,-30],[20,-40],[0,0],[30,20]],"closed":true'
get length >found
numbers 'closed, from the third point: the length' 1e-13 want found
samples 11 | sed -n '1,18p' >part.found
numbers 'closed, from the third point: the curvature' 1e-10 part.want part.found

# ---- models ------------------------------------------------------------------

# The published construction is smooth in direction, not in curvature.
rough=0.5
curve 'nielson' "$some,\"model\":\"nielson\""
get diagnostics.curvature_jump |
  holds 'nielson: the curvature jumps' 'n == 1 && x[1] > 1e-3'
samples 2,11 | awk -F, '$1 != k && NR > 1 { if (($2 / was - 1)^2 > 1e-6) jumps++ }
  { k = $1; was = $2 } END { exit !(jumps == 3) }'
equal 'nielson: samples say so, too' 0 $?
rough=1e-9
curve 'exact' "$some,\"model\":\"exact\""
samples 2,11 | awk -F, '$1 != k && NR > 1 { if (($2 / was - 1)^2 < 1e-24) same++ }
  { k = $1; was = $2 } END { exit !(same == 3) }'
equal 'exact: no jump in the samples' 0 $?

# ---- knots -------------------------------------------------------------------

curve 'uniform knots' "$some,\"knots\":\"uniform\""
joints >want
get length >>want
curve 'equal knots' "$some,\"knots\":[-3,-1,1,3,5]"
equal 'equal knots: they are kept' '[-3,-1] [3,5]' \
  "$(get 'segments[0].interval') $(get 'segments[3].interval')"
joints >found
get length >>found
numbers 'equal knots: the curve of uniform knots' 1e-13 want found
# A tension is per spacing: knots four times apart want a fourth of it.
curve 'a tension' "$some,\"shape\":false,\"knots\":[0,1,2,4,5],\"tension\":8"
joints >want
get length >>want
curve 'a tension, other units' \
  "$some,\"shape\":false,\"knots\":[0,4,8,16,20],\"tension\":2"
joints >found
get length >>found
numbers 'a tension, other units: the same curve' 1e-13 want found

# ---- shape -------------------------------------------------------------------

# A run along the equator, and a corner.
corner='"lonlat":[[0,0],[20,0],[40,0],[60,0],[60,20],[60,40],[60,60]]'
curve 'a corner, as it is' "$corner,\"shape\":false"
equal 'a corner, as it is: it does not keep its shape' \
  'false [0,0,0,0,0,0,0] [0,0,0,1,0,0,0]' \
  "$(get diagnostics.shape_ok) $(get tensions) $(get indicators)"
: >sums
for epsilon in 1 0.1 0.01 0.001; do
  curve "a corner, epsilon $epsilon" "$corner,\"epsilon\":$epsilon"
  equal "a corner, epsilon $epsilon: its shape" true \
    "$(get diagnostics.shape_ok)"
  printf '%s\n' "$(get diagnostics.tension_sum)" >>sums
  # on both sides of the second and third node, and of the fifth and sixth
  samples 11 | sed -n '9p;10p;18p;19p;36p;37p;45p;46p' |
    awk -v e=$epsilon '!($1 * $1 < e * e) { bad = 1 }
      END { exit bad || NR != 8 }'
  equal "a corner, epsilon $epsilon: the curvature in the runs" 0 $?
done
holds 'a corner: the smaller epsilon, the more tension' \
  'n == 4 && x[1] < x[2] && x[2] < x[3] && x[3] < x[4]' <sums
for increase in plus:10 times:2; do
  curve "a corner, $increase" "$corner,\"increase\":\"$increase\""
  equal "a corner, $increase: its shape" true "$(get diagnostics.shape_ok)"
  { printf '%s\n' "$(get diagnostics.tension_sum)"; sed -n 3p sums; } |
    holds "a corner, $increase: more than the smallest tension" \
      'n == 2 && x[1] > x[2]'
done
curve 'a corner, plus:10' "$corner,\"increase\":\"plus:10\""
floats tensions | awk '$1 % 10 { bad = 1 } $1 > 0 { some = 1 }
  END { exit bad || !some }'
equal 'a corner, plus:10: tensions are so many tens' 0 $?

# Data that turn left only, at great and small angles: so does the curve.
left='"lonlat":[[0,0],[40,0],[60,1],[70,25],[69,45],[20,50]]'
curve 'always left, as it is' "$left,\"shape\":false"
equal 'always left, as it is: not so' false "$(get diagnostics.shape_ok)"
curve 'always left' "$left"
equal 'always left: indicators' '[0,1,1,1,1,0]' "$(get indicators)"
samples 11 | awk '!($1 > -1e-12) { bad = 1 } END { exit bad || NR < 45 }'
equal 'always left: the curvature is nowhere negative' 0 $?
floats tensions | holds 'always left: not all tensions are needed' \
  'n == 6 && (x[2] == 0 || x[3] == 0 || x[4] == 0 || x[5] == 0) &&
    x[2] + x[3] + x[4] + x[5] > 0'

# Tensions that are given are where it begins; one is for all inner nodes.
curve 'a tension for all' "$some,\"tension\":5"
equal 'a tension for all: not of the ends' '[0,5,5,5,0]' "$(get tensions)"
curve 'a tension for all, closed' "$ring,\"tension\":5"
equal 'a tension for all, closed' '[5,5,5,5,5]' "$(get tensions)"
: >lengths
for tension in 0 1 10 100 1000; do
  curve "tension $tension" "$some,\"tension\":$tension"
  printf '%s\n' "$(get length)" >>lengths
done
holds 'the more tension, the shorter' 'n == 5 && x[1] > x[2] && x[2] > x[3] &&
  x[3] > x[4] && x[4] > x[5]' <lengths

# ---- sweeps, options ---------------------------------------------------------

feed "{\"id\":1,$some}" sphere -q --sweep=tension=0:20:3 -S model=exact,nielson
expect 'a sweep' 0
equal 'a sweep: values' '{"tension":0,"model":"exact"} '\
'{"tension":0,"model":"nielson"} {"tension":10,"model":"exact"} '\
'{"tension":10,"model":"nielson"} {"tension":20,"model":"exact"} '\
'{"tension":20,"model":"nielson"}' "$(get sweep)"
equal 'a sweep: tensions' '[0,0,0,0,0] [0,0,0,0,0] [0,10,10,10,0] '\
'[0,10,10,10,0] [0,20,20,20,0] [0,20,20,20,0]' "$(get tensions)"
feed "{$corner}" sphere -q -S epsilon=0.1,0.01,0
expect 'a sweep over epsilon' 1 'phspline: -:1: record 1: epsilon: must be at '\
'least 1e-11, found 0 [bad-value]'
equal 'a sweep over epsilon: results' '"ok" "ok" "error"' "$(get status)"
feed "{$some,\"tension\":[0,1,2,3,0]}" sphere -q -S 'tension[2]=5,6' \
  -S 'lonlat[1][1]=20,21'
equal 'a sweep over elements' \
  '[0,1,5,3,0] [0,1,5,3,0] [0,1,6,3,0] [0,1,6,3,0]' "$(get tensions)"
feed '{}' sphere --lonlat='[[0,0],[90,0]]' --radius=2 --center='[1,1,1]'
expect 'a problem of options' 0
get length | holds 'a problem of options: the length' \
  "n == 1 && (x[1] - $pi)^2 < 1e-26"
feed "{$some}" sphere -q -v
sed 's/[0-9.]* ms/T ms/; s/residual [-0-9.e]*/residual R/' err >said
mv said err
expect '--verbose' 0 \
  'phspline: -:1: record 1: 4 iterations, residual R, T ms'

# ---- help --------------------------------------------------------------------

run sphere --help
expect 'help' 0
cp out help
run help sphere
expect 'help sphere' 0
equal_files 'help sphere: the same' help out
for field in points lonlat closed center radius radius_tolerance model knots \
  ends end_tangents tension shape increase criterion epsilon; do
  true_that "help tells $field" grep -q "^  $field  " help
done
true_that 'help tells id and meta' grep -q '^  id, meta  ' help
grep -v -e '^    phspline' -e '^    printf' help | cut -c 81- | tr -d '\n' \
  >found
true_that 'help: lines of at most 80 characters, but for examples' \
  cmp found /dev/null
