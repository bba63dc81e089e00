#include "client/capture/busy_watch.h"

#include <utility>

namespace fovea::capture {

std::string BusyWatch::Take(const v1::Detections& detections) {
  constexpr double kEnough_s = 2;
  const cli::ProcessorWait wait = cli::ProcessorWaitOf(detections);
  recent_.waited_s += wait.waited_s;
  recent_.took_s += wait.took_s;
  if (recent_.took_s < kEnough_s) return {};
  const cli::ProcessorWait past = std::exchange(recent_, {});
  const bool was_busy = std::exchange(is_busy_, past.IsMuch());
  return was_busy ? std::string() : cli::NoteOfBusyMachine(past);
}

}  // namespace fovea::capture
