// Where the tests find real recordings, which are not part of the repository.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace fovea {

// The file or folder `name` (such as "osd/learn0_color.png") in the folder that the environment
// variable FOVEA_DATA names, or else in shared/data beside the project; none if it is not there.
// A test without its data says so: GTEST_SKIP() << MissingData(name).
inline std::optional<std::filesystem::path> DataPath(const std::string& name) {
  const char* folder = std::getenv("FOVEA_DATA");
  const std::filesystem::path root =
      folder != nullptr ? folder : FOVEA_SOURCE_DIR "/../shared/data";
  if (!std::filesystem::exists(root / name)) return std::nullopt;
  return root / name;
}

inline std::string MissingData(const std::string& name) {
  return "no data: " + name + " is neither in $FOVEA_DATA nor in ../shared/data";
}

}  // namespace fovea
