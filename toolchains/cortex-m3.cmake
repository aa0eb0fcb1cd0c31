# Arm Cortex-M3 with arm-none-eabi-g++.
set(CMAKE_SYSTEM_PROCESSOR cortex-m3)
include("${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake")
