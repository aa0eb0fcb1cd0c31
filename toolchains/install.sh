#!/bin/sh
# usage: install.sh host|cortex-m4|test
# Installs the Debian packages that a build needs and this machine lacks: `host` for the simulation,
# `cortex-m4` for that and its images in the emulator, `test` for everything. Without a missing package it
# does nothing.
set -eu

host_packages="g++ cmake ninja-build"
cortex_m4_packages="$host_packages gcc-arm-none-eabi binutils-arm-none-eabi qemu-system-arm"
# What -m32 needs, by its parts: g++-multilib cannot be installed beside a cross compiler.
linux_packages="g++-aarch64-linux-gnu qemu-user libc6-dev-i386 lib32gcc-12-dev"
wasm_packages="clang lld nodejs"
avr_packages="clang gcc-avr avr-libc simavr"
riscv_packages="gcc-riscv64-unknown-elf binutils-riscv64-unknown-elf qemu-system-misc"
case "${1:-}" in
  host) packages=$host_packages ;;
  cortex-m4) packages=$cortex_m4_packages ;;
  test)
    packages="$cortex_m4_packages $riscv_packages $linux_packages $wasm_packages $avr_packages gcc clang libclang-rt-14-dev
              libgtest-dev binutils"
    ;;
  *)
    sed -n '2,5s/^# //p' "$0" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null 2>&1; then
  echo "install.sh: not a Debian machine; these must be installed by hand: $packages" >&2
  exit 0
fi

# A tool that came another way (a newer CMake, say) serves as well as its package.
is_present() {
  case "$1" in
    cmake) command -v cmake >/dev/null 2>&1 && return 0 ;;
    ninja-build) command -v ninja >/dev/null 2>&1 && return 0 ;;
    g++ | gcc) command -v "$1" >/dev/null 2>&1 && return 0 ;;
    clang) command -v clang++ >/dev/null 2>&1 && return 0 ;;
    gcc-arm-none-eabi) command -v arm-none-eabi-g++ >/dev/null 2>&1 && return 0 ;;
    gcc-riscv64-unknown-elf) command -v riscv64-unknown-elf-g++ >/dev/null 2>&1 && return 0 ;;
    qemu-system-arm) command -v qemu-system-arm >/dev/null 2>&1 && return 0 ;;
    g++-aarch64-linux-gnu) command -v aarch64-linux-gnu-g++ >/dev/null 2>&1 && return 0 ;;
    qemu-user) command -v qemu-aarch64 >/dev/null 2>&1 && return 0 ;;
    lld) command -v wasm-ld >/dev/null 2>&1 && return 0 ;;
    nodejs) command -v node >/dev/null 2>&1 && return 0 ;;
    qemu-system-misc) command -v qemu-system-riscv32 >/dev/null 2>&1 && return 0 ;;
  esac
  dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q '^install ok installed$'
}

missing=""
for package in $packages; do
  is_present "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "install.sh: run as root, or install sudo, to get:$missing" >&2
    exit 1
  fi
  as_root="sudo"
fi

echo "installing:$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# $missing is a list of words, and $as_root is empty for root.
# shellcheck disable=SC2086
if ! { $as_root apt-get update &&
       $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing; \
     } >"$log" 2>&1; then
  tail -n 40 "$log" >&2
  exit 1
fi
