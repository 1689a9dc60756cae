# SPDX-License-Identifier: GPL-3.0-or-later
#
# `tc' against simple truths: the cubic (t - t^3/3, t^2), lines, symmetries; its
# modes, and what is derived from curves.  (Published cases: tc-reference.t;
# errors: tc-errors.t; data at the edge: tc-degenerate.t.)
. "$srcdir/tests/cli/lib.sh"

# ends SEGMENT: its first and its last control point
ends() {
  get "segments[$1].control_points" |
    sed 's/^\[\(\[[^]]*\]\).*\(\[[^]]*\]\)\]$/\1 \2/'
}

# is NAME PATH VALUE [TOLERANCE]: one number of the record in out
is() {
  get "$2" | holds "$1: $2" \
    "n == 1 && (x[1] - ($3))^2 <= (${4-1e-14})^2"
}

# same NAME FILE: the record in out is that of the file, whatever options set
same() {
  equal_but_set "$1" "$2" out
}

some='"points":[[0,0],[1,2],[4,1],[5,3]]'
spline='"mode":"spline"'
pi=3.141592653589793

# ---- records -----------------------------------------------------------------

feed "{\"id\":7,\"meta\":[1],$some,$spline}" tc
expect 'a record' 0
equal 'a record: its members' '{id:number,command:string,status:string,'\
'meta:[number],curve:string,dimension:number,degree:number,closed:bool,'\
'segments:[{interval:[number],control_points:[[number]],'\
'preimage:[[number]],length:number}],intervals:[{length:number,'\
'segments:[number],root:string}],length:number,diagnostics:{'\
'iterations:number,residual:number,interpolation_error:number,'\
'end_derivative_error:number,tangent_error:number,pythagorean_error:number,'\
'continuity_error:number,length_error:number,'\
'max_curvature:number,regular:bool,lambda:number,loops:number,simple:bool,'\
'energy:number,rotation_index:number,absolute_rotation_index:number}}' \
  "$(json shape <out)"
equal 'a record: values' '7 [1] "tc" 2 3 false 0.5 true 0' \
  "$(get id) $(get meta) $(get curve) $(get dimension) $(get degree) \
$(get closed) $(get diagnostics.lambda) $(get diagnostics.simple) \
$(get diagnostics.loops)"
equal 'a record: two cubics an interval' '[0,1] [2,3] [4,5] absent' \
  "$(get 'intervals[0].segments') $(get 'intervals[1].segments') \
$(get 'intervals[2].segments') $(get 'intervals[3].segments')"
equal 'a record: standard pairs' '"++" "++" "++"' "$(get 'intervals[0].root') \
$(get 'intervals[1].root') $(get 'intervals[2].root')"
equal 'a record: knots count cubics' '[0,1] [1,2] [5,6]' \
  "$(get 'segments[0].interval') $(get 'segments[1].interval') \
$(get 'segments[5].interval')"
{
  get length
  echo
  get segments | grep -o '"length":[-0-9.e]*' | sed 's/.*://'
  get intervals | grep -o '"length":[-0-9.e]*' | sed 's/.*://'
} | holds 'a record: lengths add up' 'n == 10 &&
  (x[1] - x[2] - x[3] - x[4] - x[5] - x[6] - x[7])^2 < 1e-28 &&
  (x[8] - x[2] - x[3])^2 + (x[10] - x[6] - x[7])^2 < 1e-28'

# ---- the cubic (t - t^3/3, t^2), 0 <= t <= 1 ---------------------------------

# w = 1 + i t: its length is t + t^3/3, its curvature 2/(1 + t^2)^2.
points='"points":[[0,0],[0.6666666666666666,1]]'
energy="3 * $pi / 8 + 1"

# whole NAME: what holds for it, however many cubics it has
whole() {
  is "$1" length '4 / 3'
  is "$1" diagnostics.energy "$energy" 1e-13
  is "$1" diagnostics.max_curvature 2 1e-13
  is "$1" diagnostics.rotation_index 0.25
}

feed "{$points,\"tangents\":[[1,0],[0,1]],\"mode\":\"g1\"}" tc
expect 'one cubic' 0
whole 'one cubic'
floats 'segments[0].control_points' >found
printf '%s\n' 0 0 0.3333333333333333 0 0.6666666666666666 0.3333333333333333 \
  0.6666666666666666 1 >want
numbers 'one cubic: control points' 1e-15 want found
is 'one cubic' diagnostics.D '2 ^ 0.5'
equal 'one cubic: root' '"+" "+"' \
  "$(get diagnostics.root) $(get 'intervals[0].root')"
feed "{$points,\"derivatives\":[[0.5,0],[0,1]]}" tc
expect 'in halves' 0
whole 'in halves'
equal 'in halves: root' '"++"' "$(get diagnostics.root)"
floats 'segments[0].control_points[3]' >found
awk 'BEGIN { printf "%.17g\n0.25\n", 11 / 24 }' >want
numbers 'in halves: the joint' 1e-15 want found
curve='[[0,0],[0.3333333333333333,0],[0.6666666666666666,0.3333333333333333],
  [0.6666666666666666,1]]'
feed "{\"curve\":$curve,\"tolerance\":1e-9}" tc
expect 'approximated' 0
whole 'approximated'
equal 'approximated: by itself' '[0,1] absent' \
  "$(get 'segments[0].interval') $(get 'segments[1]')"
get diagnostics.distance | holds 'approximated: the distance' \
  'n == 1 && x[1] >= 0 && x[1] <= 1e-9'

# ---- modes -------------------------------------------------------------------

tangents='"tangents":[[1,0],[1,1],[0,-1],[1,2]]'
derivatives='"derivatives":[[1,0],[1,1],[1,-1],[1,2]]'
bezier='"curve":[[0,0],[1,3],[4,-2],[5,1]],"tolerance":1e-3'

# implied MODE MEMBERS: the mode is what it is without the word
implied() {
  feed "{$2}" tc -q
  mv out plain
  feed "{$2,\"mode\":\"$1\"}" tc -q
  expect "mode $1" 0
  same "mode $1: by what is given" plain
}

implied g2 "$some"
implied spline "$some,\"lambda\":0.4"
implied spline "$some,\"ends\":\"chord\""
implied spline "$some,\"solutions\":\"best\""
implied spline "$some,\"end_derivatives\":[[1,0],[0,1]]"
implied g1-fair "$some,$tangents"
implied c1 "$some,$derivatives"
implied approximate "$bezier"
feed '{"points":[[0,0],[1,3],[4,-2],[5,1]],"tolerance":1e-3}' tc \
  --mode=approximate
same 'points are a curve to approximate, if the mode says so' plain

# Of one interval: F = energy * length of one cubic, of two, of the fairer.
: >both
: >fair
for a in -2.5 -1.2 -0.3 0.4 1.5; do
  t=$(awk "BEGIN { printf \"[[%.17g,%.17g],[0.6,0.8]]\", cos($a), sin($a) }")
  feed "{\"points\":[[0,0],[3,0]],\"tangents\":$t}" tc -S \
    mode=g1-auto,g1-pair,g1-fair
  true_that "angle $a: in three modes" count 3 out
  table diagnostics.energy length |
    awk '{ f[NR] = $1 * $2 } END { printf "%.12g\n", f[1] < f[2] ? f[1] : f[2] }
      ' >>both
  table diagnostics.energy length |
    awk 'NR == 3 { printf "%.12g\n", $1 * $2 }' >>fair
done
numbers 'g1-fair: the smaller F of g1-auto and g1-pair' 1e-11 both fair
# One cubic that all but stands still is not what tangents alone ask for.
near='"points":[[0,0],[1,0]],"tangents":[[1,0.01],[-0.8,0.6]]'
feed "{$near}" tc -S mode=g1-fair,g1-auto
table diagnostics.max_curvature | holds 'no near cusp unless it is asked for' \
  'n == 2 && x[1] < 10 && x[2] > 1e5'
feed "{$some,$tangents}" tc -S mode=g1-pair,g1-auto
equal 'g1-auto: fewer cubics than two for each interval' true "$(
  table segments | awk '{ n[NR] = gsub(/control_points/, "") }
    END { print n[1] == 6 && n[2] < 6 ? "true" : "false" }')"
feed "{$some,$tangents}" tc --mode=g1-pair --lambda=0.4
equal 'g1-pair with a lambda: joined with derivatives' true "$(get segments |
  tr -d 'a-z_":{}[]' | tr ',' '\n' | awk 'NF { x[++n] = $1 }
    END { same = 1
      for (k = 1; k < 6; k++) {
        p = 15 * (k - 1) + 2
        for (c = 1; c <= 2; c++) {
          d = x[p + 6 + c] - x[p + 4 + c] - (x[p + 17 + c] - x[p + 15 + c])
          if (!(d * d < 1e-28)) same = 0
        }
      }
      print same && n == 90 ? "true" : "false " n }')"

# ---- splines -----------------------------------------------------------------

feed '{"points":[[0,0],[1,0],[3,0],[3.5,0]]}' tc
expect 'along a line' 0
is 'along a line' length 3.5
is 'along a line' diagnostics.max_curvature 0 0
square='"points":[[0,0],[2,0],[2,2],[0,2]]'
feed "{$square,$spline}" tc --closed
expect 'a square' 0
equal 'a square: closed' 'true [0,0] [0,0]' \
  "$(get closed) $(ends 0 | cut -d' ' -f1) $(ends 7 | cut -d' ' -f2)"
is 'a square' diagnostics.rotation_index 1
get intervals | grep -o '"length":[-0-9.e]*' | sed 's/.*://' |
  holds 'a square: four equal lengths' \
    'n == 4 && (x[1] - x[2])^2 + (x[1] - x[3])^2 + (x[1] - x[4])^2 < 1e-28'
floats 'segments[0].control_points[1]' |
  holds 'a square: the derivative is half the side, across the corner' \
    'n == 2 && (3 * x[1] - 2 ^ -0.5)^2 + (3 * x[2] + 2 ^ -0.5)^2 < 1e-28'
mv out closed
feed '{"points":[[0,0],[2,0],[2,2],[0,2],[0,0]],"closed":true,"mode":"spline"}' tc
same 'a square: the first point again' closed
feed "{$some,$spline}" tc
mv out plain
feed "{$some,\"ends\":\"chord\",\"lambda\":0.5}" tc
same 'ends and lambda by default' plain
feed "{$some,$spline,\"end_tangents\":[[2,4],[0.5,1]]}" tc
same 'end tangents along the chords, of any length' plain
feed "{$some,\"end_derivatives\":[[0.5,1],[0.5,1]]}" tc
same 'end derivatives as by default' plain
feed '{"points":[[3,0],[0,3],[-3,0]],"ends":"circle","mode":"spline"}' tc
expect 'ends of a circle' 0
floats 'segments[0].control_points[1]' |
  holds 'ends of a circle: the tangent at its first point' \
    'n == 2 && (x[1] - 3)^2 < 1e-28 && x[2] > 0'

# ---- solutions ---------------------------------------------------------------

pair='"points":[[0,0],[5,0]],"derivatives":[[6,6],[6,3]]'
feed "{$pair,\"solutions\":\"all\"}" tc
expect 'all pairs' 0
equal 'all pairs: roots' '"++" "+-" "-+" "--"' "$(for i in 0 1 2 3; do
  get "solutions[$i].diagnostics.root"; echo; done | sort | tr '\n' ' ' |
    sed 's/ $//')"
equal 'all pairs: the best one is the first' "$(get segments)" \
  "$(get 'solutions[0].segments')"
for i in 0 1 2 3; do
  get "solutions[$i].diagnostics.energy"
  echo
done | holds 'all pairs: by energy' \
  'n == 4 && x[1] < x[2] && x[2] < x[3] && x[3] < x[4]'
equal 'all pairs: no fifth' absent "$(get 'solutions[4]')"
feed "{$pair,\"solutions\":\"standard\"}" tc
equal 'the standard pair' '"++" absent' \
  "$(get diagnostics.root) $(get solutions)"
feed "{$some,$derivatives,\"solutions\":\"all\"}" tc
expect 'all of three intervals' 0
equal 'all of three intervals: 4^3' 64 \
  "$(get solutions | grep -o '"closed"\|"length":[^}]*,"diagnostics"' | wc -l |
    tr -d ' ')"

# ---- joints on the chord -----------------------------------------------------

chord='"points":[[0,0],[4,0]],"tangents":[[1,-2],[1,2]],"mode":"g1-pair"'
chord="$chord,\"joint\":\"chord\""
feed "{$chord,\"joint_angle\":0.05,\"joint_position\":0.25}" tc -q
expect 'a joint on the chord' 0
equal 'a joint on the chord: what is given' '"chord" 0.05 0.25' \
  "$(get 'intervals[0].root') $(get 'intervals[0].joint_angle') \
$(get 'intervals[0].joint_position')"
floats 'segments[0].control_points' | holds 'a joint on the chord: there' \
  'n == 8 && (x[7] - 1)^2 + x[8]^2 < 1e-28 &&
    ((x[8] - x[6]) / (x[7] - x[5]) - sin(0.05) / cos(0.05))^2 < 1e-24'
feed "{$chord}" tc -q -S joint_angle=-0.05,0.05,0.1
expect 'a sweep of the angle' 1 'phspline: -:1: record 1: segments[0]: no '\
'two cubics meet on the chord at the angle 0.1: it must be between '\
'-0.0886875 and 3.08164 and between -3.08164 and 0.0886875, and not 0 '\
'[infeasible]'
equal 'a sweep of the angle: outcomes' '"ok" "ok" "error"' "$(get status)"
equal 'a sweep of the angle: values' '{"joint_angle":-0.05} '\
'{"joint_angle":0.05} {"joint_angle":0.1}' "$(get sweep)"
table diagnostics.energy | sed 2q | holds 'a sweep of the angle: symmetric' \
  'n == 2 && (x[1] / x[2] - 1)^2 < 1e-24'

# ---- sweeps, options ---------------------------------------------------------

feed "{\"id\":1,$some}" tc -S lambda=0.2:1:5
expect 'a sweep of lambda' 0
equal 'a sweep of lambda: values' '0.2 0.4 0.6000000000000001 0.8 1' \
  "$(get diagnostics.lambda)"
table length | holds 'a sweep of lambda: five lengths' \
  'n == 5 && x[1] != x[2] && x[2] != x[3] && x[3] != x[4] && x[4] != x[5]'
feed '{}' tc --points='[[0,0],[3,4]]' --blaschke
expect 'a problem of options' 0
is 'a problem of options' length 5
feed "{$some,$spline}" tc -v
sed 's/[0-9.]* ms/T ms/; s/residual [-0-9.e]*/residual R/' err >said
mv said err
expect '--verbose' 0 \
  'phspline: -:1: record 1: 0 iterations, residual R, T ms'
awk -v some="$some" -v pair="$pair" -v bezier="$bezier" 'BEGIN {
  for (i = 0; i < 200; i++)
    print i % 3 ? (i % 3 > 1 ? "{" pair "}" : "{" some "}") : "{" bezier "}" }
  ' >many.jsonl
run tc -q -j 1 many.jsonl
mv out one
run tc -q -j 4 many.jsonl
expect '--jobs' 0
same '--jobs: not a byte differs' one

# ---- CSV ---------------------------------------------------------------------

# csv NAME ROWS MEMBERS: rows, with no blanks in them, are the problem
csv() {
  # rows are words
  # shellcheck disable=SC2086
  printf '%s\n' $2 >in.csv
  run tc -q in.csv
  expect "$1" 0
  mv out found
  feed "{$3}" tc -q
  same "$1: the same as in JSON" found
}

csv 'points' 'x,y 0,0 1,2 4,1 5,3' "$some"
csv 'points with tangents' \
  'x,y,tx,ty 0,0,1,0 1,2,1,1 4,1,0,-1 5,3,1,2' "$some,$tangents"
csv 'points with derivatives' \
  'dx,dy,x,y 1,0,0,0 1,1,1,2 1,-1,4,1 1,2,5,3' "$some,$derivatives"

cubic='"points":[[0,0],[0.6666666666666666,1]],"tangents":[[1,0],[0,1]]'
feed "{\"id\":5,$cubic}" tc -f csv
printf '%s\n' id,segment,index,x,y 5,0,0,0,0 5,0,1,0.3333333333333333,0 \
  5,0,2,0.6666666666666666,0.3333333333333333 5,0,3,0.6666666666666666,1 >want
numbers 'a table of control points' 1e-15 want out
feed "{\"id\":5,$cubic}" tc -f csv --table=lengths
printf '%s\n' id,segment,t0,t1,length,cumulative \
  5,0,0,1,1.3333333333333333,1.3333333333333333 >want
numbers 'a table of lengths' 1e-15 want out
feed "{\"id\":5,$cubic}" tc -f csv --table=samples -n 2
awk -F, 'BEGIN { print "id,segment,t,s,x,y,tx,ty,curvature"
  for (t = 0; t <= 1; t += 0.5) {
    w = 1 + t * t
    printf "5,0,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", t, t + t^3 / 3,
      t - t^3 / 3, t * t, (1 - t * t) / w, 2 * t / w, 2 / (w * w) } }' >want
numbers 'a table of samples' 1e-14 want out

# ---- offsets, images ---------------------------------------------------------

# The weights are those of 1 + t^2; o = r + d n.
feed "{\"id\":5,$cubic}" tc -f csv --table=offsets -d 0.25,-1
{
  echo id,distance,segment,index,x,y,weight
  for d in 0.25 -1; do
    awk -v d=$d 'BEGIN { printf "5,%s,0,0,0,%.17g,1\n5,%s,0,5,%.17g,1,2\n", d,
      d, d, 2 / 3 - d }'
  done
} >want
awk -F, 'NR == 1 || $4 == 0 || $4 == 5' out >ends.found
numbers 'offsets: their ends' 1e-15 want ends.found
cut -d, -f7 out | sed 1d | holds 'offsets: weights' \
  'n == 12 && (x[2] - 1)^2 < 1e-28 && (x[3] - 1.1)^2 < 1e-28 &&
    (x[4] - 1.3)^2 < 1e-28 && (x[5] - 1.6)^2 < 1e-28 && (x[6] - 2)^2 < 1e-28 &&
    (x[9] - 1.1)^2 < 1e-28'

# A cubic that turns by more than a half turn is cut where it bends most.
loop='"points":[[0,0],[1,0]],"mode":"g1",
  "tangents":[[0.5403023058681398,-0.8414709848078965],[1,0]]'
feed "{$loop,\"blaschke\":true}" tc -d 0.01
expect 'a loop' 0 'phspline: -:1: record 1: warning: the curve of interval 0 '\
'has a loop or crosses itself (such intervals: 1) [loop]'
equal 'a loop: offset and image are cut at the same place' \
  "$(get 'segments[0].blaschke[0].interval')$(get \
  'segments[0].blaschke[1].interval')" \
  "$(get 'offsets[0].segments[0].interval')$(get \
  'offsets[0].segments[1].interval')"
equal 'a loop: into two pieces' 'absent absent' "$(get \
  'segments[0].blaschke[2]') $(get 'offsets[0].segments[2]')"
for i in 0 1; do
  floats "offsets[0].segments[$i].weights" >weights.$i
done
cat weights.0 weights.1 | holds 'a loop: weights of the offset' 'n == 12 &&
  x[1] > 0 && x[2] > 0 && x[3] > 0 && x[4] > 0 && x[5] > 0 && x[6] > 0 &&
  x[7] > 0 && x[8] > 0 && x[9] > 0 && x[10] > 0 && x[11] > 0 && x[12] > 0'
floats 'segments[0].blaschke[1].weights' >found
numbers 'a loop: weights of the image are the same' 1e-14 weights.1 found

# The image of the cubic goes from (0, 1, 0) to (-1, 0, 2/3).
feed "{$cubic}" tc --blaschke
expect 'an image' 0
equal 'an image: degree 5' \
  '[{interval:[number],control_points:[[number]],weights:[number]}]' \
  "$(shape_of 'segments[0].blaschke')"
floats 'segments[0].blaschke[0].control_points' |
  holds 'an image: its ends' 'n == 18 && x[1]^2 < 1e-28 &&
    (x[2] - 1)^2 < 1e-28 && x[3]^2 < 1e-28 && (x[16] + 1)^2 < 1e-28 &&
    x[17]^2 < 1e-28 && (x[18] - 2 / 3)^2 < 1e-28'
