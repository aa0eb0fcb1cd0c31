# Reads `objdump -d --no-show-raw-insn` of a Thumb image. Prints the greatest stack that a call of `root` can
# use, as `stack BYTES` and one line for each function of that path. Fails, with a line on what and where, for
# recursion anywhere, and for what would make the figure wrong in a function that `root` reaches: calls
# through a register, stack of a size that is not a constant. A function's own stack is the sum of all that it
# pushes, so never too small.

function complain(text) {
  print text
  failed = 1
}

function add_call(from, to) {
  if (from == to || (from, to) in is_call) return
  is_call[from, to] = 1
  call[from, ++calls[from]] = to
}

function register_bytes(list) { return 4 * gsub(/,/, ",", list) + 4 }

function number_of(hexadecimal, i, number) {
  number = 0
  for (i = 1; i <= length(hexadecimal); ++i) {
    number = 16 * number + index("0123456789abcdef", substr(hexadecimal, i, 1)) - 1
  }
  return number
}

# The function that an address lies in, "" if it lies in none. Names beside branch targets are no help:
# objdump takes any symbol of that value, even one that is a size.
function function_at(address, low, high, middle) {
  low = 0
  high = function_count + 1
  while (high - low > 1) {
    middle = int((low + high) / 2)
    if (start[middle] <= address) low = middle
    else high = middle
  }
  return low == 0 ? "" : functions[low]
}

function constant_after_hash(text) {
  sub(/.*#-?/, "", text)
  sub(/[^0-9].*/, "", text)
  return text + 0
}

# The greatest stack of a call of `f`. state: 1 while it is on the path, 2 afterwards.
function stack_of(f, i, to, bytes, greatest, path) {
  if (state[f] == 2) return depth[f]
  state[f] = 1
  trail[++trail_length] = f
  greatest = 0
  for (i = 1; i <= calls[f]; ++i) {
    to = call[f, i]
    if (state[to] == 1) {
      path = to
      for (bytes = trail_length; trail[bytes] != to; --bytes) path = trail[bytes] " > " path
      complain("recursion: " to " > " path)
      continue
    }
    bytes = stack_of(to)
    if (bytes > greatest || !(f in deepest)) {
      greatest = bytes
      deepest[f] = to
    }
  }
  --trail_length
  state[f] = 2
  depth[f] = frame[f] + greatest
  return depth[f]
}

function mark_reachable(f, i) {
  if (f in reachable) return
  reachable[f] = 1
  for (i = 1; i <= calls[f]; ++i) mark_reachable(call[f, i])
}

BEGIN { FS = "\t" }

/^[0-9a-f]+ <.*>:$/ {
  name = $0
  sub(/^[0-9a-f]+ </, "", name)
  sub(/>:$/, "", name)
  # A function that does not end with a jump goes on in the next one.
  if (current != "" && last !~ /^(b|bl|bx|b\..*|pop|ldm.*|ldr.*|udf|nop|bkpt|tb[bh]|\..*)$/) {
    add_call(current, name)
  }
  current = name
  functions[++function_count] = name
  start[function_count] = number_of(substr($0, 1, index($0, " ") - 1))
  is_function[name] = 1
  frame[name] = frame[name] + 0
  next
}

current != "" && NF >= 2 {
  mnemonic = $2
  operands = $3
  sub(/ *[@;].*/, "", operands)
  last = mnemonic
  sub(/\.[nw]$/, "", mnemonic)

  if (mnemonic ~ /^(b|bl|b[a-z][a-z]|cbn?z)$/ && operands ~ /</) {
    target = operands
    sub(/ *<.*/, "", target)
    sub(/^.*[ ,]/, "", target)
    ++branches
    branch_from[branches] = current
    branch_to[branches] = number_of(target)
  } else if (mnemonic ~ /^blx/ || (mnemonic ~ /^bx/ && operands != "lr") ||
             (mnemonic ~ /^mov/ && operands ~ /^pc,/) ||
             (mnemonic ~ /^ldr/ && operands ~ /^pc,/ && operands !~ /\[sp\]/)) {
    indirect[current] = mnemonic " " operands
  } else if (mnemonic == "push") {
    frame[current] += register_bytes(operands)
  } else if (mnemonic ~ /^stmdb/ && operands ~ /^sp!/) {
    sub(/^sp!, */, "", operands)
    frame[current] += register_bytes(operands)
  } else if (mnemonic ~ /^v(push|stmdb)/) {
    unbounded[current] = mnemonic " " operands
  } else if (mnemonic ~ /^str/ && operands ~ /\[sp, #-[0-9]+\]!/) {
    frame[current] += constant_after_hash(operands)
  } else if (mnemonic ~ /^sub/ && operands ~ /^sp,.*#[0-9]+$/) {
    frame[current] += constant_after_hash(operands)
  } else if ((mnemonic ~ /^(sub|mov|bic|and)/ && operands ~ /^sp,/) ||
             (mnemonic ~ /^msr/ && operands ~ /^[MP]SP/)) {
    unbounded[current] = mnemonic " " operands
  }
}

END {
  if (!(root in is_function)) {
    complain("there is no function " root)
    exit 1
  }
  for (i = 1; i <= branches; ++i) {
    f = function_at(branch_to[i])
    if (f == "") complain(branch_from[i] " calls what is not there")
    else add_call(branch_from[i], f)
  }
  for (i = 1; i <= function_count; ++i) stack_of(functions[i])
  mark_reachable(root)
  for (f in reachable) {
    if (f in indirect) complain(f " calls through a register: " indirect[f])
    if (f in unbounded) complain(f " uses stack of unknown size: " unbounded[f])
  }
  if (failed) exit 1
  print "stack " depth[root]
  for (f = root; f != ""; f = (f in deepest) ? deepest[f] : "") printf "  %5d  %s\n", frame[f], f
}
