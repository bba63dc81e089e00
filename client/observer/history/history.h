#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/observer/history/history_file.h"
#include "client/observer/history/history_folder.h"

namespace fovea::observer {

struct HistoryLimits {
  std::chrono::seconds span{600};                       // of each robot, before its newest frame
  std::uint64_t max_bytes = std::uint64_t{4} << 30;     // of all; of one robot half of it
  std::size_t max_frames = 200'000, max_robots = 1024;  // of all
};

// The last minutes of robots, on disk: one file a frame, in a folder a robot. What a program before
// this one wrote is read again; what is not whole is dropped. The oldest goes first. Thread-safe.
class History {
 public:
  struct Entry {
    // When it came, in microseconds since 1970; of one robot no two have one. Where the clock is
    // set back, those before are moved with it.
    std::uint64_t id = 0;
    std::string server = {};
    std::uint32_t objects = 0;
    bool problem = false;
  };

  // Makes the folder where it is missing. Throws std::runtime_error where it cannot be used, or
  // another program does.
  History(std::filesystem::path folder, const HistoryLimits& limits);

  History(const History&) = delete;
  History& operator=(const History&) = delete;

  // On a full disk, too, the oldest goes. Where the folder was moved away, it is made anew. Throws
  // std::runtime_error where it cannot be written.
  void Add(const HistoryRecord& record, std::chrono::system_clock::time_point now);

  // Oldest first. Of servers that `may_see` says yes to.
  using MaySee = std::function<bool(const std::string& server)>;
  std::vector<Entry> List(const std::string& robot, const MaySee& may_see) const;

  // Of each robot that a server showed, the newest frame of that server.
  std::map<std::string, std::uint64_t> NewestOf(const std::string& server) const;

  // None where it is not there (any more), or damaged.
  std::optional<HistoryRecord> Read(const std::string& robot, std::uint64_t id) const;

  // Why it lacks frames that came within its span of time, in words that stay the same; empty where
  // it has all of them.
  std::string Shortage() const;

  struct Counts {
    std::size_t robots = 0, frames = 0;
    std::uint64_t bytes = 0;
  };
  Counts counts() const;
  const HistoryLimits& limits() const { return limits_; }

 private:
  struct Kept {
    std::uint64_t id = 0;
    std::uint32_t server = 0;  // in servers_
    std::uint32_t objects = 0;
    std::uint64_t bytes = 0;
    bool problem = false;
  };
  struct Robot {
    std::deque<Kept> frames;  // oldest first
    std::uint64_t bytes = 0;
  };
  using Robots = std::map<std::string, Robot>;

  void Load();
  void LoadRobot(const std::filesystem::path& folder);
  std::filesystem::path FolderOf(const std::string& robot) const;
  std::filesystem::path PathOf(const std::string& robot, std::uint64_t id) const;
  // mutex_ is held for these.
  void FollowFolder();
  void FollowClock(std::uint64_t now);
  void MoveBack(Robots::iterator robot, std::uint64_t by);
  std::uint32_t NumberOf(const std::string& server);
  void Keep(const std::string& robot, const Kept& frame);
  void Write(const HistoryRecord& record, std::uint64_t id, std::uint64_t bytes);
  void DropOldest(Robots::iterator robot);
  void DropForRoom(Robots::iterator robot, const char* why);
  void DropAll(Robots::iterator robot, const char* why);
  Robots::iterator Oldest();  // the robot that has the oldest frame; there must be one
  void MakeRoom(const std::string& robot, std::uint64_t bytes);
  void Bound(const std::string& robot);

  const std::filesystem::path folder_;
  const HistoryLimits limits_;
  std::unique_ptr<FolderLock> lock_;
  mutable std::mutex mutex_;
  std::vector<std::string> servers_;
  Robots robots_;
  std::size_t num_frames_ = 0;
  std::uint64_t bytes_ = 0, newest_ = 0;  // newest_: at least the largest id
  std::string shortage_;                  // why a frame within the span went last
  std::uint64_t short_until_ = 0;         // as ids
};

}  // namespace fovea::observer
