# Arm Cortex-M33 (Armv8-M) in secure state with arm-none-eabi-g++, its single-precision FPU and the FPU's calling
# convention.
set(CMAKE_SYSTEM_PROCESSOR cortex-m33)
set(float_flags "-mfloat-abi=hard -mfpu=fpv5-sp-d16")
include("${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake")
