#include "client/cli/drawing.h"

#include <opencv2/imgproc.hpp>

#include "client/cli/palette.h"

namespace fovea::cli {
namespace {

const cv::Scalar kRim(20, 20, 20);
constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
constexpr double kFontScale = 0.6;
constexpr int kPadding = 5;

// Coordinates in 1/16 pixel, for lines that do not jump by whole pixels.
constexpr int kShift = 4;
cv::Point Fine(const cv::Point2d& point) {
  constexpr double kFactor = 1 << kShift;
  return {cvRound(point.x * kFactor), cvRound(point.y * kFactor)};
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

void Tint(cv::Mat& image, const cv::Mat& mask, const cv::Scalar& color, double opacity) {
  const cv::Mat paint(image.size(), image.type(), color);
  cv::Mat blended;
  cv::addWeighted(image, 1 - opacity, paint, opacity, 0, blended);
  blended.copyTo(image, mask);
}

cv::Size BadgeSize(const std::string& text) {
  int baseline = 0;
  const cv::Size size = cv::getTextSize(text, kFont, kFontScale, 1, &baseline);
  return {size.width + 2 * kPadding, size.height + 2 * kPadding};
}

void DrawBadge(cv::Mat& image, const cv::Point& corner, const std::string& text,
               const cv::Scalar& background) {
  const cv::Rect box(corner, BadgeSize(text));
  cv::rectangle(image, box, background, cv::FILLED);
  cv::rectangle(image, box, kRim, 1);
  const cv::Point baseline(corner.x + kPadding, corner.y + box.height - kPadding);
  cv::putText(image, text, baseline, kFont, kFontScale, TextColorOn(background), 1, cv::LINE_AA);
}

}  // namespace fovea::cli
