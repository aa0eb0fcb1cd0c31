# What the toolchain files of all Cortex-M cores share. Each sets CMAKE_SYSTEM_PROCESSOR, and
# `float_flags` if the FPU is used; of a core in two builds the one that uses it has an f behind its name.
set(tool_prefix arm-none-eabi-)
if(NOT DEFINED float_flags)
  set(float_flags "-mfloat-abi=soft")
endif()
string(REGEX REPLACE "f$" "" cpu "${CMAKE_SYSTEM_PROCESSOR}")
set(core_flags "-mcpu=${cpu} -mthumb ${float_flags} -masm-syntax-unified")
include("${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake")
