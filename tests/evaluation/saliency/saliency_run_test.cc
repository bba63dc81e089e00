#include "tests/evaluation/saliency/saliency_run.h"

#include <gmock/gmock.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "tests/evaluation/saliency/saliency_report.h"
#include "tests/support/data_path.h"

namespace fovea::evaluation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

class SaliencyRun : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("fovea_") + test->name());
    std::filesystem::create_directories(folder_);
    // A red square in a corner of a grey picture.
    cv::Mat picture(60, 80, CV_8UC3, cv::Scalar::all(128));
    picture(cv::Rect(55, 5, 20, 20)).setTo(cv::Scalar(0, 0, 255));
    ASSERT_TRUE(cv::imwrite((folder_ / "square.png").string(), picture));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Write(const std::string& json) {
    const auto path = folder_ / "fixations.json";
    std::ofstream(path) << json;
    return path;
  }

  std::filesystem::path folder_;
};

TEST_F(SaliencyRun, ReadsEachFixatedPixelOnce) {
  const auto images =
      LoadFixations(Write(R"({"b.png": [[3, 4], [1, 4], [3, 4]], "a.png": [[0, 0]]})"));
  ASSERT_EQ(images.size(), 2U);
  EXPECT_EQ(images[0].file, "a.png");
  EXPECT_THAT(images[1].fixations, ElementsAre(cv::Point(1, 4), cv::Point(3, 4)));
}

TEST_F(SaliencyRun, ErrorsNameTheFile) {
  const auto load = [&](const char* json) { LoadFixations(Write(json)); };
  EXPECT_THAT([&] { load("[1"); }, ThrowsMessage<std::runtime_error>(HasSubstr("fixations.json")));
  EXPECT_THAT([&] { load(R"({"a.png": [[1]]})"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a.png: expected pairs")));
  EXPECT_THAT([&] { load(R"({"a.png": []})"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("a.png: no fixations")));
  const auto run = [&](const FixatedImage& image) { RunSaliency(folder_, {image}, {}, {}); };
  EXPECT_THAT(
      [&] {
        run({"none.png", {{0, 0}}});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("none.png: cannot be read")));
  EXPECT_THAT(
      [&] {
        run({"square.png", {{80, 0}}});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr("square.png: a fixation lies outside")));
}

TEST_F(SaliencyRun, EveryMethodButTheCenterFindsTheSquare) {
  const std::vector<FixatedImage> images = {{"square.png", {{60, 10}, {65, 15}, {57, 22}}}};
  std::vector<SaliencyMethod> methods;
  for (const std::string& name : SaliencyMethodNames()) methods.push_back(MakeSaliencyMethod(name));
  std::vector<std::string> order;
  const auto results =
      RunSaliency(folder_, images, methods, {.sigmas = {0, 0.05}},
                  [&](const FixatedImage&, const std::string& method, const cv::Mat& map) {
                    order.push_back(method);
                    EXPECT_EQ(map.type(), CV_32FC1);
                    EXPECT_EQ(map.size(), cv::Size(80, 60));
                  });
  EXPECT_EQ(order, SaliencyMethodNames());
  for (const SaliencyResult& result : results) {
    ASSERT_EQ(result.scores.size(), 2U);
    const SaliencyScores& blurred = result.scores[1][0];
    if (result.method == "center") {
      EXPECT_LT(blurred.nss, 1);
    } else {
      EXPECT_GT(blurred.nss, 1) << result.method;
    }
  }
  // Strength saliency is flat on the square and 0 elsewhere: NSS = (1 − p)/√(p·(1 − p)), and the
  // deviation of the sample is a little above that of the whole.
  const double p = 400.0 / 4800;
  EXPECT_NEAR(results[0].scores[0][0].nss, std::sqrt((1 - p) / p), 1e-3);
}

TEST_F(SaliencyRun, ACenterPriorFavoursTheMiddle) {
  const std::vector<FixatedImage> images = {{"square.png", {{40, 30}}}};
  const std::vector<SaliencyMethod> methods = {{"flat but for a corner", [](const cv::Mat& color) {
                                                  cv::Mat map = cv::Mat::ones(color.size(), CV_32F);
                                                  map.at<float>(0, 0) = 0;
                                                  return map;
                                                }}};
  EXPECT_LT(RunSaliency(folder_, images, methods, {})[0].scores[0][0].nss, 0.1);
  EXPECT_GT(RunSaliency(folder_, images, methods, {.center_prior = 0.25})[0].scores[0][0].nss, 1);
}

TEST(SaliencyCharts, AreDrawnOfMapsThatSayNothing) {
  const SaliencyResult flat{"flat", {{{.auc = 0.5, .nss = 0, .cc = 0}}}, 0};
  const std::string svg = DrawSvg(SaliencyCharts({flat}, {0.0}));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SaliencyOfRecordings, IsAboveChance) {
  const auto data = DataPath("osie");
  if (!data) GTEST_SKIP() << MissingData("osie");
  auto images = LoadFixations(*data / "fixations.json");
  images.resize(4);
  const std::vector<SaliencyMethod> methods = {MakeSaliencyMethod("strength_default")};
  const auto results = RunSaliency(*data / "images", images, methods, {.sigmas = {0.04}});
  for (const SaliencyScores& scores : results[0].scores[0]) {
    EXPECT_GT(scores.auc, 0.6);
    EXPECT_GT(scores.nss, 0.3);
    EXPECT_GT(scores.cc, 0.1);
  }
}

}  // namespace
}  // namespace fovea::evaluation
