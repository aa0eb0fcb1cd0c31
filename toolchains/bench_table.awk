# Of what shape_costs, blend_costs and tick_costs print on each target, the rows that are aimed at, one under the other. Where
# there are aims, a line of them follows, each with the percentage by which it is missed, if it is.
# Worst instructions: of ball potential value and gradient, of the others the value.
/ on [a-z0-9-]+: / {
  match($0, / on [a-z0-9-]+:/)
  target = substr($0, RSTART + 4, RLENGTH - 5)
  if (!(target in known)) {
    known[target] = 1
    targets[++count] = target
  }
  next
}
{
  name = $0
  sub(/( +[0-9]+)+$/, "", name)
  last = name ~ /ball potential/ || $(NF - 1) !~ /^[0-9]+$/
  cost[target, name] = last ? $NF : $(NF - 1)
}

function value(target, name) { return ((target, name) in cost) ? cost[target, name] : "-" }
function row(title, name,    i) {
  printf "%-38s", title
  for (i = 1; i <= count; ++i) printf " %13s", value(targets[i], name)
  printf "\n"
}
# The aim of one target, and by how much `measured` misses it.
function aimed(target, measured, aim) {
  if (aim == "" || aim == "-" || measured == "-") return ""
  return measured + 0 > aim + 0 ? sprintf("%d +%d%%", aim, (measured - aim) * 100 / aim + 0.5) : aim ""
}
function aims(name, m0, m3, m4, rv32,    i, target, aim) {
  printf "%-38s", "  aim, missed by"
  for (i = 1; i <= count; ++i) {
    target = targets[i]
    aim = target == "cortex-m0" ? m0 : target == "cortex-m3" ? m3 : target == "cortex-m4" ? m4 : target == "rv32imac" ? rv32 : "-"
    printf " %13s", aimed(target, value(target, name), aim)
  }
  printf "\n"
}
# In float the aim is the straightforward code, on the FPU of the M4.
function float_rows(title, name, direct,    i, any) {
  row("  straightforward float", direct)
  row("  " title, name)
  for (i = 1; i <= count; ++i) any = any || targets[i] == "cortex-m4f"
  if (!any) return
  printf "%-38s", "    aim, missed by"
  for (i = 1; i <= count; ++i) {
    printf " %13s", targets[i] == "cortex-m4f" ? aimed(targets[i], value(targets[i], name), value(targets[i], direct)) : ""
  }
  printf "\n"
}

END {
  printf "%-38s", "worst instructions"
  for (i = 1; i <= count; ++i) printf " %13s", targets[i]
  printf "\n"
  row("ball potential, value and gradient", "ball potential")
  aims("ball potential", 420, 60, 60, 90)
  float_rows("Nearfield in float", "Nearfield in float: ball potential", "float: ball potential")
  row("smooth union, value", "exterior, 32 bits")
  aims("exterior, 32 bits", 250, 35, 35, 60)
  float_rows("Nearfield in float", "exterior, float table", "float: exterior, directly")
  row("square root", "square root")
  aims("square root", 150, 45, 45, 60)
  row("  straightforward float", "float: square root")
  row("nearest of 64 capsules", "nearest of 64 capsules")
  aims("nearest of 64 capsules", 25000, 3500, 3200, 4500)
  float_rows("Nearfield in float", "Nearfield in float: nearest of 64 capsules", "float: nearest of 64 capsules")
  row("arm tick, images", "arm tick")
  row("arm tick, composed in the source", "arm tick, composed in the source")
  float_rows("Nearfield in float", "Nearfield in float: arm tick", "float: arm tick")
}
