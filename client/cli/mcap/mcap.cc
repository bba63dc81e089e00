#include "client/cli/mcap/mcap.h"

#include <fmt/format.h>
#include <zlib.h>

#include <map>
#include <stdexcept>

#include "client/cli/mcap/byte_reader.h"
#include "client/cli/mcap/decompression.h"

namespace fovea::cli {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::uint8_t kSchema = 3, kChannel = 4, kMessage = 5, kChunk = 6, kDataEnd = 15;

struct Channel {
  std::string topic, type, encoding;
};

struct Chunk {
  std::string_view compression, records;
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;  // CRC-32 of the records, decompressed; 0 = none
};

Chunk ParseChunk(std::string_view content) {
  ByteReader reader(content);
  reader.Bytes(2 * sizeof(std::uint64_t));  // of the first and the last message
  Chunk chunk;
  chunk.size = reader.Number<std::uint64_t>();
  chunk.checksum = reader.Number<std::uint32_t>();
  chunk.compression = reader.Text();
  chunk.records = reader.Bytes(reader.Number<std::uint64_t>());
  return chunk;
}

std::string RecordsOf(const Chunk& chunk) {
  return Decompress(chunk.records, chunk.compression, chunk.size);
}

void RequireChecksum(const Chunk& chunk, const std::string& records) {
  if (chunk.checksum == 0) return;
  const auto* bytes = reinterpret_cast<const Bytef*>(records.data());
  if (crc32_z(0, bytes, records.size()) == chunk.checksum) return;
  throw std::invalid_argument("a chunk is damaged: its checksum is another");
}

class Parser {
 public:
  Parser(std::string_view file, const std::function<void(const McapMessage&)>& use)
      : file_(file), use_(use) {}

  std::optional<std::uint64_t> Parse() {
    if (!file_.starts_with(kMagic)) throw std::invalid_argument("it is no MCAP file");
    return Records(file_.substr(kMagic.size()), kMagic.size(), {});
  }

 private:
  // `start`: of `records` in the file, or in those of the chunk that `chunk` names. Returns where
  // they break off, as the file does.
  std::optional<std::uint64_t> Records(std::string_view records, std::uint64_t start,
                                       const McapPlace& chunk) {
    ByteReader reader(records);
    while (!reader.AtEnd()) {
      constexpr std::size_t kHead = 1 + sizeof(std::uint64_t);
      const std::uint64_t at = start + reader.position();
      if (records.size() - reader.position() < kHead) return at;
      const auto kind = reader.Number<std::uint8_t>();
      const auto size = reader.Number<std::uint64_t>();
      const bool is_none = kind == 0;  // as where a disk lost what was written
      if (is_none || size > records.size() - reader.position()) return at;
      if (kind == kDataEnd) return std::nullopt;  // what follows says the same once more
      const std::uint64_t place = start + reader.position();
      try {
        Add(kind, reader.Bytes(size), place, chunk);
      } catch (const std::invalid_argument& error) {
        if (chunk.chunk != 0) throw;
        throw std::invalid_argument(fmt::format("the record at byte {}: {}", at, error.what()));
      }
    }
    if (chunk.chunk != 0) return std::nullopt;
    return start + reader.position();
  }

  void Add(std::uint8_t kind, std::string_view content, std::uint64_t place,
           const McapPlace& chunk) {
    if (kind == kSchema) AddSchema(content);
    if (kind == kChannel) AddChannel(content);
    if (kind == kMessage) AddMessage(content, place, chunk);
    if (kind == kChunk && chunk.chunk == 0) AddChunk(content, place);
  }

  void AddSchema(std::string_view content) {
    ByteReader reader(content);
    const auto id = reader.Number<std::uint16_t>();
    schemas_[id] = reader.Text();
  }

  void AddChannel(std::string_view content) {
    ByteReader reader(content);
    const auto id = reader.Number<std::uint16_t>();
    const auto schema = schemas_.find(reader.Number<std::uint16_t>());
    Channel& channel = channels_[id];
    channel.type = schema == schemas_.end() ? "" : schema->second;
    channel.topic = reader.Text();
    channel.encoding = reader.Text();
  }

  void AddMessage(std::string_view content, std::uint64_t place, McapPlace chunk) {
    ByteReader reader(content);
    const auto channel = channels_.find(reader.Number<std::uint16_t>());
    if (channel == channels_.end()) throw std::invalid_argument("a message is of no channel");
    reader.Bytes(sizeof(std::uint32_t));  // its number
    const auto log_time = reader.Number<std::uint64_t>();
    reader.Bytes(sizeof(std::uint64_t));  // when it was published
    chunk.start = place + reader.position();
    const std::string_view data = reader.Rest();
    chunk.size = data.size();
    const auto& [topic, type, encoding] = channel->second;
    use_({topic, type, encoding, static_cast<std::int64_t>(log_time), data, chunk});
  }

  void AddChunk(std::string_view content, std::uint64_t place) {
    const Chunk chunk = ParseChunk(content);
    const std::string records = RecordsOf(chunk);
    RequireChecksum(chunk, records);
    if (Records(records, 0, {place, content.size(), 0, 0})) {
      throw std::invalid_argument("a chunk ends within a record");
    }
  }

  const std::string_view file_;
  const std::function<void(const McapMessage&)>& use_;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, Channel> channels_;
};

std::string_view Part(std::string_view bytes, std::uint64_t start, std::uint64_t size) {
  ByteReader reader(bytes);
  reader.Bytes(start);
  return reader.Bytes(size);
}

}  // namespace

std::optional<std::uint64_t> ForEachMessage(std::string_view file,
                                            const std::function<void(const McapMessage&)>& use) {
  return Parser(file, use).Parse();
}

std::string DataAt(std::string_view file, const McapPlace& place) {
  if (place.chunk == 0) return std::string(Part(file, place.start, place.size));
  const std::string records = RecordsOf(ParseChunk(Part(file, place.chunk, place.chunk_bytes)));
  return std::string(Part(records, place.start, place.size));
}

}  // namespace fovea::cli
