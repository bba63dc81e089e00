#include "client/observer/history/recorder.h"

#include <exception>
#include <iostream>
#include <utility>

namespace fovea::observer {
namespace {

v1::WatchRequest RequestOf(double rate_hz) {
  v1::WatchRequest request;
  request.set_max_rate_hz(rate_hz);
  for (const v1::WatchPart part : {v1::WATCH_PART_ANSWER, v1::WATCH_PART_PICTURE,
                                   v1::WATCH_PART_DEPTH, v1::WATCH_PART_FRAME}) {
    request.add_parts(part);
  }
  return request;
}

}  // namespace

Recorder::Recorder(const std::vector<ServerLink>& servers, const std::string& token, double rate_hz,
                   History& history)
    : history_(history) {
  for (const ServerLink& server : servers) servers_.push_back({.address = server.address});
  for (std::size_t i = 0; i < servers.size(); ++i) {
    streams_.push_back(
        std::make_unique<WatchStream>(servers[i], token, RequestOf(rate_hz), ListenerOf(i)));
  }
}

WatchStream::Listener Recorder::ListenerOf(std::size_t server) {
  return {.on_observer =
              [this, server](const v1::Observer& observer) {
                const std::lock_guard lock(mutex_);
                servers_[server].version = observer.server_version();
              },
          .on_frame =
              [this, server](v1::WatchResponse response) {
                OnFrame(server, std::move(*response.mutable_frame()));
              },
          .on_state =
              [this, server](const LinkState& state) {
                const std::lock_guard lock(mutex_);
                const std::string text =
                    state.kind == LinkState::Kind::kRefused ? state.problem : "";
                Say(&servers_[server].problem,
                    text.empty() ? "" : servers_[server].address + ": " + text);
              }};
}

// Aloud where it is new; mutex_ is held.
void Recorder::Say(std::string* where, const std::string& problem, const char* if_none) {
  if (*where == problem) return;
  *where = problem;
  std::cerr << "fovea-observer: history: " << (problem.empty() ? if_none : problem) << std::endl;
}

void Recorder::OnFrame(std::size_t server, v1::WatchedFrame frame) {
  HistoryRecord record;
  {
    const std::lock_guard lock(mutex_);
    record.header = {.robot = frame.robot(),
                     .server = servers_[server].address,
                     .version = servers_[server].version,
                     .objects = frame.num_objects(),
                     .problem = frame.is_problem()};
  }
  // The same file twice would take twice the room.
  if (frame.frame().color().encoding() == v1::COLOR_ENCODING_JPEG) frame.clear_picture();
  record.frame = std::move(frame);
  std::string problem;
  try {
    history_.Add(record, std::chrono::system_clock::now());
  } catch (const std::exception& error) {
    problem = error.what();
  }
  const std::lock_guard lock(mutex_);
  Say(&disk_problem_, problem);
  Say(&shortage_, history_.Shortage(), "holds --history-minutes again");
}

std::string Recorder::Problem() const {
  const std::lock_guard lock(mutex_);
  if (!disk_problem_.empty()) return disk_problem_;
  for (const Server& server : servers_) {
    if (!server.problem.empty()) return server.problem;
  }
  return {};
}

}  // namespace fovea::observer
