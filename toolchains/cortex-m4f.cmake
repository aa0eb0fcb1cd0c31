# Arm Cortex-M4 with arm-none-eabi-g++, its single-precision FPU and the FPU's calling convention.
set(CMAKE_SYSTEM_PROCESSOR cortex-m4f)
set(float_flags "-mfloat-abi=hard -mfpu=fpv4-sp-d16")
include("${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake")
