#pragma once

#include <google/protobuf/descriptor.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstddef>

namespace fovea::server {

// How much of a message is none of the bytes of images: parsed, that may take a hundred times as
// much memory, and long. Reads no farther than `most` of it, and counts nothing that is broken.
std::size_t BytesBesideData(const grpc::ByteBuffer& message,
                            const google::protobuf::Descriptor& descriptor, std::size_t most);

}  // namespace fovea::server
