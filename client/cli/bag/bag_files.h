// Which files a ROS 2 bag has: one that is given, or those of a folder that `ros2 bag record` made.
#pragma once

#include <string>

#include "client/cli/bag/bag.h"

namespace fovea::cli {

// "x.mcap", "x.db3", or a folder with metadata.yaml or, where its recorder was killed, NAME/NAME_0
// or another of its files.
bool IsBag(const std::string& path);

// Files of a folder that are missing or none of a bag are left out, and the first note says so.
// Throws std::runtime_error that names the file and what ReadBag says; where none can be read, the
// first.
Bag OpenBag(const std::string& path, const BagFlags& flags);

}  // namespace fovea::cli
