# SPDX-License-Identifier: GPL-3.0-or-later
#
# --sample: samples in records and in the table `samples', of each command and
# kind of curve.  (Of a sphere see also sphere-csv.t, sphere.t.)
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

# ---- each kind of curve ------------------------------------------------------

# Rows of the table: N + 1 for each segment, t from 0 to the end of the local
# parameter in equal steps, tangents of length 1, s that grows by no less than
# the chord, up to the length; in the middle of 33 samples a chord is along the
# tangent.
cat >table.awk <<'EOF'
function bad(what) {
  print "line " NR ": " what
  failed = 1
}
BEGIN { FS = ","; segment = -1 }
NR == 1 {
  at = $7 == "z" ? 3 : 2
  wanted = "id,segment,t,s," (at == 3 ? "x,y,z,tx,ty,tz,curvature" : \
    "x,y,tx,ty,curvature")
  if (substr($0, 1, length(wanted)) != wanted) bad("columns " $0)
  next
}
{
  size = chord = along = 0
  for (i = 1; i <= at; i++) {
    p[i] = $(4 + i)
    v[i] = $(4 + at + i)
    size += v[i]^2
    chord += (p[i] - p0[i])^2
    along += (p[i] - p0[i]) * (v[i] + v0[i])
  }
  chord = sqrt(chord)
  if (!((size - 1)^2 < 1e-28)) bad("a tangent of the size " sqrt(size))
  if ($2 != segment) {
    if ($2 != segment + 1) bad("segment " $2)
    if (segment >= 0 && rows != n + 1) bad(rows " samples")
    if ($3 != 0) bad("t = " $3)
    if (NR > 2 && !(chord < 1e-12 * scale)) bad("a gap of " chord)
    if (NR > 2 && !(($4 - s)^2 <= (1e-13 * s)^2)) bad("s goes on at " $4)
    if (NR == 2 && $4 != 0) bad("s begins at " $4)
    rows = 0
  } else {
    if (!($4 - s >= chord * (1 - slack))) bad("s grows by too little")
    if (!($4 - s <= chord * 1.05)) bad("s grows by too much")
    if (rows > 1 && !(($3 - t - step)^2 <= (1e-13 * step)^2)) bad("t = " $3)
    if (!(along > 1.9 * chord)) bad("a tangent that is not along the curve")
    step = $3 - t
  }
  rows++
  segment = $2
  t = $3
  s = $4
  for (i = 1; i <= at; i++) { p0[i] = p[i]; v0[i] = v[i] }
}
END {
  if (segment + 1 != segments) bad("there are " segments " segments")
  if (rows != n + 1) bad(rows " samples")
  if (!((s / scale - 1)^2 < 1e-26)) bad("s ends at " s ", the length is " scale)
  exit failed
}
EOF

# kind TITLE COMMAND MEMBERS [ARGUMENT...]: Bezier pieces that are converted have
# the lengths of the curve that they stand for
kind() {
  title=$1 command=$2 members=$3
  case $title in *converted*) slack=1e-6 ;; *) slack=1e-11 ;; esac
  shift 3
  feed "{$members}" "$command" -q -n 32 -f csv --table=samples "$@"
  mv out table.csv
  feed "{$members}" "$command" -q -n 32 "$@"
  expect "$title" 0
  true_that "$title: the table" awk -v n=32 -v scale="$(get length)" \
    -v segments="$(get segments | grep -o interval | wc -l)" -v slack=$slack \
    -f table.awk table.csv
  # the record has the same: the numbers of a row, without those left empty
  printf '%s\n' "$(get samples)" |
    sed 's/"lonlat":\[[^]]*\]//g; s/"[a-z]*"://g' | tr -d '{}[]' |
    tr ',' '\n' | sed '/^$/d' >found
  sed 1d table.csv | cut -d, -f2- | case $command in
  sphere) cut -d, -f-10 ;;
  *) cat ;;
  esac | tr ',' '\n' | sed '/^$/d' >want
  equal_files "$title: the record" want found
}

for more in '' ',"basis":"atph"' ',"knots":"uniform"'; do
  kind "planar $more" planar "$bend$more"
  kind "planar, closed $more" planar "$bend,\"closed\":true$more"
done
kind 'planar, converted' planar "$bend,\"basis\":\"atph\"" --convert=bezier \
  --tolerance=1e-4
for more in '' ',"criterion":"F1"' ',"basis":"atph"' ',"closed":true'; do
  kind "spatial-hermite $more" spatial-hermite "$space$more"
done
kind 'spatial-hermite, converted' spatial-hermite \
  "$space,\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"cc\"" \
  --convert=bezier --tolerance=1e-4
kind 'arclength' arclength "$space,\"lengths\":[1.6,2,1.5]"
kind 'arclength, no lengths' arclength "$space"
kind 'arclength, closed' arclength "$space,\"closed\":true"
kind 'arclength, tangents' arclength \
  '"tangents":[[1,0,0],[1,1,0],[0,1,1]],"lengths":[1,2]'
globe='"lonlat":[[0,0],[10,20],[40,30],[60,-10]]'
for more in '' ',"model":"nielson"' ',"radius":6371,"center":[1,2,3]' \
  ',"closed":true' ',"tension":10' \
  ',"ends":"clamped","end_tangents":[[0,1,0],[0,0,-1]]'; do
  kind "sphere $more" sphere "$globe$more"
done
feed "{$globe}" sphere -q -n 1000 -f csv --table=samples
true_that 'a thousand' count 3004 out

# ---- the range of numbers ----------------------------------------------------

# beyond FIELDS COMMAND OPTION...: what leaves it is an error of the record
beyond() {
  echo "{$1}" >large
  shift
  run "$@" -q large
  equal "$*: beyond all numbers" '"too-large" 1' \
    "$(jq -c .error.code out) $status"
}
beyond '"points":[[-1.0069819426159631e307,-2.0559759185366998e307,
3.8674383232589423e307],[-5.237629767870573e306,
2.8333915574588896e307,3.449013398181751e307],
[-1.579629048381602e306,-4.4425841557844076e307,
6.607741929266089e306],[2.4966177779559395e307,
-3.696507602008644e307,-5.485070771248388e306]],
"radius":4.49423283715579e307' \
  sphere --offset=-8.98846567431158e307
beyond '"points":[[3.346043993639933e307,-3.0392813030545504e307,
3.020034532648201e307],[5.016436350001588e306,
-1.4734268817623691e307,-3.618851253281071e306],
[4.214169361739256e307,-1.0875364933198755e307,
2.349554140605438e307]],"lengths":[6.878067472613971e307,
6.41519841527871e307],"refine":2' \
  arclength --offset=1.348269851146737e307 --sample=3

# lengths of parts are in range where sums of squares are not
echo '{"points":[[0,7e306,-2.7e307],[-8.8e307,1.5e307,6.4e307]],
"basis":"atph","alpha":1}' >large
run spatial-hermite -q --convert=bezier --tolerance=1e305 large
expect 'a length near the largest number' 0
mv out made
run verify -q --problems=large made
expect 'a length near the largest number, verified' 0

# curvatures that are none, as a circle that small has
echo '{"points":[[0,0],[1e-313,2e-313],[3e-313,0]]}' >small
for command in planar tc; do
  run "$command" -q --sample=4 small
  mv out made
  run verify -q --problems=small made
  expect "$command: curvatures beyond all numbers, verified" 0
done

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
expect '--table=samples alone' 2 "phspline: --table=samples needs --sample, --spacing, --chord-error or --at
Try 'phspline planar --help'."

# ---- at given lengths -----------------------------------------------------------

feed "{$bend}" planar --at=2,-0.5,0,1e0,2
expect 'at lengths' 0
all=$(get length)
equal 'at lengths: these, in order, each once' '[0,1,2] true' \
  "$(jq -c '[.samples[:3][].s]' out) $(jq '.length - .samples[3].s == 0.5' out)"
cp out at.json
true_that 'at lengths: verify' "$PHSPLINE" verify --tolerance=1e-12 at.json
"$PHSPLINE" planar --spacing=1 in | jq -c '.samples[:3]' >spaced
jq -c '.samples[:3]' at.json >lengths
equal_files 'at lengths: as at the same spacing' spaced lengths
feed "{$bend,\"at\":-1}" planar --offset=0.2,-0.2 -q --sample=1
expect 'two ways' 1 'phspline: -:1: record 1: at: is one way to take samples, and --sample, --spacing and --chord-error are others [bad-value]'
feed "{$bend,\"at\":-1}" planar --offset=0.2,-0.2
equal 'offsets beside the places of the curve' 'true' "$(jq '
  [.samples[0], .offsets[].samples[0]] | map([.segment, .t]) | unique | length == 1' out)"
equal 'offsets at the distance' '0.2 0.2' "$(jq -r '.samples[0].point as [$x, $y] |
  .offsets[].samples[0].point | (.[0] - $x) as $u | (.[1] - $y) as $v |
  $u * $u + $v * $v | sqrt | . * 1e12 | round / 1e12' out | tr '\n' ' ' |
  sed 's/ $//')"
true_that 'offsets: verify' "$PHSPLINE" verify --tolerance=1e-12 out
feed "{$bend}" planar -q --at=1,-100
expect 'beyond the end' 1 "phspline: -:1: record 1: at[1]: must be within the \
length of the curve, which is $all, or the same from its end, found -100 \
[bad-value]"
feed "{$bend}" planar -q --at=1 --offset=1 --offset-mode=trimmed
expect 'of loops' 1 'phspline: -:1: record 1: at: is of the curve and its raw offsets: loops begin anywhere [bad-value]'
feed "{$bend}" planar --at="0,$all" --table=samples
equal 'both ends' '0 0 1' "$(awk -F, 'NR > 1 { print $3 } NR == 2 { print $4 }' out |
  sort -n | tr '\n' ' ' | sed 's/ $//')"
feed '{"lonlat":[[0,0],[40,10],[80,-20]],"radius":6371}' sphere --at=1000,-1000 \
  --frame=rmf
equal 'on a sphere' 'true' "$(jq '.length as $l | [.samples[].s] | map(. * 1e6 |
  round) == [1e9, (($l - 1000) * 1e6 | round)]' out)"
true_that 'on a sphere: verify' "$PHSPLINE" verify out

# ---- the area --------------------------------------------------------------------

# area NAME WANTED COMMAND PROBLEM ARGUMENT...
area() {
  name=$1
  wanted=$2
  command=$3
  printf '%s\n' "$4" >in
  shift 4
  "$PHSPLINE" "$command" -q "$@" in >out
  equal "$name" "$wanted" "$(jq -c '.area | if . then . * 1e6 | round / 1e6 else . end' out)"
  true_that "$name: verify" "$PHSPLINE" verify --tolerance=1e-13 out
}

ring='"points":[[3,0],[0,3],[-3,0],[0,-3]],"closed":true'
area 'inside of a curve' 28.124198 planar "{$ring}"
area 'the other way' -28.124198 planar \
  '{"points":[[0,-3],[-3,0],[0,3],[3,0]],"closed":true}'
area 'far from the origin' 28.124198 planar \
  '{"points":[[1000003,0],[1000000,3],[999997,0],[1000000,-3]],"closed":true}'
area 'of an open curve' null planar "{$bend}"
area 'of a circle' "$(awk 'BEGIN { printf "%.6f", 9 * atan2(0, -1) }')" planar \
  "{$ring,\"basis\":\"atph\",\"alpha\":0.7853981633974483}"
area 'of trigonometric curves as Bezier curves' 28.274334 planar \
  "{$ring,\"basis\":\"atph\",\"alpha\":0.7853981633974483}" --convert=bezier
area 'of a polygon' 8 tc \
  '{"closed":true,"tolerance":0.01,"curve":[[[0,0],[4,0]],[[4,0],[4,2]],[[4,2],[0,2]],[[0,2],[0,0]]]}'

# ---- a long curve --------------------------------------------------------------

# Its segments are walked along in parts: every multiple of the spacing is there
# once, in the segment that has it, and so are given lengths.
walk 4 2000 >long.csv
run planar -q -f csv --table=samples -n 1 long.csv
mv out joints
for rule in --spacing=0.37 "--at=$(awk 'BEGIN {
  for (i = 0; i < 3000; i++) printf "%s%.2f", i ? "," : "", i * 0.37
}')"; do
  run planar -q -f csv --table=samples "$rule" long.csv
  name=${rule%%=*}
  equal "a long curve, $name: the samples that are wrong" '' "$(awk -F, '
    FNR == 1 { next }
    NR == FNR { high[$2] = $4; low[$2] = low[$2] == "" ? $4 : low[$2]; next }
    { n++; last = $4; good = (last - 0.37 * (n - 1)) ^ 2 < 1e-24 * n * n }
    !good { off = off " " n }
    $4 < low[$2] - 1e-9 || $4 > high[$2] + 1e-9 { print n }
    END {
      if (off != "" && off != " " n) print off
      if (n < 3000) print n " samples"
    }' joints out)"
done
equal 'a long curve: the last sample is its end' "$(tail -n 1 joints | cut -d, -f4)" \
  "$(run planar -q -f csv --table=samples --spacing=0.37 long.csv &&
    tail -n 1 out | cut -d, -f4)"
