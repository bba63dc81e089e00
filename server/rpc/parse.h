// Messages that calls take as bytes, so that one that is no message gets an answer.
#pragma once

#include <grpcpp/impl/codegen/proto_utils.h>

namespace fovea::server {

// INVALID_ARGUMENT where the bytes are no such message.
template <typename Message>
grpc::Status Parse(grpc::ByteBuffer* bytes, Message* message) {
  if (grpc::SerializationTraits<Message>::Deserialize(bytes, message).ok()) return {};
  return {grpc::StatusCode::INVALID_ARGUMENT,
          "the message is not a " + Message::descriptor()->name()};
}

}  // namespace fovea::server
