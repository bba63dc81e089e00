// The frames that methods are timed on: recorded ones where there are any, and generated ones.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/evaluation/dataset.h"

namespace fovea::benchmark {

struct BenchFrame {
  evaluation::Scene scene;      // without its ground truth
  std::size_t num_objects = 0;  // that are known to be there; 0: not known
};

struct FrameSet {
  std::string name;
  std::string source;  // what the frames are and where they come from
  std::vector<BenchFrame> frames;
};

// mOSD, frames of other cameras by size, and whole rooms from `data`, without those that it lacks,
// then generated scenes by size and by their number of objects, noise and a checkerboard; of these
// the sets whose names begin with `only`. At most `max_frames` each, spread over the whole of a
// set. Throws std::invalid_argument where no name begins so.
std::vector<FrameSet> FrameSets(const std::optional<std::filesystem::path>& data,
                                const std::string& only, std::size_t max_frames);

// What `data` lacks of it.
std::vector<std::string> MissingSets(const std::optional<std::filesystem::path>& data);

}  // namespace fovea::benchmark
