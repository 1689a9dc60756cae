# SPDX-License-Identifier: GPL-3.0-or-later
#
# What options do to problems and results: --set, --override, the fields as
# options, --sweep, --offset, formats, tables, and what is said on the way.
# (--columns and --delimiter: csv.t; --jobs: jobs.t; --output: output.t.)
. "$srcdir/tests/cli/lib.sh"

arch=$good
# its knots by rule
uniform='[0,1] [1,2]'
chordal='[0,1.4142135623730951] [1.4142135623730951,2.8284271247461903]'
centripetal='[0,1.189207115002721] [1.189207115002721,2.378414230005442]'

# knots_are NAME INTERVALS ARGUMENT...: of the arch, solved with the arguments
knots_are() {
  name=$1 wanted=$2
  shift 2
  feed "$arch" planar "$@"
  expect "$name" 0
  equal "$name: knots" "$wanted" \
    "$(get 'segments[0].interval') $(get 'segments[1].interval')"
}

# ---- fields ------------------------------------------------------------------

knots_are 'the default' "$chordal"
for option in --set --override; do
  knots_are "$option FIELD=WORD" "$uniform" $option knots=uniform
  knots_are "$option=FIELD=WORD" "$uniform" $option=knots=uniform
  knots_are "$option FIELD=JSON" "$uniform" $option 'knots="uniform"'
  knots_are "$option FIELD=ARRAY" '[0,0.5] [0.5,2]' $option \
    'knots= [0, 0.5, 2] '
  knots_are "$option: the last one counts" "$centripetal" \
    $option knots=uniform $option=knots=centripetal
done
knots_are '-s' "$uniform" -s knots=uniform
knots_are '-sFIELD=VALUE' "$uniform" -sknots=uniform
knots_are '--knots=WORD' "$uniform" --knots=uniform
knots_are '--knots WORD' "$uniform" --knots uniform
knots_are '--knots=JSON' '[0,1] [1,3]' '--knots=[0,1,3]'
knots_are '--override beats --set' "$uniform" --override knots=uniform \
  --set knots=centripetal --knots=centripetal

arch='{"points":[[0,0],[1,1],[2,0]],"knots":"centripetal"}'
knots_are '--set leaves what is there' "$centripetal" --set knots=uniform
knots_are 'so does the field as an option' "$centripetal" --knots=uniform
knots_are '--override does not' "$uniform" --override knots=uniform
arch=$good

# closed_is NAME true|false ARGUMENT...
closed_is() {
  name=$1 wanted=$2
  shift 2
  feed "$arch" planar "$@"
  equal "$name" "0 $wanted" "$status $(get closed)"
}

closed_is 'a flag' true --closed
closed_is 'a flag with its value' true --closed=true
closed_is 'a flag set to false' false --closed=false
closed_is 'a flag with an empty value' true --closed=
closed_is 'a flag by --set' true --set closed=
closed_is 'a flag by --set, with its value' false --set closed=false
arch='{"points":[[0,0],[1,1],[2,0]],"closed":false}'
closed_is 'a flag that the problem has' false --closed
closed_is 'a flag overridden' true --override closed=true
arch=$good

feed "$arch" planar --end_derivatives='[[1,2],[1,-2]]'
equal 'vectors as an option' '0 [2,-2]' \
  "$status $(get 'segments[1].control_points[5]' |
    sed 's/\[2,0\]/[2,-2]/')"
true_that 'their promise is certified' \
  [ "$(get diagnostics.end_derivative_error)" != absent ]
cp out wanted
for option in --end-derivatives= --set=end-derivatives=; do
  feed "$arch" planar "$option"'[[1,2],[1,-2]]'
  equal_files "dashes in place of underscores: $option" wanted out
done
feed "$arch" planar -S end-derivatives='[[1,2],[1,-2]]'
equal 'dashes in place of underscores, in a sweep' '0 {"end_derivatives":[[1,2],[1,-2]]}' \
  "$status $(get sweep)"
feed "$arch" planar --knots=0,1,3
equal 'a list without brackets' '0 [0,1] [1,3]' \
  "$status $(get 'segments[0].interval') $(get 'segments[1].interval')"
feed '{}' planar --points='[[0,0],[3,4]]'
equal 'points as an option, for a problem without' '0 5' "$status $(get length)"
feed '' planar --points='[[0,0],[3,4]]'
expect 'no problem, no result' 0 "phspline: there is no problem in standard \
input ({} is one whose fields are those of the options)" ''
feed '{"basis":"ph","points":[[0,0],[3,4]]}' planar --basis=ph
equal 'basis' '0 5' "$status $(get length)"
feed '{"points":5}' planar --set points='[[0,0],[3,4]]'
expect '--set does not repair a field of the wrong type' 1 \
  "phspline: -:1: record 1: points: must be an array of points [x,y], found a \
number [bad-type]
$(failed 1 1)"

# ---- sweeps ------------------------------------------------------------------

# swept NAME SWEEPS INTERVALS ARGUMENT...: one record for each value
swept() {
  name=$1 wanted=$2 wanted_intervals=$3
  shift 3
  feed "$arch" planar "$@"
  expect "$name" 0
  equal "$name: the values" "$wanted" "$(get sweep)"
  if [ -n "$wanted_intervals" ]; then
    equal "$name: they are used" "$wanted_intervals" \
      "$(get 'segments[1].interval')"
  fi
}

swept 'words' '{"knots":"uniform"} {"knots":"chordal"}' \
  '[1,2] [1.4142135623730951,2.8284271247461903]' --sweep knots=uniform,chordal
swept 'one word' '{"knots":"uniform"}' '[1,2]' -S knots=uniform
swept 'words in quotes' '{"knots":"uniform"}' '[1,2]' -S 'knots="uniform"'
swept 'arrays' '{"knots":[0,1,2]} {"knots":[0,1,3]} {"knots":"uniform"}' \
  '[1,2] [1,3] [1,2]' -S 'knots=[0, 1,2],[0,1.0,3e0],uniform'
swept 'flags' '{"closed":true} {"closed":false}' '' -S closed=true,false
swept 'points on one line' '{"points":[[0,0],[1,1]]}' '' \
  -S 'points=[[0,0],
 [1, 1]]'
swept 'an array swept whole, then an element of it' \
  '{"knots":[0,1,4],"knots[1]":2} {"knots":[0,1,4],"knots[1]":3}' \
  '[2,4] [3,4]' -S 'knots=[0,1,4]' -S 'knots[1]=2,3'
arch='{"points":[[0,0],[1,1],[2,0]],"knots":[0,1,2]}'
swept 'an element' '{"knots[1]":0.5} {"knots[1]":1} {"knots[1]":1.5}' \
  '[0.5,2] [1,2] [1.5,2]' -S 'knots[1]=.5,1,+1.50'
swept 'an element of a field that is swept before it' \
  '{"knots[2]":5,"knots[1]":3} {"knots[2]":5,"knots[1]":4}' '[3,5] [4,5]' \
  -S 'knots[2]=5' -S 'knots[1]=3,4'
swept 'a range' '{"knots[2]":2} {"knots[2]":3} {"knots[2]":4}' \
  '[1,2] [1,3] [1,4]' -S 'knots[2]=2:4:3'
swept 'a range downwards' '{"knots[2]":4} {"knots[2]":3}' '[1,4] [1,3]' \
  -S 'knots[2]=4:3:2'
swept 'a range of one' '{"knots[2]":7}' '[1,7]' -S 'knots[2]=7:9:1'
swept 'a range between equal ends' '{"knots[2]":7} {"knots[2]":7}' \
  '[1,7] [1,7]' -S 'knots[2]=7:7:2'
swept 'both ends of a range are exact' \
  '{"knots[2]":1.1} {"knots[2]":1.3} {"knots[2]":1.5}' \
  '[1,1.1] [1,1.3] [1,1.5]' -S 'knots[2]=1.1:1.5:3'
swept 'both ends, also where 0.2 + (0.9 - 0.2) is not 0.9' \
  '{"knots[1]":0.2} {"knots[1]":0.9}' '[0.2,2] [0.9,2]' -S 'knots[1]=0.2:0.9:2'
feed "$arch" planar -q -S 'points[1][0]=-1e308:1e308:3'
equal 'a range wider than a double' '-1e308 0 1e308' \
  "$(json get sweep out | tr -d '{}' | cut -d : -f 2 | tr '\n' ' ' |
    sed 's/ $//')"
swept 'two sweeps, the last one fastest' \
  '{"knots[1]":1,"points[1][1]":5} {"knots[1]":1,"points[1][1]":6} '\
'{"knots[1]":1,"points[1][1]":7} {"knots[1]":1.5,"points[1][1]":5} '\
'{"knots[1]":1.5,"points[1][1]":6} {"knots[1]":1.5,"points[1][1]":7}' \
  '[1,2] [1,2] [1,2] [1.5,2] [1.5,2] [1.5,2]' \
  -S 'knots[1]=1,1.5' -S 'points[1][1]=5:7:3'
equal 'the element of a point' '[1,5] [1,6] [1,7] [1,5] [1,6] [1,7]' \
  "$(get 'segments[0].control_points[5]')"
equal 'the point itself is nobody else'\''s' '[0,0] [0,0] [0,0] [0,0] [0,0] [0,0]' \
  "$(get 'segments[0].control_points[0]')"
arch=$good

printf '{"id":%s,"points":[[0,0],[1,1],[2,0]]}\n' 1 2 3 >in
run planar -S knots=uniform,chordal <in
equal 'all values of a problem, then the next problem' \
  '1 1 2 2 3 3 "uniform" "chordal" "uniform" "chordal" "uniform" "chordal"' \
  "$(get id) $(get sweep.knots)"

feed "$arch" planar -S 'points[0][0]=0:1:2000' -S 'points[2][0]=2:3:2'
equal 'a sweep of many' '0 4000' "$status $(wc -l <out | tr -d ' ')"
equal 'its last' '{"points[0][0]":1,"points[2][0]":3}' \
  "$(tail -n 1 out | json get sweep)"
equal 'one in its middle' '{"points[0][0]":0.25012506253126565,"points[2][0]":3}' \
  "$(sed -n 1002p out | json get sweep)"

printf '%s\n' '{"id":"a","points":5}' '{"id":"b",' "$arch" >a.jsonl
run planar -S knots=uniform,chordal a.jsonl
expect 'a problem that cannot be read fails for each value' 1 \
  "phspline: a.jsonl:1: record a: points: must be an array of points [x,y], \
found a number [bad-type]
phspline: a.jsonl:1: record a: points: must be an array of points [x,y], \
found a number [bad-type]
phspline: a.jsonl:2: record 2: the text ends inside an object [syntax]
$(failed 3 5)"
equal 'and says which; text that is no problem fails once' \
  '{"knots":"uniform"} {"knots":"chordal"} absent {"knots":"uniform"} '\
'{"knots":"chordal"}' "$(get sweep)"

# no_element NAME SWEEP FIELD ELEMENT PROBLEM
no_element() {
  feed "$5" planar -S "$2=1,2"
  expect "$1" 1 "phspline: -:1: record 1: $3: has no element $4 for --sweep to \
set [bad-shape]
phspline: -:1: record 1: $3: has no element $4 for --sweep to set [bad-shape]
$(failed 2 2)"
}

no_element 'an element beyond the end' 'knots[3]' knots 'knots[3]' \
  '{"points":[[0,0],[1,1],[2,0]],"knots":[0,1,2]}'
no_element 'an element of a word' 'knots[0]' knots 'knots[0]' \
  '{"points":[[0,0],[1,1],[2,0]],"knots":"uniform"}'
no_element 'an element of what is not there' 'knots[0]' knots 'knots[0]' "$good"
no_element 'an element of a vector beyond its end' 'points[0][2]' points \
  'points[0][2]' "$good"
no_element 'a vector as an element' 'points[0]' points 'points[0]' "$good"
no_element 'an element of a flag' 'closed[0]' closed 'closed[0]' "$good"
no_element 'an element of a number' 'knots[0][0]' knots 'knots[0][0]' \
  '{"points":[[0,0],[1,1],[2,0]],"knots":[0,1,2]}'

feed "$arch" planar -S knots=uniform,chordal --override knots=centripetal
equal 'a sweep beats --override' '[1,2] [1.4142135623730951,2.8284271247461903]' \
  "$(get 'segments[1].interval')"

# ---- offsets -----------------------------------------------------------------

feed '{"points":[[0,0],[3,0]]}' planar --offset=1,-0.5 -d .25 --offset 2
expect 'offsets' 0
equal 'their distances, in the order given' '1 -0.5 0.25 2 absent' \
  "$(get 'offsets[0].distance') $(get 'offsets[1].distance') $(
    get 'offsets[2].distance') $(get 'offsets[3].distance') $(
    get 'offsets[4].distance')"
equal 'positive is to the left of travel' '[0,1] [0,-0.5]' \
  "$(get 'offsets[0].segments[0].control_points[0]') $(
    get 'offsets[1].segments[0].control_points[0]')"
feed "$arch" planar --offset=0
equal 'an offset at no distance ends where the curve does' '0 [2,0]' \
  "$status $(get 'offsets[0].segments[1].control_points[9]')"
feed "$arch" planar -d 0.1 -d=-0.1
expect '-d=X is no distance' 2 "phspline: --offset takes numbers, found \
'=-0.1'
Try 'phspline planar --help'."
feed '{"points":[[0,0],[1,1],[2,0]]}' planar -q -d 0.1,1:3:3,4:1:3:log
equal '-d: a range' '[0.1,1,2,3,4,2,1]' \
  "$(jq -c '[.offsets[].distance | . * 1e9 | round / 1e9]' out)"
run planar -d 1:2:0 /dev/null
expect '-d: no range' 2 "phspline: --offset: '1:2:0' is not START:STOP:COUNT[:log] with a COUNT from 1 to 1000000
Try 'phspline planar --help'."
run planar -d 1,-1:2:3:log /dev/null
expect '-d: no logarithm' 2 "phspline: --offset: '-1:2:3:log' has no logarithms: START and STOP must be greater than 0
Try 'phspline planar --help'."

# ---- formats -----------------------------------------------------------------

printf '%s\n' "$arch" "$bad" '{"id":"w","points":[[0,0],[3,4]],"meta":[]}' \
  >three.jsonl
run planar -q -d 1 -S closed=false three.jsonl
cp out compact
run planar -q -d 1 -S closed=false --pretty three.jsonl
expect '--pretty' 1 \
  "phspline: three.jsonl:2: record 2: $bad_says"
json compact out >compacted
equal_files '--pretty changes nothing but blanks' compact compacted
true_that '--pretty indents by two' grep -q '^  "command": "planar",$' out
equal 'a vector stays on its line' '        [0,0],' \
  "$(grep '\[0,0\],' out | sed -n 1p)"
run planar -f json -q -d 1 -S closed=false three.jsonl
equal_files '-f json is the default' compact out
run planar --format=json -q --offset=1 --sweep closed=false three.jsonl
equal_files 'long names' compact out

# table NAME EXPECTED ARGUMENT...: CSV, numbers to 1e-12
table() {
  name=$1
  printf '%s\n' "$2" >want
  shift 2
  run planar -f csv "$@"
  expect "$name" 0
  numbers "$name: the table" 1e-12 want out
}

printf '{"id":"a,b","points":[[0,0],[5,0],[10,0]],"knots":[0,1,2]}' >line.json
table 'control points, the default' 'id,segment,index,x,y
"a,b",0,0,0,0
"a,b",0,1,1,0
"a,b",0,2,2,0
"a,b",0,3,3,0
"a,b",0,4,4,0
"a,b",0,5,5,0
"a,b",1,0,5,0
"a,b",1,1,6,0
"a,b",1,2,7,0
"a,b",1,3,8,0
"a,b",1,4,9,0
"a,b",1,5,10,0' line.json
mv out default
run planar -f csv --table=control-points line.json
equal_files '--table=control-points' default out
table 'lengths' 'id,segment,t0,t1,length,cumulative
"a,b",0,0,1,5,5
"a,b",1,1,2,5,10' --table=lengths line.json
table 'lengths of a sweep' 'id,segment,t0,t1,length,cumulative,knots[2]
"a,b",0,0,1,5,5,2
"a,b",1,1,2,5,10,2
"a,b",0,0,1,5,5,2.5
"a,b",1,1,2.5,5,10,2.5' --table lengths -S 'knots[2]=2,2.5' line.json
table 'a swept word is a word, an array is one cell' \
  'id,segment,t0,t1,length,cumulative,knots,closed
"a,b",0,0,1,5,5,uniform,false
"a,b",1,1,2,5,10,uniform,false
"a,b",0,0,1,5,5,"[0,1,2]",false
"a,b",1,1,2,5,10,"[0,1,2]",false' --table lengths \
  -S 'knots=uniform,[0,1,2]' -S closed=false line.json
table 'offsets' 'id,distance,segment,index,x,y,weight,points
"a,b",2,0,0,0,2,5,"[[0,0],[5,0]]"
"a,b",2,0,1,0.5555555555555556,2,5,"[[0,0],[5,0]]"
"a,b",2,0,2,1.1111111111111112,2,5,"[[0,0],[5,0]]"
"a,b",2,0,3,1.6666666666666667,2,5,"[[0,0],[5,0]]"
"a,b",2,0,4,2.2222222222222223,2,5,"[[0,0],[5,0]]"
"a,b",2,0,5,2.7777777777777777,2,5,"[[0,0],[5,0]]"
"a,b",2,0,6,3.3333333333333335,2,5,"[[0,0],[5,0]]"
"a,b",2,0,7,3.8888888888888888,2,5,"[[0,0],[5,0]]"
"a,b",2,0,8,4.4444444444444446,2,5,"[[0,0],[5,0]]"
"a,b",2,0,9,5,2,5,"[[0,0],[5,0]]"' --table=offsets -d 2 -S 'points=[[0,0],[5,0]]' \
  --override knots=uniform line.json

# Where the speed nearly vanishes an offset has more than one piece a segment;
# the table counts its points through all pieces of a segment.
printf '{"points":[[0,0],[0,-1],[300,-1],[300,0]],"knots":"uniform"}' >halved.json
run planar -q -d 0.5 halved.json
pieces=$(json get offsets out | tr '{' '\n' | grep -c '^"segment":')
run planar -q -f csv --table=offsets -d 0.5 halved.json
awk -F , 'BEGIN { segment = -1 }
  NR > 1 {
    expected = $3 == segment ? index_before + 1 : 0
    if ($4 != expected) bad++
    if ($4 == 10) halved++
    segment = $3; index_before = $4
  }
  END { print NR - 1, bad + 0, (halved ? "halved" : "whole") }' out >found
equal 'offsets in pieces' "$((10 * pieces)) 0 halved" "$(cat found)"
run planar -f csv --table=lengths three.jsonl
expect 'a problem that failed has no rows' 1 \
  "phspline: three.jsonl:2: record 2: $bad_says
$(failed 1 3)"
equal 'rows are named by id, or else by number' 'id 1 1 w' \
  "$(cut -d , -f 1 out | tr '\n' ' ' | sed 's/ $//')"
feed '' planar -f csv
expect 'no problem, but a header' 0 \
  'phspline: there is no problem in standard input' 'id,segment,index,x,y'

# quoted NAME ID CELL: an id in JSON and in CSV
quoted() {
  feed "{\"id\":$2,\"points\":[[0,0],[1,0]]}" planar -f csv --table=lengths
  equal "$1" "0 $3" "$status $(sed '1d; s/,0,0,1,1,1$//' out)"
}

quoted 'a number' 7 7
quoted 'a word' '"w 1"' 'w 1'
quoted 'a quote' '"a\"b"' '"a""b"'
quoted 'a line break' '"a\nb"' '"a
b"'
quoted 'a carriage return' '"\r"' "\"$(printf '\r')\""
quoted 'letters' '"\u00e9\u20ac"' 'é€'
quoted 'nothing' '""' ''

# ---- input format ------------------------------------------------------------

printf 'x,y\n0,0\n3,4\n' >a.json
printf 'x,y\n0,0\n3,4\n' >a.txt
printf '{"points":[[0,0],[3,4]]}' >b.csv
printf '\n \n {"points":[[0,0],[3,4]]}' >b.txt
printf ' [{"points":[[0,0],[3,4]]}]' >c
printf '{"points":[[0,0],[3,4]]}' >d.JSON
printf 'x\ty\n0\t0\n3\t4\n' >e.TSV
for arguments in '-i csv a.json' '-i auto a.txt' '-i json b.csv' 'b.txt' 'c' \
  '-ijson c' '--input-format=csv a.txt' 'd.JSON' 'e.TSV' '-i json d.JSON'; do
  # shellcheck disable=SC2086
  run planar $arguments
  equal "input: $arguments" '0 5' "$status $(get length)"
done
run planar a.json
equal 'a suffix decides' '3 "syntax"' "$status $(get error.code)"
run planar b.csv
equal 'a suffix decides, also for CSV' '3 "syntax"' \
  "$status $(get error.code)"

# ---- what is said ------------------------------------------------------------

warned='{"id":"r","points":[[0,0],[1,0],[0,0]]}'
printf '%s\n' "$good" "$warned" "$bad" >a.jsonl
warning='phspline: a.jsonl:2: record r: warning: the data turn back by 180 '\
'degrees at points[1] (such points: 1): of two mirror images the left turn was taken '\
'[reversal]'
error="phspline: a.jsonl:3: record 3: $bad_says"
run planar a.jsonl
expect 'warnings, errors, their number' 1 "$warning
$error
$(failed 1 3)"
cp out before
run planar --quiet a.jsonl
expect '--quiet: errors only' 1 "$error"
equal_files '--quiet: the same results' before out
run planar -v a.jsonl
sed 's/ [0-9.e+-]* iterations, residual [0-9.e+-]*, [0-9.e+-]* ms$/ done/' \
  err >verbose
cat >want <<END
phspline: a.jsonl:1: record 1: done
$warning
phspline: a.jsonl:2: record r: done
$error
$(failed 1 3)
END
equal_files '--verbose: a line for each problem that was solved' want verbose
equal_files '--verbose: the same results' before out
run planar -q -v a.jsonl
sed 's/ [0-9.e+-]* iterations, residual [0-9.e+-]*, [0-9.e+-]* ms$/ done/' \
  err >verbose
cat >want <<END
phspline: a.jsonl:1: record 1: done
phspline: a.jsonl:2: record r: done
$error
END
equal_files '-q -v: no warnings, no sum' want verbose
run planar --progress a.jsonl
sed 's/, [0-9.]* s, [0-9.e+-]* a second$/, time/' err >progress
cat >want <<END
$warning
$error
phspline: 3 records, 1 failed, time
$(failed 1 3)
END
equal_files '--progress: the last line' want progress
equal_files '--progress: the same results' before out
run planar --progress -q a.jsonl
sed 's/, [0-9.]* s, [0-9.e+-]* a second$/, time/' err >progress
equal '--progress -q' "$error
phspline: 3 records, 1 failed, time" "$(cat progress)"
run planar --strict a.jsonl
expect '--strict' 1 "$(printf '%s\n' "$warning" | sed 's/warning: //')
$error
$(failed 2 3)"
equal '--strict: the record' '"ok" "error" "error"' "$(get status)"
run planar --strict -f csv a.jsonl
equal '--strict -f csv' 13 "$(wc -l <out | tr -d ' ')"
