#include "core/relations/free_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/relations/support_grid.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Cosine and sine of 0, 45, 90 and 135 degrees.
constexpr float kHalf = 0.70710678F;
constexpr std::array<std::pair<float, float>, 4> kDirections = {
    {{1, 0}, {kHalf, kHalf}, {0, 1}, {-kHalf, kHalf}}};

// How many cells cover a length.
int Cells(float length_m, float cell_m) {
  return std::max(1, static_cast<int>(std::ceil(length_m / cell_m)));
}

// Turns the grid about its middle cell so that `direction` runs along the columns; larger, so that
// nothing is lost. Two rows and three columns, as cv::warpAffine takes it.
cv::Matx23f Turn(const std::pair<float, float>& direction, const cv::Size& size, int side) {
  const auto [c, s] = direction;
  // Whole cells: right angles move cells to cells.
  const cv::Point2f middle(cv::Point(size) / 2), target(cv::Point(side, side) / 2);
  return {c,  s, target.x - c * middle.x - s * middle.y,
          -s, c, target.y + s * middle.x - c * middle.y};
}

// Free where all cells around are: the nearest ones alone would pass by every sixth cell.
cv::Mat Turned(const cv::Mat& free, const cv::Matx23f& turn, int side) {
  cv::Mat turned;
  cv::warpAffine(free, turned, turn, {side, side}, cv::INTER_LINEAR, cv::BORDER_CONSTANT,
                 cv::Scalar(0));
  return turned == 255;
}

struct Best {
  float room_cells = 0;  // to the nearest cell that is not free
  cv::Point2f cell;      // of the grid
  std::size_t direction = 0;
};

// The middle with the most room around a rectangle that is free as a whole.
Best MostRoom(const cv::Mat& free, const cv::Size2f& rectangle) {
  const int side = static_cast<int>(std::hypot(free.cols, free.rows)) + 3;
  Best best;
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    InterruptionPoint();
    const cv::Matx23f turn = Turn(kDirections[i], free.size(), side);
    cv::Mat fits, room;
    const cv::Size kernel(static_cast<int>(rectangle.width) | 1,
                          static_cast<int>(rectangle.height) | 1);
    if (kernel.width > side || kernel.height > side) continue;
    cv::erode(Turned(free, turn, side), fits, cv::Mat::ones(kernel, CV_8UC1), {-1, -1}, 1,
              cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::distanceTransform(fits, room, cv::DIST_L2, cv::DIST_MASK_5);
    double most = 0;
    cv::Point at;
    cv::minMaxLoc(room, nullptr, &most, nullptr, &at);
    if (most <= best.room_cells) continue;
    const cv::Point2f offset = cv::Point2f(at) - cv::Point2f(turn(0, 2), turn(1, 2));
    const auto [c, s] = kDirections[i];
    best = {
        static_cast<float>(most), {c * offset.x - s * offset.y, s * offset.x + c * offset.y}, i};
  }
  return best;
}

FreePlace PlaceAt(const SupportGrid& grid, const SupportSurface& surface, const Best& best,
                  const PlaceOptions& options) {
  const auto [c, s] = kDirections[best.direction];
  FreePlace place;
  OrientedBox& box = place.box;
  box.size_m = options.size_m;
  box.center = grid.PointAt(best.cell) + surface.normal * (options.size_m.z() / 2);
  box.rotation.col(0) = (grid.axes().transpose() * Eigen::Vector2f(c, s)).normalized();
  box.rotation.col(2) = surface.normal;
  box.rotation.col(1) = box.rotation.col(2).cross(box.rotation.col(0));
  place.clearance_m = options.margin_m + (best.room_cells - 1) * grid.cell_m();
  return place;
}

// What a place takes of the grid is free no more.
void Take(const Best& best, const cv::Size2f& rectangle, cv::Mat& free) {
  const auto [c, s] = kDirections[best.direction];
  std::vector<cv::Point> corners;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const float x = static_cast<float>(a) * rectangle.width / 2,
                y = static_cast<float>(b) * rectangle.height / 2;
    corners.emplace_back(cvRound(best.cell.x + c * x - s * y),
                         cvRound(best.cell.y + s * x + c * y));
  }
  cv::fillConvexPoly(free, corners, cv::Scalar(0));
}

}  // namespace

std::vector<FreePlace> FindFreePlaces(const ViewedScene& scene,
                                      const std::vector<Support>& supports,
                                      const std::vector<DetectedObject>& objects,
                                      const PlaceOptions& options,
                                      const SupportOptions& support_options) {
  std::vector<FreePlace> places;
  const float around = 2 * options.margin_m;
  for (const Support& support : supports) {
    const SupportGrid grid(scene, support, objects, options.size_m.z() + options.margin_m,
                           support_options);
    cv::Mat free = grid.free().clone();
    const cv::Size2f rectangle(
        static_cast<float>(Cells(options.size_m.x() + around, grid.cell_m())),
        static_cast<float>(Cells(options.size_m.y() + around, grid.cell_m())));
    for (int i = 0; i < options.max_places; ++i) {
      const Best best = MostRoom(free, rectangle);
      if (best.room_cells <= 0) break;
      places.push_back(PlaceAt(grid, support.surface, best, options));
      Take(best, rectangle, free);
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const FreePlace& a, const FreePlace& b) {
    return a.clearance_m > b.clearance_m;
  });
  if (places.size() > static_cast<std::size_t>(options.max_places)) {
    places.resize(static_cast<std::size_t>(options.max_places));
  }
  return places;
}

}  // namespace fovea
