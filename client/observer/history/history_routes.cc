#include "client/observer/history/history_routes.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "client/observer/board_json.h"
#include "client/observer/exif.h"
#include "client/observer/history/bundling.h"
#include "client/observer/history/past.h"
#include "client/observer/json_text.h"

namespace fovea::observer {
namespace {

using nlohmann::json;

constexpr const char* kPath = "/api/history";
constexpr const char* kRetryAfterSeconds = "5";

HttpResponse AnswerResponse(std::uint64_t id, const v1::WatchedFrame& frame) {
  ShownFrame shown{.id = id, .came_at_us = id};
  shown.frame = frame;
  return BytesResponse("application/json",
                       "{\"line\":" + JsonText(RobotJson(shown, /*rate_hz=*/0)) +
                           ",\"frame\":" + FrameJson(shown) + "}");
}

// Held while a bundle is made and sent; null where somebody holds it.
std::shared_ptr<void> TakeTicket(const std::shared_ptr<std::atomic<bool>>& is_out) {
  if (is_out->exchange(true)) return nullptr;
  return {is_out.get(), [is_out](void*) { *is_out = false; }};
}

HttpResponse BusyResponse() {
  HttpResponse response =
      ErrorResponse(429, "somebody saves a bundle already, and there is one at a time; try again");
  response.headers.emplace_back("Retry-After", kRetryAfterSeconds);
  return response;
}

// What is sent keeps the ticket until it has been sent, or cannot be.
HttpResponse FileResponse(BundleFile file, std::shared_ptr<void> ticket) {
  struct Sent {
    std::shared_ptr<void> ticket;
    std::string bytes;
  };
  const auto sent =
      std::make_shared<Sent>(Sent{.ticket = std::move(ticket), .bytes = std::move(file.bytes)});
  return {.type = "application/zip",
          .body = {sent, &sent->bytes},
          .headers = {{"Content-Disposition", "attachment; filename=\"" + file.name + "\""},
                      {"Fovea-Answered-At-Ms", std::to_string(file.answered_at.count())}}};
}

}  // namespace

bool HistoryRoutes::IsOne(const std::string& path) {
  return path == kPath || path.starts_with(std::string(kPath) + "/");
}

std::string HistoryRoutes::About() const {
  if (history_ == nullptr) return "null";
  const auto minutes = std::chrono::duration<double, std::ratio<60>>(history_->limits().span);
  return JsonText(json{{"minutes", minutes.count()},
                       {"problem", recorder_->Problem()},
                       {"shortage", history_->Shortage()}});
}

HttpResponse HistoryRoutes::Answer(const HttpRequest& request, const Board& board) const {
  if (history_ == nullptr) return NotFound();
  if (request.path == kPath) return List(request.Query("robot"), board);
  if (request.path == std::string(kPath) + "/bundle") return Bundle(request, board);
  return OfFrame(request, board);
}

HttpResponse HistoryRoutes::List(const std::string& robot, const Board& board) const {
  const auto entries = history_->List(robot, [&](const std::string& server) {
    return board.MayDo(server, robot, v1::OBSERVER_RIGHT_VIEW);
  });
  json ids = json::array(), objects = json::array(), problems = json::array();
  for (const History::Entry& entry : entries) {
    ids.push_back(entry.id);
    objects.push_back(entry.objects);
    problems.push_back(entry.problem ? 1 : 0);
  }
  json list = json::parse(About());
  list["ids"] = std::move(ids);
  list["objects"] = std::move(objects);
  list["problems"] = std::move(problems);
  return BytesResponse("application/json", JsonText(list));
}

std::optional<HistoryRecord> HistoryRoutes::Find(const std::string& robot, std::uint64_t id,
                                                 const Board& board,
                                                 v1::ObserverRight right) const {
  if (history_ == nullptr) return std::nullopt;
  std::optional<HistoryRecord> record = history_->Read(robot, id);
  if (!record || !board.MayDo(record->header.server, robot, right)) return std::nullopt;
  return record;
}

HttpResponse HistoryRoutes::OfFrame(const HttpRequest& request, const Board& board) const {
  const auto id = NumberOf(request.Query("id"));
  if (!id) return NotFound();
  const auto record = Find(request.Query("robot"), *id, board, v1::OBSERVER_RIGHT_VIEW);
  if (!record) return NotFound();
  const v1::WatchedFrame& frame = record->frame;
  const std::string part = request.path.substr(std::string(kPath).size());
  if (part == "/answer") return AnswerResponse(*id, frame);
  if (part == "/picture" && !PictureOf(frame).empty()) {
    return BytesResponse("image/jpeg", WithoutExif(PictureOf(frame)));
  }
  if (part == "/depth" && frame.has_depth()) {
    HttpResponse response = BytesResponse("application/octet-stream", frame.depth().data());
    response.headers.emplace_back("Content-Encoding", "gzip");
    return response;
  }
  return NotFound();
}

HttpResponse HistoryRoutes::Bundle(const HttpRequest& request, const Board& board) const {
  const std::string robot = request.Query("robot");
  const auto moment = MomentOf(request);
  if (!moment) {
    return ErrorResponse(400,
                         "at: must be a time in microseconds since 1970, and before and "
                         "after seconds up to 600");
  }
  const auto entries = history_->List(robot, [&](const std::string& server) {
    return board.MayDo(server, robot, v1::OBSERVER_RIGHT_DOWNLOAD);
  });
  if (entries.empty()) return NotFound();
  auto ticket = TakeTicket(bundle_is_out_);
  if (!ticket) return BusyResponse();
  auto file = BundleOf(*history_, robot, entries, *moment);
  return file ? FileResponse(std::move(*file), std::move(ticket)) : NotFound();
}

}  // namespace fovea::observer
