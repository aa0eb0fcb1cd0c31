# Arm Cortex-M7 with arm-none-eabi-g++, its FPU of single and double precision and the FPU's calling convention.
set(CMAKE_SYSTEM_PROCESSOR cortex-m7)
set(float_flags "-mfloat-abi=hard -mfpu=fpv5-d16")
include("${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake")
