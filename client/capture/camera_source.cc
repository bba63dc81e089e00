#include "client/capture/camera_source.h"

#include <ostream>
#include <thread>
#include <utility>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

// How soon Ctrl-C is noticed, and how often a camera that is away is looked for.
constexpr std::chrono::milliseconds kMoment{100};

CameraLosses Sum(const CameraLosses& a, const CameraLosses& b) {
  return {a.missed + b.missed, a.unpaired + b.unpaired, a.wrong_size + b.wrong_size};
}

}  // namespace

CameraSource::CameraSource(const CameraOptions& options, std::chrono::milliseconds patience,
                           std::ostream& notes)
    : options_(options), patience_(patience), notes_(notes), camera_(OpenCamera(options, notes)) {
  options_.device = camera_->Name();
}

std::optional<Picture> CameraSource::Next() {
  if (!camera_) TryToReopen();
  if (!camera_) return std::nullopt;
  try {
    return NextOf(*camera_);
  } catch (const CameraLost& lost) {
    Lose(lost.what());
  } catch (const CameraError& error) {
    if (!away_since_) throw;
    earlier_losses_ = Losses();
    camera_.reset();
    GiveUpOrWait(error);
  }
  return std::nullopt;
}

std::optional<Picture> CameraSource::NextOf(Camera& camera) {
  auto picture = camera.Next(kMoment);
  if (!picture) return std::nullopt;
  picture->number = ++num_pictures_;
  if (std::exchange(away_since_, std::nullopt)) {
    ++num_reopened_;
    notes_ << "the camera " << camera.Uri() << " is back" << std::endl;
  }
  return picture;
}

void CameraSource::SkipWaiting() {
  try {
    if (camera_) camera_->SkipWaiting();
  } catch (const CameraLost& lost) {
    Lose(lost.what());
  }
}

void CameraSource::Lose(const std::string& reason) {
  notes_ << reason << "; waiting for it to come back" << std::endl;
  earlier_losses_ = Losses();
  camera_.reset();
  if (!away_since_) away_since_ = std::chrono::steady_clock::now();
}

void CameraSource::TryToReopen() {
  try {
    camera_ = OpenCamera(options_, notes_);
  } catch (const CameraError& error) {
    GiveUpOrWait(error);
  }
}

void CameraSource::GiveUpOrWait(const CameraError& error) {
  if (std::chrono::steady_clock::now() - *away_since_ >= patience_) {
    throw CameraError(std::string("the camera did not come back: ") + error.what());
  }
  std::this_thread::sleep_for(kMoment);
}

CameraLosses CameraSource::Losses() const {
  return camera_ ? Sum(earlier_losses_, camera_->Losses()) : earlier_losses_;
}

}  // namespace fovea::capture
