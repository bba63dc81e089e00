#include "client/cli/height_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "client/cli/geometry.h"
#include "client/cli/overlay/drawing.h"
#include "client/cli/overlay/palette.h"

namespace fovea::cli {
namespace {

constexpr int kHeightColors = cv::COLORMAP_VIRIDIS;  // has no grey

// CV_32FC1, NaN = unknown, the farthest row first.
cv::Mat HeightsOf(const v1::HeightMap& map) {
  const std::uint64_t cells = std::uint64_t{map.width()} * map.height();
  if (map.data().size() / sizeof(float) != cells || map.data().size() % sizeof(float) != 0) {
    throw std::runtime_error("the server's answer has a broken height map");
  }
  if (cells == 0) return {};
  const cv::Mat rows(static_cast<int>(map.height()), static_cast<int>(map.width()), CV_32FC1,
                     const_cast<char*>(map.data().data()));
  cv::Mat heights;
  cv::flip(rows, heights, 0);
  return heights;
}

cv::Mat Hatched(const cv::Size& size) {
  constexpr int kEvery_px = 8, kLine_px = 2;
  cv::Mat picture(size, CV_8UC3, cv::Scalar::all(110));
  for (int row = 0; row < size.height; ++row) {
    for (int col = 0; col < size.width; ++col) {
      if ((row + col) % kEvery_px < kLine_px) picture.at<cv::Vec3b>(row, col) = {150, 150, 150};
    }
  }
  return picture;
}

struct Span {
  bool is_known = false;
  double low = 0, high = 0;
};

Span SpanOf(const cv::Mat& heights) {
  Span span;
  const cv::Mat known = heights == heights;  // NaN is not
  span.is_known = cv::countNonZero(known) > 0;
  if (span.is_known) cv::minMaxLoc(heights, &span.low, &span.high, nullptr, nullptr, known);
  return span;
}

// `scale`: pixels of a cell.
cv::Mat Painted(const cv::Mat& heights, const Span& span, int scale) {
  const double steps = 255 / std::max(span.high - span.low, 1e-6);
  const cv::Mat known = heights == heights;
  cv::Mat bytes, colors, is_known;
  heights.convertTo(bytes, CV_8U, steps, -steps * span.low);
  cv::applyColorMap(bytes, colors, kHeightColors);
  cv::resize(colors, colors, {}, scale, scale, cv::INTER_NEAREST);
  cv::resize(known, is_known, {}, scale, scale, cv::INTER_NEAREST);
  cv::Mat picture = Hatched(colors.size());
  colors.copyTo(picture, is_known);
  return picture;
}

void DrawNumbers(const v1::Detections& detections, int scale, cv::Mat* picture) {
  const v1::HeightMap& map = detections.height_map();
  const cv::Matx33d to_map = RotationOf(map.pose().orientation()).t();
  for (const v1::Object& object : detections.objects()) {
    const cv::Vec3d place =
        to_map * (ToVec(object.oriented_box().pose().position()) - ToVec(map.pose().position()));
    const cv::Point2d cell(place[0] / map.cell_m(), map.height() - 1 - place[1] / map.cell_m());
    const cv::Point2d middle = (cell + cv::Point2d(0.5, 0.5)) * scale;
    if (!cv::Rect2d({}, cv::Size2d(picture->size())).contains(middle)) continue;
    const v1::Vector3& size = object.oriented_box().size();
    const double beside = std::hypot(size.x(), size.y()) / 2 / map.cell_m() * scale;
    const std::string number = std::to_string(object.label());
    DrawBadge(*picture, middle + cv::Point2d(beside, -BadgeSize({number}).height / 2.0), {number},
              ColorOf(object.label()));
  }
}

void AddLegend(const v1::HeightMap& map, const Span& span, cv::Mat* picture) {
  constexpr int kLeast_px = 480, kHigh_px = 64, kEdge_px = 8, kBar_px = 14;
  const int right = std::max(0, kLeast_px - picture->cols);
  cv::copyMakeBorder(*picture, *picture, 0, kHigh_px, 0, right, cv::BORDER_CONSTANT);
  const int top = picture->rows - kHigh_px + kEdge_px;
  cv::Mat ramp(1, 256, CV_8U), bar;
  for (int i = 0; i < 256; ++i) ramp.at<std::uint8_t>(i) = static_cast<std::uint8_t>(i);
  cv::applyColorMap(ramp, bar, kHeightColors);
  cv::resize(bar, bar, {256, kBar_px});
  bar.copyTo((*picture)(cv::Rect({kEdge_px, top}, bar.size())));
  const cv::Rect unknown(2 * kEdge_px + bar.cols, top, kBar_px * 2, kBar_px);
  Hatched(unknown.size()).copyTo((*picture)(unknown));
  const auto write = [&](const cv::Point& at, const std::string& text) {
    cv::putText(*picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, kWhite, 1, cv::LINE_AA);
  };
  write({unknown.br().x + kEdge_px, unknown.br().y - 3}, "unknown");
  const std::string range = span.is_known ? fmt::format("{:.3f} to {:.3f} m, cells of {:g} m",
                                                        span.low, span.high, map.cell_m())
                                          : "nothing was seen";
  write({kEdge_px, top + kBar_px + 16}, range);
  write({kEdge_px, top + kBar_px + 34}, "from above, the way that the camera looks is up");
}

}  // namespace

cv::Mat HeightPicture(const v1::Detections& detections) {
  constexpr int kLongest_px = 960, kLargestCell_px = 40;
  cv::Mat heights = HeightsOf(detections.height_map());
  // Of what was not looked at in time there is none.
  if (heights.empty()) heights = cv::Mat(1, 1, CV_32FC1, cv::Scalar(std::nan("")));
  const int scale =
      std::clamp(kLongest_px / std::max(heights.cols, heights.rows), 1, kLargestCell_px);
  const Span span = SpanOf(heights);
  cv::Mat picture = Painted(heights, span, scale);
  DrawNumbers(detections, scale, &picture);
  AddLegend(detections.height_map(), span, &picture);
  return picture;
}

}  // namespace fovea::cli
