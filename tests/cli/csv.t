# SPDX-License-Identifier: GPL-3.0-or-later
#
# CSV input: what the first row may be, where a problem ends, what cells may
# hold, --columns and --delimiter.  (Failures to the byte: errors.t.)
. "$srcdir/tests/cli/lib.sh"

# csv NAME WANTED TEXT [ARGUMENT...]: WANTED is the exit status, the ids, and
# the second point of each problem; TEXT is for printf
csv() {
  name=$1 wanted=$2
  # shellcheck disable=SC2059
  printf "$3" >a.csv
  shift 3
  run planar "$@" a.csv
  equal "$name" "$wanted" \
    "$status $(get id) $(get 'segments[0].control_points[5]')"
}

# ---- the first row -----------------------------------------------------------

one='0 absent [3,4]'
csv 'a header' "$one" 'x,y\n0,0\n3,4\n'
csv 'a header in another order' "$one" 'y,x\n0,0\n4,3\n'
csv 'a header in capitals' "$one" 'X,Y\n0,0\n3,4\n'
csv 'a header with units' "$one" 'x_m,y_m\n0,0\n3,4\n'
csv 'a header with units in capitals' "$one" 'X_M,Y_m\n0,0\n3,4\n'
csv 'a header with blanks' "$one" ' x ,\ty\n0,0\n3,4\n'
csv 'a header in quotes' "$one" '"x" , "y"\n0,0\n3,4\n'
csv 'a header after blank lines' "$one" '\n  \nx,y\n0,0\n3,4\n'
csv 'a header after comments' "$one" '# a track\n#\nx,y\n0,0\n3,4\n'
csv 'a first line that names the columns' "$one" '# y,x\n0,0\n4,3\n'
csv 'a first line with units' "$one" '#x_m,y_m\n0,0\n3,4\n'
csv 'a first line that names too few' '3 absent absent' '# x,knot\n0,0\n4,3\n'
csv 'a first line that is a remark' "$one" '# x and y\n0,0\n3,4\n'
csv 'a second line is never a header' "$one" '#\n# y,x\n0,0\n3,4\n'
csv 'no header' "$one" '0,0\n3,4\n'
csv 'no header, blank lines before' "$one" '\n\n0,0\n3,4\n'
csv 'no header, a first cell that is empty' '1 absent absent' ',0\n3,4\n'
csv 'no header, three columns' '3 absent absent' '0,0,0\n3,4,0\n'
csv 'no header, four columns' '3 absent absent' '0,0,0,0\n3,4,0,0\n'
csv 'a header that is not known' '3 absent absent' 'a,b\n0,0\n3,4\n'
csv 'a header known in part' '3 absent absent' 'x,y,speed\n0,0,1\n3,4,1\n'
csv 'a column of another command' '3 absent absent' 'x,y,tension\n0,0,1\n3,4,1\n'
csv 'a column too many' '3 absent absent' 'x,y,z\n0,0,0\n3,4,0\n'
csv 'x alone' '3 absent absent' 'x\n0\n3\n'
csv 'y alone' '3 absent absent' 'id,y\na,0\na,3\n'
csv 'x twice' '3 absent absent' 'x,x_m\n0,0\n3,4\n'
csv 'a header and nothing else' '0  ' 'x,y\n'
csv 'nothing' '0  ' ''
csv 'blank lines' '0  ' '\n  \n\t\n'
csv 'comments' '0  ' '# nothing\n#\n'

# ---- line breaks and blanks --------------------------------------------------

csv 'lines of Windows' "$one" 'x,y\r\n0,0\r\n3,4\r\n'
csv 'a byte-order mark' "$one" '\357\273\277x,y\n0,0\n3,4\n'
csv 'a byte-order mark and no header' "$one" '\357\273\2770,0\n3,4\n'
csv 'a byte-order mark before a first line' "$one" '\357\273\277# y,x\n0,0\n4,3\n'
csv 'no line break at the end' "$one" 'x,y\n0,0\n3,4'
csv 'blanks around cells' "$one" 'x,y\n 0 ,\t0\n 3,4 \n'
csv 'comments between rows' "$one" 'x,y\n0,0\n# 1,1\n3,4\n#\n'
csv 'a comment within a cell is none' '1 absent absent' 'x,y\n0,0\n3,#4\n'

# ---- problems ----------------------------------------------------------------

two='x,y\n0,0\n3,4\n'
csv 'a blank line ends a problem' '0 absent absent [3,4] [5,6]' \
  "$two\\n0,0\\n5,6\\n"
csv 'so do many' '0 absent absent [3,4] [5,6]' "\\n$two\\n \\n\\n0,0\\n5,6\\n\\n"
csv 'and a blank line of Windows' '0 absent absent [3,4] [5,6]' \
  "$two\\r\\n0,0\\n5,6\\n"
csv 'a comment does not' '0 absent [3,4]' "$two# x\\n5,6\\n"
csv 'a row of empty cells does not' '1 absent absent' "$two,\\n5,6\\n"
csv 'another id ends a problem' '0 "a" "b" [3,4] [5,6]' \
  'id,x,y\na,0,0\na,3,4\nb,0,0\nb,5,6\n'
csv 'the same id later is another problem' '0 "a" "b" "a" [3,4] [5,6] [7,8]' \
  'id,x,y\na,0,0\na,3,4\nb,0,0\nb,5,6\na,0,0\na,7,8\n'
csv 'a blank line also between rows of one id' '0 "a" "a" [3,4] [5,6]' \
  'id,x,y\na,0,0\na,3,4\n\na,0,0\na,5,6\n'
csv 'the id may be anywhere' '0 7 8 [3,4] [5,6]' \
  'x,id,y\n0,7,0\n3,7,4\n0,8,0\n5,8,6\n'
csv 'a number as id stays as it is' '0 1.50 -2 [3,4] [5,6]' \
  'id,x,y\n1.50,0,0\n1.50,3,4\n-2,0,0\n-2,5,6\n'
csv 'what JSON would not take for a number is a string' \
  '0 "007" "+1" "1e999" [3,4] [5,6] [7,8]' \
  'id,x,y\n007,0,0\n007,3,4\n+1,0,0\n+1,5,6\n1e999,0,0\n1e999,7,8\n'
csv 'numbers are compared as text' '1 1 1.0 absent absent' \
  'id,x,y\n1,0,0\n1.0,3,4\n'
csv 'an empty id is none' '0 absent "a" [3,4] [5,6]' \
  'id,x,y\n,0,0\n,3,4\na,0,0\na,5,6\n'
csv 'ids in quotes' '0 "a,b" "c\"d" [3,4] [5,6]' \
  'id,x,y\n"a,b",0,0\n"a,b",3,4\n"c""d",0,0\n"c""d",5,6\n'
csv 'quotes do not make another id' '0 "a" [3,4]' 'id,x,y\n"a",0,0\na,3,4\n'
csv 'a line break in an id' '0 "a\u000ab" [3,4]' \
  'id,x,y\n"a\nb",0,0\n"a\nb",3,4\n'
csv 'letters in an id' '0 "Äß€" [3,4]' 'id,x,y\nÄß€,0,0\nÄß€,3,4\n'
csv 'blanks within an id' '0 "a b" [3,4]' 'id,x,y\n a b ,0,0\na b,3,4\n'
csv 'a problem that fails among others' \
  '1 "a" "b" "c" [3,4] absent [5,6]' \
  'id,x,y\na,0,0\na,3,4\nb,0,0\nb,0,0\nc,0,0\nc,5,6\n'
expect 'its line is that of the row' 1 \
  "phspline: a.csv:5: record b: $bad_says
$(failed 1 3)"
csv 'a row too short among others' '1 "a" "b" "c" [3,4] absent [5,6]' \
  'id,x,y\na,0,0\na,3,4\nb,0,0\nb,1\nc,0,0\nc,5,6\n'
csv 'a row too long among others' '1 "a" "b" "c" [3,4] absent [5,6]' \
  'id,x,y\na,0,0\na,3,4\nb,0,0\nb,1,1,1\nc,0,0\nc,5,6\n'
csv 'a quote that never ends' '3 "a" absent [3,4] absent' \
  'id,x,y\na,0,0\na,3,4\nb,"0,0\nb,5,6\n'
expect 'the error is about the row' 3 \
  "phspline: a.csv:4: record 2: the quote that begins this cell is never \
closed [syntax]
$(failed 1 2)"
csv 'a quote that never ends, in the id' '3 "a" absent [3,4] absent' \
  'id,x,y\na,0,0\na,3,4\n"b,0,0\nb,5,6\n'
csv 'a quote that never ends, within a problem' '3 absent absent' \
  'id,x,y\na,0,0\na,3,4\na,"5,6\n'
csv 'text behind a quote' '3 "a" absent [3,4] absent' \
  'id,x,y\na,0,0\na,3,4\nb,"0"0,0\nb,5,6\nc,0,0\nc,7,8\n'

# ---- cells -------------------------------------------------------------------

csv 'numbers as people write them' '0 absent [3,0.5]' 'x,y\n0,0\n+3.,.5\n'
csv 'numbers with exponents' '0 absent [300,0.04]' 'x,y\n0,0\n3e2,4E-02\n'
csv 'numbers with zeros in front' '0 absent [3,-4]' 'x,y\n-0,00\n003,-04\n'
csv 'numbers in quotes' "$one" 'x,y\n"0","0"\n"3" , "4"\n'
for cell in 1,5 0x10 1d3 1e 1e+ . + - -- '1 2' 1_000 '1\\,5' one; do
  csv "no number: $cell" '1 absent absent' "x,y\\n0,0\\n3,\"$cell\"\\n"
done
for cell in nan NaN -nan inf -inf +Infinity 1e309 -1e400; do
  csv "no finite number: $cell" '1 absent absent' "x,y\\n0,0\\n3,$cell\\n"
  equal "no finite number: $cell: its code" '"not-finite"' "$(get error.code)"
done
csv 'knots' '0 absent [3,4]' 'x,y,knot\n0,0,1\n3,4,1.5\n5,6,4\n'
equal 'knots are used' '[1,1.5] [1.5,4]' \
  "$(get 'segments[0].interval') $(get 'segments[1].interval')"
csv 'a column of knots that is empty' "$one" 'knot,x,y\n,0,0\n,3,4\n'
csv 'a column of knots with a gap' '1 absent absent' 'x,y,knot\n0,0,1\n3,4,\n'
csv 'a column of knots that is empty for one problem' \
  '0 "a" "b" [3,4] [5,6]' 'id,x,y,knot\na,0,0,\na,3,4,\nb,0,0,0\nb,5,6,7\n'
equal 'knots are those of their problem' '[0,5] [0,7]' \
  "$(get 'segments[0].interval')"
# A segment's number stands in the row in which it ends.
run planar --basis=atph - <<'END'
x,y,alpha
0,0,
3,4,0.5
5,6,0.7
END
equal 'angles of an open curve' '[0.5] [0.7]' "[$(get 'segments[0].alpha')] [$(get 'segments[1].alpha')]"
run planar --basis=atph --closed - <<'END'
x,y,alpha
0,0,0.9
3,4,0.5
5,0,0.7
END
equal 'angles of a closed curve' '0.5 0.9' \
  "$(get 'segments[0].alpha') $(get 'segments[2].alpha')"
run planar --basis=atph - <<'END'
x,y,alpha
0,0,
3,4,
5,6,0.7
END
equal 'a gap in the angles' '1 "bad-value"' "$status $(get error.code)"

csv 'options fill in what has no column' "$one" "$two" --knots='[0,2]'
equal 'options fill in: knots' '[0,2]' "$(get 'segments[0].interval')"
csv 'a closed curve, its first point repeated' '0 absent [3,4]' \
  'x,y\n0,0\n3,4\n6,0\n0,0\n' --closed
equal 'the repeated point is dropped' 'true absent' \
  "$(get closed) $(get 'segments[3]')"

# ---- --columns ---------------------------------------------------------------

csv 'names for a file without header' "$one" '0,0\n3,4\n' --columns=x,y
csv 'names in another order' "$one" '0,0\n4,3\n' --columns=y,x
csv 'columns skipped' "$one" '9,0,0,a\n8,3,4,b\n' --columns=-,x,y,-
csv 'columns skipped, whatever is in them' "$one" \
  'nan,0,0\n"a,b",3,4\n' --columns=-,x,y
csv 'an id' '0 "a" "b" [3,4] [5,6]' 'a,0,0\na,3,4\nb,0,0\nb,5,6\n' \
  --columns=id,x,y
csv 'names over a header that is not known' "$one" 'east,north\n0,0\n3,4\n' \
  --columns=x,y
csv 'names over a header that is' "$one" 'y,x\n0,0\n3,4\n' --columns=x,y
csv 'names over a first line' "$one" '# y,x\n0,0\n3,4\n' --columns=x,y
csv 'a header over a column that is skipped' "$one" \
  'x,y,speed\n0,0,1\n3,4,1\n' --columns=x,y,-
csv 'capitals and blanks in names' "$one" '0,0\n3,4\n' --columns=' X , Y_M '
csv 'fewer names than cells' '3 absent absent' '0,0,0\n3,4,0\n' --columns=x,y
csv 'more names than cells' '1 absent absent' '0,0\n3,4\n' --columns=x,y,-
csv 'a later row with more cells' '1 absent absent' '0,0\n3,4,5\n' --columns=x,y
printf 'x;y\n0;0\n3;4\n' >b.csv
printf '5 0 0\n5 3 4\n' >c.csv
csv 'names are for every file' '0 absent absent [3,4] [3,4]' '0,0\n3,4\n' \
  --columns=x,y a.csv

# ---- --delimiter -------------------------------------------------------------

csv 'a semicolon' "$one" 'x;y\n0;0\n3;4\n' --delimiter=';'
csv 'a semicolon in a first line' "$one" '# y;x\n0;0\n4;3\n' --delimiter=';'
csv 'a tab, typed' "$one" 'x\ty\n0\t0\n3\t4\n' --delimiter='\t'
csv 'a tab' "$one" 'x\ty\n0\t0\n3\t4\n' --delimiter="$(printf '\t')"
csv 'a blank' "$one" 'x y\n0 0\n3 4\n' --delimiter=' '
csv 'a bar, and --columns with commas' "$one" '0|0\n4|3\n' --delimiter='|' \
  --columns=y,x
csv 'a comma within quotes' '0 "a;b" [3,4]' \
  'id;x;y\n"a;b";0;0\n"a;b";3;4\n' --delimiter=';'
csv 'the wrong one' '3 absent absent' 'x;y\n0;0\n3;4\n' --delimiter=,

# ---- delimiters that the first row tells --------------------------------------

csv 'semicolons' "$one" 'x;y\n0;0\n3;4\n'
csv 'semicolons without a header' "$one" '0;0\n3;4\n'
csv 'tabs' "$one" 'y\tx\n0\t0\n4\t3\n'
csv 'blanks' "$one" '0 0\n3 4\n'
csv 'blanks of GNU spline and gnuplot' '0 absent absent [3,4] [5,6]' \
  ' 0 0 \n3  4\n\n0   0\n 5\t 6\n'
csv 'blanks of numpy.savetxt' "$one" \
  '0.000000000000000000e+00 0.0e+00\n3.000000000000000000e+00 4.0e+00\n'
csv 'a header between blanks' "$one" 'y x\n0 0\n4 3\n'
csv 'a first line between blanks' "$one" '# y x\n0 0\n4 3\n'
csv 'a first line between blanks, rows with commas' "$one" '# y x\n0,0\n4,3\n'
csv 'a first line between commas, rows with tabs' "$one" '# y,x\n0\t0\n4\t3\n'
csv 'a comma wins over a semicolon in a cell' '0 "a;b" [3,4]' \
  'id,x,y\na;b,0,0\na;b,3,4\n'
csv 'quoted cells between semicolons' '0 "a;b" [3,4]' \
  '"id";"x";"y"\n"a;b";"0";"0"\n"a;b";"3";"4"\n'
csv 'a line break in the first row' '0 absent [3,4]' \
  '"a\nb";0;0\n1;3;4\n' --columns=-,x,y
csv 'as many cells as --columns names' '0 "a" [3,4]' 'a 0 0\na 3 4\n' \
  --columns=id,x,y
csv 'text, whatever the first row has' '1 absent absent' '0,0\n3,4\n' -i text \
  --columns=x,y
csv 'text' "$one" '0\t0\n 3 4\n' -i text
csv 'a sentence is no header' '3 absent absent' 'to x or y\n0 0\n3 4\n'
for text in '0;0,5\n1;1,5\n' '0 0,5\n1 1\n' '0\t0,5\n1\t1\n'; do
  csv "decimal commas: $text" '1 absent absent' "$text"
  expect "decimal commas: $text: the remedy" 1 "phspline: a.csv:1: record 1: \
points[0]: needs a number in column y, found \"0,5\"; numbers have a decimal \
point (tr , . turns commas into points) [bad-type]
$(failed 1 1)"
done

for cell in '"1,234.5"' "1'234.5" '1 234.5' '1.234,5'; do
  csv "thousands: $cell" '1 absent absent' "x;y\n0;0\n1;$cell\n"
  expect "thousands: $cell: what is wrong" 1 "phspline: a.csv:3: record 1: \
points[1]: needs a number in column y, found \"$(echo "$cell" | tr -d '"')\"; \
numbers have no thousands separators [bad-type]
$(failed 1 1)"
done

# foreign NAME WHAT TEXT: what is no table is called by its name
foreign() {
  # shellcheck disable=SC2059
  printf "$3" >foreign
  run planar foreign
  expect "$1" 3 "phspline: foreign:1: record 1: the input is $2 [syntax]
$(failed 1 1)"
}
foreign 'gzip' 'compressed by gzip: gunzip unpacks it' '\037\213\010\n'
utf16='UTF-16: iconv -f UTF-16 -t UTF-8 converts it'
foreign 'UTF-16' "$utf16" '\377\376x\000,\000y\000\n\000'
foreign 'UTF-16, the other way round' "$utf16" '\376\377\000x\000,\000y\000\n'
foreign 'xlsx' 'a spreadsheet or other zip archive: spreadsheets can be saved as CSV' 'PK\003\004,"a"b\n'
printf '<svg/>\n' >foreign
run planar -q -i csv foreign
expect 'XML that is read as CSV' 3 'phspline: foreign:1: record 1: the input is XML or HTML: --input-format=svg and gpx read SVG and GPX [syntax]'
foreign 'WKT' 'WKT: ogr2ogr -f GeoJSON converts it' \
  'LINESTRING (0 0, 1 1)\n'
printf '{\n"type": "LineString"}\n' >foreign
run planar -q -i csv foreign
expect 'JSON that is read as CSV' 3 'phspline: foreign:1: record 1: the input is JSON: --input-format=json and geojson read it [syntax]'
csv 'longitudes in the plane' '3 absent absent' 'Longitude,Latitude\n0,0\n1,2\n'
expect 'longitudes in the plane: the remedy' 3 "phspline: a.csv:1: record 1: \
column \"Longitude\" is unknown to planar, but not to sphere [unknown-field]
$(failed 1 1)"
foreign 'NumPy' 'an array of NumPy: numpy.savetxt writes it as text' \
  "\\223NUMPY\\001\\000v\\000{'shape': (7, 2)}\\n"
# remedy NAME COLUMN REMEDY HEADER: a header without coordinates
remedy() {
  csv "$1" '3 absent absent' "$4\n0;0;0\n1;1;1\n"
  expect "$1: the remedy" 3 "phspline: a.csv:1: record 1: column \"$2\" is unknown \
to planar ($3) [unknown-field]
$(failed 1 1)"
}
remedy 'columns of other names' Easting \
  '--columns=x=NAME,y=NAME takes columns by their names' 'Easting;Northing;Name'
csv 'columns of other names, ignored' '3 absent absent' \
  'Easting;Northing\n0;0\n1;1\n' --ignore-columns
expect 'columns of other names, ignored: the remedy' 3 "phspline: a.csv:1: record \
1: column \"Easting\" is unknown to planar (--columns=x=NAME,y=NAME takes columns \
by their names) [unknown-field]
$(failed 1 1)"
remedy 'WKT in a column' geom 'ogr2ogr -f GeoJSON converts WKT' 'geom;a;b'
remedy 'a column beside points' geom '--ignore-columns skips it' 'x;y;geom'
csv 'no WKT' '3 absent absent' 'POINTS,x\n0,0\n'

# ---- columns by their names, columns that are unknown --------------------------

survey='Station;Northing;Easting\nA1;0;0\nA2;4;3\n'
csv 'columns by name' "$one" "$survey" --columns=x=Easting,y=Northing
csv 'an id by name' '1 "A1" "A2" absent absent' "$survey" \
  --columns=id=Station,x=Easting,y=Northing
csv 'names in a first line' "$one" '# E N h\n0 0 1\n3 4 1\n' --columns=x=E,y=N
csv 'a name with a comma' "$one" '"E, m",N\n0,0\n3,4\n' \
  --columns='"x=E, m",y=N'
csv 'a name that is not there' '3 absent absent' "$survey" \
  --columns=x=Easting,y=Grid
expect 'a name that is not there: which' 3 "phspline: a.csv:1: record 1: the \
header row has no column \"Grid\", which --columns names [missing-field]
$(failed 1 1)"
csv 'a name misspelt' '3 absent absent' "$survey" --columns=x=Easting,y=Northin
expect 'a name misspelt: which is meant' 3 "phspline: a.csv:1: record 1: the \
header row has no column \"Northin\", which --columns names; did you mean \
\"Northing\"? [missing-field]
$(failed 1 1)"
csv 'names but no header' '3 absent absent' '0;0\n3;4\n' --columns=x=E,y=N
expect 'names but no header: why' 3 "phspline: a.csv:1: record 1: the file has \
no header row with the names of --columns [syntax]
$(failed 1 1)"
for columns in x=E,y x=E,=N x=E,y=; do
  run planar --columns="$columns" a.csv
  equal "--columns=$columns" 2 "$status"
done
csv 'unknown columns' "$one" ',x,y,speed\n0,0,0,1\n1,3,4,2\n' --ignore-columns
csv 'unknown columns between blanks' "$one" 'x y speed\n0 0 1\n3 4 1\n' \
  --ignore-columns
csv 'a third column' "$one" '0 0 0\n3 4 0\n' --ignore-columns

# ---- tables of ours ------------------------------------------------------------

# again NAME POINTS OPTION...: a table of one problem after another is read as
# as many problems, with all points and every joint once
printf 'id,x,y\na,0,0\na,3,4\na,6,0\nb,0,0\nb,3,4\n' >a.csv
again() {
  name=$1 wanted=$2
  shift 2
  for format in csv text; do
    run planar --format="$format" "$@" a.csv
    cp out table
    run planar --table=lengths table
    equal "$name, $format" "$wanted" \
      "$status $(sed 1d out | cut -d, -f1 | uniq -c | tr -s ' \n' ' ')"
  done
}
again 'samples' '0  4 a 2 b ' --table=samples --sample=2
again 'control points' '0  10 a 5 b ' --table=control-points
again 'samples of a sweep' '0  8 a 4 b ' --table=samples --sample=2 \
  --sweep=knots=uniform,centripetal
run planar --table=samples --sample=2 --offset=0.5 a.csv
cp out table
run planar table
equal 'samples of offsets' '0 "a" "a" "b" "b"' "$status $(get id)"
equal 'the first place of an offset is the second of its curve' 2 \
  "$(get 'segments[3].control_points[5]' | tr ' ' '\n' | grep -c '\[')"
printf 'id,segment,t,s,x,y\n1,0,0,0,0,0\n1,0,1,1,1,0\n1,1,0,1,1,0\n1,1,1,1,,0\n' \
  >table
run planar table
expect 'lines of what is read are those of the table' 1 \
  "phspline: table:5: record 1: points[2]: needs a number in column x, found an \
empty cell [bad-value]
$(failed 1 1)"
printf 'x\ty\n0\t0\n3\t4\n' >a.tsv
printf 'id\tx\ty\n"a\tb"\t0\t0\n"a\tb"\t3\t4\n' >b.TSV
printf 'x,y\n0,0\n3,4\n' >c.tsv
run planar a.tsv b.TSV
equal 'the suffix .tsv' '0 absent "a\u0009b" [3,4] [3,4]' \
  "$status $(get id) $(get 'segments[0].control_points[5]')"
run planar --delimiter=, c.tsv
equal '--delimiter beats .tsv' '0 [3,4]' \
  "$status $(get 'segments[0].control_points[5]')"
printf 'x,y\n0,0\n3,4\n' >a.csv
run planar a.csv a.tsv a.csv
equal 'each file has its own' '0 [3,4] [3,4] [3,4]' \
  "$status $(get 'segments[0].control_points[5]')"
feed 'y,x
0,0
4,3
' planar
equal 'standard input' '0 [3,4]' \
  "$status $(get 'segments[0].control_points[5]')"
feed 'y	x
0	0
4	3
' planar -i csv --delimiter='\t' -
equal 'standard input, with tabs' '0 [3,4]' \
  "$status $(get 'segments[0].control_points[5]')"

# ---- ids that would read as something else ---------------------------------------

for id in '#x' ' x' 'x '; do
  feed "{\"id\":\"$id\",\"points\":[[0,0],[1,1],[3,0]]}" planar --table=samples \
    --sample=2
  expect "id '$id': written" 0 ''
  equal "id '$id': quoted" "\"$id\"," "$(sed -n '2s/,.*/,/p' out)"
  sed 1d out | awk -F, -v OFS=, 'BEGIN { print "id,x,y" } { print $1, NR, NR % 2 }' >id.csv
  run planar --table=lengths id.csv
  expect "id '$id': read again" 0 ''
  equal "id '$id': the same" "\"$id\"" "$(sed -n '2s/,.*//p' out)"
done
