# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cone': what can be wrong with each field, and what is said then; the rest is in
# cone.t and cone-atph.t.
#
# shellcheck disable=SC2034,SC2154  # what errors.sh reads and sets
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

points='"points":[[0,0,0],[2,1,0]]'
rulings='"rulings":[[0,1,0],[0,1,0]]'
tangents='"tangents":[[1,0,0],[1,0,0]]'
elements="$points,$rulings,$tangents"
atph='"method":"atph","apexes":[-3,3]'
good="{$elements}"
errors_of cone

# said CODE FIELD MESSAGE PROBLEM
said() {
  printf '%s\n' "$4" >a.json
  error_record "$1" "$2" "$3" a.json 1 >want
  run cone -q a.json
  expect "${2:+$2: }$3 [$1]" 1 "phspline: a.json:1: record 1: ${2:+$2: }$3 [$1]"
  equal_files "$2: $3: the record" want out
}

# field FIELD VALUE CODE WHERE MESSAGE [METHOD]: the value in place of what stands
# there, or beside it; WHERE follows the name of the field
field() {
  said "$3" "$1$4" "$5" "$(printf '{%s%s}' "$elements" "${6:+,$6}" |
    jq -c --argjson value "$2" ".$1 = \$value")"
}

array='must be an array of vectors [x,y,z]'
for name in rulings tangents; do
  field $name '[]' bad-shape '' 'must have 2 vectors, one for each point, found 0'
  field $name '[[1,0,0],[0,1]]' bad-shape '[1]' 'must have 3 numbers, found 2'
  field $name '[[1,0,0],[0,"x",0]]' bad-type '[1][1]' \
    'must be a number, found a string'
  field $name '"up"' bad-type '' "$array, found a string"
  field $name '[1,2,3]' bad-type '' "$array, found an array of numbers"
  field $name null bad-type '' "$array, found null"
done
field points '[]' too-few-points '' 'must be at least 2, found 0'
field points '[[0,0],[1,1]]' bad-shape '[0]' 'must have 3 numbers, found 2'
field points '[[0,0,0],[1,null,0]]' bad-type '[1][1]' \
  'must be a number, found null'
field normals '[[0,0,1]]' bad-shape '' \
  'must have 2 vectors, one for each point, found 1'
field normals '[[0,0,1],[0,0,0]]' zero-tangent '[1]' 'must not be zero'
field normals '[[0,0,1],[0,1,1]]' bad-value '[1]' \
  'is neither rulings[1] x tangents[1] nor its opposite: it is off by 0.765, at most 0.005 is allowed'
field closed 1 bad-type '' 'must be true or false, found a number'
said too-few-points points 'must be at least 3 different points for a closed curve, found 2' \
  "{$elements,\"closed\":true}"
field method '"conic"' bad-value '' 'must be "circular" or "atph", found "conic"'
field method 1 bad-type '' 'must be "circular" or "atph", found a number'
for value in '[1,2]:2' '[]:0'; do
  field lambda "${value%:*}" bad-shape '' \
    "must be a number, or as many as there are pairs, 1, found ${value#*:}"
done
field lambda '"both"' bad-value '' \
  'must be "equal", a number or an array of numbers, found "both"'
field lambda -1 bad-value '' 'must be greater than 0, found -1'
field lambda '[0]' bad-value '[0]' 'must be greater than 0, found 0'
field lambda null bad-type '' \
  'must be "equal", a number or an array of numbers, found null'
field degenerate_tolerance 0 bad-value '' \
  'must be greater than 0 and at most 0.1, found 0'
field degenerate_tolerance '"x"' bad-type '' 'must be a number, found a string'
field height '"low"' bad-type '' 'must be an array of numbers, found a string'
field height '[0,1,2]' bad-shape '' \
  'must have 2 numbers, from where to where, found 3'
field height '[0,null]' bad-type '[1]' 'must be a number, found null'
field flat '[1,2]' bad-type '' \
  'must be an array of vectors [x,y], found an array of numbers'
field flat '[[1,null]]' bad-type '[0][1]' 'must be a number, found null'
field translate 5 bad-type '' 'must be an array of numbers, found a number'
field translate '[1,2,3,4]' bad-shape '' 'must have 3 numbers, found 4'
field translate '[1,2,"z"]' bad-type '[2]' 'must be a number, found a string'

for name in 'apexes [1,2]' 'contact_point 0.5' 'tangent_scale "chord"' \
  'criterion "F1"' 'angles [[0,0]]' 'alpha 1'; do
  field "${name% *}" "${name#* }" bad-value '' 'is of "method":"atph"'
done
for name in 'lambda 1' 'degenerate_tolerance 0.001'; do
  field "${name% *}" "${name#* }" bad-value '' 'is of "method":"circular"' "$atph"
done
field apexes '[1]' bad-shape '' 'must have 2 numbers, one for each point, found 1' \
  "$atph"
field apexes 1 bad-type '' 'must be an array of numbers, found a number' "$atph"
field apexes '[1,"x"]' bad-type '[1]' 'must be a number, found a string' "$atph"
field contact_point '"middle"' bad-value '' \
  'must be "nearest", "midpoint" or a number, found "middle"' "$atph"
field tangent_scale 2 bad-type '' 'must be "chord" or "unit", found a number' \
  "$atph"
field criterion '"F4"' bad-value '' \
  'must be "F1", "F2" or "F3", found "F4"; did you mean "F1"?' "$atph"
for value in 0 4; do
  field alpha $value bad-value '' "must be between 0 and pi, found $value" "$atph"
done
field alpha '[1,1,1]' bad-shape '' \
  'must be one for all strips, or as many as there are, 2, found 3' "$atph"
field angles '[[0,0],[0,0],[0,0]]' bad-shape '' \
  'must be one for all strips, or as many as there are, 2, found 3' "$atph"
field angles '[[0,0,0]]' bad-shape '[0]' 'must have 2 numbers, found 3' "$atph"

# ---- flipped frames --------------------------------------------------------------

saddle='has no pair of circular cones: the rulings are those of a saddle, as of a '\
'helicoid; see whether one of them points the other way'
legs='has no pair of cones with such legs: the second contact element is not ahead '\
'of the first, or no second leg belongs to this lambda'
said infeasible 'pairs[0]' "$saddle" "{$points,\"rulings\":[[0,1,0],[0,-1,0]],$tangents}"
said infeasible 'pairs[0]' "$legs" "{$points,$rulings,\"tangents\":[[1,0,0],[-1,0,0]]}"
said infeasible 'pairs[0]' "$legs" "{$points,$rulings,\"tangents\":[[-1,0,0],[-1,0,0]]}"

said too-large '' 'the length or the area of the surface overflows a double' \
  '{"points":[[0,0,0],[3e200,1e200,1e200]],"rulings":[[0,1,0],[0,1,0]],"tangents":[[1,0,0],[0.6,0,0.8]],"height":[0,1e200]}'

# ---- text that is none -----------------------------------------------------------

said bad-value rulings 'occurs twice' "{$elements,$rulings}"
said unknown-field tangnts 'is not a field of cone; did you mean "tangents"?' \
  "{$elements,\"tangnts\":1}"
said not-finite 'rulings[1][1]' 'is 1e999, which overflows a double' \
  "{$points,\"rulings\":[[0,1,0],[0,1e999,0]],$tangents}"
feed "{$points,\"rulings\":[[0,1,0],[0,NaN,0]],$tangents}" cone
equal 'NaN' '3 "syntax"' "$status $(get error.code)"
feed "{$points,$rulings" cone
equal 'text that ends' '3 "syntax"' "$status $(get error.code)"

# ---- tables ----------------------------------------------------------------------

head='x,y,z,rx,ry,rz,tx,ty,tz'
row='0,0,0,0,1,0,1,0,0'
for part in 'x:points' 'rx:rulings' 'tz:tangents'; do
  bad_csv 3 1:1 '' missing-field "column \"${part%:*}\" is missing: cone needs it \
for ${part#*:}" "$(echo "$head" | sed "s/\\(^\\|,\\)${part%:*}\\(,\\|\$\\)/\\1/;
    s/^,//; s/,\$//")\n1,2,3,4,5,6,7,8\n"
done
bad_csv 3 1:25 '' unknown-field 'column "up" is unknown to cone (--ignore-columns '\
'skips it)' "$head,up\n$row,1\n"
for cell in nan inf; do
  bad_csv 1 3 'tangents[1]' not-finite "needs a finite number in column ty, \
found \"$cell\"" "$head\n$row\n2,1,0,0,1,0,1,$cell,0\n"
done
bad_csv 1 3 'tangents[1]' bad-type 'needs a number in column ty, found "x"' \
  "$head\n$row\n2,1,0,0,1,0,1,x,0\n"
bad_csv 1 3 'rulings[1]' zero-tangent 'must not be zero' \
  "$head\n$row\n2,1,0,0,0,0,1,0,0\n"
bad_csv 1 3 'tangents[1]' zero-tangent 'must not be zero' \
  "$head\n$row\n2,1,0,0,1,0,0,0,0\n"
bad_csv 1 3 '' bad-shape 'the row has 8 cells, expected 9' \
  "$head\n$row\n2,1,0,0,1,0,1,0\n"
