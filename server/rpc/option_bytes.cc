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

}  // namespace

std::optional<std::string> OptionBytesOf(const grpc::ByteBuffer& message) {
  grpc::ByteBuffer bytes(message);  // shares what it holds
  grpc::ProtoBufferReader reader(&bytes);
  google::protobuf::io::CodedInputStream stream(&reader);
  std::optional<std::string> options;
  for (int i = 0; i < kMaxFields; ++i) {
    const std::uint32_t tag = stream.ReadTag();
    if (tag == 0) return options;
    const bool has_length =
        WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
    const bool is_options =
        WireFormatLite::GetTagFieldNumber(tag) == v1::DetectStreamRequest::kOptionsFieldNumber;
    std::uint32_t length = 0;
    // Groups, which may hold any number of fields, are none of ours.
    if (!has_length || !stream.ReadVarint32(&length)) return std::nullopt;
    if (!is_options) {
      if (!stream.Skip(static_cast<int>(length))) return std::nullopt;
      continue;
    }
    std::string part;
    if (length > kMaxBytes || !stream.ReadString(&part, static_cast<int>(length)))
      return std::nullopt;
    options = options.value_or("") + part;  // the same as merging what they mean
    if (options->size() > kMaxBytes) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace fovea::server
