#include "tests/evaluation/clean_up/client_dialog.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::evaluation {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ClientDialog, ARequestHasTheFrameAndTheHands) {
  scenes::LabelledFrame frame;
  frame.frame.color_rgb = cv::Mat(2, 3, CV_8UC3, cv::Scalar(200, 100, 50));
  frame.frame.depth_m = cv::Mat(2, 3, CV_32FC1, 0.5F);
  frame.frame.depth_m.at<float>(0, 0) = std::numeric_limits<float>::quiet_NaN();
  frame.frame.intrinsics = {500, 501, 1, 0.5};
  Gripper jaw, cup;
  jaw.name = "jaw";
  jaw.max_grasps = 20;
  jaw.min_probability = 0.05F;
  cup.hand = SuctionGripper{.diameter_m = 0.04F};
  cup.max_tilt_rad = 0.8F;
  const std::string line = RequestLine(frame, {jaw, cup}, "1/2");
  EXPECT_EQ(line.find('\n'), std::string::npos);
  v1::DetectRequest request;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(line, &request).ok());
  EXPECT_EQ(request.frame().id(), "1/2");
  EXPECT_EQ(request.frame().intrinsics().fy(), 501);
  const std::string& depth = request.frame().depth().data();
  const cv::Mat depth_mm = cv::imdecode({depth.data(), static_cast<int>(depth.size())}, -1);
  EXPECT_EQ(depth_mm.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(depth_mm.at<std::uint16_t>(1, 2), 500);
  const std::string& color = request.frame().color().data();
  const cv::Mat bgr = cv::imdecode({color.data(), static_cast<int>(color.size())}, -1);
  EXPECT_EQ(bgr.at<cv::Vec3b>(1, 1), cv::Vec3b(50, 100, 200));
  ASSERT_EQ(request.options().grasps().grippers_size(), 2);
  const v1::Gripper& asked_jaw = request.options().grasps().grippers(0);
  const v1::Gripper& asked_cup = request.options().grasps().grippers(1);
  EXPECT_EQ(asked_jaw.name(), "jaw");
  EXPECT_EQ(asked_jaw.max_grasps(), 20U);
  EXPECT_FLOAT_EQ(asked_jaw.min_probability(), 0.05F);
  EXPECT_FLOAT_EQ(asked_cup.suction().diameter_m(), 0.04F);
  EXPECT_FLOAT_EQ(asked_cup.max_tilt_rad(), 0.8F);
}

TEST(ClientDialog, ReadsDecisionsOfBothLibraries) {
  for (const char* line :
       {R"({"grasp":{"tool_center_point":{"x":0.1,"z":0.9},"approach":{"z":1},
           "closing":{"x":1},"opening_m":0.05,"pre_grasp_opening_m":0.09,"gripper_index":1,"probability":0.75}})",
        R"({"grasp": {"tool_center_point": [0.1, 0, 0.9], "approach": [0, 0, 1], "closing":
           [1, 0, 0], "opening_m": 0.05, "pre_grasp_opening_m": 0.09, "gripper_index": 1, "probability": 0.75}})"}) {
    const Decision decision = DecisionOf(line);
    const Grasp& grasp = std::get<Grasp>(decision);
    EXPECT_TRUE(grasp.tool_center_point.isApprox(Eigen::Vector3f(0.1F, 0, 0.9F)));
    EXPECT_EQ(grasp.approach, Eigen::Vector3f::UnitZ());
    EXPECT_EQ(grasp.closing, Eigen::Vector3f::UnitX());
    EXPECT_FLOAT_EQ(grasp.opening_m, 0.05F);
    EXPECT_FLOAT_EQ(grasp.pre_grasp_opening_m, 0.09F);
    EXPECT_EQ(grasp.gripper, 1U);
  }
  for (const char* line :
       {R"({"left":{"objects":[{"bounding_box":{"x":1,"y":2,"width":3,"height":4},
           "no_grasps":[{"gripper":"jaw","reason":"NO_GRASP_REASON_TOO_LOW"}]},
           {"bounding_box":{"width":3,"height":4},"blocked_by":[1]}]}})",
        R"({"left": [{"bounding_box": {"x": 1, "y": 2, "width": 3, "height": 4}, "no_grasps":
           [{"gripper": "jaw", "reason": "too_low"}], "blocked_by": []},
           {"bounding_box": {"x": 0, "y": 0, "width": 3, "height": 4}, "blocked_by": [1]}]})"}) {
    const Decision decision = DecisionOf(line);
    const auto& found = std::get<std::vector<FoundThing>>(decision);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].bounds_px, cv::Rect(1, 2, 3, 4));
    EXPECT_EQ(found[0].reason, "jaw too low");
    EXPECT_EQ(found[1].reason, "something stands on it");
  }
}

TEST(ClientDialog, QuotesWhatItDoesNotUnderstand) {
  const auto quotes = [](const char* part) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(part));
  };
  EXPECT_THAT([] { DecisionOf("Traceback"); }, quotes("\"Traceback\" is no decision"));
  EXPECT_THAT([] { DecisionOf("{}"); }, quotes("left"));
  EXPECT_THAT([] { DecisionOf(R"({"grasp":{"closing":{}}})"); }, quotes("tool_center_point"));
}

}  // namespace
}  // namespace fovea::evaluation
