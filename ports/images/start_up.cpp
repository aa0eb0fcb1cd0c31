// Start-up and console, which every other image has as well.
#include <images/report.hpp>

int main() {
  nearfield::board::report_stack();
  return 0;
}
