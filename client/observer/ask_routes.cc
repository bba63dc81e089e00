#include "client/observer/ask_routes.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "client/bundle/changed_options.h"
#include "client/observer/json_text.h"
#include "client/observer/server_calls.h"

namespace fovea::observer {
namespace {

using nlohmann::json;

constexpr int kMaxAsked = 4;  // at once; each holds a thread

// In the server's own words.
HttpResponse RefusalOf(const grpc::Status& status) {
  const auto code = [&] {
    switch (status.error_code()) {
      case grpc::StatusCode::INVALID_ARGUMENT:
        return 400;
      case grpc::StatusCode::UNAUTHENTICATED:
      case grpc::StatusCode::PERMISSION_DENIED:
        return 403;
      case grpc::StatusCode::FAILED_PRECONDITION:
        return 409;
      case grpc::StatusCode::RESOURCE_EXHAUSTED:
        return 429;
      case grpc::StatusCode::UNIMPLEMENTED:
        return 501;
      case grpc::StatusCode::UNAVAILABLE:
        return 503;
      case grpc::StatusCode::DEADLINE_EXCEEDED:
        return 504;
      default:
        return 502;
    }
  };
  return ErrorResponse(code(), status.error_message());
}

const ServerLink* LinkOf(const Feed& feed, const std::string& address) {
  const auto found = std::ranges::find(feed.servers(), address, &ServerLink::address);
  return found == feed.servers().end() ? nullptr : &*found;
}

// What the page asks for, as it comes: none where it is no such object.
struct Asked {
  std::string robot = {};
  std::uint64_t id = 0;
  bool past = false;
  std::uint32_t label = 0;
  std::string options = {};  // as JSON of DetectOptions
};

std::optional<Asked> AskedIn(const std::string& body) {
  const json asked = json::parse(body, nullptr, /*allow_exceptions=*/false);
  const auto is_number = [&](const char* name) {
    return !asked.contains(name) || asked[name].is_number_unsigned();
  };
  if (!asked.is_object() || !is_number("id") || !is_number("label")) return std::nullopt;
  try {
    return Asked{.robot = asked.at("robot").get<std::string>(),
                 .id = asked.at("id").get<std::uint64_t>(),
                 .past = asked.value("past", false),
                 .label = asked.value("label", std::uint32_t{0}),
                 .options = asked.value("options", json::object()).dump()};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

// What the robot asked for, with what is shown of it, and the changes.
google::protobuf::util::Status SetOptions(const v1::DetectOptions& sent, const std::string& changes,
                                          v1::DetectOptions* options) {
  v1::DetectOptions parsed;
  const auto status = google::protobuf::util::JsonStringToMessage(changes, &parsed);
  if (!status.ok()) return status;
  *options = sent;
  bundle::ChangeOptions(parsed, options);
  options->clear_time_budget();
  options->set_return_masks(true);
  options->set_return_rejected(true);
  options->set_return_clouds(false);
  options->set_return_trace(false);
  return status;
}

}  // namespace

bool AskRoutes::IsOne(const std::string& path) {
  return path == "/api/options" || path == "/api/try" || path == "/api/pick";
}

HttpResponse AskRoutes::Answer(const HttpRequest& request, Feed& feed) {
  if (end_.stop_requested()) return ErrorResponse(503, "the observer ends");
  if (num_asked_.fetch_add(1) >= kMaxAsked) {
    --num_asked_;
    return ErrorResponse(429, "others ask already; try again");
  }
  const std::shared_ptr<void> done(nullptr, [this](void*) { --num_asked_; });
  const bool is_post = request.method == "POST";
  if (request.path == "/api/options") return is_post ? NotFound() : Options(request, feed);
  if (!is_post) return NotFound();
  return request.path == "/api/try" ? TryFrame(request, feed) : Pick(request, feed);
}

std::optional<AskRoutes::Named> AskRoutes::Find(const std::string& robot, std::uint64_t id,
                                                bool past, const Board& board,
                                                v1::ObserverRight right) const {
  if (past) {
    auto record = history_.Find(robot, id, board, right);
    if (!record) return std::nullopt;
    return Named{.server = record->header.server, .frame = std::move(record->frame)};
  }
  const ShownFramePtr shown = board.FrameToPickFrom(robot, id);
  if (!shown) return std::nullopt;
  const std::string& address = board.AddressOf(shown->server);
  if (!board.MayDo(address, robot, right)) return std::nullopt;
  return Named{.server = address, .frame = shown->frame};
}

HttpResponse AskRoutes::Options(const HttpRequest& request, Feed& feed) const {
  const auto id = NumberOf(request.Query("id"));
  const auto named =
      id ? Find(request.Query("robot"), *id, /*past=*/true, feed.board(), v1::OBSERVER_RIGHT_TRY)
         : std::nullopt;
  const ServerLink* const link = named ? LinkOf(feed, named->server) : nullptr;
  if (link == nullptr) return NotFound();
  v1::ListOptionsResponse options;
  const grpc::Status status = ListOptions(*link, feed.token(), &options, end_.get_token());
  return status.ok() ? BytesResponse("application/json", JsonText(options)) : RefusalOf(status);
}

HttpResponse AskRoutes::TryFrame(const HttpRequest& request, Feed& feed) const {
  const auto asked = AskedIn(request.body);
  if (!asked) return ErrorResponse(400, "the request is malformed");
  auto named = Find(asked->robot, asked->id, /*past=*/true, feed.board(), v1::OBSERVER_RIGHT_TRY);
  const ServerLink* const link = named ? LinkOf(feed, named->server) : nullptr;
  if (link == nullptr) return NotFound();
  v1::TryRequest trial;
  trial.set_robot(asked->robot);
  trial.mutable_frame()->Swap(named->frame.mutable_frame());
  if (!asked->options.starts_with('{')) return ErrorResponse(400, "options: must be an object");
  const auto parsed = SetOptions(named->frame.options(), asked->options, trial.mutable_options());
  if (!parsed.ok()) return ErrorResponse(400, "options: " + std::string(parsed.message()));
  v1::TryResponse response;
  const grpc::Status status = Try(*link, feed.token(), trial, &response, end_.get_token());
  return status.ok() ? BytesResponse("application/json", JsonText(response)) : RefusalOf(status);
}

HttpResponse AskRoutes::Pick(const HttpRequest& request, Feed& feed) const {
  const auto asked = AskedIn(request.body);
  if (!asked) return ErrorResponse(400, "the request is malformed");
  const auto named =
      Find(asked->robot, asked->id, asked->past, feed.board(), v1::OBSERVER_RIGHT_PICK);
  const ServerLink* const link = named ? LinkOf(feed, named->server) : nullptr;
  if (link == nullptr) return NotFound();
  const auto& objects = named->frame.detections().objects();
  const auto object = std::ranges::find(objects, asked->label, &v1::Object::label);
  if (object == objects.end()) return ErrorResponse(404, "the frame has no such object");
  v1::SelectObjectRequest selection;
  selection.set_robot(asked->robot);
  v1::Pick& pick = *selection.mutable_pick();
  pick.set_frame_id(named->frame.frame_id());
  *pick.mutable_answered_at() = named->frame.answered_at();
  pick.set_label(object->label());
  pick.set_track_id(object->track_id());
  *pick.mutable_oriented_box() = object->oriented_box();
  v1::SelectObjectResponse response;
  const grpc::Status status =
      SelectObject(*link, feed.token(), selection, &response, end_.get_token());
  return status.ok() ? BytesResponse("application/json", JsonText(response)) : RefusalOf(status);
}

}  // namespace fovea::observer
