#!/bin/sh
# Nearfield installed into a folder and used from there: found by CMake in C++, and from C with nothing but
# the header and the static library, linked without a C++ library. Both give the same answers.
set -eu
source_dir=${NEARFIELD_SOURCE_DIR:-$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)}
cmake=${CMAKE:-cmake}
here=$PWD
rm -rf prefix core package

"$cmake" -G Ninja -S "$source_dir" -B core -DCMAKE_BUILD_TYPE=Release -DNEARFIELD_BUILD_HOST=OFF \
  -DNEARFIELD_BUILD_TESTS=OFF -DCMAKE_INSTALL_LIBDIR=lib
"$cmake" --build core
"$cmake" --install core --prefix "$here/prefix"

"$cmake" -G Ninja -S "$source_dir/tests/consume/package" -B package -DCMAKE_PREFIX_PATH="$here/prefix" \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
"$cmake" --build package
./package/write_answers field.image answers.txt

if grep -rIl "$source_dir" prefix; then
  echo "FAILED: what is installed, above, refers to the sources" >&2
  exit 1
fi

compiler=${CC:-cc}
if ! command -v "$compiler" >/dev/null 2>&1; then
  echo "skipped: there is no C compiler $compiler"
  exit 77
fi
"$compiler" -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I prefix/include \
  "$source_dir/tests/consume/c/compare_answers.c" prefix/lib/libnearfield_core.a -o compare_answers
./compare_answers field.image answers.txt
