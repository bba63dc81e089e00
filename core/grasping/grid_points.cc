#include "core/grasping/grid_points.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/grasping/placed_points.h"
#include "core/grasping/sight.h"
#include "core/types/interruption.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

constexpr float kRoomAbove_m = 0.2F;  // the hand and the arm behind it, above the object

// The part of the image in which the grid's columns are seen.
cv::Rect SeenPart(const GraspScene& scene, float half_height_m, const HandGrid& grid) {
  const cv::Rect image({}, scene.points.size());
  cv::Rect2d part;
  for (const float z : {-half_height_m, half_height_m + kRoomAbove_m}) {
    for (const float y : {-grid.Half(), grid.Half()}) {
      for (const float x : {-grid.Half(), grid.Half()}) {
        const Eigen::Vector3f corner = grid.frame.ToCamera({x, y, z});
        if (corner.z() < 0.05F) return image;
        const cv::Rect2d pixel(Project(corner, scene.intrinsics), cv::Size2d(1, 1));
        part = part.empty() ? pixel : part | pixel;
      }
    }
  }
  part &= cv::Rect2d(image);
  return image & cv::Rect(cvFloor(part.x), cvFloor(part.y), cvCeil(part.width) + 1,
                          cvCeil(part.height) + 1);
}

// The two highest.
struct TwoHighest {
  float first = HandGrid::kNothing, second = HandGrid::kNothing;

  void Add(float height) {
    second = std::max(second, std::min(first, height));
    first = std::max(first, height);
  }
};

// Points of the object that may lie well outside of its solid: parts that it does not have.
class BesideSolid {
 public:
  explicit BesideSolid(const CompletedSolid& solid) : solid_(solid) {}

  void Ask(const Eigen::Vector3f& point, std::size_t cell, float noise_m) {
    const Eigen::Vector3f from = point - solid_.Center();
    lines_.Add(solid_.Center(), from.normalized());
    asked_.push_back({cell, point.z(), from.norm(), 0.01F + 2 * noise_m});
  }

  // Adds those that do; then none is asked for any more.
  void AddTo(std::vector<TwoHighest>& cells) {
    solid_.Along(lines_, spans_);
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const Asked& asked = asked_[i];
      const Span& span = spans_[i];
      if (span.IsEmpty() || asked.distance_m - span.high > asked.tolerance_m) {
        cells[asked.cell].Add(asked.height_m);
      }
    }
    lines_.Clear();
    asked_.clear();
  }

 private:
  struct Asked {
    std::size_t cell;
    float height_m, distance_m, tolerance_m;
  };

  const CompletedSolid& solid_;
  Lines lines_;
  std::vector<Asked> asked_;
  std::vector<Span> spans_;
};

class PointCollector {
 public:
  PointCollector(const GraspScene& scene, const DetectedObject& object, const CompletedSolid& solid,
                 HandGrid& grid)
      : scene_(scene),
        object_(object),
        solid_(solid),
        grid_(grid),
        is_whole_(solid.IsKnown() && object.shape.kind == Shape::Kind::kBox),
        beside_(solid),
        of_target_(grid.columns.size()),
        of_others_(grid.columns.size()) {}

  // `columns`: those of the image, every `step`th.
  void AddRow(int row, const cv::Range& columns, int step) {
    PlacedPoints some;
    for (int first = columns.start; first < columns.end; first += PlacedPoints::kNum * step) {
      const int num = std::min(PlacedPoints::kNum, (columns.end - first + step - 1) / step);
      Load(row, first, step, num, some);
      PlaceIn(grid_, some);
      for (int i = 0; i < num; ++i) {
        if (some.cell[i] >= 0) Add(some, i, row, first + i * step);
      }
    }
    beside_.AddTo(of_target_);
  }

  void SetColumns() const {
    for (std::size_t i = 0; i < grid_.columns.size(); ++i) {
      grid_.columns[i] = {of_target_[i].second, of_others_[i].second};
    }
  }

 private:
  // The last fills up what is left.
  void Load(int row, int first, int step, int num, PlacedPoints& some) const {
    const auto* points = scene_.points.ptr<Eigen::Vector3f>(row);
    const auto* labels = scene_.labels.ptr<std::uint16_t>(row);
    for (int i = 0; i < PlacedPoints::kNum; ++i) {
      const int column = first + std::min(i, num - 1) * step;
      some.x[i] = points[column].x(), some.y[i] = points[column].y(),
      some.z[i] = points[column].z();
      some.label[i] = labels[column];
    }
  }

  void Add(const PlacedPoints& some, int i, int row, int column) {
    const auto cell = static_cast<std::size_t>(some.cell[i]);
    if (some.label[i] == object_.label) {
      if (is_whole_) return;
      if (!solid_.IsKnown()) return of_target_[cell].Add(some.z[i]);
      return beside_.Ask({some.x[i], some.y[i], some.z[i]}, cell, some.noise_m[i]);
    }
    if (some.label[i] == 0 && IsAtMask(scene_, row, column, object_.label)) return;
    of_others_[cell].Add(some.z[i]);
  }

  const GraspScene& scene_;
  const DetectedObject& object_;
  const CompletedSolid& solid_;
  HandGrid& grid_;
  bool is_whole_;  // a box: all of its points are of it
  BesideSolid beside_;
  std::vector<TwoHighest> of_target_, of_others_;  // for each cell
};

}  // namespace

void AddPoints(const GraspScene& scene, const DetectedObject& object, const CompletedSolid& solid,
               const Eigen::Vector3f& half_extents, HandGrid& grid) {
  constexpr int kMostPixels = 60000;
  const cv::Rect part = SeenPart(scene, half_extents.z(), grid);
  const int step = std::max(1, cvCeil(std::sqrt(part.area() / static_cast<double>(kMostPixels))));
  PointCollector points(scene, object, solid, grid);
  for (int row = part.y; row < part.br().y; row += step) {
    InterruptionPoint();
    points.AddRow(row, {part.x, part.br().x}, step);
  }
  points.SetColumns();
}

}  // namespace fovea
