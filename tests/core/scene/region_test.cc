#include "core/scene/region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace fovea {
namespace {

constexpr CameraIntrinsics kIntrinsics{500, 500, 320, 240};

TEST(IsInRegion, ByDefaultEverythingIs) {
  EXPECT_TRUE(IsInRegion({0.6F, -0.4F, 1}, kIntrinsics, {}));
  EXPECT_TRUE(IsInRegion({-150, 120, 90}, kIntrinsics, {}));
}

TEST(IsInRegion, TheFirstColumnAndRowAreWhateverRoundingMakesOfThem) {
  const Eigen::Vector3f before(-0.6400001F, -0.4800001F, 1);
  ASSERT_LT(500 * before.x() + 320, 0);
  EXPECT_TRUE(IsInRegion(before, kIntrinsics, {}));
  EXPECT_TRUE(IsInRegion(before, kIntrinsics, {.width_px = 40, .max_z_m = 2}));
  EXPECT_TRUE(IsInRegion({-0.0400001F, 0, 1}, kIntrinsics, {.x_px = 300}));
  EXPECT_FALSE(IsInRegion(before, kIntrinsics, {.x_px = 1}));
  EXPECT_FALSE(IsInRegion(before, kIntrinsics, {.y_px = 1}));
}

TEST(IsInRegion, AsksForThePixelAtWhichThePointShows) {
  const RegionOptions options{.x_px = 300, .y_px = 200, .width_px = 40, .height_px = 60};
  EXPECT_TRUE(IsInRegion({0, 0, 1}, kIntrinsics, options));         // at 320, 240
  EXPECT_TRUE(IsInRegion({-0.08F, 0, 2}, kIntrinsics, options));    // at 300
  EXPECT_FALSE(IsInRegion({-0.09F, 0, 2}, kIntrinsics, options));   // at 297.5
  EXPECT_TRUE(IsInRegion({0.0388F, 0, 1}, kIntrinsics, options));   // at 339.4
  EXPECT_FALSE(IsInRegion({0.0392F, 0, 1}, kIntrinsics, options));  // at 339.6
  EXPECT_FALSE(IsInRegion({0, 0.05F, 1}, kIntrinsics, options));    // at 265 of below 260
  EXPECT_FALSE(IsInRegion({0, -0.09F, 1}, kIntrinsics, options));   // at 195
}

TEST(RequireNotEmpty, NamesWhatLeavesNothing) {
  const auto refused = [](const RegionOptions& options, const std::string& name) {
    EXPECT_THAT(
        [&] {
          RequireNotEmpty(options, {640, 480});
        },
        testing::ThrowsMessage<std::invalid_argument>(testing::StartsWith(name)));
  };
  refused({.x_px = 640}, "region.x_px: 640");
  refused({.y_px = 480}, "region.y_px: 480");
  refused({.min_x_m = 1, .max_x_m = 0.5}, "region.min_x_m: 1");
  refused({.max_y_m = -100}, "region.min_y_m: -100");
  refused({.min_z_m = 2, .max_z_m = 1}, "region.min_z_m: 2");
  EXPECT_NO_THROW(RequireNotEmpty({.x_px = 639, .y_px = 479}, {640, 480}));
}

TEST(IsInRegion, AsksForTheWorkspace) {
  const RegionOptions options{.min_x_m = -0.1, .max_y_m = 0.2, .max_z_m = 1.5};
  EXPECT_TRUE(IsInRegion({0, 0, 1}, kIntrinsics, options));
  EXPECT_FALSE(IsInRegion({-0.2F, 0, 1}, kIntrinsics, options));
  EXPECT_FALSE(IsInRegion({0, 0.3F, 1}, kIntrinsics, options));
  EXPECT_FALSE(IsInRegion({0, 0, 1.6F}, kIntrinsics, options));
}

}  // namespace
}  // namespace fovea
