# Of what shape_costs and blend_costs print on each target, the rows that are aimed at, one under the other, with the aims.
# Worst instructions: of ball potential value and gradient, of the others the value. An aim is "-" where there is none.
/^worst instructions of / {
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
  sub(/ +[0-9].*$/, "", name)
  cost[target, name] = name ~ /ball potential/ ? $NF : name ~ /^exterior|^float: exterior/ ? $(NF - 1) : $NF
}

function row(title, name, m0, m3, m4, rv32,    i, aim, text) {
  printf "%-40s", title
  for (i = 1; i <= count; ++i) {
    aim = targets[i] == "cortex-m0" ? m0 : targets[i] == "cortex-m3" ? m3 : targets[i] == "cortex-m4" ? m4 : \
          targets[i] == "rv32imac" ? rv32 : "-"
    text = ((targets[i], name) in cost) ? cost[targets[i], name] : "-"
    printf " %8s /%6s", text, aim
  }
  printf "\n"
}

END {
  printf "%-40s", "worst instructions / aim"
  for (i = 1; i <= count; ++i) printf " %16s", targets[i]
  printf "\n"
  row("ball potential, value and gradient", "ball potential", 420, 60, 60, 90)
  row("  straightforward float", "float: ball potential", "-", "-", "-", "-")
  row("  Nearfield in float", "Nearfield in float: ball potential", "-", "-", "-", "-")
  row("smooth union, value", "exterior, 32 bits", 250, 35, 35, 60)
  row("  straightforward float", "float: exterior, directly", "-", "-", "-", "-")
  row("square root", "square root", 150, 45, 45, 60)
  row("  straightforward float", "float: square root", "-", "-", "-", "-")
  row("nearest of 64 capsules", "nearest of 64 capsules", 25000, 3500, 3200, 4500)
  row("  straightforward float", "float: nearest of 64 capsules", "-", "-", "-", "-")
}
