#include "server/conversion/planning.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "server/conversion/color.h"
#include "server/conversion/object.h"
#include "server/conversion/place.h"

namespace fovea::testing {
namespace {

using ::testing::StartsWith;

template <typename Convert>
std::string ErrorOf(const Convert& convert, const v1::DetectOptions& options) {
  try {
    convert(options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "valid";
}

TEST(Planning, IsOffUnlessAskedFor) {
  v1::DetectOptions options;
  EXPECT_FALSE(server::PlanningFromProto(options).collision_primitives);
  EXPECT_FALSE(server::PlanningFromProto(options).height_map);
  options.mutable_planning()->mutable_height_map();
  const PlanningOptions planning = server::PlanningFromProto(options);
  EXPECT_TRUE(planning.height_map);
  EXPECT_FLOAT_EQ(planning.cell_m, 0.02F);
  EXPECT_EQ(planning.max_cells, 65536);
}

TEST(Planning, BoundsTheHeightMap) {
  v1::DetectOptions options;
  v1::HeightMapOptions& map = *options.mutable_planning()->mutable_height_map();
  for (const double wrong : {-0.1, 0.001, 1.5, double{NAN}}) {
    map.set_cell_m(wrong);
    EXPECT_THAT(ErrorOf(server::PlanningFromProto, options),
                StartsWith("options.planning.height_map.cell_m: "));
  }
  map.set_cell_m(0.5);
  map.set_max_cells(2000000);
  EXPECT_THAT(ErrorOf(server::PlanningFromProto, options),
              StartsWith("options.planning.height_map.max_cells: "));
  map.set_max_cells(100);
  EXPECT_EQ(server::PlanningFromProto(options).max_cells, 100);
  EXPECT_FLOAT_EQ(server::PlanningFromProto(options).cell_m, 0.5F);
}

TEST(Planning, HeightsComeRowByRow) {
  HeightMap map;
  map.pose.translation() = Eigen::Vector3f(1, 2, 3);
  map.cell_m = 0.25F;
  map.heights_m = (cv::Mat_<float>(2, 3) << 0, 1, 2, 3, 4, 5);
  const v1::HeightMap proto = server::ToProto(map);
  EXPECT_EQ(proto.width(), 3U);
  EXPECT_EQ(proto.height(), 2U);
  EXPECT_EQ(proto.cell_m(), 0.25);
  EXPECT_EQ(proto.pose().position().y(), 2);
  EXPECT_EQ(proto.pose().orientation().w(), 1);
  ASSERT_EQ(proto.data().size(), 24U);
  float height = 0;
  std::memcpy(&height, proto.data().data() + 4 * sizeof(float), sizeof(float));
  EXPECT_EQ(height, 4);
}

TEST(Places, AreChecked) {
  v1::DetectOptions options;
  EXPECT_FALSE(server::PlaceFromProto(options));
  v1::PlaceOptions& places = *options.mutable_places();
  EXPECT_THAT(ErrorOf(server::PlaceFromProto, options), StartsWith("options.places.size: "));
  places.mutable_size()->set_x(0.1);
  places.mutable_size()->set_y(0.2);
  places.mutable_size()->set_z(0.3);
  EXPECT_EQ(server::PlaceFromProto(options)->size_m, Eigen::Vector3f(0.1F, 0.2F, 0.3F));
  places.set_margin_m(-1);
  EXPECT_THAT(ErrorOf(server::PlaceFromProto, options), StartsWith("options.places.margin_m: "));
  places.set_margin_m(0);
  places.set_max_places(101);
  EXPECT_THAT(ErrorOf(server::PlaceFromProto, options), StartsWith("options.places.max_places: "));
}

TEST(Objects, SayTheirColorsAndHowSureTheirBoxIs) {
  DetectedObject object;
  object.colors = {{ColorName::kBrown, 0.75F, {100, 60, 20}, {1, 2, 3}}};
  v1::Object proto = server::ToProto(object, "frame", std::nullopt, {});
  EXPECT_FALSE(proto.has_uncertainty());
  EXPECT_FALSE(proto.has_collision());
  ASSERT_EQ(proto.colors_size(), 1);
  EXPECT_EQ(proto.colors(0).name(), v1::COLOR_NAME_BROWN);
  EXPECT_EQ(proto.colors(0).share(), 0.75);
  EXPECT_EQ(proto.colors(0).mean().green(), 60U);
  EXPECT_EQ(proto.colors(0).centroid().z(), 3);

  object.uncertainty = BoxUncertainty{};
  object.uncertainty->pose_covariance(0, 3) = 0.5F;
  object.uncertainty->size_sigma_m = {0.25F, 0.5F, 1};
  object.collision = CollisionPrimitive{};
  object.collision->kind = CollisionPrimitive::Kind::kSphere;
  object.collision->size_m.setConstant(0.5F);
  proto = server::ToProto(object, "frame", std::nullopt, {});
  ASSERT_EQ(proto.uncertainty().pose_covariance_size(), 16);
  EXPECT_EQ(proto.uncertainty().pose_covariance(3), 0.5);
  EXPECT_EQ(proto.uncertainty().size_sigma().y(), 0.5);
  EXPECT_EQ(proto.collision().kind(), v1::COLLISION_KIND_SPHERE);
  EXPECT_EQ(proto.collision().size().z(), 0.5);
}

TEST(Colors, EachHasItsName) {
  for (std::size_t i = 0; i < kNumColorNames; ++i) {
    ColorPart part;
    part.name = static_cast<ColorName>(i);
    EXPECT_EQ(static_cast<std::size_t>(server::ToProto(part).name()), i + 1);
  }
}

}  // namespace
}  // namespace fovea::testing
