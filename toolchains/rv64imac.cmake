# RISC-V rv64imac with riscv64-unknown-elf-g++; floats are in software.
set(CMAKE_SYSTEM_PROCESSOR rv64imac)
set(tool_prefix riscv64-unknown-elf-)
# As for rv32imac; and addresses relative to the program counter, since memory is beyond 2 GiB.
set(core_flags "-march=rv64imac -misa-spec=2.2 -mabi=lp64 -mcmodel=medany")
include("${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake")
