#include "core/types/squares.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace fovea {
namespace {

cv::Mat RandomImage(const cv::Size& size, int type, int most) {
  cv::Mat image(size, type);
  cv::RNG random(size.width + 100 * size.height);
  random.fill(image, cv::RNG::UNIFORM, 0, most);
  return image;
}

bool AreEqual(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::countNonZero(a != b) == 0;
}

// Also of images smaller than the square, and of parts of an image.
TEST(Squares, AreThoseOfOpenCv) {
  for (const int type : {CV_8UC1, CV_16UC1}) {
    for (const cv::Size& size :
         {cv::Size(1, 1), cv::Size(2, 7), cv::Size(70, 3), cv::Size(131, 90)}) {
      const cv::Mat whole = RandomImage(size, type, 250);
      for (const int reach : {0, 1, 2, 3}) {
        const cv::Mat square = cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8UC1);
        for (const cv::Rect& part : {cv::Rect({}, size), cv::Rect(0, 0, size.width, 1)}) {
          const cv::Mat image = whole(part).clone();
          cv::Mat expected, largest = image.clone(), least = image.clone(), closed = image.clone();
          TakeLargestAround(reach, largest);
          cv::dilate(image, expected, square);
          EXPECT_TRUE(AreEqual(largest, expected)) << size << " " << reach;
          TakeLeastAround(reach, least);
          cv::erode(image, expected, square);
          EXPECT_TRUE(AreEqual(least, expected)) << size << " " << reach;
          CloseGaps(reach, closed);
          cv::morphologyEx(image, expected, cv::MORPH_CLOSE, square);
          EXPECT_TRUE(AreEqual(closed, expected)) << size << " " << reach;
        }
      }
    }
  }
}

TEST(Squares, LeaveAloneWhatIsAroundAPartOfAnImage) {
  cv::Mat image = cv::Mat::zeros(5, 5, CV_8UC1);
  image.at<std::uint8_t>(2, 2) = 9;
  cv::Mat part = image(cv::Rect(2, 1, 2, 3));
  TakeLargestAround(2, part);
  EXPECT_EQ(cv::countNonZero(image == 9), 6);
}

}  // namespace
}  // namespace fovea
