#pragma once

#include <iosfwd>
#include <string>

#include "client/capture/busy_watch.h"
#include "client/capture/picture.h"
#include "client/capture/tally.h"
#include "client/capture/viewer.h"
#include "fovea/v1/detection_service.pb.h"

namespace fovea::capture {

// An answer and the picture that it is about.
struct Result {
  Picture picture;
  v1::DetectStreamResponse response;
  std::uint64_t lost = 0;  // before it, with a connection that broke
};

// What a person gets to see of the answers: a line each, files, the window.
class Results {
 public:
  // `save_folder` is there; empty = no files. `viewer` may be null.
  // `cameras`: a frame without images, with what all frames say of the cameras.
  Results(std::string save_folder, v1::Frame cameras, Viewer* viewer, std::ostream& out);

  // Masks are needed for drawing only.
  void RequestFor(v1::DetectOptions* options) const;

  // Counts, prints and saves. Throws std::runtime_error for files that cannot be written, and where
  // the server refuses what all frames of the run have in common. By one thread at a time.
  void Take(const Result& result, Tally& tally);

 private:
  void PrintNotes(const v1::Detections& detections);
  bool Draws() const { return viewer_ != nullptr || !save_folder_.empty(); }
  void Save(const Picture& picture, const v1::Detections& detections, const cv::Mat& color,
            const cv::Mat& overlay);

  const std::string save_folder_;
  const v1::Frame cameras_;
  Viewer* const viewer_;
  std::ostream& out_;
  bool saved_cameras_ = false;
  BusyWatch busy_watch_;
  std::string last_notes_;  // what the server said of the last frame, without its numbers
};

}  // namespace fovea::capture
