// Calibrations in JSON with the fields of librealsense's intrinsics, as scripts in Python write
// them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/cli/calibration_file.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RealsenseIntrinsics : public ::testing::Test {
 protected:
  Calibration Read(const std::string& more) const {
    return ReadCalibration(folder_.Write(
        "c.json",
        R"({"width": 640, "height": 480, "ppx": 319.5, "ppy": 238.25, "fx": 615, "fy": 616)" +
            more + "}"));
  }
  std::string WhyNot(const std::string& more) const {
    try {
      Read(more);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const testing::TemporaryFolder folder_;
};

TEST_F(RealsenseIntrinsics, OfALensWithoutDistortionAreRead) {
  for (const char* model : {"None", "Brown Conrady", "Inverse Brown Conrady", "distortion.none"}) {
    const Calibration c =
        Read(R"(, "model": ")" + std::string(model) + R"(", "coeffs": [0, 0.0, 0, 0, 0])");
    EXPECT_EQ(c.cx, 319.5) << model;
    EXPECT_EQ(c.cy, 238.25);
    EXPECT_EQ(c.fy, 616);
    EXPECT_EQ(c.width, 640);
    EXPECT_FALSE(c.distortion) << model;
  }
  EXPECT_FALSE(Read(R"(, "coeffs": [0, 0, 0, 0, 0])").distortion);
  EXPECT_EQ(Read("").cx, 319.5);
}

// As str(), repr() and int() of pyrealsense2's enumeration have it, too.
TEST_F(RealsenseIntrinsics, OfBrownConradyAreThoseOfPlumbBob) {
  for (const char* model : {R"("Brown Conrady")", R"("distortion.brown_conrady")",
                            R"("<distortion.brown_conrady: 4>")", R"("brown_conrady")", "4"}) {
    const Calibration c = Read(R"(, "model": )" + std::string(model) +
                               R"(, "coeffs": [0.1, -0.2, 0.001, 0.002, 0.05])");
    ASSERT_TRUE(c.distortion) << model;
    EXPECT_EQ(c.distortion->model(), v1::DISTORTION_MODEL_BROWN_CONRADY);
    EXPECT_THAT(c.distortion->coefficients(), ElementsAre(0.1, -0.2, 0.001, 0.002, 0.05));
  }
  const Calibration ros = Read(R"(, "distortion_model": "plumb_bob", "coeffs": [0.1, 0, 0, 0, 0])");
  ASSERT_TRUE(ros.distortion);
  EXPECT_EQ(ros.distortion->coefficients(0), 0.1);
}

TEST_F(RealsenseIntrinsics, OfOtherLensesAreRefused) {
  for (const char* model : {"Inverse Brown Conrady", "Modified Brown Conrady", "Ftheta", "None"}) {
    EXPECT_THAT(
        WhyNot(R"(, "model": ")" + std::string(model) + R"(", "coeffs": [0.1, 0, 0, 0, 0])"),
        HasSubstr("c.json: coeffs of the model \"" + std::string(model) + "\" are not all 0"));
  }
  EXPECT_THAT(WhyNot(R"(, "model": "Kannala Brandt4", "coeffs": [0, 0, 0, 0, 0])"),
              HasSubstr("coeffs of the model \"Kannala Brandt4\" are not read"))
      << "a fisheye bends rays even then";
  EXPECT_THAT(WhyNot(R"(, "model": 2, "coeffs": [0.1, 0, 0, 0, 0])"),
              HasSubstr("coeffs of the model \"Inverse Brown Conrady\" are not all 0"));
  EXPECT_THAT(WhyNot(R"(, "coeffs": [0.1, 0, 0, 0, 0])"), HasSubstr("it has coeffs and no model"));
}

TEST_F(RealsenseIntrinsics, ThatAreNoneAreRefused) {
  EXPECT_THAT(WhyNot(R"(, "model": "Brown Conrady", "coeffs": "0 0 0 0 0")"),
              HasSubstr("coeffs must be numbers"));
  EXPECT_THAT(WhyNot(R"(, "model": "Brown Conrady", "coeffs": [0, "x"])"),
              HasSubstr("coeffs must be numbers"));
  EXPECT_THAT(WhyNot(R"(, "model": [4], "coeffs": [0.1])"), HasSubstr("model must be a name"));
  EXPECT_THAT(WhyNot(R"(, "model": 17, "coeffs": [0.1])"), HasSubstr("model must be a name"));
  EXPECT_THAT(WhyNot(R"(, "model": "Brown Conrady", "coeffs": [0, 0, 0, 0, 0, 0, 0, 0, 0.1])"),
              HasSubstr("only the first 8"));
}

}  // namespace
}  // namespace fovea::cli
