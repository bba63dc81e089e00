#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"
#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// A frame of a robot and what became of it, as it is handed over to be shown.
struct Sight {
  std::string robot;
  std::uint64_t sequence = 0;
  std::chrono::system_clock::time_point answered_at;
  std::chrono::steady_clock::duration took{};
  grpc::Status status = {};
  v1::Frame frame = {};  // as it came
  v1::DetectOptions options = {};
  RgbdFrame decoded = {};      // empty images where it was not
  Detections detections = {};  // where the status is OK
  v1::Detections extras = {};  // what is not in these: seeds, saliency maps, whose grippers
  // What the robot got, where somebody wants that.
  std::shared_ptr<const v1::Detections> answer = nullptr;

  bool IsProblem() const;
  // What it holds of memory, roughly.
  std::size_t NumBytes() const;
};

}  // namespace fovea::server
