// Shapes that stay legible on any photograph: each on a dark rim.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace fovea::cli {

void DrawLine(cv::Mat& image, const cv::Point2d& from, const cv::Point2d& to,
              const cv::Scalar& color, int thickness);

// An upright plus.
void DrawCross(cv::Mat& image, const cv::Point2d& center, int radius, const cv::Scalar& color);

void DrawContours(cv::Mat& image, const std::vector<std::vector<cv::Point>>& contours,
                  const cv::Scalar& color);

// Fills the pixels of `mask` (CV_8UC1, image size) with `color` at the given opacity.
void Tint(cv::Mat& image, const cv::Mat& mask, const cv::Scalar& color, double opacity);

// The size of a badge with this text.
cv::Size BadgeSize(const std::string& text);

// Text on a filled background, its top left corner at `corner`.
void DrawBadge(cv::Mat& image, const cv::Point& corner, const std::string& text,
               const cv::Scalar& background);

}  // namespace fovea::cli
