# SPDX-License-Identifier: GPL-3.0-or-later
#
# --fields: records with some of their members are the whole records without the
# others; what nobody asked for is not computed, what is promised is checked.
. "$srcdir/tests/cli/lib.sh"

plane='{"id":"p","meta":[1],"points":[[0,0],[1,2],[3,0],[4,1]]}'
bad='{"id":"bad","points":[[0,0]]}'
space='{"id":"s","points":[[0,0,0],[1,2,1],[3,0,0],[4,1,2]]}'
printf '%s\n' "$plane" "$bad" >plane.jsonl
printf '%s\n' "$plane" >good.jsonl
printf '%s\n' "$space" >space.jsonl

# keeps NAME FILTER COMMAND FILE FIELDS [OPTION...]: the records with the fields
# are what jq's filter makes of the whole ones
keeps() {
  name=$1 filter=$2 command=$3 file=$4 fields=$5
  shift 5
  run "$command" -q "$@" "$file"
  jq -c "if .status == \"ok\" then $filter else . end" out >want
  run "$command" -q --fields="$fields" "$@" "$file"
  jq -c . out >found
  equal_files "$name" want found
}

head='{id, command, status}'
if command -v jq >/dev/null; then
  keeps 'nothing but the heading' "$head" planar plane.jsonl id
  keeps 'the length' "$head + {length}" planar plane.jsonl length
  keeps 'meta' "{id, command, status, meta, length}" planar plane.jsonl \
    length,meta
  keeps 'a diagnostic' "$head + {diagnostics: {energy: .diagnostics.energy}}" \
    planar plane.jsonl diagnostics.energy
  keeps 'two of them' "$head + {diagnostics: {loops: .diagnostics.loops,
    kantorovich: {h: .diagnostics.kantorovich.h}}}" \
    planar plane.jsonl diagnostics.kantorovich.h,diagnostics.loops
  keeps 'all of them' "$head + {diagnostics}" planar plane.jsonl \
    diagnostics.loops,diagnostics,diagnostics.energy
  keeps 'of segments' "$head + {segments: [.segments[] |
    {control_points, length}]}" planar plane.jsonl \
    segments.length,segments.control_points
  keeps 'of offsets' "$head + {length, offsets: [.offsets[] | {distance}]}" \
    planar plane.jsonl offsets.distance,length --offset=0.1,0.2
  keeps 'of solutions' "$head + {solutions: [.solutions[] |
    {diagnostics: {energy: .diagnostics.energy}}]}" \
    planar good.jsonl solutions.diagnostics.energy --solutions=all
  keeps 'sweep and set' '{id, command, status, sweep, set}' \
    planar good.jsonl sweep,set -S knots=uniform,chordal --set=closed=false
  keeps 'in space' "$head + {diagnostics: {F1: .diagnostics.F1}}" \
    spatial-hermite space.jsonl diagnostics.F1
  keeps 'of arclength' "$head + {diagnostics: {starts:
    [.diagnostics.starts[] | {outcome}]}}" \
    arclength space.jsonl diagnostics.starts.outcome
  keeps 'of cubics' "$head + {diagnostics: {simple: .diagnostics.simple}}" \
    tc plane.jsonl diagnostics.simple
  keeps 'indented' "$head + {length}" planar plane.jsonl length --pretty
else
  printf 'SKIP  %s\n' 'members of records: no jq'
fi

# Failures are whole, a curve that misses its promise would be one.
run planar -q --fields=length plane.jsonl
equal 'an error record' '{"id":"bad","command":"planar","status":"error",'\
'"error":{"code":"too-few-points","message":"points must be at least 2, '\
'found 1","field":"points","file":"plane.jsonl","line":2}}' "$(sed -n 2p out)"
run planar --strict -q --fields=id -S closed=true plane.jsonl
equal 'warnings count' 1 "$status"

run planar -q --fields=length plane.jsonl
cp out whole
run planar -q --fields=error.code plane.jsonl
equal 'a part of an error' "$(sed -n 2p whole)" "$(sed -n 2p out)"
run planar --fields=error.cod plane.jsonl
expect 'a name of an error' 2 "phspline: --fields: no member 'error.cod'; did \
you mean \"code\"?
Try 'phspline planar --help'." ''
run planar --fields=lenght plane.jsonl
expect 'a name' 2 "phspline: --fields: no member 'lenght'; did you mean \
\"length\"?
Try 'phspline planar --help'." ''
run planar --fields=id,diagnostics.energi plane.jsonl
expect 'a name inside' 2 "phspline: --fields: no member 'diagnostics.energi'; \
did you mean \"energy\"?
Try 'phspline planar --help'." ''
for fields in '' ',' 'id,' length.x segments..length segments. 'id length'; do
  run planar --fields="$fields" plane.jsonl
  equal "no member in '$fields'" 2 "$status"
done
run planar --fields=length -f csv plane.jsonl
expect 'tables' 2 "phspline: --fields needs --format=json
Try 'phspline planar --help'." ''
