#!/bin/sh
# The pictures that README.md shows are those that `nearfield` draws now.
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

# Scenes of the gallery, smaller than there.
draw() {
  picture=$1 scene=$2
  shift 2
  "$host_tool" render "$source_dir/host_sim/scenes/gallery/$scene" --size 300x240 "$@" --output "$picture" >/dev/null
  grep -q "($pictures/$picture)" "$source_dir/README.md" || fail "README.md does not show $pictures/$picture"
  cmp "$picture" "$source_dir/$pictures/$picture" || fail "$pictures/$picture is not what is drawn now; refresh it with
  nearfield render host_sim/scenes/gallery/$scene --size 300x240 $* --output $pictures/$picture"
}
draw teapot.png li/teapot.json --camera 0.9,-2.6,1.3 --look-at 0.08,0,0.4 --field-of-view 28
draw layers.png akleman/handles.json --bands 0.03 --box -1.2,-1.2,-1.2,1.2,1.2,0.04 --camera 0.9,-1.5,2.2
draw moment.png robotics/moment.json --bands 0.1 --ground -0.75 --camera -0.3,2.8,1.3 --look-at 0.5,0.15,0.03 \
  --field-of-view 42

# The lines of the run that the page quotes.
grep -E '^(least clearance|time in zones|digest)' summary.txt | while read -r line; do
  tr -s ' ' <"$source_dir/README.md" | grep -Fqx "$(echo "$line" | tr -s ' ')" ||
    fail "README.md does not quote this line of ./run sim: $line"
done
