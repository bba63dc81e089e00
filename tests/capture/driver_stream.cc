#include "tests/capture/driver_stream.h"

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>
#include <utility>

namespace fovea::testing {
namespace {

// Of the camera of the generated scenes: 525 px for a width of 640 px.
constexpr double kFocalLengthOverWidth = 525.0 / 640;

template <typename Value>
OniStatus Give(const Value& value, void* data, int* size) {
  if (*size < static_cast<int>(sizeof value)) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(data, &value, sizeof value);
  *size = sizeof value;
  return ONI_STATUS_OK;
}

template <typename Value>
OniStatus Take(const void* data, int size, Value* value) {
  if (size != static_cast<int>(sizeof *value)) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(value, data, sizeof *value);
  return ONI_STATUS_OK;
}

float Angle(double extent, double width) {
  return static_cast<float>(2 * std::atan(extent / 2 / (kFocalLengthOverWidth * width)));
}

}  // namespace

DriverStream::DriverStream(OniSensorType type, const OniVideoMode& mode,
                           std::function<void()> on_start)
    : type_(type), mode_(mode), on_start_(std::move(on_start)) {}

OniStatus DriverStream::start() {
  running_ = true;
  on_start_();
  return ONI_STATUS_OK;
}

void DriverStream::stop() {
  running_ = false;
  on_start_();
}

OniStatus DriverStream::getProperty(int id, void* data, int* size) {
  switch (id) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return Give(mode_, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
      return Give(Angle(mode_.resolutionX, mode_.resolutionX), data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
      return Give(Angle(mode_.resolutionY, mode_.resolutionX), data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return Give(mirrored_, data, size);
    // Recordings of streams without these two play back nothing.
    case ONI_STREAM_PROPERTY_CROPPING:
      return Give(OniCropping{}, data, size);
    case ONI_STREAM_PROPERTY_STRIDE:
      return Give(mode_.resolutionX * (type_ == ONI_SENSOR_COLOR ? 3 : 2), data, size);
    case ONI_STREAM_PROPERTY_MIN_VALUE:
      return Give(0, data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE:
      return Give(10'000, data, size);
    default:
      return ONI_STATUS_NOT_SUPPORTED;
  }
}

OniStatus DriverStream::setProperty(int id, const void* data, int size) {
  switch (id) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return Take(data, size, &mode_);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return Take(data, size, &mirrored_);
    default:
      return ONI_STATUS_NOT_SUPPORTED;
  }
}

OniBool DriverStream::isPropertySupported(int id) {
  return (id >= ONI_STREAM_PROPERTY_CROPPING && id <= ONI_STREAM_PROPERTY_MIRRORING) ? TRUE : FALSE;
}

void DriverStream::Deliver(const cv::Mat& image, int index, std::uint64_t time_us, bool only_half) {
  OniFrame* frame = getServices().acquireFrame();
  if (frame == nullptr) return;
  frame->sensorType = type_;
  frame->frameIndex = index;
  frame->timestamp = time_us;
  frame->videoMode = mode_;
  frame->width = image.cols;
  frame->height = image.rows;
  frame->croppingEnabled = FALSE;
  frame->cropOriginX = frame->cropOriginY = 0;
  frame->stride = static_cast<int>(image.step);
  frame->dataSize = static_cast<int>(image.total() * image.elemSize());
  cv::Mat out(image.size(), image.type(), frame->data);
  mirrored_ != 0 ? cv::flip(image, out, 1) : image.copyTo(out);
  if (only_half) {
    frame->dataSize /= 2;
    out.rowRange(image.rows / 2, image.rows).setTo(0);
  }
  raiseNewFrame(frame);
  getServices().releaseFrame(frame);
}

}  // namespace fovea::testing
