#include "client/cli/bag/mcap.h"

#include <fmt/format.h>
#include <zlib.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "client/cli/bag/byte_reader.h"
#include "client/cli/bag/decompression.h"

namespace fovea::cli {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kRecordHead = 1 + sizeof(std::uint64_t);  // of a record: its kind and size
// A few bytes of a compressed chunk may be any number of records that are none.
constexpr std::uint64_t kMostBrokenRecords = 100'000;
constexpr std::uint64_t kMostOfRecord = std::uint64_t{512} << 20;  // what a chunk may hold, twice
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

// Good as long as `decompressor` has it.
std::string_view RecordsOf(const Chunk& chunk, Decompressor& decompressor) {
  return decompressor.Chunk(chunk.records, chunk.compression, chunk.size);
}

void RequireChecksum(const Chunk& chunk, std::string_view records) {
  if (chunk.checksum == 0) return;
  const auto* bytes = reinterpret_cast<const Bytef*>(records.data());
  if (crc32_z(0, bytes, records.size()) == chunk.checksum) return;
  throw std::invalid_argument("a chunk is damaged: its checksum is another");
}

// What of a file could not be read.
struct Faults {
  std::optional<std::uint64_t> end;  // where it breaks off, as there is no whole record
  std::uint64_t num_damaged = 0;     // records that contradict themselves or their checksum
  std::string first_damage = {};     // "at byte 33: a chunk holds less than it says"

  std::vector<std::string> Said(std::uint64_t size) const {
    std::vector<std::string> said;
    if (num_damaged > 0) {
      said.push_back(
          fmt::format("has damaged records: {}, the first {}", num_damaged, first_damage));
    }
    if (end) said.push_back(fmt::format("breaks off at byte {} of {}", *end, size));
    return said;
  }
};

// `chunk` of a place is that of its chunk's content in the file, or 0 where it is in none.
class Parser {
 public:
  Parser(const McapBytes& file, const std::function<void(const BagMessage&)>& use)
      : file_(file), use_(use) {}

  Faults Parse() {
    faults_.end = Records(file_, kMagic.size(), {});
    return faults_;
  }

 private:
  // From byte `at` on. `chunk`: the one whose records they are, if any. Returns where they break
  // off, as the file does.
  std::optional<std::uint64_t> Records(const McapBytes& records, std::uint64_t at,
                                       const MessagePlace& chunk) {
    while (at < records.size) {
      if (records.size - at < kRecordHead) return at;
      const std::string head = records.part(at, kRecordHead);
      ByteReader reader(head);
      const auto kind = reader.Number<std::uint8_t>();
      const auto size = reader.Number<std::uint64_t>();
      const std::uint64_t place = at + kRecordHead;
      const bool is_none = kind == 0;  // as where a disk lost what was written
      if (is_none || size > records.size - place) return at;
      if (kind == kDataEnd) return std::nullopt;  // what follows says the same once more
      try {
        if (kind >= kSchema && kind <= kChunk) {
          Add(kind, Content(records, place, size), place, chunk);
        }
      } catch (const std::invalid_argument& error) {
        NoteDamage(place, chunk, error.what());
        if (++num_broken_ > kMostBrokenRecords) return at;
      }
      at = place + size;
    }
    if (chunk.chunk != 0) return std::nullopt;
    return at;
  }

  // What is behind it is read all the same: a record says where the next one is.
  void NoteDamage(std::uint64_t place, const MessagePlace& chunk, std::string_view what) {
    if (faults_.num_damaged++ > 0) return;
    const std::uint64_t at = (chunk.chunk == 0 ? place : chunk.chunk) - kRecordHead;
    faults_.first_damage = fmt::format("at byte {}: {}", at, what);
  }

  static std::string Content(const McapBytes& records, std::uint64_t place, std::uint64_t size) {
    if (size > kMostOfRecord) throw std::invalid_argument("it is larger than 512 MiB");
    return records.part(place, size);
  }

  void Add(std::uint8_t kind, std::string_view content, std::uint64_t place,
           const MessagePlace& chunk) {
    if (kind == kSchema) AddSchema(content);
    if (kind == kChannel) AddChannel(content);
    if (kind == kMessage) AddMessage(content, place, chunk);
    if (kind == kChunk && chunk.chunk == 0) AddChunk(content, place);
  }

  void AddSchema(std::string_view content) {
    ByteReader reader(content);
    const auto id = reader.Number<std::uint16_t>();
    schemas_[id] = reader.Text().substr(0, kLongestName);  // what is longer is no image
  }

  void AddChannel(std::string_view content) {
    ByteReader reader(content);
    const auto id = reader.Number<std::uint16_t>();
    const auto schema = schemas_.find(reader.Number<std::uint16_t>());
    const std::string_view topic = reader.Text();
    if (topic.size() > kLongestName) {
      throw std::invalid_argument(fmt::format("a topic has more than {} letters", kLongestName));
    }
    Channel& channel = channels_[id];
    channel.type = schema == schemas_.end() ? "" : schema->second;
    channel.topic = topic;
    channel.encoding = reader.Text().substr(0, kLongestName);
  }

  void AddMessage(std::string_view content, std::uint64_t place, MessagePlace chunk) {
    ByteReader reader(content);
    const auto channel = channels_.find(reader.Number<std::uint16_t>());
    if (channel ==
        channels_.end()) {  // any number, where the chunk that has the channel is damaged
      NoteDamage(place, chunk, "a message is of no channel");
      return;
    }
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
    const std::string_view records = RecordsOf(chunk, decompressor_);
    RequireChecksum(chunk, records);
    if (Records(McapInMemory(records), 0, {place, content.size(), 0, 0})) {
      throw std::invalid_argument("a chunk ends within a record");
    }
  }

  const McapBytes& file_;
  const std::function<void(const BagMessage&)>& use_;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  Decompressor decompressor_;
  std::uint64_t num_broken_ = 0;
  Faults faults_;
};

class Mcap : public BagFile {
 public:
  explicit Mcap(McapBytes bytes) : bytes_(std::move(bytes)) {
    if (bytes_.size < kMagic.size() || bytes_.part(0, kMagic.size()) != kMagic) {
      throw std::invalid_argument("it is no MCAP file");
    }
  }

  std::vector<std::string> ForEachMessage(
      const std::function<void(const BagMessage&)>& use) const override {
    return Parser(bytes_, use).Parse().Said(bytes_.size);
  }

  std::string DataAt(const MessagePlace& place) const override {
    if (place.chunk == 0) return bytes_.part(place.start, place.size);
    return McapInMemory(*ChunkAt(place)).part(place.start, place.size);
  }

 private:
  using Records = std::shared_ptr<const std::string>;

  // Messages are asked for in the order in which they were recorded, and a chunk has many.
  Records ChunkAt(const MessagePlace& place) const {
    {
      const std::lock_guard lock(mutex_);
      if (last_chunk_ && last_place_ == place.chunk) return last_chunk_;
    }
    const std::string content = bytes_.part(place.chunk, place.chunk_bytes);
    Decompressor decompressor;
    auto records =
        std::make_shared<const std::string>(RecordsOf(ParseChunk(content), decompressor));
    const std::lock_guard lock(mutex_);
    last_place_ = place.chunk;
    last_chunk_ = records;
    return records;
  }

  const McapBytes bytes_;
  mutable std::mutex mutex_;
  mutable std::uint64_t last_place_ = 0;
  mutable Records last_chunk_;
};

}  // namespace

std::shared_ptr<const BagFile> McapFile(McapBytes bytes) {
  return std::make_shared<Mcap>(std::move(bytes));
}

}  // namespace fovea::cli
