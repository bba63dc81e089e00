#include "tests/evaluation/dataset.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/random_scene.h"
#include "tests/support/scene_files.h"

namespace fovea::evaluation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const CameraIntrinsics kIntrinsics = {525, 525, 319.5, 239.5};

// An empty folder of its own for each test.
class Dataset : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("fovea_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& file, const cv::Mat& image) {
    ASSERT_TRUE(cv::imwrite((folder_ / file).string(), image));
  }

  // A scene of one row of four pixels.
  void WriteScene(const std::string& name) {
    Write(name + "_color.png", cv::Mat(1, 4, CV_8UC3, cv::Scalar(30, 20, 10)));
    Write(name + "_depth.png", (cv::Mat_<std::uint16_t>(1, 4) << 0, 1500, 2000, 2500));
    Write(name + "_label.png", (cv::Mat_<std::uint8_t>(1, 4) << 20, 3, 21, 35));
  }

  std::filesystem::path folder_;
};

TEST_F(Dataset, NamesAreInNumericalOrder) {
  for (const char* name : {"test2", "learn10", "learn2"}) WriteScene(name);
  Write("unlabelled_color.png", cv::Mat(1, 1, CV_8UC3));
  EXPECT_THAT(SceneNames(folder_), ElementsAre("learn2", "learn10", "test2"));
}

TEST_F(Dataset, DecodesMosdLabelsAndLeavesOutPixelsWithoutDepth) {
  WriteScene("a");
  const Scene scene = LoadScene(folder_, "a", LabelEncoding::kMosd, kIntrinsics);
  EXPECT_THAT(std::vector<std::uint16_t>(scene.truth), ElementsAre(1, 0, 1, 2));
  EXPECT_THAT(std::vector<std::uint8_t>(scene.valid), ElementsAre(0, 255, 255, 255));
  EXPECT_EQ(scene.frame.color_rgb.at<cv::Vec3b>(0, 0), cv::Vec3b(10, 20, 30));
  EXPECT_TRUE(std::isnan(scene.frame.depth_m.at<float>(0, 0)));
  EXPECT_FLOAT_EQ(scene.frame.depth_m.at<float>(0, 1), 1.5F);
}

TEST_F(Dataset, LabelsHoldOnlyWhereTheLabelledDepthIs) {
  WriteScene("a");
  Write("a_labelled_depth.png", (cv::Mat_<std::uint16_t>(1, 4) << 0, 0, 2000, 2500));
  const Scene scene = LoadScene(folder_, "a", LabelEncoding::kMosd, kIntrinsics);
  EXPECT_THAT(std::vector<std::uint8_t>(scene.valid), ElementsAre(0, 0, 255, 255));
  EXPECT_FALSE(std::isnan(scene.frame.depth_m.at<float>(0, 1)));
}

TEST_F(Dataset, ErrorsNameTheFile) {
  EXPECT_THAT([&] { SceneNames(folder_); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no labelled scenes")));
  WriteScene("a");
  Write("a_depth.png", cv::Mat::zeros(1, 4, CV_8UC1));
  EXPECT_THAT([&] { LoadScene(folder_, "a", LabelEncoding::kMosd, kIntrinsics); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a_depth.png: unexpected pixel type")));
  Write("a_depth.png", cv::Mat::zeros(2, 4, CV_16UC1));
  EXPECT_THAT([&] { LoadScene(folder_, "a", LabelEncoding::kMosd, kIntrinsics); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a_depth.png: its size differs")));
}

TEST_F(Dataset, GeneratedFramesComeBackAsTheyWere) {
  const auto frame = scenes::MakeFrame(scenes::RandomScene("tabletop", 1, {160, 120}),
                                       scenes::SensorKind::kKinect, 1);
  scenes::WriteFrame(folder_, "tabletop_1", frame);
  const Scene scene =
      LoadScene(folder_, "tabletop_1", LabelEncoding::kPlain, frame.frame.intrinsics);
  EXPECT_EQ(cv::norm(scene.frame.color_rgb, frame.frame.color_rgb, cv::NORM_INF), 0);
  EXPECT_EQ(cv::countNonZero(scene.truth != frame.labels), 0);
  const cv::Mat measured = frame.frame.depth_m == frame.frame.depth_m;
  EXPECT_EQ(cv::countNonZero(scene.valid != measured), 0);
  EXPECT_LT(cv::norm(scene.frame.depth_m, frame.frame.depth_m, cv::NORM_INF, measured), 1e-6);
}

}  // namespace
}  // namespace fovea::evaluation
