#include <functional>
#include <optional>
#include <ostream>
#include <stop_token>
#include <thread>
#include <utility>

#include "client/capture/outage_watch.h"
#include "client/capture/session.h"
#include "client/capture/stop_signal.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

// Ends the call under way where its answer is not there some time after a stop was asked for.
void StopLate(const std::stop_token& over, const Session& session, std::stop_source& call) {
  constexpr std::chrono::milliseconds kBetweenLooks{20};
  while (!StopAskedWithin(kBetweenLooks)) {
    if (over.stop_requested()) return;
  }
  if (!AwaitLastAnswers(session, [&over] { return over.stop_requested(); })) call.request_stop();
}

// Asks again while the server is away, or has no room and says when to come again.
v1::DetectResponse Ask(const SessionOptions& options, const Session& session,
                       const v1::DetectRequest& request, const std::stop_token& stop) {
  constexpr std::chrono::minutes kLongestAnswer{1};
  const steady_clock::time_point end = steady_clock::now() + options.patience;
  bool is_away = false;
  while (true) {
    try {
      v1::DetectResponse response = session.client.Detect(request, kLongestAnswer, {.stop = stop});
      if (is_away) session.notes << BackNote(options.server) << std::flush;
      return response;
    } catch (const client::RpcError& error) {
      const auto wait = error.retry_after().value_or(std::chrono::milliseconds(0));
      const bool unavailable = error.code() == grpc::StatusCode::UNAVAILABLE;
      const bool too_late = steady_clock::now() + wait >= end;
      if ((!unavailable && !error.retry_after()) || too_late) throw;
      if (unavailable && !std::exchange(is_away, true)) {
        session.notes << AwayNote(options.server) << std::flush;
      }
      if (StopAskedWithin(wait)) throw;
    }
  }
}

// None where it was stopped.
std::optional<v1::DetectStreamResponse> Answer(const SessionOptions& options,
                                               const Session& session,
                                               const v1::DetectRequest& request,
                                               const std::stop_token& stop) {
  v1::DetectStreamResponse response;
  response.set_frame_id(request.frame().id());
  try {
    *response.mutable_detections() =
        std::move(*Ask(options, session, request, stop).mutable_detections());
  } catch (const client::RpcError& error) {
    if (stop.stop_requested()) return std::nullopt;
    if (error.code() == grpc::StatusCode::UNAVAILABLE) throw;
    response.mutable_error()->set_code(error.code());
    response.mutable_error()->set_message(error.message());
    response.mutable_error()->set_field(error.field());
    response.mutable_error()->set_request_id(error.request_id());
  }
  return response;
}

}  // namespace

void RunEveryFrame(const SessionOptions& options, const Session& session) {
  Encoder encoder(options.encoding);
  v1::DetectRequest request;
  *request.mutable_options() = options.detection;
  session.results.RequestFor(request.mutable_options());
  std::stop_source call;
  const std::jthread stopping(StopLate, std::cref(session), std::ref(call));
  while (GoesOn(options, session)) {
    const std::optional<Picture> picture = session.source.Next();
    if (session.viewer != nullptr && !session.viewer->Refresh(picture)) return;
    if (!picture) continue;
    *request.mutable_frame() = MakeFrame(options, *picture, encoder);
    session.tally.Sent(*picture);
    const auto response = Answer(options, session, request, call.get_token());
    if (!response) {
      session.notes << "the last answer did not come in time" << std::endl;
      return;
    }
    session.tally.Answered(session.tally.Snapshot().sent - 1);
    session.results.Take({*picture, *response, 0}, session.tally);
    session.source.SkipWaiting();
  }
}

}  // namespace fovea::capture
