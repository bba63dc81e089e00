#include "server/rpc/observation_service.h"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "server/access/unauthenticated.h"
#include "server/conversion/field_error.h"
#include "server/scheduling/scheduler.h"
#include "server/status.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxRobot = 1024, kMaxFrameId = 1024;
constexpr std::chrono::seconds kPickPatience{5};

void RequireRobot(const std::string& robot) {
  RequireField(!robot.empty() && robot.size() <= kMaxRobot, "robot",
               "must have 1 to 1024 characters");
}

bool IsFinite(const v1::Vector3& vector) {
  return std::isfinite(vector.x()) && std::isfinite(vector.y()) && std::isfinite(vector.z());
}

void RequirePick(const v1::Pick& pick) {
  RequireField(pick.frame_id().size() <= kMaxFrameId, "pick.frame_id",
               "must have at most 1024 bytes");
  RequireField(pick.label() > 0, "pick.label", "must be the label of an object, from 1");
  const v1::OrientedBox& box = pick.oriented_box();
  const v1::Quaternion& turn = box.pose().orientation();
  RequireField(IsFinite(box.pose().position()) && IsFinite(box.size()) &&
                   std::isfinite(turn.w() + turn.x() + turn.y() + turn.z()),
               "pick.oriented_box", "must be finite");
}

}  // namespace

ObservationService::ObservationService() {
  constexpr int kTry = 1, kListOptions = 2, kSelectObject = 3;  // their places in the contract
  Answer<v1::TryResponse>(kTry, &ObservationService::TryOptions);
  Answer<v1::ListOptionsResponse>(kListOptions, &ObservationService::TellOptions);
  Answer<v1::SelectObjectResponse>(kSelectObject, &ObservationService::PassSelection);
}

template <typename Response>
void ObservationService::Answer(int place, Method<Response> method) {
  MarkMethodStreamed(
      place, LateReading<Response>(std::bind_front(method, this), [this] { return Rules(); }));
}

TransferRules ObservationService::Rules() const {
  return {environment_->queue, environment_->max_transfer, environment_->unsent};
}

ObserverEntry ObservationService::Admit(const grpc::ServerContext& context, CallAccount* account,
                                        bool ObserverRights::*right, const char* name) const {
  ObserverEntry observer = environment_->gate.Admit(context);
  account->Admit(context.peer());
  if (!(observer.rights.*right)) {
    throw PermissionDenied(std::string("the observer has no right ") + name);
  }
  return observer;
}

template <typename Request, typename Response>
grpc::Status ObservationService::ReadFrom(grpc::ServerContext* context,
                                          LateStream<Response>* stream, CallAccount* account,
                                          Request* request) const {
  return Read(stream, std::make_shared<TransferLimit>(context, Rules()), account, request);
}

grpc::Status ObservationService::TryOptions(grpc::ServerContext* context,
                                            LateStream<v1::TryResponse>* stream,
                                            v1::TryResponse* response) {
  const auto received = std::chrono::steady_clock::now();
  CallAccount account(environment_->connections);
  const ObserverEntry observer = Admit(*context, &account, &ObserverRights::try_, "try");
  v1::TryRequest request;
  grpc::Status status = ReadFrom(context, stream, &account, &request);
  if (!status.ok()) return status;
  RequireRobot(request.robot());
  if (!observer.MaySee(request.robot())) throw PermissionDenied("robot: is none of yours");
  const auto token = environment_->live_calls.Begin([] {});
  if (!token) return StatusOfStopping();
  environment_->trials.Run(observer.name, [&] {
    const FrameRequest frame{.frame = request.has_frame() ? &request.frame() : nullptr,
                             .options = &request.options(),
                             .received = received,
                             .began = std::chrono::steady_clock::now()};
    const auto is_gone = [&] {
      return context->IsCancelled() || std::chrono::system_clock::now() >= context->deadline();
    };
    status = environment_->answerer.Try(
        frame, {.robot = request.robot(), .is_gone = is_gone, .is_helped = false},
        response->mutable_detections());
  });
  return status;
}

grpc::Status ObservationService::TellOptions(grpc::ServerContext* context,
                                             LateStream<v1::ListOptionsResponse>* /*stream*/,
                                             v1::ListOptionsResponse* response) {
  CallAccount account(environment_->connections);
  Admit(*context, &account, &ObserverRights::try_, "try");
  *response = environment_->options;
  return grpc::Status::OK;
}

grpc::Status ObservationService::PassSelection(grpc::ServerContext* context,
                                               LateStream<v1::SelectObjectResponse>* stream,
                                               v1::SelectObjectResponse* response) {
  CallAccount account(environment_->connections);
  const ObserverEntry observer = Admit(*context, &account, &ObserverRights::pick, "pick");
  v1::SelectObjectRequest request;
  if (grpc::Status status = ReadFrom(context, stream, &account, &request); !status.ok())
    return status;
  RequireRobot(request.robot());
  RequirePick(request.pick());
  v1::Pick pick = request.pick();
  pick.set_observer(observer.name);
  // A robot that the observer may not see is as one that is not there; its name is none.
  const bool may_see = observer.MaySee(request.robot());
  try {
    const PickBoard::Outcome outcome =
        environment_->picks.Deliver(request.robot(), may_see, std::move(pick), kPickPatience,
                                    [&] { return context->IsCancelled(); });
    response->set_delivered(outcome.delivered);
    response->set_reason(outcome.reason);
    return grpc::Status::OK;
  } catch (const NoPicksTaken& nobody) {
    return {grpc::StatusCode::FAILED_PRECONDITION, nobody.what()};
  }
}

}  // namespace fovea::server
