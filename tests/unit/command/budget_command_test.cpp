// `nearfield budget`: what a field costs on each target.
#include <nearfield/field/budget.hpp>

#include "command_runner.hpp"

namespace nearfield::host {
namespace {

class BudgetCommand : public testing::Test {
 protected:
  Outcome of(const std::string& field) const {
    folder_.write("s.json", "{\"format\": \"nearfield-scene-1\", \"name\": \"a\", \"field\":\n" + field + "}");
    return folder_.run({"budget", "s.json"});
  }
  ScratchFolder folder_;
};

TEST_F(BudgetCommand, IsTheSumOfWhatTheOperationsAndTheQueryCost) {
  const Outcome outcome = of("{\"type\": \"sphere\", \"radius\": 0.5}");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const Target* target : {&target::cortex_m0, &target::cortex_m4}) {
    const Budget sum = target->query_cost(0, 0) + target->cost(Operation::sphere);
    const std::string numbers = std::to_string(sum.value);
    EXPECT_NE(outcome.out.find(" " + numbers + " "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" " + std::to_string(sum.gradient) + "\n"), std::string::npos) << outcome.out;
  }
  EXPECT_EQ(outcome.out.find("soft"), std::string::npos);
}

TEST_F(BudgetCommand, OfIntensitiesHasSoftClearances) {
  const Outcome outcome = of("{\"type\": \"soft_point\", \"influence_radius\": 0.5}");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("soft clearance"), std::string::npos);
}

TEST_F(BudgetCommand, RefusesWithOneLine) {
  const Outcome wrong = of("{\"type\": \"sphere\", \"radius\": -1}");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("field.radius"), std::string::npos) << wrong.err;
  EXPECT_EQ(folder_.run({"budget"}).status, 2);
  EXPECT_EQ(folder_.run({"budget", "none.json"}).status, 2);
  EXPECT_EQ(folder_.run({"budget", "--help"}).status, 0);
}

}  // namespace
}  // namespace nearfield::host
