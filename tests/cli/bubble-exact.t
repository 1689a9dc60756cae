# SPDX-License-Identifier: GPL-3.0-or-later
#
# `bubble --degree=exact': records of surfaces without control points, which
# `verify' recomputes from their vertices and edges.
#
# shellcheck disable=SC2154,SC2016  # what lib.sh sets; programs of jq
. "$srcdir/tests/cli/lib.sh"

meshes=$srcdir/data/byrtus-2011-meshes.jsonl
jq -c 'select(.id == "monkey saddle")' "$meshes" >saddle.json
jq -c 'select(.id == "cube")' "$meshes" >cube.json

for n in 0 1 2; do
  run bubble --degree=exact --continuity=$n --sample=3 -q saddle.json cube.json
  expect "continuity $n" 0
  cp out result$n
  cat saddle.json cube.json >problems
  run verify --problems=problems result$n
  expect "continuity $n: verified" 0
  run verify result$n
  expect "continuity $n: verified alone" 0
done
equal 'members' '{vertices:[{point:[number],normal:[number]}],edges:['\
'{vertices:[number],faces:[number],normal_jump:number,curvature_jump:number,'\
'strip:{height:[number],gradient:[[number]],hessian:[[number]]}}]}' \
  "$(tail -n 1 result2 | jq -c '{vertices, edges: .edges[:1]}' | json shape)"
run bubble --degree=exact --offset=0.05,-0.05 --sample=2 -q cube.json
cp out beside
run verify --problems=cube.json beside
expect 'surfaces beside' 0
jq -c 'del(.normals) | .subdivide = 1' saddle.json >fine.json
run bubble --degree=exact fine.json
cp out fine
run verify --problems=fine.json fine
expect 'subdivided' 0

# ---- records that are not right any more --------------------------------------

# tampered WHERE PROGRAM [N]: of the saddle, of continuity N or 2
tampered() {
  head -n 1 "result${3-2}" | jq -c "$2" >wrong.json
  "$PHSPLINE" verify wrong.json >out 2>err
  equal "tampered: $2" "$1" "$(jq -r .error.field out)"
}
tampered vertices 'del(.vertices)'
tampered 'patches[0].vertices' 'del(.edges)'
tampered 'vertices[2].normal' '.vertices[2].normal |= map(. * 1.001)'
tampered 'patches[4].vertices' '.vertices |= .[:11]'
tampered 'edges[3].strip' '.edges[3].strip.height |= .[1:]'
tampered 'edges[3].strip' 'del(.edges[3].strip.hessian)'
tampered 'diagnostics.area' '.area *= 1.000001'
tampered 'samples[20].point' '.samples[20].point[0] += 1e-6'
tampered 'samples[20].mean' '.samples[20].mean *= 1.0001'
tampered closed '.closed = true'

# Any number that the surface depends on: what both patches of an edge have of
# it does not fit what others have, or what is told.  (In a plane of symmetry
# gradients count by their direction, and no edge is in one here.)
jq -c 'del(.normals) | .points |= [to_entries[] | .key as $i | .value |
  to_entries | map(.value + (($i * 7 + .key * 3) | sin) / 80)]' saddle.json \
  >rough.json
for n in 1 2; do
  run bubble --degree=exact --continuity=$n rough.json
  jq -c '. as $r | [paths(numbers) | select((.[0] == "vertices") or
      (.[0] == "edges" and .[2] == "strip" and .[3] != "hessian"))] as $all |
    $r, (range(0; $all | length; 11) as $i | $r | .id = $i |
    setpath($all[$i]; getpath($all[$i]) + 1e-5))' out >wrong
  "$PHSPLINE" verify wrong >out 2>err
  true_that "continuity $n: any number that is wrong" jq -se '(.[0] |
    .status == "ok") and (.[1:] | length > 40 and all(.[]; .status != "ok"))' out
done
