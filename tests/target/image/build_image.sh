# Sourced by the scripts of tests/target: builds the image of the default work cell in the folder ./image of
# the caller, from a clean configuration of the preset cortex-m4. Sets `image` and `library` (the target nearfield_core). Reads
# NEARFIELD_SOURCE_DIR, NEARFIELD_BUILD_DIR (a host build) and CMAKE; each has a default for runs by hand.

source_dir=${NEARFIELD_SOURCE_DIR:-$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)}
host_tool=${NEARFIELD_BUILD_DIR:-$source_dir/build/host}/host_sim/nearfield
image_build=$PWD/image
image=$image_build/ports/mps2/work_cell.elf
library=$image_build/firmware_core/libnearfield_core.a

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# skip_without PROGRAM...: ends the test as skipped (77) if one of them is missing.
skip_without() {
  for program in "$@"; do
    if ! command -v "$program" >/dev/null 2>&1; then
      echo "skipped: $program is not installed"
      exit 77
    fi
  done
}

quietly() {
  if ! "$@" >"$image_build/log" 2>&1; then
    tail -n 60 "$image_build/log" >&2
    fail "$*"
  fi
}

# build_image [TARGET...]: and other targets of that configuration.
build_image() {
  [ -x "$host_tool" ] || fail "$host_tool is not built"
  mkdir -p "$image_build/generated"
  quietly "${CMAKE:-cmake}" -S "$source_dir" --preset cortex-m4 -B "$image_build" -DNEARFIELD_BUILD_TESTS=OFF
  quietly "$host_tool" bake --output "$image_build/generated/work_cell.inc"
  quietly "${CMAKE:-cmake}" --build "$image_build" --target work_cell "$@"
}
