# One row of the table of `./run targets`, from what `ctest -V` prints of one build. Variables: target, compiler,
# build_seconds. Results that no test gave are "-".
/^ *Start +[0-9]+: / {
  number = $2
  name = $3
  sub(/.*\//, "", name)
  test[number] = name
}
# Lines of a test begin with its number.
/^[0-9]+: / {
  of = test[$1]
  result = /differs/ ? "DIFFERS" : "same"
  if (of == "query_digest" && $2 ~ /^(fixed27|fixed16|float)$/) query[$2] = result
  if (of == "entry_digest" && $2 ~ /^(fixed27|fixed16|float)$/ && entries != "DIFFERS") entries = result
  if (of == "kernel_digest" && $2 == "kernel") kernel = result
  if (of == "simulation_digest" && $2 == "simulation") simulation = result
  if (of == "unit_tests" && / tests passed$/) units = $2 "/" $4
}
/^[0-9]+% tests passed/ { verdict = $1 == "100%" ? "" : "  FAILED" }
/^Total Test time/ { run_seconds = $(NF - 1) }

function shown(result) { return result == "" ? "-" : result }

END {
  printf "%-16s %-14s %-8s %-8s %-8s %-8s %-10s %-8s %-8s %7d %7.0f%s\n", target, compiler, shown(kernel),
    shown(query["fixed27"]), shown(query["fixed16"]), shown(query["float"]), shown(simulation), shown(entries), shown(units), build_seconds,
    run_seconds, verdict
}
