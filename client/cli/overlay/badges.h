// Labels of things in a picture.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "client/cli/overlay/view.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// Keeps them apart from each other and inside of the picture.
class Badges {
 public:
  explicit Badges(const cv::Size& picture) : picture_(picture) {}

  // The first of the lines is written larger. `corner`: where the upper left one would best be.
  void Add(const cv::Point& corner, std::vector<std::string> lines, const cv::Scalar& background);
  void Draw(cv::Mat& picture) const;

 private:
  struct Badge {
    cv::Rect box;
    std::vector<std::string> lines;
    cv::Scalar background;
  };

  cv::Rect Place(cv::Rect box) const;

  const cv::Size picture_;
  std::vector<Badge> badges_;
};

// Its number and confidence, what must be moved before it, and why it has no grasp.
void AddBadge(const v1::Object& object, const View& view, Badges& badges);

}  // namespace fovea::cli
