// The page, which is part of the program.
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace fovea::observer {

struct Asset {
  std::string type;
  std::shared_ptr<const std::string> gzip;  // the file, compressed
};

// By its path, "/index.html".
std::optional<Asset> FindAsset(const std::string& path);

}  // namespace fovea::observer
