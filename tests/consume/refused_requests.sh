#!/bin/sh
# Fields of kinds that do not mix and requests for tables that cannot be met do not compile, and the compiler says why; allowed ones beside
# them do.
set -eu
source_dir=${NEARFIELD_SOURCE_DIR:-$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)}
compiler=${CXX:-g++}
requests=$source_dir/tests/consume/refused_requests
flags="-std=c++17 -Wall -Wextra -fsyntax-only -I $source_dir/firmware_core/include"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# shellcheck disable=SC2086
"$compiler" $flags "$requests/met.cpp" || fail "requests that can be met do not compile"

count=0
for request in "$requests"/*.cpp; do
  name=$(basename "$request" .cpp)
  [ "$name" = met ] && continue
  expected=$(sed -n '1s/^\/\/ expected: //p' "$request")
  [ -n "$expected" ] || fail "$name names no expected message"
  # shellcheck disable=SC2086
  if "$compiler" $flags "$request" 2>"$name.log"; then fail "$name compiles"; fi
  grep -e 'static.assert' -e 'deleted function' "$name.log" | grep -Fq "$expected" || fail "$name: no \"$expected\" in
$(cat "$name.log")"
  echo "$name: $expected"
  count=$((count + 1))
done
[ "$count" -ge 10 ] || fail "only $count requests were tried"
