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

// With numbers and lists that are 0 or empty, "objects": [] and "y": 0 too.
std::string WholeJson(const google::protobuf::Message& message, JsonLayout layout) {
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  return ToJson(message, layout, options);
}

// Part by part: a Frame as a whole would have what is not said of it here, such as its images.
std::string JsonOfSent(const v1::Frame& frame, JsonLayout layout) {
  std::string parts;
  const auto add = [&](const char* name, bool is_there, const google::protobuf::Message& part) {
    if (!is_there) return;
    parts += std::string(parts.empty() ? "\"" : ",\"") + name + "\":" + WholeJson(part, layout);
  };
  add("intrinsics", frame.has_intrinsics(), frame.intrinsics());
  add("gravity", frame.has_gravity(), frame.gravity());
  add("camera_pose", frame.has_camera_pose(), frame.camera_pose());
  add("depth_intrinsics", frame.has_depth_intrinsics(), frame.depth_intrinsics());
  add("color_from_depth", frame.has_color_from_depth(), frame.color_from_depth());
  if (frame.depth().unit_m() != 0) {
    v1::DepthImage unit;
    unit.set_unit_m(frame.depth().unit_m());
    parts += std::string(parts.empty() ? "" : ",") + "\"depth\":" + ToJson(unit, layout);
  }
  return "{" + parts + "}";
}

}  // namespace

std::string ToJson(const google::protobuf::Message& message, JsonLayout layout) {
  return ToJson(message, layout, {});
}

std::string ToJson(const v1::Detections& detections, const v1::Frame& frame, JsonLayout layout) {
  const std::string answer = WholeJson(detections, layout);
  const std::string head = "{\"frame\":" + JsonOfSent(frame, layout);
  // Both are objects; the answer's fields go on where the frame's ended.
  const std::size_t first = answer.find('"');
  return first == std::string::npos ? head + "}" : head + "," + answer.substr(1);
}

}  // namespace fovea::cli
