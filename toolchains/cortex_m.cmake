# What the toolchain files of all Cortex-M cores share. Each sets CMAKE_SYSTEM_PROCESSOR, with an f behind the
# name of the core if it has an FPU, and then `float_flags`.
set(tool_prefix arm-none-eabi-)
if(NOT DEFINED float_flags)
  set(float_flags "-mfloat-abi=soft")
endif()
string(REGEX REPLACE "f$" "" cpu "${CMAKE_SYSTEM_PROCESSOR}")
set(core_flags "-mcpu=${cpu} -mthumb ${float_flags} -masm-syntax-unified")
include("${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake")
