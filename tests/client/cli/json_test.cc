#include "client/cli/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace fovea::cli {
namespace {

TEST(Json, HoldsWhatWasSentBesideTheAnswer) {
  v1::Frame frame;
  frame.mutable_intrinsics()->set_fx(525);
  frame.mutable_color()->set_data("pixels");
  frame.mutable_depth()->set_data("pixels");
  frame.mutable_depth()->set_unit_m(0.0002);
  v1::Detections detections;
  detections.set_frame_id("a");
  detections.add_objects()->set_num_pixels(7);
  for (const JsonLayout layout : {JsonLayout::kIndented, JsonLayout::kOneLine}) {
    const auto json = nlohmann::json::parse(ToJson(detections, frame, layout));
    EXPECT_EQ(json["frame"]["intrinsics"]["fx"], 525);
    EXPECT_EQ(json["frame"]["depth"]["unit_m"], 0.0002);
    EXPECT_EQ(json["frame"].dump().find("data"), std::string::npos);
    EXPECT_EQ(json["frame_id"], "a");
    EXPECT_EQ(json["objects"][0]["num_pixels"], 7);
    EXPECT_EQ(json["objects"][0]["truncated"], false);
    const auto empty = nlohmann::json::parse(ToJson({}, frame, layout));
    EXPECT_EQ(empty["objects"], nlohmann::json::array());
    EXPECT_EQ(empty["frame"]["intrinsics"]["fx"], 525);
  }
  EXPECT_EQ(ToJson(detections, frame, JsonLayout::kOneLine).find('\n'), std::string::npos);
}

TEST(Json, HasNumbersThatAre0OfWhatWasSentToo) {
  v1::Frame frame;
  frame.mutable_intrinsics()->set_fx(525);
  frame.mutable_gravity()->set_y(1);
  frame.mutable_camera_pose()->mutable_orientation()->set_w(1);
  frame.mutable_camera_pose()->mutable_position();
  for (const JsonLayout layout : {JsonLayout::kIndented, JsonLayout::kOneLine}) {
    const auto sent = nlohmann::json::parse(ToJson({}, frame, layout))["frame"];
    EXPECT_EQ(sent["gravity"], nlohmann::json({{"x", 0}, {"y", 1}, {"z", 0}}));
    EXPECT_EQ(sent["camera_pose"]["position"], nlohmann::json({{"x", 0}, {"y", 0}, {"z", 0}}));
    EXPECT_EQ(sent["camera_pose"]["orientation"]["x"], 0);
    EXPECT_EQ(sent["intrinsics"]["cx"], 0);
    EXPECT_FALSE(sent.contains("color"));
    EXPECT_FALSE(sent.contains("depth"));
    EXPECT_FALSE(sent.contains("id"));
  }
}

}  // namespace
}  // namespace fovea::cli
