# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cone' with method=atph: section 4.4.2 of [GON18] as an independent program has
# found it, simple truths about general cones, and what can be wrong.
#
# A problem of tests/vectors/cone-atph.jsonl brings in `meta' what its strips
# are, or the most that the functional of each of them may be.
#
# shellcheck disable=SC2016,SC2154  # programs of jq and awk; what errors.sh sets
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

verified() {
  run verify --problems=problem.json result.json
  equal "$1: verified" '0 "ok"' "$status $(get status)"
}

# ---- as published --------------------------------------------------------------

sed -n 1p "$srcdir/tests/vectors/cone-atph.jsonl" >problem.json
run cone -q problem.json
expect 'given angles' 0
cp out result.json
jq -c '.meta | .contact, (.strips[] | [.control_points, .length, .F1, .F2,
  .development_angle])' problem.json >known
jq -c '.strips[1].control_points[0], (.strips[] | [.control_points, .length, .F1,
  .F2, .development_angle])' result.json >found
numbers 'given angles: control points, lengths, F1, F2, angles' 1e-8 known found
jq -c '.meta.strips[] | .F3' problem.json >known
jq -c '.strips[] | .F3' result.json >found
numbers 'given angles: F3' 1e-6 known found
verified 'given angles'
for line in 2 3 4; do
  sed -n "${line}p" "$srcdir/tests/vectors/cone-atph.jsonl" >problem.json
  run cone -q problem.json
  cp out result.json
  name=$(json get criterion problem.json | tr -d '"')
  true_that "table 4.4, $name: no more than was found before" jq -e -s \
    --arg f "$name" '.[0].meta.most as $most | [.[1].strips[][$f]] |
      .[0] <= $most[0] and .[1] <= $most[1]' problem.json result.json
  true_that "table 4.4, $name: alpha is at its bound" \
    jq -e '.diagnostics.at_bound' result.json
  verified "table 4.4, $name"
done

# ---- records -------------------------------------------------------------------

points='"points":[[252.6524,62,92.5],[266.5158,65.1388,91.5]]'
rulings='"rulings":[[-0.1151,0.2405,0.9638],[-0.1785,0.165,0.97]]'
tangents='"tangents":[[0.9925,0.069,0.1013],[0.8847,0.4583,0.0849]]'
elements="$points,$rulings,$tangents"
good="{$elements,\"method\":\"atph\",\"apexes\":[-30,70]}"
printf '%s\n' "$good" >problem.json

run cone problem.json
expect 'a record' 0
equal 'a record: a strip' '{pair:number,method:string,frame:{point:[number],'\
'ruling:[number],tangent:[number],normal:[number]},alpha:number,angles:[number],'\
'control_points:[[number]],preimage:[[number]],length:number,vertex:[number],'\
'development_angle:number,turn:number,F1:number,F2:number,F3:number,'\
'shift:[number],development:{samples:[{t:number,point:[number]}],angle:number}}' \
  "$(jq -c '.strips[0]' out | json shape)"
equal 'a record: pairs, bends' 'absent 1' \
  "$(get pairs) $(get diagnostics.inflections)"
true_that 'a record: no worse than its certificate' jq -e '.diagnostics |
  .frame_error < 1e-12 and .isometry_error < 1e-13 and .tangent_error < 1e-12' out
true_that 'the defaults have the contact point nearest to the middle' jq -e '
  def dot(a; b): a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  def minus(a; b): [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  .strips as [$a, $b] |
  dot(minus([259.5841, 63.5694, 92]; $b.frame.point);
    minus($b.vertex; $a.vertex)) | fabs < 1e-9' out
run cone -q --tolerance=1e-2 problem.json
true_that 'a tolerance of the flat pattern: fewer samples, chords within' jq -e '
  [.strips[].development.samples | length] | .[0] < 20 and .[1] < 20' out
run cone -q --table=development problem.json
true_that 'the development as a table: samples have no weights' awk -F, '
  NR > 1 && NF != 6 { exit bad = 1 }
  NR > 1 && $6 != "" { exit bad = 1 }
  END { exit bad || NR < 50 }' out

run cone -q --height='[-5,5]' --sample=8x2 problem.json
expect 'samples' 0
cp out result.json
verified 'samples'
true_that 'flat samples are as far from one another along a ruling' jq -e '
  def apart: map(. * .) | add | sqrt;
  .samples as $s | all(range(0; 54; 3); . as $i |
    [$s[$i].flat, $s[$i + 2].flat] | [.[0][0] - .[1][0], .[0][1] - .[1][1]] |
    apart - 10 | fabs < 1e-11)' result.json
true_that 'samples of both strips meet' jq -e '
  .samples as $s | all(range(0; 3); . as $i | $s[24 + $i].flat as $a |
    $s[27 + $i].flat as $b | ($a[0] - $b[0] | fabs < 1e-11) and
    ($a[1] - $b[1] | fabs < 1e-11))' result.json
run cone -q --height='[-5,5]' --format=obj --sample=4x2 problem.json
equal 'a mesh' '27 16' "$(grep -c '^v ' out) $(grep -c '^f ' out)"
run cone -q --height='[-5,5]' --format=svg-path problem.json
true_that 'a flat pattern: an outline and one ruling' \
  awk '{ exit gsub(/M/, "") != 2 }' out

# A flat pattern of an area is as large as that.
run cone -q --height='[-5,5]' --sample=400x1 problem.json
true_that 'the area is that of the flat pattern' jq -e '
  def cross(a; b; c): (b[0] - a[0]) * (c[1] - a[1]) -
    (b[1] - a[1]) * (c[0] - a[0]) | fabs;
  .samples as $s | .area as $area | [range(0; 1602; 2) | select(. != 800) |
    . as $i | (cross($s[$i].flat; $s[$i + 1].flat; $s[$i + 2].flat) +
      cross($s[$i + 1].flat; $s[$i + 3].flat; $s[$i + 2].flat)) / 2] | add |
  . / $area - 1 | fabs < 1e-5' out

# Points of the flat pattern, on both sides of the vertex and all around it.
# located NAME HEIGHT: samples are found again by their place in the pattern
located() {
  run cone -q --height="$2" --sample=16x3 problem.json
  jq -c '{flat: [.samples[].flat]}' out >flat.json
  jq -c '[.samples[]]' out >samples.json
  jq -cs '.[0] + .[1]' problem.json flat.json >located.json
  run cone -q --height="$2" located.json
  expect "located: $1" 0
  cp out result.json
  true_that "located: $1: all, where they were" jq -es '.[0] as $p |
    .[1].located as $l | ($p | length) == ($l | length) and
    all(range($p | length); . as $i | $l[$i].index == $i and
      ($l[$i].strip < $p[$i].strip or # the pattern covers itself
      (all(range(3); $p[$i].point[.] - $l[$i].point[.] | fabs < 1e-11) and
      ($p[$i].s - $l[$i].s | fabs < 1e-11))))' \
    samples.json result.json
  run verify --problems=located.json result.json
  equal "located: $1: verified" '0 "ok"' "$status $(get status)"
}
located 'a strip' '[-5,5]'
located 'beyond the vertex' '[-60,-35]'
run cone --height='[-5,5]' --flat='[[0,0],[99,9],[3,6]]' problem.json
expect 'located: a point beside the pattern' 0 "phspline: problem.json:1: record 1: \
warning: 2 of 3 points are outside of the flat pattern, the first is flat[1] \
[outside]"
jq -c '.located[0].s = 0.1' result.json >wrong.json
run verify -q --problems=located.json wrong.json
equal 'located: another place is refused' 1 "$status"
jq -c '.located[7].h = 7' result.json >wrong.json
run verify -q --problems=located.json wrong.json
equal 'located: a place beside the height is refused' 1 "$status"

# ---- parallel surfaces -----------------------------------------------------------

run cone -q --height='[-5,5]' --offset=0.9,-1 --sample=64x2 problem.json
expect 'offsets' 0
cp out result.json
equal 'offsets: a strip' '{pair:number,method:string,frame:{point:[number],'\
'ruling:[number],tangent:[number],normal:[number]},alpha:number,length:number,'\
'vertex:null,development_angle:number,turn:number,shift:[number],'\
'development:{samples:[{t:number,point:[number]}],angle:number}}' \
  "$(jq -c '.offsets[0].strips[0]' out | json shape)"
verified 'offsets'
true_that 'offsets: the same rulings, at the distance along the normals' jq -e '
  .samples as $s | all(.offsets[]; .distance as $d | .samples as $o |
    all(range($s | length); . as $i | all(range(3); . as $j |
      ($s[$i].point[$j] + $d * $s[$i].normal[$j] - $o[$i].point[$j] | fabs < 1e-12)
      and ($s[$i].normal[$j] - $o[$i].normal[$j] | fabs < 1e-14))))' result.json
# Diagonals of narrow faces, whose lengths in space and in the plane differ by
# less than the square of the turn on the way.
true_that 'offsets: their flat patterns are isometric' jq -e '
  def apart(a; b): [a, b] | transpose | map(.[0] - .[1] | . * .) | add | sqrt;
  all(.offsets[]; .samples as $o | all(range(0; 192; 3) | ., . + 195; . as $i |
    (apart($o[$i].point; $o[$i + 5].point) / apart($o[$i].flat; $o[$i + 5].flat) -
      1 | fabs < 1e-5) and
    (apart($o[$i + 2].point; $o[$i + 3].point) /
      apart($o[$i + 2].flat; $o[$i + 3].flat) - 1 | fabs < 1e-5)))' result.json
true_that 'offsets: their lengths are those of the samples' jq -e '
  all(.offsets[]; .samples[194].s - .strips[0].length | fabs < 1e-12)' result.json
# Steiner: the mean of the areas on both sides is that of the cone.
run cone -q --height='[-5,5]' --offset=-1,1 problem.json
true_that 'offsets: areas' jq -e \
  '([.offsets[].area] | add) / .area / 2 - 1 | fabs < 1e-11' out
run cone -q --height='[-5,5]' --offset=0.5 --sample=4x2 --format=obj problem.json
equal 'offsets: meshes' '54 32 2' "$(grep -c '^v ' out) $(grep -c '^f ' out) \
$(grep -c '^o ' out)"
run cone -q --height='[-5,5]' --offset=0.5 --format=svg-path problem.json
true_that 'offsets: flat patterns' awk '{ exit gsub(/M/, "") != 4 }' out
run cone -q --offset=0.5 --table=development problem.json
true_that 'offsets: a table' awk -F, 'NR > 1 && $NF == 0.5 { n++ }
  END { exit n < 50 }' out

run cone -q --height='[-5,5]' --offset=0.9,-1 --sample=8x2 problem.json
cp out result.json
# tampered NAME PROGRAM: what a program of jq makes of the record is refused
tampered() {
  jq -c "$2" result.json >wrong.json
  run verify -q --problems=problem.json wrong.json
  equal "tampered: $1" 1 "$status"
}
tampered 'length of an offset' '.offsets[0].length *= 1.000001'
tampered 'area of an offset' '.offsets[1].area *= 1.000001'
tampered 'distance' '.offsets[0].distance = 0.9001'
tampered 'length of a strip' '.offsets[0].strips[1].length += 1e-6'
tampered 'alpha' '.offsets[0].strips[1].alpha += 1e-6'
tampered 'frame' '.offsets[0].strips[0].frame.point[2] += 1e-6'
tampered 'normal' '.offsets[0].strips[0].frame.normal[2] += 1e-6'
tampered 'angle' '.offsets[1].strips[0].development_angle += 1e-7'
tampered 'turn' '.offsets[1].strips[0].turn += 1e-7'
tampered 'development' '.offsets[1].strips[1].development.samples[9].point[0] += 1e-6'
tampered 'order' '.offsets[1].strips[1].development.samples[9].t = 0'
tampered 'joint' '.offsets[1].strips[1].development.angle += 1e-7'
tampered 'point of a sample' '.offsets[1].samples[7].point[1] += 1e-6'
tampered 'place of a sample' '.offsets[1].samples[40].s += 1e-6'
tampered 'normal of a sample' '.offsets[1].samples[40].normal[0] += 1e-6'
tampered 'flat sample' '.offsets[0].samples[40].flat[0] += 1e-6'
tampered 'strip of a sample' '.offsets[0].samples[40].strip = 0'
tampered 'pair of a strip' '.offsets[0].strips[0].pair = 1'
tampered 'a strip less' '.offsets[0].strips |= .[:1]'

for unit in 1e-9 1e9; do
  jq -c ".points |= map(map(. * $unit)) | .apexes |= map(. * $unit)" problem.json \
    >scaled.json
  run cone -q --offset="$(awk "BEGIN { print 0.9 * $unit }")" scaled.json
  cp out scaled.out
  true_that "offsets in the unit $unit" jq -e --argjson unit "$unit" -s '
    .[0].offsets[0].length / .[1].offsets[0].length * $unit - 1 | fabs < 1e-9' \
    result.json scaled.out
  "$PHSPLINE" verify -q --problems=scaled.json scaled.out >verdict
  equal "offsets in the unit $unit: verified" '"ok"' "$(json get status verdict)"
done

# ---- moved by a vector -------------------------------------------------------------

run cone -q --height='[-5,5]' --translate='[1,-2,3]' problem.json
expect 'translate' 0
cp out moved.out
run cone -q --height='[-5,5]' problem.json
true_that 'translate: the strips are moved' jq -es '. as [$a, $b] |
  all(range(2); . as $i | [$a, $b] | map(.strips[$i].frame.point) | transpose |
    map(.[1] - .[0]) | (.[0] - 1 | fabs < 1e-9) and (.[1] + 2 | fabs < 1e-9) and
    (.[2] - 3 | fabs < 1e-9))' out moved.out
true_that 'translate: the flat pattern stays' jq -es '. as [$a, $b] |
  ($a.area / $b.area - 1 | fabs < 1e-9) and ($a.strips[1].development.angle -
    $b.strips[1].development.angle | fabs < 1e-9)' out moved.out
run verify -q --problems=problem.json moved.out
equal 'translate: verified' '0 "ok"' "$status $(get status)"
jq -c '.set.translate = [1, -2, 3.001]' moved.out >wrong.json
run verify -q --problems=problem.json wrong.json
equal 'translate: by another vector' 1 "$status"

# ---- the same data, moved --------------------------------------------------------

# same NAME FACTOR PROGRAM: the problem changed by a program of jq has the same
# numbers, and their unit the factor
same() {
  jq -c "$3" problem.json >moved.json
  run cone -q --height='[-5,5]' moved.json
  expect "$1" 0
  true_that "$1: the same surface" jq -e --argjson unit "$2" -s '
    def near(a; e): . / a - 1 | fabs < e;
    .[0] as $a | .[1] as $b | ($b.diagnostics.F1 | near($a.diagnostics.F1; 1e-12))
    and ($b.length / $unit | near($a.length; 1e-8)) and
    ([$b.strips[].turn] | add | near([$a.strips[].turn] | add; 1e-6))' \
    base.json out
  cp out result.json
  "$PHSPLINE" verify -q --set='height=[-5,5]' --problems=moved.json result.json \
    >verdict
  equal "$1: verified" '"ok"' "$(json get status verdict)"
}
run cone -q --height='[-5,5]' problem.json
cp out base.json
same 'turned' 1 '(.points, .rulings, .tangents) |= map([0.6 * .[0] - 0.8 * .[2],
  .[1], 0.8 * .[0] + 0.6 * .[2]])'
same 'backward' 1 '(.points, .rulings, .apexes) |= reverse |
  .tangents |= (reverse | map(map(-.)))'
same 'with rulings to the other side' 1 '.rulings |= map(map(-.)) |
  .apexes |= map(-.)'
for unit in 1e-9 1e9 1e-100 1e100; do
  same "in the unit $unit" "$unit" \
    ".points |= map(map(. * $unit)) | .apexes |= map(. * $unit)"
done

# ---- a row of elements -----------------------------------------------------------

# Elements of the cone about z whose vertex is at (0,0,8/3), all around.
awk 'BEGIN {
  for (k = 0; k < 8; k++) {
    t = k * atan2(1, 1)
    p = p sprintf(",[%.17g,%.17g,0]", 2 * cos(t), 2 * sin(t))
    r = r sprintf(",[%.17g,%.17g,0.8]", -0.6 * cos(t), -0.6 * sin(t))
    d = d sprintf(",[%.17g,%.17g,0]", -sin(t), cos(t))
    a = a (k % 2 ? ",2" : ",-3")
  }
  printf "{\"points\":[%s],\"rulings\":[%s],\"tangents\":[%s],", substr(p, 2),
    substr(r, 2), substr(d, 2)
  printf "\"apexes\":[%s],\"closed\":true,\"method\":\"atph\"}\n", substr(a, 2)
}' >problem.json
run cone -q --height='[-1,1]' problem.json
expect 'a closed row' 0
cp out result.json
true_that 'a closed row: strips' jq -e '.closed and (.strips | length) == 16 and
  .strips[15].pair == 7 and .diagnostics.frame_error < 1e-11' result.json
run verify -q --set='height=[-1,1]' --problems=problem.json result.json
equal 'a closed row: verified' '0 "ok"' "$status $(get status)"
run cone -q --format=obj --sample=2x1 --height='[-1,1]' problem.json
equal 'a closed row: a mesh that is closed' '64 32' \
  "$(grep -c '^v ' out) $(grep -c '^f ' out)"

# ---- what is wrong -------------------------------------------------------------

errors_of cone
bad missing-field apexes 'is missing: "method":"atph" has its vertices there' \
  "{$elements,\"method\":\"atph\"}"
bad bad-value apexes 'is of "method":"atph"' "{$elements,\"apexes\":[1,2]}"
bad bad-value lambda 'is of "method":"circular"' \
  "{$elements,\"method\":\"atph\",\"apexes\":[-30,70],\"lambda\":1}"
bad bad-shape apexes 'must have 2 numbers, one for each point, found 1' \
  "{$elements,\"method\":\"atph\",\"apexes\":[-30]}"
bad bad-value 'apexes[1]' 'must not be 0: a vertex is away from its point' \
  "{$elements,\"method\":\"atph\",\"apexes\":[-30,0]}"
bad bad-value contact_point 'must be from 0, the first vertex, to 1, the '\
'second, found 2' "{$elements,\"method\":\"atph\",\"apexes\":[-30,70],\
\"contact_point\":2}"
bad infeasible 'pairs[0]' 'has its contact point on the wrong side of a vertex: '\
'apexes on opposite sides of their rulings have it between them, others beyond '\
'both; look at apexes and contact_point' \
  "{$elements,\"method\":\"atph\",\"apexes\":[-30,-70],\
\"contact_point\":\"midpoint\"}"
bad infeasible 'pairs[0]' 'has no common ruling: both vertices are the same '\
'point' '{"points":[[1,0,0],[0,1,0]],"rulings":[[1,0,0],[0,1,0]],'\
'"tangents":[[0,1,0],[-1,0,0]],"method":"atph","apexes":[-1,-1]}'
bad missing-field alpha 'is missing: only the criteria F1, F2 and F3 choose it' \
  "{$elements,\"method\":\"atph\",\"apexes\":[-30,70],\"angles\":[0,0]}"
bad no-convergence 'strips[0]' 'is a loop: its spherical image turns by 6.08 to '\
'one side, at most pi is allowed; other apexes, "contact_point":"nearest", or '\
'another criterion may have none' "{$elements,\"method\":\"atph\",\
\"apexes\":[-30,70],\"contact_point\":\"midpoint\"}"
# refused NAME MESSAGE HEIGHT DISTANCE
refused() {
  printf '%s\n' "$good" >a.json
  run cone -q --height="$3" --offset="$4" a.json
  equal "$1" "1 phspline: a.json:1: record 1: strips[0]: has no parallel \
surface$2 [infeasible]" "$status $(cat err)"
}
refused 'a distance beyond the curvature' ' at the distance 2: the least radius of '\
'normal curvature within the height is 1.30096' '[0,0]' 2
refused 'the other side' ' at the distance -2: the least radius of '\
'normal curvature within the height is -1.59565' '[0,0]' -2
refused 'a vertex within the height' ': its vertex is within the height' '[-40,0]' 1
bad bad-shape translate 'must have 3 numbers, found 2' \
  "{$elements,\"translate\":[1,2]}"
bad too-large translate 'moves points[0] beyond all numbers' \
  '{"points":[[1e308,0,0],[0,1,0]],"rulings":[[1,0,0],[0,1,0]],'\
'"tangents":[[0,1,0],[-1,0,0]],"translate":[1e308,0,0]}'

# ---- any data -----------------------------------------------------------------

accepted cone 'a turn that changes its side in the middle' <<'EOF'
{"points":[[-820,0,0],[-815,680,0],[-813,700,0],[0,0,0]],"alpha":[1,3,1,3,1,2],
"tangents":[[0.92,0.384,0.068],[0.92,0.384,0.068],[0.92,0.384,0.068],
[0.92,0.384,0.068]],"rulings":[[-0.119,0.44,-0.889],[-0.119,0.44,-0.889],
[-0.119,0.44,-0.889],[-0.119,0.44,-0.889]],"method":"atph",
"apexes":[-14.526096890707336,77.2,-61.80885168954214,35.200412600879886]}
EOF
accepted cone 'a vertex within a small height' <<'EOF'
{"points":[[-1680,1300,-2300],[-1680,1320,-2296],[-1700,0,-2300]],
"alpha":0.16,"tangents":[[-0.844,0.002,0.536],[-0.73,-0.5822,-0.3637],
[-0.724,0.153,0.673]],"angles":[[2.8620682893712854,1.3525673291235512],
[-2.470195939500815,0.8839178013398914],[-0.0628601352970164,1.825190010187036],
[0.08044016389857367,-0.9138851117820619]],"rulings":[[0.343,-0.767,0.542],
[0.3427,-0.77,0.542],[0.343,-0.767,0.542]],"method":"atph",
"height":[22.6,22.7],"apexes":[25,-30,3.66]}
EOF
equal 'a vertex within a small height: the area, by 40 nodes on parts of it' \
  true "$(jq '(.area / 26.838518848643858 - 1 | fabs) < 1e-12' any.result)"
accepted cone 'derivatives of a ten millionth' --sample=3 <<'EOF'
{"points":[[0,0,0],[30000000,0,0]],"alpha":0.4,"method":"atph",
"tangents":[[0.28,0.044,0.96],[0.79,0.39,0.47]],"tangent_scale":"unit",
"rulings":[[0.49,-0.87,-0.103],[0.49,-0.87,-0.1]],"apexes":[500000000,30000000]}
EOF
accepted cone 'a surface at no distance, finely laid flat' --offset=0 <<'EOF'
{"points":[[-4e-10,-9e-10,-1e-9],[0,2e-9,0]],"method":"atph",
"tangents":[[0.9,-0.213,-0.386],[0.9215699185690206,-0.17664424621956765,
-0.3456959581282512]],"rulings":[[0.09181261136792399,-0.7660471005648491,
0.6361935901201697],[0.09181261053210794,-0.7660471006891454,
0.6361935900911246]],"apexes":[1.2096606163496192e-10,1.1662306763706864e-8]}
EOF
# Near its ends the directrix is so slow that its direction turns within some
# millionths of the parameter; the control points say it to 1e-5 only.
accepted cone 'beside a directrix that nearly rests at its ends' \
  --offset=-17040.946410854278 <<'EOF'
{"points":[[3483674.450565,-6658033.8404,8849136.93092],[-2428661.8993151393,
-4770554.9990336,6407706.432303881]],"tangents":[[0.04027587394405844,
0.9983808807196544,0.040168034448917395],[-0.007830857274692241,
0.9997697562240729,0.01997779302129105]],"rulings":[[-0.9210179624674382,
0.05268259422695172,-0.38594100206877113],[-0.9218649092377756,
0.0005227434291179001,-0.3875110525589368]],"method":"atph","apexes":[
-330455.63,8181694.180335608],"tangent_scale":"unit"}
EOF
equal 'beside it: the length, by 40 digits from the preimage' true \
  "$(jq '(.offsets[0].strips[1].length / 3451179.531775020912 - 1 | fabs) <
    1e-14' any.result)"
jq -c '.offsets[0].strips[1].length *= 1.000001 |
  .offsets[0].length = ([.offsets[0].strips[].length] | add)' any.result >bad
run verify -q bad
equal 'beside it: another length' '1 "offsets[0].strips[1].length"' \
  "$status $(get error.field)"
accepted cone 'beside a directrix that turns quickly' \
  --offset=0.000029324154325175654 <<'EOF'
{"points":[[-1.3813968334547608,0.15202193633659497,0.2546480737734146],[
-1.9942894177463755,-0.5675742588545256,0.6758903820439679]],"tangents":[[
-0.780365547280088,-0.5132792045506837,0.35717512622531056],[
-0.36207937228912906,-0.8280635338145097,0.4280295692231279]],"rulings":[[
0.607241401923563,-0.7583835232467533,0.2368803737284858],[0.9201146861965391,
-0.39103950455544445,0.021841934952680525]],"method":"atph","apexes":[-2.31,
6.083829027547787]}
EOF
# Angles of rulings are relative to themselves, however far the vertices are.
accepted cone 'vertices a million million times as far as the points' <<'EOF'
{"points":[[0,0,0],[3000,333.33333333333331,0]],"alpha":0.4,"method":"atph",
"tangents":[[0.28,0.96,0],[0.8,0.6,0]],"tangent_scale":"unit",
"rulings":[[0,0,1],[0,0,1]],"apexes":[-3e15,-6e15]}
EOF
jq -c '.strips[0].development_angle *= 1.00000001' any.result >bad
run verify -q bad
equal 'an angle of 1e-12 that is off by 1e-8 of it' \
  '1 "strips[0].development_angle"' "$status $(get error.field)"
accepted cone 'points that are far from the origin' <<'EOF'
{"points":[[12358.3,-9600,18607.033119415435],[12359.537242250692,
-9599.355827816804,18608.082919415432]],"tangents":[[0.7771,-0.3358,0.5322],[
0.7825,-0.0733,0.6183]],"rulings":[[0.5744,0.0329,-0.8179],[0.6216,0.0338,
-0.7826]],"method":"atph","apexes":[-0.9539815800240917,6.07]}
EOF
