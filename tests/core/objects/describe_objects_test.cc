#include "core/objects/describe_objects.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

#include "core/depth/back_projection.h"

namespace fovea {
namespace {

// A 640×480 frame at 1 m with rectangles of labels.
struct LabelledObjects {
  RgbdFrame frame{cv::Mat(480, 640, CV_8UC3, cv::Scalar(10, 20, 30)),
                  cv::Mat(480, 640, CV_32FC1, cv::Scalar(1.0F)),
                  {500, 500, 320, 240},
                  std::nullopt};
  cv::Mat saliency{480, 640, CV_32FC1, cv::Scalar(0.5F)};
  std::vector<float> confidences = std::vector<float>(9, 0.5F);
  std::vector<char> is_cut;
  Detections detections;
  cv::Mat shown_m;  // the depth of what is described; the frame's unless there is another

  LabelledObjects() { detections.labels = cv::Mat::zeros(480, 640, CV_16UC1); }
  void Label(const cv::Rect& rectangle, int label) { detections.labels(rectangle).setTo(label); }
  void Describe(const ObjectOptions& options = {}) {
    const PixelPoints points(shown_m.empty() ? frame.depth_m : shown_m, frame.intrinsics);
    const std::vector<Support> supports =
        detections.support ? std::vector<Support>{{*detections.support, Footprint()}}
                           : std::vector<Support>{};
    DescribeObjects(frame, points, {saliency}, {confidences, is_cut}, supports, options,
                    detections);
  }
};

TEST(DescribeObjects, OrdersByConfidenceAndRenumbers) {
  LabelledObjects scene;
  scene.Label({100, 100, 20, 20}, 4);
  scene.Label({200, 200, 40, 50}, 9);
  scene.confidences[3] = 0.4F;
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 2U);
  const DetectedObject& first = scene.detections.objects[0];
  EXPECT_EQ(first.label, 1);
  EXPECT_EQ(first.bounds_px, cv::Rect(200, 200, 40, 50));
  EXPECT_EQ(first.num_pixels, 2000U);
  EXPECT_GT(first.confidence, scene.detections.objects[1].confidence);
  EXPECT_EQ(scene.detections.labels.at<std::uint16_t>(210, 210), 1);
  EXPECT_EQ(scene.detections.labels.at<std::uint16_t>(110, 110), 2);
  EXPECT_EQ(cv::countNonZero(scene.detections.labels), 2400);
}

TEST(DescribeObjects, OrdersBySizeWhereConfidenceIsEqual) {
  LabelledObjects scene;
  scene.Label({100, 100, 60, 60}, 1);
  scene.Label({200, 200, 80, 80}, 2);
  scene.Label({400, 200, 60, 60}, 3);
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 3U);
  EXPECT_EQ(scene.detections.objects[0].confidence, scene.detections.objects[2].confidence);
  EXPECT_EQ(scene.detections.objects[0].num_pixels, 6400U);
  EXPECT_EQ(scene.detections.objects[1].bounds_px.x, 100);
  EXPECT_EQ(scene.detections.objects[2].bounds_px.x, 400);
}

TEST(DescribeObjects, DropsAndCountsWhatIsTooSmall) {
  LabelledObjects scene;
  scene.Label({100, 100, 17, 17}, 1);  // 289
  scene.Label({200, 100, 20, 15}, 2);  // 300
  scene.Describe();                    // min_pixels is 300
  EXPECT_EQ(scene.detections.objects.size(), 1U);
  EXPECT_EQ(scene.detections.diagnostics.segments_too_small, 1U);
  EXPECT_EQ(scene.detections.labels.at<std::uint16_t>(101, 101), 0);
}

TEST(DescribeObjects, GivesCentroidColorCloudAndHeight) {
  LabelledObjects scene;
  scene.detections.support = SupportSurface{-Eigen::Vector3f::UnitY(), 0.3F, 100};
  scene.Label({310, 230, 21, 21}, 1);  // centred on the optical axis
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 1U);
  const DetectedObject& object = scene.detections.objects[0];
  EXPECT_TRUE(object.centroid.isApprox(Eigen::Vector3f(0, 0, 1), 1e-5F));
  EXPECT_EQ(object.mean_color, (std::array<std::uint8_t, 3>{10, 20, 30}));
  ASSERT_EQ(object.cloud.size(), 441U);
  EXPECT_FLOAT_EQ(object.cloud[0].x, -10.0F / 500);
  EXPECT_EQ(object.cloud[0].g, 20);
  EXPECT_NEAR(object.height_above_support_m.value(), 0.3F - 10.0F / 500, 1e-5F);
}

TEST(DescribeObjects, FlagsObjectsAtTheImageBorder) {
  LabelledObjects scene;
  scene.Label({0, 100, 30, 30}, 1);
  scene.Label({610, 200, 30, 29}, 2);
  scene.Label({300, 200, 28, 28}, 3);
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 3U);
  EXPECT_TRUE(scene.detections.objects[0].truncated);
  EXPECT_TRUE(scene.detections.objects[1].truncated);
  EXPECT_FALSE(scene.detections.objects[2].truncated);
}

TEST(DescribeObjects, FlagsObjectsWithoutDepthAndTakesThemForAsDeepAsWide) {
  LabelledObjects scene;
  scene.Label({300, 200, 40, 40}, 1);
  scene.Label({400, 200, 40, 40}, 2);
  scene.shown_m = scene.frame.depth_m.clone();
  scene.detections.support = SupportSurface{-Eigen::Vector3f::UnitY(), 0.3F, 100};
  scene.frame.depth_m(cv::Rect(300, 200, 40, 21)).setTo(std::numeric_limits<float>::quiet_NaN());
  scene.frame.depth_m(cv::Rect(400, 200, 40, 20)).setTo(std::numeric_limits<float>::quiet_NaN());
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 2U);
  for (const DetectedObject& object : scene.detections.objects) {
    EXPECT_EQ(object.depth_missing, object.bounds_px.x == 300);
    const Eigen::Vector3f& size = object.box.size_m;
    EXPECT_LT(object.visible_box.size_m.y(), 0.1F * size.x());
    if (!object.depth_missing) continue;
    EXPECT_FLOAT_EQ(size.y(), size.x());
    EXPECT_NEAR(object.box.center.z(), 1 + size.x() / 2, 1e-4);  // behind what is seen
    EXPECT_EQ(object.unseen_share, 1);
    EXPECT_EQ(object.stands_on, std::vector<int>{0});
  }
}

TEST(DescribeObjects, FlagsObjectsWhereTheDepthEnds) {
  LabelledObjects scene;
  scene.frame.depth_m.colRange(0, 20) = std::numeric_limits<float>::quiet_NaN();
  scene.Label({20, 100, 30, 30}, 1);
  scene.Label({300, 200, 28, 28}, 2);
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 2U);
  EXPECT_TRUE(scene.detections.objects[0].truncated);
  EXPECT_FALSE(scene.detections.objects[1].truncated);
}

TEST(DescribeObjects, FlagsWhatTheRegionCuts) {
  LabelledObjects scene;
  scene.Label({100, 100, 40, 40}, 1);
  scene.Label({300, 200, 30, 30}, 2);
  scene.is_cut = {0, 1};
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 2U);
  EXPECT_FALSE(scene.detections.objects[0].truncated);
  EXPECT_TRUE(scene.detections.objects[1].truncated);
}

TEST(DescribeObjects, SaliencyIsTheMeanOverTheMaskAndTheMostSalientAreKept) {
  LabelledObjects scene;
  scene.Label({100, 100, 40, 40}, 1);
  scene.Label({200, 200, 30, 30}, 2);
  scene.Label({300, 300, 20, 20}, 3);
  scene.saliency(cv::Rect(200, 200, 30, 30)).setTo(0.9F);
  scene.saliency(cv::Rect(300, 300, 20, 10)).setTo(0.7F);
  ObjectOptions options;
  options.selection.max_objects = 2;
  scene.Describe(options);
  ASSERT_EQ(scene.detections.objects.size(), 2U);
  EXPECT_NEAR(scene.detections.objects[0].saliency, 0.9F, 1e-6F);
  EXPECT_NEAR(scene.detections.objects[1].saliency, 0.6F, 1e-6F);
  EXPECT_EQ(scene.detections.diagnostics.objects_less_salient, 1U);
  EXPECT_EQ(scene.detections.labels.at<std::uint16_t>(110, 110), 0);
}

TEST(DescribeObjects, TakesConfidencesAsGiven) {
  LabelledObjects scene;
  scene.Label({100, 100, 40, 40}, 1);
  scene.Label({200, 200, 30, 30}, 2);
  scene.confidences = {0.4F, 0.9F};
  scene.Describe();
  ASSERT_EQ(scene.detections.objects.size(), 2U);
  EXPECT_EQ(scene.detections.objects[0].confidence, 0.9F);
  EXPECT_EQ(scene.detections.objects[0].bounds_px.x, 200);
  EXPECT_EQ(scene.detections.objects[1].confidence, 0.4F);
}

// Of an object whose highest row is 80 mm above the optical axis and whose lowest is 2 mm above it.
float HeightAbove(const std::vector<Support>& supports) {
  LabelledObjects scene;
  scene.Label({300, 200, 40, 40}, 1);
  const PixelPoints points(scene.frame.depth_m, scene.frame.intrinsics);
  DescribeObjects(scene.frame, points, {scene.saliency}, {scene.confidences}, supports, {},
                  scene.detections);
  return scene.detections.objects.at(0).height_above_support_m.value();
}

// So far below the camera, everywhere.
Support Level(float below_m) { return {{-Eigen::Vector3f::UnitY(), below_m, 1}, Footprint()}; }

TEST(DescribeObjects, StandsOnTheHighestSupportBelow) {
  EXPECT_NEAR(HeightAbove({Level(0.8F), Level(0.1F)}), 0.102, 1e-3);
  EXPECT_NEAR(HeightAbove({Level(0.1F), Level(0.8F)}), 0.102, 1e-3);
}

TEST(DescribeObjects, StandsOnNothingThatIsHigherThanMostOfIt) {
  EXPECT_NEAR(HeightAbove({Level(0.8F), Level(-0.5F)}), 0.802, 1e-3);
  EXPECT_NEAR(HeightAbove({Level(0.8F), Level(-0.06F)}), 0.802, 1e-3);  // a quarter is above it
  EXPECT_NEAR(HeightAbove({Level(-0.5F), Level(-0.6F)}), -0.498, 1e-3);
}

TEST(DescribeObjects, StandsOnNothingThatIsBesideIt) {
  std::vector<Eigen::Vector3f> beside;
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      const float along = 0.02F * static_cast<float>(i), away = 0.02F * static_cast<float>(j);
      beside.emplace_back(0.3F + along, 0.1F, 0.7F + away);
    }
  }
  Support table = Level(0.1F);
  table.footprint = Footprint(beside, {}, table.surface, 0.1, 0.02);
  EXPECT_NEAR(HeightAbove({Level(0.8F), table}), 0.802, 1e-3);
}

}  // namespace
}  // namespace fovea
