#!/bin/sh
# usage: sizes.sh [--check RECORD COMPILER_VERSION] TARGET SIZE_TOOL [IMAGE FILE]...
# Prints a row for each image: bytes of flash, of RAM besides the stack, and of the greatest stack when it runs on the
# target's board. With --check every row must stand in RECORD, with no figure that is more than 2 % greater than there.
# Records hold for one version of the compiler, which they name as `GCC VERSION`; with another the rows are only shown.
set -eu

record=""
if [ "$1" = --check ]; then
  record=$2
  version=$3
  shift 3
fi
target=$1
size_tool=$2
shift 2
toolchains=$(dirname -- "$0")/../toolchains

measure() {
  while [ $# -ge 2 ]; do
    stack=$(NEARFIELD_QEMU_ICOUNT=off "$toolchains/qemu.sh" "$target" "$2" | sed -n 's/^stack \([0-9]*\)$/\1/p')
    [ -n "$stack" ] || { echo "$1 does not run" >&2; return 1; }
    "$size_tool" -A "$2" | awk -v target="$target" -v image="$1" -v stack="$stack" '
      $1 == ".text" || $1 == ".data" { flash += $2 }
      $1 == ".data" || $1 == ".bss" { ram += $2 }
      END {
        gsub("_", " ", image)
        printf "| `%s` | %s | %d | %d | %d |\n", target, image, flash, ram, stack
      }'
    shift 2
  done
}

rows=$(measure "$@")
printf '%s\n' "$rows"
[ -n "$record" ] || exit 0
if ! grep -q -F "GCC $version" "$record"; then
  echo "not compared: $record was not recorded with GCC $version"
  exit 0
fi
printf '%s\n' "$rows" | awk -F ' *[|] *' '
  NR == FNR { if (NF == 7) recorded[$2, $3] = $4 " " $5 " " $6; next }
  !(($2, $3) in recorded) { print $2 ", " $3 ": not in the record"; failed = 1; next }
  {
    split(recorded[$2, $3], before, " ")
    split("flash RAM stack", name, " ")
    for (i = 1; i <= 3; ++i) {
      if ($(3 + i) * 100 <= before[i] * 102) continue
      print $2 ", " $3 ": " name[i] " grew from " before[i] " to " $(3 + i) " bytes"
      failed = 1
    }
  }
  END { if (failed) print "./run sizes replaces the figures in the record, if the growth is meant"; exit failed }
' "$record" -
