#include "client/cli/busy_machine.h"

#include <fmt/format.h>

namespace fovea::cli {
namespace {

void Add(const std::string& stage, const google::protobuf::Duration& duration,
         ProcessorWait& wait) {
  const double seconds = static_cast<double>(duration.seconds()) + duration.nanos() * 1e-9;
  if (stage == kProcessorWait) {
    wait.waited_s += seconds;
  } else if (stage != "queue" && stage != "decode") {  // which it is not measured in
    wait.took_s += seconds;
  }
}

}  // namespace

ProcessorWait ProcessorWaitOf(const v1::Detections& detections) {
  ProcessorWait wait;
  for (const v1::StageTime& time : detections.stage_times())
    Add(time.stage(), time.duration(), wait);
  return wait;
}

ProcessorWait ProcessorWaitOf(const v1::GetStatisticsResponse& statistics) {
  ProcessorWait wait;
  for (const auto& [stage, times] : statistics.stages()) Add(stage, times.total(), wait);
  return wait;
}

std::string NoteOfBusyMachine(const ProcessorWait& wait) {
  if (!wait.IsMuch()) return {};
  return fmt::format(
      "note: of {:.1f} s that frames took, the server waited {:.1f} s for a processor: other "
      "programs of its machine, or more threads than it has processors, use them; see \"A busy "
      "machine\" in docs/operations.md\n",
      wait.took_s, wait.waited_s);
}

}  // namespace fovea::cli
