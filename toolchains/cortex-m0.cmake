# Arm Cortex-M0 with arm-none-eabi-g++.
set(CMAKE_SYSTEM_PROCESSOR cortex-m0)
include("${CMAKE_CURRENT_LIST_DIR}/cortex_m.cmake")
