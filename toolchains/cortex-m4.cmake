# Arm Cortex-M4 with arm-none-eabi-g++; floats are in software.
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
include("${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake")
