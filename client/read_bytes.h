// Streams of answers are read as bytes. Of a message that it cannot parse gRPC says no more than of
// the end of the call, for which whoever takes it for that then waits.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/status.h>

namespace fovea::client {

// Whether these bytes are such a message.
template <typename Message>
bool ParseBytes(grpc::ByteBuffer* bytes, Message* message) {
  return grpc::SerializationTraits<Message>::Deserialize(bytes, message).ok();
}

// Ends the call of a stream, of which such a message came that cannot be read. Returns what became
// of it.
template <typename Message, typename Stream>
grpc::Status EndUnread(Stream* stream, grpc::ClientContext* context) {
  context->TryCancel();
  stream->Finish();
  return {grpc::StatusCode::INTERNAL,
          "the server sent a " + Message::descriptor()->name() + " that cannot be read"};
}

}  // namespace fovea::client
