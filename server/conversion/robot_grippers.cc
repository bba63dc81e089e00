#include "server/conversion/robot_grippers.h"

#include <google/protobuf/util/json_util.h>

#include <stdexcept>

#include "server/conversion/gripper.h"

namespace fovea::server {
namespace {

constexpr const char* kEveryOther = "*";

[[noreturn]] void Fail(const std::string& given, const std::string& reason) {
  throw std::invalid_argument("--gripper: \"" + given + "\": " + reason);
}

v1::Gripper Parsed(const std::string& given, const std::string& json) {
  v1::Gripper gripper;
  const auto status = google::protobuf::util::JsonStringToMessage(json, &gripper);
  if (!status.ok()) Fail(given, "is no fovea.v1.Gripper in JSON: " + status.ToString());
  return gripper;
}

// Without the path of the request that it would have come with.
std::string WithoutPath(const std::string& text) {
  const std::string path = "options.grasps.";
  return text.starts_with(path) ? text.substr(path.size()) : text;
}

bool SaysNothing(const v1::GraspOptions& options) {
  return !options.none() && options.grippers().empty();
}

}  // namespace

RobotGrippers::RobotGrippers(const std::vector<std::string>& given) {
  std::map<std::string, v1::GraspOptions> options;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) Fail(text, "is not ROBOT={…}");
    v1::GraspOptions& of_robot = options[text.substr(0, equals)];
    *of_robot.add_grippers() = Parsed(text, text.substr(equals + 1));
    try {
      by_robot_[text.substr(0, equals)] = FromProto(of_robot);
    } catch (const std::invalid_argument& error) {
      Fail(text, WithoutPath(error.what()));
    }
  }
}

const std::vector<Gripper>* RobotGrippers::Find(const std::string& robot) const {
  auto found = by_robot_.find(robot);
  if (found == by_robot_.end()) found = by_robot_.find(kEveryOther);
  return found == by_robot_.end() ? nullptr : &found->second;
}

std::vector<Gripper> RobotGrippers::For(const std::string& robot, const v1::GraspOptions& options,
                                        const std::vector<Gripper>& requested) const {
  const std::vector<Gripper>* own = SaysNothing(options) ? Find(robot) : nullptr;
  return own != nullptr ? *own : requested;
}

v1::GripperSource RobotGrippers::SourceFor(const std::string& robot,
                                           const v1::GraspOptions& options) const {
  if (!SaysNothing(options)) return v1::GRIPPER_SOURCE_REQUEST;
  return Find(robot) != nullptr ? v1::GRIPPER_SOURCE_SERVER : v1::GRIPPER_SOURCE_DEFAULT;
}

}  // namespace fovea::server
