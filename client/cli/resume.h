// What a folder's frames become, and which of them are done already.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "client/cli/batch.h"
#include "client/cli/outputs.h"
#include "client/cli/request.h"

namespace fovea::cli {

// The files of the frame of this name, below Batch::output; of none but JSON on standard output.
Outputs OutputsOf(const std::string& name, const Batch& batch);

// Writes fovea_request.json and fovea_input.json, for --resume and for people who come back to the
// results; with --resume the first stays as old as it is. Throws std::invalid_argument where
// --resume would mix answers to different requests, or of frames of different inputs, or overlays
// that show different things.
void SaveRequest(const Batch& batch, const FrameSettings& settings);

// With --resume, takes what is done out of `frames`: frames whose files are all there, and no older
// than what they were made from. Returns how many those were.
std::size_t LeaveOutDone(const Batch& batch, std::vector<FrameFiles>* frames);

}  // namespace fovea::cli
