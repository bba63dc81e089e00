#pragma once

#include <string>

#include "client/cli/busy_machine.h"

namespace fovea::capture {

// Notices, of the answers of a stream, when other programs begin to keep the processors of the
// server's machine from it.
class BusyWatch {
 public:
  // The note for people, where frames of the last two seconds of work waited for more than a third
  // of their time and those before them did not; else empty.
  std::string Take(const v1::Detections& detections);

 private:
  cli::ProcessorWait recent_;
  bool is_busy_ = false;
};

}  // namespace fovea::capture
