#include "client/cli/overlay/extras.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/overlay/drawing.h"
#include "client/cli/overlay/palette.h"
#include "client/cli/overlay/solid_lines.h"

namespace fovea::cli {

cv::Mat WarmedBySaliency(const cv::Mat& color, const v1::Detections& detections) {
  cv::Mat most = cv::Mat::zeros(color.size(), CV_8UC1), heat, warmed;
  for (const v1::SaliencyMap& map : detections.saliency_maps()) {
    const cv::Size size(static_cast<int>(map.width()), static_cast<int>(map.height()));
    if (size != color.size() || map.data().size() != color.total()) {
      throw std::runtime_error("the server's answer has a broken saliency map");
    }
    cv::max(most, cv::Mat(size, CV_8UC1, const_cast<char*>(map.data().data())), most);
  }
  cv::applyColorMap(most, heat, cv::COLORMAP_INFERNO);
  cv::addWeighted(color, 0.4, heat, 0.6, 0, warmed);
  return warmed;
}

void DrawPlace(cv::Mat& picture, const v1::FreePlace& place, const View& view) {
  const Block block = BlockOf(place.box());
  std::vector<cv::Point> floor;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const auto pixel = view.Project(block.center + x * block.half_axes[0] + y * block.half_axes[1] -
                                    block.half_axes[2]);
    if (!pixel) return;
    floor.emplace_back(*pixel);
  }
  FillPolygon(picture, floor, kWhite, 0.25);
  for (const SpaceLine& edge : EdgesOf(block)) {
    const auto ends = view.Project(edge);
    if (ends) DrawDashes(picture, ends->first, ends->second, kWhite);
  }
}

void DrawCollisions(cv::Mat& picture, const v1::Detections& detections, const View& view) {
  const auto draw = [&](const v1::CollisionPrimitive& primitive) {
    for (const SpaceLine& line : LinesOf(primitive)) {
      const auto ends = view.Project(line);
      if (ends) DrawThinLine(picture, ends->first, ends->second, kBlue, line.hidden ? 0.35 : 1);
    }
  };
  for (const auto& support : detections.support_collisions()) draw(support);
  for (const v1::Object& object : detections.objects()) {
    if (object.has_collision()) draw(object.collision());
  }
}

void DrawSeeds(cv::Mat& picture, const v1::Detections& detections, const View& view) {
  for (const v1::Seed& seed : detections.seeds()) {
    DrawCross(picture, view.At(seed.x(), seed.y()), 6, kRed);
  }
}

void DrawRejected(cv::Mat& picture, const v1::Detections& detections, const View& view) {
  for (int i = detections.rejected_size() - 1; i >= 0; --i) {  // the likeliest on top
    const v1::RejectedObject& rejected = detections.rejected(i);
    const v1::BoundingBox2D& bounds = rejected.bounding_box();
    const cv::Rect frame_box =
        cv::Rect(static_cast<int>(bounds.x()), static_cast<int>(bounds.y()),
                 static_cast<int>(bounds.width()), static_cast<int>(bounds.height())) &
        cv::Rect({}, view.frame);
    const cv::Rect box(frame_box.tl() * view.scale, frame_box.size() * view.scale);
    const cv::Scalar tint = kYellow * (0.35 + 0.65 * std::clamp(rejected.probability(), 0.0, 1.0));
    cv::rectangle(picture, box, tint, 1);
    if (rejected.probability() < 0.01) continue;
    DrawBadge(picture, box.tl(), {std::to_string(cvRound(100 * rejected.probability())) + " %"},
              tint);
  }
}

}  // namespace fovea::cli
