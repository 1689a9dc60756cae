# SPDX-License-Identifier: GPL-3.0-or-later
#
# Drawings as SVG: paths with ids, the box around them, and that other programs
# find them well-formed.
. "$srcdir/tests/cli/lib.sh"

# ds: the attributes d of out
ds() {
  sed -n 's/.* d="\([^"]*\)".*/\1/p' out
}

# view: the numbers of the viewBox
view() {
  sed -n 's/.*viewBox="\([^"]*\)".*/\1/p' out
}

feed '{"points":[[0,0],[3,0]],"id":"a"}' planar -f svg
expect 'a drawing' 0 '' \
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.06 -0.06 3.12 0.12">
<style>path { fill: none; stroke: black; stroke-width: 0.005859375 }
.offset { stroke: gray }
.ruling { stroke-dasharray: 0.0234375 }</style>
<path id="a" transform="scale(1,-1)" d="M0,0C1,0 2,0 3,0"/>
</svg>'
feed '{"points":[[0,0],[3,0]]}' planar -f svg --unit=in
equal 'its size in inches' \
  ' width="79.248mm" height="3.0479999999999996mm" viewBox="-0.06 -0.06 3.12 0.12">' \
  "$(sed -n '1s/.*svg"//p' out)"
feed '' planar -f svg
equal 'no problem' '0 0 1.04 1.04' "$(view)"
printf 'id,x,y\n"a<b ""c",0,0\n"a<b ""c",4,0\n"a<b ""c",4,3\nd,5,5\nd,7,8\n' \
  >data.csv
run planar --offset=0.5 -f svg -q data.csv
cp out drawing.svg
equal 'ids' 'a&lt;b_&quot;c a&lt;b_&quot;c@0.5 d d@0.5' \
  "$(sed -n 's/.* id="\([^"]*\)".*/\1/p' out | tr '\n' ' ' | sed 's/ $//')"
ds >found
run planar --offset=0.5 -f svg-path -q data.csv
sed 's/\(.\)M/\1\
M/' out >wanted
equal_files 'the paths are those of svg-path' wanted found
if command -v xmllint >/dev/null; then
  true_that 'it is well-formed' xmllint --noout drawing.svg
else
  echo 'ok without xmllint # SKIP'
fi
feed '{"points":[[0,0],[10,5]],"id":"a"}' planar -f svg -S 'points[1][0]=1,2'
equal 'a sweep' 'a:points[1][0]=1 a:points[1][0]=2' \
  "$(sed -n 's/.* id="\([^"]*\)".*/\1/p' out | tr '\n' ' ' | sed 's/ $//')"
feed '{"points":[[0,0]],"id":1}
{"points":[[0,0],[1,1]],"id":2}' planar -f svg -q
equal 'a failure has no path' '1 1' "$status $(grep -c '<path' out)"
# a cubic is drawn as it is; others within the tolerance
feed '{"points":[[0,0],[4,0],[5,3]],"tangents":[[1,1],[1,0],[0,1]]}' tc -f svg
ds | tr -s 'MC ' '[\n*]' | sed '/^$/d' | tr ',' ' ' >found
feed '{"points":[[0,0],[4,0],[5,3]],"tangents":[[1,1],[1,0],[0,1]]}' tc
jq -r '.segments | .[0].control_points[0], (.[].control_points[1:][]) |
  join(" ")' out >wanted
numbers 'exact cubics' 0 wanted found
for tolerance in 1 1e-9; do
  run planar --tolerance=$tolerance -f svg "$srcdir/data/spiral.csv"
  ds | tr -cd C | wc -c
done >found
true_that '--tolerance makes more cubics' \
  test "$(tail -n 1 found)" -gt $((2 * $(head -n 1 found)))
run cone --height='[-5,5]' -f svg --closed "$srcdir/data/lampshade.csv"
equal 'the pattern of a surface' '0 2' "$status $(grep -c '<path' out)"
