#include "client/cli/overlay/drawing.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "client/cli/overlay/palette.h"

namespace fovea::cli {
namespace {

const cv::Scalar kRim(20, 20, 20);
constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
constexpr double kLarge = 0.6, kSmall = 0.45;  // font scales
constexpr int kPadding = 5;

// Coordinates in 1/16 pixel, for lines that do not jump by whole pixels.
constexpr int kShift = 4;
cv::Point Fine(const cv::Point2d& point) {
  constexpr double kFactor = 1 << kShift;
  return {cvRound(point.x * kFactor), cvRound(point.y * kFactor)};
}

// What a thin line between both touches of the image.
cv::Rect AreaOf(const std::pair<cv::Point2d, cv::Point2d>& ends, const cv::Mat& image) {
  const auto& [a, b] = ends;
  const cv::Point low(cvFloor(std::min(a.x, b.x)) - 1, cvFloor(std::min(a.y, b.y)) - 1);
  const cv::Point high(cvCeil(std::max(a.x, b.x)) + 2, cvCeil(std::max(a.y, b.y)) + 2);
  return cv::Rect(low, high) & cv::Rect({}, image.size());
}

double ScaleOf(const std::string& line, const std::vector<std::string>& lines) {
  return &line == lines.data() ? kLarge : kSmall;
}

cv::Size TextSize(const std::string& text, double scale) {
  int baseline = 0;
  return cv::getTextSize(text, kFont, scale, 1, &baseline);
}

}  // namespace

void DrawLine(cv::Mat& image, const cv::Point2d& from, const cv::Point2d& to,
              const cv::Scalar& color, int thickness) {
  cv::line(image, Fine(from), Fine(to), kRim, thickness + 2, cv::LINE_AA, kShift);
  cv::line(image, Fine(from), Fine(to), color, thickness, cv::LINE_AA, kShift);
}

void DrawCross(cv::Mat& image, const cv::Point2d& center, int radius, const cv::Scalar& color) {
  const cv::Point2d right(radius, 0), down(0, radius);
  for (const auto& [paint, thickness] : {std::pair{kRim, 4}, std::pair{color, 2}}) {
    cv::line(image, Fine(center - right), Fine(center + right), paint, thickness, cv::LINE_AA,
             kShift);
    cv::line(image, Fine(center - down), Fine(center + down), paint, thickness, cv::LINE_AA,
             kShift);
  }
}

void DrawContours(cv::Mat& image, const std::vector<std::vector<cv::Point>>& contours,
                  const cv::Scalar& color) {
  cv::drawContours(image, contours, -1, kRim, 4, cv::LINE_AA);
  cv::drawContours(image, contours, -1, color, 2, cv::LINE_AA);
}

void DrawThinLine(cv::Mat& image, const cv::Point2d& from, const cv::Point2d& to,
                  const cv::Scalar& color, double opacity) {
  if (opacity >= 1) {
    cv::line(image, Fine(from), Fine(to), color, 1, cv::LINE_AA, kShift);
    return;
  }
  const cv::Rect area = AreaOf({from, to}, image);
  if (area.empty()) return;
  const cv::Point2d corner(area.tl());
  cv::Mat drawn = image(area).clone();
  cv::line(drawn, Fine(from - corner), Fine(to - corner), color, 1, cv::LINE_AA, kShift);
  cv::addWeighted(drawn, opacity, image(area), 1 - opacity, 0, image(area));
}

void DrawDashes(cv::Mat& image, const cv::Point2d& from, const cv::Point2d& to,
                const cv::Scalar& color) {
  constexpr double kDash_px = 6, kMostDashes = 200;
  const int count =
      static_cast<int>(std::clamp(cv::norm(to - from) / (2 * kDash_px), 1.0, kMostDashes));
  for (int i = 0; i < count; ++i) {
    const cv::Point2d start = from + (to - from) * ((i + 0.25) / count);
    DrawThinLine(image, start, start + (to - from) * (0.5 / count), color, 1);
  }
}

void FillPolygon(cv::Mat& image, const std::vector<cv::Point>& polygon, const cv::Scalar& color,
                 double opacity) {
  const cv::Rect area = cv::boundingRect(polygon) & cv::Rect({}, image.size());
  if (area.empty()) return;
  std::vector<cv::Point> moved;
  for (const cv::Point& corner : polygon) moved.push_back(corner - area.tl());
  cv::Mat filled = image(area).clone();
  cv::fillConvexPoly(filled, moved, color, cv::LINE_AA);
  cv::addWeighted(filled, opacity, image(area), 1 - opacity, 0, image(area));
}

cv::Size BadgeSize(const std::vector<std::string>& lines) {
  cv::Size size(0, kPadding);
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    const cv::Size text = TextSize(line, ScaleOf(line, lines));
    size.width = std::max(size.width, text.width + 2 * kPadding);
    size.height += text.height + kPadding;
  }
  return size;
}

void DrawBadge(cv::Mat& image, const cv::Point& corner, const std::vector<std::string>& lines,
               const cv::Scalar& background) {
  const cv::Rect box(corner, BadgeSize(lines));
  cv::rectangle(image, box, background, cv::FILLED);
  cv::rectangle(image, box, kRim, 1);
  int y = corner.y + kPadding;
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    const double scale = ScaleOf(line, lines);
    y += TextSize(line, scale).height;
    cv::putText(image, line, {corner.x + kPadding, y}, kFont, scale, TextColorOn(background), 1,
                cv::LINE_AA);
    y += kPadding;
  }
}

}  // namespace fovea::cli
