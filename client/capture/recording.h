#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "client/capture/openni_camera.h"
#include "client/capture/recording_file.h"

namespace fovea::capture {

// A recording of a running camera that is being written; its end completes the file.
class Recording {
 public:
  // Refers to the camera, which must outlive it. Throws std::runtime_error where the file cannot be
  // made.
  Recording(std::string path, OpenNiCamera& camera);
  ~Recording();

  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  // OpenNI2 counts the time of each stream from the first image that it writes of it, so it starts
  // between two moments: the first of colour and of depth belong together. `notes` gets a line
  // where that does not succeed; `goes_on` ends the attempts. Throws std::runtime_error where
  // OpenNI2 does not record, CameraError like the camera.
  void Begin(const std::function<bool()>& goes_on, std::ostream& notes);

  // How many pictures are in the file. OpenNI2 writes in a thread of its own, a little later.
  std::uint64_t NumWritten();

  // Stops the camera, waits until nothing more gets into the file, as OpenNI2 forgets what it has
  // not written when a recording ends, and completes it. Returns the number of pictures in it.
  std::uint64_t Finish();

 private:
  struct Closing {
    void operator()(openni::Recorder* recorder) const;
  };

  void Create();
  bool StartsTogether(const std::function<bool()>& goes_on);
  bool Starts();
  bool Abandon(const std::function<bool()>& goes_on);
  std::optional<std::uint64_t> TimeOfNext(const std::function<bool()>& goes_on);
  void AwaitWritten();
  void Check(openni::Status status) const;

  const std::string path_;
  OpenNiCamera& camera_;
  std::unique_ptr<openni::Recorder, Closing> recorder_;
  std::optional<RecordingFile> file_;
};

}  // namespace fovea::capture
