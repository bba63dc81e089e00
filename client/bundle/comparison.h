#pragma once

#include <string>

#include "fovea/v1/detection.pb.h"

namespace fovea::bundle {

// The answer to a frame that is sent once more, alone, as it compares with that of its stream: what
// was not asked for is left out, so is what comes from frames before it (tracks), and, unless
// `with_times`, what differs from run to run (times).
v1::Detections Comparable(v1::Detections answer, const v1::DetectOptions& asked, bool with_times);

// The same answer has the same bytes.
std::string BytesOf(const v1::Detections& answer);

// For people: whether the answers are the same, and if not, in what. Both to the same options.
std::string CompareAnswers(const v1::Detections& then, const v1::Detections& now,
                           const v1::DetectOptions& asked);

}  // namespace fovea::bundle
