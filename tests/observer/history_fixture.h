// A history in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "client/observer/history/history.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {

class ObserverHistory : public ::testing::Test {
 protected:
  static constexpr std::chrono::system_clock::time_point kStart{
      std::chrono::seconds(1'700'000'000)};

  static observer::HistoryRecord Record(const std::string& robot, std::size_t bytes = 100,
                                        const std::string& server = "here:1") {
    observer::HistoryRecord record{.header = {.robot = robot, .server = server, .version = "1"}};
    record.frame.set_robot(robot);
    record.frame.set_picture(std::string(bytes, 'x'));
    return record;
  }

  static std::vector<std::uint64_t> IdsOf(const observer::History& history,
                                          const std::string& robot) {
    std::vector<std::uint64_t> ids;
    for (const auto& entry : history.List(robot, [](const auto&) { return true; })) {
      ids.push_back(entry.id);
    }
    return ids;
  }

  std::vector<std::filesystem::path> Files() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.Path())) {
      if (entry.path().extension() == ".frame") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  std::filesystem::path FileOf(const std::string& robot, std::uint64_t id) const {
    const std::string number = std::to_string(id);
    return std::filesystem::path(folder_.At(robot)) /
           (std::string(20 - number.size(), '0') + number + ".frame");
  }

  const TemporaryFolder folder_;
};

}  // namespace fovea::testing
