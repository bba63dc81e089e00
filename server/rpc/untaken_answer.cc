#include "server/rpc/untaken_answer.h"

#include "server/watching/request_log.h"

namespace fovea::server {

bool NoteUntakenAnswer(const TransferLimit& transfer, const Caller& caller, Metrics& metrics) {
  const auto why = transfer.why_cancelled();
  if (!why) return false;
  LogUntakenAnswer(caller.request_id(), caller.robot(), *why);
  metrics.OnUntaken();
  return true;
}

}  // namespace fovea::server
