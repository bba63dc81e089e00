#include "client/cli/patient_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "client/cli/progress.h"

namespace fovea::cli {
namespace {

bool IsSilence(const client::RpcError& error) {
  return error.code() == grpc::StatusCode::DEADLINE_EXCEEDED;
}

}  // namespace

void PatientServer::Await() {
  std::string why = "the server does not serve yet";
  try {
    is_there_ = client_.IsServing();
    if (is_there_) return;
  } catch (const client::RpcError& error) {
    if (error.code() != grpc::StatusCode::UNAVAILABLE) return;  // the first frame tells
    why = explain_(error);
  }
  PrintNote(why + fmt::format("; it is waited for, {} s at most", timeout_.count() / 1000.0));
  try {
    client_.WaitUntilReady(timeout_);
  } catch (const client::RpcError&) {
    throw std::runtime_error(why);
  }
  is_there_ = true;
}

std::size_t PatientServer::MostAtOnce(std::optional<int> wanted) const {
  constexpr std::uint32_t kUsual = 4;
  if (wanted) return static_cast<std::size_t>(*wanted);
  try {
    const std::uint32_t most = client_.GetServerInfo().max_per_robot();
    return most == 0 ? kUsual : std::min(most, kUsual);
  } catch (const client::RpcError&) {
    return kUsual;  // the frames tell what is wrong
  }
}

v1::DetectResponse PatientServer::Ask(const v1::DetectRequest& request) {
  using std::chrono::steady_clock;
  RequireLife();
  RequireServer();
  const steady_clock::time_point end = steady_clock::now() + timeout_;
  while (true) {
    try {
      v1::DetectResponse response = client_.Detect(
          request,
          std::chrono::duration_cast<std::chrono::milliseconds>(end - steady_clock::now()));
      is_there_ = true;
      num_unanswered_ = 0;
      return response;
    } catch (const client::RpcError& error) {
      CountSilence(error);
      const auto pause = PauseAfter(error);
      if (!pause || steady_clock::now() + *pause >= end) {
        if (error.code() == grpc::StatusCode::UNAVAILABLE) is_there_ = false;
        throw;
      }
      std::this_thread::sleep_for(*pause);
    }
  }
}

std::optional<std::chrono::milliseconds> PatientServer::PauseAfter(
    const client::RpcError& error) const {
  constexpr std::chrono::milliseconds kBetween{500};
  if (error.code() == grpc::StatusCode::RESOURCE_EXHAUSTED) return error.retry_after();
  if (error.code() == grpc::StatusCode::UNAVAILABLE && is_there_) return kBetween;
  return std::nullopt;
}

void PatientServer::CountSilence(const client::RpcError& error) {
  if (IsSilence(error)) {
    ++num_unanswered_;
  } else if (error.code() != grpc::StatusCode::UNAVAILABLE) {
    num_unanswered_ = 0;  // the server says no
  }
}

// Where a frame has waited in vain, those after it do not: one attempt tells.
void PatientServer::RequireServer() const {
  if (is_there_) return;
  try {
    client_.IsServing();
  } catch (const client::RpcError& error) {
    if (error.code() == grpc::StatusCode::UNAVAILABLE) throw;
  }
}

// Where several frames in turn have waited for their whole time, all that are left would: the
// server has that time once more for a word. Else the frames are too much for it, and each has its
// own.
void PatientServer::RequireLife() {
  constexpr int kMostUnanswered = 3;
  const int unanswered = num_unanswered_;
  if (unanswered < kMostUnanswered) return;
  try {
    client_.WaitUntilReady(timeout_);
    num_unanswered_ = 0;
  } catch (const client::RpcError& error) {
    if (!IsSilence(error)) return;
    throw ServerHangs(fmt::format(
        "the server hangs: {} frames in turn had no answer, and it does not say whether it serves",
        unanswered));
  }
}

}  // namespace fovea::cli
