#!/bin/sh
# The default work cell, baked and run on the emulated board: the host's digest, no tick above 100,000
# instructions or above its budget, and no more stack than the call graph permits.
set -eu
. "$(dirname -- "$0")/image/build_image.sh"
skip_without arm-none-eabi-g++ arm-none-eabi-objdump qemu-system-arm

most_instructions=100000

build_image
"$host_tool" sim --output simulation >host.txt
status=0
"$source_dir/toolchains/qemu.sh" cortex-m4 "$image" >target.txt || status=$?
cat target.txt

host_digest=$(grep '^digest [0-9a-f]\{16\}$' host.txt) || fail "the host prints no digest"
target_digest=$(grep '^digest [0-9a-f]\{16\}$' target.txt) ||
  fail "the target prints no digest (exit status $status)"
[ "$target_digest" = "$host_digest" ] || fail "the target's $target_digest is not the host's $host_digest"

figure() { sed -n "s/^$1 \([0-9]*\).*\$/\1/p" target.txt; }
worst=$(figure 'instructions a tick: .*worst')
budget=$(figure 'instructions a tick: .*budget')
query_worst=$(figure 'instructions a query of the cell: .*worst')
query_budget=$(figure 'instructions a query of the cell: .*budget')
stack=$(figure 'greatest stack')
[ -n "$worst" ] && [ -n "$budget" ] || fail "the target prints no instructions a tick"
[ -n "$query_worst" ] && [ -n "$query_budget" ] || fail "the target prints no instructions a query"
[ "$query_worst" -le "$query_budget" ] ||
  fail "the worst query took $query_worst instructions, above the budget of $query_budget"
[ -n "$stack" ] || fail "the target prints no greatest stack"
stated=$(sed -n 's/^worst tick: at most \([0-9]*\) .*$/\1/p' host.txt)
[ "$stated" = "$budget" ] || fail "the host states a budget of ${stated:-nothing} instructions a tick, the target has $budget"
[ "$worst" -le "$budget" ] || fail "the worst tick took $worst instructions, above the budget of $budget"
[ "$worst" -le "$most_instructions" ] ||
  fail "the worst tick took $worst instructions, above $most_instructions"
[ "$status" -eq 0 ] || fail "the image ended with status $status"

arm-none-eabi-objdump -d --no-show-raw-insn "$image" |
  awk -v root=reset_handler -f "$source_dir/tests/target/image/call_graph.awk" >call_graph.txt ||
  fail "$(cat call_graph.txt)"
bound=$(sed -n 's/^stack //p' call_graph.txt)
echo "greatest stack by the call graph $bound bytes"
[ "$stack" -le "$bound" ] || fail "the run used $stack bytes of stack, the call graph permits $bound"
