# SPDX-License-Identifier: GPL-3.0-or-later
#
# Trimmed offsets, as independent programs have found them: polygons of three
# densities, whose offsets were extrapolated, distances to 4e5 points, or a
# formula.
#
# A problem of tests/vectors/offset-trim.ndjson brings what is known in `meta':
#   command, options  what is asked for
#   data              a file of points in place of the problem's, or its reverse
#   track             such a file of the folder PH_TRACKS: the center lines of
#                     github.com/TUMFTM/racetrack-database, which is not ours
#   loops             numbers of closed loops that are right
#   open              of open ones
#   area, length      sums over all loops, and by how much they may differ
. "$srcdir/tests/cli/lib.sh"

# told NAME: a member of meta, without quotes and brackets
told() {
  sed -n 's/.*"'"$1"'":\("[^"]*"\|\[[^]]*\]\|[0-9]*\)[,}].*/\1/p' meta |
    tr -d '"[]'
}

# closed WHETHER: how many loops are
closed() {
  sed 's/.*"loops":\[{/{/' out | grep -o "{\"closed\":$1" | wc -l | tr -d ' '
}

# near FOUND VALUE,TOLERANCE
near() {
  awk -v x="$1" -v of="$2" 'BEGIN {
    split(of, y, ",")
    d = x - y[1]
    exit !((d < 0 ? -d : d) <= 1.01 * y[2])
  }'
}

while read -r line; do
  one_in 7 || continue
  printf '%s\n' "$line" | sed 's/}.*/}/' >meta
  printf '%s\n' "$line" >in.json
  case=$(told name)
  data=$(told data)
  track=$(told track)
  if [ -n "$track" ] && [ ! -r "${PH_TRACKS:-/none}/$track" ]; then
    echo "skip $case: no $track in PH_TRACKS"
    continue
  fi
  set -- "$(told command)" -q --offset-mode=trimmed
  for option in $(told options); do
    set -- "$@" "$option"
  done
  file=${track:+$PH_TRACKS/$track}
  file=${file:-${data:+$srcdir/${data%% *}}}
  if [ -n "$file" ]; then
    grep -v '^[#x]' "$file" | cut -d, -f1,2 | awk -v back="${data##* }" '
      { row[NR] = $0 }
      END {
        for (i = 1; i <= NR; i++)
          print back == "reversed" ? row[NR + 1 - i] : row[i]
      }' >in.csv
    case $line in
      *'"closed":true'*) set -- "$@" --closed ;;
    esac
    run "$@" --columns=x,y in.csv
  else
    run "$@" in.json
  fi
  expect "$case" 0
  loops=$(told loops)
  case ,$loops, in
    ,, | *,"$(closed true)",*) ;;
    *) fail "$case: loops" "$(closed true) in place of $loops" ;;
  esac
  open=$(told open)
  [ -z "$open" ] || equal "$case: open" "$open" "$(closed false)"
  for sum in area length; do
    known=$(told $sum)
    if [ -n "$known" ]; then
      true_that "$case: $sum" near "$(get "offsets[0].$sum")" "$known"
    fi
  done
  cat out >>records
done <"$srcdir/tests/vectors/offset-trim.ndjson"

run verify records
expect 'all verified' 0
