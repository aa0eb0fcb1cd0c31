#!/bin/sh
# usage: qemu-mps2.sh IMAGE [ARGUMENT...]
# Runs an image of ports/mps2 in QEMU. Its output goes to standard output, its exit status is the result;
# 124 when it has not ended after NEARFIELD_QEMU_SECONDS (default 600). Every instruction takes 256 ns of the
# board's time, so the board's timers count instructions. NEARFIELD_QEMU_ICOUNT=off runs without that.
set -eu

if [ $# -eq 0 ]; then
  sed -n '2,5s/^# //p' "$0" >&2
  exit 2
fi
image=$1

configuration="enable=on,target=native,chardev=console"
for argument in "$@"; do
  # A comma separates QEMU's options; a doubled one stands for itself.
  configuration="$configuration,arg=$(printf '%s' "$argument" | sed 's/,/,,/g')"
done

set -- -M mps2-an386 -display none -monitor none -serial none -chardev stdio,id=console,signal=off \
  -semihosting-config "$configuration"
if [ "${NEARFIELD_QEMU_ICOUNT:-on}" != off ]; then
  set -- "$@" -icount shift=8,align=off,sleep=off
fi
exec timeout --kill-after=5 "${NEARFIELD_QEMU_SECONDS:-600}" \
  qemu-system-arm "$@" -kernel "$image" </dev/null
