#include "tests/capture/driver_device.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kNominalFps = 30;

cv::Mat ReadRgb(const std::string& path) {
  cv::Mat image = cv::imread(path);
  cv::cvtColor(image, image, cv::COLOR_BGR2RGB);
  return image;
}

std::uint64_t TimeOf(int index) {
  return static_cast<std::uint64_t>(index) * 1'000'000 / kNominalFps;
}

OniVideoMode Mode(OniPixelFormat format, const cv::Size& size, int fps) {
  return {format, size.width, size.height, fps};
}

}  // namespace

DriverDevice::DriverDevice(DriverOptions options, int opening)
    : options_(std::move(options)), opening_(opening) {
  LoadFrames();
  const cv::Size size = images_.front().color.size();
  const std::array formats{ONI_PIXEL_FORMAT_RGB888, ONI_PIXEL_FORMAT_DEPTH_1_MM};
  const std::array types{ONI_SENSOR_COLOR, ONI_SENSOR_DEPTH};
  for (std::size_t i = 0; i < infos_.size(); ++i) {
    modes_[i] = {Mode(formats[i], size, kNominalFps), Mode(formats[i], size, 15)};
    // One that only colour has.
    if (i == 0) modes_[i].push_back(Mode(formats[i], size * 2, kNominalFps));
    infos_[i] = {types[i], static_cast<int>(modes_[i].size()), modes_[i].data()};
  }
  thread_ = std::jthread([this] { Serve(); });
}

DriverDevice::~DriverDevice() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void DriverDevice::LoadFrames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(options_.frames)) {
    const std::string path = entry.path().string();
    const std::string ending = "_color.png";
    if (path.ends_with(ending)) names.push_back(path.substr(0, path.size() - ending.size()));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    images_.push_back(
        {ReadRgb(name + "_color.png"), cv::imread(name + "_depth.png", cv::IMREAD_UNCHANGED)});
  }
}

OniStatus DriverDevice::getSensorInfoList(OniSensorInfo** infos, int* count) {
  *infos = infos_.data();
  *count = static_cast<int>(infos_.size());
  return ONI_STATUS_OK;
}

oni::driver::StreamBase* DriverDevice::createStream(OniSensorType type) {
  const auto notify = [this] {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  };
  const bool is_color = type == ONI_SENSOR_COLOR;
  auto* stream = new DriverStream(type, modes_[is_color ? 0 : 1].front(), notify);
  const std::lock_guard lock(mutex_);
  (is_color ? color_ : depth_) = stream;
  return stream;
}

void DriverDevice::destroyStream(oni::driver::StreamBase* stream) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !serving_; });
  (stream == color_ ? color_ : depth_) = nullptr;
  delete stream;
}

OniStatus DriverDevice::getProperty(int id, void* data, int* size) {
  if (id != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION) return ONI_STATUS_NOT_SUPPORTED;
  std::memcpy(data, &registration_, sizeof registration_);
  *size = sizeof registration_;
  return ONI_STATUS_OK;
}

OniStatus DriverDevice::setProperty(int id, const void* data, int size) {
  if (id != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION || size != sizeof registration_) {
    return ONI_STATUS_NOT_SUPPORTED;
  }
  if (options_.Has("late-registration") && !BothRun()) return ONI_STATUS_OUT_OF_FLOW;
  std::memcpy(&registration_, data, sizeof registration_);
  return ONI_STATUS_OK;
}

OniBool DriverDevice::isPropertySupported(int id) {
  return id == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION ? TRUE : FALSE;
}

OniBool DriverDevice::isImageRegistrationModeSupported(OniImageRegistrationMode mode) {
  return mode == ONI_IMAGE_REGISTRATION_OFF || !options_.Has("no-registration") ? TRUE : FALSE;
}

OniStatus DriverDevice::tryManualTrigger() {
  const std::lock_guard lock(mutex_);
  wanted_ = true;
  changed_.notify_all();
  return ONI_STATUS_OK;
}

bool DriverDevice::BothRun() const {
  return color_ != nullptr && depth_ != nullptr && color_->Running() && depth_->Running();
}

bool DriverDevice::IsSilent(int index) const {
  constexpr int kNumBefore = 3;
  const bool hangs = opening_ == 2 || (opening_ == 1 && index > kNumBefore);
  return options_.Has("silent") || (options_.Has("hangs") && hangs);
}

void DriverDevice::Serve() {
  using std::chrono::steady_clock;
  const bool paced = options_.fps > 0;
  const auto period = std::chrono::microseconds(1'000'000 / std::max(options_.fps, 1));
  steady_clock::time_point next = steady_clock::now();
  std::unique_lock lock(mutex_);
  for (int index = 1;; ++index) {
    if (paced) {
      next = std::max(next + period, steady_clock::now() - period);
      changed_.wait_until(lock, next, [&] { return closing_; });
    }
    changed_.wait(lock, [&] { return closing_ || (BothRun() && (paced || wanted_)); });
    if (closing_) return;
    if (IsSilent(index)) {
      wanted_ = false;
      continue;
    }
    // Unlocked: OpenNI2 calls us with its locks held, and takes them when it gets a frame.
    serving_ = true;
    lock.unlock();
    if (const int owed = std::exchange(owed_color_, 0)) {
      DeliverColor(owed, ImageOf(owed).color);
      --index;  // it has not had its turn
    } else {
      ServeFrame(index);
    }
    lock.lock();
    serving_ = false;
    // Who asked meanwhile waits for the second of the two images.
    wanted_ = false;
    changed_.notify_all();
  }
}

void DriverDevice::ServeFrame(int index) {
  const Image& image = ImageOf(index);
  cv::Mat color = image.color, depth = image.depth;
  if (options_.Has("wrong-size")) {
    cv::resize(color, color, {}, 0.5, 0.5, cv::INTER_NEAREST);
    cv::resize(depth, depth, {}, 0.5, 0.5, cv::INTER_NEAREST);
  }
  depth_->Deliver(depth, index, TimeOf(index), options_.Has("half") && index % 4 == 0);
  if (options_.Has("color-waits")) {
    owed_color_ = index;
    return;
  }
  const bool fourth = index % 4 == 0;
  if (fourth && options_.Has("drop-color")) return;
  if (options_.Has("late-color")) {
    if (fourth) return;
    if (index > 1 && (index - 1) % 4 == 0) {
      // OpenNI2 keeps the newest image only, so each has a turn of its own.
      owed_color_ = index;
      DeliverColor(index - 1, ImageOf(index - 1).color);
      return;
    }
  }
  DeliverColor(index, color);
}

void DriverDevice::DeliverColor(int index, const cv::Mat& color) {
  color_->Deliver(color, index, TimeOf(index) + 500);  // cameras are never exact
}

const DriverDevice::Image& DriverDevice::ImageOf(int index) const {
  return images_[static_cast<std::size_t>(index - 1) % images_.size()];
}

}  // namespace fovea::testing
