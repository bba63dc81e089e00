#include "server/conversion/grasp.h"

#include <algorithm>

#include "server/conversion/geometry.h"

namespace fovea::server {
namespace {

v1::GraspKind KindToProto(Grasp::Kind kind) {
  switch (kind) {
    case Grasp::Kind::kAcross:
      return v1::GRASP_KIND_ACROSS;
    case Grasp::Kind::kRim:
      return v1::GRASP_KIND_RIM;
    case Grasp::Kind::kHandle:
      return v1::GRASP_KIND_HANDLE;
    case Grasp::Kind::kSide:
      return v1::GRASP_KIND_SIDE;
    case Grasp::Kind::kSuction:
      return v1::GRASP_KIND_SUCTION;
  }
  return v1::GRASP_KIND_UNSPECIFIED;
}

v1::NoGraspReason ReasonToProto(NoGrasp::Reason reason) {
  switch (reason) {
    case NoGrasp::Reason::kTooWide:
      return v1::NO_GRASP_REASON_TOO_WIDE;
    case NoGrasp::Reason::kNeighbor:
      return v1::NO_GRASP_REASON_NEIGHBOR;
    case NoGrasp::Reason::kCovered:
      return v1::NO_GRASP_REASON_COVERED;
    case NoGrasp::Reason::kTooLow:
      return v1::NO_GRASP_REASON_TOO_LOW;
    case NoGrasp::Reason::kSloped:
      return v1::NO_GRASP_REASON_SLOPED;
    case NoGrasp::Reason::kCut:
      return v1::NO_GRASP_REASON_CUT;
    case NoGrasp::Reason::kTooLittleSeen:
      return v1::NO_GRASP_REASON_TOO_LITTLE_SEEN;
    case NoGrasp::Reason::kNoSeal:
      return v1::NO_GRASP_REASON_NO_SEAL;
    case NoGrasp::Reason::kUnlikely:
      return v1::NO_GRASP_REASON_UNLIKELY;
  }
  return v1::NO_GRASP_REASON_UNSPECIFIED;
}

}  // namespace

v1::Grasp ToProto(const Grasp& grasp, const std::string& gripper_name) {
  v1::Grasp proto;
  *proto.mutable_tool_center_point() = ToProto(grasp.tool_center_point);
  *proto.mutable_approach() = ToProto(grasp.approach);
  *proto.mutable_closing() = ToProto(grasp.closing);
  proto.set_opening_m(grasp.opening_m);
  proto.set_pre_grasp_opening_m(grasp.pre_grasp_opening_m);
  proto.set_kind(KindToProto(grasp.kind));
  proto.set_gripper(gripper_name);
  proto.set_gripper_index(static_cast<std::uint32_t>(grasp.gripper));
  proto.set_probability(grasp.probability);
  const Eigen::Vector3f pre_grasp =
      grasp.tool_center_point - grasp.approach * grasp.pre_grasp_distance_m;
  *proto.mutable_pre_grasp_position() = ToProto(pre_grasp);
  proto.set_clearance_m(grasp.clearance_m);
  proto.set_unseen_contacts(grasp.unseen_contacts);
  proto.set_unseen_way(grasp.unseen_way);
  proto.set_unevenness_m(grasp.unevenness_m);
  proto.set_usable_diameter_m(grasp.usable_diameter_m);
  proto.set_off_center_m(grasp.off_center_m);
  return proto;
}

void KeepWithin(const v1::Gripper& gripper, v1::Grasp* grasp) {
  if (gripper.has_jaw()) {
    const double most_m = gripper.jaw().max_opening_m();
    grasp->set_opening_m(std::min(grasp->opening_m(), most_m));
    grasp->set_pre_grasp_opening_m(std::min(grasp->pre_grasp_opening_m(), most_m));
  } else {
    const double least_m = gripper.suction().diameter_m();
    grasp->set_usable_diameter_m(std::max(grasp->usable_diameter_m(), least_m));
  }
}

v1::NoGrasp ToProto(const NoGrasp& none, const std::string& gripper_name) {
  v1::NoGrasp proto;
  proto.set_gripper(gripper_name);
  proto.set_gripper_index(static_cast<std::uint32_t>(none.gripper));
  proto.set_reason(ReasonToProto(none.reason));
  return proto;
}

}  // namespace fovea::server
