// Enumerations of the contract in words for people.
#pragma once

#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// "cylinder"; "?" of what a newer server may send.
const char* WordOf(v1::ShapeKind kind);
// "across".
const char* WordOf(v1::GraspKind kind);
// "too wide".
const char* WordOf(v1::NoGraspReason reason);

}  // namespace fovea::cli
