# SPDX-License-Identifier: GPL-3.0-or-later
#
# GeoJSON input: files as other programs write them give the curves that the
# same points give as CSV, and what is wrong is told by file, line and field.
. "$srcdir/tests/cli/lib.sh"

# the_same NAME ID FILE [ARGUMENT...]: the segments of the first record with that id
# are those in the file wanted
the_same() {
  name=$1 id=$2 file=$3
  shift 3
  run "${command:-planar}" "$@" "$file"
  jq -c "select(.id == $id) | [.closed, .segments]" out | head -n 1 >found
  equal_files "$name" wanted found
}

printf 'id,x,y\na,7,46\na,7.5,46.25\na,8,46\na,8.25,47\n' >line.csv
printf 'x,y\n0,0\n4,0\n4,3\n0,3\n' >ring.csv

# ---- files of other programs -------------------------------------------------

# as QGIS writes them
cat >qgis.geojson <<'END'
{
"type": "FeatureCollection",
"name": "tracks",
"crs": { "type": "name", "properties": { "name": "urn:ogc:def:crs:OGC:1.3:CRS84" } },
"features": [
{ "type": "Feature", "properties": { "fid": 1, "name": "Weg" }, "geometry": { "type": "MultiLineString", "coordinates": [ [ [ 7.0, 46.0 ], [ 7.5, 46.25 ], [ 8.0, 46.0 ], [ 8.25, 47.0 ] ] ] } },
{ "type": "Feature", "properties": { "fid": 2, "name": null }, "geometry": { "type": "MultiPolygon", "coordinates": [ [ [ [ 0, 0 ], [ 4, 0 ], [ 4, 3 ], [ 0, 3 ], [ 0, 0 ] ], [ [ 1, 1 ], [ 1, 2 ], [ 2, 2 ], [ 1, 1 ] ] ] ] } }
]
}
END
# as geopandas and json.dumps(sort_keys=True) do
printf '%s' '{"bbox": [7, 46, 8.25, 47], "features": [{"bbox": [7, 46, 8.25,' \
  ' 47], "geometry": {"coordinates": [[7.0, 46.0, 410.5], [7.5, 46.25, 420],' \
  ' [8.0, 46.0, 400], [8.25, 47.0, 1e3]], "type": "LineString"}, "id": "0",' \
  ' "properties": {"km": 1.5}, "type": "Feature"}], "type":' \
  ' "FeatureCollection"}' >pandas.json

run planar line.csv
jq -c '[.closed, .segments]' out >wanted
the_same 'a MultiLineString of QGIS' null qgis.geojson --fail-fast -q
equal 'its lines, rings and properties' \
  '{"fid":1,"name":"Weg"} 4 {"fid":2,"name":null} 4 {"fid":2,"name":null} 3' \
  "$(run planar qgis.geojson
    jq -r '[.meta, (.segments | length + if input_line_number == 1 then 1
      else 0 end)] | map(tojson) | join(" ")' out | tr '\n' ' ' | sed 's/ $//')"
the_same 'a LineString with elevations, of geopandas' '"0"' pandas.json
equal 'elevations are kept' '{"km": 1.5,"elevation":[410.5,420,400,1e3]}' \
  "$(get meta)"
the_same 'the same from standard input' '"0"' - <pandas.json
run planar --closed ring.csv
jq -c '[.closed, .segments]' out >wanted
printf '%s' '{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],' \
  '[0,0]]]}' >ring.json
the_same 'a Polygon is closed' null ring.json
command=sphere
printf 'lon,lat\n7,46\n7.5,46.25\n8,46\n8.25,47\n' >sphere.csv
run sphere sphere.csv
jq -c '[.closed, .segments]' out >wanted
the_same 'positions on the sphere are longitude and latitude' '"0"' pandas.json
command=spatial-hermite
printf 'x,y,z\n7,46,410.5\n7.5,46.25,420\n8,46,400\n8.25,47,1e3\n' >space.csv
run spatial-hermite space.csv
jq -c '[.closed, .segments]' out >wanted
the_same 'in space the elevation is z' '"0"' pandas.json
command=planar

if command -v ogr2ogr >/dev/null; then
  printf '%s\n' 'id,WKT' 'a,"LINESTRING(7 46,7.5 46.25,8 46,8.25 47)"' >wkt.csv
  run planar line.csv
  jq -c '[.closed, .segments]' out >wanted
  for driver in GeoJSON GeoJSONSeq 'GeoJSONSeq -lco RS=YES'; do
    # two words
    # shellcheck disable=SC2086
    ogr2ogr -f $driver ogr.out wkt.csv -oo KEEP_GEOM_COLUMNS=NO \
      -lco ID_FIELD=id 2>ogr.err
    the_same "of ogr2ogr -f $driver" '"a"' ogr.out
    rm -f ogr.out
  done
else
  echo 'ok without ogr2ogr # SKIP'
fi

# ---- failures ----------------------------------------------------------------

cat >bad.geojson <<'END'
{"type":"FeatureCollection","features":[
{"type":"Feature","id":"a","geometry":{"type":"LineString","coordinates":
[[0,0],
[1,"x"]]}},
{"type":"Feature","id":"b","geometry":{"type":"Point","coordinates":[0,1]}},
{"type":"Feature","id":"c","geometry":{"type":"Linestring"}},
{"type":"Feature","id":"d","geometry":null},
{"type":"Feature","id":"e","geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}}
],"bbox":}
END
run planar -q bad.geojson
expect 'failures' 3 \
  'phspline: bad.geojson:4: record a: points[1][1]: must be a number, found a string [bad-type]
phspline: bad.geojson:5: record b: type: is Point, and no curve goes through one point; read are LineString, Polygon, these with Multi, and MultiPoint [bad-value]
phspline: bad.geojson:6: record c: type: is "Linestring", which is no geometry of GeoJSON; did you mean "LineString"? [bad-value]
phspline: bad.geojson:7: record d: geometry: is null: the feature has no line [bad-value]
phspline: bad.geojson:9: record 6: expected a value, found '\''}'\'' [syntax]'
equal 'their records' '"a" "b" "c" "d" "e" null' \
  "$(jq -c .id out | tr '\n' ' ' | sed 's/ $//')"
feed '{"type":"LineString","coordinates":[[0,0],[1,1]]}' planar -q -i json
expect 'GeoJSON that is read as problems' 1 \
  'phspline: -:1: record 1: type: is not a field of planar; --input-format=geojson reads GeoJSON [unknown-field]'
printf '\036{"type":"MultiPoint","coordinates":[[0,0],[1,1]]}\n\036{"type":
\036{"type":"MultiPoint","coordinates":[[0,0],[2,2]]}\n' >seq.geojsons
run planar -q seq.geojsons
equal 'a sequence with a broken text' '1 "ok" "error" "ok"' \
  "$status $(jq -c .status out | tr '\n' ' ' | sed 's/ $//')"

# ---- verify ------------------------------------------------------------------

run planar qgis.geojson -o results.json
run verify --problems=qgis.geojson results.json
equal 'verify reads the problems' 0 "$status"
