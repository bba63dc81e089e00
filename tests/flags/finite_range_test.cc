#include "flags/finite_range.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <string>

namespace fovea::flags {
namespace {

// What is wrong with --rate VALUE; empty where nothing is.
std::string Problem(const std::string& value, double minimum = 0.5, double maximum = 30) {
  CLI::App app("Test", "program");
  double rate = 0;
  app.add_option("--rate", rate)->check(FiniteRange(minimum, maximum));
  try {
    app.parse("--rate=" + value);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return {};
}

TEST(FiniteRange, TakesItsEndsAndWhatIsBetween) {
  for (const char* value : {"0.5", "30", "1", "2.5", "1e1", "+3"}) {
    EXPECT_EQ(Problem(value), "") << value;
  }
}

TEST(FiniteRange, NamesTheFlagTheValueAndTheRange) {
  EXPECT_EQ(Problem("31"), "--rate: \"31\" is not a number from 0.5 to 30");
  EXPECT_EQ(Problem("nan"), "--rate: \"nan\" is not a number from 0.5 to 30");
}

TEST(FiniteRange, RefusesWhatIsOutsideNotFiniteOrNoNumber) {
  for (const char* value : {"0.49", "-1", "30.01", "nan", "-nan", "NaN", "nan(1)", "inf", "-inf",
                            "infinity", "1e999", "x", "1x"}) {
    EXPECT_NE(Problem(value), "") << value;
  }
}

TEST(FiniteRange, RefusesInfinityInARangeWithoutEnd) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Problem("1e300", -kInfinity, kInfinity), "");
  EXPECT_NE(Problem("inf", -kInfinity, kInfinity), "");
  EXPECT_NE(Problem("-inf", -kInfinity, kInfinity), "");
}

}  // namespace
}  // namespace fovea::flags
