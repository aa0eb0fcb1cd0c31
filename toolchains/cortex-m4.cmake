# Arm Cortex-M4 with arm-none-eabi-g++, freestanding: no C or C++ library, libgcc only.
# NEARFIELD_FPU=ON uses the single-precision FPU and its calling convention; otherwise floats are in software.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

option(NEARFIELD_FPU "Use the FPU of the Cortex-M4F" OFF)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES NEARFIELD_FPU)
set(float_flags "-mfloat-abi=soft")
if(NEARFIELD_FPU)
  set(float_flags "-mfloat-abi=hard -mfpu=fpv4-sp-d16")
endif()

string(CONCAT CMAKE_CXX_FLAGS_INIT
  "-mcpu=cortex-m4 -mthumb ${float_flags} -ffreestanding -fno-exceptions -fno-rtti "
  "-fno-threadsafe-statics -fno-unwind-tables -fno-asynchronous-unwind-tables "
  "-ffunction-sections -fdata-sections -Wno-psabi")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -nostartfiles -Wl,--gc-sections")

set(CMAKE_CROSSCOMPILING_EMULATOR "${CMAKE_CURRENT_LIST_DIR}/qemu-mps2.sh")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
