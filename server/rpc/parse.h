// Messages that calls take as bytes, so that one that is no message gets an answer.
#pragma once

#include <grpcpp/impl/codegen/proto_utils.h>

#include <string>

#include "server/rpc/beside_data.h"

namespace fovea::server {

// INVALID_ARGUMENT where the bytes are no such message, or have more than 64 KiB beside images: it
// is refused before it takes memory. The message is empty then: half of one may hold text that is
// no UTF-8, and whatever that is put into can be read by nobody.
template <typename Message>
grpc::Status Parse(grpc::ByteBuffer* bytes, Message* message) {
  constexpr std::size_t kMostBesideData = 64 << 10;
  const std::string name = Message::descriptor()->name();
  if (BytesBesideData(*bytes, *Message::descriptor(), kMostBesideData) > kMostBesideData) {
    return {grpc::StatusCode::INVALID_ARGUMENT,
            "the " + name + " has more than 65536 bytes beside its images"};
  }
  if (grpc::SerializationTraits<Message>::Deserialize(bytes, message).ok()) return {};
  message->Clear();
  return {grpc::StatusCode::INVALID_ARGUMENT, "the message is not a " + name};
}

}  // namespace fovea::server
