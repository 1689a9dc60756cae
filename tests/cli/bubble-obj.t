# SPDX-License-Identifier: GPL-3.0-or-later
#
# `bubble': meshes of OBJ files, good and hostile, and meshes that are
# subdivided before.
#
# shellcheck disable=SC2154,SC2016  # what lib.sh sets; programs of jq
. "$srcdir/tests/cli/lib.sh"

meshes=$srcdir/data/byrtus-2011-meshes.jsonl
jq -c 'select(.id == "cube")' "$meshes" >cube.json

# ---- files -------------------------------------------------------------------

# A cube, as JSON and as programs write it.
{
  echo '# a cube'
  jq -r '.points[] | "v \(.[0]) \(.[1]) \(.[2])"' cube.json
  jq -r '.faces[] | "f \(map(. + 1) | map(tostring) | join(" "))"' cube.json
} >plain.obj
jq -c 'del(.normals, .id, .meta)' cube.json >plain.json
run bubble plain.json
cp out want
run bubble plain.obj
expect 'points and faces' 0
equal_files 'points and faces: as from JSON' want out
run bubble --input-format=obj - <plain.obj
expect 'standard input' 0
equal_files 'standard input: the same' want out
sed 's/$/\r/' plain.obj >dos.obj
run bubble dos.obj
equal_files 'lines that end in CR and LF' want out
{
  printf '\357\273\277mtllib cube.mtl\no cube one\ng a b\nusemtl red\ns off\n'
  sed -n '2,9s/$/ 1.0/p' plain.obj
  printf 'vt 0 0\nvt 1 0\nl 1 2\np 3\n'
  sed -n '10,$p' plain.obj | awk '{ printf "f"; for (i = 2; i < 6; i++)
    printf " %d/%d%s", $i, 1 + i % 2, i == 3 ? "\\\n\t" : ""; print " # face" }'
  printf '\n  \n#\\\n# end'
} >full.obj
run bubble full.obj
equal_files 'names, colours, texture coordinates, joined lines' want out
awk '/^f/ { printf "f"; for (i = 2; i < 6; i++) printf " %d", $i - 9; print ""
  next } 1' plain.obj >negative.obj
run bubble negative.obj
equal_files 'numbers from the last point back' want out
{
  sed -n '10,$p' plain.obj
  sed 9q plain.obj
} >last.obj
run bubble last.obj
equal_files 'faces before their points' want out

# normals of corners, by numbers of their own
jq -c 'del(.id, .meta)' cube.json >normals.json
run bubble normals.json
cp out want
{
  jq -r '.normals | reverse[] | "vn \(.[0]) \(.[1]) \(.[2])"' cube.json
  sed 9q plain.obj
  sed -n '10,$p' plain.obj | awk '{ printf "f"; for (i = 2; i < 6; i++)
    printf NR % 2 ? " %d//%d" : " %d//-%d", $i, NR % 2 ? 9 - $i : $i
    print "" }'
} >normals.obj
run bubble normals.obj
equal_files 'normals' want out
run bubble plain.obj full.obj cube.json
equal 'files in a row' 'ok null,ok null,ok cube' \
  "$(jq -sr 'map("\(.status) \(.id)") | join(",")' out)"
run bubble plain.obj
cp out result
run verify --problems=plain.obj result
expect 'verified' 0
sed 's/^v -1 -1 -1/v -1 -1 -2/' plain.obj >other.obj
"$PHSPLINE" verify --problems=other.obj result >out 2>err
equal 'verified against another mesh' 'patches[0].control_points' \
  "$(jq -r .error.field out)"
run bubble --format=obj --sample=3 plain.obj
mv out again.obj
run bubble again.obj
expect 'a mesh that was written is read' 0
true_that 'a mesh that was written is read: 9 for each face' jq -e \
  '.patches | length == 54' out

# ---- hostile files -----------------------------------------------------------

square='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n'
# wrong LINE [FIELD] CODE MESSAGE TEXT
wrong() {
  printf '%b' "$5" >wrong.obj
  run bubble wrong.obj
  expect "$4" 1 "phspline: wrong.obj:$1: record 1: ${2:+$2: }$4 [$3]
$(failed 1 1)" "$(printf '{"command":"bubble","status":"error","error":{"code":"%s","message":"%s%s",%s"file":"wrong.obj","line":%d}}\n' \
    "$3" "${2:+$2 }" "$4" "${2:+\"field\":\"$2\",}" "$1")"
}
wrong 5 'faces[0]' bad-shape 'must have 4 points, found 3; with subdivide of 1 or more it may have others' "${square}f 1 2 3\n"
wrong 7 'faces[1]' bad-shape 'must have 4 points, found 5; with subdivide of 1 or more it may have others' "${square}f 1 2 3 4\n\nf 1 2 3 4 5\nv 2 2 2\n"
wrong 5 'faces[0]' bad-value 'has points[0] twice' "${square}f 1 2 3 -4\n"
wrong 1 'points[0]' bad-value 'belongs to no face' "v 9 9 9\n${square}f 2 3 4 5\n"
wrong 1 'points[0]' bad-value 'belongs to no face' "v 9 9 9\n${square}vn 0 0 1\nf 2//1 3//1 4//1 5//1\n"
wrong 5 '' bad-value "a corner must be one of the points, found '5'" "${square}f 1 2 3 5\n"
wrong 5 '' bad-value "a corner must be one of the points, found '0'" "${square}f 1 2 3 0\n"
wrong 5 '' bad-value "a corner must be one of the points, found '-5'" "${square}f 1 2 3 -5\n"
wrong 5 '' bad-value "a corner must be one of the points, found '1.5'" "${square}f 1 2 3 1.5\n"
wrong 5 '' bad-value "a corner must be one of the points, found '1e300'" "${square}f 1 2 3 1e300\n"
wrong 5 '' bad-value "a corner must have one of the normals, found '4//1'" "${square}f 1 2 3 4//1\n"
wrong 5 '' syntax "a corner must be numbers, as in 7, 7/2, 7//5 or 7/2/5, found '4x'" "${square}f 1 2 3 4x\n"
wrong 5 '' syntax "a corner must be numbers, as in 7, 7/2, 7//5 or 7/2/5, found '4/1/1/1'" "${square}f 1 2 3 4/1/1/1\n"
wrong 2 '' bad-shape "must have 3 numbers, found 'v 1 0'" 'v 0 0 0\nv 1 0\n'
wrong 1 '' syntax "v must have 3 numbers, and then at most 4 others, found 'x'" 'v 0 0 x\n'
wrong 1 '' syntax "vn must have 3 numbers, found '1'" 'vn 0 0 1 1\n'
wrong 1 '' not-finite "must be a finite number, found '1e999'" 'v 0 0 1e999\n'
wrong 2 '' syntax "must be a line of OBJ that begins with v, vn, f or what is ignored, found 'curv2'" '# x\ncurv2 1 2\n'
wrong 4 'points[3]' bad-value 'has no normal, but others have' \
  "${square}vn 0 0 1\nf 1//1 2//1 3//1 4\n"
wrong 10 'points[1]' bad-value 'has another normal here than in line 9; leave out the normals of corners, or give each point one' \
  "${square}v 2 0 0\nv 2 1 0\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1 4//1\nf 2//2 5//1 6//1 3//1\n"
wrong 1 points missing-field 'is missing: it must be an array of points [x,y,z]' '#\n'
wrong 1 faces missing-field 'is missing: it must be an array of arrays of numbers' "$square"
printf 'v 0 0\000 0\nf \000' >wrong.obj
run bubble wrong.obj
equal 'bytes of 0' 'syntax 1' "$(jq -r '.error | "\(.code) \(.line)"' out)"
: >empty.obj
run bubble empty.obj
expect 'an empty file is no problem' 0 \
  'phspline: there is no problem in empty.obj' ''
run bubble --max-record-bytes=20 plain.obj
equal 'a file that is too long' limit "$(jq -r .error.code out)"
run bubble plain.obj --max-memory=1000
equal 'a file that takes too much memory' limit "$(jq -r .error.code out)"
run planar plain.obj
expect 'a mesh for another command' 1 "phspline: plain.obj:1: record 1: is a mesh, which planar does not read [bad-value]
$(failed 1 1)" "$(cat out)"

# ---- subdivision ---------------------------------------------------------------

# corners of patches, in order, of bilinear ones
corners='[.patches[].control_points[]] | unique'
run bubble --continuity=0 --subdivide=1 plain.json
true_that 'one step on a cube' jq -e "$corners | map(map(fabs) | sort) |
  group_by(.) | map([.[0], length]) | map([(.[0] | map(. * 36 | round)), .[1]])
  == [[[0,0,36],6],[[0,27,27],12],[[20,20,20],8]]" out
cat >sheet.json <<'END'
{"points":[[0,0,0],[2,0,0],[4,0,0],[0,2,0],[2,2,3],[4,2,0],[0,4,0],[2,4,0],
[4,4,0]],"faces":[[0,1,4,3],[1,2,5,4],[3,4,7,6],[4,5,8,7]],"continuity":0}
END
run bubble --subdivide=1 sheet.json
true_that 'the boundary of a sheet' jq -e "$corners | map(select(.[2] == 0)) |
  length == 16 and all(.[]; (.[0] | . == 0 or . == 4) or (.[1] | . == 0 or
  . == 4))" out
true_that 'the middle of a sheet' jq -e "$corners | map(select(.[0] == 2 and
  .[1] == 2))[0][2] - (3 / 4 + 2 * 1.5 + 3) / 4 | fabs < 1e-15" out
jq -c '.points[1] = [2, -1, 0]' sheet.json >other.json
run bubble --subdivide=1 other.json
true_that 'a boundary point moves' jq -e "$corners | any(.[]; . == [2,-0.75,0])" out
run bubble --subdivide=1 --boundary=fixed other.json
true_that 'a boundary that is fixed' jq -e "$corners | any(.[]; . == [2,-1,0]) and
  any(.[]; . == [1,-0.5,0])" out
cat >tetrahedron.obj <<'END'
v 1 1 1
v -1 -1 1
v -1 1 -1
v 1 -1 -1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
END
for steps in 1 2; do
  run bubble --subdivide=$steps --continuity=2 tetrahedron.obj
  expect "triangles, $steps steps" 0
  true_that "triangles, $steps steps: patches" jq -e ".closed and
    (.patches | length) == 3 * pow(4; $steps)" out
  cp out result
  run verify --problems=tetrahedron.obj result
  expect "triangles, $steps steps: verified" 0
done
jq -c '.patches |= .[1:]' result >wrong.json
"$PHSPLINE" verify --problems=tetrahedron.obj wrong.json >out 2>err
equal 'triangles: a patch is gone' 'patches are not as many as the steps make of the faces (shape)' "$(jq -r .error.message out)"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >triangle.obj
run bubble --subdivide=1 triangle.obj
true_that 'one triangle' jq -e '(.area - 0.5 | fabs) < 1e-15' out

# refused CODE FIELD MESSAGE FILE OPTION...
refused() {
  code=$1 field=$2 message=$3
  shift 3
  run bubble --subdivide=1 "$@"
  equal "refused: $message" "$code $field $message" \
    "$(jq -r '.error | "\(.code) \(.message)"' out)"
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\nf 1 2 3\nf 1 2 4\nf 2 1 5\n' >three.obj
refused bad-value 'faces[2]' 'is the third one at the edge of points 0 and 1, after faces 0 and 1; two are allowed' three.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n' >alone.obj
refused bad-value 'points[3]' 'belongs to no face' alone.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n' >two.obj
refused bad-shape 'faces[0]' 'must have from 3 to 1000 points, found 2' two.obj
refused bad-value subdivide 'must be a whole number from 0 to 10, found 1.5' --override=subdivide=1.5 plain.obj
refused bad-value subdivide 'must be a whole number from 0 to 10, found 11' --override=subdivide=11 plain.obj
jq -c '.boundary = "loose"' plain.json >loose.json
refused bad-value boundary 'must be "smooth" or "fixed", found "loose"' loose.json
jq -c '.normals |= (.[0] = (.[7] | map(-.)) | .[1] = (.[7]) | map([0,0,1]) |
  .[0] = [0,0,-1] | .[1] = [0,0,-1] | .[2] = [0,0,-1] | .[3] = [0,0,-1])' \
  normals.json >zero.json
refused zero-tangent 'points[10]' 'has no normal after subdivision: those around it add up to 0' zero.json
