#include "core/objects/confidence.h"

#include <gtest/gtest.h>

#include <limits>

namespace fovea {
namespace {

TEST(Confidence, GrowsWithTheAreaUntilThereIsAmple) {
  EXPECT_LT(Confidence(0.001, 1), Confidence(0.002, 1));
  EXPECT_LT(Confidence(0.002, 1), Confidence(0.005, 1));
  EXPECT_EQ(Confidence(0.005, 1), Confidence(0.5, 1));
}

TEST(Confidence, FallsWithTheDistanceBeyondAMetre) {
  EXPECT_EQ(Confidence(0.01, 0.3), Confidence(0.01, 1));
  EXPECT_GT(Confidence(0.01, 1), Confidence(0.01, 2));
  EXPECT_GT(Confidence(0.01, 2), Confidence(0.01, 3));
}

TEST(Confidence, IsAProbabilityForAnyInput) {
  for (const double area : {0.0, 1e-300, 1e-4, 1.0, 1e300}) {
    for (const double distance : {0.0, 1.0, 100.0, std::numeric_limits<double>::infinity()}) {
      EXPECT_GE(Confidence(area, distance), 0);
      EXPECT_LT(Confidence(area, distance), 1);
    }
  }
}

}  // namespace
}  // namespace fovea
