#include "tests/support/bag_writer.h"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <utility>

namespace fovea::testing {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

template <typename Value>
std::string Bytes(Value value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string Text(std::string_view text) {
  return Bytes(static_cast<std::uint32_t>(text.size())) + std::string(text);
}

std::string Record(std::uint8_t kind, const std::string& content) {
  return Bytes(kind) + Bytes(static_cast<std::uint64_t>(content.size())) + content;
}

class Cdr {
 public:
  template <typename Value>
  Cdr& Number(Value value) {
    body_.resize((body_.size() + sizeof value - 1) / sizeof value * sizeof value);
    body_ += Bytes(value);
    return *this;
  }
  Cdr& Data(std::string_view data) {
    Number(static_cast<std::uint32_t>(data.size()));
    body_ += data;
    return *this;
  }
  Cdr& Word(std::string_view word) { return Data(std::string(word) + '\0'); }
  Cdr& Header(std::int64_t stamp_ns, std::string_view frame = "camera") {
    Number(static_cast<std::int32_t>(stamp_ns / kSecond_ns));
    return Number(static_cast<std::uint32_t>(stamp_ns % kSecond_ns)).Word(frame);
  }
  std::string Finish() const { return std::string("\0\1\0\0", 4) + body_; }

 private:
  std::string body_;
};

std::string Packed(const std::string& records, std::string_view compression) {
  if (compression.empty()) return records;
  const bool zstd = compression == "zstd";
  std::string packed(
      zstd ? ZSTD_compressBound(records.size()) : LZ4F_compressFrameBound(records.size(), nullptr),
      '\0');
  packed.resize(zstd
                    ? ZSTD_compress(packed.data(), packed.size(), records.data(), records.size(), 1)
                    : LZ4F_compressFrame(packed.data(), packed.size(), records.data(),
                                         records.size(), nullptr));
  return packed;
}

}  // namespace

std::string ImageMessage(std::int64_t stamp_ns, std::string_view encoding, std::uint32_t width,
                         std::uint32_t height, std::uint32_t step, std::string_view data,
                         std::string_view frame) {
  Cdr cdr;
  cdr.Header(stamp_ns, frame).Number(height).Number(width).Word(encoding);
  return cdr.Number(std::uint8_t{0}).Number(step).Data(data).Finish();
}

std::string CompressedMessage(std::int64_t stamp_ns, std::string_view format,
                              std::string_view data) {
  return Cdr().Header(stamp_ns).Word(format).Data(data).Finish();
}

std::string CameraInfoMessage(std::uint32_t width, std::uint32_t height, double focal_px, double k1,
                              const Window& window) {
  Cdr cdr;
  cdr.Header(kSecond_ns).Number(height).Number(width).Word("plumb_bob").Number(std::uint32_t{5});
  for (const double value : {k1, 0.0, 0.0, 0.0, 0.0}) cdr.Number(value);
  const double cx = (width - 1) / 2.0, cy = (height - 1) / 2.0;
  for (const double value : {focal_px, 0.0, cx, 0.0, focal_px, cy, 0.0, 0.0, 1.0}) {
    cdr.Number(value);
  }
  for (int i = 0; i < 9; ++i) cdr.Number(0.0);
  const double rectified_px = 0.75 * focal_px;
  for (const double value :
       {rectified_px, 0.0, cx, 0.0, 0.0, rectified_px, cy, 0.0, 0.0, 0.0, 1.0, 0.0}) {
    cdr.Number(value);
  }
  for (const std::uint32_t value : {window.binning_x, window.binning_y, window.x_offset,
                                    window.y_offset, window.height, window.width}) {
    cdr.Number(value);
  }
  return cdr.Number(std::uint8_t{0}).Finish();
}

BagWriter::BagWriter() : file_("\x89MCAP0\r\n" + Record(1, Text("ros2") + Text("test"))) {}

void BagWriter::Add(std::string_view topic, std::string_view type, std::string_view message) {
  const std::string id = Bytes(next_id_++);
  open_ +=
      Record(3, id + Text("sensor_msgs/msg/" + std::string(type)) + Text("ros2msg") + Text(""));
  open_ += Record(4, id + id + Text(topic) + Text("cdr") + Bytes(std::uint32_t{0}));
  const std::string times = Bytes(2 * kSecond_ns) + Bytes(2 * kSecond_ns);
  open_ += Record(5, id + Bytes(std::uint32_t{0}) + times + std::string(message));
}

void BagWriter::EndChunk(std::string_view compression, bool with_checksum) {
  const std::string records = std::exchange(open_, {});
  const auto checksum = static_cast<std::uint32_t>(
      with_checksum ? crc32_z(0, reinterpret_cast<const Bytef*>(records.data()), records.size())
                    : 0);
  const std::string packed = Packed(records, compression);
  file_ +=
      Record(6, Bytes(std::uint64_t{0}) + Bytes(std::uint64_t{0}) +
                    Bytes(static_cast<std::uint64_t>(records.size())) + Bytes(checksum) +
                    Text(compression) + Bytes(static_cast<std::uint64_t>(packed.size())) + packed);
}

std::string BagWriter::Finish() {
  return file_ + open_ + Record(15, Bytes(std::uint32_t{0})) + Record(2, std::string(20, '\0')) +
         "\x89MCAP0\r\n";
}

}  // namespace fovea::testing
