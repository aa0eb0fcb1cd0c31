#!/bin/sh
# usage: qemu.sh CORE IMAGE [ARGUMENT...]
# Runs an image of ports/ in QEMU, on the board with this core: the name of a toolchain file here. Its output goes to standard output, its exit status is the result; 124 when it has not ended after
# NEARFIELD_QEMU_SECONDS (default 600). Every instruction takes the same time on the board's clock, so that
# its timers count instructions: 256 ns on Arm; 1 ns on RISC-V, whose counter of instructions QEMU derives
# from the clock. NEARFIELD_QEMU_ICOUNT=off runs without that.
set -eu

print_usage() {
  sed -n '2,7s/^# //p' "$0" >&2
  exit 2
}
[ $# -ge 2 ] || print_usage

time_shift=8
case "$1" in
  cortex-m0) emulator="qemu-system-arm -M microbit" ;;
  cortex-m3) emulator="qemu-system-arm -M mps2-an385" ;;
  cortex-m4 | cortex-m4f) emulator="qemu-system-arm -M mps2-an386" ;;
  cortex-m7) emulator="qemu-system-arm -M mps2-an500" ;;
  cortex-m33) emulator="qemu-system-arm -M mps2-an505" ;;
  rv32imac) emulator="qemu-system-riscv32 -M virt -bios none" time_shift=0 ;;
  rv64imac) emulator="qemu-system-riscv64 -M virt -bios none" time_shift=0 ;;
  *) print_usage ;;
esac
shift
image=$1

configuration="enable=on,target=native,chardev=console"
for argument in "$@"; do
  # A comma separates QEMU's options; a doubled one stands for itself.
  configuration="$configuration,arg=$(printf '%s' "$argument" | sed 's/,/,,/g')"
done

set -- -display none -monitor none -serial none -chardev stdio,id=console,signal=off \
  -semihosting-config "$configuration"
if [ "${NEARFIELD_QEMU_ICOUNT:-on}" != off ]; then
  set -- "$@" -icount "shift=$time_shift,align=off,sleep=off"
fi
# $emulator is a command with its first arguments.
# shellcheck disable=SC2086
exec timeout --kill-after=5 "${NEARFIELD_QEMU_SECONDS:-600}" $emulator "$@" -kernel "$image" </dev/null
