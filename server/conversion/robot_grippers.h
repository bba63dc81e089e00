#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/types/gripper.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// The grippers of robots, as the operator knows them, for requests that name none.
class RobotGrippers {
 public:
  RobotGrippers() = default;
  // Each ROBOT=GRIPPER, a fovea.v1.Gripper in protobuf's JSON; several of one robot are its
  // grippers in this order, at most 8. "*" stands for every robot that is not named. Throws
  // std::invalid_argument that names the flag, what was given and the field.
  explicit RobotGrippers(const std::vector<std::string>& given);

  // What to plan grasps for: the robot's where `options` says nothing of grasps, else `requested`,
  // which was made of `options`.
  std::vector<Gripper> For(const std::string& robot, const v1::GraspOptions& options,
                           const std::vector<Gripper>& requested) const;

  v1::GripperSource SourceFor(const std::string& robot, const v1::GraspOptions& options) const;

 private:
  const std::vector<Gripper>* Find(const std::string& robot) const;

  std::map<std::string, std::vector<Gripper>> by_robot_;
};

}  // namespace fovea::server
