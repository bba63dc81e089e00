#include "server/conversion/options.h"

#include <gmock/gmock.h>

#include <chrono>

#include "server/conversion/field_error.h"

namespace fovea::testing {
namespace {

TEST(TimeBudget, IsUpToAnHour) {
  const server::OptionPolicy policy("all", {});
  v1::DetectOptions options;
  options.mutable_time_budget()->set_seconds(3600);
  EXPECT_EQ(server::FromProto(options, policy).time_budget, std::chrono::hours(1));
  options.mutable_time_budget()->set_nanos(1);
  EXPECT_THROW(server::FromProto(options, policy), server::FieldError);
}

}  // namespace
}  // namespace fovea::testing
