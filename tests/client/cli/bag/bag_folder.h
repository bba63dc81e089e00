// The folder of a bag, "walk", to be filled.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "client/cli/bag/bag_files.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli::small_bags {

class BagFolder : public ::testing::Test {
 protected:
  BagFolder() { std::filesystem::create_directory(folder_.At("walk")); }

  std::string At(const std::string& name) const { return folder_.At("walk/" + name); }
  void Write(const std::string& name, const std::string& bytes) {
    folder_.Write("walk/" + name, bytes);
  }
  std::string WhyNotOpened() const {
    try {
      OpenBag(folder_.At("walk"), {});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const testing::TemporaryFolder folder_;
};

}  // namespace fovea::cli::small_bags
