#include "server/conversion/trace.h"

#include <bit>
#include <cstdint>
#include <opencv2/core.hpp>

#include "core/segmentation/labels.h"
#include "server/conversion/geometry.h"

namespace fovea::server {
namespace {

// Images are sent as they lie in memory.
static_assert(std::endian::native == std::endian::little);

v1::SeedSource SourceToProto(Seed::Source source) {
  switch (source) {
    case Seed::Source::kColorSaliency:
      return v1::SEED_SOURCE_COLOR_SALIENCY;
    case Seed::Source::kDepthSaliency:
      return v1::SEED_SOURCE_DEPTH_SALIENCY;
    case Seed::Source::kUnexplainedRegion:
      return v1::SEED_SOURCE_UNEXPLAINED_REGION;
  }
  return v1::SEED_SOURCE_UNSPECIFIED;
}

v1::Seed SeedToProto(const Seed& seed) {
  v1::Seed proto;
  proto.set_x(static_cast<std::uint32_t>(seed.pixel.x));
  proto.set_y(static_cast<std::uint32_t>(seed.pixel.y));
  *proto.mutable_position() = ToProto(seed.position);
  proto.set_source(SourceToProto(seed.source));
  return proto;
}

v1::SaliencyMap SaliencyToProto(const char* name, const cv::Mat& saliency) {
  cv::Mat bytes;
  cv::normalize(saliency, bytes, 0, 255, cv::NORM_MINMAX, CV_8U);
  v1::SaliencyMap proto;
  proto.set_name(name);
  proto.set_width(static_cast<std::uint32_t>(bytes.cols));
  proto.set_height(static_cast<std::uint32_t>(bytes.rows));
  proto.set_data(bytes.data, bytes.total());
  return proto;
}

v1::RemovedSeed SeedToProto(const RemovedSeed& seed) {
  v1::RemovedSeed proto;
  proto.set_x(static_cast<std::uint32_t>(seed.pixel.x));
  proto.set_y(static_cast<std::uint32_t>(seed.pixel.y));
  proto.set_source(SourceToProto(seed.source));
  proto.set_reason(seed.reason == RemovedSeed::Reason::kWithoutDepth
                       ? v1::SEED_REMOVAL_WITHOUT_DEPTH
                       : v1::SEED_REMOVAL_ON_SUPPORT);
  return proto;
}

// CV_16UC1, into a message with the size and the bytes of an image.
template <typename Image>
void SetImage(const cv::Mat& pixels, Image* image) {
  image->set_width(static_cast<std::uint32_t>(pixels.cols));
  image->set_height(static_cast<std::uint32_t>(pixels.rows));
  image->set_data(pixels.data, pixels.total() * pixels.elemSize());
}

v1::DepthImage DepthToProto(const cv::Mat& depth_m) {
  cv::Mat known = depth_m.clone(), millimetres;
  known.setTo(0, ~(depth_m == depth_m));  // NaN
  known.convertTo(millimetres, CV_16U, 1000);
  v1::DepthImage proto;
  proto.set_encoding(v1::DEPTH_ENCODING_16UC1);
  proto.set_unit_m(0.001);
  SetImage(millimetres, &proto);
  return proto;
}

v1::Trace StepsToProto(const Trace& trace) {
  v1::Trace proto;
  *proto.mutable_filled_depth() = DepthToProto(trace.depth_m);
  proto.set_gamma_per_m2(trace.gamma_per_m2);
  for (const Seed& seed : trace.seeds) *proto.add_seeds() = SeedToProto(seed);
  for (const RemovedSeed& seed : trace.removed) *proto.add_removed_seeds() = SeedToProto(seed);
  SetImage(LabelImage(trace.voxels, trace.labels), proto.mutable_hypotheses());
  SetImage(LabelImage(trace.voxels, trace.segments), proto.mutable_segments());
  SetImage(LabelImage(trace.voxels, trace.merged), proto.mutable_merged());
  return proto;
}

}  // namespace

bool WantsTrace(const v1::DetectOptions& options) {
  return options.return_saliency_maps() || options.return_seeds() || options.return_trace();
}

void AddTrace(const Trace& trace, const v1::DetectOptions& options, v1::Detections* proto) {
  if (options.return_saliency_maps() || options.return_trace()) {
    // A frame without anything to look at has no maps.
    if (!trace.color_saliency.empty()) {
      *proto->add_saliency_maps() = SaliencyToProto("color", trace.color_saliency);
    }
    if (!trace.depth_saliency.empty()) {
      *proto->add_saliency_maps() = SaliencyToProto("depth", trace.depth_saliency);
    }
  }
  if (options.return_seeds()) {
    for (const Seed& seed : trace.seeds) *proto->add_seeds() = SeedToProto(seed);
  }
  if (options.return_trace()) *proto->mutable_trace() = StepsToProto(trace);
}

}  // namespace fovea::server
