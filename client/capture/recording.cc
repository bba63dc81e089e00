#include "client/capture/recording.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

constexpr std::size_t kNumStreams = 2;
constexpr int kMaxAttempts = 10;

// OpenNI2 itself crashes where it cannot make the file.
void CheckWritable(const std::string& path) {
  errno = 0;
  if (std::ofstream(path, std::ios::binary)) return;
  throw std::runtime_error("cannot record to " + path + ": " + std::strerror(errno));
}

}  // namespace

void Recording::Closing::operator()(openni::Recorder* recorder) const {
  recorder->stop();
  recorder->destroy();
  delete recorder;
}

Recording::Recording(std::string path, OpenNiCamera& camera)
    : path_(std::move(path)), camera_(camera) {
  CheckWritable(path_);
}

Recording::~Recording() {
  if (recorder_) Finish();
}

void Recording::Begin(const std::function<bool()>& goes_on, std::ostream& notes) {
  for (int attempt = 1;; ++attempt) {
    Create();
    if (StartsTogether(goes_on)) return;
    if (attempt == kMaxAttempts || !Abandon(goes_on)) break;
  }
  notes
      << "note: colour and depth of " << path_
      << " may be a frame apart: images are missing, or this machine is too busy to start both at "
         "one moment\n";
}

void Recording::Create() {
  recorder_.reset(new openni::Recorder);
  file_.emplace(path_);
  Check(recorder_->create(path_.c_str()));
  Check(recorder_->attach(camera_.BothStreams().depth, /*allowLossyCompression=*/false));
  Check(recorder_->attach(camera_.BothStreams().color, /*allowLossyCompression=*/false));
}

// OpenNI2 waits for itself for ever where a recorder ends while it is given an image. One may be on
// its way to it now, and one before that wait to be read; once a third is read, it is given none.
// False where it shall not go on.
bool Recording::Abandon(const std::function<bool()>& goes_on) {
  constexpr int kSurelyLater = 3;
  recorder_->stop();
  for (int i = 0; i < kSurelyLater; ++i) {
    if (!TimeOfNext(goes_on)) return false;
  }
  recorder_.reset();
  return true;
}

// True as well where it shall not go on.
bool Recording::StartsTogether(const std::function<bool()>& goes_on) {
  const auto before = TimeOfNext(goes_on);
  Check(recorder_->start());
  if (!Starts() || camera_.ImageWaits()) return false;  // an image may have come before
  const auto first = TimeOfNext(goes_on);
  return !before || !first || *first - *before < camera_.PeriodUs() * 3 / 2;
}

// OpenNI2 keeps no image until the thread that writes has begun, and only the file tells when.
bool Recording::Starts() {
  constexpr std::chrono::milliseconds kMoment{1};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  while (file_->CountStreams() < kNumStreams) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(kMoment);
  }
  return true;
}

std::optional<std::uint64_t> Recording::TimeOfNext(const std::function<bool()>& goes_on) {
  constexpr std::chrono::milliseconds kMoment{100};
  while (goes_on()) {
    if (const auto picture = camera_.Next(kMoment)) return picture->device_time_us;
  }
  return std::nullopt;
}

std::uint64_t Recording::NumWritten() { return file_->CountFrames(kNumStreams); }

void Recording::AwaitWritten() {
  constexpr std::chrono::milliseconds kQuiet{300};
  std::uint64_t before = NumWritten();
  while (true) {
    std::this_thread::sleep_for(kQuiet);
    const std::uint64_t now = NumWritten();
    if (now == std::exchange(before, now)) return;
  }
}

std::uint64_t Recording::Finish() {
  camera_.Stop();
  AwaitWritten();
  const std::uint64_t num_written = NumWritten();
  recorder_.reset();
  return num_written;
}

void Recording::Check(openni::Status status) const {
  if (status == openni::STATUS_OK) return;
  throw std::runtime_error("cannot record to " + path_ + ": " + OpenNiReason());
}

}  // namespace fovea::capture
