// How a simulated world and the program of a robot speak: a line of JSON each, by turns.
#pragma once

#include <opencv2/core/types.hpp>
#include <string>
#include <variant>
#include <vector>

#include "core/types/grasp.h"
#include "tests/evaluation/clean_up/floor_world.h"

namespace fovea::evaluation {

// A fovea.v1.DetectRequest in protobuf's JSON: the frame, as PNG, and the world's grippers.
std::string RequestLine(const scenes::LabelledFrame& frame, const std::vector<Gripper>& hands,
                        const std::string& id);

// What the program wants: to take something, or to end, with what its last answer has found.
struct FoundThing {
  cv::Rect bounds_px;
  std::string reason;  // why it is left: "jaw too low, tried in vain", "something stands on it"
};
using Decision = std::variant<Grasp, std::vector<FoundThing>>;

// Of a line {"grasp": …} or {"left": …}: a fovea.v1.Grasp and Detections in protobuf's JSON with
// the names of the contract, or a grasp and the list of objects as the Python library has them.
// Throws std::invalid_argument, which quotes the line's start.
Decision DecisionOf(const std::string& line);

}  // namespace fovea::evaluation
