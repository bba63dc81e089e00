#include "client/cli/json.h"

#include <google/protobuf/util/json_util.h>

#include <stdexcept>

namespace fovea::cli {

namespace {

std::string ToJson(const google::protobuf::Message& message, JsonLayout layout,
                   google::protobuf::util::JsonPrintOptions options) {
  options.add_whitespace = layout == JsonLayout::kIndented;
  options.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(message, &json, options);
  if (!status.ok()) throw std::runtime_error("the answer cannot be written as JSON");
  return json;
}

}  // namespace

std::string ToJson(const google::protobuf::Message& message, JsonLayout layout) {
  return ToJson(message, layout, {});
}

std::string ToJson(const v1::Detections& detections, const v1::Frame& frame, JsonLayout layout) {
  v1::Frame sent;
  if (frame.has_intrinsics()) *sent.mutable_intrinsics() = frame.intrinsics();
  if (frame.has_gravity()) *sent.mutable_gravity() = frame.gravity();
  if (frame.has_camera_pose()) *sent.mutable_camera_pose() = frame.camera_pose();
  if (frame.has_depth_intrinsics()) *sent.mutable_depth_intrinsics() = frame.depth_intrinsics();
  if (frame.has_color_from_depth()) *sent.mutable_color_from_depth() = frame.color_from_depth();
  if (frame.depth().unit_m() != 0) sent.mutable_depth()->set_unit_m(frame.depth().unit_m());
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;  // "objects": [] and "y": 0 too
  const std::string answer = ToJson(detections, layout, options);
  const std::string head = "{\"frame\":" + ToJson(sent, layout);
  // Both are objects; the answer's fields go on where the frame's ended.
  const std::size_t first = answer.find('"');
  return first == std::string::npos ? head + "}" : head + "," + answer.substr(1);
}

}  // namespace fovea::cli
