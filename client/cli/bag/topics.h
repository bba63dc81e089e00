// Which of a bag's topics are meant.
#pragma once

#include <string>
#include <vector>

namespace fovea::cli {

// The one of `topics` (with images) that holds colour or depth: `wanted`, where it is not empty.
// Throws std::invalid_argument that lists them where that is not among them, or where none or
// several can be meant.
std::string ColorTopic(const std::vector<std::string>& topics, const std::string& wanted);
std::string DepthTopic(const std::vector<std::string>& topics, const std::string& wanted);

// Whether its images are undistorted already, by the name that ROS gives them ("image_rect…").
bool IsRectified(const std::string& color_topic);

// The one of `infos` (with camera_info) whose namespace the colour topic is in, the innermost: of
// several there the one that is called camera_info, or the only one without "depth" in its name.
// Empty = none, or it is not clear which.
std::string InfoTopic(const std::vector<std::string>& infos, const std::string& color_topic);

}  // namespace fovea::cli
