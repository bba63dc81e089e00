// Images of colour and depth that were taken one by one, by their times.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/cli/frame_list.h"

namespace fovea::cli {

struct TimedImage {
  std::int64_t time_ns = 0;
  std::string name, path;  // the time as it was written; the file
};

// Nanoseconds: "12.5" are seconds; whole numbers are seconds, milli-, micro- or nanoseconds by how
// many digits they have (up to 11, 14, 17, 19). None for other texts.
std::optional<std::int64_t> ParseTime(const std::string& text);

// Each image belongs to one pair at most, the closest ones first; a frame has the name and the time
// of its colour image. Sorted by time; notes say how many of which had no partner.
FrameList PairByTime(std::vector<TimedImage> color, std::vector<TimedImage> depth);

}  // namespace fovea::cli
