#include "command/command.hpp"

int main(int count, char** arguments) {
  return nearfield::host::run_command({arguments + 1, arguments + count});
}
