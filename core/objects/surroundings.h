// What lies beyond the borders of segments in the image: an object ends in the open, a table leg at
// its table, a wall at the end of the image. Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/objects/labelled_scene.h"

namespace fovea {

// What the first thing beyond a border is.
enum class Beyond {
  kEnd,         // of the image, or of what was measured of it: registered depth leaves a margin
  kUnmeasured,  // nothing, within the reach
  kFarther,     // anything farther away
  kNearer,      // background in front
  kNearerSegment,
  kLevel,         // background at the same distance, no higher: mostly what it stands on
  kRising,        // background at the same distance that goes on upwards
  kWall,          // such background on a wall, which objects may stand against
  kLevelSegment,  // a segment at the same distance
};
constexpr std::size_t kNumBeyond = 9;

// Where the border is as gravity goes; nowhere above where the camera looks straight down.
enum class BorderSide { kAbove, kElsewhere };
constexpr std::size_t kNumBorderSides = 2;

// Of colours of objects to background at their distance, CIELAB as OpenCV scales it: where nobody
// sees it.
constexpr double kUsualContrast = 12;

// Sides of pixels, so that those of joined segments add up.
struct BorderCounts {
  std::array<std::array<double, kNumBeyond>, kNumBorderSides> sides{};

  // Difference of colour to background at the same distance, summed over such sides; in grey frames
  // with what is usual of it.
  double contrast = 0;

  void Count(BorderSide side, Beyond beyond) {
    ++sides[static_cast<std::size_t>(side)][static_cast<std::size_t>(beyond)];
  }
  void Add(const BorderCounts& other, double sign = 1);
  double Of(Beyond beyond) const;  // on all sides
  double Of(BorderSide side) const;
  double At(BorderSide side, Beyond beyond) const {
    return sides[static_cast<std::size_t>(side)][static_cast<std::size_t>(beyond)];
  }
  double Total() const;
};

// The side of a pixel of one segment that faces another.
struct Facing {
  int own = 0, other = 0;  // labels
  BorderSide side = BorderSide::kElsewhere;
  Beyond beyond = Beyond::kLevelSegment;
};

struct Surroundings {
  std::vector<BorderCounts> counts;  // one entry a label, the background's first and empty
  std::vector<Facing> facings;       // of what is counted, all that face a segment
};

// Of the segments of `labels` (CV_16UC1, 0 = background). Cost: proportional to the image.
Surroundings FindSurroundings(const LabelledScene& scene, const cv::Mat& labels);

}  // namespace fovea
