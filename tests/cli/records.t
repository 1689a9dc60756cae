# SPDX-License-Identifier: GPL-3.0-or-later
#
# The shape of result records: valid JSON, one on a line, exactly the fields
# that the manual lists, in its order, and numbers that fit each other.
. "$srcdir/tests/cli/lib.sh"

# ---- fields ------------------------------------------------------------------

begin='command:string,status:string'
curve='curve:string,dimension:number,degree:number,closed:bool,segments:[{'\
'interval:[number],control_points:[[number]],preimage:[[number]],'\
'length:number}],length:number'
offsets='offsets:[{distance:number,degree:number,segments:[{segment:number,'\
'interval:[number],control_points:[[number]],weights:[number]}],cusps:['
fairness='loops:number,simple:bool,energy:number,MV:number,IES:number,'\
'IMV:number,rotation_index:number,absolute_rotation_index:number'
kantorovich='kantorovich:{B:number,C:number,K:number,h:number,'\
'radius:number,certified:bool}'
diagnostics='diagnostics:{iterations:number,residual:number,'\
'interpolation_error:number,pythagorean_error:number,'\
"continuity_error:number,length_error:number,$fairness,$kantorovich}"
diagnostics_ends='diagnostics:{iterations:number,residual:number,'\
'interpolation_error:number,end_derivative_error:number,'\
'pythagorean_error:number,continuity_error:number,'\
"length_error:number,$fairness,$kantorovich}"
warnings='warnings:[{code:string,segment:number,message:string}]'
error='error:{code:string,message:string,file:string,line:number}'
error_field='error:{code:string,message:string,field:string,file:string,'\
'line:number}'
error_column='error:{code:string,message:string,file:string,line:number,'\
'column:number}'

# shape NAME STATUS FIELDS TEXT [ARGUMENT...]: of the one record, also indented
shape() {
  name=$1 wanted=$2 wanted_shape="{$3}"
  printf '%s\n' "$4" >in
  shift 4
  for pretty in '' --pretty; do
    # shellcheck disable=SC2086
    run planar -q "$@" $pretty <in
    equal "$name $pretty" "$wanted $wanted_shape" "$status $(json shape out)"
  done
  run planar -q "$@" <in
  true_that "$name: a line of JSON" json lines out
}

points='"points":[[0,0],[1,1],[2,0]]'
shape 'a curve' 0 "$begin,$curve,$diagnostics" "{$points}"
shape 'a closed curve' 0 "$begin,$curve,area:number,$diagnostics" \
  "{$points,\"closed\":true}"
shape 'a curve with end derivatives' 0 "$begin,$curve,$diagnostics_ends" \
  "{$points,\"end_derivatives\":[[1,1],[1,0]]}"
shape 'a number as id' 0 "id:number,$begin,$curve,$diagnostics" \
  "{$points,\"id\":1}"
shape 'a string as id' 0 "id:string,$begin,$curve,$diagnostics" \
  "{\"id\":\"1\",$points}"
shape 'meta' 0 "id:number,$begin,meta:{a:[number|null],b:{}},$curve,$diagnostics" \
  "{\"meta\": {\"a\" :[1,null], \"b\":{}},\"id\":1,$points}"
shape 'meta of no object' 0 "$begin,meta:bool,$curve,$diagnostics" \
  "{\"meta\":false,$points}"
shape 'offsets' 0 "$begin,$curve,$offsets],gaps:[]}],$diagnostics" "{$points}" \
  --offset=0.5,-0.5
shape 'a warning' 0 "$begin,$curve,$diagnostics,$warnings" \
  '{"points":[[0,0],[1,0],[0,0]]}'
shape 'a sweep' 0 \
  "id:number,$begin,meta:number,sweep:{knots:string},$curve,$diagnostics" \
  "{\"id\":1,\"meta\":2,$points}" --sweep knots=uniform
shape 'all at once' 0 "id:number,$begin,meta:[],sweep:{points[0][0]:number,\
knots:string},$curve,$offsets{segment:number,t:number}],gaps:[]}],$diagnostics,$warnings" \
  '{"id":1,"meta":[],"points":[[0,0],[1,0],[0,0]]}' --offset=1 \
  --sweep 'points[0][0]=0' --sweep knots=chordal
shape 'an error' 1 "$begin,$error" 7 --input-format=json
shape 'an error in a field' 1 "id:string,$begin,meta:{},$error_field" \
  '{"id":"a","meta":{},"points":[]}'
shape 'an error in a sweep' 1 "$begin,sweep:{closed:bool},$error_field" \
  '{"points":[]}' --sweep closed=true
shape 'an error at a column' 3 "$begin,$error_column" '{"points":]'
shape 'a warning under --strict' 1 "$begin,$error" \
  '{"points":[[0,0],[1,0],[0,0]]}' --strict

feed "{\"id\":\"a\\u0000\\n\\\"b\",\"meta\":{\"\\u00e9\": \"é\\\\\",  \
\"deep\":[[[[[1e-7,1E5,-0.0]]]]]},$points}" planar
equal 'id and meta are passed on as they were written' \
  '"a\u0000\n\"b" {"\u00e9": "é\\",  "deep":[[[[[1e-7,1E5,-0.0]]]]]}' \
  "$(get id) $(get meta)"
feed "{\"meta\": {
  \"a\" : [1,
 2 ], \"b c\": \"d  e\"
}, $points}" planar
true_that 'meta of many lines' json lines out
equal 'meta of many lines is put on one' '{"a":[1,2],"b c":"d  e"}' \
  "$(get meta)"
nasty=$(printf 'a"b\\c\td\303\244\033')
printf '%s\n' "$bad" >"$nasty"
run planar "$nasty"
true_that 'a file name that JSON must escape' json lines out
equal 'the file name' '"a\"b\\c\u0009dä\u001b"' "$(get error.file)"
nasty=$(printf 'a\377b')
if printf '%s\n' "$bad" 2>cmd.out >"$nasty"; then
  run planar "$nasty"
  true_that 'a file name that is no UTF-8' json lines out
else
  echo 'skip a file name that is no UTF-8: the file system refuses it'
fi

# ---- values ------------------------------------------------------------------

equal_values() {
  equal "$1: constants" '"planar" "ok" "ph" 2 5' \
    "$(get command) $(get status) $(get curve) $(get dimension) $(get degree)"
}

# segment K: what has to hold within a segment: it joins its knots' points, its
# end derivatives are the squares of the ends of the preimage, and its length
# lies between its chord and its control polygon.
segment() {
  {
    floats "segments[$1].control_points"
    floats "segments[$1].preimage"
    floats "segments[$1].length"
  } | awk '
    function near(a, b) { d = a - b; return d * d < 1e-24 }
    function apart(i, j) {
      return sqrt((p[2*i] - p[2*j]) ^ 2 + (p[2*i+1] - p[2*j+1]) ^ 2)
    }
    { p[NR - 1] = $1 }
    END {
      if (NR != 19) { print NR " numbers"; exit 1 }
      for (i = 0; i < 5; i++) polygon += apart(i, i + 1)
      if (!near(5 * (p[2] - p[0]), p[12] ^ 2 - p[13] ^ 2) ||
          !near(5 * (p[3] - p[1]), 2 * p[12] * p[13]) ||
          !near(5 * (p[10] - p[8]), p[16] ^ 2 - p[17] ^ 2) ||
          !near(5 * (p[11] - p[9]), 2 * p[16] * p[17])) {
        print "the preimage is no root of the hodograph"; exit 1
      }
      if (p[18] < apart(0, 5) * (1 - 1e-14) || p[18] > polygon) {
        print "length " p[18] " of " apart(0, 5) " to " polygon; exit 1
      }
    }'
}

feed '{"points":[[0,0],[1,1],[2,0],[4,1]]}' planar --offset=0.25
equal_values 'an open curve'
equal 'as many segments as intervals' '[2,0] [4,1] absent' \
  "$(get 'segments[2].control_points[0]') $(
    get 'segments[2].control_points[5]') $(get 'segments[3]')"
for k in 0 1 2; do
  true_that "segment $k: its numbers fit each other" segment $k
done
equal 'segments meet' \
  "$(get 'segments[0].control_points[5]') $(get 'segments[1].interval[0]')" \
  "$(get 'segments[1].control_points[0]') $(get 'segments[0].interval[1]')"
json get length out >want
{
  floats 'segments[0].length'
  floats 'segments[1].length'
  floats 'segments[2].length'
} | awk '{ sum += $1 } END { printf "%.17g\n", sum }' >found
numbers 'the length is the sum of lengths' 1e-15 want found
for name in residual interpolation_error pythagorean_error continuity_error \
  length_error; do
  true_that "$name is small" \
    awk -v x="$(get diagnostics.$name)" 'BEGIN { exit !(x + 0 < 1e-12) }'
done
equal 'an offset: degree, pieces, parts' '0.25 9 2 [0,1] absent' \
  "$(get 'offsets[0].distance') $(get 'offsets[0].degree') $(
    get 'offsets[0].segments[2].segment') $(
    get 'offsets[0].segments[2].interval') $(get 'offsets[0].segments[3]')"
equal 'an offset: ten points and weights' '20 10' \
  "$(floats 'offsets[0].segments[1].control_points' | wc -l | tr -d ' ') $(
    floats 'offsets[0].segments[1].weights' | wc -l | tr -d ' ')"

feed '{"points":[[0,0],[1,1],[2,0],[0,0]],"closed":true}' planar
equal_values 'a closed curve'
equal 'a closed curve: a segment leads back, the repeated point is dropped' \
  'true [2,0] [0,0] absent' \
  "$(get closed) $(get 'segments[2].control_points[0]') $(
    get 'segments[2].control_points[5]') $(get 'segments[3]')"
for k in 0 1 2; do
  true_that "closed, segment $k: its numbers fit each other" segment $k
done

# A straight line on uniform knots is known to the last digit.
feed '{"points":[[0,0],[5,0],[10,0]],"knots":[0,1,2]}' planar
cat >want <<'END'
{"command":"planar","status":"ok","curve":"ph","dimension":2,"degree":5,"closed":false,"segments":[{"interval":[0,1],"control_points":[[0,0],[1,0],[2,0],[3,0],[4,0],[5,0]],"preimage":[[2.23606797749979,0],[2.23606797749979,0],[2.23606797749979,0]],"length":5},{"interval":[1,2],"control_points":[[5,0],[6,0],[7,0],[8,0],[9,0],[10,0]],"preimage":[[2.23606797749979,0],[2.23606797749979,0],[2.23606797749979,0]],"length":5}],"length":10,
END
json get diagnostics out | awk '{ print "\"diagnostics\":" $0 "}" }' >tail.json
tr -d '\n' <want | cat - tail.json >want.json
numbers 'a straight line, all of it' 1e-14 want.json out

# The arch of the examples: its length was checked by quadrature.
feed "$good" planar
echo 2.9671231267287768 >want
json get length out >found
numbers 'the length of an arch' 1e-14 want found
