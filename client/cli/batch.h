#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "client/cli/request.h"
#include "client/client.h"

namespace fovea::cli {

// Every NAME_color.(png|jpg|jpeg) with its NAME_depth.png in `input`, in the order of the names →
// NAME.png (labels), NAME.json and NAME_overlay.png in `output`, which is made where it is
// missing. A frame that fails is named and the run goes on; one without objects or support surface
// is printed with what the server says about that. `explain` words a call that failed. Returns
// whether none failed; throws std::exception where there is nothing to do.
bool DetectFolder(const client::Client& client, const std::string& input, const std::string& output,
                  FrameSettings settings, std::chrono::milliseconds timeout,
                  const std::function<std::string(const client::RpcError&)>& explain);

}  // namespace fovea::cli
