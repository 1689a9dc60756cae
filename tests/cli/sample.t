# SPDX-License-Identifier: GPL-3.0-or-later
#
# --sample: samples in records and in the table `samples', in the plane and in
# space.  (On a sphere: sphere-csv.t.)
. "$srcdir/tests/cli/lib.sh"

line='"points":[[1,0],[5,0]]'
bend='"points":[[0,0],[1,2],[2,0],[3,1]]'
space='"points":[[0,0,0],[1,1,0],[2,0,1],[3,0,0]]'

# ---- records -----------------------------------------------------------------

feed "{$line}" planar --sample=2
expect 'a line' 0
equal 'a line: what a sample is' '[{segment:number,t:number,s:number,'\
'point:[number],tangent:[number],curvature:number}]' "$(shape_of samples)"
equal 'a line: its samples' '[{"segment":0,"t":0,"s":0,"point":[1,0],'\
'"tangent":[1,0],"curvature":0},{"segment":0,"t":0.5,"s":2,"point":[3,0],'\
'"tangent":[1,0],"curvature":0},{"segment":0,"t":1,"s":4,"point":[5,0],'\
'"tangent":[1,0],"curvature":0}]' "$(get samples)"
feed "{$line}" planar
equal 'without the option there are none' absent "$(get samples)"
feed "{$line}" planar -n 1
equal 'between length and diagnostics' 1 \
  "$(grep -c '"length":4,"samples":\[.*\],"diagnostics":' out)"
feed "{$line}" planar -n 1 --offset=1
equal 'after offsets' 1 "$(grep -c '"offsets":\[.*\],"samples":\[' out)"
feed "{$space}" spatial-hermite -q -n 3
equal 'in space' '[{segment:number,t:number,s:number,point:[number],'\
'tangent:[number],curvature:number,torsion:number}]' "$(shape_of samples)"
feed '{"points":[[0,0,0],[0,0,2]]}' spatial-hermite -n 1
equal 'a torsion that does not exist' '[{segment:number,t:number,s:number,'\
'point:[number],tangent:[number],curvature:number}]' "$(shape_of samples)"
feed "{$bend,\"solutions\":\"all\"}" planar -n 1
equal 'of the curve, not of all solutions' 'absent 1' \
  "$(get 'solutions[1].samples') $(get 'samples[1].t')"

# ---- the table ---------------------------------------------------------------

run planar -f csv --table=samples -n 2 - <<'END'
{"id":"a","points":[[1,0],[1,4]]}
{"id":"bad","points":[[1,0]]}
{"id":"b","points":[[0,0],[-2,0]]}
END
equal 'the table, and a problem that fails' 1 "$status"
cat >want <<'END'
id,segment,t,s,x,y,tx,ty,curvature
a,0,0,0,1,0,0,1,0
a,0,0.5,2,1,2,0,1,0
a,0,1,4,1,4,0,1,0
b,0,0,0,0,0,-1,0,0
b,0,0.5,1,-1,0,-1,0,0
b,0,1,2,-2,0,-1,0,0
END
numbers 'the table' 1e-15 want out

# Every segment has its N + 1, its first and last points are those of the data,
# and s counts from the start of the curve.
ends() {
  awk -F, -v n="$1" -v at="$2" -v segment=-1 'NR == 1 { next }
  $2 != segment { segment = $2; first = 1; rows = 0 }
  { rows++ }
  first || rows == n + 1 {
    printf "%s %s", $2, $3
    for (i = 5; i < 5 + at; i++) printf " %s", $i
    print ""
    first = 0
  }' out
}
feed "{$bend}" planar -f csv --table=samples -n 4
ends 4 2 >found
printf '%s\n' '0 0 0 0' '0 1 1 2' '1 0 1 2' '1 1 2 0' '2 0 2 0' '2 1 3 1' >want
numbers 'ends of the segments' 0 want found
true_that 'N + 1 for each segment' count 16 out
tail -n 1 out | cut -d, -f4 >found
feed "{$bend}" planar
get length >want
echo >>want
numbers 'the last s is the length' 1e-15 want found
feed "{$space}" spatial-hermite -q -f csv --table=samples -n 3
equal 'in space: columns' \
  id,segment,t,s,x,y,z,tx,ty,tz,curvature,torsion "$(sed -n 1p out)"
ends 3 3 >found
printf '%s\n' '0 0 0 0 0' '0 1 1 1 0' '1 0 1 1 0' '1 1 2 0 1' '2 0 2 0 1' \
  '2 1 3 0 0' >want
numbers 'in space: ends of the segments' 0 want found
feed '{"points":[[0,0,0],[0,0,2]]}' spatial-hermite -n 1 -f csv --table=samples
cut -d, -f 11,12 out | sed 1d | sort -u >found
equal 'a torsion that does not exist leaves its cell empty' '0,' "$(cat found)"
feed "{$bend}" planar -f csv --table=samples -n 1 --sweep=knots=chordal,uniform
equal 'swept fields come last' \
  'id,segment,t,s,x,y,tx,ty,curvature,knots chordal uniform' \
  "$(sed -n 1p out) $(cut -d, -f10 out | sed 1d | uniq | tr '\n' ' ' |
    sed 's/ $//')"

# ---- other bases -------------------------------------------------------------

atph="{$bend,\"basis\":\"atph\",\"alpha\":[0.5,1,1.5]}"
feed "$atph" planar -f csv --table=samples -n 2
awk -F, '$2 == 1 { print $3 }' out >found
printf '%s\n' 0 0.5 1 >want
numbers 'atph: t is in [0, alpha]' 1e-15 want found
feed "$atph" planar --convert=bezier --tolerance=1e-4 -n 2
segments=$(json get segments out | grep -o interval | wc -l | tr -d ' ')
samples=$(json get samples out | grep -o '"t"' | wc -l | tr -d ' ')
true_that 'converted: there are more segments' [ "$segments" -gt 3 ]
equal 'converted: samples are those of the segments that are written' \
  "$((3 * segments))" "$samples"
equal 'converted: t is in [0,1]' '0 0.5 1' \
  "$(get 'samples[0].t') $(get 'samples[1].t') $(get 'samples[2].t')"

# ---- usage -------------------------------------------------------------------

# refused VALUE: a number of samples that is none
refused() {
  run planar --sample="$1" /dev/null
  expect "--sample=$1" 2 "phspline: --sample must be a whole number from 1 to \
1000000, found '$1'
Try 'phspline planar --help'."
}
refused 0
refused -1
refused 1.5
refused 1000001
refused many
refused nan
refused ''
run planar -f csv --table=samples /dev/null
expect '--table=samples alone' 2 "phspline: --table=samples needs --sample
Try 'phspline planar --help'."
