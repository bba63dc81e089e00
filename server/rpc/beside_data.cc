#include "server/rpc/beside_data.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <cstdint>

namespace fovea::server {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

// Goes over a message without keeping any of it.
class Walk {
 public:
  Walk(CodedInputStream& stream, std::size_t most) : stream_(stream), most_(most) {}

  std::size_t Beside() const {
    return static_cast<std::size_t>(stream_.CurrentPosition()) - data_bytes_;
  }

  // The fields of a message, or of a group where there is no descriptor, up to its end. False where
  // it is broken, or enough has been seen.
  bool Over(const Descriptor* descriptor, int depth) {
    constexpr int kMaxDepth = 100;  // protobuf reads no deeper ones
    if (depth > kMaxDepth) return false;
    while (Beside() <= most_) {
      const std::uint32_t tag = stream_.ReadTag();
      if (tag == 0 || WireFormatLite::GetTagWireType(tag) == WireFormatLite::WIRETYPE_END_GROUP) {
        return true;
      }
      const int number = WireFormatLite::GetTagFieldNumber(tag);
      const FieldDescriptor* field =
          descriptor != nullptr ? descriptor->FindFieldByNumber(number) : nullptr;
      if (!OverField(WireFormatLite::GetTagWireType(tag), field, depth)) return false;
    }
    return false;
  }

 private:
  bool OverField(WireFormatLite::WireType type, const FieldDescriptor* field, int depth) {
    std::uint64_t value = 0;
    switch (type) {
      case WireFormatLite::WIRETYPE_VARINT:
        return stream_.ReadVarint64(&value);
      case WireFormatLite::WIRETYPE_FIXED64:
        return stream_.Skip(8);
      case WireFormatLite::WIRETYPE_FIXED32:
        return stream_.Skip(4);
      case WireFormatLite::WIRETYPE_START_GROUP:
        return Over(nullptr, depth + 1);
      case WireFormatLite::WIRETYPE_LENGTH_DELIMITED:
        return OverBytes(field, depth);
      default:
        return false;
    }
  }

  bool OverBytes(const FieldDescriptor* field, int depth) {
    int length = 0;
    if (!stream_.ReadVarintSizeAsInt(&length)) return false;
    if (field != nullptr && field->type() == FieldDescriptor::TYPE_MESSAGE) {
      const CodedInputStream::Limit limit = stream_.PushLimit(length);
      const bool whole = Over(field->message_type(), depth + 1);
      stream_.PopLimit(limit);
      return whole;
    }
    if (!stream_.Skip(length)) return false;
    if (field != nullptr && field->type() == FieldDescriptor::TYPE_BYTES) {
      data_bytes_ += static_cast<std::size_t>(length);
    }
    return true;
  }

  CodedInputStream& stream_;
  const std::size_t most_;
  std::size_t data_bytes_ = 0;
};

}  // namespace

std::size_t BytesBesideData(const grpc::ByteBuffer& message,
                            const google::protobuf::Descriptor& descriptor, std::size_t most) {
  grpc::ByteBuffer bytes(message);  // shares what it holds
  grpc::ProtoBufferReader reader(&bytes);
  CodedInputStream stream(&reader);
  Walk walk(stream, most);
  walk.Over(&descriptor, 0);
  return walk.Beside();
}

}  // namespace fovea::server
