#include "client/cli/words.h"

namespace fovea::cli {

const char* WordOf(v1::ShapeKind kind) {
  switch (kind) {
    case v1::SHAPE_KIND_OTHER:
      return "other";
    case v1::SHAPE_KIND_BOX:
      return "box";
    case v1::SHAPE_KIND_CYLINDER:
      return "cylinder";
    case v1::SHAPE_KIND_SPHERE:
      return "sphere";
    case v1::SHAPE_KIND_REVOLUTION:
      return "round";
    case v1::SHAPE_KIND_FLAT:
      return "flat";
    default:
      return "?";
  }
}

const char* WordOf(v1::GraspKind kind) {
  switch (kind) {
    case v1::GRASP_KIND_ACROSS:
      return "across";
    case v1::GRASP_KIND_RIM:
      return "rim";
    case v1::GRASP_KIND_HANDLE:
      return "handle";
    case v1::GRASP_KIND_SIDE:
      return "side";
    case v1::GRASP_KIND_SUCTION:
      return "suction";
    default:
      return "?";
  }
}

const char* WordOf(v1::NoGraspReason reason) {
  switch (reason) {
    case v1::NO_GRASP_REASON_TOO_WIDE:
      return "too wide";
    case v1::NO_GRASP_REASON_NEIGHBOR:
      return "neighbour in the way";
    case v1::NO_GRASP_REASON_COVERED:
      return "covered";
    case v1::NO_GRASP_REASON_TOO_LOW:
      return "too low";
    case v1::NO_GRASP_REASON_SLOPED:
      return "sloped sides";
    case v1::NO_GRASP_REASON_CUT:
      return "cut by the image";
    case v1::NO_GRASP_REASON_TOO_LITTLE_SEEN:
      return "too little seen";
    case v1::NO_GRASP_REASON_NO_SEAL:
      return "no seal";
    case v1::NO_GRASP_REASON_UNLIKELY:
      return "unlikely to hold";
    default:
      return "?";
  }
}

}  // namespace fovea::cli
