// The errors of a box beside how sure the answer is of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/types/detections.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

// In this order; sizes and places of the middle along the axes of the answered box.
inline constexpr std::array<const char*, 7> kUncertainNumbers = {
    "length", "width", "height", "middle along x", "middle along y", "middle upwards", "yaw"};

struct ErrorAndSigma {
  double error = 0, sigma = 0;  // metres; of yaw radians

  bool IsWithin(double sigmas) const;
};

// None of yaw where truth or answer are round about the upright; all none where the answer does not
// say how sure it is.
using UncertainBox = std::array<std::optional<ErrorAndSigma>, kUncertainNumbers.size()>;
UncertainBox CompareUncertainBox(const scenes::Body& body, const DetectedObject& answer,
                                 const Eigen::Isometry3d& world_from_camera);

// Over many boxes: an honest answer has 68 and 95 % within one and two standard deviations.
struct Honesty {
  std::string name;  // of kUncertainNumbers
  std::size_t count = 0;
  double within_one = 0, within_two = 0;  // shares
  double median_error = 0, median_sigma = 0;
};

// One for each number that any of them has.
std::vector<Honesty> HonestyOf(const std::vector<UncertainBox>& boxes);

}  // namespace fovea::evaluation
