# SPDX-License-Identifier: GPL-3.0-or-later
#
# The distances up to which offsets are regular: cusps of offsets just before and
# just after them, circles, lines, and what verify says.
. "$srcdir/tests/cli/lib.sh"

# edge NAME COMMAND ARGUMENT...: no cusps just before both, some just after
edge() {
  name=$1
  shift
  run "$@" --offset-range
  expect "$name" 0 ''
  cp out record
  run verify record
  expect "$name: verified" 0
  sed -n 's/.*"offset_range":\[\([^],]*\),\([^],]*\)\].*/\1 \2/p' record >range
  for side in 1 2; do
    within=$(awk -v i=$side '{ printf "%.17g", $i * (1 - 1e-11) }' range)
    beyond=$(awk -v i=$side '{ printf "%.17g", $i * (1 + 1e-11) }' range)
    run "$@" -q "--offset=$within,$beyond"
    equal "$name: side $side" 'none some' "$(grep -o '"cusps":\[[^]]*\]' out |
      sed 's/.*segment.*/some/; s/.*\[\]/none/' | tr '\n' ' ' | sed 's/ $//')"
  done
}

edge 'a closed curve' planar --closed "$srcdir/data/coastline.csv"
edge 'with angles' planar --basis=atph --closed "$srcdir/data/coastline.csv"
printf '%s\n' '{"mode":"spline","points":[[0,0],[2,1],[3,-1],[5,2],[6,0]]}' >wave
edge 'cubics' tc wave
printf '%s\n' '{"closed":true,"points":[[8,-18],[-20,-8],[-10,11],[-12,-16],
  [16,11],[2,-20],[4,-17]]}' | tr -d '\n' >stop
edge 'the curve nearly stops' planar -q stop

feed '{"tolerance":0.01,"curve":[[[0,0],[1,0],[2,0],[3,0]]]}' tc --offset-range
expect 'a line' 0 ''
equal 'a line: all distances' null "$(get offset_range)"
cp out record
run verify record
expect 'a line: verified' 0
sed 's/"offset_range":null/"offset_range":[3,null]/' record >bad
run verify -q bad
equal 'a line: 3 is wrong' 1 "$status"

run planar --closed --offset-range "$srcdir/data/coastline.csv"
sed 's/"offset_range":\[1/"offset_range":[2/' out >bad
run verify bad
equal 'too far' 1 "$status"
# changed FACTOR: the first distance of the record in out, in bad
changed() {
  to=$(sed -n 's/.*"offset_range":\[\([^,]*\),.*/\1/p' out |
    awk -v by="$1" '{ printf "%.17g", $1 * by }')
  sed "s/\"offset_range\":\[[^,]*/\"offset_range\":[$to/" out >bad
  run verify -q bad
}

cp out whole
for basis in ph atph; do
  run planar --basis=$basis --closed --offset-range "$srcdir/data/coastline.csv"
  cp out whole
  changed 1.00000001
  equal "$basis: too far by 1e-8" 1 "$status"
  cp whole out
  changed 0.99999999
  equal "$basis: not as far by 1e-8" 1 "$status"
done
cp whole out
sed 's/"offset_range":\[\([^,]*\),[^]]*/"offset_range":[\1,null/' out >bad
run verify -q bad
equal 'without end' 1 "$status"
sed 's/"offset_range":\[/&0/; s/"offset_range":\[0[^,]*/"offset_range":[0/' out \
  >bad
run verify -q bad
equal 'nowhere' 1 "$status"
sed 's/"offset_range":\[/&-/' out >bad
run verify -q bad
equal 'to the other side' 1 "$status"

run spatial-hermite --offset-range
expect 'in space' 2 "phspline: --offset-range is of curves in the plane, and \
needs --format=json
Try 'phspline spatial-hermite --help'." ''
