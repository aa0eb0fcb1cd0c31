#!/bin/sh
# The firmware examples of README.md: taken out of the page, compiled as they stand with warnings as errors,
# run, and answering what the page prints; where there is an Arm compiler, compiled for a Cortex-M4 as well.
set -eu
source_dir=${NEARFIELD_SOURCE_DIR:-$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)}
compiler=${CXX:-g++}
c_compiler=${CC:-cc}
page=$source_dir/README.md
include=$source_dir/firmware_core/include
rm -rf extracted
mkdir extracted

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# Each block follows a line <!-- example: FILE -->.
awk '/^<!-- example: [a-z_.]+ -->$/ { name = "extracted/" $3; next }
     /^```/ { if (inside) { inside = 0; name = "" } else if (name != "") { inside = 1; printf "" >name }; next }
     inside { print >name }' "$page"
for file in firmware.hpp image.hpp curve.hpp example.c answers.txt; do
  [ -s "extracted/$file" ] || fail "README.md has no block <!-- example: $file -->"
done
grep -q static_assert extracted/firmware.hpp || fail "the example asserts nothing"

warnings="-Wall -Wextra -Werror"
cxx_flags="-std=c++17 $warnings -I extracted -I $include"
# shellcheck disable=SC2086
"$compiler" $cxx_flags -c "$source_dir/tests/consume/readme/print_answers.cpp" -o print_answers.o
# shellcheck disable=SC2086
"$c_compiler" -std=c99 $warnings -I "$include" -c extracted/example.c -o example.o
library=${NEARFIELD_BUILD_DIR:?}/firmware_core/libnearfield_core.a
"$compiler" print_answers.o example.o "$library" -o print_answers
./print_answers >printed.txt || fail "image, C and composition do not agree"
diff -u extracted/answers.txt printed.txt || fail "README.md prints other answers than its example"

cat extracted/firmware.hpp extracted/curve.hpp >curve.cpp
# shellcheck disable=SC2086
"$compiler" $cxx_flags -fsyntax-only curve.cpp

# An assertion that is broken must not compile, or those of the page prove nothing.
sed 's/\.gradient < [0-9]*/.gradient < 1/' extracted/firmware.hpp >broken.hpp
# shellcheck disable=SC2086
if "$compiler" $cxx_flags -fsyntax-only -x c++ broken.hpp 2>broken.log; then fail "a broken budget compiles"; fi
grep -q 'static.assert' broken.log || fail "$(cat broken.log)"

if ! command -v arm-none-eabi-g++ >/dev/null 2>&1; then
  echo "not compiled for a target: there is no arm-none-eabi-g++"
  exit 0
fi
arm_flags="-mcpu=cortex-m4 -mthumb -mfloat-abi=soft -O2 -ffreestanding -ffp-contract=off $warnings"
cat extracted/firmware.hpp extracted/image.hpp extracted/curve.hpp >firmware.cpp
cat >>firmware.cpp <<'END'
Q speed_at(const nf::Vector3<Q>& tool) { return allowed_speed(tool); }
nf::Clearance<Q> image_at(const void* image, size_t size, const nf::Vector3<Q>& p) {
  return clearance_in_image(image, size, p);
}
Q potential_at(Q r) { return own_potential(r); }
END
# shellcheck disable=SC2086
arm-none-eabi-g++ -std=c++17 $arm_flags -nostdinc++ -fno-exceptions -fno-rtti -I "$include" -c firmware.cpp
# shellcheck disable=SC2086
arm-none-eabi-gcc -std=c99 $arm_flags -I "$include" -c extracted/example.c -o example_arm.o
arm-none-eabi-size firmware.o example_arm.o
