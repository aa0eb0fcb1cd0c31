# What the toolchain files of all bare-metal cores share: freestanding, no C or C++ library, libgcc only. Each
# sets CMAKE_SYSTEM_PROCESSOR, `tool_prefix` and `core_flags`, then includes this.
set(CMAKE_SYSTEM_NAME Generic)
set(NEARFIELD_BARE_METAL ON)
set(CMAKE_CXX_COMPILER ${tool_prefix}g++)
set(NEARFIELD_TOOL_PREFIX ${tool_prefix})
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

string(CONCAT CMAKE_CXX_FLAGS_INIT
  "${core_flags} -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics "
  "-fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections -Wno-psabi")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -nostartfiles -Wl,--gc-sections")

set(CMAKE_CROSSCOMPILING_EMULATOR "${CMAKE_CURRENT_LIST_DIR}/qemu.sh" ${CMAKE_SYSTEM_PROCESSOR})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
