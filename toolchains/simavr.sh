#!/bin/sh
# usage: simavr.sh IMAGE
# Runs an image of ports/avr in simavr. Its output goes to standard output, without the emulator's colours and the full
# stops it prints for line ends; the status in its last line is the result.
set -eu

output=$(timeout --kill-after=5 600 simavr -m atmega2560 -f 16000000 "$1" 2>&1 |
  sed -e "s/$(printf '\033')\[[0-9;]*m//g" -e 's/\.$//' -e '/^Loaded /d') || true
printf '%s\n' "$output"
status=$(printf '%s\n' "$output" | sed -n 's/^exit status \([0-9]*\)$/\1/p')
exit "${status:-1}"
