#include "core/saliency/depth_saliency.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace fovea {
namespace {

TEST(DepthSaliency, IsZeroOnConstantDepth) {
  const cv::Mat depth(30, 40, CV_32F, cv::Scalar(1.5));
  EXPECT_LT(cv::norm(DepthSaliency(depth), cv::NORM_INF), 1e-6);
}

}  // namespace
}  // namespace fovea
