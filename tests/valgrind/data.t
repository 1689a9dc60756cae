# SPDX-License-Identifier: GPL-3.0-or-later
#
# Solves each of data/*.csv with the program given by PHSPLINE, under valgrind
# in `make valgrind', where status 9 is a memory error, and verifies what comes
# of it.  Whether the method suits the data is not asked: a refusal takes a path
# that is worth a look, of the problem (1) or of columns that the method does not
# have (3).
set -eu
bad=0

for file in "$srcdir"/data/*.csv; do
  name=${file##*/}
  if [ ! -f "$file" ]; then
    echo 'skip data: no data/*.csv'
    continue
  fi
  for method in planar spatial-hermite arclength sphere tc; do
    status=0 verdict=0
    "$PHSPLINE" $method --offset=0.1 --sample=1 "$file" >out 2>err || status=$?
    "$PHSPLINE" verify --problems="$file" out >verdicts 2>>err || verdict=$?
    case $status$verdict in
    [013][013]) echo "ok $method $name (exit status $status, $verdict)" ;;
    *)
      echo "not ok $method $name: exit status $status, $verdict"
      cat err
      bad=1
      ;;
    esac
  done
done
exit "$bad"
