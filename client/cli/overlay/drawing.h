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

// Without a rim, one pixel wide; opacity 0 … 1.
void DrawThinLine(cv::Mat& image, const cv::Point2d& from, const cv::Point2d& to,
                  const cv::Scalar& color, double opacity);

void DrawDashes(cv::Mat& image, const cv::Point2d& from, const cv::Point2d& to,
                const cv::Scalar& color);

// Of a convex polygon. Opacity 0 … 1.
void FillPolygon(cv::Mat& image, const std::vector<cv::Point>& polygon, const cv::Scalar& color,
                 double opacity);

// The size of a badge with these lines of text, of which the first is written larger.
cv::Size BadgeSize(const std::vector<std::string>& lines);

// Text on a filled background, its top left corner at `corner`. Empty lines take no room.
void DrawBadge(cv::Mat& image, const cv::Point& corner, const std::vector<std::string>& lines,
               const cv::Scalar& background);

}  // namespace fovea::cli
