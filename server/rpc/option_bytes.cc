#include "server/rpc/option_bytes.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <cstdint>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::server {
namespace {

using google::protobuf::internal::WireFormatLite;

constexpr int kMaxFields = 16;
constexpr std::uint32_t kMaxBytes = 64 << 10;

// What is looked for in a message without parsing all of it.
struct Found {
  std::optional<std::string> options = std::nullopt;
  bool accepts_picks = false;
};

std::optional<Found> Look(const grpc::ByteBuffer& message) {
  using Request = v1::DetectStreamRequest;
  grpc::ByteBuffer bytes(message);  // shares what it holds
  grpc::ProtoBufferReader reader(&bytes);
  google::protobuf::io::CodedInputStream stream(&reader);
  Found found;
  for (int i = 0; i < kMaxFields; ++i) {
    const std::uint32_t tag = stream.ReadTag();
    if (tag == 0) return found;
    const int number = WireFormatLite::GetTagFieldNumber(tag);
    const WireFormatLite::WireType type = WireFormatLite::GetTagWireType(tag);
    if (type == WireFormatLite::WIRETYPE_VARINT) {
      std::uint64_t value = 0;
      if (!stream.ReadVarint64(&value)) return std::nullopt;
      if (number == Request::kAcceptPicksFieldNumber) found.accepts_picks = value != 0;
      continue;
    }
    std::uint32_t length = 0;
    // Groups, which may hold any number of fields, are none of ours.
    const bool has_length = type == WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
    if (!has_length || !stream.ReadVarint32(&length)) return std::nullopt;
    if (number != Request::kOptionsFieldNumber) {
      if (!stream.Skip(static_cast<int>(length))) return std::nullopt;
      continue;
    }
    std::string part;
    if (length > kMaxBytes || !stream.ReadString(&part, static_cast<int>(length)))
      return std::nullopt;
    found.options = found.options.value_or("") + part;  // the same as merging what they mean
    if (found.options->size() > kMaxBytes) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> OptionBytesOf(const grpc::ByteBuffer& message) {
  const std::optional<Found> found = Look(message);
  return found ? found->options : std::nullopt;
}

bool AcceptsPicks(const grpc::ByteBuffer& message) {
  const std::optional<Found> found = Look(message);
  return found && found->accepts_picks;
}

}  // namespace fovea::server
