#include "client/cli/bag/sqlite_bag.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <map>
#include <mutex>
#include <stdexcept>

namespace fovea::cli {
namespace {

constexpr int kMostOfMessage = 512 << 20;

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* query) const { sqlite3_finalize(query); }
};
using Database = std::unique_ptr<sqlite3, Close>;
using Query = std::unique_ptr<sqlite3_stmt, Close>;

// Of a question; a journal is only looked at then.
[[noreturn]] void Fail(sqlite3* database) {
  if (sqlite3_errcode(database) == SQLITE_NOTADB) {
    throw std::invalid_argument("it is no SQLite database");
  }
  const int code = sqlite3_errcode(database) & 0xFF;  // without what it says in detail
  const std::string what = sqlite3_errmsg(database);
  if (code != SQLITE_READONLY && code != SQLITE_CANTOPEN) throw std::invalid_argument(what);
  throw std::invalid_argument(
      what +
      ": its recorder was killed or keeps a journal beside it; copy both to a folder that may be "
      "written to, and complete it there with: sqlite3 FILE .schema");
}

Database Open(const std::string& path) {
  sqlite3* opened = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
  Database database(opened);
  if (result != SQLITE_OK) throw std::invalid_argument(sqlite3_errmsg(opened));
  // What a stranger's database may bring: expressions in its tables, values of any size.
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, kMostOfMessage);
  return database;
}

std::string_view Bytes(sqlite3_stmt* query, int column) {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(query, column));
  const int size = sqlite3_column_bytes(query, column);
  return data == nullptr ? std::string_view()
                         : std::string_view(data, static_cast<std::size_t>(size));
}

struct Topic {
  std::string name, type, encoding;
};

class SqliteBag : public BagFile {
 public:
  explicit SqliteBag(const std::string& path) : database_(Open(path)) {
    const Query query = Prepare(
        "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN ('topics', "
        "'messages')");
    if (sqlite3_step(query.get()) != SQLITE_ROW) Fail(database_.get());
    if (sqlite3_column_int(query.get(), 0) == 2) return;
    throw std::invalid_argument("it is no bag of ROS 2: it has no tables topics and messages");
  }

  std::vector<std::string> ForEachMessage(
      const std::function<void(const BagMessage&)>& use) const override {
    const std::lock_guard lock(mutex_);
    const std::map<std::int64_t, Topic> topics = ReadTopics();
    const Query query = Prepare("SELECT id, topic_id, timestamp, data FROM messages ORDER BY id");
    std::uint64_t count = 0;
    int result = sqlite3_step(query.get());
    for (; result == SQLITE_ROW; result = sqlite3_step(query.get()), ++count) {
      const auto topic = topics.find(sqlite3_column_int64(query.get(), 1));
      if (topic == topics.end()) continue;
      const auto& [name, type, encoding] = topic->second;
      const auto row = static_cast<std::uint64_t>(sqlite3_column_int64(query.get(), 0));
      use({name,
           type,
           encoding,
           sqlite3_column_int64(query.get(), 2),
           Bytes(query.get(), 3),
           {.start = row}});
    }
    if (result == SQLITE_DONE) return {};
    return {fmt::format("cannot be read behind its message {} ({})", count,
                        sqlite3_errmsg(database_.get()))};
  }

  std::string DataAt(const MessagePlace& place) const override {
    const std::lock_guard lock(mutex_);
    const Query query = Prepare("SELECT data FROM messages WHERE id = ?");
    sqlite3_bind_int64(query.get(), 1, static_cast<sqlite3_int64>(place.start));
    const int result = sqlite3_step(query.get());
    if (result == SQLITE_ROW) return std::string(Bytes(query.get(), 0));
    if (result == SQLITE_DONE) throw std::invalid_argument("it is not there any more");
    Fail(database_.get());
  }

 private:
  Query Prepare(const char* text) const {
    sqlite3_stmt* query = nullptr;
    if (sqlite3_prepare_v2(database_.get(), text, -1, &query, nullptr) != SQLITE_OK) {
      Fail(database_.get());
    }
    return Query(query);
  }

  std::map<std::int64_t, Topic> ReadTopics() const {
    const Query query = Prepare("SELECT id, name, type, serialization_format FROM topics");
    const auto text = [&](int column) {
      return std::string(Bytes(query.get(), column).substr(0, kLongestName));
    };
    std::map<std::int64_t, Topic> topics;
    int result = sqlite3_step(query.get());
    for (; result == SQLITE_ROW; result = sqlite3_step(query.get())) {
      topics[sqlite3_column_int64(query.get(), 0)] = {text(1), text(2), text(3)};
    }
    if (result != SQLITE_DONE) Fail(database_.get());
    return topics;
  }

  mutable std::mutex mutex_;
  Database database_;
};

}  // namespace

std::shared_ptr<const BagFile> SqliteBagFile(const std::string& path) {
  return std::make_shared<SqliteBag>(path);
}

}  // namespace fovea::cli
