#!/bin/sh
# What the work cell's image and the static library may not contain: allocation, exceptions, double
# arithmetic, libm, constructors that run before main(), recursion. Prints the sizes, and the greatest stack
# by the call graph.
set -eu
. "$(dirname -- "$0")/image/build_image.sh"
skip_without arm-none-eabi-g++ arm-none-eabi-nm arm-none-eabi-objdump arm-none-eabi-readelf arm-none-eabi-size

allocation='malloc|calloc|realloc|reallocarray|free|aligned_alloc|memalign|posix_memalign|_?sbrk'
operators='_Zn[wa].*|_Zd[la].*'
exceptions='__cxa_.*|__gxx_.*|_Unwind_.*|__aeabi_unwind_.*|_ZSt.*|__dso_handle|atexit|abort'
type_information='_ZT[ISV].*|__dynamic_cast'
doubles='__aeabi_d.*|__aeabi_[a-z]+2d|__aeabi_cd.*|__[a-z]*df[a-z]*[0-9]?'
math='a?sinh?|a?cosh?|a?tanh?|atan2|sincos|sqrt|cbrt|hypot|pow|exp|exp2|expm1|log|log2|log10|log1p|erf'
math="$math|fma|fmod|modf|remainder|floor|ceil|l?l?round|trunc|l?l?rint|nearbyint|fabs|fmin|fmax|ldexp"
math="($math|frexp|scalbn|copysign)[fl]?"
forbidden="^($allocation|$operators|$exceptions|$type_information|$doubles|$math)\$"

# The net must catch what it is for.
for name in malloc free _Znwj _ZdlPv _ZnajRKSt9nothrow_t __cxa_throw __cxa_guard_acquire __cxa_pure_virtual \
            __aeabi_dadd __aeabi_f2d __aeabi_d2f __aeabi_ui2d __aeabi_cdcmple __adddf3 __muldf3 __ledf2 \
            __extendsfdf2 __truncdfsf2 __floatsidf __fixdfsi sin cosf sqrt sqrtf pow expf floorf fmal \
            atan2; do
  echo "$name" | grep -Eq "$forbidden" || fail "the list of forbidden names misses $name"
done
for name in memcpy memset main __aeabi_uldivmod __aeabi_ldivmod __udivmoddi4 __aeabi_fadd __mulsf3; do
  ! echo "$name" | grep -Eq "$forbidden" || fail "the list of forbidden names contains $name"
done

build_image nearfield_core

check() {
  arm-none-eabi-nm "$1" | awk 'NF >= 2 && $(NF - 1) ~ /^[A-Za-z]$/ { print $NF }' | sort -u >names.txt
  [ "$(wc -l <names.txt)" -ge 10 ] || fail "nm finds only $(wc -l <names.txt) symbols in $1"
  if grep -E "$forbidden" names.txt; then fail "forbidden symbols in $1, above"; fi
  if arm-none-eabi-nm -C "$1" | grep -w double; then fail "functions of double in $1, above"; fi
  # Sections of constructors, with any size but 0.
  if arm-none-eabi-readelf -SW "$1" | sed 's/^ *\[ *[0-9]*\] *//' |
     awk '$1 ~ /^\.(preinit_array|init_array|fini_array|ctors|dtors)/ && $5 !~ /^0+$/ { print; found = 1 }
          END { exit !found }'; then
    fail "constructors or destructors of static objects in $1, above"
  fi
  echo "$(basename "$1"): $(wc -l <names.txt | tr -d ' ') symbols, none forbidden"
}
check "$image"
check "$library"

# What the library needs from elsewhere: the compiler's own support, nothing of a C or C++ library.
arm-none-eabi-nm -u "$library" | sed -n 's/^ *U //p' | sort -u >needed.txt
if grep -Evx 'memcpy|memmove|memset|memcmp|__aeabi_[a-z0-9]*|__[a-z]*[sd]i[0-9]' needed.txt; then
  fail "the library needs what is not the compiler's own support, above"
fi
echo "the library needs: $(tr '\n' ' ' <needed.txt)"
arm-none-eabi-size "$image"

# Recursion: a call graph that would not show it proves nothing, so it is shown some.
call_graph="awk -f $source_dir/tests/target/image/call_graph.awk"
printf '%b' '0000 <a>:\n   0:\tpush\t{r4, lr}\n   2:\tbl\t10 <b>\n   6:\tpop\t{r4, pc}\n' \
  '0010 <b>:\n  10:\tb.n\t0 <a>\n' >recursive.txt
$call_graph -v root=a recursive.txt >found.txt && fail "the call graph does not see recursion"
grep -q '^recursion: a > b > a$' found.txt || fail "the call graph does not name recursion: $(cat found.txt)"
printf '0000 <a>:\n   0:\tpush\t{r4, lr}\n   2:\tblx\tr3\n   6:\tpop\t{r4, pc}\n' >indirect.txt
$call_graph -v root=a indirect.txt >found.txt && fail "the call graph does not see calls through a register"

arm-none-eabi-objdump -d --no-show-raw-insn "$image" >image.txt
$call_graph -v root=reset_handler image.txt >found.txt || fail "$(cat found.txt)"
echo "no recursion; greatest stack by the call graph $(sed -n 's/^stack //p' found.txt) bytes:"
sed 1d found.txt | if command -v c++filt >/dev/null 2>&1; then c++filt; else cat; fi | cut -c 1-110
