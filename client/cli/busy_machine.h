// Whether other programs of the server's machine keep the processors from it.
#pragma once

#include <string>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::cli {

// The name among the times of stages under which servers tell it; it is part of the others.
constexpr char kProcessorWait[] = "processor_wait";

// What frames took in all and what of it they waited for a processor, both in seconds.
struct ProcessorWait {
  double waited_s = 0;
  double took_s = 0;

  // More than a third: beyond what the server's own threads cost each other.
  bool IsMuch() const { return waited_s > took_s / 3; }
};

ProcessorWait ProcessorWaitOf(const v1::Detections& detections);
ProcessorWait ProcessorWaitOf(const v1::GetStatisticsResponse& statistics);

// "note: the server waited …\n", for people; empty where it is not much.
std::string NoteOfBusyMachine(const ProcessorWait& wait);

inline std::string NoteOfBusyMachine(const v1::GetStatisticsResponse& statistics) {
  return NoteOfBusyMachine(ProcessorWaitOf(statistics));
}

}  // namespace fovea::cli
