#include "tests/load/saboteur.h"

#include <array>
#include <chrono>
#include <functional>
#include <random>
#include <thread>
#include <utility>

#include "client/client.h"
#include "tests/load/raw_connection.h"

namespace fovea::load {
namespace {

using std::chrono::milliseconds;

class Saboteur {
 public:
  Saboteur(std::string server, const v1::Frame& frame, unsigned seed)
      : server_(std::move(server)), frame_(frame), random_(seed) {}

  // Does one thing; returns its name.
  std::string Act() {
    struct Deed {
      const char* name;
      void (Saboteur::*act)();
    };
    constexpr std::array kDeeds{
        Deed{"calls without time", &Saboteur::CallWithoutTime},
        Deed{"damaged frames", &Saboteur::SendDamagedFrame},
        Deed{"damaged frames in a stream", &Saboteur::StreamDamagedFrames},
        Deed{"streams given up", &Saboteur::GiveUpStream},
        Deed{"streams without a reader", &Saboteur::StreamWithoutReading},
        Deed{"noise on a connection", &Saboteur::SendNoise},
        Deed{"connections without a word", &Saboteur::ConnectOnly},
    };
    const Deed& deed = kDeeds[static_cast<std::size_t>(Below(kDeeds.size()))];
    try {
      (this->*deed.act)();
    } catch (const std::runtime_error&) {  // NOLINT(bugprone-empty-catch): refusal is the aim
    }
    return deed.name;
  }

 private:
  int Below(std::size_t end) {
    return std::uniform_int_distribution<int>(0, static_cast<int>(end) - 1)(random_);
  }

  // A new connection each time.
  client::Client Connect() const {
    client::ClientOptions options;
    options.robot = "saboteur";
    options.retry.max_attempts = 1;
    return client::Client(server_, options);
  }

  v1::Frame DamagedFrame() {
    v1::Frame frame = frame_;
    switch (Below(6)) {
      case 0:
        frame.clear_depth();
        break;
      case 1:
        frame.mutable_color()->mutable_data()->resize(Below(1000));
        break;
      case 2:
        frame.mutable_intrinsics()->set_fx(-1);
        break;
      case 3:
        frame.mutable_depth()->set_width(100'000);
        break;
      case 4:
        frame.mutable_color()->set_encoding(v1::COLOR_ENCODING_PNG);
        break;
      default:
        frame.mutable_depth()->set_encoding(v1::DEPTH_ENCODING_16UC1_ZSTD);
    }
    return frame;
  }

  void CallWithoutTime() {
    v1::DetectRequest request;
    *request.mutable_frame() = frame_;
    Connect().Detect(request, milliseconds(1 + Below(100)));
  }

  void SendDamagedFrame() {
    v1::DetectRequest request;
    *request.mutable_frame() = DamagedFrame();
    Connect().Detect(request, milliseconds(5000));
  }

  void StreamDamagedFrames() {
    const auto stream = Connect().OpenStream(milliseconds(20'000));
    v1::DetectStreamRequest request;
    for (int i = 0; i < 10; ++i) {
      *request.mutable_frame() = i % 3 == 0 ? frame_ : DamagedFrame();
      if (!stream->Send(request)) break;
    }
    stream->DoneSending();
    while (stream->Receive()) {
    }
  }

  void GiveUpStream() {
    const auto stream = Connect().OpenStream(milliseconds(20'000));
    v1::DetectStreamRequest request;
    *request.mutable_frame() = frame_;
    for (int i = Below(4); i >= 0; --i) stream->Send(request);
    if (Below(2) == 0) stream->Receive();
  }  // the destructor cancels

  void StreamWithoutReading() {
    const auto stream = Connect().OpenStream(milliseconds(300));
    v1::DetectStreamRequest request;
    *request.mutable_frame() = frame_;
    while (stream->Send(request)) {
    }
  }

  void SendNoise() {
    RawConnection connection(server_);
    std::string noise(static_cast<std::size_t>(Below(5000)), '\0');
    for (char& byte : noise) byte = static_cast<char>(Below(256));
    // Half of them begin as HTTP/2 does.
    connection.Send((Below(2) == 0 ? "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" : "") + noise);
  }

  void ConnectOnly() {
    const RawConnection connection(server_);
    std::this_thread::sleep_for(milliseconds(Below(500)));
  }

  const std::string server_;
  const v1::Frame& frame_;
  std::minstd_rand random_;
};

}  // namespace

std::map<std::string, std::uint64_t> RunSaboteur(const std::string& server, const v1::Frame& frame,
                                                 unsigned seed, const std::stop_token& stop) {
  Saboteur saboteur(server, frame, seed);
  std::map<std::string, std::uint64_t> deeds;
  while (!stop.stop_requested()) ++deeds[saboteur.Act()];
  return deeds;
}

}  // namespace fovea::load
