# SPDX-License-Identifier: GPL-3.0-or-later
#
# Options that tc alone has: the tolerance that is a field as well, curves of
# several pieces as values, their elements in sweeps, and images on the Blaschke
# cylinder.  (Of all commands: options.t.)
. "$srcdir/tests/cli/lib.sh"

chain='{"curve":[[[0,0],[1,2],[3,2],[4,0]],[[4,0],[5,-2],[6,0]]]}'

# with FIELDS: the chain as a problem that has these, too; its record in wanted
with() {
  feed "${chain%?},$1}" tc
  mv out wanted
}

# same NAME FIELDS ARGUMENT...: by the arguments as by the fields
same() {
  name=$1
  with "$2"
  shift 2
  feed "$chain" tc "$@"
  expect "$name" 0
  equal_but_set "$name: the record" wanted out
}

# ---- tolerance -----------------------------------------------------------------

same '--tolerance' '"tolerance":0.01' --tolerance=0.01
same '--tolerance as --set' '"tolerance":0.01' --set tolerance=0.01
same 'the last --tolerance' '"tolerance":0.01' --tolerance=1 --tolerance .01
same '--override beats it' '"tolerance":0.01' --override=tolerance=0.01 \
  --tolerance=1
same '--pieces' '"pieces":9' --pieces=9
with '"tolerance":0.01'
feed "${chain%?},\"tolerance\":0.01}" tc --tolerance=0.001
equal_files '--tolerance leaves what is there' wanted out
feed "$chain" tc --tolerance=0.001
true_that 'and is not without effect' [ "$(get 'segments[5].length')" != absent ]

feed "$chain" tc --tolerance=0
expect 'no tolerance' 2 "phspline: --tolerance must be a number greater than 0, \
found '0'
Try 'phspline tc --help'."
feed "$chain" tc --set=tolerance=abc
expect 'no tolerance that is a number' 2 "phspline: --set: tolerance must be a number, found \"abc\"
Try 'phspline tc --help'."

run tc --help
equal 'the help lists it once' 1 "$(grep -c '^ *\(--\)\{0,1\}tolerance' out)"
run planar --help
equal 'that of others, too' 1 "$(grep -c '^ *--tolerance=E' out)"

# ---- curves --------------------------------------------------------------------

with '"tolerance":0.01'
feed '{}' tc --tolerance=0.01 \
  --curve='[ [[0,0],[1,2],[3,2],[4,0]], [[4,0],[5,-2],[6,0]] ]'
equal_but_set '--curve' wanted out
feed '{"curve":[[0,0],[9,9]]}' tc --tolerance=0.01 \
  --override='curve=[[[0,0],[1,2],[3,2],[4,0]],[[4,0],[5,-2],[6,0]]]'
equal_but_set '--override=curve' wanted out
feed '{"curve":[[0,0],[1,2],[3,2],[4,0]]}' tc --tolerance=0.01
mv out wanted
feed '{"curve":[[[0,0],[1,2],[3,2],[4,0]]]}' tc --tolerance=0.01
equal_but_set 'a chain of one' wanted out

# refused NAME LINE CURVE WHERE WHY CODE
refused() {
  feed "{\"curve\":$3}" tc --tolerance=0.01
  expect "$1" 1 "phspline: -:$2: record 1: $4: $5 [$6]
$(failed 1 1)"
  equal "$1: the field" "\"$6\" \"$4\"" "$(get error.code) $(get error.field)"
}
refused 'too large' 2 '[[[0,0],[1,2]],
[[1,2],[3,1e999]]]' 'curve[1][1][1]' 'is 1e999, which overflows a double' \
  not-finite
refused 'no number' 1 '[[[0,0],[1,"2"]]]' 'curve[0][1][1]' \
  'must be a number, found a string' bad-type
refused 'in space' 3 '[[[0,0],[1,2]],
[[1,2],
[3,1,0]]]' 'curve[1][1]' 'must have 2 numbers, found 3' bad-shape
refused 'no points' 1 '[[[0,0],[1,2]],[]]' 'curve[1]' 'has no points' bad-shape
refused 'no curve' 1 '[1,2]' curve "must be an array of points [x,y] or an \
array of such arrays, found an array of numbers" bad-type

# ---- sweeps --------------------------------------------------------------------

# The chain has -2 there.
with '"tolerance":0.01'
feed "$chain" tc --tolerance=0.01 --sweep='curve[1][1][1]=-2,-3'
expect 'an element of a piece' 0
sed -n '1s/"sweep":{[^}]*},//p' out >found
equal_but_set 'an element of a piece: as it was' wanted found
equal 'an element of a piece: names' \
  '{"curve[1][1][1]":-2} {"curve[1][1][1]":-3}' "$(get sweep)"
equal 'an element of a piece: other curves' 2 "$(json get length out | sort -u |
  wc -l | tr -d ' ')"
feed '{"curve":[[0,0],[1,2],[3,2],[4,0]]}' tc --tolerance=0.01 \
  --sweep='curve[1][1]=1:3:3'
equal 'an element of a curve' \
  '0 {"curve[1][1]":1} {"curve[1][1]":2} {"curve[1][1]":3}' \
  "$status $(get sweep)"
feed "$chain" tc --tolerance=0.01 --sweep='curve[1][1]=1'
expect 'no such element' 1 "phspline: -:1: record 1: curve: has no element \
curve[1][1] for --sweep to set [bad-shape]
$(failed 1 1)"
feed "$chain" tc --sweep='curve[1][1][1][1]=1'
expect 'no element at all' 2 "phspline: --sweep: 'curve[1][1][1][1]' is not a \
field or an element like knots[2] or points[0][1]
Try 'phspline tc --help'."
with '"tolerance":0.01'
feed "$chain" tc --sweep=tolerance=0.01,0.001
expect 'tolerances' 0
sed -n '1s/"sweep":{[^}]*},//p' out >found
equal_files 'tolerances: the first' wanted found

# ---- images --------------------------------------------------------------------

turns='{"points":[[0,0],[1,0],[3,0]],"tangents":[[0,1],[0,-1],[1,1]]}'
feed "$turns" tc
equal 'no image unless asked for' absent "$(get 'segments[0].blaschke')"
feed "$turns" tc --blaschke
expect 'images' 0
equal 'an image' \
  '[{interval:[number],control_points:[[number]],weights:[number]}]' \
  "$(shape_of 'segments[0].blaschke')"
equal 'of degree 5' 6 "$(floats 'segments[0].blaschke[0].weights' | wc -l |
  tr -d ' ')"
