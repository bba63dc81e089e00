#include "client/cli/bag/bag_files.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "client/cli/bag/mcap.h"
#include "client/cli/bag/sqlite_bag.h"
#include "client/cli/endings.h"
#include "client/cli/files.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

constexpr const char* kMetadata = "metadata.yaml";

bool IsBagFile(const fs::path& path) {
  const std::string ending = LowerEnding(path);
  return ending == ".mcap" || ending == ".db3";
}

// "walk_12.mcap" → 12, where `stem` is "walk_". None where it is too many for a recorder.
std::optional<std::size_t> NumberOf(const fs::path& file, const std::string& stem) {
  constexpr std::size_t kMostDigits = 5;
  const std::string name = file.stem().string();
  if (!IsBagFile(file) || !name.starts_with(stem)) return std::nullopt;
  const std::string digits = name.substr(stem.size());
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = error == std::errc{} && end == digits.data() + digits.size();
  return is_number ? std::optional(number) : std::nullopt;
}

// Of a folder whose recorder was killed before it wrote down which files there are: those that
// have its name, by their numbers, and those that are missing between or before them.
Paths FilesByName(const fs::path& folder) {
  const std::string stem =
      fs::canonical(folder).filename().string() + "_";  // of "." and links, too
  std::map<std::size_t, std::set<fs::path>> numbered;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (const auto number = NumberOf(entry.path(), stem)) numbered[*number].insert(entry.path());
  }
  Paths files;
  std::size_t next = 0;
  for (const auto& [number, paths] : numbered) {
    const std::string ending = paths.begin()->extension().string();
    for (; next < number; ++next)
      files.push_back(folder / fmt::format("{}{}{}", stem, next, ending));
    files.insert(files.end(), paths.begin(), paths.end());
    next = number + 1;
  }
  return files;
}

Paths FilesByMetadata(const fs::path& folder) {
  Paths files;
  try {
    const YAML::Node metadata = YAML::Load(ReadTextOfFolder(folder / kMetadata));
    for (const YAML::Node& path : metadata["rosbag2_bagfile_information"]["relative_file_paths"]) {
      files.push_back(folder / fs::path(path.as<std::string>()).filename());
    }
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(std::string(kMetadata) + ": " + error.what());
  }
  if (files.empty()) throw std::invalid_argument(std::string(kMetadata) + " names no files");
  return files;
}

Paths FilesOf(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  try {
    return fs::exists(path / kMetadata) ? FilesByMetadata(path) : FilesByName(path);
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

std::shared_ptr<const BagFile> Open(const fs::path& path) {
  if (!IsBagFile(path)) {
    throw std::invalid_argument(path.filename().string() +
                                " is neither .mcap nor .db3; what is compressed as a whole has to "
                                "be decompressed before (zstd -d)");
  }
  if (!fs::is_regular_file(path)) throw std::invalid_argument("there is no such file");
  if (LowerEnding(path) == ".db3") return SqliteBagFile(path);
  return McapFile(McapInFile(path));
}

struct OpenFiles {
  std::vector<NamedBagFile> files;
  std::string left_out;  // for people; empty = none
};

// Throws where none can be read, as the first says it.
OpenFiles OpenAll(const Paths& paths) {
  OpenFiles open;
  std::string first;
  for (const fs::path& path : paths) {
    try {
      open.files.push_back({path, Open(path)});
    } catch (const std::invalid_argument& error) {
      if (first.empty()) first = path.string() + ": " + error.what();
    }
  }
  if (open.files.empty()) throw std::runtime_error(first);
  const std::size_t num_left_out = paths.size() - open.files.size();
  if (num_left_out == 0) return open;
  open.left_out = fmt::format(
      "of the bag's {} files {} cannot be read, and what {} {}", paths.size(), num_left_out,
      num_left_out == 1 ? "it has is left out:" : "they have is left out; the first is", first);
  return open;
}

}  // namespace

bool IsBag(const std::string& path) {
  if (!fs::is_directory(path)) return IsBagFile(path);
  return fs::exists(fs::path(path) / kMetadata) || !FilesByName(path).empty();
}

Bag OpenBag(const std::string& path, const BagFlags& flags) {
  const OpenFiles open = OpenAll(FilesOf(path));
  try {
    Bag bag = ReadBag(open.files, flags);
    if (!open.left_out.empty()) bag.list.notes.insert(bag.list.notes.begin(), open.left_out);
    return bag;
  } catch (const std::exception& error) {
    const std::string more = open.left_out.empty() ? "" : "; " + open.left_out;
    throw std::runtime_error(path + ": " + error.what() + more);
  }
}

}  // namespace fovea::cli
