#pragma once

#include <optional>
#include <string>

#include "client/cli/frame_list.h"
#include "client/cli/overlay/overlay.h"
#include "client/cli/patient_server.h"
#include "client/cli/request.h"

namespace fovea::cli {

// What to do with a folder of frames.
struct Batch {
  std::string input;                     // for people and --resume
  std::string color_topic, depth_topic;  // of a bag
  FrameList list;                        // what `input` holds
  std::string output;                    // made where it is missing; empty = no files
  bool labels = true, overlays = true;
  OverlayExtras extras;
  std::string clouds;  // ending of NAME.ply or NAME.pcd; empty = none
  bool height_maps = false;
  bool json_lines = false;  // an answer a line to stdout; progress then goes to stderr
  bool json_masks = true;
  bool sent_before = false;            // the frames of `list` were
  bool resume = false;                 // leave out frames whose files are there and not older
  std::optional<int> jobs;             // frames in flight at once; none = see PatientServer
  std::optional<double> depth_unit_m;  // none = as the folder says, or such folders have it
};

// Frames that were sent before also get NAME_answer.pb, the answer to what was asked then, and a
// note on how it compares.
//
// Answers every frame → NAME.png (labels), NAME_overlay.jpg and NAME.json, the last of which is
// there only if all are, fovea_request.json, what was asked, and fovea_input.json, of what. Results
// are printed in the order of the frames. A frame that fails is named and the run goes on; others
// are printed with what the server says about them. A server that is away is waited for before the
// first frame. Returns whether none failed; throws std::exception where there is nothing to do, no
// server, a mistake in what is asked about all frames, where the server hangs, or where --resume
// would mix answers to different requests.
bool DetectFolder(PatientServer& server, Batch batch, FrameSettings settings);

}  // namespace fovea::cli
