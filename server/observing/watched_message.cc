#include "server/observing/watched_message.h"

#include <google/protobuf/util/time_util.h>

#include <utility>

#include "core/trace.h"
#include "server/conversion/detections.h"
#include "server/error_details.h"
#include "server/observing/pictures.h"

namespace fovea::server {
namespace {

using google::protobuf::util::TimeUtil;

v1::FrameError ErrorOf(const grpc::Status& status) {
  v1::FrameError error;
  error.set_code(status.error_code());
  error.set_message(status.error_message());
  error.set_field(FieldOf(status));
  return error;
}

v1::Detections AnswerOf(const Sight& sight) {
  v1::DetectOptions options = sight.options;
  options.set_return_masks(true);
  options.set_return_rejected(true);
  options.set_return_clouds(false);
  // These come from the answer that the robot got; the detector's own are not kept.
  options.set_return_seeds(false);
  options.set_return_saliency_maps(false);
  options.set_return_trace(false);
  v1::Detections answer = ToProto(sight.detections, Trace{}, sight.frame, options);
  answer.MergeFrom(sight.extras);
  return answer;
}

// What lists of robots show.
v1::Detections SummaryOf(const Sight& sight) {
  v1::Detections summary;
  summary.set_frame_id(sight.frame.id());
  summary.set_incomplete(sight.detections.incomplete);
  for (const std::string& message : sight.detections.diagnostics.messages) {
    summary.mutable_diagnostics()->add_messages(message);
  }
  for (const StageTime& time : sight.detections.stage_times) {
    *summary.add_stage_times() = ToProto(time);
  }
  return summary;
}

template <typename Value, typename Make>
const Value& Once(std::optional<Value>& value, Make make) {
  if (!value) value = make();
  return *value;
}

}  // namespace

grpc::Slice WatchedMessages::With(WatchParts parts) {
  v1::WatchResponse response;
  v1::WatchedFrame& frame = *response.mutable_frame();
  frame = Base();
  const auto wants = [&](v1::WatchPart part) { return (parts & Bit(part)) != 0; };
  if (sight_.status.ok()) AddAnswer(wants(v1::WATCH_PART_ANSWER), &frame);
  AddPictures(parts, &frame);
  if (wants(v1::WATCH_PART_FRAME)) {
    *frame.mutable_frame() = sight_.frame;
    if (sight_.answer && sight_.status.ok()) *frame.mutable_answer() = *sight_.answer;
  }
  return {response.SerializeAsString()};
}

v1::WatchedFrame WatchedMessages::Base() const {
  v1::WatchedFrame frame;
  frame.set_robot(sight_.robot);
  frame.set_sequence(sight_.sequence);
  frame.set_frame_id(sight_.frame.id());
  *frame.mutable_answered_at() = TimeUtil::NanosecondsToTimestamp(
      std::chrono::nanoseconds(sight_.answered_at.time_since_epoch()).count());
  *frame.mutable_took() =
      TimeUtil::NanosecondsToDuration(std::chrono::nanoseconds(sight_.took).count());
  frame.set_num_objects(static_cast<std::uint32_t>(sight_.detections.objects.size()));
  frame.set_is_problem(sight_.IsProblem());
  *frame.mutable_options() = sight_.options;
  if (sight_.frame.has_intrinsics()) *frame.mutable_intrinsics() = sight_.frame.intrinsics();
  if (!sight_.status.ok()) *frame.mutable_error() = ErrorOf(sight_.status);
  return frame;
}

void WatchedMessages::AddAnswer(bool whole, v1::WatchedFrame* frame) {
  *frame->mutable_detections() =
      whole ? Once(answer_, [&] { return AnswerOf(sight_); }) : SummaryOf(sight_);
}

void WatchedMessages::AddPictures(WatchParts parts, v1::WatchedFrame* frame) {
  if (sight_.decoded.depth_m.empty()) return;  // refused before it was known to be an image
  const v1::ColorImage& color = sight_.frame.color();
  const auto wants = [&](v1::WatchPart part) { return (parts & Bit(part)) != 0; };
  if (wants(v1::WATCH_PART_PREVIEW)) {
    frame->set_preview(Once(preview_, [&] { return PreviewOf(color, max_pixels_); }));
  }
  if (wants(v1::WATCH_PART_PICTURE)) {
    frame->set_picture(Once(picture_, [&] { return PictureOf(color, max_pixels_); }));
  }
  if (wants(v1::WATCH_PART_DEPTH)) {
    *frame->mutable_depth() = Once(depth_, [&] { return DepthOf(sight_.decoded); });
  }
}

}  // namespace fovea::server
