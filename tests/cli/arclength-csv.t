# SPDX-License-Identifier: GPL-3.0-or-later
#
# Arc lengths from and to CSV, sweeps of them, and the options that make more
# of a curve.  (CSV itself: csv.t; options: options.t.)
. "$srcdir/tests/cli/lib.sh"

points='"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]]'
lengths='"lengths":[4.9,2.5,2]'
arch='"points":[[0,0],[1,0.8],[2,1],[3,0.7]],"lengths":[1.35,1.04,1.07]'
derivatives='"derivatives":[[-2,-1,-1],[1,0.5,0.5],[0,1,0.5],[0,-1,-0.5]],'\
'"lengths":[1.2,1.4,0.7]'
tangents='"tangents":[[1,0,0],[1,1,0],[0,1,1]],"lengths":[1,2]'

# table NAME TEXT PROBLEM [ARGUMENT...]: CSV, which is for printf, gives the
# curve that the JSON problem gives
table() {
  name=$1 text=$2
  printf '{%s}\n' "$3" >problem.json
  shift 3
  # shellcheck disable=SC2059
  printf "$text" >table.csv
  run arclength -q -f csv problem.json
  mv out want.csv
  run arclength -q -f csv "$@" table.csv
  expect "$name" 0
  equal_files "$name: the curve" want.csv out
  true_that "$name: there is one" [ "$(wc -l <out)" -gt 6 ]
}

# ---- input -------------------------------------------------------------------

table 'points and lengths' \
  'x,y,z,length\n1,1,0,\n0,4,3,4.9\n2,4,2,2.5\n3,3,3,2\n' "$points,$lengths"
table 'columns in another order, in capitals' \
  'LENGTH,z,X_m,y\n"",0,1,1\n4.9,3,0,4\n2.5,2,2,4\n2,3,3,3\n' \
  "$points,$lengths"
table 'points alone' '1,1,0\n0,4,3\n2,4,2\n3,3,3\n' "$points"
table 'a column length that is empty' \
  'x,y,z,length\n1,1,0,\n0,4,3,\n2,4,2,\n3,3,3,\n' "$points"
table 'points of two coordinates' \
  'x,y,length\n0,0,\n1,.8,1.35\n2,1,1.04\n3,.7,1.07\n' "$arch"
table 'knots' \
  'x,y,z,length,knot\n1,1,0,,0\n0,4,3,4.9,2\n2,4,2,2.5,3\n3,3,3,2,4\n' \
  "$points,$lengths,\"knots\":[0,2,3,4]"
table 'derivatives' \
  'dx,dy,dz,length\n-2,-1,-1,\n1,.5,.5,1.2\n0,1,.5,1.4\n0,-1,-.5,.7\n' \
  "$derivatives"
table 'tangents' 'length,tx,ty,tz\n,1,0,0\n1,1,1,0\n2,0,1,1\n' "$tangents"
table '--columns' '9,1,0,0\n1,1,1,0\n2,0,1,1\n' \
  "\"tangents\":[[1,0,0],[1,1,0],[0,1,1]],\"lengths\":[1,2]" \
  --columns=-,tx,ty,tz --lengths='[1,2]'
square='"points":[[0,0,0],[2,0,0],[2,2,1],[0,2,0]],"closed":true'
table 'closed: the first row has the length of the last segment' \
  'x,y,z,length\n0,0,0,2.3\n2,0,0,2.4\n2,2,1,2.6\n0,2,0,2.7\n' \
  "$square,\"lengths\":[2.4,2.6,2.7,2.3]" --closed
table 'closed: the last row repeats the first' \
  'x,y,z,length\n0,0,0,\n2,0,0,2.4\n2,2,1,2.6\n0,2,0,2.7\n0,0,0,2.3\n' \
  "$square,\"lengths\":[2.4,2.6,2.7,2.3]" --closed

# ---- fields as options -------------------------------------------------------

# option NAME PROBLEM MEMBER OPTION...: the option is the member
option() {
  name=$1
  feed "{$2,$3}" arclength -q
  mv out one
  problem=$2
  shift 3
  feed "{$problem}" arclength -q "$@"
  expect "$name as an option" 0
  equal_but_set "$name as an option: the same" one out
}

option lengths "$points" "$lengths" --lengths='[4.9, 2.5, 2]'
option refine "$points,$lengths" '"refine":1' --refine=1
option refine "$points,$lengths" '"refine":"auto"' --refine auto
option length_sigma "$points,$lengths" '"length_sigma":0.01' --length_sigma=.01
option magnitudes "$tangents" '"magnitudes":"mean"' --magnitudes=mean
option planar "$arch" '"planar":"free"' --planar=free
option starts "$points,$lengths" '"starts":2' --starts=2
option all_minima "$points,$lengths" '"all_minima":true' --all_minima
option start "$tangents" '"start":[1,2,3]' --start='[1,2,3]'
option start "$tangents" '"start":[1,2]' --start '[1,2]'
option knots "$points,$lengths" '"knots":"uniform"' --set knots=uniform

# ---- sweeps ------------------------------------------------------------------

# Figure 13 of Huard et al. 2014: the middle length.
# They lie in a plane, in which the curve is not the one that bends least.
printf '{%s,"knots":"uniform","planar":"free"}\n' "$derivatives" >13.json
run arclength -q --sweep='lengths[1]=1.4:1.456:5' 13.json
expect 'figure 13' 0
equal 'figure 13: the values' '{"lengths[1]":1.4} {"lengths[1]":1.414} '\
'{"lengths[1]":1.428} {"lengths[1]":1.442} {"lengths[1]":1.456}' "$(get sweep)"
json get 'intervals[1].length' out >found
printf '%s\n' 1.4 1.414 1.428 1.442 1.456 >want
numbers 'figure 13: the lengths' 1e-12 want found
json get 'intervals[0].length' out >found
printf '%s\n' 1.2 1.2 1.2 1.2 1.2 >want
numbers 'figure 13: the others stay' 1e-12 want found
json get diagnostics.F out | holds 'figure 13: F falls' \
  'n == 5 && (x[1] / 6.9538503429069785 - 1)^2 < 1e-12 && x[1] > x[2] &&
  x[2] > x[3] && x[3] > x[4] && x[4] > x[5] && x[5] > 6.349'
# A value does not depend on its neighbours.
for value in 1.4 1.428 1.456; do
  run arclength -q --sweep="lengths[1]=$value" 13.json
  cat out
done >alone
run arclength -q --sweep='lengths[1]=1.4,1.428,1.456' 13.json
equal_files 'figure 13: each value alone' alone out
run arclength -q --sweep=refine=1,2,3,auto 13.json
equal 'a sweep of refine' \
  '{"refine":1} {"refine":2} {"refine":3} {"refine":"auto"}' "$(get sweep)"
equal 'a sweep of refine: it is used' '[0,0] [0,1] [0,2] [0,1]' \
  "$(get 'intervals[0].segments')"

printf 'id,x,y,z,length\na,1,1,0,\na,0,4,3,4.9\na,2,4,2,2.5\n' >two.csv
printf 'b,0,0,0,\nb,1,0.1,0,1.1\nb,2,0,0.3,1.2\n' >>two.csv
run arclength -q --sweep='lengths[1]=2.5:2.7:3' two.csv
expect 'a sweep of a column' 0
equal 'a sweep of a column: of each record' '"a" "a" "a" "b" "b" "b"' \
  "$(get id)"
json get 'intervals[1].length' out >found
printf '%s\n' 2.5 2.6 2.7 2.5 2.6 2.7 >want
numbers 'a sweep of a column: the lengths' 1e-12 want found
run arclength -q -f csv --table=lengths --sweep='lengths[0]=4.9,5' \
  --refine=1 two.csv
equal 'a sweep of a column has a column' \
  'id,segment,t0,t1,length,cumulative,lengths[0]' "$(sed -n 1p out)"
awk -F, 'NR > 1 && $2 == 0 { print $5; print $7 }' out >found
printf '%s\n' 4.9 4.9 5 5 4.9 4.9 5 5 >want
numbers 'a sweep of a column: and its lengths' 1e-12 want found
feed "{$points}" arclength --sweep='lengths[1]=2,3'
expect 'a sweep of lengths that are not there' 1 \
  "phspline: -:1: record 1: lengths: has no element lengths[1] for --sweep to \
set [bad-shape]
phspline: -:1: record 1: lengths: has no element lengths[1] for --sweep to \
set [bad-shape]
$(failed 2 2)"
run arclength -q --lengths='[4.9,2.5,2]' --sweep='lengths[2]=1.9' - <<END
{$points}
END
get 'intervals[2].length' | holds 'a sweep of lengths that are an option' \
  '(x[1] - 1.9)^2 < 1e-24'

# ---- output ------------------------------------------------------------------

feed "{$points,$lengths}" arclength -q -f csv --table=lengths
expect 'the table lengths' 0
awk -F, 'NR > 1 { printf "%s,%s,%s,%s\n", $2, $3, $4, $6 }' out >found
cat >want <<'END'
0,0,0.78191489361702127,
1,0.78191489361702127,1.5638297872340425,4.9
2,1.5638297872340425,1.9627659574468086,
3,1.9627659574468086,2.3617021276595747,7.4
4,2.3617021276595747,2.6808510638297873,
5,2.6808510638297873,3,9.4
END
awk -F, -v OFS=, '$1 % 2 == 0 { $4 = "" } { print }' found >even
numbers 'the table lengths: by segments' 1e-12 want even
feed "{$points,$lengths}" arclength -q
mv out one
feed "{$points,$lengths}" arclength -q --convert=bezier
sed 's/,"conversion_error":0//' out >two
equal_files 'PH curves are Bezier curves' one two

feed "{$points,$lengths}" arclength -q --offset=0.25
expect '--offset' 0
equal '--offset: four curves' \
  '0.25 "e2" -0.25 "e2" 0.25 "e3" -0.25 "e3" absent' "$(for k in 0 1 2 3; do
    printf '%s %s ' "$(get "offsets[$k].distance")" "$(get "offsets[$k].vector")"
  done)$(get 'offsets[4]')"
for k in 0 1 2 3; do
  {
    floats "offsets[$k].segments[0].control_points[0]"
    floats 'segments[0].control_points[0]'
  } | holds "--offset: $k is at that distance" 'n == 6 && (sqrt(\
    (x[1] - x[4])^2 + (x[2] - x[5])^2 + (x[3] - x[6])^2) - 0.25)^2 < 1e-24'
done

# ---- threads -----------------------------------------------------------------

awk 'BEGIN {
  for (i = 1; i <= 200; i++) {
    text = ""; more = ""
    for (k = 0; k < 4; k++) {
      text = text sprintf("%s[%d,%.17g,%.17g]", k ? "," : "", k,
        sin(k + i), cos(k * i) / 2)
      if (k) more = more sprintf("%s%.17g", k > 1 ? "," : "",
        i % 10 ? 3 + (k + i) % 3 / 10 : 0.5)
    }
    if (i % 3 == 0) text = text "],\"planar\":\"free\",\"knots\":[0,1,2,3"
    print "{\"id\":" i ",\"points\":[" text "],\"lengths\":[" more "]}"
  }
}' >many.jsonl
run arclength --jobs=1 many.jsonl
mv out out.1
mv err err.1
equal 'some of two hundred fail' 1 "$status"
true_that 'a result for each' count 200 out.1
for jobs in 2 8; do
  run arclength --jobs=$jobs many.jsonl
  equal_files "--jobs=$jobs: results" out.1 out
  equal_files "--jobs=$jobs: messages" err.1 err
done
