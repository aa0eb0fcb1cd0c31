# Reads what operation_costs prints and writes the header of costs that it checks: what was measured, and one in sixteen
# more. Usage: awk -f state.awk -v target=cortex_m4
$1 == "on" { machine = $0 }
function stated(measured) { return measured == "-" ? 0 : int((measured * 17 + 15) / 16) }
$2 == "operation" || $2 == "item" || $2 == "part" {
  # A pair that was not measured is two dashes.
  row = sprintf("  %s(%s, %d, %d, %d)", $2, $1, stated($3), stated($5), stated($7))
  if (!(row in seen)) rows[count++] = row
  seen[row] = 1
}
END {
  if (count < 20 || machine == "") exit 1
  print "// Worst-case instructions " machine " -O2, Fixed<27>, dispatch included."
  print "// Measured by ports/operation_costs, and one in sixteen more. Written by `./run costs`."
  print "// name, value, value with gradient, greatest value in a ball"
  print "#pragma once"
  print ""
  head = "#define NEARFIELD_COSTS_OF_" target "(operation, item, part)"
  width = length(head)
  for (i = 0; i < count; ++i) if (length(rows[i]) > width) width = length(rows[i])
  printf "%-" width "s \\\n", head
  for (i = 0; i + 1 < count; ++i) printf "%-" width "s \\\n", rows[i]
  print rows[count - 1]
}
