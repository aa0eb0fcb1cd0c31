// Runs the tests of an image.
#include <gtest/gtest.h>

extern "C" {
extern const testing::Case __start_test_cases[];
extern const testing::Case __stop_test_cases[];
}

int main() {
  const testing::Message out;
  int passed = 0, failed = 0;
  for (const testing::Case* test = __start_test_cases; test != __stop_test_cases; ++test) {
    for (int type = 0; type < test->types; ++type) {
      testing::failed = false;
      test->run(type);
      if (testing::failed) out << "failed: " << test->suite << "." << test->name << ", type " << type << "\n";
      ++(testing::failed ? failed : passed);
    }
  }
  out << passed << " of " << passed + failed << " tests passed\n";
  return failed == 0 && passed != 0 ? 0 : 1;
}
