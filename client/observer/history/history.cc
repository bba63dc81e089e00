#include "client/observer/history/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <ratio>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace fovea::observer {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".frame";
constexpr const char* kTooLittle = "--history-size is too little";

// Of "0001700000000000000.frame".
std::optional<std::uint64_t> IdOf(const fs::path& path) {
  const std::string stem = path.stem().string();
  std::uint64_t id = 0;
  const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), id);
  if (path.extension() != kEnding || error != std::errc{} || end != stem.data() + stem.size()) {
    return std::nullopt;
  }
  return id;
}

bool IsFull(const std::error_code& error) {
  return error == std::errc::no_space_on_device || error.value() == EDQUOT;
}

std::uint64_t SpanOf(const HistoryLimits& limits) {
  return static_cast<std::uint64_t>(std::chrono::microseconds(limits.span).count());
}

}  // namespace

History::History(fs::path folder, const HistoryLimits& limits)
    : folder_(std::move(folder)), limits_(limits), lock_(std::make_unique<FolderLock>(folder_)) {
  Load();
}

void History::Load() {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    if (entry.is_directory(error) && !entry.is_symlink(error)) LoadRobot(entry.path());
  }
  if (error) throw std::system_error(error, "--history: " + folder_.string());
}

// Where the folder was moved away, what is there now is the history.
void History::FollowFolder() {
  if (lock_->IsInPlace()) return;
  lock_ = std::make_unique<FolderLock>(folder_);
  robots_.clear();
  num_frames_ = 0;
  bytes_ = newest_ = short_until_ = 0;
  Load();
}

// No frame is of the future: what came while the clock was ahead goes back with it. Else it would
// never be old, and all that comes now would have its time.
void History::FollowClock(std::uint64_t now) {
  constexpr std::uint64_t kNoise = 1'000'000;
  if (newest_ <= now + kNoise) return;
  for (auto robot = robots_.begin(); robot != robots_.end(); ++robot) {
    const std::uint64_t newest = robot->second.frames.back().id;
    if (newest > now) MoveBack(robot, newest - now);
  }
  newest_ = now;
  short_until_ = std::min(short_until_, now + SpanOf(limits_));
}

// In microseconds, by less than the newest one has.
void History::MoveBack(Robots::iterator robot, std::uint64_t by) {
  while (robot->second.frames.front().id <= by) DropOldest(robot);
  for (Kept& frame : robot->second.frames) {
    std::error_code ignored;  // it may be gone
    fs::rename(PathOf(robot->first, frame.id), PathOf(robot->first, frame.id - by), ignored);
    frame.id -= by;
  }
}

void History::LoadRobot(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);  // by their numbers, which have as many digits
  std::string robot;
  for (const fs::path& path : files) {
    const auto id = IdOf(path);
    const auto header = id ? ReadHistoryHeader(path) : std::nullopt;
    if (!header || FolderNameOf(header->robot) != folder.filename()) {
      if (id || path.extension() == ".part") fs::remove(path, error);
      continue;
    }
    robot = header->robot;
    Keep(robot, {.id = *id,
                 .server = NumberOf(header->server),
                 .objects = header->objects,
                 .bytes = fs::file_size(path, error),
                 .problem = header->problem});
  }
  if (!robot.empty()) Bound(robot);
  fs::remove(folder, error);  // where it is empty
}

fs::path History::FolderOf(const std::string& robot) const { return folder_ / FolderNameOf(robot); }

fs::path History::PathOf(const std::string& robot, std::uint64_t id) const {
  return FolderOf(robot) / fmt::format("{:020}{}", id, kEnding);
}

std::uint32_t History::NumberOf(const std::string& server) {
  const auto found = std::ranges::find(servers_, server);
  const auto number = static_cast<std::uint32_t>(found - servers_.begin());
  if (found == servers_.end()) servers_.push_back(server);
  return number;
}

void History::Add(const HistoryRecord& record, std::chrono::system_clock::time_point now) {
  const std::string robot = record.header.robot;
  if (robot.empty()) return;
  const std::lock_guard lock(mutex_);
  FollowFolder();
  const auto at = std::chrono::floor<std::chrono::microseconds>(now).time_since_epoch().count();
  auto id = static_cast<std::uint64_t>(std::max<std::int64_t>(at, 1));
  FollowClock(id);
  const auto found = robots_.find(robot);
  if (found != robots_.end()) id = std::max(id, found->second.frames.back().id + 1);
  const std::uint64_t bytes = HistoryFileSize(record);
  MakeRoom(robot, bytes);
  Write(record, id, bytes);
  Keep(robot, {.id = id,
               .server = NumberOf(record.header.server),
               .objects = record.header.objects,
               .bytes = bytes,
               .problem = record.header.problem});
  Bound(robot);
}

void History::Keep(const std::string& robot, const Kept& frame) {
  Robot& kept = robots_[robot];
  kept.frames.push_back(frame);
  kept.bytes += frame.bytes;
  bytes_ += frame.bytes;
  newest_ = std::max(newest_, frame.id);
  ++num_frames_;
}

// A disk may have less room than the history may take: there, too, the oldest goes. The reason is
// told without the name of the file, so that it is the same for all.
void History::Write(const HistoryRecord& record, std::uint64_t id, std::uint64_t bytes) {
  const std::uint64_t before = bytes_;
  while (true) {
    try {
      MakeFolder(FolderOf(record.header.robot));
      WriteHistoryFile(PathOf(record.header.robot, id), record);
      return;
    } catch (const std::system_error& error) {
      const bool can_shrink = IsFull(error.code()) && num_frames_ > 0 && before - bytes_ <= bytes;
      if (!can_shrink) {
        throw std::runtime_error("cannot write to " + folder_.string() + ": " +
                                 error.code().message());
      }
      DropForRoom(Oldest(), "the disk is full");
    }
  }
}

void History::DropOldest(Robots::iterator robot) {
  const Kept frame = robot->second.frames.front();
  std::error_code ignored;  // it may be gone
  fs::remove(PathOf(robot->first, frame.id), ignored);
  robot->second.frames.pop_front();
  robot->second.bytes -= frame.bytes;
  bytes_ -= frame.bytes;
  --num_frames_;
  if (!robot->second.frames.empty()) return;
  fs::remove(FolderOf(robot->first), ignored);
  robots_.erase(robot);
}

// What is missing since is whole again once the span has passed.
void History::DropForRoom(Robots::iterator robot, const char* why) {
  const std::uint64_t span = SpanOf(limits_);
  if (robot->second.frames.front().id + span > newest_) {
    shortage_ = why;
    short_until_ = newest_ + span;
  }
  DropOldest(robot);
}

std::string History::Shortage() const {
  const std::lock_guard lock(mutex_);
  if (newest_ >= short_until_) return {};
  const auto minutes = std::chrono::duration<double, std::ratio<60>>(limits_.span);
  return fmt::format("holds less than {:g} minutes: {}", minutes.count(), shortage_);
}

void History::DropAll(Robots::iterator robot, const char* why) {
  for (std::size_t left = robot->second.frames.size(); left > 0; --left) DropForRoom(robot, why);
}

// Before a frame of this size is written, so that what is on disk never takes more than it may.
void History::MakeRoom(const std::string& name, std::uint64_t bytes) {
  for (auto robot = robots_.find(name);
       robot != robots_.end() && robot->second.bytes + bytes > limits_.max_bytes / 2;
       robot = robots_.find(name)) {
    DropForRoom(robot, kTooLittle);
  }
  while (num_frames_ > 0 && bytes_ + bytes > limits_.max_bytes) DropForRoom(Oldest(), kTooLittle);
}

History::Robots::iterator History::Oldest() {
  return std::ranges::min_element(robots_, {},
                                  [](const auto& each) { return each.second.frames.front().id; });
}

// Of the robot that got a frame first, then of all.
void History::Bound(const std::string& name) {
  const auto robot = robots_.find(name);
  const std::uint64_t span = SpanOf(limits_);
  const std::uint64_t newest = robot->second.frames.back().id;
  while (robot->second.frames.size() > 1 && (robot->second.frames.front().id + span < newest ||
                                             robot->second.bytes > limits_.max_bytes / 2)) {
    DropForRoom(robot, kTooLittle);
  }
  while (robots_.size() > limits_.max_robots) {
    const auto quietest = std::ranges::min_element(
        robots_, {}, [](const auto& each) { return each.second.frames.back().id; });
    DropAll(quietest, "it has the most robots");
  }
  while (num_frames_ > limits_.max_frames || bytes_ > limits_.max_bytes) {
    DropForRoom(Oldest(), bytes_ > limits_.max_bytes ? kTooLittle : "it has the most frames");
  }
}

std::vector<History::Entry> History::List(const std::string& robot, const MaySee& may_see) const {
  const std::lock_guard lock(mutex_);
  std::vector<Entry> entries;
  const auto found = robots_.find(robot);
  if (found == robots_.end()) return entries;
  std::vector<bool> is_seen;
  for (const std::string& server : servers_) is_seen.push_back(may_see(server));
  for (const Kept& frame : found->second.frames) {
    if (!is_seen[frame.server]) continue;
    entries.push_back({.id = frame.id,
                       .server = servers_[frame.server],
                       .objects = frame.objects,
                       .problem = frame.problem});
  }
  return entries;
}

std::map<std::string, std::uint64_t> History::NewestOf(const std::string& server) const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, std::uint64_t> newest;
  const auto number = std::ranges::find(servers_, server) - servers_.begin();
  for (const auto& [name, robot] : robots_) {
    const auto found = std::ranges::find(robot.frames.rbegin(), robot.frames.rend(), number,
                                         [](const Kept& each) { return each.server; });
    if (found != robot.frames.rend()) newest[name] = found->id;
  }
  return newest;
}

std::optional<HistoryRecord> History::Read(const std::string& robot, std::uint64_t id) const {
  {
    const std::lock_guard lock(mutex_);
    const auto found = robots_.find(robot);
    if (found == robots_.end() ||
        !std::ranges::binary_search(found->second.frames, id, {}, &Kept::id)) {
      return std::nullopt;
    }
  }
  auto record = ReadHistoryFile(PathOf(robot, id));  // it may be dropped meanwhile
  return record && record->header.robot == robot ? record : std::nullopt;
}

History::Counts History::counts() const {
  const std::lock_guard lock(mutex_);
  return {.robots = robots_.size(), .frames = num_frames_, .bytes = bytes_};
}

}  // namespace fovea::observer
