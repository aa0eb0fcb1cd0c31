#!/bin/sh
# usage: chosen_code.sh TOOL_PREFIX IMAGE OTHER_IMAGE
# IMAGE has a static field of a sphere, a box, a capsule and a cylinder, united: no instruction of it may come from any other
# operation, from programs or from tables, and it may have no constants of theirs. OTHER_IMAGE has more, which must be found.
set -eu

prefix=$1

# The headers that instructions come from, those in line included. Not what is data or between functions: sections that were
# not linked have addresses from 0 on in the debugging information, and would seem to be there.
headers() {
  "${prefix}objdump" -d --no-show-raw-insn "$1" | grep -E -v '	(nop|movs	r0, r0|c?\.?unimp)' |
    sed -n -E 's/^ *([0-9a-f]+):	[a-z][a-z0-9.]*(	.*)?$/0x\1/p' |
    "${prefix}addr2line" -i -e "$1" | sed -n 's,^.*/nearfield/\([a-z]*/[a-z_]*\.hpp\):.*,\1,p' | sort -u
}
# Of these, what a field of those shapes has no need of.
others() {
  headers "$1" | grep -E -v -x -e 'number/.*' -e 'query/clearance\.hpp' -e 'field/(apply|compose|slots)\.hpp' \
    -e 'shape/(sphere|box|capsule|cylinder|sample|certificate|operands|payload)\.hpp' -e 'blend/sharp\.hpp' || true
}

headers "$2" | grep -q -x 'shape/cylinder.hpp' || { echo "$2 does not tell where its code is from" >&2; exit 1; }
[ -n "$(others "$3")" ] || { echo "nothing of other operations is found in $3 either" >&2; exit 1; }
found=$(others "$2")
constants=$("${prefix}nm" -S -C "$2" | awk 'NF >= 4 && $3 ~ /^[rR]$/' || true)
if [ -n "$found$constants" ]; then
  echo "code or constants of other operations in $2:" >&2
  printf '%s\n' "$found" "$constants" >&2
  exit 1
fi
echo "code from" $(headers "$2")
