#include "client/cli/height_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace fovea::cli {
namespace {

constexpr int kCell_px = 40;  // of the smallest maps

// Two by two cells of 0.1 m, the nearer row first; level below the camera, as it looks along z.
v1::Detections WithMap(const std::vector<float>& heights) {
  v1::Detections detections;
  v1::HeightMap& map = *detections.mutable_height_map();
  v1::Quaternion& turn = *map.mutable_pose()->mutable_orientation();
  turn.set_x(std::sqrt(0.5));
  turn.set_w(std::sqrt(0.5));
  map.mutable_pose()->mutable_position()->set_z(1);
  map.set_cell_m(0.1);
  map.set_width(2);
  map.set_height(2);
  map.set_data(heights.data(), heights.size() * sizeof(float));
  return detections;
}

// The middle of a cell, by row and column of the picture.
cv::Vec3b At(const cv::Mat& picture, int row, int col) {
  return picture.at<cv::Vec3b>(row * kCell_px + kCell_px / 2, col * kCell_px + kCell_px / 2);
}

bool IsGrey(const cv::Vec3b& pixel) { return pixel[0] == pixel[1] && pixel[1] == pixel[2]; }

int Brightness(const cv::Vec3b& pixel) { return pixel[0] + pixel[1] + pixel[2]; }

TEST(HeightPicture, ShowsWhatIsHighFarAndUnknown) {
  const cv::Mat picture = HeightPicture(WithMap({0, 0.1F, 0.2F, NAN}));
  EXPECT_GT(picture.rows, 2 * kCell_px) << "no legend";
  EXPECT_TRUE(IsGrey(At(picture, 0, 1)));
  for (const auto& [row, col] : {std::pair{0, 0}, {1, 0}, {1, 1}}) {
    EXPECT_FALSE(IsGrey(At(picture, row, col))) << row << ' ' << col;
  }
  EXPECT_GT(Brightness(At(picture, 0, 0)), Brightness(At(picture, 1, 1)));
  EXPECT_GT(Brightness(At(picture, 1, 1)), Brightness(At(picture, 1, 0)));
}

TEST(HeightPicture, NumbersObjectsWhereTheyAre) {
  v1::Detections detections = WithMap({0, 0, 0, 0});
  const cv::Mat without = HeightPicture(detections);
  v1::Object& object = *detections.add_objects();
  object.set_label(1);
  object.mutable_oriented_box()->mutable_pose()->mutable_position()->set_z(1.1);  // the far row
  const cv::Mat with = HeightPicture(detections);
  const cv::Rect far_row(0, 0, 2 * kCell_px, kCell_px);
  EXPECT_GT(cv::norm(with(far_row), without(far_row)), 0);
  const cv::Rect near_row(0, kCell_px, 2 * kCell_px, kCell_px);
  EXPECT_EQ(cv::norm(with(near_row), without(near_row)), 0);
}

TEST(HeightPicture, IsUnknownWhereTheAnswerHasNoMap) {
  EXPECT_TRUE(IsGrey(At(HeightPicture({}), 0, 0)));
}

TEST(HeightPicture, RefusesDataOfAnotherSize) {
  EXPECT_THROW(HeightPicture(WithMap({0, 0, 0})), std::runtime_error);
  EXPECT_THROW(HeightPicture(WithMap({0, 0, 0, 0, 0})), std::runtime_error);
}

}  // namespace
}  // namespace fovea::cli
