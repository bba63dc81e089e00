// MCAP (mcap.dev/spec), the files of ROS 2 bags from Iron on, as far as messages need it: no
// indices, so that a bag whose recorder was killed is read, too.
#pragma once

#include <memory>

#include "client/cli/bag/bag_file.h"
#include "client/cli/bag/mcap_bytes.h"

namespace fovea::cli {

// Of bytes that live as long as what is returned. Throws std::invalid_argument where they are none.
std::shared_ptr<const BagFile> McapFile(McapBytes bytes);

}  // namespace fovea::cli
