# SPDX-License-Identifier: GPL-3.0-or-later
#
# GPX input: files as Garmin, gpsbabel and ogr2ogr write them.
. "$srcdir/tests/cli/lib.sh"

feed '<gpx/>' sphere -q
case $(cat err) in
*'built without'*)
  echo 'skip GPX: built without expat'
  exit 0
  ;;
esac

# of a Garmin Oregon
cat >garmin.gpx <<'END'
<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<gpx xmlns="http://www.topografix.com/GPX/1/1" xmlns:gpxtpx="http://www.garmin.com/xmlschemas/TrackPointExtension/v1" creator="Oregon 400t" version="1.1">
  <metadata><name>no track</name><time>2009-10-17T22:58:43Z</time></metadata>
  <wpt lat="47" lon="7"><ele>3</ele><name>a place</name></wpt>
  <trk>
    <name>Up &amp; down</name>
    <trkseg>
      <trkpt lat="47.644548" lon="-122.326897"><ele>4.46</ele><time>2009-10-17T18:37:26Z</time><extensions><gpxtpx:TrackPointExtension><gpxtpx:hr>92</gpxtpx:hr></gpxtpx:TrackPointExtension></extensions></trkpt>
      <trkpt lat="47.644548" lon="-122.336897">
        <ele>4.940</ele>
      </trkpt>
      <trkpt lat="47.654548" lon="-122.326897"/>
    </trkseg>
    <trkseg><trkpt lat="1" lon="2"/><trkpt lat="2" lon="2"/></trkseg>
    <trkseg/>
  </trk>
  <trk><trkseg>
<trkpt lat="1" lon="2"/>
<trkpt lat="x" lon="2"/></trkseg>
<trkseg><trkpt lat="1" lon="2"/><trkpt lat="2" lon="2"/></trkseg></trk>
</gpx>
END
printf 'lon,lat\n-122.326897,47.644548\n-122.336897,47.644548\n%s\n' \
  '-122.326897,47.654548' >points.csv
run sphere points.csv
jq -c .segments out >wanted
run sphere -q garmin.gpx
jq -c .segments out | head -n 1 >found
equal_files 'longitude and latitude' wanted found
equal 'elevation and time' \
  '{"elevation":[4.46,4.94,null],"time":["2009-10-17T18:37:26Z",null,null]}' \
  "$(jq -c .meta out | head -n 1)"
equal 'names, and their segments' \
  '"Up & down/1" ok "Up & down/2" ok null error null ok' \
  "$(jq -r '(.id | tojson), .status' out | tr '\n' ' ' | sed 's/ $//')"
expect 'a point without a number' 1 \
  'phspline: garmin.gpx:19: record 3: lat: must be a number [bad-value]'

# texts of two segments and a route, the first longer than a record may be: of
# the name, or of one point
texts() {
  printf '<gpx><trk><name>%s</name>\n' "$1"
  printf '<trkseg><trkpt lat="1" lon="2"><%s>%s</%s></trkpt>' "$2" "$3" "$2"
  printf '<trkpt lat="2" lon="2"/></trkseg>\n'
  printf '<trkseg><trkpt lat="3" lon="2"/><trkpt lat="4" lon="2"/></trkseg>\n'
  printf '</trk><rte><name>r</name><rtept lat="3" lon="2"/>'
  printf '<rtept lat="4" lon="2"/></rte></gpx>'
}
over='the record is longer than the 200 bytes of --max-record-bytes'
long=$(printf '%0201d' 1)
texts "$long" ele 1 | "$PHSPLINE" sphere --max-record-bytes=200 \
  >out 2>err || :
told='.status + (if .error then " " + .error.message else "" end)'
equal 'a name longer than a record' "error $over
error $over
ok" "$(jq -r "$told" out)"
for element in ele time; do
  texts a "$element" "$long" | "$PHSPLINE" sphere --max-record-bytes=200 \
    >out 2>err || :
  equal "$element longer than a record" \
    "error $over
ok
ok" "$(jq -r "$told" out)"
done

cat >track.gpx <<'END'
<gpx><trk>
<name>a</name>
<trkseg><trkpt lat="1" lon="2"/><trkpt lat="2" lon="2"/></trkseg>
</trk></gpx>
END
run planar track.gpx
expect 'degrees as x and y' 0 'phspline: track.gpx:3: record a: warning: longitudes and latitudes, in degrees, were taken as x and y: sphere takes them as they are, and projected coordinates have lengths [degrees]'
run sphere track.gpx
expect 'degrees as such' 0 ''

# of gpsbabel, whose routes are in GPX 1.0
cat >gpsbabel.gpx <<'END'
<?xml version="1.0" encoding="UTF-8"?>
<gpx version="1.0" creator="GPSBabel - https://www.gpsbabel.org" xmlns="http://www.topografix.com/GPX/1/0">
  <time>2020-01-01T00:00:00.000Z</time>
  <bounds minlat="1" minlon="2" maxlat="2" maxlon="2"/>
  <rte>
    <name>R1</name>
    <number>1</number>
    <rtept lat="1.000000000" lon="2.000000000">
      <ele>0.000</ele>
      <name>A</name>
    </rtept>
    <rtept lat="2.000000000" lon="2.000000000">
      <name>B</name>
    </rtept>
    <rtept lat="2.000000000" lon="2.000000000"/>
  </rte>
</gpx>
END
run sphere --merge=1e-9 gpsbabel.gpx
equal 'a route' '"R1" {"elevation":[0,null,null]} 1' \
  "$(jq -c '.id, .meta, (.segments | length)' out | tr '\n' ' ' |
    sed 's/ $//')"
run sphere -q gpsbabel.gpx
expect 'lines are counted' 1 'phspline: gpsbabel.gpx:15: record R1: lonlat[2]: coincides with lonlat[1]: they are less than 1e-10 rad apart; --merge=D joins points nearer than D [coincident-points]'

if command -v ogr2ogr >/dev/null; then
  printf '%s\n' 'name,WKT' \
    'a,"MULTILINESTRING((-122.326897 47.644548,-122.336897 47.644548,-122.326897 47.654548))"' \
    >wkt.csv
  ogr2ogr -f GPX ogr.gpx wkt.csv -lco FORCE_GPX_TRACK=YES -nln tracks -nlt MULTILINESTRING \
    -oo KEEP_GEOM_COLUMNS=NO 2>ogr.err
  run sphere ogr.gpx
  equal 'the name that ogr2ogr writes' '"a"' "$(get id)"
  jq -c .segments out >found
  equal_files 'a track of ogr2ogr' wanted found
else
  echo 'ok without ogr2ogr # SKIP'
fi
