# SPDX-License-Identifier: GPL-3.0-or-later
#
# bench/results and bench/quote, on benchmarks that say what they are told.
. "$srcdir/tests/cli/lib.sh"

mkdir -p tree/bench build
cp "$srcdir/bench/results" "$srcdir/bench/quote" tree/bench/
printf '#!/bin/sh\necho phspline 1.2.3\n' >build/phspline
chmod +x build/phspline
cat >tree/bench/run <<'END'
echo 'Rows  '
echo
echo '  ours    -n 5   0.20    1.00'
echo '  theirs         0.60    3.00'
echo 'The end of the benchmarks.'
END
cat >tree/bench/README <<'END'
Other
-----
  theirs         0.10    0.10

How fast
--------
  theirs         9.99    9.99
  ours    -n 5   9.99    1.00
text 5

Next
----
  theirs         0.10    0.10
END
CC=false CFLAGS=-O7 sh tree/bench/results build tree/bench/RESULTS.md >shown
equal 'shown as they go' "$(sh tree/bench/run)" "$(cat shown)"
true_that 'the rows are in the file' grep -q '^  theirs  *0.60    3.00$' \
  tree/bench/RESULTS.md
for what in 'commit: [^ ]' 'date: 20[0-9-]*$' 'machine: .* processors' \
  'compiler: .*-O7$' 'load .* at the end$' 'peers: GSL '; do
  true_that "the file says $what" grep -q "^- $what" tree/bench/RESULTS.md
done
equal 'nothing but rows after the head' "\`\`\`
Rows

  ours    -n 5   0.20    1.00
  theirs         0.60    3.00
\`\`\`" "$(sed -n '/^```/,$p' tree/bench/RESULTS.md)"
equal 'README quotes it, in its section' '  theirs         0.10    0.10
  theirs         0.60    3.00
  ours    -n 5   0.20    1.00
  theirs         0.10    0.10' "$(grep '^  ' tree/bench/README)"
sed 's/0.60/0.70/' tree/bench/README >other
true_that 'what is quoted is found' sh tree/bench/quote tree/bench/RESULTS.md \
  tree/bench/README check
equal 'what is not is told' 1 "$(sh tree/bench/quote tree/bench/RESULTS.md \
  other check >differs; echo $?)"
cp tree/bench/RESULTS.md before
sed '/The end/d' tree/bench/run >fails
mv fails tree/bench/run
equal 'benchmarks that break off' 1 "$(sh tree/bench/results build \
  tree/bench/RESULTS.md >shown; echo $?)"
equal_files 'leave the file' before tree/bench/RESULTS.md
