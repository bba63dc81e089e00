#include "server/connections/self_check.h"

#include <grpcpp/client_context.h>
#include <grpcpp/create_channel_posix.h>
#include <netinet/in.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>

#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "grpc/health/v1/health.grpc.pb.h"
#include "server/connections/socket_address.h"

namespace fovea::server {
namespace {

constexpr std::chrono::seconds kTimeout{5};
constexpr int kMaxFailures = 3;

// A socket with a name of its own, by which the door will know it.
FileDescriptor SocketFor(const SocketAddress& to) {
  FileDescriptor fd(socket(to.family(), SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!fd) throw std::runtime_error(std::string("no socket: ") + std::strerror(errno));
  const int for_both = 0;  // it may be an IPv4 address that is mapped
  setsockopt(fd.get(), IPPROTO_IPV6, IPV6_V6ONLY, &for_both, sizeof for_both);
  const SocketAddress from = to.WithAnyPort();
  if (bind(fd.get(), from.get(), from.size()) != 0) {
    throw std::runtime_error(std::string("no socket: ") + std::strerror(errno));
  }
  return fd;
}

void AskForHealth(FileDescriptor connection) {
  namespace health = grpc::health::v1;
  const auto channel = grpc::CreateInsecureChannelFromFd("self-check", connection.Release());
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kTimeout);
  health::HealthCheckResponse response;
  const grpc::Status status = health::Health::NewStub(channel)->Check(&context, {}, &response);
  if (!status.ok()) throw std::runtime_error(status.error_message());
}

}  // namespace

SelfCheck::SelfCheck(Door& door, std::chrono::seconds period, Listener listener)
    : door_(door),
      period_(period),
      listener_(std::move(listener)),
      thread_([this](const std::stop_token& stop) { Run(stop); }) {}

void SelfCheck::Run(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  do {
    try {
      Check();
      failures_ = 0;
      listener_.on_answer();
    } catch (const std::exception& error) {
      spdlog::error("the server does not answer itself: {}", error.what());
      if (++failures_ == kMaxFailures) listener_.on_failure(error.what());
    }
  } while (!never.wait_for(lock, stop, period_, [&] { return stop.stop_requested(); }));
}

void SelfCheck::Check() {
  const SocketAddress to = SocketAddress::Local(door_.listening().front().fd()).OrLoopback();
  FileDescriptor fd = SocketFor(to);
  door_.Announce(SocketAddress::Local(fd.get()).Uri());
  if (connect(fd.get(), to.get(), to.size()) != 0 && errno != EINPROGRESS) {
    throw std::runtime_error(std::string("cannot connect: ") + std::strerror(errno));
  }
  AskForHealth(std::move(fd));
}

}  // namespace fovea::server
