#include "client/capture/v4l2_node.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "client/capture/camera_error.h"

namespace fovea::capture {
namespace {

constexpr std::uint32_t kNumBuffers = 4;
constexpr auto kCapture = static_cast<std::uint32_t>(V4L2_BUF_TYPE_VIDEO_CAPTURE);

// Goes on after signals. Returns whether it worked; else errno says why.
template <typename Argument>
bool Control(int fd, unsigned long request, Argument* argument) {
  int result = 0;
  do {
    result = ioctl(fd, request, argument);
  } while (result == -1 && errno == EINTR);
  return result != -1;
}

std::uint32_t CodeOf(V4l2Format format) {
  return format == V4l2Format::kDepth ? V4L2_PIX_FMT_Z16 : V4L2_PIX_FMT_YUYV;
}

std::string NameOf(std::uint32_t code) {
  std::string name;
  for (int i = 0; i < 4; ++i) {
    const auto letter = static_cast<char>(code >> 8 * i & 0x7F);
    name += letter >= ' ' && letter < 0x7F ? letter : '?';
  }
  name.erase(name.find_last_not_of(' ') + 1);
  return name;
}

v4l2_buffer BufferOf(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = kCapture;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

}  // namespace

V4l2Node::V4l2Node(const std::string& path, V4l2Format format, const cv::Size& size)
    : path_(path), format_(format), size_(size) {}

// By way of the other one, so that the destructor closes what has been opened before something
// fails.
V4l2Node::V4l2Node(const std::string& path, V4l2Format format, const cv::Size& size, int fps)
    : V4l2Node(path, format, size) {
  Open();
  SetFormat(size);
  SetRate(fps);
  MapBuffers();
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (!Control(fd_, VIDIOC_STREAMON, &type)) Fail("does not start");
}

V4l2Node::~V4l2Node() {
  if (fd_ == -1) return;
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  Control(fd_, VIDIOC_STREAMOFF, &type);
  for (const Buffer& buffer : buffers_) munmap(buffer.data, buffer.size);
  close(fd_);
}

void V4l2Node::Fail(const std::string& what) const {
  throw CameraError("v4l2: " + path_ + " " + what + ": " + std::strerror(errno));
}

void V4l2Node::Open() {
  fd_ = open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (fd_ == -1) {
    const bool denied = errno == EACCES || errno == EPERM;
    Fail(denied ? "may not be opened (its group is video)" : "cannot be opened");
  }
  v4l2_capability capability{};
  if (!Control(fd_, VIDIOC_QUERYCAP, &capability)) Fail("is no video device");
  const std::uint32_t can = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0
                                ? capability.device_caps
                                : capability.capabilities;
  constexpr std::uint32_t kNeeded = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  if ((can & kNeeded) == kNeeded) return;
  throw CameraError("v4l2: " + path_ +
                    " delivers no images; each camera has several nodes, see "
                    "v4l2-ctl --list-devices");
}

// The names of its formats.
std::string V4l2Node::Offered() const {
  constexpr std::uint32_t kMost = 64;
  std::string names;
  for (std::uint32_t i = 0; i < kMost; ++i) {
    v4l2_fmtdesc format{};
    format.type = kCapture;
    format.index = i;
    if (!Control(fd_, VIDIOC_ENUM_FMT, &format)) break;
    names += (names.empty() ? "" : ", ") + NameOf(format.pixelformat);
  }
  return names.empty() ? "none" : names;
}

void V4l2Node::SetFormat(const cv::Size& size) {
  v4l2_format format{};
  format.type = kCapture;
  format.fmt.pix.width = static_cast<std::uint32_t>(size.width);
  format.fmt.pix.height = static_cast<std::uint32_t>(size.height);
  format.fmt.pix.pixelformat = CodeOf(format_);
  format.fmt.pix.field = V4L2_FIELD_NONE;
  if (!Control(fd_, VIDIOC_S_FMT, &format)) Fail("takes no format");
  const v4l2_pix_format& got = format.fmt.pix;
  if (got.pixelformat != CodeOf(format_)) {
    throw CameraError(fmt::format("v4l2: {} has no {} ({}); it has: {}", path_,
                                  NameOf(CodeOf(format_)),
                                  format_ == V4l2Format::kDepth ? "depth" : "colour", Offered()));
  }
  if (cv::Size(static_cast<int>(got.width), static_cast<int>(got.height)) != size) {
    throw CameraError(fmt::format("v4l2: {} has no {}x{}; nearest is {}x{}", path_, size.width,
                                  size.height, got.width, got.height));
  }
  constexpr std::uint32_t kPixelBytes = 2;
  row_bytes_ = std::max(got.bytesperline, kPixelBytes * got.width);
}

// Drivers without the call have one rate.
void V4l2Node::SetRate(int fps) {
  v4l2_streamparm parameters{};
  parameters.type = kCapture;
  parameters.parm.capture.timeperframe = {1, static_cast<std::uint32_t>(fps)};
  if (!Control(fd_, VIDIOC_S_PARM, &parameters)) {
    if (errno == ENOTTY || errno == EINVAL) return;
    Fail("is in use or takes no rate");
  }
  const v4l2_fract& got = parameters.parm.capture.timeperframe;
  if (got.denominator == static_cast<std::uint64_t>(fps) * got.numerator) return;
  throw CameraError(
      fmt::format("v4l2: {} has no {} frames a second at this size; nearest is {:g}", path_, fps,
                  got.numerator == 0 ? 0.0 : double(got.denominator) / got.numerator));
}

void V4l2Node::MapBuffers() {
  v4l2_requestbuffers wanted{};
  wanted.count = kNumBuffers;
  wanted.type = kCapture;
  wanted.memory = V4L2_MEMORY_MMAP;
  if (!Control(fd_, VIDIOC_REQBUFS, &wanted)) {
    Fail(errno == EBUSY ? "is used by another program" : "has no buffers");
  }
  for (std::uint32_t i = 0; i < wanted.count; ++i) {
    v4l2_buffer buffer = BufferOf(i);
    if (!Control(fd_, VIDIOC_QUERYBUF, &buffer)) Fail("has no buffer");
    void* data = mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, fd_,
                      static_cast<off_t>(buffer.m.offset));
    if (data == MAP_FAILED) Fail("cannot be mapped");
    buffers_.push_back({data, buffer.length});
    Queue(i);
  }
  if (buffers_.empty()) throw CameraError("v4l2: " + path_ + " has no buffers");
}

void V4l2Node::Queue(std::uint32_t index) {
  v4l2_buffer buffer = BufferOf(index);
  if (!Control(fd_, VIDIOC_QBUF, &buffer)) Fail("takes no buffer");
}

std::optional<V4l2Node::Image> V4l2Node::Take() {
  v4l2_buffer buffer = BufferOf(0);
  if (!Control(fd_, VIDIOC_DQBUF, &buffer)) {
    if (errno == EAGAIN) return std::nullopt;
    throw CameraLost("the camera at " + path_ + " is gone: " + std::strerror(errno));
  }
  if (buffer.index >= buffers_.size()) throw CameraError("v4l2: " + path_ + " has no such buffer");
  Image image;
  constexpr std::uint64_t kMicroseconds = 1'000'000;
  image.time_us = static_cast<std::uint64_t>(buffer.timestamp.tv_sec) * kMicroseconds +
                  static_cast<std::uint64_t>(buffer.timestamp.tv_usec);
  image.sequence = buffer.sequence;
  const Buffer& mapped = buffers_[buffer.index];
  const std::size_t needed = row_bytes_ * static_cast<std::size_t>(size_.height);
  const bool whole = (buffer.flags & V4L2_BUF_FLAG_ERROR) == 0 && buffer.bytesused >= needed &&
                     mapped.size >= needed;
  if (whole) {
    const int type = format_ == V4l2Format::kDepth ? CV_16UC1 : CV_8UC2;
    image.pixels = cv::Mat(size_, type, mapped.data, row_bytes_).clone();
  }
  Queue(buffer.index);
  return image;
}

void V4l2Node::Skip() {
  for (std::size_t i = 0; i < buffers_.size() && Take(); ++i) {
  }
}

}  // namespace fovea::capture
