# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every error code that `planar' can give: the line on standard error and the
# error record, to the byte, and that the problems around it are solved.
. "$srcdir/tests/cli/lib.sh"
. "$srcdir/tests/cli/errors.sh"

# ---- problems ----------------------------------------------------------------

errors_of planar

# with MEMBERS: a problem that has more than its points
with() {
  printf '{"points":[[0,0],[1,1],[2,0]],%s}' "$1"
}

points='must be an array of points [x,y], found'
knots='must be "chordal", "centripetal", "uniform" or an array of numbers, found'
vectors='must be an array of vectors [x,y], found'

bad bad-type '' 'a problem must be an object, found a number' 5
bad bad-type '' 'a problem must be an object, found a string' '"points"'
bad bad-type '' 'a problem must be an object, found null' null
bad bad-type '' 'a problem must be an object, found true' true

bad unknown-field point 'is not a field of planar; did you mean "points"?' \
  '{"point":[[0,0],[1,1]]}'
bad unknown-field cloesd 'is not a field of planar; did you mean "closed"?' \
  '"cloesd":true'
bad unknown-field Points 'is not a field of planar; did you mean "points"?' \
  '{"Points":[[0,0],[1,1]]}'
bad unknown-field mta 'is not a field of planar; did you mean "meta"?' '"mta":1'
bad unknown-field length 'is not a field of planar' '"length":1'
bad unknown-field '""' 'is not a field of planar' '"":1'
bad unknown-field x "is not a field of planar; an object is a whole problem, and \
its points are one array, \"points\"" '"x":1'

missing='is missing: it must be an array of points [x,y]'
bad missing-field points "$missing" '{}'
bad missing-field points "$missing" '{"knots":"uniform","closed":true}'

bad bad-type points "$points a number" '{"points":5}'
bad bad-type points "$points a string" '{"points":"0,0"}'
bad bad-type points "$points an object" '{"points":{"x":[0,1],"y":[0,1]}}'
bad bad-type points "$points null" '{"points":null}'
bad bad-type points "$points an array of numbers" '{"points":[0,0,1,1]}'
bad bad-type points "$points an array of something else" '{"points":["0"]}'
bad bad-type 'points[1]' 'must be an array of numbers, found a number' \
  '{"points":[[0,0],1]}'
bad bad-type 'points[1][1]' 'must be a number, found a string' \
  '{"points":[[0,0],[1,"1"]]}'
bad bad-type 'points[0][0]' 'must be a number, found null' \
  '{"points":[[null,0],[1,1]]}'
bad bad-type 'points[0][0]' 'must be a number, found an array' \
  '{"points":[[[0,0]],[[1,1]]]}'
bad bad-type 'knots[1]' 'must be a number, found a string' '"knots":[0,"1",2]'
bad bad-type knots "$knots a number" '"knots":1'
bad bad-type knots "$knots an array of arrays" '"knots":[[0,1,2]]'
bad bad-type closed 'must be true or false, found a number' '"closed":1'
bad bad-type closed 'must be true or false, found a string' '"closed":"true"'
bad bad-type closed 'must be true or false, found null' '"closed":null'
bad bad-type end_derivatives "$vectors a string" '"end_derivatives":"chord"'
bad bad-type end_derivatives "$vectors an array of numbers" \
  '"end_derivatives":[1,0]'
bad bad-type id 'must be a string or a number, found true' '"id":true'
bad bad-type id 'must be a string or a number, found null' '"id":null'
bad bad-type id 'must be a string or a number, found an array' '"id":[1]'
bad bad-type id 'must be a string or a number, found an object' '"id":{}'

bad bad-value knots "$knots \"unifrom\"; did you mean \"uniform\"?" \
  '"knots":"unifrom"'
bad bad-value knots "$knots \"\"" '"knots":""'
bad bad-value knots "$knots \"Chordal\"; did you mean \"chordal\"?" \
  '"knots":"Chordal"'
bad bad-value 'knots[1]' 'must be greater than the knot before, 0, found 0' \
  '"knots":[0,0,1]'
bad bad-value 'knots[2]' 'must be greater than the knot before, 2, found 1.5' \
  '"knots":[0,2,1.5]'
bad bad-value end_derivatives 'is for open curves: a closed curve has no ends' \
  '"closed":true,"end_derivatives":[[1,0],[1,0]]'
bad bad-value points 'occurs twice' '"points":[[0,0],[1,1]]'
bad bad-value points 'occurs twice' '"p\u006fints":[[0,0],[1,1]]'
bad bad-value closed 'occurs twice' '"closed":1,"closed":true'
bad bad-value meta 'has the name "a" twice' '"meta":[{"a":1,"b":2,"\u0061":3}]'

bad bad-shape 'points[1]' 'must have 2 numbers, found 1' '{"points":[[0,0],[1]]}'
bad bad-shape 'points[0]' 'must have 2 numbers, found 3' \
  '{"points":[[0,0,0],[1,1,1]]}'
bad bad-shape 'points[1]' 'must have 2 numbers, found 4' \
  '{"points":[[0,0],[1,1,1,1]]}'
bad bad-shape 'points[0]' 'must have 2 numbers, found 0' '{"points":[[],[]]}'
bad bad-shape knots 'must have 3 numbers, one for each point, found 2' \
  '"knots":[0,1]'
bad bad-shape knots 'must have 3 numbers, one for each point, found 0' \
  '"knots":[]'
bad bad-shape knots 'must have 4 numbers, one for each point and one that closes the period, found 3' \
  '"closed":true,"knots":[0,1,2]'
bad bad-shape end_derivatives 'must be two vectors, found 1' \
  '"end_derivatives":[[1,0]]'
bad bad-shape 'end_derivatives[1]' 'must have 2 numbers, found 3' \
  '"end_derivatives":[[1,0],[1,0,0]]'

bad not-finite 'points[1][0]' 'is 1e999, which overflows a double' \
  '{"points":[[0,0],[1e999,1]]}'
bad not-finite 'points[1][1]' 'is -1.8e308, which overflows a double' \
  '{"points":[[0,0],[1,-1.8e308]]}'
bad not-finite 'knots[2]' 'is 1e309, which overflows a double' \
  '"knots":[0,1,1e309]'
bad not-finite id 'is 1e999, which overflows a double' '"id":1e999'
bad not-finite meta 'is -1e999, which overflows a double' \
  '"meta":{"a":[1,-1e999]}'

bad too-few-points points 'must be at least 2, found 0' '{"points":[]}'
bad too-few-points points 'must be at least 2, found 1' '{"points":[[0,0]]}'
bad too-few-points points \
  'must be at least 3 different points for a closed curve, found 2' \
  '{"points":[[0,0],[1,1]],"closed":true}'
bad too-few-points points \
  'must be at least 3 different points for a closed curve, found 2' \
  '{"points":[[0,0],[1,1],[0,0]],"closed":true}'

bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[3,4],[3,4]]}'
bad coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[0,0],[1,1],[1,1.000000000000000001],[2,0]]}'
bad coincident-points 'points[1]' "coincides with points[0]$joins" \
  '{"points":[[0,0],[0,0]]}'
bad coincident-points 'points[2]' "coincides with points[1]$joins" \
  '{"points":[[1,0],[0,0],[0,0],[0,1],[1,0]],"closed":true}'

# there is a curve, but rounding of its control points bends it
rounded='where coordinates are rounded by 2.22e-10'
bad coincident-points 'points[1]' "is too near to points[0]: 2.83e-08 apart, \
$rounded$joins, and data moved to the origin are rounded less" \
  '{"points":[[1000000,0],[1000000.00000002,-2e-8],[1000000.00000005,2e-8],
    [1000000.0000001,-1e-8]]}'
bad coincident-points 'points[0]' "is too near to points[3]: 1.42e-08 apart, \
$rounded$joins, and data moved to the origin are rounded less" \
  '{"points":[[1000000,0],[1000000.00000006,4e-8],[1000000.00000002,0],
    [999999.99999999,-1e-8]],"closed":true}'
feed '{"points":[[0,0],[2e-8,-2e-8],[5e-8,2e-8],[1e-7,-1e-8]]}' planar -q
expect 'the same at the origin' 0

bad zero-tangent 'end_derivatives[0]' 'must not be zero' \
  '"end_derivatives":[[0,0],[1,0]]'
bad zero-tangent 'end_derivatives[1]' 'must not be zero' \
  '"end_derivatives":[[1,0],[0,-0.0]]'

bad too-large knots 'span more than a double can hold' \
  '{"points":[[-1.7e308,0],[1.7e308,0]]}'
bad too-large 'knots[1]' \
  'differs from the knot before by more than a double can hold' \
  '"knots":[-1.7e308,1.7e308,1.75e308]'
bad too-large 'end_derivatives[0]' 'is too large for these points' \
  '{"points":[[0,0],[1e-300,0]],"end_derivatives":[[1e300,0],[1,0]]}'

# The digits of a residual are nobody's promise.
far='{"points":[[0,0],[1,1],[2,0]],"end_derivatives":[[1e150,0],[0,1]]}'
printf '%s\n%s\n' "$far" "$good" >a.jsonl
run planar a.jsonl
equal 'no-convergence' '1 "no-convergence" "segments[1]" absent' \
  "$status $(get error.code | cut -d ' ' -f 1) $(get error.field |
    cut -d ' ' -f 1) $(get segments | cut -d ' ' -f 1)"
true_that 'no-convergence, on standard error' grep -q \
  '^phspline: a.jsonl:1: record 1: segments\[1\]: .* \[no-convergence\]$' err
true_that 'no-convergence: what may help' grep -q \
  '; --end_derivatives nearer to the steps of the data, or none, may help \[' err

# A curve that stands still, of a speed that is a fourth power, has no normal.
printf '{"points":[[0,0],[1,0]],"end_derivatives":[[5,0],[5,0]]}' >a.json
run planar --offset=0.1 a.json
still='has no offset: the curve stands still in it and has no normal there'
expect 'infeasible: the offset of a curve that stands still' 1 \
  "phspline: a.json:1: record 1: segments[0]: $still [infeasible]
$(failed 1 1)" \
  "$(error_record infeasible 'segments[0]' "$still" a.json 1)"
run planar a.json
expect 'that curve without its offset' 0 \
  "phspline: a.json:1: record 1: warning: segment 0 stands still somewhere, \
or turns on the spot (with loops, such segments: 1) [loop]"

# ---- what a record is called -------------------------------------------------

# called NAME RECORD ID: how an id appears in the message and in the record
called() {
  printf '{"points":[],"id":%s}\n' "$3" >a.json
  run planar a.json
  expect "$1, in the message" 1 "phspline: a.json:1: record $2: points: must \
be at least 2, found 0 [too-few-points]
$(failed 1 1)" \
    "$(error_record too-few-points points 'must be at least 2, found 0' a.json \
      1 "$3")"
}

called 'a number as id' 7 7
called 'a number as it was written' 1.50e0 1.50e0
called 'a string as id' 'wing tip' '"wing tip"'
called 'an empty string as id' '' '""'
called 'an id with escapes' "a\"\\x0ab\\" '"a\"\nb\\"'
called 'an id with letters beyond ASCII' 'Ärger' '"Ärger"'
called 'an id that drives terminals' 'a\x1b[2J\x7f\xc2\x9b' \
  "\"a\\u001b[2J\\u007f$(printf '\302\233')\""

# bytes OCTAL...: characters that would be invisible here
bytes() {
  # shellcheck disable=SC2059  # a format of nothing but octal escapes
  printf "$(printf '\\%s' "$@")"
}

# no_effect NAME SHOWN OCTAL...: a character that is not shown as such
no_effect() {
  name=$1 seen=$2
  shift 2
  called "$name" "a${seen}b" "\"a$(bytes "$@")b\""
}
no_effect 'U+0080' '\xc2\x80' 302 200
no_effect 'U+061C, of Arabic letters' '\xd8\x9c' 330 234
no_effect 'U+200B, a space of no width' '\xe2\x80\x8b' 342 200 213
no_effect 'U+200F, right to left' '\xe2\x80\x8f' 342 200 217
no_effect 'U+2028, a line separator' '\xe2\x80\xa8' 342 200 250
no_effect 'U+2029, a paragraph separator' '\xe2\x80\xa9' 342 200 251
no_effect 'U+202A, an embedding' '\xe2\x80\xaa' 342 200 252
no_effect 'U+202E, an override' '\xe2\x80\xae' 342 200 256
no_effect 'U+2066, an isolate' '\xe2\x81\xa6' 342 201 246
no_effect 'U+2069, its end' '\xe2\x81\xa9' 342 201 251
no_effect 'U+FEFF, of byte order' '\xef\xbb\xbf' 357 273 277
no_effect 'U+E0041, a tag' '\xf3\xa0\x81\x81' 363 240 201 201
for shown in '302 240' '342 200 247' '342 200 257' '357 277 275'; do
  # shellcheck disable=SC2086  # of several bytes
  called "$shown is shown" "a$(bytes $shown)b" "\"a$(bytes $shown)b\""
done

ten=1234567890
forty=$ten$ten$ten$ten
called 'an id of 80 bytes' $forty$forty "\"$forty$forty\""
called 'an id of 81 bytes' $forty$forty... "\"$forty${forty}1\""
called 'an id cut where a character begins' "$forty$ten$ten${ten}123456789..." \
  "\"$forty$ten$ten${ten}123456789Ä\""
called 'an id cut before an escape' "${forty}${ten}${ten}${ten}1234567..." \
  "\"$forty$ten$ten${ten}1234567\\u001bxyz\""

unseen=$(bytes 342 200 256)
feed "{\"points$unseen\":[]}" planar -
expect 'the name of a field' 1 \
  "phspline: -:1: record 1: points\\xe2\\x80\\xae: is not a field of planar \
[unknown-field]
$(failed 1 1)"
feed "{\"points\":[[0,0],[1,1]],\"basis\":\"a$unseen\"}" planar -
expect 'the value of a field' 1 \
  "phspline: -:1: record 1: basis: must be \"ph\" or \"atph\", found \
\"a\\xe2\\x80\\xae\" [bad-value]
$(failed 1 1)"
printf '%s\n' "$good" >"a$unseen"
run planar -v "a$unseen"
equal 'a line of --verbose' 'phspline: a\xe2\x80\xae:1: record 1' \
  "$(sed 's/: [^:]*$//' err)"

called 'an id written in escapes' 'AÄ' '"\u0041\u00c4"'

printf '{"points":7,"extra":1,"id":"last"}' >a.json
run planar a.json
expect 'the first failure is told, with an id that comes last' 1 \
  "phspline: a.json:1: record last: extra: is not a field of planar \
[unknown-field]
$(failed 1 1)"

feed '{
 "id": 1,
 "points": [
  [0, 0],
  [0, 0]
 ]
}' planar -
expect 'the line of the element within a problem of many lines' 1 \
  "phspline: -:5: record 1: $bad_says
$(failed 1 1)"

feed '{"points":[],"meta":{"of": [1,2]}}' planar
expect 'meta is in the error record, too' 1 \
  "phspline: -:1: record 1: points: must be at least 2, found 0 \
[too-few-points]
$(failed 1 1)" \
  '{"command":"planar","status":"error","meta":{"of": [1,2]},"error":{'\
'"code":"too-few-points","message":"points must be at least 2, found 0",'\
'"field":"points","file":"-","line":1}}'

# ---- text that is no JSON ----------------------------------------------------

# broken STATUS LINE:COLUMN RECORD MESSAGE FILE TEXT: `syntax', with the number
# of records that come before; TEXT is one for printf.
broken() {
  # shellcheck disable=SC2059
  printf "$6" >"$5"
  run planar "$5"
  total=$(wc -l <out | tr -d ' ')
  expect "$6" "$1" \
    "phspline: $5:${2%:*}: record $3: $4 [syntax]
$(failed 1 "$total")"
  equal "record of $6" "$(error_record syntax '' "$4" "$5" "$2")" \
    "$(sed -n "$3p" out)"
}

g=$good'\n'
broken 1 2:21 2 'NaN is not JSON: numbers are finite' a.jsonl \
  "$g"'{"points":[[0,0],[1,NaN]]}\n'"$g"
broken 1 2:22 2 'Infinity is not JSON: numbers are finite' a.jsonl \
  "$g"'{"points":[[0,0],[1,-Infinity]]}\n'"$g"
broken 1 2:24 2 "expected a value, found ']'" a.jsonl \
  "$g"'{"points":[[0,0],[1,1],]}\n'"$g"
broken 1 2:25 2 "expected a name in double quotes, found '}'" a.jsonl \
  "$g"'{"points":[[0,0],[1,1]],}\n'"$g"
broken 1 2:25 2 "expected ',' or '}', found '/'; JSON has no comments" a.jsonl \
  "$g"'{"points":[[0,0],[1,1]] // two\n'"$g"
broken 1 2:21 2 "expected a value, found '.'" a.jsonl \
  "$g"'{"points":[[0,0],[1,.5]]}\n'"$g"
broken 1 2:21 2 "expected a value, found '+'" a.jsonl \
  "$g"'{"points":[[0,0],[1,+1]]}\n'"$g"
broken 1 2:22 2 'a number has no leading zero' a.jsonl \
  "$g"'{"points":[[0,0],[1,01]]}\n'"$g"
broken 1 2:23 2 "expected a digit, found ']'" a.jsonl \
  "$g"'{"points":[[0,0],[1,1.]]}\n'"$g"
broken 1 2:2 2 "expected a name in double quotes or '}', found \"'\"" a.jsonl \
  "$g"'{'"'points'"':[[0,0],[1,1]]}\n'"$g"
broken 1 2:2 2 "expected a name in double quotes or '}', found 'p'" a.jsonl \
  "$g"'{points:[[0,0],[1,1]]}\n'"$g"
broken 1 2:8 2 'the byte \xff is not UTF-8' a.jsonl "$g"'{"id":"\377"}\n'"$g"
broken 1 2:9 2 'the text ends inside a string' a.jsonl "$g"'{"id":"a\n'"$g"
broken 1 2:20 2 'the text ends inside an array' a.jsonl \
  "$g"'{"points":[[0,0],[1\n'"$g"
broken 1 2:1 2 'expected a value, found "solved"' a.jsonl "$g"'solved\n'"$g"
broken 1 2:1 2 "expected a value, found '}'" a.jsonl "$g"'}\n'"$g"
broken 3 1:1 1 'expected a value, found "solved"' a.json 'solved'
broken 3 1:20 1 'the text ends inside an array' a.json '{"points":[[0,0],[1'
broken 3 2:3 1 'the text ends inside an object' a.json '{"points":\n[]'
broken 3 2:1 2 "expected ',' or ']', found '{'" a.json \
  "[$good\\n$good]"

# ---- CSV ---------------------------------------------------------------------

skip='(--ignore-columns skips it)'
bad_csv 3 1:5 '' unknown-field "column \"speed\" is unknown to planar $skip" \
  'x,y,speed\n0,0,1\n1,1,1\n'
bad_csv 3 1:1 '' unknown-field \
  "column \"kont\" is unknown to planar; did you mean \"knot\"? $skip" \
  'kont,x,y\n0,0,1\n1,1,1\n'
bad_csv 3 1:5 '' unknown-field "column 3 has no name $skip" 'x,y,\n0,0,\n'
bad_csv 3 1:1 '' unknown-field "the file has no header row and 3 columns, and \
planar takes x and y (--columns=x,y,- skips the third)" '0,0,0\n1,1,0\n'
bad_csv 3 1:3 '' bad-value "columns 1 and 2 (\"X\") are the same (--columns can skip it)" \
  'x,X\n0,0\n1,1\n'
bad_csv 3 1:3 '' bad-value "columns 1 and 2 (\"x_m\") are the same (--columns can skip it)" \
  'x,x_m\n0,0\n1,1\n'
bad_csv 3 1:1 '' missing-field 'column "y" is missing: planar needs it for points' \
  'x\n0\n1\n'
bad_csv 3 1:1 '' missing-field 'column "x" is missing: planar needs it for points' \
  'id,y\na,0\na,1\n'
bad_csv 1 2 points missing-field "$missing" 'id\n""\n'
bad_csv 1 2 points missing-field "$missing" 'x,y\n,\n,\n'
bad_csv 1 2 'points[0]' bad-type 'needs a number in column y, found "high"' \
  'x,y\n0,high\n1,1\n'
bad_csv 1 3 'points[1]' bad-type 'needs a number in column x, found "0x1"' \
  'x,y\n0,0\n0x1,1\n'
bad_csv 1 3 'points[1]' bad-type 'needs a number in column y, found "1 2"' \
  'x,y\n0,0\n1,1 2\n'
bad_csv 1 3 'knots[1]' bad-type 'needs a number in column knot, found "one"' \
  'x,y,knot\n0,0,0\n1,1,one\n'
bad_csv 1 3 'points[1]' bad-value \
  'needs a number in column y, found an empty cell' 'x,y\n0,0\n1,\n2,0\n'
bad_csv 1 3 'knots[1]' bad-value \
  'needs a number in column knot, found an empty cell' \
  'x,y,knot\n0,0,0\n1,1,\n'
bad_csv 1 4 'knots[2]' bad-value \
  'must be greater than the knot before, 1, found 1' \
  'x,y,knot\n0,0,0\n1,1,1\n2,0,1\n'
bad_csv 1 3 '' bad-shape 'the row has 1 cells, expected 2' 'x,y\n0,0\n1\n'
bad_csv 1 2 '' bad-shape 'the row has 3 cells, expected 2' 'x,y\n0,0,0\n1,1\n'
bad_csv 3 1:1 '' bad-shape \
  'the row has 3 cells, but --columns names 2 (- skips a column)' \
  '0,0,0\n1,1,0\n' --columns=x,y
bad_csv 1 2 'points[0]' not-finite \
  'needs a finite number in column y, found "nan"' 'x,y\n0,nan\n1,1\n'
bad_csv 1 3 'points[1]' not-finite \
  'needs a finite number in column x, found "-inf"' 'x,y\n0,0\n-inf,1\n'
bad_csv 1 3 'points[1]' not-finite \
  'needs a finite number in column x, found "1e999"' 'x,y\n0,0\n1e999,1\n'
bad_csv 1 2 points too-few-points 'must be at least 2, found 1' 'x,y\n0,0\n'
bad_csv 1 4 'points[2]' coincident-points "coincides with points[1]$joins" \
  '# x,y\n0,0\n1,1\n1,1\n'
bad_csv 1 2 points too-few-points \
  'must be at least 3 different points for a closed curve, found 2' \
  'x,y\n0,0\n1,1\n' --closed
bad_csv 1 2 'end_derivatives[1]' zero-tangent 'must not be zero' \
  'x,y\n0,0\n1,1\n' '--end_derivatives=[[1,0],[0,0]]'
bad_csv 1 2 knots too-large 'span more than a double can hold' \
  'x,y\n-1.7e308,0\n1.7e308,0\n'
bad_csv 3 3:4 '' syntax \
  "expected ',' or the end of the row after a quoted cell, found 'z'" \
  'x,y\n0,0\n"1"z,1\n'
bad_csv 3 2:1 '' syntax 'the quote that begins this cell is never closed' \
  'x,y\n"0,0\n1,1\n'
bad_csv 3 1:1 '' syntax \
  'the file has no header row: --columns must name its 4 columns' \
  '0,0,1,1\n1,1,1,1\n'
bad_csv 1 2 id syntax 'has the byte \xff, which is not UTF-8' \
  'id,x,y\n\377,0,0\n\377,1,1\n'

printf 'solved\n' >text
run planar text
expect 'text that is neither JSON nor CSV' 3 \
  "phspline: text:1: record 1: expected JSON, or CSV with a header row, found \
\"solved\" [syntax]
$(failed 1 1)" \
  "$(error_record syntax '' \
    'expected JSON, or CSV with a header row, found "solved"' text 1:1)"

# ---- warnings ----------------------------------------------------------------

reversal='{"id":"r","points":[[0,0],[1,0],[0,0]]}'
loop='{"id":"l","points":[[0,0],[1,1]],"end_derivatives":[[0,-1],[-1,0]]}'
reversal_says='the data turn back by 180 degrees at points[1] (such points: 1): of two
mirror images the left turn was taken'
reversal_says=$(printf %s "$reversal_says" | tr '\n' ' ')
loop_says='segment 0 turns by 4.712 radians, more than half a turn (such
segments: 1)'
loop_says=$(printf %s "$loop_says" | tr '\n' ' ')

warned reversal reversal "$reversal_says" 1 "$reversal"
warned loop loop "$loop_says" 0 "$loop"

printf '%s' '{"points":[[0,0],[1,0],[0,0]],"end_derivatives":[[-1,-1],[-1,-1]]}' \
  >a.json
run planar a.json
equal 'two warnings' '"reversal" "loop"' \
  "$(get 'warnings[0].code') $(get 'warnings[1].code')"
run planar --strict a.json
equal 'two warnings: the first one is the error' '1 "reversal"' \
  "$status $(get error.code)"
