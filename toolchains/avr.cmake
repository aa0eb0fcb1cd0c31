# Atmel AVR (ATmega2560) with clang++: avr-g++ is GCC 5.4, which has no C++17. avr-gcc links, with avr-libc's start-up and
# its own library of functions.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET avr)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Constants are computed in double, which has 32 bits here unless told otherwise.
set(CMAKE_CXX_FLAGS_INIT "-mmcu=atmega2560 -mdouble=64 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics")
set(CMAKE_CXX_LINK_EXECUTABLE "avr-gcc -mmcu=atmega2560 <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
set(CMAKE_CROSSCOMPILING_EMULATOR "${CMAKE_CURRENT_LIST_DIR}/simavr.sh")
