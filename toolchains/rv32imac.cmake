# RISC-V rv32imac with riscv64-unknown-elf-g++; floats are in software.
set(CMAKE_SYSTEM_PROCESSOR rv32imac)
set(tool_prefix riscv64-unknown-elf-)
# In this version of the instruction set its base has the control registers: an extension in the name would
# hide libgcc.
set(core_flags "-march=rv32imac -misa-spec=2.2 -mabi=ilp32")
include("${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake")
