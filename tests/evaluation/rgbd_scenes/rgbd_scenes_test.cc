// The loader of RGB-D Scenes, on a file as MATLAB writes it and rendered frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <array>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/evaluation/regions.h"
#include "tests/evaluation/rgbd_scenes/scenario.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

matvar_t* Number(double value) {
  std::array<std::size_t, 2> dims{1, 1};
  return Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims.data(), &value, 0);
}

matvar_t* Text(std::string text) {
  std::array<std::size_t, 2> dims{1, text.size()};
  return Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, dims.data(), text.data(), 0);
}

// A struct array, or an empty matrix as MATLAB has for a frame without objects.
matvar_t* Cell(const std::vector<AnnotatedObject>& objects, const char* left_name) {
  if (objects.empty()) {
    std::array<std::size_t, 2> none{0, 0};
    return Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, none.data(), nullptr, 0);
  }
  std::array<const char*, 6> names{"category", "instance", "top", "bottom", left_name, "right"};
  std::array<std::size_t, 2> dims{1, objects.size()};
  matvar_t* cell = Mat_VarCreateStruct(nullptr, 2, dims.data(), names.data(), names.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const cv::Rect& box = objects[i].box;
    Mat_VarSetStructFieldByName(cell, names[0], i, Text(objects[i].category));
    Mat_VarSetStructFieldByName(cell, names[1], i, Number(1));
    Mat_VarSetStructFieldByName(cell, names[2], i, Number(box.y + 1));
    Mat_VarSetStructFieldByName(cell, names[3], i, Number(box.y + box.height));
    Mat_VarSetStructFieldByName(cell, names[4], i, Number(box.x + 1));
    Mat_VarSetStructFieldByName(cell, names[5], i, Number(box.x + box.width));
  }
  return cell;
}

class RgbdScenes : public ::testing::Test {
 protected:
  RgbdScenes() {
    std::string pattern = (fs::temp_directory_path() / "fovea_scenes_XXXXXX").string();
    data_ = mkdtemp(pattern.data());
    fs::create_directories(data_ / "table" / "table_1");
  }
  ~RgbdScenes() override { fs::remove_all(data_); }

  fs::path Annotations() const { return data_ / "table" / "table_1.mat"; }

  void Write(const std::vector<std::vector<AnnotatedObject>>& frames, const char* variable,
             const char* left_name = "left") const {
    mat_t* file = Mat_CreateVer(Annotations().c_str(), nullptr, MAT_FT_MAT5);
    std::array<std::size_t, 2> dims{1, frames.size()};
    matvar_t* cells = Mat_VarCreate(variable, MAT_C_CELL, MAT_T_CELL, 2, dims.data(), nullptr, 0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      Mat_VarSetCell(cells, static_cast<int>(i), Cell(frames[i], left_name));
    }
    // matio compresses some nested texts so that it cannot read them itself.
    Mat_VarWrite(file, cells, MAT_COMPRESSION_NONE);
    Mat_VarFree(cells);
    Mat_Close(file);
  }

  // Frame `number` of a generated scene; returns its true boxes.
  std::vector<AnnotatedObject> WriteFrame(int number) const {
    const auto scene = scenes::MakeFrame(scenes::RandomScene("tabletop", 1, {320, 240}),
                                         scenes::SensorKind::kIdeal, 1);
    const std::string stem =
        (data_ / "table" / "table_1" / ("table_1_" + std::to_string(number))).string();
    cv::Mat bgr, millimetres;
    cv::cvtColor(scene.frame.color_rgb, bgr, cv::COLOR_RGB2BGR);
    cv::patchNaNs(scene.frame.depth_m, 0);
    scene.frame.depth_m.convertTo(millimetres, CV_16U, 1000);
    cv::imwrite(stem + ".png", bgr);
    cv::imwrite(stem + "_depth.png", millimetres);
    std::vector<AnnotatedObject> objects;
    for (const Region& region : Regions(scene.labels)) objects.push_back({"bowl", region.bounds});
    intrinsics_ = scene.frame.intrinsics;
    return objects;
  }

  fs::path data_;
  mutable CameraIntrinsics intrinsics_;
};

TEST_F(RgbdScenes, ReadsWhatMatlabWrites) {
  Write({{{"cap", {10, 20, 30, 40}}, {"soda_can", {0, 0, 1, 1}}}, {}}, "bboxes");
  const auto frames = ReadAnnotations(Annotations());
  ASSERT_EQ(frames.size(), 2U);
  ASSERT_EQ(frames[0].size(), 2U);
  EXPECT_EQ(frames[0][0].category, "cap");
  EXPECT_EQ(frames[0][0].box, cv::Rect(10, 20, 30, 40));
  EXPECT_EQ(frames[0][1].box, cv::Rect(0, 0, 1, 1));
  EXPECT_TRUE(frames[1].empty());
}

TEST_F(RgbdScenes, CountsTheAnnotatedObjectsThatAreDetected) {
  std::vector<AnnotatedObject> objects = WriteFrame(2);  // of frame 1 there are no images
  const int num_true = static_cast<int>(objects.size());
  ASSERT_GT(num_true, 2);
  objects.push_back({"cap", {0, 0, 5, 5}});  // nothing is there
  Write({{{"cap", {0, 0, 5, 5}}}, objects}, "bboxes");
  const std::vector<Scenario> scenarios = FindScenarios(data_);
  ASSERT_EQ(scenarios.size(), 1U);
  EXPECT_EQ(scenarios[0].name, "table_1");
  const DetectionRate rate = RateOf(scenarios[0], intrinsics_, OptionsOfProfile("default"));
  EXPECT_EQ(rate.objects, num_true + 1);
  EXPECT_GE(rate.detected, num_true - 1);
  EXPECT_LE(rate.detected, num_true);
}

TEST_F(RgbdScenes, NamesWhatIsWrongWithAFile) {
  const auto read = [&] { ReadAnnotations(Annotations()); };
  EXPECT_THAT(read, ThrowsMessage<std::runtime_error>(HasSubstr("table_1.mat: cannot be read")));
  std::ofstream(Annotations()) << "no MATLAB file at all";
  EXPECT_THAT(read, ThrowsMessage<std::runtime_error>(HasSubstr("table_1.mat: ")));
  Write({{}}, "boxes");
  EXPECT_THAT(read, ThrowsMessage<std::runtime_error>(HasSubstr("no variable bboxes")));
  Write({{{"cap", {1, 1, 2, 2}}}}, "bboxes", "links");
  EXPECT_THAT(read, ThrowsMessage<std::runtime_error>(HasSubstr("bboxes{1}(1).left is missing")));
  Write({{}, {{"cap", {-5, 1, 2, 2}}}}, "bboxes");
  EXPECT_THAT(read,
              ThrowsMessage<std::runtime_error>(HasSubstr("bboxes{2}(1).left is -4, no pixel")));
}

TEST_F(RgbdScenes, NamesWhatIsMissing) {
  EXPECT_THAT([&] { FindScenarios(data_); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no NAME.mat")));
  Write({{}}, "bboxes");
  EXPECT_THAT([&] { RateOf(FindScenarios(data_).front(), intrinsics_, {}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no frames")));
}

TEST(PublishedRateOf, IsTable4) {
  EXPECT_EQ(PublishedRateOf("table_small_2").percent, 98.5);
  EXPECT_EQ(PublishedRateOf("desk_9").objects, 0);
}

}  // namespace
}  // namespace fovea::evaluation
