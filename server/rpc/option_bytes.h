#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <optional>
#include <string>

namespace fovea::server {

// The options of a DetectStreamRequest as they came, to be parsed later; nothing where it has none.
// Takes no more of the message than that, so that it costs little whatever is in it: what has more
// fields than ours, or options of more than 64 KiB, is taken for one without.
std::optional<std::string> OptionBytesOf(const grpc::ByteBuffer& message);

// Whether a DetectStreamRequest says accept_picks; costs as little.
bool AcceptsPicks(const grpc::ByteBuffer& message);

}  // namespace fovea::server
