#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "client/capture/intrinsics.h"
#include "client/cli/calibration_file.h"
#include "client/images.h"
#include "tests/support/temporary_folder.h"

namespace fovea::capture {
namespace {

using cli::Calibration;
using cli::ReadCalibration;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kRos = R"(image_width: 640
image_height: 480
camera_name: head
camera_matrix:
  rows: 3
  cols: 3
  data: [540.5, 0, 315.25, 0, 541.5, 238.75, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.04, -0.1, 0, 0, 0]
)";

class CalibrationTest : public ::testing::Test {
 protected:
  void ExpectRefused(const std::string& text, const std::string& reason) {
    const std::string path = folder_.Write("c.yaml", text);
    try {
      ReadCalibration(path);
      FAIL() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("calibration file " + path + ": "));
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
  }

  testing::TemporaryFolder folder_;
};

TEST_F(CalibrationTest, ReadsCameraInfo) {
  const Calibration c = ReadCalibration(folder_.Write("c.yaml", kRos));
  EXPECT_EQ(c.fx, 540.5);
  EXPECT_EQ(c.fy, 541.5);
  EXPECT_EQ(c.cx, 315.25);
  EXPECT_EQ(c.cy, 238.75);
  EXPECT_EQ(c.width, 640);
  EXPECT_EQ(c.height, 480);
  ASSERT_TRUE(c.distortion);
  EXPECT_EQ(c.distortion->model(), v1::DISTORTION_MODEL_BROWN_CONRADY);
  EXPECT_THAT(c.distortion->coefficients(), ElementsAre(0.04, -0.1, 0, 0, 0));
}

TEST_F(CalibrationTest, ReadsJson) {
  const Calibration c = ReadCalibration(folder_.Write(
      "c.json", R"( {"fx": 500, "fy": 501, "cx": 320, "cy": 240.5, "width": 640, "height": 480})"));
  EXPECT_EQ(c.fx, 500);
  EXPECT_EQ(c.fy, 501);
  EXPECT_EQ(c.cx, 320);
  EXPECT_EQ(c.cy, 240.5);
  EXPECT_EQ(c.width, 640);
  EXPECT_EQ(c.height, 480);
  EXPECT_FALSE(c.distortion);
}

TEST_F(CalibrationTest, TakesDistortionByAnyOfItsNames) {
  const std::string k =
      R"("fx": 500, "fy": 500, "cx": 320, "cy": 240, "width": 640, "height": 480)";
  const auto file = [&](const std::string& more) { return "{" + k + ", " + more + "}"; };
  for (const char* name : {"distortion", "distortion_coefficients", "D", "d"}) {
    const Calibration c = ReadCalibration(
        folder_.Write("c.json", file("\"" + std::string(name) + R"(": [0.5, 0, 0, 0, 0])")));
    ASSERT_TRUE(c.distortion) << name;
    EXPECT_EQ(c.distortion->coefficients(0), 0.5);
  }
  ExpectRefused(file(R"("distortion_model": "plumb_bob", "k1": 0.5)"),
                "it has a distortion_model (plumb_bob) and no distortion");
  ExpectRefused(file(R"("D": {"k1": 1})"), "D must be numbers");
}

TEST_F(CalibrationTest, RefusesSidesThatAreNoWholeNumbers) {
  for (const char* width : {"640.5", "1e300", "-1e300"}) {
    ExpectRefused(
        std::string(R"({"fx": 1, "fy": 1, "cx": 1, "cy": 1, "height": 4, "width": )") + width + "}",
        "width must be a whole number of pixels");
  }
}

// As `ros2 topic echo --once` prints a message.
TEST_F(CalibrationTest, ReadsACameraInfoMessage) {
  const Calibration c = ReadCalibration(folder_.Write(
      "c.yaml",
      "header:\n  frame_id: camera\nheight: 480\nwidth: 640\ndistortion_model: plumb_bob\n"
      "d:\n- 0.0\n- 0.0\nk:\n- 615.0\n- 0.0\n- 320.5\n- 0.0\n- 616.0\n- 240.5\n- 0.0\n- 0.0\n"
      "- 1.0\n---\n"));
  EXPECT_EQ(c.fx, 615);
  EXPECT_EQ(c.cy, 240.5);
  EXPECT_EQ(c.width, 640);
  EXPECT_FALSE(c.distortion);
  ExpectRefused("k: [1, 2]\nwidth: 640\nheight: 480\n", "k must have 9 numbers");
  ExpectRefused("k: [1, 0, 1, 0, 1, 1, 0, 0, 1]\n", "it has no width");
}

TEST_F(CalibrationTest, ReadsACameraInfoOfImagesThatAreCutOutAndBinned) {
  const std::string k = "k: [600, 0, 320, 0, 600, 240, 0, 0, 1]\nwidth: 640\nheight: 480\n";
  const Calibration c = ReadCalibration(folder_.Write(
      "c.yaml", k + "binning_x: 2\nbinning_y: 0\nroi:\n  x_offset: 100\n  y_offset: 40\n"
                    "  height: 300\n  width: 200\n  do_rectify: false\n"));
  EXPECT_EQ(c.fx, 300);
  EXPECT_EQ(c.fy, 600);
  EXPECT_EQ(c.cx, 110);
  EXPECT_EQ(c.cy, 200);
  EXPECT_EQ(c.width, 100);
  EXPECT_EQ(c.height, 300);
  ExpectRefused(k + "roi: {x_offset: 600, width: 41}\n", "its roi is not within");
  ExpectRefused(k + "binning_x: 641\n", "its binning leaves no pixel");
}

// As bags turned into JSON have it.
TEST_F(CalibrationTest, ReadsACameraInfoMessageInJson) {
  const Calibration c = ReadCalibration(
      folder_.Write("c.json",
                    R"({"height": 480, "width": 640, "distortion_model": "rational_polynomial",
          "D": [0.5, -2, 0.001, 0, 1, 0.4, -1.8, 1, 0, 0, 0, 0],
          "K": [615, 0, 320.5, 0, 616, 240.5, 0, 0, 1]})"));
  EXPECT_EQ(c.cx, 320.5);
  ASSERT_TRUE(c.distortion);
  EXPECT_THAT(c.distortion->coefficients(), ElementsAre(0.5, -2, 0.001, 0, 1, 0.4, -1.8, 1));
}

TEST_F(CalibrationTest, RefusesLensesThatNoServerKnows) {
  const std::string k = "k: [1, 0, 1, 0, 1, 1, 0, 0, 1]\nwidth: 4\nheight: 3\n";
  ExpectRefused(k + "distortion_model: magic\nd: [1, 0, 0, 0]\n", "\"magic\" is not plumb_bob");
  ExpectRefused(k + "d: [1, 0, 0, 0, 0, 0, 0, 0, 0, 0.5]\n", "only the first 8");
  ExpectRefused(k + "d: [.nan, 0, 0, 0]\n", "must be finite");
  ExpectRefused(k + "d: [a, 0, 0, 0]\n", "bad conversion");
}

TEST_F(CalibrationTest, ReadsNumbersAlone) {
  const Calibration c = ReadCalibration(folder_.Write("c.txt", "525,526,319.5,239.5\n"));
  EXPECT_EQ(c.fy, 526);
  EXPECT_EQ(c.width, 0) << "not said";
  ExpectRefused("525,526\n", "is not FX,FY,CX,CY");
  ExpectRefused("525 0 319.5\n0 525 239.5\n0 0 1\n", "are more than one line FX,FY,CX,CY");
}

// Some editors begin files with it.
TEST_F(CalibrationTest, ReadsPastAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(ReadCalibration(folder_.Write("c.txt", mark + "525,526,1,2\n")).fy, 526);
  EXPECT_EQ(ReadCalibration(folder_.Write("c.json", mark + R"({"fx": 1, "fy": 7, "cx": 1, "cy": 1,
            "width": 4, "height": 4})"))
                .fy,
            7);
  EXPECT_EQ(ReadCalibration(folder_.Write("c.yaml", mark + kRos)).fx, 540.5);
}

TEST_F(CalibrationTest, ReadsWhatItWrites) {
  const Calibration written{
      .fx = 525.25,
      .fy = 526,
      .cx = 1.5,
      .cy = 2,
      .width = 4,
      .height = 3,
      .distortion = client::MakeLensDistortion("rational_polynomial", {1, 2, 3, 4, 5, 6, 7, 8.5})};
  const Calibration read =
      ReadCalibration(folder_.Write("c.json", cli::ToCalibrationJson(written)));
  EXPECT_EQ(read.fx, written.fx);
  EXPECT_EQ(read.cx, written.cx);
  EXPECT_EQ(read.height, written.height);
  ASSERT_TRUE(read.distortion);
  EXPECT_EQ(read.distortion->model(), v1::DISTORTION_MODEL_BROWN_CONRADY);
  EXPECT_THAT(read.distortion->coefficients(), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8.5));
  const Calibration fisheye{.fx = 1,
                            .fy = 1,
                            .cx = 1,
                            .cy = 1,
                            .width = 2,
                            .height = 2,
                            .distortion = client::MakeLensDistortion("equidistant", {0, 0, 0, 0})};
  const Calibration again =
      ReadCalibration(folder_.Write("c.json", cli::ToCalibrationJson(fisheye)));
  ASSERT_TRUE(again.distortion) << "a fisheye bends rays even then";
  EXPECT_EQ(again.distortion->model(), v1::DISTORTION_MODEL_KANNALA_BRANDT);
}

TEST_F(CalibrationTest, SaysWhatIsMissing) {
  ExpectRefused("image_width: 640\n", "it has no camera_matrix");
  ExpectRefused("just text", "it is neither FX,FY,CX,CY nor YAML or JSON of a camera");
  ExpectRefused("-525,525,319.5,239.5", "focal lengths must be above 0");
  ExpectRefused("a: [", "c.yaml");
  ExpectRefused("{\"fx\": 1}", "fy");
  ExpectRefused("camera_matrix: {data: [1, 2]}", "camera_matrix must have 9 numbers");
  ExpectRefused(
      "camera_matrix: {data: [0, 0, 1, 0, 1, 1, 0, 0, 1]}\nimage_width: 4\n"
      "image_height: 3\n",
      "focal lengths must be above 0");
  ExpectRefused(
      "camera_matrix: {data: [1, 0, 1, 0, 1, 1, 0, 0, 1]}\nimage_width: 0\n"
      "image_height: 3\n",
      "width and height must be above 0");
  for (const char* matrix : {"525, 0, 0, 0, 525, 0, 319.5, 239.5, 1",  // column by column
                             "525, 12, 319.5, 0, 525, 239.5, 0, 0, 1"}) {
    ExpectRefused("camera_matrix: {data: [" + std::string(matrix) +
                      "]}\nimage_width: 640\nimage_height: 480\n",
                  "camera_matrix is not fx 0 cx, 0 fy cy, 0 0 1, row by row");
  }
  EXPECT_THROW(ReadCalibration(folder_.At("none")), std::runtime_error);
}

TEST_F(CalibrationTest, ChoosesTheBestThatIsKnown) {
  const std::string path = folder_.Write("c.yaml", kRos);
  const FieldOfView view{1.0, 0.8};
  const auto choose = [](const IntrinsicsFlags& flags, const FieldOfView& stated,
                         const cv::Size& size) {
    return ChooseIntrinsics(ReadIntrinsics(flags), stated, size);
  };
  const ChosenIntrinsics from_file = choose({path, "", ""}, view, {640, 480});
  EXPECT_EQ(from_file.values.fx(), 540.5);
  EXPECT_EQ(from_file.values.distortion().coefficients_size(), 5);
  EXPECT_THAT(Describe(from_file), HasSubstr("cy 238.8, plumb_bob distortion, from the calib"));
  EXPECT_EQ(Describe(choose({"", path, ""}, view, {640, 480})), Describe(from_file));
  const ChosenIntrinsics without = choose({path, "", "none"}, view, {640, 480});
  EXPECT_FALSE(without.values.has_distortion());
  const ChosenIntrinsics other =
      choose({"", "1,2,3,4", "plumb_bob=0.1,0,0,-0.5"}, view, {640, 480});
  EXPECT_THAT(other.values.distortion().coefficients(), ElementsAre(0.1, 0, 0, -0.5));
  EXPECT_THROW(choose({path, "", "0.1,0,0,0"}, view, {640, 480}), std::invalid_argument);
  EXPECT_EQ(choose({"", "1,2,3,4", ""}, view, {640, 480}).values.cy(), 4);
  EXPECT_THAT(choose({}, view, {640, 480}).source, HasSubstr("field of view"));
  EXPECT_THROW(choose({path, "", ""}, view, {320, 240}), std::runtime_error);
  EXPECT_THROW(choose({"", "1,2", ""}, view, {640, 480}), std::invalid_argument);
  EXPECT_THROW(choose({"", "0,2,3,4", ""}, view, {640, 480}), std::invalid_argument);
  EXPECT_THROW(choose({}, {0, 0}, {640, 480}), std::runtime_error);
}

TEST(FieldOfView, GivesTheFocalLengthWhoseRaysMeetTheImageBorder) {
  const FieldOfView view{2 * std::atan(320 / 525.0), 2 * std::atan(240 / 530.0)};
  const v1::CameraIntrinsics k = FromFieldOfView(view, {640, 480});
  EXPECT_NEAR(k.fx(), 525, 1e-9);
  EXPECT_NEAR(k.fy(), 530, 1e-9);
  EXPECT_EQ(k.cx(), 319.5);
  EXPECT_EQ(k.cy(), 239.5);
}

}  // namespace
}  // namespace fovea::capture
