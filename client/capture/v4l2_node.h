// One video node of the kernel (Video4Linux2), such as UVC cameras have: /dev/video0.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace fovea::capture {

enum class V4l2Format { kDepth, kColor };  // Z16: 16 bits a pixel; YUYV: 8 bits, twice a pixel

class V4l2Node {
 public:
  struct Image {
    cv::Mat pixels;  // CV_16UC1 or CV_8UC2, the caller's; empty where the driver says it is broken
    std::uint64_t time_us = 0;   // by a clock that all nodes of the machine share
    std::uint32_t sequence = 0;  // gaps are images that were missed
  };

  // Opens the node and lets it stream images of that size; throws CameraError where it does not
  // exist, is in use, or has another format, size or rate.
  V4l2Node(const std::string& path, V4l2Format format, const cv::Size& size, int fps);
  ~V4l2Node();

  V4l2Node(const V4l2Node&) = delete;
  V4l2Node& operator=(const V4l2Node&) = delete;

  int fd() const { return fd_; }
  const std::string& path() const { return path_; }

  // Without waiting: none where no image is there. Throws CameraLost where the camera is gone.
  std::optional<Image> Take();
  // What the kernel's buffers hold is not taken; it keeps the oldest images and drops newer ones.
  void Skip();

 private:
  struct Buffer {
    void* data = nullptr;
    std::size_t size = 0;
  };

  V4l2Node(const std::string& path, V4l2Format format, const cv::Size& size);  // opens nothing

  void Open();
  void SetFormat(const cv::Size& size);
  void SetRate(int fps);
  void MapBuffers();
  void Queue(std::uint32_t index);
  std::string Offered() const;
  [[noreturn]] void Fail(const std::string& what) const;

  const std::string path_;
  const V4l2Format format_;
  int fd_ = -1;
  cv::Size size_;
  std::size_t row_bytes_ = 0;
  std::vector<Buffer> buffers_;
};

}  // namespace fovea::capture
