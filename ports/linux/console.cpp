#include <board/console.hpp>

#include <unistd.h>

namespace nearfield::board {

void write(const char* bytes, size_t size) {
  while (size != 0) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes, size);
    if (written < 0) _exit(1);
    bytes += written;
    size -= static_cast<size_t>(written);
  }
}

void exit_with_status(int status) { _exit(status & 0xff); }

}  // namespace nearfield::board
