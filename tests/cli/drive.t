# SPDX-License-Identifier: GPL-3.0-or-later
#
# Roads and moves: --format=opendrive and --format=gcode, which other programs
# read and integrate, or run; what is refused.
. "$srcdir/tests/cli/lib.sh"

python=
for p in python3 /usr/bin/python3; do
  if "$p" -c 'import xml.etree.ElementTree' 2>/dev/null; then
    python=$p
    break
  fi
done
if [ -z "$python" ]; then
  echo 'ok without python3 # SKIP'
  exit 0
fi

# road NAME WANTED [down]: of the problems in the file in
road() {
  "$PHSPLINE" tc -q -i json --sample=8 in >records 2>err
  "$PHSPLINE" tc -q -i json -f opendrive in >out.xodr 2>err
  equal "$1: roads, lines, polynomials" "$2" \
    "$("$python" "$srcdir/tests/cli/opendrive.py" out.xodr records 1e-12 2>&1 | tail -n 1)"
}

# moves NAME WANTED CHORD ARGUMENT...: with the command first
moves() {
  case=$1
  wanted=$2
  chord=$3
  command=$4
  shift 4
  "$PHSPLINE" "$command" -q --sample=40 "$@" in >records 2>err
  "$PHSPLINE" "$command" -q -f gcode --feed=600 --chord-error="$chord" "$@" in \
    >out.ngc 2>err
  equal "$case: chains, lines, cubics, arcs" "$wanted" \
    "$("$python" "$srcdir/tests/cli/gcode.py" out.ngc records 4e-12 "$chord" \
      600 2>&1 | tail -n 1)"
}

# ---- roads ----------------------------------------------------------------------

cp "$srcdir/tests/vectors/tc-g2.jsonl" in
road 'all cases of mode g2' '16 9 179'
zigzag='"points":[[0,0],[2,1],[3,0],[5,0.5],[6,0],[7,0],[8,0]]'
straight='{"id":"<&> \"road\"","points":[[0,0],[2,0],[4,0],[7,4]]}'
plate='{"closed":true,"tolerance":0.01,"curve":[[[0,0],[10,0]],[[10,0],[10,4]],
  [[10,4],[0,4]],[[0,4],[0,0]]]}'
plate=$(printf '%s' "$plate" | tr -d '\n')
{
  printf '{%s,"mode":"spline"}\n' "$zigzag"
  echo '{"points":[[0,0],[2,1],[3,0]],"tangents":[[1,1],[1,-0.5],[1,-2]]}'
  echo '{"points":[[0,0],[2,1],[3,0]],"tangents":[[1,-1],[1,0.5],[1,0]],"mode":"g1-pair"}'
  echo "$straight"
  echo "$plate"
  # of a map, in metres
  echo '{"points":[[691000,5335000],[691040,5335010],[691085,5335000],[691090,5334950]]}'
} >in
road 'other modes, corners, large numbers' '6 8 22'
equal 'the name is text' '&lt;&amp;&gt;_&quot;road&quot;' \
  "$(sed -n 's/^<road name="\([^"]*\)".*lt.*/\1/p; s/^<road name="\(&lt;[^"]*\)" .*/\1/p' out.xodr)"
sed 's/hdg="\([^"]*\)"/hdg="1\1"/' out.xodr >bad.xodr
true_that 'the reader sees another heading' eval "! $python \
  $srcdir/tests/cli/opendrive.py bad.xodr records 1e-12"
sed 's/\(length="[0-9.]*\)[0-9]\("><param\)/\1\2/' out.xodr >bad.xodr
true_that 'the reader sees another length' eval "! $python \
  $srcdir/tests/cli/opendrive.py bad.xodr records 1e-12"

cat >down.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg"><path d="M0,0 C10,0 20,10 20,30"/></svg>
END
"$PHSPLINE" tc -q --tolerance=0.01 --sample=8 down.svg >records
"$PHSPLINE" tc -q --tolerance=0.01 -f opendrive down.svg >out.xodr
true_that 'y of a drawing is turned' "$python" \
  "$srcdir/tests/cli/opendrive.py" out.xodr records 1e-12 down
printf '%s\n' "{$zigzag}" >in
"$PHSPLINE" tc -q -f opendrive -S 'points[1][1]=1:3:3' in >out.xodr
equal 'a sweep: ids and names' '1 1:points[1][1]=1
2 1:points[1][1]=2
3 1:points[1][1]=3' \
  "$(sed -n 's/^<road name="\([^"]*\)" id="\([^"]*\)".*/\2 \1/p' out.xodr)"

# ---- moves ----------------------------------------------------------------------

cp "$srcdir/tests/vectors/tc-g2.jsonl" in
moves 'all cases of mode g2' '16 9 179 0' 1e-3 tc
printf '%s\n' "$plate" >in
moves 'offsets of a plate, with gaps' '9 12 0 0' 0.001 tc -d 1,-1
moves 'trimmed' '3 12 0 4' 0.001 tc -d 1,-1 --offset-mode=trimmed
moves 'joined: tips' '2 16 0 0' 0.001 tc -d -1 --offset-mode=joined \
  --offset-join=miter
moves 'arcs that are less than a chord error' '2 12 0 0' 0.5 tc -d -1 \
  --offset-mode=trimmed
printf '%s\n' "{\"id\":\"(MSG, a)é\",$zigzag}" "{$zigzag}" >in
moves 'round ends' '4 326 14 8' 0.001 tc -d 0.2 \
  --offset-mode=trimmed --offset-ends=round
equal 'a comment is one' '(curve _MSG, a___)' "$(grep -m 1 curve out.ngc)"
moves 'chords of quintics, and raw offsets' '6 1474 0 0' 1e-4 planar -d 0.1,-0.1
moves 'coarse ones' '4 64 0 0' 0.05 planar -d 0.1
moves 'trigonometric ones' '4 328 0 0' 1e-3 planar -d 0.1 --basis=atph
printf '%s\n' '{"points":[[691000,5335000],[691040,5335010],[691085,5335000]]}' \
  '{"points":[[0,0],[1e-9,1e-9],[3e-9,0]]}' '{"points":[[0,0],[1e9,1e9],[3e9,0]]}' >in
moves 'large and small numbers' '3 0 6 0' 1 tc
"$PHSPLINE" tc -q -f gcode --feed=0.5 --tolerance=0.01 -d 3 \
  --offset-mode=trimmed --chord-error=0.001 "$srcdir/data/bracket.svg" >out.ngc
"$PHSPLINE" tc -q --tolerance=0.01 -d 3 --offset-mode=trimmed --sample=8 \
  "$srcdir/data/bracket.svg" >records
true_that 'y of a drawing is turned' "$python" "$srcdir/tests/cli/gcode.py" \
  out.ngc records 4e-12 0.001 0.5 down
for edit in 's/^G3/G2/' 's/^\(G5.*\) P/\1 P1/' '0,/^G1/s/^\(G1 X\)/\11/'; do
  sed "$edit" out.ngc >bad.ngc
  true_that "the machine sees another program: $edit" eval "! cmp -s out.ngc \
    bad.ngc && ! $python $srcdir/tests/cli/gcode.py bad.ngc records 4e-12 \
    0.001 0.5 down"
done

# ---- what is refused --------------------------------------------------------------

# refused NAME MESSAGE COMMAND ARGUMENT...
refused() {
  name=$1
  message=$2
  shift 2
  feed "{$zigzag}" "$@"
  expect "$name" 2 "phspline: $message
Try 'phspline $1 --help'." ''
}

refused 'a road of quintics' '--format=opendrive is of plane cubics, which planar does not make: tc does' planar -f opendrive
refused 'a road on a sphere' '--format=opendrive is of plane cubics, which sphere does not make: tc does' sphere -f opendrive
for option in --sample=2 --spacing=1 --chord-error=1 --offset=1 --convert=bezier; do
  refused "a road with $option" '--format=opendrive is of the curve itself, without samples and offsets' tc -f opendrive "$option"
done
refused 'moves in space' '--format=gcode is of curves in the plane, those of planar and tc' arclength -f gcode --feed=1
for option in --sample=2 --spacing=1 --convert=bezier; do
  refused "moves with $option" '--format=gcode has no samples; --chord-error says how near moves are to the curve' planar -f gcode --feed=1 "$option"
done
refused 'no feed' '--format=gcode needs --feed' tc -f gcode
refused 'a feed of nothing' '--feed needs --format=gcode' tc --feed=100
refused 'no such feed' '--feed must be from 1e-06 to 1e+09 mm a minute' tc -f gcode --feed=1e-7
refused 'a feed back' "--feed must be a number greater than 0, found '-1'" tc -f gcode --feed=-1
feed '{"points":[[0,0],[1e-30,1e-30],[2e-30,0]]}' tc -q -f gcode --feed=1
equal 'too small for plain decimals' '1 the curve has a size of 1.12e-30 and coordinates up to 1.12e-30, which G-code, of plain decimals, has no room for [too-large]' \
  "$status $(sed 's/.*record 1: //' err)"
equal 'of which nothing is left' 'G21 G17 G90
F1
M2' "$(cat out)"
