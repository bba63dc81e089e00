#include "client/bundle/zip_writer.h"

#include <zip.h>

#include <memory>
#include <stdexcept>

namespace fovea::bundle {
namespace {

constexpr zip_uint32_t kFastest = 1;

[[noreturn]] void FailAt(const char* what) {
  throw std::runtime_error(std::string("no zip file can be made: ") + what);
}

}  // namespace

void ZipWriter::Add(std::string name, std::string bytes, bool is_packed) {
  entries_.push_back({std::move(name), std::move(bytes), is_packed});
}

std::string ZipWriter::Finish() const {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> target(
      zip_source_buffer_create(nullptr, 0, 0, &error), zip_source_free);
  if (!target) FailAt("memory");
  zip_source_keep(target.get());  // closing gives one back
  std::unique_ptr<zip_t, void (*)(zip_t*)> zip(
      zip_open_from_source(target.get(), ZIP_TRUNCATE, &error), zip_discard);
  if (!zip) FailAt("opening");
  for (const Entry& entry : entries_) {
    zip_source_t* const source =
        zip_source_buffer(zip.get(), entry.bytes.data(), entry.bytes.size(), 0);
    const zip_int64_t index = zip_file_add(zip.get(), entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      zip_source_free(source);
      FailAt(entry.name.c_str());
    }
    const auto at = static_cast<zip_uint64_t>(index);
    zip_set_file_compression(zip.get(), at, entry.is_packed ? ZIP_CM_STORE : ZIP_CM_DEFLATE,
                             kFastest);
    zip_file_set_mtime(zip.get(), at, static_cast<time_t>(time_), 0);
  }
  if (zip_close(zip.get()) != 0) FailAt("writing");
  zip.release();  // NOLINT(bugprone-unused-return-value): it is closed
  if (zip_source_open(target.get()) != 0) FailAt("reading");
  zip_stat_t stat;
  if (zip_source_stat(target.get(), &stat) != 0) FailAt("size");
  std::string bytes(static_cast<std::size_t>(stat.size), '\0');
  const zip_int64_t got = zip_source_read(target.get(), bytes.data(), bytes.size());
  zip_source_close(target.get());
  if (got < 0 || static_cast<std::size_t>(got) != bytes.size()) FailAt("reading");
  return bytes;
}

}  // namespace fovea::bundle
