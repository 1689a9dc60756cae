# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cone --panorama': volumes on surfaces, laid flat.
#
# shellcheck disable=SC2016  # programs of jq and awk
. "$srcdir/tests/cli/lib.sh"

run cone --panorama=x.png </dev/null
case $(cat err) in
*'without teem'*)
  expect 'without teem' 2 "phspline: --panorama: this phspline was built \
without teem: install libteem-dev (Debian, Ubuntu) or teem (elsewhere) and \
build it again
Try 'phspline cone --help'." ''
  echo 'skip volumes: built without teem'
  exit
  ;;
esac

# lattice EXPRESSION HEADER...: a volume of 7 x 6 x 5 points, as text
lattice() {
  value=$1
  shift
  printf '%s\n' NRRD0004 'type: double' 'dimension: 3' 'sizes: 7 6 5' \
    'encoding: ascii' "$@" ''
  awk "BEGIN { for (k = 0; k < 5; k++) for (j = 0; j < 6; j++)
    for (i = 0; i < 7; i++) printf \"%.17g\\n\", $value }"
}

# a piece of a cone, in the box from -1, -2, -1 to 5, 3, 3
cat >part.json <<'EOF'
{"points":[[2,0,0],[1.5,1.25,0.25],[0.5,2,0.5]],
"rulings":[[-0.6,0,0.8],[-0.5,-0.3,0.8],[-0.2,-0.5,0.8]],
"tangents":[[0,1,0],[-0.5,0.8333333333333333,0],[-1,0.4,0]],"height":[0,1.5]}
EOF
linear='3 * x - 2 * y + 0.5 * z + 7'

# exact NAME: what the panorama out.nrrd has is linear where the surface is
exact() {
  sed '1,/^$/d' out.nrrd | od -An -v -tf8 | tr -s ' ' '\n' | sed '/^$/d' |
    jq -s . >values.json
  jq -c '.panorama as $p | {flat: [range($p.height) as $j |
    range($p.width) as $i | [$p.origin[0] + $i / $p.resolution,
    $p.origin[1] - $j / $p.resolution]]}' out >flat.json
  jq -cs '.[0] + .[1]' part.json flat.json >located.json
  run cone -q located.json
  true_that "$1: all values" jq -es '.[0] as $v | .[1] as $r |
    ($r.located | length > 500) and all($r.located[];
    .point as [$x, $y, $z] | $v[.index] - ('"$(echo "$linear" |
    sed 's/\([xyz]\)/$\1/g')"') | fabs < 1e-13)' values.json out
  true_that "$1: the rest is filled" jq -es '.[0] as $v | .[1] as $r |
    ($v | map(select(. == -9)) | length) == ($v | length) -
    ($r.located | length)' values.json out
}

lattice "3 * (i - 1) - 2 * (j - 2) + 0.5 * (k - 1) + 7" 'spacings: 1 1 1' \
  'axis mins: -1 -2 -1' 'centerings: node node node' >linear.nrrd

# teem is loaded for volumes alone, and it is told where it cannot be
name=$(grep -ao 'libteem[.][.a-z0-9]*' "$PHSPLINE" | head -n 1)
if [ -n "$name" ]; then
  mkdir broken
  : >"broken/$name"
  true_that 'no volume, no teem' env LD_LIBRARY_PATH="$PWD/broken" \
    "$PHSPLINE" cone -q part.json
  status=0
  LD_LIBRARY_PATH=$PWD/broken "$PHSPLINE" cone -q --volume=linear.nrrd \
    --panorama=out.nrrd --resolution=20 part.json >out 2>err || status=$?
  true_that 'a teem that cannot be loaded' \
    grep -q '^phspline: volumes need the library teem: .*libteem' err
  equal 'its exit status' "$status" 3
fi

run cone -q --volume=linear.nrrd --panorama=out.nrrd --resolution=20 --fill=-9 \
  part.json
expect 'a linear volume' 0
true_that 'a linear volume: its panorama' jq -e '.panorama | .resolution == 20 and
  .outside == 0 and .points > 500 and .range[0] < .range[1]' out
exact 'a linear volume'

# the same turned and sheared: x = 5 - i + j/4, y = -4 + 3/2 j, z = -1 + k
lattice "3 * (5 - i + j / 4) - 2 * (-4 + 1.5 * j) + 0.5 * (k - 1) + 7" \
  'space dimension: 3' 'space directions: (-1,0,0) (0.25,1.5,0) (0,0,1)' \
  'space origin: (5,-4,-1)' >sheared.nrrd
run cone -q --volume=sheared.nrrd --panorama=out.nrrd --resolution=20 --fill=-9 \
  part.json
expect 'a sheared volume' 0
exact 'a sheared volume'

# cells: the first point is half a spacing behind the minimum
lattice "3 * (i - 0.5) - 2 * (j - 1.5) + 0.5 * (k - 0.5) + 7" 'spacings: 1 1 1' \
  'axis mins: -1 -2 -1' 'centerings: cell cell cell' >cells.nrrd
run cone -q --volume=cells.nrrd --panorama=out.nrrd --resolution=20 --fill=-9 \
  part.json
exact 'a volume of cells'

# general cones
cp part.json circular.json
jq -c '. + {method: "atph", apexes: [-2, 3, -2], height: [-1, 1]}' circular.json \
  >part.json
run cone -q --volume=linear.nrrd --panorama=out.nrrd --resolution=20 --fill=-9 \
  part.json
expect 'general cones' 0
true_that 'general cones: as many points as the area says' jq -e '
  .panorama.points / 400 / .area - 1 | fabs < 0.02' out
exact 'general cones'
mv circular.json part.json

# ---- verified ----------------------------------------------------------------

# A pattern that covers itself, on a volume that does not reach everywhere.
printf '%s\n' '{"points":[[3,0,1],[0,3,1],[-3,0,1],[0,-3,1]],"rulings":'\
'[[-0.96,0,0.28],[0,-0.96,0.28],[0.96,0,0.28],[0,0.96,0.28]],"tangents":'\
'[[0,1,0],[-1,0,0],[0,-1,0],[1,0,0]],"closed":true,"height":[-2.5,1]}' >fan.json
jq -c '. + {method: "atph", apexes: [-2, 3, -2], height: [-1, 1]}' part.json \
  >general.json
# verified NAME FILE RESOLUTION
verified() {
  run cone -q --volume=linear.nrrd --panorama=out.nrrd --resolution="$3" \
    --override='translate=[0.1,0.2,0.3]' "$2"
  cp out result.json
  run verify -q --volume=linear.nrrd result.json
  equal "verified: $1" '0 "ok" absent' "$status $(get status) $(get unchecked)"
  true_that "verified: $1: exactly" jq -e '.checks.panorama_error < 1e-14' out
  run verify -q result.json
  equal "without the volume: $1" \
    '0 ["panorama.outside","panorama.range","panorama.mean"]' \
    "$status $(get unchecked)"
  for change in '.points += 90' '.points -= 90' '.resolution *= 1.02' \
    '.origin[0] += 0.2' '.outside += 90' '.range[0] += 1e-6' \
    '.range[1] -= 1e-6' '.mean += 1e-6'; do
    jq -c ".panorama |= ($change)" result.json >wrong.json
    run verify -q --volume=linear.nrrd wrong.json
    equal "tampered: $1: $change" '1 "not-verified"' \
      "$status $(get error.code)"
  done
}
verified 'circular cones' part.json 20
verified 'a pattern that covers itself' fan.json 10
verified 'general cones' general.json 10
lattice "4 * (i - 1) - 2 * (j - 2) + 0.5 * (k - 1) + 7" 'spacings: 1 1 1' \
  'axis mins: -1 -2 -1' 'centerings: node node node' >other.nrrd
run verify -q --volume=other.nrrd result.json
equal 'verified: of another volume' '1 "panorama.range"' \
  "$status $(get error.field)"
jq -c '.panorama.width = 2147483647 | .panorama.height = 2147483647' \
  result.json >wrong.json
run verify -q wrong.json
equal 'verified: a picture of no end' '1 "panorama.width"' \
  "$status $(get error.field)"

# A plane through a pattern of 0 and 1: the products of the weights.
printf '%s' '{"points":[[0,1,1],[4,1,1]],"rulings":[[0,1,0],[0,1,0]],'\
'"tangents":[[1,0,0],[1,0,0]],"height":[0,3]}' >plane.json
lattice '(i + j) % 2' >pattern.nrrd
run cone -q --volume=pattern.nrrd --panorama=out.nrrd --resolution=2 plane.json
expect 'a pattern' 0
equal 'a pattern: its values' '0 0.5 1 0.5 0 0.5 1 0.5 0 0.5' \
  "$(sed '1,/^$/d' out.nrrd | od -An -v -tf8 | tr -s ' ' '\n' | sed '/^$/d' |
    head -n 10 | tr '\n' ' ' | sed 's/ $//')"
equal 'a pattern: where it is' 'space directions: (0.5,0) (0,-0.5)
space origin: (0,3)' "$(sed -n 's/ *$//; /^space [do].*(/p' out.nrrd)"

for type in 'signed char' uchar short ushort int uint float; do
  lattice '(i + j) % 2' | sed "s/^type: .*/type: $type/" >typed.nrrd
  mv out.nrrd want.nrrd
  run cone -q --volume=typed.nrrd --panorama=out.nrrd --resolution=2 plane.json
  equal_files "of type $type" want.nrrd out.nrrd
done

# ---- PNG ---------------------------------------------------------------------

run cone -q --volume=linear.nrrd --panorama=a.png --resolution=20 -j1 part.json
expect 'PNG' 0
equal 'PNG: its size, 16 bits of grey' "$(jq -r '.panorama |
  [.width, .height, 16, 0] | join(" ")' out)" "$(od -An -tu1 -j16 -N10 a.png |
  awk '{ print ($1 * 256 + $2) * 65536 + $3 * 256 + $4,
    ($5 * 256 + $6) * 65536 + $7 * 256 + $8, $9, $10 }')"
run cone -q --volume=linear.nrrd --panorama=b.png --resolution=20 -j7 part.json
equal_files 'PNG: the same again' a.png b.png

# ---- what is wrong -----------------------------------------------------------

run cone --volume=linear.nrrd --panorama=c.png --resolution=20 \
  --override='height=[-3,1]' part.json
true_that 'beside the volume: a warning' grep -q \
  'warning: [0-9]* of [0-9]* points of the panorama are outside of the volume' err
run cone -q --volume=linear.nrrd --panorama=d.png --resolution=20 part.json \
  plane.json
expect 'two problems' 1 "phspline: plane.json:1: record 2: is not the only \
problem: --panorama is the picture of one [bad-value]"
true_that 'two problems: that of the first' test -s d.png
echo old >e.png
run cone -q --volume=linear.nrrd --panorama=e.png --resolution=20 \
  --max-samples=9 part.json
true_that 'a limit' grep -q 'more than the 9 of --max-samples \[limit\]' err
equal 'a limit: the file is left' old "$(cat e.png)"
run cone -q --volume=linear.nrrd --panorama=e.png --resolution=20 \
  --override='height=[0,0]' part.json
expect 'no height' 1 "phspline: part.json:3: record 1: height: must have an \
extent for --panorama, as in --height=[-1,1] [bad-value]"

# unread NAME MESSAGE [OPTION]...: of the volume bad.nrrd
unread() {
  name=$1 message=$2
  shift 2
  run cone --volume=bad.nrrd --panorama=f.png --resolution=1 "$@" part.json
  expect "$name" 3 "phspline: cannot read the volume bad.nrrd: $message" ''
  true_that "$name: no file" [ ! -e f.png ]
}
lattice 0 | sed 's/^sizes.*/sizes: 3 70/; s/^dimension.*/dimension: 2/' >bad.nrrd
unread '2 axes' 'it must have 3 axes, of numbers, not of vectors or colours'
lattice 0 | sed 's/^sizes.*/sizes: 210 1 1/' >bad.nrrd
unread 'no depth' 'it must have 2 or more points along each axis'
lattice 0 | sed 's/double/longlong/' >bad.nrrd
unread 'long integers' 'it must be of integers of up to 32 bits, float or double'
lattice 0 'space dimension: 3' 'space directions: (1,0,0) (2,0,0) (0,0,1)' \
  >bad.nrrd
unread 'a flat lattice' 'it must have spacings or space directions of which '\
'none depends on the others'
lattice 0 >bad.nrrd
unread 'a large volume' 'it takes 1680 bytes, more than the 1000 of --max-memory' \
  --max-memory=1000
echo nothing >bad.nrrd
run cone --volume=bad.nrrd --panorama=f.png --resolution=1 part.json
equal 'no volume' '3 phspline: cannot read the volume bad.nrrd: ' \
  "$status $(sed 's/\(nrrd: \).*/\1/' err)"
rm bad.nrrd
run cone --volume=bad.nrrd --panorama=f.png --resolution=1 part.json
equal 'no file' 3 "$status"

# usage MESSAGE OPTION...
usage() {
  message=$1
  shift
  run cone "$@" </dev/null
  expect "$message" 2 "phspline: $message
Try 'phspline cone --help'." ''
}
usage '--volume, --panorama and --resolution go together' --panorama=x.png
usage '--volume, --panorama and --resolution go together' --fill=1
usage "--panorama must be the name of a .png or .nrrd file, found 'x.gif'" \
  --volume=v.nrrd --panorama=x.gif --resolution=1
usage "--resolution must be a number greater than 0, found '0'" --resolution=0
usage "--fill must be a number, found 'nan'" --fill=nan
usage '--panorama is the picture of one result, --sweep gives several' \
  --volume=v.nrrd --panorama=x.png --resolution=1 --sweep=lambda=1,2
usage "--panorama must be a file of its own, 'x.nrrd' is that of another option, \
too" --volume=x.nrrd --panorama=x.nrrd --resolution=1
