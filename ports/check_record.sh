#!/bin/sh
# usage: check_record.sh RECORD COMPILER_VERSION COMMAND...
# Runs COMMAND; it must succeed, and its output must stand in the file RECORD, line by line in one piece. Records hold
# for one version of the compiler, which they name as `GCC VERSION`; with another the output is only shown.
set -eu

record=$1
version=$2
shift 2
output=$("$@") || { printf '%s\n' "$output"; exit 1; }
[ -n "$output" ] || { echo "nothing was measured" >&2; exit 1; }
printf '%s\n' "$output"
if ! grep -q -F "GCC $version" "$record"; then
  echo "not compared: $record was not recorded with GCC $version"
  exit 0
fi
case "$(cat "$record")" in
  *"$output"*) ;;
  *)
    echo "these are not the figures in $record; replace them there if the change is meant" >&2
    exit 1
    ;;
esac
