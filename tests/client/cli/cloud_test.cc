#include "client/cli/cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace fovea::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<CloudPoint> kTwo{{{1, 2, 3}, {10, 20, 30}}, {{4, 5, 6}, {40, 50, 60}}};

TEST(Cloud, WritesPly) {
  const std::string file = MakePly(kTwo);
  EXPECT_THAT(file, StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(file, HasSubstr("\nelement vertex 2\n"));
  const std::string points = file.substr(file.find("end_header\n") + 11);
  ASSERT_EQ(points.size(), 2U * 15);
  EXPECT_EQ(points.substr(12, 3), "\x1E\x14\x0A") << "red comes first";
}

TEST(Cloud, WritesPcd) {
  const std::string file = MakePcd(kTwo);
  EXPECT_THAT(file, HasSubstr("\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\n"));
  EXPECT_THAT(file, HasSubstr("\nWIDTH 2\nHEIGHT 1\n"));
  EXPECT_THAT(file, HasSubstr("\nPOINTS 2\nDATA binary\n"));
  const std::string points = file.substr(file.find("DATA binary\n") + 12);
  ASSERT_EQ(points.size(), 2U * 16);
  float z = 0;
  std::memcpy(&z, points.data() + 8, sizeof z);
  EXPECT_EQ(z, 3);
  EXPECT_EQ(points.substr(12, 3), "\x0A\x14\x1E") << "0x00RRGGBB, little-endian";
}

// Ten centimetres wide: every dot lies on the surface, as near to the next as a millimetre.
TEST(Cloud, DotsLieOnTheSolid) {
  v1::Detections detections;
  v1::Object& object = *detections.add_objects();
  object.set_label(1);
  v1::OrientedBox& box = *object.mutable_oriented_box();
  box.mutable_pose()->mutable_position()->set_z(1);
  box.mutable_pose()->mutable_orientation()->set_w(1);
  box.mutable_size()->set_x(0.1);
  box.mutable_size()->set_y(0.1);
  box.mutable_size()->set_z(0.1);
  const std::vector<CloudPoint> dots = DotsOf(detections);
  EXPECT_GE(dots.size(), 12U * 100);
  EXPECT_LE(dots.size(), 12U * 101) << "a hundred steps, or one more by rounding";
  for (const CloudPoint& dot : dots) {
    int at_edge = 0;
    for (const float x : {dot.position[0], dot.position[1], dot.position[2] - 1}) {
      EXPECT_LE(std::abs(x), 0.05F + 1e-6F);
      at_edge += std::abs(std::abs(x) - 0.05F) < 1e-6F ? 1 : 0;
    }
    EXPECT_GE(at_edge, 2);
  }
}

}  // namespace
}  // namespace fovea::cli
