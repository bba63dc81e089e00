#include "core/lens/lens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace fovea {
namespace {

using ::testing::HasSubstr;
using Model = LensDistortion::Model;

const cv::Size kImageSize(640, 480);
constexpr CameraIntrinsics kCamera{610, 620, 325, 236};
const cv::Matx33d kMatrix(610, 0, 325, 0, 620, 236, 0, 0, 1);

// A webcam's, as plumb_bob; a depth camera's, as rational_polynomial; a fisheye's.
const LensDistortion kPlumbBob{Model::kBrownConrady, {-0.31, 0.12, 0.0011, -0.0007, -0.02}};
const LensDistortion kRational{Model::kBrownConrady,
                               {0.52, -2.68, 0.0005, -0.0001, 1.49, 0.40, -2.49, 1.41}};
const LensDistortion kFisheye{Model::kKannalaBrandt, {-0.012, 0.031, -0.024, 0.006}};

std::vector<cv::Point2d> PixelsSent() {
  std::vector<cv::Point2d> pixels;
  for (int y = 0; y < kImageSize.height; y += 53) {
    for (int x = 0; x < kImageSize.width; x += 71) pixels.emplace_back(x, y);
  }
  return pixels;
}

std::vector<cv::Point2d> UndistortByOpenCv(const std::vector<cv::Point2d>& sent,
                                           const LensDistortion& distortion) {
  const auto& c = distortion.coefficients;
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-9);
  std::vector<cv::Point2d> ideal;
  if (distortion.model == Model::kKannalaBrandt) {
    const cv::Vec4d k(c[0], c[1], c[2], c[3]);
    cv::fisheye::undistortPoints(sent, ideal, kMatrix, k, cv::noArray(), kMatrix);
  } else {
    cv::undistortPoints(sent, ideal, kMatrix, std::vector<double>(c.begin(), c.end()),
                        cv::noArray(), kMatrix, until);
  }
  return ideal;
}

class LensOf : public ::testing::TestWithParam<LensDistortion> {};

TEST_P(LensOf, UndistortsAsOpenCvDoes) {
  const Lens lens(kCamera, GetParam(), kImageSize);
  const std::vector<cv::Point2d> sent = PixelsSent(),
                                 expected = UndistortByOpenCv(sent, GetParam());
  double farthest = 0;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const cv::Point2d ideal = lens.Undistort(sent[i]);
    if (std::isnan(ideal.x)) continue;  // the next test says where
    EXPECT_NEAR(ideal.x, expected[i].x, 0.05) << sent[i];
    EXPECT_NEAR(ideal.y, expected[i].y, 0.05) << sent[i];
    farthest = std::max(farthest, cv::norm(ideal - sent[i]));
  }
  EXPECT_GT(farthest, 2) << "nothing was bent";
}

TEST_P(LensOf, DistortTakesBackWhatUndistortDoes) {
  const Lens lens(kCamera, GetParam(), kImageSize);
  for (int y = 0; y < kImageSize.height; y += 31) {
    for (int x = 0; x < kImageSize.width; x += 37) {
      const cv::Point2d ideal(x, y), sent = lens.Distort(ideal);
      ASSERT_TRUE(lens.IsShown(ideal));
      const cv::Point2d back = lens.Undistort(sent);
      EXPECT_NEAR(back.x, x, 0.05) << sent;
      EXPECT_NEAR(back.y, y, 0.05) << sent;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachModel, LensOf, ::testing::Values(kPlumbBob, kRational, kFisheye));

// x = 0.5, y = 0: r² = 0.25, f = 1 - 0.2 · 0.25 = 0.95, x' = 0.475 + p2 · 3 · 0.25.
TEST(Lens, BrownConradyByHand) {
  const Lens lens({100, 100, 50, 50}, {Model::kBrownConrady, {-0.2, 0, 0.01, 0.02}}, {101, 101});
  const cv::Point2d sent = lens.Distort({100, 50});
  EXPECT_NEAR(sent.x, 50 + 100 * (0.475 + 0.02 * 0.75), 1e-9);
  EXPECT_NEAR(sent.y, 50 + 100 * 0.01 * 0.25, 1e-9);
}

// x = 1: θ = π/4, x' = θ (1 + 0.1 θ²).
TEST(Lens, KannalaBrandtByHand) {
  const Lens lens({50, 50, 50, 50}, {Model::kKannalaBrandt, {0.1}}, {101, 101});
  const double angle = std::atan(1.0);
  EXPECT_NEAR(lens.Distort({100, 50}).x, 50 + 50 * angle * (1 + 0.1 * angle * angle), 1e-9);
}

std::string ErrorOf(const LensDistortion& distortion) {
  try {
    const Lens lens(kCamera, distortion, kImageSize);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Lens, RefusesCoefficientsOfNoLens) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {nan}}), HasSubstr("nan is not a finite number"));
  EXPECT_THAT(ErrorOf({Model::kKannalaBrandt, {0, 0, 0, infinite}}), HasSubstr("not a finite"));
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {0, 0, -7, 0}}), HasSubstr("tangential"));
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {-8}}), HasSubstr("send rays back or apart"));
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {0, 0, 0, 0, 0, -20}}),
              HasSubstr("send rays back or apart"));
  EXPECT_THAT(ErrorOf({Model::kKannalaBrandt, {-1e300}}), HasSubstr("send rays back or apart"));
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {1e300, -1e300}}), HasSubstr("back or apart"));
  EXPECT_EQ(ErrorOf(kPlumbBob), "none");
}

// dy'/dy = 1 + 6 p1 y along x = 0, of which the image shows y from -0.5 to 0.5: it is 0 at -0.17
// where p1 is 1, and nowhere where p1 is 0.1.
TEST(Lens, RefusesTangentialTermsThatFoldTheImage) {
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {0, 0, 1, 0}}), HasSubstr("send rays back or apart"));
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {0, 0, 0, -1}}), HasSubstr("send rays back or apart"));
  EXPECT_EQ(ErrorOf({Model::kBrownConrady, {0, 0, 0.1, 0}}), "none");
}

TEST(Lens, RefusesImagesThatAreNotUndistorted) {
  const LensDistortion slight{Model::kBrownConrady, {1e-4}};
  EXPECT_NO_THROW(Lens({5000, 5000, 100, 8}, slight, {Lens::kLongestSide_px, 16}));
  EXPECT_THROW(Lens({5000, 5000, 100, 8}, slight, {16, Lens::kLongestSide_px + 1}),
               std::invalid_argument);
}

TEST(Lens, SaysFromWhereOnRaysComeBack) {
  // 1 - 24 r² is 0.08 at 0.196, 119 px; the farthest corner is at (-325.5, 243.5).
  EXPECT_THAT(ErrorOf({Model::kBrownConrady, {-8}}),
              HasSubstr("from 120 px beside the optical axis on, where the image reaches to 404"));
}

// At k1 = -0.9 the radius falls again beyond 1 / sqrt(2.7) = 0.61, and grows by less than 0.08 of
// what it should from sqrt(0.92 / 2.7) = 0.584 on, where it is 0.405; the corners are at 0.66.
TEST(Lens, ShowsNothingBeyondWhereRaysComeBack) {
  const Lens lens(kCamera, {Model::kBrownConrady, {-0.9}}, kImageSize);
  const auto at = [](double radius) { return cv::Point2d(325 - 610 * radius, 236); };
  EXPECT_TRUE(lens.IsShown({325, 0}));
  EXPECT_TRUE(lens.IsShown(at(0.58)));
  EXPECT_FALSE(lens.IsShown(at(0.59)));
  EXPECT_FALSE(lens.IsShown({0, 0}));
  EXPECT_NEAR(cv::norm(lens.Distort(at(1)) - at(0.4047)), 0, 0.5) << "the last place before";
  EXPECT_TRUE(std::isnan(lens.Undistort({0, 0}).x));
  for (const cv::Point2d& sent : PixelsSent()) {
    for (const double radius : {0.0, 0.5, 0.9, 1.1}) {
      const cv::Point2d ideal = lens.Undistort(sent, at(radius));
      EXPECT_TRUE(std::isnan(ideal.x) || lens.IsShown(ideal)) << sent << ' ' << radius;
    }
  }
}

// At k4 = -3 the radius is r / (1 - 3 r²), which grows twelve times as fast as it should where
// 1 + 3 r² = 12 (1 - 3 r²)²: at r² = 0.2105, r = 0.4588.
TEST(Lens, ShowsNothingBeyondWhereRaysPart) {
  const Lens lens(kCamera, {Model::kBrownConrady, {0, 0, 0, 0, 0, -3}}, kImageSize);
  EXPECT_TRUE(lens.IsShown({325 - 610 * 0.455, 236}));
  EXPECT_FALSE(lens.IsShown({325 - 610 * 0.463, 236}));
}

// Its corners are 82 degrees beside the axis, where a pinhole camera's pixel sees fifty times less.
TEST(Lens, AFisheyeShowsWhatIsFarBeside) {
  const Lens lens({20, 20, 100, 100}, {Model::kKannalaBrandt, {}}, {201, 201});
  EXPECT_TRUE(lens.IsShown({0, 0}));
}

TEST(Lens, TheAxisIsNotBent) {
  const Lens lens(kCamera, kPlumbBob, kImageSize);
  EXPECT_EQ(lens.Distort({325, 236}), cv::Point2d(325, 236));
  EXPECT_EQ(lens.Undistort({325, 236}), cv::Point2d(325, 236));
}

}  // namespace
}  // namespace fovea
