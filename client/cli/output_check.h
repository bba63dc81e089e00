// Whether outputs can be written, asked before anything is computed for them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "client/cli/outputs.h"
#include "client/cli/request.h"

namespace fovea::cli {

// Flags and what they name: files that are read, or other values.
using ReadFiles = std::vector<std::pair<std::string, std::string>>;

// Throws std::invalid_argument that names flag and path where a folder is missing or cannot be
// written to, where a file cannot be of the kind that its ending says, or where an output is a file
// of the frame, one of `others` or another output.
void CheckOutputs(const Outputs& outputs, const FrameFiles& files, const ReadFiles& others = {});

// Makes the folder that `flag` names where it is missing. Throws std::invalid_argument that names
// both where it cannot be written to.
void MakeFolder(const std::string& flag, const std::string& path);

// Makes `output` where it is missing. Throws std::invalid_argument where it cannot be written to,
// or is `input` or a folder of the frames' files: NAME.png there may be an image, or the truth
// about one.
void PrepareFolder(const std::string& input, const std::vector<FrameFiles>& frames,
                   const std::string& output);

// Throws std::invalid_argument unless it is "ply" or "pcd" in either case, which --cloud writes.
void CheckCloudFormat(const std::string& ending);

}  // namespace fovea::cli
