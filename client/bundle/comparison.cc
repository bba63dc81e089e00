#include "client/bundle/comparison.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <algorithm>

#include "client/bundle/shown.h"

namespace fovea::bundle {
namespace {

void LeaveOutTracks(v1::Detections* answer) {
  answer->clear_track_epoch();
  answer->clear_camera_motion();
  answer->clear_hidden_tracks();
  for (v1::Object& object : *answer->mutable_objects()) {
    object.clear_track_id();
    object.clear_first_seen();
    object.clear_times_seen();
    object.clear_steadied_box();
    object.clear_steadied_over();
    object.clear_moving();
  }
}

std::string Count(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string ServerOf(const v1::Detections& answer) {
  return Shown(answer.server_version()) + " (" + Shown(answer.server_build()) + ")";
}

}  // namespace

v1::Detections Comparable(v1::Detections answer, const v1::DetectOptions& asked, bool with_times) {
  if (!with_times) answer.clear_stage_times();
  if (!asked.return_rejected()) answer.clear_rejected();
  if (!asked.return_seeds()) answer.clear_seeds();
  if (!asked.return_saliency_maps() && !asked.return_trace()) answer.clear_saliency_maps();
  if (!asked.return_trace()) answer.clear_trace();
  if (!asked.planning().has_height_map()) answer.clear_height_map();
  const bool with_collisions = asked.planning().collision_primitives();
  if (!with_collisions) answer.clear_support_collisions();
  for (v1::Object& object : *answer.mutable_objects()) {
    if (!asked.return_masks()) object.clear_mask();
    if (!asked.return_clouds()) object.clear_cloud();
    if (!with_collisions) object.clear_collision();
  }
  LeaveOutTracks(&answer);
  return answer;
}

std::string BytesOf(const v1::Detections& answer) {
  std::string bytes;
  {
    google::protobuf::io::StringOutputStream stream(&bytes);
    google::protobuf::io::CodedOutputStream coded(&stream);
    coded.SetSerializationDeterministic(true);
    answer.SerializeToCodedStream(&coded);
  }
  return bytes;
}

std::string CompareAnswers(const v1::Detections& then, const v1::Detections& now,
                           const v1::DetectOptions& asked) {
  v1::Detections before = Comparable(then, asked, /*with_times=*/false);
  v1::Detections after = Comparable(now, asked, /*with_times=*/false);
  if (BytesOf(before) == BytesOf(after)) return "the same answer as then";
  const std::string versions = ServerOf(before) + " then, " + ServerOf(after) + " now";
  for (v1::Detections* each : {&before, &after}) {
    each->clear_server_version();
    each->clear_server_build();
  }
  if (BytesOf(before) == BytesOf(after)) return "the same answer as then, by server " + versions;
  const std::string counts = Count(before.objects_size(), "object") + " then, " +
                             std::to_string(after.objects_size()) + " now";
  return "another answer than then: " + counts + "; server " + versions;
}

}  // namespace fovea::bundle
