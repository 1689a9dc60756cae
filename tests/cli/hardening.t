# SPDX-License-Identifier: GPL-3.0-or-later
#
# How the program was linked: what build/*/hardening lists is in it.  Needs
# readelf, of the binutils.
. "$srcdir/tests/cli/lib.sh"

list=${PHSPLINE%/*}/hardening
if instrumented || [ ! -f "$list" ]; then
  echo 'skip hardening: not beside sanitizers and coverage'
  exit 0
fi
if ! command -v readelf >/dev/null 2>&1 || ! readelf -h "$PHSPLINE" >elf 2>&1
then
  echo 'skip hardening: no readelf, or no ELF file'
  exit 0
fi
readelf -W -d -l -s "$PHSPLINE" >>elf

# listed FLAG NAME PATTERN...: if the flag was used, the patterns are in the ELF
listed() {
  if ! sed 1d "$list" | grep -q -e "$1"; then
    echo "skip $2: the compiler or its flags do without $1"
    return
  fi
  name=$2
  shift 2
  for pattern; do
    true_that "$name: $pattern" grep -q -e "$pattern" elf
  done
}
listed -pie 'position independent' 'Type: *DYN' 'FLAGS_1.*PIE'
listed -z,relro 'relocations are read-only' GNU_RELRO
listed -z,now '... and made at once' 'BIND_NOW\|FLAGS_1.*NOW'
listed -fstack-protector 'stacks are guarded' '__stack_chk_fail'
listed FORTIFY_SOURCE 'copies are checked' '__[a-z]*_chk'
