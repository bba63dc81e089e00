// Every broken request over the wire: INVALID_ARGUMENT that starts with the field it is about.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "core/types/too_complex.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/raw_call.h"

namespace fovea::testing {
namespace {

using ::testing::StartsWith;

struct BadInput {
  std::string name;
  std::function<void(v1::DetectRequest&)> damage;
  std::string error_start;
};

v1::Frame& FrameOf(v1::DetectRequest& request) { return *request.mutable_frame(); }

BadInput Color(std::string name, const v1::ColorImage& image, std::string error_start) {
  return {std::move(name), [=](auto& request) { *FrameOf(request).mutable_color() = image; },
          std::move(error_start)};
}

BadInput Depth(std::string name, const v1::DepthImage& image, std::string error_start) {
  return {std::move(name), [=](auto& request) { *FrameOf(request).mutable_depth() = image; },
          std::move(error_start)};
}

BadInput Intrinsic(std::string name, void (v1::CameraIntrinsics::*set)(double), double value,
                   std::string error_start) {
  return {std::move(name),
          [=](auto& request) { (FrameOf(request).mutable_intrinsics()->*set)(value); },
          std::move(error_start)};
}

std::string CutInHalf(const std::string& bytes) { return bytes.substr(0, bytes.size() / 2); }

std::vector<BadInput> BadParts() {
  return {
      {"no_frame", [](auto& r) { r.clear_frame(); }, "frame: is missing"},
      {"no_color", [](auto& r) { FrameOf(r).clear_color(); }, "frame.color: is missing"},
      {"no_depth", [](auto& r) { FrameOf(r).clear_depth(); }, "frame.depth: is missing"},
      {"no_intrinsics", [](auto& r) { FrameOf(r).clear_intrinsics(); },
       "frame.intrinsics: is missing"},
      {"long_id", [](auto& r) { FrameOf(r).set_id(std::string(257, 'x')); }, "frame.id: "},
      {"long_gravity", [](auto& r) { FrameOf(r).mutable_gravity()->set_y(1.2); },
       "frame.gravity: "},
      {"zero_gravity", [](auto& r) { FrameOf(r).mutable_gravity(); }, "frame.gravity: "},
      {"nan_gravity", [](auto& r) { FrameOf(r).mutable_gravity()->set_x(NAN); }, "frame.gravity: "},
      {"pose_without_orientation", [](auto& r) { FrameOf(r).mutable_camera_pose(); },
       "frame.camera_pose.orientation: "},
      {"infinite_pose",
       [](auto& r) { FrameOf(r).mutable_camera_pose()->mutable_position()->set_x(INFINITY); },
       "frame.camera_pose.position: "},
      {"unknown_profile", [](auto& r) { r.mutable_options()->set_profile("fast"); },
       "options.profile: "},
      {"unknown_option",
       [](auto& r) { (*r.mutable_options()->mutable_parameters())["no.such"] = 1; },
       "options.parameters[no.such]: there is no such option; known names start with max_depth_m"},
      {"option_of_another_version",
       [](auto& r) { (*r.mutable_options()->mutable_parameters())["walls.max_planes"] = 4; },
       "options.parameters[walls.max_planes]: there is no such option; known are "
       "walls.min_extent_m"},
      {"option_of_another_profile",
       [](auto& r) { (*r.mutable_options()->mutable_parameters())["gravity.step_px"] = 4; },
       "options.parameters[gravity.step_px]: profile \"default\" does not read it"},
      {"region_beyond_the_image",
       [](auto& r) { (*r.mutable_options()->mutable_parameters())["region.x_px"] = 9999; },
       "options.parameters[region.x_px]: 9999"},
      {"negative_time_budget",
       [](auto& r) { r.mutable_options()->mutable_time_budget()->set_nanos(-1); },
       "options.time_budget: must be from 0"},
      {"enormous_time_budget",
       [](auto& r) { r.mutable_options()->mutable_time_budget()->set_seconds(1'000'000'000'000); },
       "options.time_budget: must be from 0"},
      {"more_than_an_hour",
       [](auto& r) {
         r.mutable_options()->mutable_time_budget()->set_seconds(3600);
         r.mutable_options()->mutable_time_budget()->set_nanos(1);
       },
       "options.time_budget: must be from 0"},
      {"time_budget_with_trace",
       [](auto& r) {
         r.mutable_options()->mutable_time_budget()->set_seconds(1);
         r.mutable_options()->set_return_trace(true);
       },
       "options.time_budget: does not go with return_trace"},
      {"enormous_option_name",
       [](auto& r) { (*r.mutable_options()->mutable_parameters())[std::string(50'000, 'x')] = 1; },
       "options.parameters[xxx"},
  };
}

std::vector<BadInput> BadIntrinsics() {
  using K = v1::CameraIntrinsics;
  return {Intrinsic("fx_nan", &K::set_fx, NAN, "frame.intrinsics.fx: "),
          Intrinsic("fx_zero", &K::set_fx, 0, "frame.intrinsics.fx: "),
          Intrinsic("fy_negative", &K::set_fy, -525, "frame.intrinsics.fy: "),
          Intrinsic("fy_infinite", &K::set_fy, INFINITY, "frame.intrinsics.fy: "),
          Intrinsic("cx_nan", &K::set_cx, NAN, "frame.intrinsics.cx: "),
          Intrinsic("cy_infinite", &K::set_cy, -INFINITY, "frame.intrinsics.cy: "),
          Intrinsic("fx_normalised", &K::set_fx, 0.8, "frame.intrinsics.fx: 0.8"),
          Intrinsic("cy_far_outside", &K::set_cy, 1e6, "frame.intrinsics.cy: 1e+06 px with fy "),
          Intrinsic("cx_far_outside", &K::set_cx, -1e6, "frame.intrinsics.cx: -1e+06 px with fx ")};
}

std::vector<BadInput> BadColors() {
  const std::string rgb = BytesOf(TestColor()), jpeg = JpegOf(TestColor()),
                    png = PngOf(TestColor());
  const auto unknown = static_cast<v1::ColorEncoding>(99);
  return {
      Color("color_no_encoding", ColorMessage({}, rgb, kWidth, kHeight), "frame.color.encoding: "),
      Color("color_unknown_encoding", ColorMessage(unknown, rgb, kWidth, kHeight),
            "frame.color.encoding: "),
      Color("color_no_width", ColorMessage(v1::COLOR_ENCODING_RGB8, rgb, 0, kHeight),
            "frame.color.width: "),
      Color("color_no_height", ColorMessage(v1::COLOR_ENCODING_BGR8, rgb, kWidth, 0),
            "frame.color.height: "),
      Color("color_too_few_bytes", ColorMessage(v1::COLOR_ENCODING_RGB8, "0123456789", 640, 480),
            "frame.color.data: has 10 bytes, 640x480 RGB8 needs 921600"),
      Color("color_too_many_bytes",
            ColorMessage(v1::COLOR_ENCODING_RGB8, rgb + "x", kWidth, kHeight),
            "frame.color.data: has"),
      Color("color_raw_bomb", ColorMessage(v1::COLOR_ENCODING_RGB8, rgb, 100'000, 100'000),
            "frame.color.width, height: "),
      Color("color_largest_size", ColorMessage(v1::COLOR_ENCODING_RGB8, rgb, -1, -1),
            "frame.color.width, height: "),
      Color("jpeg_empty", ColorMessage(v1::COLOR_ENCODING_JPEG, ""), "frame.color.data: "),
      Color("jpeg_cut", ColorMessage(v1::COLOR_ENCODING_JPEG, CutInHalf(jpeg)),
            "frame.color.data: not a whole JPEG"),
      Color("jpeg_bomb", ColorMessage(v1::COLOR_ENCODING_JPEG, JpegClaiming(65500, 65500)),
            "frame.color.data: the JPEG is 65500x65500, more than"),
      Color("jpeg_other_size", ColorMessage(v1::COLOR_ENCODING_JPEG, jpeg, 33, 24),
            "frame.color.data: the JPEG is 32x24, but the message says 33x24"),
      Color("jpeg_is_png", ColorMessage(v1::COLOR_ENCODING_JPEG, png), "frame.color.data: "),
      Color("png_cut", ColorMessage(v1::COLOR_ENCODING_PNG, CutInHalf(png)),
            "frame.color.data: not a whole PNG"),
      Color("png_bomb", ColorMessage(v1::COLOR_ENCODING_PNG, PngClaiming(100'000, 100'000)),
            "frame.color.data: the PNG is 100000x100000, more than"),
      Color("png_is_depth", ColorMessage(v1::COLOR_ENCODING_PNG, PngOf(TestDepth())),
            "frame.color.data: the PNG has 16 bits"),
  };
}

std::vector<BadInput> BadDepths() {
  const std::string units = BytesOf(TestDepth()), png = PngOf(TestDepth()), zstd = ZstdOf(units);
  const std::string rvl = RvlOf(TestDepth());
  const std::string bomb = ZstdOf(std::string(20'000'000, '\0'));
  const auto unknown = static_cast<v1::DepthEncoding>(99);
  v1::DepthImage nan_unit = DepthMessage(v1::DEPTH_ENCODING_16UC1, units, kWidth, kHeight);
  nan_unit.set_unit_m(NAN);
  v1::DepthImage large_unit = nan_unit;
  large_unit.set_unit_m(1.5);
  return {
      Depth("depth_no_encoding", DepthMessage({}, units, kWidth, kHeight),
            "frame.depth.encoding: "),
      Depth("depth_unknown_encoding", DepthMessage(unknown, units, kWidth, kHeight),
            "frame.depth.encoding: "),
      Depth("depth_no_size", DepthMessage(v1::DEPTH_ENCODING_16UC1, units), "frame.depth.width: "),
      Depth("depth_16_as_32", DepthMessage(v1::DEPTH_ENCODING_32FC1, units, kWidth, kHeight),
            "frame.depth.data: has 1536 bytes, 32x24 32FC1 needs 3072"),
      Depth("depth_unit_nan", nan_unit, "frame.depth.unit_m: "),
      Depth("depth_unit_large", large_unit, "frame.depth.unit_m: "),
      Depth("depth_raw_bomb", DepthMessage(v1::DEPTH_ENCODING_32FC1, units, 100'000, 100'000),
            "frame.depth.width, height: "),
      Depth("depth_other_size",
            DepthMessage(v1::DEPTH_ENCODING_16UC1, units, kWidth * 2, kHeight / 2),
            "frame.depth: is 64x12, colour is 32x24; depth must be registered"),
      Depth("depth_png_cut", DepthMessage(v1::DEPTH_ENCODING_16UC1_PNG, CutInHalf(png)),
            "frame.depth.data: not a whole PNG"),
      Depth("depth_png_bomb",
            DepthMessage(v1::DEPTH_ENCODING_16UC1_PNG, PngClaiming(100'000, 100'000)),
            "frame.depth.data: the PNG is 100000x100000, more than"),
      Depth(
          "depth_png_of_color", DepthMessage(v1::DEPTH_ENCODING_16UC1_PNG, PngOf(TestColor())),
          "frame.depth.data: the PNG has 3 channels of 8 bits; depth needs one channel of 16 bits"),
      Depth("zstd_without_size", DepthMessage(v1::DEPTH_ENCODING_16UC1_ZSTD, zstd),
            "frame.depth.width: "),
      Depth("zstd_cut",
            DepthMessage(v1::DEPTH_ENCODING_16UC1_ZSTD, CutInHalf(zstd), kWidth, kHeight),
            "frame.depth.data: not a whole zstd frame"),
      Depth("zstd_bomb", DepthMessage(v1::DEPTH_ENCODING_16UC1_ZSTD, bomb, kWidth, kHeight),
            "frame.depth.data: the zstd frame holds 20000000 bytes, needed are 1536"),
      Depth("zstd_claims_100000x100000",
            DepthMessage(v1::DEPTH_ENCODING_32FC1_ZSTD, zstd, 100'000, 100'000),
            "frame.depth.width, height: "),
      Depth("zstd_with_garbage",
            DepthMessage(v1::DEPTH_ENCODING_16UC1_ZSTD, zstd + "?", kWidth, kHeight),
            "frame.depth.data: has 1 bytes behind"),
      Depth("rvl_without_size", DepthMessage(v1::DEPTH_ENCODING_16UC1_RVL, rvl),
            "frame.depth.width: "),
      Depth("rvl_of_more_pixels",
            DepthMessage(v1::DEPTH_ENCODING_16UC1_RVL, rvl, kWidth, 2 * kHeight),
            "frame.depth.data: the RVL codes end before the pixels do"),
      Depth("rvl_of_fewer_pixels",
            DepthMessage(v1::DEPTH_ENCODING_16UC1_RVL, rvl, kWidth, kHeight / 2),
            "frame.depth.data: has "),
      Depth("rvl_claims_100000x100000",
            DepthMessage(v1::DEPTH_ENCODING_16UC1_RVL, rvl, 100'000, 100'000),
            "frame.depth.width, height: "),
      Depth("rvl_zstd_bomb", DepthMessage(v1::DEPTH_ENCODING_16UC1_RVL_ZSTD, bomb, kWidth, kHeight),
            "frame.depth.data: the zstd frame holds 20000000 bytes, needed are at most 3080"),
  };
}

class BadInputTest : public ::testing::Test {
 protected:
  void ExpectRefused(const std::vector<BadInput>& inputs) {
    for (const BadInput& input : inputs) {
      SCOPED_TRACE(input.name);
      v1::DetectRequest request = TestRequest();
      input.damage(request);
      const grpc::Status status = StatusOf([&] { loopback_.client.Detect(request); });
      EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
      EXPECT_THAT(status.error_message(), StartsWith(input.error_start));
    }
  }

  Loopback loopback_;
};

TEST_F(BadInputTest, NamesBadParts) { ExpectRefused(BadParts()); }
TEST_F(BadInputTest, NamesBadIntrinsics) { ExpectRefused(BadIntrinsics()); }
TEST_F(BadInputTest, NamesBadColors) { ExpectRefused(BadColors()); }
TEST_F(BadInputTest, NamesBadDepths) { ExpectRefused(BadDepths()); }

TEST_F(BadInputTest, RefusesRandomBytesInEveryFileEncoding) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::string bytes(4096, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  ExpectRefused(
      {Color("jpeg", ColorMessage(v1::COLOR_ENCODING_JPEG, bytes), "frame.color.data: "),
       Color("png", ColorMessage(v1::COLOR_ENCODING_PNG, bytes), "frame.color.data: "),
       Depth("depth_png", DepthMessage(v1::DEPTH_ENCODING_16UC1_PNG, bytes), "frame.depth.data: "),
       Depth("zstd", DepthMessage(v1::DEPTH_ENCODING_32FC1_ZSTD, bytes, kWidth, kHeight),
             "frame.depth.data: ")});
}

TEST_F(BadInputTest, RefusesMessagesAboveTheLimit) {
  v1::DetectRequest request = TestRequest();
  request.mutable_frame()->mutable_color()->set_data(std::string(25 << 20, 'x'));
  const grpc::Status status = StatusOf([&] { loopback_.client.Detect(request); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

TEST_F(BadInputTest, RefusesWhatIsNoMessage) {
  const grpc::Status status =
      RawCall(loopback_.server.Address(), "/fovea.v1.DetectionService/Detect", "\xFF\xFF");
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(status.error_message(), "the message is not a DetectRequest");
}

TEST(LimitOfTheMethod, IsNamed) {
  Loopback loopback([](auto&&...) -> Detections { throw TooComplex("too many"); });
  const grpc::Status status = StatusOf([&] { loopback.client.Detect(TestRequest()); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(status.error_message(), "options.parameters[voxels.size_m]: too many");
}

}  // namespace
}  // namespace fovea::testing
