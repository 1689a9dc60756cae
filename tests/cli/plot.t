# SPDX-License-Identifier: GPL-3.0-or-later
#
# --plot: what figures show, counted by the colours of their strokes, their
# sizes, that they are the same for every run, and how their files come to be.
# How they look is not asked here.
. "$srcdir/tests/cli/lib.sh"

# table 4.1 of [GON18]
cone_good='{"points":[[252.6524,62,92.5],[266.5158,65.1388,91.5]],'\
'"rulings":[[-0.1151,0.2405,0.9638],[-0.1785,0.165,0.97]],'\
'"tangents":[[0.9925,0.069,0.1013],[0.8847,0.4583,0.0849]]}'
hint="Try 'phspline planar --help'."
printf '%s\n' "$good" >good.jsonl
printf '%s\n%s\n%s\n' "$good" "$bad" "$good" >mixed.jsonl

# ---- without cairo -----------------------------------------------------------

run planar -p x.svg nosuch.json
case $(cat err) in
*'without cairo'*)
  expect 'without cairo' 2 "phspline: --plot: this phspline was built without \
cairo: install libcairo2-dev (Debian, Ubuntu), cairo-devel (Fedora) or cairo \
(elsewhere) and build it again
$hint" ''
  true_that 'without cairo: no file' [ ! -e x.svg ]
  run planar --plot=x.bmp nosuch.json
  expect 'without cairo, an unknown suffix' 2 "phspline: --plot must be the \
name of a .svg, .pdf or .png file, found 'x.bmp'
$hint" ''
  echo 'skip figures: built without cairo'
  exit
  ;;
esac
rm -f x.svg

# cairo is loaded for figures alone, and it is told where it cannot be
library=$(grep -ao 'libcairo[.][.a-z0-9]*' "$PHSPLINE" | head -n 1)
if [ -n "$library" ]; then
  mkdir broken
  : >"broken/$library"
  printf '%s\n' "$good" >good.json
  true_that 'no figure, no cairo' env LD_LIBRARY_PATH="$PWD/broken" \
    "$PHSPLINE" planar -q good.json
  status=0
  LD_LIBRARY_PATH=$PWD/broken "$PHSPLINE" planar -p x.svg nosuch.json \
    >out 2>err || status=$?
  true_that 'a cairo that cannot be loaded' grep -q \
    "^phspline: --plot: figures need the library cairo: .*$library" err
  equal 'its exit status' 2 "$status"
  true_that 'and no file' [ ! -e x.svg ]
fi

# ---- misuse ------------------------------------------------------------------

# misused NAME MESSAGE ARGUMENT...: before anything is read
misused() {
  name=$1 message=$2
  shift 2
  run planar "$@" nosuch.json
  expect "$name" 2 "phspline: $message
$hint" ''
}

suffix='--plot must be the name of a .svg, .pdf or .png file, found'
misused 'an unknown suffix' "$suffix 'x.bmp'" --plot=x.bmp
misused 'no suffix' "$suffix 'svg'" -p svg
misused 'nothing but a suffix' "$suffix '.svg'" -p .svg
misused 'no file' "$suffix ''" --plot=
misused 'standard output' "$suffix '-'" -p -
misused 'a size without a figure' '--plot-size needs --plot' --plot-size=640x480
misused 'a title without a figure' '--title needs --plot' --title=a
misused 'labels without a figure' '--labels needs --plot' --labels
size='--plot-size must be WIDTHxHEIGHT, whole numbers from 100 to 20000, found'
for bad_size in 640 640x 640x480x 640x99 20001x480 640x480.5 -640x480 x nanx100 \
  '640 x480'; do
  misused "the size '$bad_size'" "$size '$bad_size'" -p x.svg \
    "--plot-size=$bad_size"
done
same='--plot and --output are the same file'
misused 'one name' "$same" -p x.svg -o x.svg
misused 'one name, by a detour' "$same" -p x.svg -o ./x.svg
: >there.svg
ln -s there.svg link.svg
ln there.svg hard.svg
misused 'a symbolic link' "$same" -p link.svg -o there.svg
misused 'a hard link' "$same" -p hard.svg -o there.svg
true_that 'misuse: no file' [ ! -e x.svg ]

# ---- what a figure shows -----------------------------------------------------

# well_formed NAME FILE
if command -v xmllint >/dev/null; then
  well_formed() {
    true_that "$1: well-formed" xmllint --noout "$2"
  }
else
  echo 'skip whether SVG files are well-formed: no xmllint'
  well_formed() { :; }
fi

# inks FILE: how many paths of each colour, but for the key; as `R,G,B=N', in
# whole percent
inks() {
  sed -n '/<g class="key">/,/<\/g>/d
    s/ //g; s/<path.*stroke[:=]"*rgb(\([^)]*\)).*/stroke,\1/p
    s/<path.*fill[:=]"*rgb(\([^)]*\)).*/fill,\1/p' "$1" |
    awk -F '[,%]+' '{ n[sprintf("%s %.0f,%.0f,%.0f", $1, $2, $3, $4)]++ }
      END { for (ink in n) print ink "=" n[ink] }'
}

# ink WHAT: from inks on standard input
ink() {
  sed -n "s/^$1=//p" | grep . || echo 0
}

# drawn NAME EVEN ODD LAST OFFSET POLYGON TANGENT POINT: the paths in x.svg of
# segments in turn, each in the views and in the profiles; of offsets, control
# polygons, tangents and data points
drawn() {
  figure=$1
  well_formed "$figure" x.svg
  inks x.svg >found
  shift
  equal "$figure: paths" "$*" "$(
    for what in 'stroke 8,39,70' 'stroke 90,47,8' 'stroke 49,32,66' \
      'stroke 5,58,44' 'stroke 66,66,66' 'stroke 36,36,36' 'fill 10,10,10'; do
      ink "$what" <found
    done | tr '\n' ' ' | sed 's/ $//'
  )"
}

five='"points":[[0,0],[1,1],[2,0],[3,1],[4,3]]'
feed "{$five}" planar -p x.svg -d 0.1,-0.1
equal 'in the plane: status' 0 "$status"
drawn 'in the plane' 4 4 0 2 4 0 5
cp out with
feed "{$five}" planar -d 0.1,-0.1
equal_files 'results are the same without a figure' with out
feed "{$five,\"basis\":\"atph\"}" planar -p x.svg --convert=bezier
drawn 'what Bezier pieces stand for' 4 4 0 0 4 0 5
feed '{"points":[[0,0],[2,1],[3,0]],"closed":true}' planar -p x.svg
drawn 'closed' 2 2 2 0 3 0 3
feed '{"points":[[0,0],[2,1],[3,0]],"tangents":[[1,1],[1,0],[1,-1]]}' tc \
  -p x.svg
drawn 'cubics with tangents, and a joint that is no datum' 4 2 0 0 3 3 3
feed '{"points":[[0,0],[1,0]],"derivatives":[[1,1],[-1,1]]}' tc -p x.svg
drawn 'a pair of cubics' 2 2 0 0 2 2 2
# places of the figure are x and -y of the control points, scaled and moved
{
  jq '.segments[].control_points[][]' out
  grep '<path.*[0-9]C[0-9]' x.svg | sed 's/.* d="M\([^"]*\)".*/\1/' |
    tr -s 'C ,' '[\n*]'
} | awk '{ v[NR] = $1 } END {
    scale = (v[23] - v[17]) / (v[7] - v[1])
    for (i = 1; i <= 16; i++) {
      sign = i % 2 ? 1 : -1
      from = i % 2 ? 1 : 2
      d = v[i + 16] - v[from + 16] - sign * scale * (v[i] - v[from])
      bad = bad || d > 0.0015 || d < -0.0015
    }
    print NR, bad + 0 }' >found
equal 'a pair of cubics: they are drawn as themselves' '32 0' "$(cat found)"
# four views and two profiles
feed '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]]}' spatial-hermite -p x.svg
drawn 'in space' 12 6 0 0 12 0 16
feed '{"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,1]]}' spatial-hermite -p x.svg \
  -d 0.1
drawn 'in space, with offsets' 12 6 0 16 12 0 16
feed '{"points":[[1,1,0],[0,4,3],[2,4,2],[3,3,3]],"lengths":[4.9,2.5,2]}' \
  arclength -q -p x.svg
drawn 'intervals of two segments' 18 18 0 0 24 0 16
feed '{"lonlat":[[0,0],[9,5],[18,5],[27,0]]}' sphere -p x.svg
drawn 'on a sphere' 4 2 0 0 3 0 4
cat >two.jsonl <<END
{"id":"a \\"b\\" <c> & \\u0007 \\u00e9",$five}
{"id":2,$five}
END
run planar -p x.svg two.jsonl
drawn 'two problems' 8 8 0 0 8 0 10
feed "{$five}" planar -p x.svg -S 'points[2][1]=0:1:4'
well_formed 'a sweep' x.svg
inks x.svg >found
# five profiles, views and the legend are as many for each
equal 'a sweep: colours of the ramp' 9 "$(ink 'stroke 27,0,33' <found)"
equal 'a sweep: none of the segments' 0 "$(ink 'stroke 8,39,70' <found)"
run planar -q -p x.svg mixed.jsonl
equal 'a problem failed: status' 1 "$status"
drawn 'a problem failed' 4 4 0 0 4 0 6
run planar -p x.svg </dev/null
expect 'no problem' 0 'phspline: there is no problem in standard input' ''
drawn 'no problem' 0 0 0 0 0 0 0
run planar -q -p x.svg good.jsonl nosuch.json
equal 'input that cannot be read: status' 3 "$status"
drawn 'what came before it' 2 2 0 0 2 0 3

# a surface, laid flat beside it; and without a height
run cone -q -p x.svg <<END
$(echo "$cone_good" | sed 's/}$/,"height":[-9,9]}/')
END
well_formed 'a surface' x.svg
inks x.svg >found
equal 'a surface: points and arrows, in space and flat' '4 4' \
  "$(ink 'fill 10,10,10' <found) $(ink 'stroke 36,36,36' <found)"
true_that 'a surface: edges, rulings, contact curves of both strips' \
  test "$(ink 'stroke 22,24,28' <found)" -gt 50 -a \
  "$(ink 'stroke 58,60,64' <found)" -gt 12 -a \
  "$(ink 'stroke 8,39,70' <found)" -gt 6 -a \
  "$(ink 'stroke 90,47,8' <found)" -gt 6
equal 'a surface: no parallel one' 0 "$(ink 'stroke 5,58,44' <found)"
run cone -q -p x.svg -d 1 <<END
$(echo "$cone_good" | sed 's/}$/,"height":[-9,9]}/')
END
inks x.svg >found
true_that 'a parallel surface' test "$(ink 'stroke 5,58,44' <found)" -gt 20
run cone -q -p x.svg <<END
$cone_good
END
well_formed 'a contact curve' x.svg
inks x.svg >found
equal 'a contact curve: points, arrows, and rulings alone' '4 4 4 0' \
  "$(ink 'fill 10,10,10' <found) $(ink 'stroke 36,36,36' <found) \
$(ink 'stroke 22,24,28' <found) $(ink 'stroke 58,60,64' <found)"
run cone -q -p x.svg --labels <<'END'
{"points":[[252.6524,62,92.5],[252.6525,62,92.5],[266.5158,65.1388,91.5]],
"rulings":[[-0.1151,0.2405,0.9638],[-0.1151,0.2405,0.9638],[-0.1785,0.165,0.97]],
"tangents":[[0.9925,0.069,0.1013],[0.9925,0.069,0.1013],[0.8847,0.4583,0.0849]],
"height":[-9,9],"merge":0.01}
END
equal 'a surface: numbers of points, in space and flat' '0 2 0 2 ' \
  "$(grep 'font-size="9"' x.svg | sed -n 's/.*>\([0-9]*\)<.*/\1/p' | tr '\n' ' ')"
feed '{"closed":true,"points":[[2,0,0],[-1,1.7320508075688772,0],'\
'[-1,-1.7320508075688772,0]],"rulings":[[0,0,1],[0,0,1],[0,0,1]],'\
'"tangents":[[0,1,0],[-0.8660254037844386,-0.5,0],'\
'[0.8660254037844386,-0.5,0]],"height":[-4,4]}' cone -q -p x.svg
inks x.svg >found
equal 'a cylinder all around: its hidden lines are one dashed path' 1 \
  "$(sed '/<g class="key">/,$d' x.svg | grep -c 'stroke-dasharray')"
equal 'a cylinder all around: one point of three is hidden' '5 2' \
  "$(ink 'fill 10,10,10' <found) $(ink 'fill 55,56,58' <found)"

# ---- words -------------------------------------------------------------------

# texts: those of x.svg, in order, without numbers of axes
texts() {
  sed -n 's/.*<text [^>]*>\(.*\)<\/text>/\1/p' x.svg
}

# key: the words of the key of x.svg
key() {
  sed -n '/<g class="key">/,/<\/g>/s/.*>\(.*\)<\/text>/\1/p' x.svg |
    tr '\n' '|'
}

# element NAME: of x.svg, up to the end of its first line
element() {
  sed -n "s/^<$1>//p" x.svg | sed "s/<\/$1>\$//"
}

feed '{"id":"a<b","points":[[0,0],[1,1],[2,0]]}' planar -p x.svg -d 0.1 \
  --title='One & "two"'
well_formed 'a title' x.svg
equal 'a title' 'One &amp; "two"' "$(element title)"
equal 'a title: it is seen' 1 "$(texts | grep -cx 'One &amp; "two"')"
equal 'the id, as text' 1 "$(texts | grep -cx 'a&lt;b')"
equal 'a description' "a&lt;b: curve in the plane through 3 points, with 1 \
offset; below, its curvature over the arc length." "$(element desc)"
equal 'axes, as text' 'x y arc length curvature' \
  "$(texts | grep -x '[a-z ]*[a-z]' | grep -v ',\|control\|data\|offset' |
    tr '\n' ' ' | sed 's/ $//')"
equal 'the key' 'data|curve, by segments|control polygon|offset|' "$(key)"
feed '{"id":"c","points":[[0,0],[1,1],[2,0]]}' planar -p x.svg
equal 'without --title: that of the panel' c "$(element title)"
feed "$good" planar -p x.svg --title=
equal 'an empty title' '' "$(element title)"
feed '{"points":[[0,0],[1,1]],"tangents":[[1,0],[1,0]]}' tc -p x.svg
equal 'the key of tangents' \
  'data|curve, by segments|control polygon|tangent|' "$(key)"
feed '{"points":[[0,0],[1,1],[2,0]]}' planar -p x.svg -S knots=uniform,chordal
equal 'the key of a sweep: its legend has the curves' '' "$(key)"
equal 'two curves of a sweep: the second is dashed' \
  "$(inks x.svg | ink 'stroke 48,82,32')" \
  "$(sed -n 's/.*stroke-dasharray="\([^"]*\)".*/\1/p' x.svg | grep -c .)"
# a slot that is closed but for its mouth: both ends of the offset around it
five='{"closed":true,"curve":[[[0,0],[9,0]],[[9,0],[9,9]],[[9,9],[5,9]],'\
'[[5,9],[5,4]],[[5,4],[4,4]],[[4,4],[4,9]],[[4,9],[0,9]],[[0,9],[0,0]]],'\
'"tolerance":0.1}'
feed "$five" tc -q -p x.svg -d -1 --offset-mode=trimmed
equal 'the key of an offset that was trimmed' \
  'data|curve, by segments|offset|trimmed off|' "$(key | sed 's/control polygon.//')"
equal 'what was trimmed is dashed and thin, and nothing else is' 'stroke 38,66,57' \
  "$(sed '/<g class="key">/,$d' x.svg | grep 'stroke-dasharray' >dashed
    inks dashed | sed 's/=.*//')"
feed "$five" tc -q -p x.svg -d -0.1 --offset-mode=joined
equal 'the key of an offset that was joined' \
  'data|curve, by segments|offset|' "$(key | sed 's/control polygon.//')"
feed "$five" tc -q -p x.svg -d -1,-0.1 --offset-mode=trimmed \
  --sweep=tolerance=0.1,0.2
equal 'of a sweep it is not drawn' 0 "$(inks x.svg | ink 'stroke 38,66,57')"
feed '{"lonlat":[[0,0],[80,5],[160,5],[-120,0]]}' sphere -q -p x.svg
equal 'the key of a sphere' 'data|curve, by segments|control polygon|hidden|' \
  "$(key)"
printf '%s\n' "$cone_good" | sed 's/}$/,"height":[-9,9]}/' >high.json
run cone -q -p x.svg high.json
equal 'the key of a surface' \
  'data|contact curve|tangent|edge of a strip|ruling|hidden|' "$(key)"
# styles: inks and widths of lines
styles() {
  grep -o 'stroke="[^"]*" stroke-width="[^"]*"' | sort -u
}
run cone -q -p x.svg --closed --height='[0,18]' "$srcdir/data/lampshade.csv"
sed '/<g class="key">/,$d' x.svg | styles >drawn
sed -n '/<g class="key">/,/<\/g>/p' x.svg | styles >shown
equal 'it shows lines as they are drawn' '6 0' \
  "$(wc -l <shown | tr -d ' ') $(comm -13 drawn shown | wc -l | tr -d ' ')"

feed '{"points":[[0,0,0],[10,10,0],[20,0,10],[30,10,10]]}' spatial-hermite -p x.svg
box=$(awk '/rgb\(83%/ { inside = 1; next } /rgb\(66%/ { inside = 0 } inside' x.svg |
  sed -n 's/.*<text [^>]*>\(.*\)<\/text>/\1/p' | tr '\n' ' ')
equal 'a curve in space: numbers and names at its box' '0 20 x 0 y 0 z ' "$box"

# Points have their numbers, in data with merged points those that were given.
labels() {
  texts | grep -x '[0-9]*' | tr '\n' ' '
}
points='[10.5,10.5],[11.5,11.5],[11.5,11.5],[12.5,10.5],[13.5,11.5]'
feed "{\"points\":[$points],\"merge\":0.1}" planar -q -p x.svg
without=$(labels)
feed "{\"points\":[$points],\"merge\":0.1}" planar -q -p x.svg --labels
equal '--labels' '0 1 3 4 ' "$(labels | sed "s/$without//")"

# more segments than can be told apart
awk 'BEGIN {
  printf "{\"points\":["
  for (i = 0; i < 3000; i++) printf "%s[%d,%d]", i ? "," : "", i, i * i % 7
  print "]}"
}' >large.json
run planar -p x.svg large.json
drawn 'thousands of segments' 1000 1000 0 0 0 0 0

# ---- sizes -------------------------------------------------------------------

# attribute NAME: of the svg element of x.svg, numbers without their unit
attribute() {
  sed -n "s/pt\"/\"/g; s/^<svg.* $1=\"\([^\"]*\)\".*/\1/p" x.svg
}

# ihdr FILE: width and height
ihdr() {
  od -A n -t u1 -j 16 -N 8 "$1" |
    awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4, \
      (($5 * 256 + $6) * 256 + $7) * 256 + $8 }'
}

# magic FILE: its first bytes, in hexadecimal
magic() {
  od -A n -t x1 -N 8 "$1" | tr -d ' \n'
}

# bytes FILE
bytes() {
  wc -c <"$1" | tr -d ' '
}

run planar -p x.svg --plot-size=321x234 good.jsonl
equal 'SVG: size' '321 234 0 0 321 234' \
  "$(attribute width) $(attribute height) $(attribute viewBox)"
run planar -p x.pdf --plot-size=321x234 good.jsonl
equal 'PDF: its header' 255044462d "$(magic x.pdf | cut -c 1-10)"
equal 'PDF: its end' '%%EOF' "$(tail -n 1 x.pdf)"
equal 'PDF: one page' 1 \
  "$(LC_ALL=C sed -n 's/.*\/Count \([0-9]*\).*/\1/p' x.pdf)"
equal 'PDF: size' '0 0 321 234' \
  "$(LC_ALL=C sed -n 's/.*\/MediaBox \[ *\([0-9 ]*[0-9]\) *\].*/\1/p' x.pdf)"
run planar -p x.png --plot-size=321x234 good.jsonl
equal 'PNG: its header' 89504e470d0a1a0a "$(magic x.png)"
equal 'PNG: size' '321 234' "$(ihdr x.png)"
run planar -p empty.png --plot-size=321x234 </dev/null
equal 'PNG, nothing to draw: size' '321 234' "$(ihdr empty.png)"
# a page of one colour takes some 500 bytes
true_that 'PNG: there is more to see than on an empty page' \
  [ "$(bytes x.png)" -gt $((2 * $(bytes empty.png))) ]
for kind in svg pdf png; do
  run planar -p "x.$kind" good.jsonl
  true_that "$kind: size by itself" [ "$(bytes "x.$kind")" -gt 2000 ]
done
run planar -p two.png two.jsonl
{
  ihdr x.png
  ihdr two.png
} | tr ' ' '\n' | holds 'PNG: two problems take more' \
  'x[3] * x[4] > 1.5 * x[1] * x[2]'
rm x.*
run planar -p x.svg -p x.png good.jsonl
equal 'the last name counts' x.png "$(echo x.*)"

# ---- all commands, always the same -------------------------------------------

echo '{"points":[[0,0],[1,1],[2,0]]}' >planar.json
echo '{"points":[[0,0,0],[1,0,1],[0,1,2]]}' >spatial-hermite.json
echo '{"points":[[0,0,0],[1,0,1],[0,1,2]],"lengths":[1.5,2]}' >arclength.json
echo '{"lonlat":[[0,0],[20,10],[40,0]]}' >sphere.json
cp planar.json tc.json
echo "$cone_good" | sed 's/}$/,"height":[-9,9]}/' >cone.json
for command in planar spatial-hermite arclength sphere tc cone; do
  for kind in svg pdf png; do
    run "$command" -q -d 0.1 -p "1.$kind" "$command.json"
    equal "$command, $kind: status" 0 "$status"
    run "$command" -q -d 0.1 -p "2.$kind" "$command.json"
    equal_files "$command, $kind: the same again" "1.$kind" "2.$kind"
  done
  well_formed "$command" 1.svg
done
awk 'BEGIN {
  for (i = 1; i <= 150; i++) {
    if (i % 7 == 0) print "{\"points\":[[0,0],[0,0]]}"
    else print "{\"id\":" i ",\"points\":[[0,0],[1," i "],[2,0]]}"
  }
}' >many.jsonl
for jobs in 1 4; do
  run planar -p "$jobs.svg" -j $jobs many.jsonl
  equal "more than fit, --jobs=$jobs: status" 1 "$status"
  grep -v 'coincides with' err >said
  equal "more than fit, --jobs=$jobs: what is said" \
    "phspline: warning: --plot shows 100 of 129 problems
$(failed 21 150)" "$(cat said)"
done
equal_files 'more than fit: the same for all --jobs' 1.svg 4.svg
equal 'more than fit: 100 are drawn' 400 \
  "$(inks 1.svg | ink 'stroke 8,39,70' | awk '{ print 2 * $1 }')"
run planar -q -p 1.svg many.jsonl
expect 'more than fit, --quiet' 1 "$(sed '/^phspline: .*records failed/d
  /^phspline: warning/d' err)"
feed "$good" planar -p x.png -S 'points[0][0]=0:0.5:1003'
expect 'a sweep of more than fit' 0 \
  'phspline: warning: --plot shows 1000 of 1003 results'

# ---- the file ----------------------------------------------------------------

run planar -p want.svg good.jsonl
mv out want.out

# Each case has a directory d, with an old file.
fresh() {
  rm -rf d
  mkdir d
  echo old >d/old.svg
}

# untouched NAME
untouched() {
  equal "$1: the old figure stays, alone" 'old.svg old' \
    "$(ls -A d) $(cat d/old.svg)"
}

fresh
run planar -p d/old.svg -o d/out good.jsonl
expect 'a figure and results' 0 '' ''
equal_files 'a figure and results: the figure' want.svg d/old.svg
equal_files 'a figure and results: the results' want.out d/out
equal 'a figure and results: nothing else' 'old.svg out' \
  "$(cd d && echo *)"
fresh
run planar --fail-fast -p d/old.svg -o d/out mixed.jsonl
equal '--fail-fast: status' 1 "$status"
untouched '--fail-fast'
run planar --fail-fast -q -p d/old.svg good.jsonl
equal '--fail-fast, and nothing failed' 0 "$status"
equal_files '--fail-fast, and nothing failed: the figure' want.svg d/old.svg
fresh
run planar -p nosuch/x.svg -o d/out good.jsonl
expect 'a directory that is not there' 4 \
  'phspline: cannot create nosuch/x.svg: No such file or directory' ''
untouched 'a directory that is not there'
mkdir d/dir.svg
run planar -p d/dir.svg good.jsonl
expect 'a directory' 4 'phspline: cannot open d/dir.svg: Is a directory' ''
fresh
chmod 500 d
if (: >d/new) 2>/dev/null; then
  rm d/new
  echo 'skip a directory without permission: nothing is forbidden to this user'
else
  run planar -p d/old.svg good.jsonl
  expect 'a directory without permission' 4 \
    'phspline: cannot create d/old.svg: Permission denied' ''
fi
chmod 700 d
untouched 'a directory without permission'
run planar -p d/old.svg -o nosuch/out good.jsonl
expect 'results that cannot be written' 4 \
  'phspline: cannot create nosuch/out: No such file or directory' ''
untouched 'results that cannot be written'
awk -v line="$good" 'BEGIN { for (i = 0; i < 20; i++) print line }' \
  >twenty.jsonl
run planar twenty.jsonl
mv out twenty.out
(
  ulimit -f 64
  run planar -p d/old.svg -o d/out twenty.jsonl
  expect 'no room for the figure' 4 \
    'phspline: cannot write d/old.svg: File too large' ''
)
equal_files 'no room for the figure: results are there' twenty.out d/out
rm d/out
untouched 'no room for the figure'

# Root gets a node of its own: a program that replaced it instead would leave
# the machine without the real one.
if [ "$(id -u)" -ne 0 ]; then
  ln -s /dev/full full.svg
else
  { mknod full.svg c 1 7 && : >full.svg; } 2>cmd.out
fi
if [ -c full.svg ]; then
  run planar -p full.svg good.jsonl
  expect 'a full device' 4 \
    'phspline: cannot write full.svg: No space left on device' "$(cat want.out)"
  true_that 'a full device stays one' [ -c full.svg ]
else
  echo 'skip a full device: none can be made here'
fi

# interrupted NAME STATUS SIGNAL JOBS: while it waits for input, with a figure
# and results in the making
mkfifo input messages
interrupted() {
  fresh
  defaults "$PHSPLINE" planar -v -j "$4" -p d/old.svg -o d/out input \
    2>messages &
  pid=$!
  exec 4<messages 3>input
  cat good.jsonl >&3
  read -r message <&4
  equal "$1: in the middle of its work" 'phspline: input:1: record 1:' \
    "$(printf '%s' "$message" | cut -d ' ' -f 1-4)"
  equal "$1: three files then" 3 "$(find d -type f | wc -l | tr -d ' ')"
  kill -s "$3" "$pid"
  status=0
  wait "$pid" 2>cmd.out || status=$?
  equal "$1: status" "$2" "$status"
  exec 3>&- 4<&-
  untouched "$1"
}

interrupted 'SIGTERM' 143 TERM 1
interrupted 'SIGINT, with threads' 130 INT 4
