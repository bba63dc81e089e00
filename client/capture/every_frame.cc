#include <ostream>
#include <utility>

#include "client/capture/outage_watch.h"
#include "client/capture/session.h"
#include "client/capture/stop_signal.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

// Asks again while the server is away, or has no room and says when to come again.
v1::DetectResponse Ask(const SessionOptions& options, const Session& session,
                       const v1::DetectRequest& request) {
  constexpr std::chrono::minutes kLongestAnswer{1};
  const steady_clock::time_point end = steady_clock::now() + options.patience;
  bool is_away = false;
  while (true) {
    try {
      v1::DetectResponse response = session.client.Detect(request, kLongestAnswer);
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

v1::DetectStreamResponse Answer(const SessionOptions& options, const Session& session,
                                const v1::DetectRequest& request) {
  v1::DetectStreamResponse response;
  response.set_frame_id(request.frame().id());
  try {
    *response.mutable_detections() =
        std::move(*Ask(options, session, request).mutable_detections());
  } catch (const client::RpcError& error) {
    if (error.code() == grpc::StatusCode::UNAVAILABLE) throw;
    response.mutable_error()->set_code(error.code());
    response.mutable_error()->set_message(error.message());
    response.mutable_error()->set_field(error.field());
  }
  return response;
}

}  // namespace

void RunEveryFrame(const SessionOptions& options, const Session& session) {
  Encoder encoder(options.encoding);
  v1::DetectRequest request;
  *request.mutable_options() = options.detection;
  session.results.RequestFor(request.mutable_options());
  while (GoesOn(options, session)) {
    const std::optional<Picture> picture = session.source.Next();
    if (session.viewer != nullptr && !session.viewer->Refresh(picture)) return;
    if (!picture) continue;
    *request.mutable_frame() = MakeFrame(options, *picture, encoder);
    session.tally.Sent(*picture);
    const v1::DetectStreamResponse response = Answer(options, session, request);
    session.tally.Answered(session.tally.Snapshot().sent - 1);
    session.results.Take({*picture, response, 0}, session.tally);
    session.source.SkipWaiting();
  }
    response.mutable_error()->set_request_id(error.request_id());
}

}  // namespace fovea::capture
