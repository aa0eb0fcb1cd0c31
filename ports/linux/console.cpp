#include <board/console.hpp>

#include <stdio.h>
#include <stdlib.h>

namespace nearfield::board {

void write(const char* bytes, size_t size) { fwrite(bytes, 1, size, stdout); }

void exit_with_status(int status) { exit(status & 0xff); }

}  // namespace nearfield::board
