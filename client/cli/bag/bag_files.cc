#include "client/cli/bag/bag_files.h"

#include <yaml-cpp/yaml.h>

#include <filesystem>
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

// Of a folder whose recorder was killed before it wrote down which files there are.
Paths FilesByName(const fs::path& folder) {
  const fs::path name = fs::canonical(folder).filename();  // of "." and links, too
  Paths files;
  for (int number = 0;; ++number) {
    const std::string stem = name.string() + "_" + std::to_string(number);
    const std::size_t before = files.size();
    for (const char* ending : {".mcap", ".db3"}) {
      if (fs::exists(folder / (stem + ending))) files.push_back(folder / (stem + ending));
    }
    if (files.size() == before) return files;
  }
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
  return fs::exists(path / kMetadata) ? FilesByMetadata(path) : FilesByName(path);
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

}  // namespace

bool IsBag(const std::string& path) {
  if (!fs::is_directory(path)) return IsBagFile(path);
  return fs::exists(fs::path(path) / kMetadata) || !FilesByName(path).empty();
}

Bag OpenBag(const std::string& path, const BagFlags& flags) {
  std::string name = path;
  try {
    std::vector<NamedBagFile> files;
    for (const fs::path& file : FilesOf(path)) {
      name = file;
      files.push_back({file, Open(file)});
    }
    name = path;
    return ReadBag(files, flags);
  } catch (const std::exception& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

}  // namespace fovea::cli
