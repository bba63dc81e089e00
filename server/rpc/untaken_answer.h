#pragma once

#include "server/rpc/caller.h"
#include "server/rpc/transfer_limit.h"
#include "server/watching/metrics.h"

namespace fovea::server {

// Logs and counts an answer for which `transfer` has cancelled the call, if it has. The frame that
// it is of counts as answered all the same. Returns whether it has.
bool NoteUntakenAnswer(const TransferLimit& transfer, const Caller& caller, Metrics& metrics);

}  // namespace fovea::server
