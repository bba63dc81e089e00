// Answers the kernel's part of Video4Linux2 for files that stand for video nodes, by taking the
// place of ioctl() in the process that it is loaded into (LD_PRELOAD): open(), mmap(), poll() and
// close() are the real ones. A node named …depth has Z16, one named …color has YUYV.
//
// FOVEA_CAMERA_FRAMES and words of FOVEA_CAMERA_FAULTS are as for the camera of OpenNI2, and
//   no-z16    the depth node has YUYV only
//   busy      another program has the buffers
//   broken    each fourth colour image is marked as broken
//   short     images have half of their bytes
//   gone      the camera is unplugged after the third depth image, and soon plugged in again
//   padded    rows have 64 bytes more than pixels
#include <dlfcn.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "tests/capture/driver_options.h"

namespace fovea::testing {
namespace {

constexpr std::uint32_t kFrame_us = 33'333;

struct Node {
  bool is_depth = false;
  std::uint32_t width = 0, height = 0, row_bytes = 0, sequence = 0;
  std::deque<std::uint32_t> queued;
  std::uint32_t ImageBytes() const { return row_bytes * height; }
};

int Refuse(int reason) {
  errno = reason;
  return -1;
}

std::string PathOf(int fd) {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(fd), error).string();
}

// Of two pixels Y U Y V, by BT.601 as cameras have it. `bgr` has an even width.
cv::Mat YuyvOf(const cv::Mat& bgr) {
  cv::Mat yuyv(bgr.size(), CV_8UC2);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x < bgr.cols; ++x) {
      const auto& first = bgr.at<cv::Vec3b>(y, x / 2 * 2);
      const auto& own = bgr.at<cv::Vec3b>(y, x);
      const double luma = 16 + 0.257 * own[2] + 0.504 * own[1] + 0.098 * own[0];
      const double u = 128 - 0.148 * first[2] - 0.291 * first[1] + 0.439 * first[0];
      const double v = 128 + 0.439 * first[2] - 0.368 * first[1] - 0.071 * first[0];
      yuyv.at<cv::Vec2b>(y, x) = {cv::saturate_cast<std::uint8_t>(luma),
                                  cv::saturate_cast<std::uint8_t>(x % 2 == 0 ? u : v)};
    }
  }
  return yuyv;
}

class Driver {
 public:
  int Answer(int fd, const std::string& path, unsigned long request, void* argument) {
    const std::lock_guard lock(mutex_);
    Node& node = nodes_[path];
    node.is_depth = path.ends_with("depth");
    switch (request) {
      case VIDIOC_QUERYCAP:
        static_cast<v4l2_capability*>(argument)->capabilities =
            V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
        return 0;
      case VIDIOC_ENUM_FMT:
        return EnumerateFormats(*static_cast<v4l2_fmtdesc*>(argument));
      case VIDIOC_S_FMT:
        return SetFormat(node, static_cast<v4l2_format*>(argument)->fmt.pix);
      case VIDIOC_REQBUFS:
        return RequestBuffers(node, fd, *static_cast<v4l2_requestbuffers*>(argument));
      case VIDIOC_QUERYBUF: {
        auto& buffer = *static_cast<v4l2_buffer*>(argument);
        buffer.length = node.ImageBytes();
        buffer.m.offset = OffsetOf(node, buffer.index);
        return 0;
      }
      case VIDIOC_QBUF:
        node.queued.push_back(static_cast<v4l2_buffer*>(argument)->index);
        return 0;
      case VIDIOC_DQBUF:
        return Deliver(node, fd, *static_cast<v4l2_buffer*>(argument));
      case VIDIOC_STREAMON:
      case VIDIOC_STREAMOFF:
        return 0;
      default:
        return Refuse(ENOTTY);  // as drivers without a choice of rates
    }
  }

 private:
  static int EnumerateFormats(v4l2_fmtdesc& format) {
    if (format.index > 0) return Refuse(EINVAL);
    format.pixelformat = V4L2_PIX_FMT_YUYV;
    return 0;
  }

  // Of the size of the frames, whatever is wanted, as drivers choose what is nearest.
  int SetFormat(Node& node, v4l2_pix_format& format) {
    const cv::Mat frame = Frame(0, true);
    node.width = format.width = static_cast<std::uint32_t>(frame.cols);
    node.height = format.height = static_cast<std::uint32_t>(frame.rows);
    node.row_bytes = 2 * node.width + (options_.Has("padded") ? 64 : 0);
    format.bytesperline = node.row_bytes;
    format.sizeimage = node.ImageBytes();
    format.pixelformat =
        node.is_depth && !options_.Has("no-z16") ? V4L2_PIX_FMT_Z16 : V4L2_PIX_FMT_YUYV;
    return 0;
  }

  // Mappings want whole pages.
  static std::uint32_t OffsetOf(const Node& node, std::uint32_t index) {
    constexpr std::uint32_t kPage = 4096;
    return index * ((node.ImageBytes() + kPage - 1) / kPage * kPage);
  }

  int RequestBuffers(Node& node, int fd, const v4l2_requestbuffers& wanted) {
    if (options_.Has("busy")) return Refuse(EBUSY);
    node.queued.clear();
    return ftruncate(fd, OffsetOf(node, wanted.count));
  }

  int Deliver(Node& node, int fd, v4l2_buffer& buffer) {
    constexpr std::uint32_t kLast = 3;
    if (node.queued.empty()) return Refuse(EAGAIN);
    if (options_.Has("gone") && node.is_depth && node.sequence == kLast) {
      ++node.sequence;
      return Refuse(ENODEV);
    }
    buffer.index = node.queued.front();
    node.queued.pop_front();
    const cv::Mat image = Frame(node.sequence, node.is_depth);
    for (std::uint32_t y = 0; y < node.height; ++y) {
      const ssize_t written = pwrite(fd, image.ptr(static_cast<int>(y)), 2UL * node.width,
                                     OffsetOf(node, buffer.index) + y * node.row_bytes);
      if (written != static_cast<ssize_t>(2UL * node.width)) return Refuse(EIO);
    }
    buffer.bytesused = options_.Has("short") ? node.ImageBytes() / 2 : node.ImageBytes();
    const bool broken = options_.Has("broken") && !node.is_depth && node.sequence % 4 == 3;
    buffer.flags = broken ? V4L2_BUF_FLAG_ERROR : 0;
    buffer.sequence = node.sequence++;
    buffer.timestamp = {.tv_sec = 100, .tv_usec = 0};
    buffer.timestamp.tv_sec += buffer.sequence * kFrame_us / 1'000'000;
    buffer.timestamp.tv_usec = buffer.sequence * kFrame_us % 1'000'000;
    return 0;
  }

  cv::Mat Frame(std::uint32_t sequence, bool is_depth) {
    if (depth_.empty()) {
      for (int i = 0;; ++i) {
        const std::string prefix = options_.frames + "/" + std::to_string(i);
        if (!std::filesystem::exists(prefix + "_depth.png")) break;
        depth_.push_back(cv::imread(prefix + "_depth.png", cv::IMREAD_UNCHANGED));
        color_.push_back(YuyvOf(cv::imread(prefix + "_color.png")));
      }
    }
    return (is_depth ? depth_ : color_)[sequence % depth_.size()];
  }

  std::mutex mutex_;
  const DriverOptions options_ = ReadDriverOptions();
  std::map<std::string, Node> nodes_;
  std::vector<cv::Mat> depth_, color_;
};

}  // namespace
}  // namespace fovea::testing

extern "C" int ioctl(int fd, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  const std::string path = fovea::testing::PathOf(fd);
  if (path.ends_with("video-depth") || path.ends_with("video-color")) {
    static fovea::testing::Driver driver;
    return driver.Answer(fd, path, request, argument);
  }
  using Ioctl = int (*)(int, unsigned long, ...);
  static const auto real = reinterpret_cast<Ioctl>(dlsym(RTLD_NEXT, "ioctl"));
  return real(fd, request, argument);
}
