#include "tests/load/robot.h"

#include <algorithm>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "client/cli/report.h"
#include "client/client.h"
#include "tests/load/robot_stream.h"

namespace fovea::load {
namespace {

using Clock = std::chrono::steady_clock;
using Clients = std::vector<std::unique_ptr<client::Client>>;
using std::chrono::milliseconds;

constexpr milliseconds kTimeout{30'000}, kWaitAfterError{1000};

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void Note(const v1::Detections& detections, Clock::time_point sent, Outcome* outcome) {
  const double latency_ms = MillisecondsSince(sent);
  outcome->latency_ms.push_back(latency_ms);
  outcome->overhead_ms.push_back(latency_ms - cli::ServerMs(detections));
}

std::string CodeName(const client::RpcError& error) {
  const std::string text = error.what();
  return text.substr(0, text.find(':'));
}

std::string CodeName(const v1::FrameError& error) {
  const auto code = static_cast<grpc::StatusCode>(error.code());
  return CodeName(client::RpcError({code, error.message()}));
}

// The robot's clock: when the next frame is due.
class Pace {
 public:
  Pace(double rate_hz, double phase) : rate_hz_(rate_hz) {
    if (rate_hz_ > 0) std::this_thread::sleep_until(next_ += Share(phase));
  }

  void Wait() {
    if (rate_hz_ <= 0) return;
    next_ += Share(1);
    // A camera does not make up for frames that nobody took.
    next_ = std::max(next_, Clock::now());
    std::this_thread::sleep_until(next_);
  }

 private:
  // Of the time between two frames.
  Clock::duration Share(double share) const {
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(share / rate_hz_));
  }

  const double rate_hz_;
  Clock::time_point next_ = Clock::now();
};

Outcome CallOneByOne(const Clients& clients, const RobotPlan& plan, const std::stop_token& stop) {
  Outcome outcome;
  v1::DetectRequest request;
  *request.mutable_frame() = plan.frame;
  Outcome not_noted;
  std::size_t turn = 0;
  for (Pace pace(plan.rate_hz, plan.phase); !stop.stop_requested(); pace.Wait()) {
    const Clock::time_point sent = Clock::now();
    Outcome& noted = sent < plan.noted_from ? not_noted : outcome;
    ++noted.sent;
    try {
      const client::Client& client = *clients[turn++ % clients.size()];
      Note(client.Detect(request, kTimeout).detections(), sent, &noted);
    } catch (const client::RpcError& error) {
      ++noted.errors[CodeName(error)];
      noted.refusal_ms.push_back(MillisecondsSince(sent));
      if (plan.rate_hz <= 0)
        std::this_thread::sleep_for(error.retry_after().value_or(kWaitAfterError));
    }
  }
  return outcome;
}

// When each frame was sent, by its place in the stream.
class SendTimes {
 public:
  explicit SendTimes(Clock::time_point noted_from) : noted_from_(noted_from) {}

  void Add() {
    const std::lock_guard lock(mutex_);
    times_.push_back(Clock::now());
    if (times_.back() >= noted_from_) ++num_noted_;
  }
  struct Taken {
    Clock::time_point sent;
    std::uint64_t num_passed = 0;  // noted ones that were sent before it and get no answer
  };
  Taken Take(std::uint64_t sequence) {
    const std::lock_guard lock(mutex_);
    Taken taken;
    for (; first_ < sequence; ++first_) {
      if (times_.front() >= noted_from_) ++taken.num_passed;
      times_.pop_front();
    }
    taken.sent = times_.front();
    times_.pop_front();
    ++first_;
    return taken;
  }
  std::uint64_t NumNoted() {
    const std::lock_guard lock(mutex_);
    return num_noted_;
  }

 private:
  const Clock::time_point noted_from_;
  std::mutex mutex_;
  std::deque<Clock::time_point> times_;
  std::uint64_t first_ = 0;  // sequence of the first of times_
  std::uint64_t num_noted_ = 0;
};

Outcome Stream(const client::Client& client, const RobotPlan& plan, const std::stop_token& stop) {
  Outcome outcome, not_noted;
  SendTimes times(plan.noted_from);
  RobotStream stream(client, /*resuming=*/plan.retry);
  std::jthread sender([&] {
    v1::DetectStreamRequest request;
    *request.mutable_frame() = plan.frame;
    for (Pace pace(plan.rate_hz > 0 ? plan.rate_hz : 30, plan.phase); !stop.stop_requested();
         pace.Wait()) {
      times.Add();
      if (!stream.Send(request)) break;
    }
    stream.DoneSending();
  });
  try {
    while (const auto answer = stream.Receive()) {
      const v1::DetectStreamResponse& response = answer->response;
      const auto [sent, num_passed] = times.Take(response.sequence());
      Outcome& noted = sent < plan.noted_from ? not_noted : outcome;
      // Those that were lost were sent before those that the new connection dropped.
      const std::uint64_t dropped = std::min<std::uint64_t>(response.dropped(), num_passed);
      noted.dropped += dropped;
      noted.lost += std::min(answer->lost, num_passed - dropped);
      if (response.has_detections()) {
        Note(response.detections(), sent, &noted);
      } else {
        ++noted.errors[CodeName(response.error())];
      }
    }
  } catch (const client::RpcError& error) {
    ++outcome.errors[CodeName(error)];
  }
  sender.join();
  outcome.sent = times.NumNoted();
  return outcome;
}

Outcome CallAtOnce(const Clients& clients, const RobotPlan& plan, const std::stop_token& stop) {
  std::vector<std::future<Outcome>> callers;
  callers.reserve(static_cast<std::size_t>(plan.calls_at_once));
  for (int i = 0; i < plan.calls_at_once; ++i) {
    callers.push_back(std::async(std::launch::async, CallOneByOne, std::cref(clients),
                                 std::cref(plan), std::cref(stop)));
  }
  std::vector<Outcome> outcomes;
  outcomes.reserve(callers.size());
  for (auto& caller : callers) outcomes.push_back(caller.get());
  return Sum(outcomes);
}

void Append(const std::vector<double>& from, std::vector<double>* to) {
  to->insert(to->end(), from.begin(), from.end());
}

}  // namespace

Outcome Sum(const std::vector<Outcome>& outcomes) {
  Outcome all;
  for (const Outcome& one : outcomes) {
    all.sent += one.sent;
    all.dropped += one.dropped;
    all.lost += one.lost;
    Append(one.latency_ms, &all.latency_ms);
    Append(one.overhead_ms, &all.overhead_ms);
    Append(one.refusal_ms, &all.refusal_ms);
    for (const auto& [code, count] : one.errors) all.errors[code] += count;
  }
  return all;
}

void WaitForServers(const std::vector<RobotPlan>& plans) {
  std::set<std::string> servers;
  for (const RobotPlan& plan : plans) servers.insert(plan.servers.begin(), plan.servers.end());
  for (const std::string& server : servers) client::Client(server).WaitUntilReady(kTimeout);
}

Outcome RunRobot(const RobotPlan& plan, const std::stop_token& stop) {
  client::ClientOptions options;
  options.robot = plan.name;
  if (!plan.retry) options.retry.max_attempts = 1;  // refusals are to be seen
  Clients clients;
  for (const std::string& server : plan.servers) {
    clients.push_back(std::make_unique<client::Client>(server, options));
    clients.back()->WaitUntilReady(kTimeout);
  }
  Outcome outcome =
      plan.stream ? Stream(*clients.front(), plan, stop) : CallAtOnce(clients, plan, stop);
  outcome.role = plan.role;
  return outcome;
}

}  // namespace fovea::load
