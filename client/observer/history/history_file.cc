#include "client/observer/history/history_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "client/observer/json_text.h"

namespace fovea::observer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char kMagic[] = "FOVEAHF1";
constexpr std::uint32_t kMaxHeader = 64 << 10;
constexpr std::uint64_t kMaxBody = std::uint64_t{256} << 20;

// Little-endian, as all that Debian 12 builds for here is.
struct Start {
  std::array<char, 8> magic;
  std::uint32_t checksum;  // CRC-32 of header and body
  std::uint32_t header_bytes;
  std::uint64_t body_bytes;
};

std::uint32_t ChecksumOf(const std::string& header, const std::string& body) {
  const auto add = [](uLong sum, const std::string& bytes) {
    return crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  };
  return static_cast<std::uint32_t>(add(add(crc32_z(0, nullptr, 0), header), body));
}

std::string TextOf(const HistoryHeader& header) {
  return JsonText(json{{"robot", header.robot},
                       {"server", header.server},
                       {"version", header.version},
                       {"objects", header.objects},
                       {"problem", header.problem}});
}

std::optional<HistoryHeader> HeaderOf(const std::string& text) {
  try {
    const json header = json::parse(text);
    return HistoryHeader{.robot = header.at("robot"),
                         .server = header.at("server"),
                         .version = header.at("version"),
                         .objects = header.at("objects"),
                         .problem = header.at("problem")};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

void Write(const fs::path& path, const std::string& bytes) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  std::size_t done = 0;
  while (file >= 0 && done < bytes.size()) {
    const ssize_t count = write(file, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  int error = errno;
  if (file >= 0) {
    if (close(file) == 0 && done == bytes.size()) return;
    if (done == bytes.size()) error = errno;
  }
  std::error_code ignored;
  fs::remove(path, ignored);
  throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

std::optional<Start> ReadStart(std::ifstream& file, std::uint64_t file_bytes) {
  Start start{};
  if (!file.read(reinterpret_cast<char*>(&start), sizeof start)) return std::nullopt;
  const bool is_ours = std::memcmp(start.magic.data(), kMagic, start.magic.size()) == 0 &&
                       start.header_bytes <= kMaxHeader && start.body_bytes <= kMaxBody &&
                       file_bytes == sizeof start + start.header_bytes + start.body_bytes;
  return is_ours ? std::optional(start) : std::nullopt;
}

std::optional<std::string> Read(std::ifstream& file, std::uint64_t count) {
  std::string bytes(static_cast<std::size_t>(count), '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(count))) return std::nullopt;
  return bytes;
}

}  // namespace

std::uint64_t HistoryFileSize(const HistoryRecord& record) {
  return sizeof(Start) + TextOf(record.header).size() + record.frame.ByteSizeLong();
}

void WriteHistoryFile(const fs::path& path, const HistoryRecord& record) {
  const std::string header = TextOf(record.header);
  const std::string body = record.frame.SerializeAsString();
  Start start{.magic = {},
              .checksum = ChecksumOf(header, body),
              .header_bytes = static_cast<std::uint32_t>(header.size()),
              .body_bytes = body.size()};
  std::memcpy(start.magic.data(), kMagic, start.magic.size());
  const std::string bytes =
      std::string(reinterpret_cast<const char*>(&start), sizeof start) + header + body;
  const fs::path part = path.string() + ".part";
  Write(part, bytes);
  std::error_code error;
  fs::rename(part, path, error);
  if (error) throw std::system_error(error, "cannot write " + path.string());
}

std::optional<HistoryHeader> ReadHistoryHeader(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  const auto start = ReadStart(file, fs::file_size(path, error));
  const auto header = start ? Read(file, start->header_bytes) : std::nullopt;
  return header ? HeaderOf(*header) : std::nullopt;
}

std::optional<HistoryRecord> ReadHistoryFile(const fs::path& path) {
  std::error_code error;
  std::ifstream file(path, std::ios::binary);
  const auto start = file ? ReadStart(file, fs::file_size(path, error)) : std::nullopt;
  const auto text = start ? Read(file, start->header_bytes) : std::nullopt;
  const auto body = text ? Read(file, start->body_bytes) : std::nullopt;
  if (!body || ChecksumOf(*text, *body) != start->checksum) return std::nullopt;
  const auto header = HeaderOf(*text);
  HistoryRecord record;
  if (!header || !record.frame.ParseFromString(*body)) return std::nullopt;
  record.header = *header;
  return record;
}

}  // namespace fovea::observer
