# SPDX-License-Identifier: GPL-3.0-or-later
#
# Where results come from: the member file and the column of --with-file; what
# is said of empty input; progress.
. "$srcdir/tests/cli/lib.sh"

printf '0,0\n3,4\n' >a.csv
cp a.csv c.csv
printf '{"points":[[0,0],[3,4]],"id":1}\n{"points":[[0,0]],"id":2}\n' >'b ".json'
run planar -q a.csv 'b ".json' - <c.csv
equal 'each file, but for standard input and failures' \
  '"a.csv" "b \".json" null null' \
  "$(jq -c .file out | tr '\n' ' ' | sed 's/ $//')"
equal 'the error has its own' '"b \".json"' \
  "$(jq -c 'select(.error) | .error.file' out)"
cp out results.json
run verify -q results.json
equal 'verify reads it' 0 "$status"
run planar -q --with-file --table=lengths a.csv 'b ".json' - <c.csv
expect 'a column' 1 "$(grep '\[' err)" \
  'id,segment,t0,t1,length,cumulative,file
1,0,0,5,5,5,a.csv
1,0,0,5,5,5,"b "".json"
4,0,0,5,5,5,-'
run planar --with-file --table=lengths -f text -S 'points[1][1]=4' a.csv
expect 'after what is swept' 0 '' \
  '# id segment t0 t1 length cumulative points[1][1] file
1 0 0 5 5 5 4 a.csv'
run planar --with-file --sample=1 --table=samples a.csv
cp out samples.csv
run planar samples.csv
equal 'such a table can be read' '0 5' "$status $(get length)"
run planar -f geojson a.csv
equal 'a property of GeoJSON' '"a.csv"' "$(jq -c '.features[].properties.file' out)"
run planar --with-file a.csv
expect 'not of JSON' 2 "phspline: --with-file needs --format=csv or --format=text
Try 'phspline planar --help'."

# ---- nothing ------------------------------------------------------------------

: >empty
printf 'x,y\n' >header.csv
run planar empty header.csv
expect 'empty files' 0 'phspline: there is no problem in empty, header.csv' ''
feed ' ' planar
expect 'empty standard input' 0 'phspline: there is no problem in standard input' ''
feed '' planar -q
expect 'quietly' 0 '' ''
run planar a.csv empty
expect 'one among others' 0 'phspline: there is no problem in empty'
run planar --shard=0/1 a.csv empty
expect 'not of a part' 0 ''
run planar a.csv empty - </dev/null
expect 'two of three' 0 'phspline: there is no problem in empty, standard input'
for i in 1 2 3 4 5 6 7 8 9 a b c; do
  : >"empty$i"
done
run planar empty?
expect 'the first of many' 0 'phspline: there is no problem in empty1, empty2, empty3, '\
'empty4, empty5, empty6, empty7, empty8, empty9, emptya and 2 more' ''
run verify empty
expect 'verify' 0 'phspline: there is no result in empty' ''

# ---- progress -------------------------------------------------------------------

run planar --progress -q -o out.json a.csv a.csv
equal 'the last line has the rate' 'phspline: 2 records, 0 failed, N s, N a second' \
  "$(sed 's/[0-9.e+]* s/N s/; s/[0-9.e+]* a second/N a second/' err)"
