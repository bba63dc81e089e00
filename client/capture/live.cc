#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <ostream>
#include <thread>
#include <utility>

#include "client/capture/latest.h"
#include "client/capture/outage_watch.h"
#include "client/capture/session.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::hours kWholeLife{24 * 365};

// The first error of several threads; the others are its consequences.
class FirstError {
 public:
  void Guard(const std::function<void()>& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      failed_ = true;
    }
  }
  bool Failed() const { return failed_; }
  void Rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
  std::atomic<bool> failed_ = false;
};

// What the three threads share: the caller's takes pictures, one sends them, one receives.
struct Line {
  const SessionOptions& options;
  const Session& session;
  const std::unique_ptr<client::ResumingStream> stream;
  OutageWatch outage;
  Latest<Picture> outbox;
  FirstError error;
};

// Where nothing is drawn, only the times are kept until the answer comes.
Picture ForAnswer(const Picture& picture, bool draws) {
  Picture kept = picture;
  if (!draws) kept.color = kept.depth = cv::Mat();
  return kept;
}

void SendAll(Line& line) {
  Encoder encoder(line.options.encoding);
  v1::DetectStreamRequest request;
  *request.mutable_options() = line.options.detection;
  line.session.results.RequestFor(request.mutable_options());
  const bool draws = request.options().return_masks();
  while (const auto picture = line.outbox.Take()) {
    *request.mutable_frame() = MakeFrame(line.options, *picture, encoder);
    line.session.tally.Sent(ForAnswer(*picture, draws));
    line.outage.Sending(steady_clock::now());
    const bool was_taken = line.stream->Send(request);
    line.outage.Sent(was_taken);
    if (!was_taken) line.session.tally.NotSent();
    request.clear_options();  // they hold for the frames after
  }
  line.stream->DoneSending();
}

void ReceiveAll(Line& line) {
  while (auto answer = line.stream->Receive()) {
    const std::uint64_t sequence = answer->response.sequence();
    line.outage.Answered(sequence, steady_clock::now());
    auto picture = line.session.tally.Answered(sequence);
    if (!picture) throw std::runtime_error("the server answered a frame that was not sent");
    line.session.results.Take({std::move(*picture), std::move(answer->response), answer->lost},
                              line.session.tally);
  }
}

void TakePictures(Line& line) {
  const Session& session = line.session;
  while (GoesOn(line.options, session) && !line.error.Failed()) {
    std::optional<Picture> picture = session.source.Next();
    session.notes << line.outage.Take(steady_clock::now()) << std::flush;
    if (session.viewer != nullptr && !session.viewer->Refresh(picture)) return;
    if (picture && line.outbox.Put(std::move(*picture))) session.tally.Replaced();
  }
}

// A server that goes away with the last answers fails no run: the summary counts them among the
// lost, as those of connections that broke before.
void NoteLostAnswers(const Line& line) {
  try {
    line.error.Rethrow();
  } catch (const client::RpcError& error) {
    const bool is_away = error.code() == grpc::StatusCode::UNAVAILABLE ||
                         error.code() == grpc::StatusCode::CANCELLED;
    if (!is_away) throw;
    line.session.notes << "the last answers were lost: " << error.message() << std::endl;
  }
}

}  // namespace

void RunLive(const SessionOptions& options, const Session& session) {
  Line line{
      options, session, session.client.OpenResumingStream(kWholeLife), OutageWatch(options.server),
      {},      {}};
  const auto guarded = [&line](void (*work)(Line&)) {
    return [&line, work] { line.error.Guard([&] { work(line); }); };
  };
  const auto sending = std::async(std::launch::async, guarded(SendAll));
  const auto receiving = std::async(std::launch::async, guarded(ReceiveAll));
  guarded(TakePictures)();
  line.outbox.Close();
  const bool went_well = !line.error.Failed();
  if (!went_well) line.stream->Cancel();
  const bool in_time = AwaitLastAnswers(session, [&receiving] {
    return receiving.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  const bool failed = line.error.Failed();
  if (!in_time) {
    session.notes << "the last answers did not come in time" << std::endl;
    line.stream->Cancel();
  }
  receiving.wait();
  sending.wait();
  if (!failed) return;  // or only because it was cancelled
  went_well ? NoteLostAnswers(line) : line.error.Rethrow();
}

}  // namespace fovea::capture
