#include "client/bundle/zip_reader.h"

#include <zip.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "client/bundle/shown.h"

namespace fovea::bundle {
namespace {

[[noreturn]] void Fail(const std::string& text) { throw std::invalid_argument(text); }

std::string TextOf(zip_error_t* error) { return zip_error_strerror(error); }

void Discard(void* zip) { zip_discard(static_cast<zip_t*>(zip)); }

zip_t* Open(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) Fail("cannot be read: " + TextOf(&error));
  zip_t* const zip = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
  if (zip == nullptr) {
    zip_source_free(source);
    const std::string text = TextOf(&error);
    zip_error_fini(&error);
    Fail("is no readable zip file: " + text);
  }
  return zip;
}

bool IsPlain(const std::string& name) {
  constexpr std::size_t kMaxName = 128;
  const auto is_fine = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= kMaxName && name.front() != '.' &&
         std::ranges::all_of(name, is_fine);
}

std::string Quoted(const std::string& name) { return '"' + Shown(name) + '"'; }

}  // namespace

ZipReader::ZipReader(std::string bytes, const ZipLimits& limits)
    : bytes_(std::move(bytes)), limits_(limits), zip_(Open(bytes_), Discard) {
  auto* const zip = static_cast<zip_t*>(zip_.get());
  const zip_int64_t count = zip_get_num_entries(zip, 0);
  if (count < 0 || static_cast<std::uint64_t>(count) > limits_.max_entries) {
    Fail("holds " + std::to_string(count) + " files, more than " +
         std::to_string(limits_.max_entries));
  }
  std::set<std::string> seen;
  std::uint64_t total = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(zip, static_cast<zip_uint64_t>(i), ZIP_FL_ENC_RAW, &stat) != 0) {
      Fail("has an entry that cannot be read");
    }
    const std::string name = stat.name != nullptr ? stat.name : "";
    if (!IsPlain(name)) Fail("has an entry " + Quoted(name) + ", which is no plain file name");
    if (!seen.insert(name).second) Fail("has " + Quoted(name) + " twice");
    if ((stat.valid & ZIP_STAT_SIZE) == 0 || stat.size > limits_.max_entry_bytes) {
      Fail("has " + Quoted(name) + " of more than " +
           std::to_string(limits_.max_entry_bytes >> 20U) + " MiB");
    }
    total += stat.size;
    if (total > limits_.max_total_bytes) {
      Fail("unpacks to more than " + std::to_string(limits_.max_total_bytes >> 20U) + " MiB");
    }
    names_.push_back(name);
  }
}

ZipReader::~ZipReader() = default;

bool ZipReader::Has(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::string ZipReader::Read(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  auto* const zip = static_cast<zip_t*>(zip_.get());
  zip_stat_t stat;
  if (zip_stat(zip, name.c_str(), ZIP_FL_ENC_RAW, &stat) != 0) Fail("has no " + name);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(zip, stat.index, 0),
                                                               zip_fclose);
  if (!file) Fail(name + " in it cannot be unpacked");
  std::string bytes(static_cast<std::size_t>(std::min(stat.size, limits_.max_entry_bytes)), '\0');
  const zip_int64_t got = zip_fread(file.get(), bytes.data(), bytes.size());
  char more = 0;  // at the end the checksum is compared
  if (got < 0 || static_cast<std::size_t>(got) != bytes.size() ||
      zip_fread(file.get(), &more, 1) != 0) {
    Fail(name + " in it is damaged");
  }
  return bytes;
}

}  // namespace fovea::bundle
