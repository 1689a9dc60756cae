# SPDX-License-Identifier: GPL-3.0-or-later
#
# GeoJSON output: features and their geometries, rings as RFC 7946 wants them,
# the antimeridian, and what other programs read of it.
. "$srcdir/tests/cli/lib.sh"

# features FILTER: of each feature of out a line
features() {
  jq -c ".features[] | $1" out | tr '\n' ' ' | sed 's/ $//'
}

square='0,0\n4,0\n4,3\n0,3\n'

# ---- geometries --------------------------------------------------------------

feed '{"points":[[0,0],[3,4]],"id":"a","meta":{"b":1}}' planar -f geojson
expect 'a line' 0 '' '{"type":"FeatureCollection","features":[
{"type":"Feature","id":"a","properties":{"id":"a","length":5,"meta":{"b":1}},"geometry":{"type":"LineString","coordinates":[[0,0],[3,4]]}}
]}'
feed '' planar -f geojson -q
expect 'no problem' 0 '' '{"type":"FeatureCollection","features":[

]}'
feed '{"points":[[0,0]],"id":1}
{"points":[[0,0],[3,4]],"id":2}' planar -f geojson -q
equal 'a failure has no feature' '1 2' "$status $(features .id)"
feed '{"points":[[0,0],[3,4]],"id":2}' planar -f geojson -S 'points[1][0]=3,4'
equal 'a sweep' \
  '[null,2,{"points[1][0]":3}] [null,2,{"points[1][0]":4}]' \
  "$(features '[.id, .properties.id, .properties.sweep]')"
# the ring of a reversed square is not reversed
for way in 1 -1; do
  # shellcheck disable=SC2059
  printf "$square" | if [ $way = 1 ]; then cat; else tac; fi >square.csv
  run planar --closed --offset=0.5,-0.5 -f geojson square.csv
  equal "a closed curve, way $way" \
    '["Polygon",true,true] ["LineString",null,true] ["LineString",null,true]' \
    "$(features '.geometry | [.type,
      (select(.type == "Polygon") | .coordinates[0] |
        [.[:-1], .[1:]] | transpose |
        map(.[0][0] * .[1][1] - .[0][1] * .[1][0]) | add > 0) // null,
      (if .type == "Polygon" then .coordinates[0] else .coordinates end |
        first == last)]')"
done
feed "$(printf '0,0\n4,4\n4,0\n0,4\n')" planar --closed -f geojson -q
equal 'a curve that crosses itself' '"LineString"' "$(features .geometry.type)"
feed "$(printf '0,0\n1,0\n1,1\n')" spatial-hermite --sample=2 -f geojson
equal 'samples that are asked for' '5' \
  "$(features '.geometry.coordinates | length')"
printf '0,0\n10,0\n10,10\n0,10\n' >big.csv
run planar --closed --offset=1 --offset-mode=trimmed --offset-sides=both \
  -f geojson -q big.csv
equal 'an outline has a hole' '["Polygon",1] ["Polygon",2]' \
  "$(features '.geometry | [.type, (.coordinates | length)]')"
run planar --closed --offset=30 --offset-mode=trimmed -f geojson -q big.csv
equal 'nothing is left of an offset' 'null' \
  "$(features 'select(.properties.distance) | .geometry')"
feed '{"curve":[[[0,0],[10,0]],[[10,0],[10,10]]]}' tc --offset=-3 --tolerance=1 \
  -f geojson -q
equal 'gaps are not bridged' '"LineString" "MultiLineString"' \
  "$(features .geometry.type)"

# ---- the sphere --------------------------------------------------------------

printf 'lon,lat\n170,10\n-170,20\n-100,70\n' >flight.csv
run sphere -f geojson --radius=6371 flight.csv
equal 'a line is cut at the antimeridian' \
  '["MultiLineString",2,[170,180],[-180,-100]]' \
  "$(features '.geometry | [.type, (.coordinates | length)] +
    (.coordinates | map([.[0][0], .[-1][0]] | map(. * 1e9 | round / 1e9)))')"
equal 'on both sides at the same latitude' 'true' \
  "$(features '.geometry.coordinates | .[0][-1][1] == .[1][0][1]')"
# the great circle from (170, 10) to (-170, 10) has its summit at 180
printf 'lon,lat\n170,10\n-170,10\n' >circle.csv
run sphere -f geojson --sample=1 circle.csv
jq '.features[0].geometry.coordinates[0][-1][1]' out >found
awk 'BEGIN { d = atan2(0, -1) / 180
  printf "%.15g\n", atan2(sin(10 * d) / cos(10 * d) / cos(10 * d), 1) / d }' \
  >wanted
numbers 'where it does' 1e-13 wanted found
# over NUMBER POINTS WANTED: lines at a pole, with so many steps
over() {
  printf 'lon,lat\n%b\n' "$2" >pole.csv
  run sphere -q -f geojson --sample="$1" pole.csv
  equal "at a pole: $2, $1" "$3" \
    "$(features '.geometry.coordinates | tojson | gsub("6{13}7"; "7")')"
}
over 2 '0,90\n90,0' '"[[90,90],[90,45],[90,0]]"'
over 2 '90,0\n0,-90' '"[[90,0],[90,-45],[90,-90]]"'
over 2 '0,80\n180,80' '"[[[0,80],[0,90]],[[180,90],[180,80]]]"'
over 3 '0,80\n180,80' \
  '"[[[0,80],[0,86.7],[0,90]],[[180,90],[180,86.7],[180,80]]]"'
printf 'lon,lat\n10,70\n0,90\n-100,60\n' >pole.csv
run sphere -q -f geojson --sample=3 --closed pole.csv
equal 'a curve through a pole goes on at another longitude' '[true,true]' \
  "$(features '.geometry.coordinates | [(.[0][-1] | .[1] == 90) and
    .[0][-1][0] == .[0][-2][0], (.[1][0] | .[1] == 90) and
    .[1][0][0] == .[1][1][0]]')"
printf 'lon,lat\n170,10\n180,15\n-170,20\n-170,10\n' >touch.csv
run sphere -f geojson touch.csv
equal 'a sample at 180 degrees is at both ends' '[[180,true],[-180,true]]' \
  "$(features '.geometry.coordinates |
    [[.[0][-1][0], (.[0] | all(.[0] > 0))],
     [.[1][0][0], (.[1] | all(.[0] < 0))]]')"

# ---- other programs ----------------------------------------------------------

run planar --closed --offset=5,-5 --offset-mode=trimmed -f geojson -q \
  "$srcdir/data/coastline.csv"
cp out coast.geojson
run planar --closed --offset=5,-5 --offset-mode=trimmed -q \
  "$srcdir/data/coastline.csv"
jq -c '.offsets[] | .area, .length' out >wanted
python=
for p in python3 /usr/bin/python3; do
  if [ -z "$python" ] && "$p" -c 'import shapely' 2>err; then
    python=$p
  fi
done
if [ -n "$python" ]; then
  "$python" - coast.geojson >found <<'END'
import json, sys
from shapely.geometry import shape
for f in json.load(open(sys.argv[1]))["features"][1:]:
    s = shape(f["geometry"])
    assert s.is_valid and s.exterior.is_ccw
    print(s.area)
    print(s.length)
END
  numbers 'shapely finds areas and lengths of offsets' 1e-5 wanted found
else
  echo 'ok without shapely # SKIP'
fi
if command -v ogr2ogr >/dev/null; then
  ogr2ogr -f CSV ogr.csv coast.geojson -lco GEOMETRY=AS_WKT 2>err
  equal 'ogr2ogr reads it' 'POLYGON 840.089916256595 POLYGON "5" POLYGON "-5"' \
    "$(sed -n 's/^"\([A-Z]*\) [^a-z]*)",\(.*\)$/\1 \2/p' ogr.csv |
      awk '{ split($2, v, ","); print $1, v[1] == "" ? v[2] : v[1] }' |
      tr '\n' ' ' | sed 's/ $//')"
else
  echo 'ok without ogr2ogr # SKIP'
fi
# what is written can be read: a line through the samples is as long
run planar -f geojson --spacing=0.1 "$srcdir/data/spiral.csv"
cp out spiral.geojson
jq '.features[].properties.length' out >wanted
run planar spiral.geojson
json get length out >found
numbers 'the program reads what it wrote' 1e-6 wanted found

# ---- options -----------------------------------------------------------------

feed '' cone -f geojson
expect 'surfaces have none' 2 "phspline: --format=geojson is of curves, cone makes surfaces
Try 'phspline cone --help'."
feed '' sphere -f geojson --sample=2 --frame=rmf
expect 'frames' 2 "phspline: --format=geojson has no frames
Try 'phspline sphere --help'."
