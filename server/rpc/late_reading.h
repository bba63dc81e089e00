// Unary methods whose message is read once their caller has been let in: gRPC's own would take and
// parse it before.
#pragma once

#include <grpcpp/impl/codegen/method_handler.h>
#include <grpcpp/support/byte_buffer.h>

#include <functional>
#include <memory>
#include <utility>

#include "server/connections/call_account.h"
#include "server/rpc/parse.h"
#include "server/rpc/transfer_limit.h"
#include "server/scheduling/scheduler.h"
#include "server/status.h"

namespace fovea::server {

// Of such a call. What is never read is none of the server's memory.
template <typename Response>
using LateStream = grpc::ServerReaderWriter<Response, grpc::ByteBuffer>;

// Those of a service, once it is used.
using TransferRulesOf = std::function<TransferRules()>;

// As long as `limit` allows, waits until the response is sent: the thread is gRPC's, which has few.
template <typename Response>
void Write(const Response& response, const std::shared_ptr<TransferLimit>& limit,
           LateStream<Response>* stream) {
  const std::shared_ptr<void> end(nullptr, [&](void*) { limit->End(); });
  limit->BeginAnswer(limit, response.ByteSizeLong());
  stream->Write(response);
}

// For Service::MarkMethodStreamed, which owns it: the same on the wire. The response is sent where
// `answer` returns OK; what it throws becomes a status.
template <typename Response>
grpc::internal::MethodHandler* LateReading(
    std::function<grpc::Status(grpc::ServerContext*, LateStream<Response>*, Response*)> answer,
    TransferRulesOf rules) {
  using Handler = grpc::internal::TemplatedBidiStreamingHandler<LateStream<Response>, false>;
  return new Handler([answer = std::move(answer), rules = std::move(rules)](
                         grpc::ServerContext* context, LateStream<Response>* stream) {
    try {
      Response response;
      grpc::Status status = answer(context, stream, &response);
      if (status.ok()) Write(response, std::make_shared<TransferLimit>(context, rules()), stream);
      return status;
    } catch (const Overloaded& full) {
      AddRetryAfter(full.retry_after, context);
      return StatusOfCurrentException();
    } catch (...) {  // whatever it is, the caller gets a status
      return StatusOfCurrentException();
    }
  });
}

// Waits for the message, for as long as `limit` allows.
template <typename Request, typename Response>
grpc::Status Read(LateStream<Response>* stream, const std::shared_ptr<TransferLimit>& limit,
                  CallAccount* account, Request* request) {
  grpc::ByteBuffer bytes;
  limit->Begin(limit);
  const bool came = stream->Read(&bytes);
  limit->End();
  if (const auto why = limit->why_cancelled()) return *why;
  if (!came) return {grpc::StatusCode::INVALID_ARGUMENT, "the call has no message"};
  account->OnLastMessage(bytes.Length());
  return Parse(&bytes, request);
}

}  // namespace fovea::server
