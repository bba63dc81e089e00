#include "server/conversion/gripper.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "server/conversion/field_error.h"
#include "server/conversion/geometry.h"

namespace fovea::server {
namespace {

constexpr float kSuctionTilt_rad = 0.8F;

// From `least` to `most`. Answers say floats, which may lie beside a limit by what they are rounded
// by, and can be sent again.
bool IsFrom(double least, double most, double given) {
  return given >= std::min<double>(least, static_cast<float>(least)) &&
         given <= std::max<double>(most, static_cast<float>(most));
}

// What 0 stands for is in `value` already; what is more does not become it.
void SetPositive(double given, float* value) {
  if (given > 0) *value = std::max(static_cast<float>(given), std::numeric_limits<float>::min());
}

void SetLength(double given, double most, const std::string& path, float* length) {
  constexpr double kLeast_m = 1e-4;
  RequireField(given == 0 || IsFrom(kLeast_m, most, given), path,
               "must be 0 (as the contract says) or from 0.0001 to " + std::to_string(most) + " m");
  SetPositive(given, length);
}

Eigen::Vector3f PalmFromProto(const v1::Vector3& palm, const std::string& path) {
  const Eigen::Vector3d size = FromProto(palm);
  // More than the widest hand has where none is given, which comes back and can be sent again.
  constexpr double kMost_m = 1.5;
  RequireField(size.allFinite() && size.minCoeff() >= 0 && size.maxCoeff() <= kMost_m, path,
               "must be from 0 to 1.5 m each");
  return size.cast<float>();
}

JawGripper JawFromProto(const v1::JawGripper& proto, const std::string& path) {
  JawGripper jaw;
  SetLength(proto.max_opening_m(), 1, path + ".max_opening_m", &jaw.max_opening_m);
  SetLength(proto.finger_length_m(), 1, path + ".finger_length_m", &jaw.finger_length_m);
  SetLength(proto.finger_width_m(), 0.5, path + ".finger_width_m", &jaw.finger_width_m);
  SetLength(proto.finger_thickness_m(), 0.2, path + ".finger_thickness_m", &jaw.finger_thickness_m);
  RequireField(IsFrom(0, 2, proto.friction()), path + ".friction", "must be from 0 (0.5) to 2");
  SetPositive(proto.friction(), &jaw.friction);
  if (proto.has_palm_size()) jaw.palm_m = PalmFromProto(proto.palm_size(), path + ".palm_size");
  return jaw;
}

SuctionGripper SuctionFromProto(const v1::SuctionGripper& proto, const std::string& path) {
  SuctionGripper suction;
  SetLength(proto.diameter_m(), 0.3, path + ".diameter_m", &suction.diameter_m);
  RequireField(IsFrom(0, 1000, proto.max_curvature_per_m()), path + ".max_curvature_per_m",
               "must be from 0 (12) to 1000");
  SetPositive(proto.max_curvature_per_m(), &suction.max_curvature_per_m);
  return suction;
}

Gripper GripperFromProto(const v1::Gripper& proto, const std::string& path) {
  constexpr std::size_t kMaxName = 64;
  constexpr std::uint32_t kMaxGrasps = 20;
  constexpr double kUnit = 1e-3;
  Gripper gripper;
  RequireField(proto.name().size() <= kMaxName, path + ".name", "is longer than 64 bytes");
  gripper.name = proto.name();
  switch (proto.hand_case()) {
    case v1::Gripper::kSuction:
      gripper.hand = SuctionFromProto(proto.suction(), path + ".suction");
      gripper.max_tilt_rad = kSuctionTilt_rad;
      break;
    case v1::Gripper::kJaw:
    case v1::Gripper::HAND_NOT_SET:  // jaws, as the contract says
      gripper.hand = JawFromProto(proto.jaw(), path + ".jaw");
  }
  if (proto.has_approach()) {
    const Eigen::Vector3d approach = FromProto(proto.approach());
    RequireField(std::abs(approach.norm() - 1) < kUnit, path + ".approach",
                 "must be a unit vector; its length is " + std::to_string(approach.norm()));
    gripper.approach = approach.normalized().cast<float>();
  }
  if (proto.has_max_tilt_rad()) {
    RequireField(IsFrom(0, std::numbers::pi / 2, proto.max_tilt_rad()), path + ".max_tilt_rad",
                 "must be from 0 to pi / 2");
    gripper.max_tilt_rad = static_cast<float>(proto.max_tilt_rad());
  }
  RequireField(proto.max_grasps() <= kMaxGrasps, path + ".max_grasps", "must be at most 20");
  if (proto.max_grasps() > 0) gripper.max_grasps = static_cast<int>(proto.max_grasps());
  if (proto.has_min_probability()) {
    RequireField(IsFrom(0, 1, proto.min_probability()), path + ".min_probability",
                 "must be from 0 to 1");
    gripper.min_probability = static_cast<float>(proto.min_probability());
  }
  return gripper;
}

double Said(float held, double given) {
  if (static_cast<float>(given) == held) return given;
  std::array<char, 32> text;
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), held).ptr;
  double said = held;
  std::from_chars(text.data(), end, said);
  return said;
}

void SetHand(const JawGripper& jaw, const v1::Gripper& sent, v1::Gripper* gripper) {
  const v1::JawGripper& given = sent.jaw();
  v1::JawGripper& proto = *gripper->mutable_jaw();
  proto.set_max_opening_m(Said(jaw.max_opening_m, given.max_opening_m()));
  proto.set_finger_length_m(Said(jaw.finger_length_m, given.finger_length_m()));
  proto.set_finger_width_m(Said(jaw.finger_width_m, given.finger_width_m()));
  proto.set_finger_thickness_m(Said(jaw.finger_thickness_m, given.finger_thickness_m()));
  const Eigen::Vector3f palm = PalmOf(jaw);
  proto.mutable_palm_size()->set_x(Said(palm.x(), given.palm_size().x()));
  proto.mutable_palm_size()->set_y(Said(palm.y(), given.palm_size().y()));
  proto.mutable_palm_size()->set_z(Said(palm.z(), given.palm_size().z()));
  proto.set_friction(Said(jaw.friction, given.friction()));
}

void SetHand(const SuctionGripper& cup, const v1::Gripper& sent, v1::Gripper* gripper) {
  const v1::SuctionGripper& given = sent.suction();
  v1::SuctionGripper& proto = *gripper->mutable_suction();
  proto.set_diameter_m(Said(cup.diameter_m, given.diameter_m()));
  proto.set_max_curvature_per_m(Said(cup.max_curvature_per_m, given.max_curvature_per_m()));
}

}  // namespace

v1::Gripper ToProto(const Gripper& gripper, const v1::Gripper& given) {
  v1::Gripper proto;
  proto.set_name(gripper.name);
  std::visit([&](const auto& hand) { SetHand(hand, given, &proto); }, gripper.hand);
  if (gripper.approach) *proto.mutable_approach() = ToProto(*gripper.approach);
  // Of pi / 2 the shortest number is beyond it.
  proto.set_max_tilt_rad(given.has_max_tilt_rad() ? Said(gripper.max_tilt_rad, given.max_tilt_rad())
                                                  : gripper.max_tilt_rad);
  proto.set_max_grasps(static_cast<std::uint32_t>(gripper.max_grasps));
  proto.set_min_probability(Said(gripper.min_probability, given.min_probability()));
  return proto;
}

std::vector<Gripper> FromProto(const v1::GraspOptions& options) {
  constexpr int kMaxGrippers = 8;
  if (options.none()) {
    RequireField(options.grippers().empty(), "options.grasps.none", "does not go with grippers");
    return {};
  }
  RequireField(options.grippers_size() <= kMaxGrippers, "options.grasps.grippers",
               "must be at most 8");
  if (options.grippers().empty()) return {Gripper{}};
  std::vector<Gripper> grippers;
  grippers.reserve(static_cast<std::size_t>(options.grippers_size()));
  for (int i = 0; i < options.grippers_size(); ++i) {
    grippers.push_back(GripperFromProto(options.grippers(i),
                                        "options.grasps.grippers[" + std::to_string(i) + "]"));
  }
  return grippers;
}

}  // namespace fovea::server
