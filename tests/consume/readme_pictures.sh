#!/bin/sh
# The pictures that README.md shows are those that `nearfield sim` draws now.
set -eu
source_dir=${NEARFIELD_SOURCE_DIR:-$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)}
host_tool=${NEARFIELD_BUILD_DIR:-$source_dir/build/host}/host_sim/nearfield
pictures=host_sim/pictures
rm -rf sim

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

[ -x "$host_tool" ] || fail "$host_tool is not built"
"$host_tool" sim --output sim >summary.txt
# The moment that the page tells of, whatever its letter.
moment=$(sed -n 's/^ *\(moment_[A-Z]\.svg\) .*  The arm stops$/\1/p' summary.txt)
[ -f "sim/$moment" ] || fail "the simulation draws no moment \"The arm stops\""

compare() {
  grep -q "($pictures/$2)" "$source_dir/README.md" || fail "README.md does not show $pictures/$2"
  cmp "sim/$1" "$source_dir/$pictures/$2" || fail "$pictures/$2 is not what the simulation draws now; refresh it with
  ./run sim && cp out/sim/$moment $pictures/work_cell.svg && cp out/sim/timeline.svg $pictures/timeline.svg"
}
compare "$moment" work_cell.svg
compare timeline.svg timeline.svg

# The lines of the run that the page quotes.
grep -E '^(least clearance|time in zones|digest)' summary.txt | while read -r line; do
  tr -s ' ' <"$source_dir/README.md" | grep -Fqx "$(echo "$line" | tr -s ' ')" ||
    fail "README.md does not quote this line of ./run sim: $line"
done
