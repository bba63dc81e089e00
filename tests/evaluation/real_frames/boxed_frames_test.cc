#include "tests/evaluation/real_frames/boxed_frames.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "tests/evaluation/real_frames/boxed_run.h"
#include "tests/support/data_path.h"

namespace fovea::evaluation {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class BoxedFrames : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("boxed_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "lab");
    Write("boxes.json", R"({"a": [{"name": "cup", "box": [1, 2, 4, 6]},
                                  {"name": "note", "box": [0, 0, 2, 2], "small": true}]})");
    Write("intrinsics.txt", "610.5,611.5,320,240\n");
    cv::imwrite((folder_ / "lab/a_color.jpg").string(), cv::Mat(8, 8, CV_8UC3, cv::Scalar(9)));
    cv::imwrite((folder_ / "lab/a_depth.png").string(), cv::Mat(8, 8, CV_16UC1, cv::Scalar(700)));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& file, const std::string& text) {
    std::ofstream(folder_ / "lab" / file) << text;
  }

  std::filesystem::path folder_;
};

TEST_F(BoxedFrames, AreReadFromEverySourceOrFromOne) {
  for (const auto& folder : {folder_, folder_ / "lab", folder_ / "lab/"}) {
    const std::vector<BoxedFrame> frames = LoadBoxedFrames(folder);
    ASSERT_EQ(frames.size(), 1U) << folder;
    EXPECT_EQ(frames[0].source, "lab");
    EXPECT_EQ(frames[0].name, "a");
    EXPECT_EQ(frames[0].frame.intrinsics.fy_px, 611.5);
    EXPECT_FLOAT_EQ(frames[0].frame.depth_m.at<float>(3, 3), 0.7F);
    ASSERT_EQ(frames[0].objects.size(), 2U);
    EXPECT_EQ(frames[0].objects[0].box, cv::Rect(1, 2, 3, 4));
    EXPECT_FALSE(frames[0].objects[0].optional);
    EXPECT_TRUE(frames[0].objects[1].optional);
  }
}

TEST_F(BoxedFrames, SayWhichFileIsWrong) {
  const auto load = [this] { return LoadBoxedFrames(folder_); };
  Write("intrinsics.txt", "610.5,none");
  EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("intrinsics.txt: expected fx")));
  Write("intrinsics.txt", "1,1,1,1");
  Write("boxes.json", R"({"a": [{"name": "cup", "box": [1, 2]}]})");
  EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("boxes.json: ")));
  Write("boxes.json", R"({"b": []})");
  EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("b_color.jpg: cannot be read")));
  std::filesystem::remove_all(folder_ / "lab");
  EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("no boxes.json here")));
}

TEST_F(BoxedFrames, HaveBoxesWithinTheImage) {
  const auto load = [this] { return LoadBoxedFrames(folder_); };
  for (const char* box : {"[3, 2, 1, 6]", "[1, 2, 1, 6]", "[1, 2, 9, 6]", "[-1, 2, 4, 6]",
                          "[1, 2, 4, 4294967302]", "[1.5, 2, 4, 6]", "[1, 2, 4, 6, 7]"}) {
    Write("boxes.json", std::string(R"({"a": [{"name": "cup", "box": )") + box + "}]}");
    EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("boxes.json: a: box ["))) << box;
  }
}

TEST_F(BoxedFrames, AreListedOneByOne) {
  const auto load = [this] { return LoadBoxedFrames(folder_); };
  Write("boxes.json", R"({"a": []})");
  EXPECT_EQ(load().size(), 1U);
  Write("boxes.json", "{}");
  EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("boxes.json: no frames here")));
  for (const char* text : {"null", "[]", R"({"a": null})", R"({"a": {}})", R"({"a": 5})"}) {
    Write("boxes.json", text);
    EXPECT_THAT(load, ThrowsMessage<std::runtime_error>(HasSubstr("boxes.json: "))) << text;
  }
}

TEST_F(BoxedFrames, AreRunAndSummedUpBySource) {
  std::vector<BoxedFrame> frames = LoadBoxedFrames(folder_);
  frames.push_back(frames[0]);
  frames[1].source = "glass_transparent";
  const auto find_cup = [](const RgbdFrame& frame) {
    Detections found;
    found.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
    found.labels(cv::Rect(1, 2, 3, 4)).setTo(5);
    found.objects.resize(1);
    found.objects[0].label = 5;
    found.objects[0].confidence = 0.9F;
    return found;
  };
  const std::vector<BoxedFrameResult> results = RunBoxedFrames(frames, find_cup, 2);
  ASSERT_EQ(results[0].predictions.size(), 1U);
  EXPECT_TRUE(results[0].predictions[0].correct);
  const BoxSummary summary = Summarize(results);
  EXPECT_EQ(summary.all.found, 1);
  EXPECT_EQ(summary.clear.found, 1);
  EXPECT_EQ(summary.mean_f1, 1);
}

TEST(BoxReport, SaysNothingOfWhatThereIsNot) {
  for (const bool is_clear : {false, true}) {
    const BoxSummary summary =
        Summarize({{is_clear ? "glass_transparent" : "lab", "a", {}, 1, {}}});
    std::ostringstream text;
    PrintBoxSummary(text, "default", summary);
    PrintSideBySide(text, {"default"}, {summary});
    EXPECT_EQ(text.str().find("\nclear glass") != std::string::npos, is_clear);
    EXPECT_EQ(text.str().find("\nall but clear glass") != std::string::npos, !is_clear);
    EXPECT_EQ(ToJson(summary).contains("clear_glass"), is_clear);
    EXPECT_EQ(ToJson(summary).contains("all"), !is_clear);
  }
}

TEST(RealFrames, AreAllReadable) {
  const auto data = DataPath("real");
  if (!data) GTEST_SKIP() << MissingData("real");
  EXPECT_EQ(LoadBoxedFrames(*data).size(), 44U);
}

}  // namespace
}  // namespace fovea::evaluation
