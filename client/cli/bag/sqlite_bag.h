// SQLite databases, the files of ROS 2 bags up to Humble: tables `topics` and `messages`.
#pragma once

#include <memory>
#include <string>

#include "client/cli/bag/bag_file.h"

namespace fovea::cli {

// Only reads it. Throws std::invalid_argument where it is no such database.
std::shared_ptr<const BagFile> SqliteBagFile(const std::string& path);

}  // namespace fovea::cli
