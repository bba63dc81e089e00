#include "client/observer/board_json.h"

#include <google/protobuf/util/time_util.h>

#include "client/observer/json_text.h"

namespace fovea::observer {
namespace {

using google::protobuf::util::TimeUtil;
using nlohmann::json;

double Milliseconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(TimeUtil::DurationToMicroseconds(duration)) / 1000;
}

json StagesOf(const v1::Detections& detections) {
  json stages = json::object();
  for (const v1::StageTime& time : detections.stage_times()) {
    stages[time.stage()] = Milliseconds(time.duration());
  }
  return stages;
}

const char* NameOf(LinkState::Kind kind) {
  switch (kind) {
    case LinkState::Kind::kConnecting:
      return "connecting";
    case LinkState::Kind::kWatching:
      return "watching";
    case LinkState::Kind::kAway:
      return "away";
    case LinkState::Kind::kRefused:
      return "refused";
  }
  return "";
}

const char* NameOf(int right) {
  switch (right) {
    case v1::OBSERVER_RIGHT_VIEW:
      return "view";
    case v1::OBSERVER_RIGHT_TRY:
      return "try";
    case v1::OBSERVER_RIGHT_DOWNLOAD:
      return "download";
    case v1::OBSERVER_RIGHT_PICK:
      return "pick";
    default:
      return "unknown";
  }
}

}  // namespace

json ServerJson(const std::string& address, const LinkState& state, const v1::Observer* observer) {
  return {{"address", address},
          {"state", NameOf(state.kind)},
          {"problem", state.problem},
          {"version", observer != nullptr ? observer->server_version() : ""}};
}

json RobotJson(const ShownFrame& shown, double rate_hz) {
  const v1::WatchedFrame& frame = shown.frame;
  json robot{{"robot", frame.robot()},
             {"id", shown.id},
             {"frame_id", frame.frame_id()},
             {"answered_at_ms", TimeUtil::TimestampToMilliseconds(frame.answered_at())},
             {"came_at_us", shown.came_at_us},
             {"took_ms", Milliseconds(frame.took())},
             {"rate_hz", rate_hz},
             {"objects", frame.num_objects()},
             {"problem", frame.is_problem()},
             {"has_picture", !frame.preview().empty() || !frame.picture().empty()},
             {"stages", StagesOf(frame.detections())}};
  json reasons = json::array();
  if (frame.has_error()) reasons.push_back(frame.error().message());
  if (frame.detections().incomplete()) reasons.push_back("the time budget ended early");
  for (const std::string& text : frame.detections().diagnostics().messages()) {
    reasons.push_back(text);
  }
  robot["reasons"] = std::move(reasons);
  return robot;
}

json ObserverJson(const v1::Observer& observer) {
  json rights = json::array();
  for (const int right : observer.rights()) rights.push_back(NameOf(right));
  return {{"name", observer.name()},
          {"rights", std::move(rights)},
          {"robots", std::vector<std::string>(observer.robots().begin(), observer.robots().end())}};
}

std::string FrameJson(const ShownFrame& shown) {
  v1::WatchedFrame frame = shown.frame;
  frame.clear_preview();
  frame.clear_picture();
  frame.clear_frame();
  frame.clear_answer();
  frame.mutable_depth()->clear_data();
  if (!shown.frame.has_depth()) frame.clear_depth();
  return JsonText(frame);
}

}  // namespace fovea::observer
