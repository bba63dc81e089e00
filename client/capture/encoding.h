#pragma once

#include <memory>
#include <string>

#include "client/capture/picture.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::capture {

struct EncodingOptions {
  v1::ColorEncoding color = v1::COLOR_ENCODING_JPEG;  // or RGB8
  int jpeg_quality = 90;                              // 1 … 100
};

// "jpeg" or "rgb8"; throws std::invalid_argument for other names.
v1::ColorEncoding ParseColorEncoding(const std::string& name);

// Pictures as they travel: depth without loss (zstd), colour as chosen. Keeps its buffers; one
// thread at a time. About 3 ms for 640x480.
class Encoder {
 public:
  explicit Encoder(const EncodingOptions& options);
  ~Encoder();

  // Everything but the intrinsics.
  v1::Frame Encode(const Picture& picture);

 private:
  struct Codecs;

  v1::ColorImage EncodeColor(const cv::Mat& color);
  v1::DepthImage EncodeDepth(const cv::Mat& depth, double unit_m);

  const EncodingOptions options_;
  const std::unique_ptr<Codecs> codecs_;
};

// "000042".
std::string FrameName(std::uint64_t number);

}  // namespace fovea::capture
