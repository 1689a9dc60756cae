# SPDX-License-Identifier: GPL-3.0-or-later
#
# SVG input: the field path of tc, files as Inkscape writes them, every shape,
# nested transformations, and hostile files.
. "$srcdir/tests/cli/lib.sh"

# ---- the field path ----------------------------------------------------------

printf '%s\n' '{"curve":[[[0,0],[10,0]],[[10,0],[12,0],[13,2],[12,4]],' \
  '[[12,4],[0,0]]],"closed":true}' >curve.json
run tc --tolerance=0.01 curve.json
cp out wanted
feed '{"path":"M0 0H10c2,0,3,2,2,4z"}' tc --tolerance=0.01
equal_files 'a path is the curve of its pieces' wanted out
cp out result.json
feed '{}' tc --tolerance=0.01 --path='M0 0H10c2,0,3,2,2,4z' -o set.json
equal_but_set 'as an option' wanted set.json
equal 'which the record tells' '"M0 0H10c2,0,3,2,2,4z"' \
  "$(jq -c .set.path set.json)"
printf '{"path":"M0 0H10c2,0,3,2,2,4z"}\n' >path.json
run verify --problems=path.json result.json
equal 'verify knows the path' 0 "$status"
printf '{"tolerance":0.01}\n' >empty.json
run verify --problems=empty.json set.json
equal 'verify knows the path of an option' 0 "$status"
feed '{"path":"M5 0A5 5 0 0 1-5 0A5 5 0 0 1 5 0z"}' tc --tolerance=1e-6
json get length out >found
awk 'BEGIN { printf "%.17g\n", 10 * atan2(0, -1) }' >wanted
numbers 'a circle of two arcs is as long as it is' 1e-6 wanted found
feed '{"path":"M0 0","tolerance":1}' tc -q
expect 'a path that draws nothing' 1 \
  'phspline: -:1: record 1: path: draws nothing (0 subpaths) [bad-value]'
feed '{"path":"M0 0h1M1 1h1","tolerance":1}' tc -q
expect 'a path of two' 1 \
  'phspline: -:1: record 1: path: has 2 subpaths: a problem has one, an SVG file may have any number [bad-value]'
feed '{"path":"M0 0h1","curve":[[0,0],[1,1]],"tolerance":1}' tc -q
expect 'a path and a curve' 1 \
  'phspline: -:1: record 1: path: excludes curve: give one of them [bad-value]'
for path in drawing.SVG '<svg/>'; do
  feed "{\"path\":\"$path\",\"tolerance\":1}" tc -q
  expect "$path is no path" 1 \
    'phspline: -:1: record 1: path: is path data, as "M0,0 L1,1": a whole SVG file is read as input, and gives a problem for each path [bad-value]'
done
feed '{"path":[[0,0],[1,1]],"tolerance":1}' tc -q
expect 'no path' 1 \
  'phspline: -:1: record 1: path: must be a string of SVG path data, found an array [bad-type]'

# ---- files -------------------------------------------------------------------

feed '<svg/>' tc -q
case $(cat err) in
*'built without'*)
  expect 'without expat' 3 "phspline: cannot read -: SVG and GPX need expat, \
which this program was built without: install libexpat1-dev (Debian, Ubuntu) or \
expat (elsewhere) and build it again"
  exit 0
  ;;
esac
expect 'a drawing of nothing' 0 '' ''

# as Inkscape writes them
cat >inkscape.svg <<'END'
<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->
<svg width="210mm" height="297mm" viewBox="0 0 210 297" version="1.1" id="svg5"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg">
  <sodipodi:namedview id="namedview7" pagecolor="#ffffff">
    <inkscape:grid type="xygrid" id="grid" /></sodipodi:namedview>
  <defs id="defs2"><path id="hidden" d="M 0,0 H 1" /></defs>
  <g inkscape:label="Layer 1" id="layer1" transform="translate(10,20)">
    <g transform="rotate(90) scale(2,2)">
      <rect style="fill:none" id="turned" x="1" y="2" width="4" height="3" /></g>
    <rect id="round" width="4" height="6" rx="1" />
    <circle id="circle" cx="5" cy="5" r="2px" />
    <ellipse id="ellipse" rx="2" ry="3" transform="matrix(0 1 -1 0 5 6)" />
    <path id="two" d="m 0,0 10,0 c 1,0 2,1 2,2 z m 5 5 l 1 1
      2 0" sodipodi:nodetypes="ccc" />
    <polyline points="0,0 1,1 2,0" />
    <polygon id="polygon" points="0 0 1 1 2 0" transform="skewX(45)" />
    <line x2="3" id="line" />
    <text id="text">text</text>
  </g>
</svg>
END
run tc --tolerance=1e-6 inkscape.svg
equal 'all shapes, and their ids' \
  '0 "turned" "round" "circle" "ellipse" "two/1" "two/2" null "polygon" "line"' \
  "$status $(jq -c .id out | tr '\n' ' ' | sed 's/ $//')"
equal 'what is closed' 'true true true true true false false true false' \
  "$(jq -c .closed out | tr '\n' ' ' | sed 's/ $//')"
equal 'where they begin' \
  '[6,22] [11,20] [17,25] [15,28] [10,20] [15,25] [10,20] [10,20] [10,20]' \
  "$(jq -c '.segments[0].control_points[0]' out | tr '\n' ' ' | sed 's/ $//')"
jq .length out >found
awk 'BEGIN { pi = atan2(0, -1); r = sqrt(2)
  # the ellipse: its perimeter by the series of Gauss and Kummer, h = 1/25
  h = 1 / 25; e = 1; c = 1
  for (n = 1; n < 20; n++) { c *= (1.5 - n) / n; e += c * c * h ^ n }
  printf "28\n%.15g\n%.15g\n%.15g\n", 12 + 2 * pi, 4 * pi, 5 * pi * e
  print "-"; printf "%.15g\n%.15g\n%.15g\n3\n", 2 + r, 2 * r, 2 + 1 + sqrt(5) }' \
  >wanted
sed -i 5s/.*/-/ found
numbers 'lengths' 1e-6 wanted found
equal 'viewBox and units are told' \
  '{"width":"210mm","height":"297mm","viewBox":"0 0 210 297"}' \
  "$(jq -c .meta out | sort -u)"
run planar -q inkscape.svg
equal 'other commands take lines' \
  '1 "turned" true null false "polygon" true "line" false' \
  "$status $(jq -c 'select(.status == "ok") | .id, .closed' out | tr '\n' ' ' |
    sed 's/ $//')"
expect 'and nothing else' 1 "$(printf 'phspline: inkscape.svg:%s: record %s: the element has curves: planar takes points, tc approximates curves [bad-value]\n' \
  13 round 14 circle 15 ellipse 16 two)"
run tc --tolerance=1e-3 -f svg inkscape.svg
cp out again.svg
jq -r .length wanted >/dev/null 2>&1
run tc --tolerance=1e-3 inkscape.svg
jq .length out >wanted
run tc --tolerance=1e-3 again.svg
jq .length out >found
numbers 'a drawing that was written can be read' 1e-3 wanted found
true_that 'it is not turned over' sh -c '! grep -q scale again.svg'

# ---- failures ----------------------------------------------------------------

cat >bad.svg <<'END'
<svg>
<path id="a" d="M 0 0 L 1 x"/>
<circle id="b" r="3mm"/>
<use id="c" href="#a"/>
<g id="d" transform="turn(90)"><line x2="1"/></g>
<polygon id="e" points="1 2 3"/>
<rect id="f"/>
<line id="g" x2="1e400"/>
<svg id="i" viewBox="0 0 1 1"><line x2="1"/></svg>
<svg><line id="h" x2="1"/></svg>
</svg>
END
run tc -q --tolerance=1 bad.svg
expect 'failures' 1 "$(
  sed 's/^/phspline: bad.svg:/' <<'END'
2: record a: d: has "x" at character 11, where a number is due in the path [syntax]
3: record b: r: is "3mm"; a number without unit is read [bad-value]
4: record c: the element is <use>: what it refers to is not read [bad-value]
5: record d: transform: is "turn(90)", which is no list of transformations [bad-value]
6: record e: points: must be pairs of numbers; something else stands in the place of pair 1 [syntax]
7: record f: the element draws nothing [bad-value]
8: record g: x2: is "1e400"; a number without unit is read [bad-value]
9: record i: the element is <svg> inside of another, with x, y or viewBox: what is in it is not read [bad-value]
END
)"
# hostile NAME STATUS MESSAGE [ARGUMENT...]: of the file bad.svg
hostile() {
  name=$1 wanted=$2 message=$3
  shift 3
  run tc -q --tolerance=1 "$@" bad.svg
  expect "$name" "$wanted" "phspline: bad.svg:1: record 1: $message"
}
printf '%s' '<!DOCTYPE lolz [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>' \
  '<svg id="&b;"/>' >bad.svg
hostile 'entities' 3 'the XML declares the entity a: entities are refused [syntax]'
printf '%s' '<!DOCTYPE svg [<!ENTITY a SYSTEM "/etc/passwd">]>' \
  '<svg>&a;</svg>' >bad.svg
hostile 'an entity in a file' 3 \
  'the XML declares the entity a: entities are refused [syntax]'
awk 'BEGIN { printf "<svg>"; for (i = 0; i < 100000; i++) printf "<g>" }' >bad.svg
hostile 'depth' 3 'elements are nested more than 256 deep [limit]'
awk 'BEGIN { printf "<svg><path d=\"M0 0"
  for (i = 0; i < 100000; i++) printf " 1 1"; printf "\"/></svg>" }' >bad.svg
hostile 'a long path' 3 'an element is longer than the 100000 bytes of --max-record-bytes [limit]' \
  --max-record-bytes=100000
awk 'BEGIN { printf "<svg><path id=\"a\" d=\"M0 0"
  for (i = 0; i < 9000; i++) printf "A1 1 0 0 0 %d 1", i; printf "\"/></svg>" }' \
  >bad.svg
run tc -q --tolerance=1 --max-record-bytes=200000 bad.svg
expect 'a path of many arcs' 1 'phspline: bad.svg:1: record a: the record is longer than the 200000 bytes of --max-record-bytes [limit]'
printf '<svg><g></svg>' >bad.svg
hostile 'broken XML' 3 'XML: mismatched tag [syntax]'
printf '{}' >bad.svg
hostile 'JSON' 3 'XML: not well-formed (invalid token); the input does not begin as SVG or GPX do [syntax]'
printf '<html><body/></html>' >bad.svg
run tc -q <bad.svg
expect 'HTML' 3 'phspline: -:1: record 1: the XML is <html>: only SVG and GPX are read [syntax]'
printf '<gpx/>' >bad.svg
hostile 'GPX' 3 'the XML is <gpx>: it should be <svg> [syntax]'
printf '%s' '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN"' \
  ' "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">' \
  '<svg:svg xmlns:svg="http://www.w3.org/2000/svg"><svg:line x2="4"/></svg:svg>' \
  >good.svg
run tc -q --tolerance=1 good.svg
equal 'a document type and a prefix are no harm' '0 4' "$status $(get length)"
