#!/bin/sh
# Nearfield's sources as a part of another project.
set -eu
source_dir=${NEARFIELD_SOURCE_DIR:-$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)}
cmake=${CMAKE:-cmake}
rm -rf build
"$cmake" -G Ninja -S "$source_dir/tests/consume/subdirectory" -B build -DNEARFIELD_SOURCE_DIR="$source_dir"
"$cmake" --build build
./build/keep_out
