// usage: node wasm.mjs MODULE
// Runs a module of ports/wasm: its output goes to standard output, its exit status is the result.
import { readFileSync, writeSync } from 'fs'

const imports = {
  write: (start, size) => writeSync(1, new Uint8Array(instance.exports.memory.buffer, start, size)),
  exit: process.exit,
}
const module = new WebAssembly.Module(readFileSync(process.argv[2]))
const instance = new WebAssembly.Instance(module, { console: imports })
instance.exports._start()
