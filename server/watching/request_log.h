#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <opencv2/core/types.hpp>
#include <string>

#include "core/types/detections.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// What there is to say of a frame that has been answered.
struct FrameRecord {
  const std::string& request_id;
  const std::string& robot;
  const std::string& peer;  // which is named where there is no robot
  const std::string& frame_id;
  const grpc::Status& status;
  const Detections& detections;      // where the status is not OK, only times of stages
  const v1::DetectOptions* options;  // as they came; null where there was no frame to look at
  cv::Size image;                    // empty where it was not decoded
  // From its receipt to its turn, or to its answer where none came; to its answer.
  std::chrono::steady_clock::duration queued{}, took{};
};

// One line of key=value per frame: at info what was found, at warning what went wrong; a second one
// with image, profile, options that differ from it (what of these is known), and the time of each
// stage where it took longer than `slow` (0: never). What went wrong is limited by status code, see
// LogLimiter. What came from outside is quoted, escaped and shortened.
void LogFrame(const FrameRecord& record, std::chrono::milliseconds slow);

// One line, at warning and limited likewise, for a stream that was not let in, or whose caller may
// not call any more.
void LogRefusedStream(const std::string& request_id, const std::string& robot,
                      const std::string& peer, const grpc::Status& status);

// The same for an answer that was ready, and whose caller did not take it.
void LogUntakenAnswer(const std::string& request_id, const std::string& robot,
                      const grpc::Status& status);

}  // namespace fovea::server
