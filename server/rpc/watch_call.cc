#include "server/rpc/watch_call.h"

#include <google/protobuf/util/time_util.h>

#include <utility>

#include "server/build_info.h"
#include "server/rpc/parse.h"
#include "server/status.h"
#include "server/until_it_works.h"
#include "server/watching/request_log.h"

namespace fovea::server {
namespace {

v1::Observer ObserverToProto(const ObserverEntry& observer) {
  v1::Observer proto;
  proto.set_name(observer.name);
  for (const std::string& robot : observer.robots) proto.add_robots(robot);
  const auto add = [&](bool has, v1::ObserverRight right) {
    if (has) proto.add_rights(right);
  };
  add(observer.rights.view, v1::OBSERVER_RIGHT_VIEW);
  add(observer.rights.try_, v1::OBSERVER_RIGHT_TRY);
  add(observer.rights.download, v1::OBSERVER_RIGHT_DOWNLOAD);
  add(observer.rights.pick, v1::OBSERVER_RIGHT_PICK);
  if (observer.expires != std::chrono::sys_seconds::max()) {
    proto.mutable_expires()->set_seconds(observer.expires.time_since_epoch().count());
  }
  proto.set_server_version(Version());
  return proto;
}

bool IsSame(const ObserverEntry& one, const ObserverEntry& other) {
  return ObserverToProto(one).SerializeAsString() == ObserverToProto(other).SerializeAsString();
}

}  // namespace

void WatchCall::Accept(const ObservationEnvironment& environment) {
  const auto call = std::make_shared<WatchCall>(environment);
  environment.service.RequestWatch(&call->context_, &call->bytes_, &call->stream_,
                                   environment.queue, environment.queue,
                                   Then([call, &environment](bool ok) {
                                     if (!ok) return;  // the server stops
                                     UntilItWorks([&] { Accept(environment); });
                                     call->caller_.Guard([&] { call->OnRequest(); });
                                   }));
}

WatchCall::WatchCall(const ObservationEnvironment& environment)
    : environment_(environment),
      token_(environment.live_calls.Enter()),
      caller_(&context_, environment.connections, environment.live_calls),
      transfer_(&context_, environment.queue, environment.max_transfer, environment.unsent) {}

WatchCall::~WatchCall() = default;

void WatchCall::OnRequest() {
  caller_.Begin([self = shared_from_this()] { self->End(self->caller_.StatusOfGone()); });
  try {
    Open();
  } catch (...) {
    End(StatusOfCurrentException());
  }
}

void WatchCall::Open() {
  const ObserverEntry observer = environment_.gate.Admit(context_);
  caller_.Identify(Admission{.robot = {observer.name, observer.name}});
  caller_.OnLastMessage(bytes_.Length());
  v1::WatchRequest request;
  if (const grpc::Status parsed = Parse(&bytes_, &request); !parsed.ok()) return End(parsed);
  const auto weak = weak_from_this();
  const auto call = [weak](auto step) {
    return [weak, step] {
      if (const auto self = weak.lock()) self->caller_.Guard([&] { step(*self); });
    };
  };
  begun_ = environment_.live_calls.Begin(call([](WatchCall& c) { c.End(StatusOfStopping()); }),
                                         call([](WatchCall& c) { c.Check(); }));
  if (!begun_) return End(StatusOfStopping());
  const auto watcher = environment_.hub.Join(WishOf(request, observer), call([](WatchCall& c) {
                                               const std::lock_guard lock(c.mutex_);
                                               c.Proceed();
                                             }));
  const std::lock_guard lock(mutex_);
  if (status_) {  // the server has begun to stop meanwhile
    environment_.hub.Leave(watcher);
    return;
  }
  watcher_ = watcher;
  Greet(observer);
}

void WatchCall::Greet(const ObserverEntry& observer) {
  v1::WatchResponse greeting;
  *greeting.mutable_observer() = ObserverToProto(observer);
  const grpc::Slice slice(greeting.SerializeAsString());
  Write(grpc::ByteBuffer(&slice, 1));
}

void WatchCall::Check() {
  {
    const std::lock_guard lock(mutex_);
    if (!watcher_) return;
  }
  try {
    if (IsSame(environment_.gate.Admit(context_), watcher_->wish.observer)) return;
    End({grpc::StatusCode::UNAUTHENTICATED, "the observer's rights have changed; watch anew"});
  } catch (...) {
    End(StatusOfCurrentException());
  }
}

void WatchCall::End(const grpc::Status& status) {
  std::shared_ptr<WatchHub::Watcher> watcher;
  {
    const std::lock_guard lock(mutex_);
    if (!status_) status_ = status;
    watcher = watcher_;
    Proceed();
  }
  if (watcher) environment_.hub.Leave(watcher);
}

void WatchCall::Write(const grpc::ByteBuffer& bytes) {
  busy_ = true;
  transfer_.BeginAnswer(shared_from_this(), bytes.Length());
  stream_.Write(bytes, Then([self = shared_from_this(), size = bytes.Length()](bool ok) {
                  self->transfer_.End();
                  if (ok) self->caller_.OnSent(size);
                  self->caller_.Guard([&] { self->OnWritten(ok); });
                }));
}

void WatchCall::OnWritten(bool ok) {
  {
    const std::lock_guard lock(mutex_);
    busy_ = false;
    if (ok) return Proceed();
  }
  const auto cancelled = transfer_.why_cancelled();
  if (cancelled) LogUntakenAnswer(caller_.request_id(), caller_.robot(), *cancelled);
  End(cancelled ? *cancelled : caller_.StatusOfGone());
}

void WatchCall::Proceed() {
  if (finished_ || busy_) return;
  if (status_) {
    finished_ = true;
    stream_.Finish(*status_, Then([self = shared_from_this()](bool) {}));
  } else if (watcher_) {
    if (const auto bytes = watcher_->mailbox.Take()) Write(*bytes);
  }
}

}  // namespace fovea::server
