// Makes small ROS 2 bags of SQLite, with the tables of Humble.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>

namespace fovea::cli::small_bags {

class SqliteWriter {
 public:
  explicit SqliteWriter(const std::string& path) {
    sqlite3_open(path.c_str(), &database_);
    Run("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF");  // as the recorder has it
    Run("CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL)");
    Run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
    Run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
        "INTEGER NOT NULL, data BLOB NOT NULL)");
    Run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  }
  ~SqliteWriter() { sqlite3_close(database_); }
  SqliteWriter(const SqliteWriter&) = delete;
  SqliteWriter& operator=(const SqliteWriter&) = delete;

  void Run(const std::string& text) {
    EXPECT_EQ(sqlite3_exec(database_, text.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << text << ": " << sqlite3_errmsg(database_);
  }

  // `type`: "Image" of sensor_msgs/msg. Each message brings a topic of its own.
  void Add(const std::string& topic, const std::string& type, const std::string& message) {
    const std::string id = std::to_string(next_id_++);
    Run("INSERT INTO topics VALUES(" + id + ", '" + topic + "', 'sensor_msgs/msg/" + type +
        "', 'cdr', '')");
    sqlite3_stmt* query = nullptr;
    const std::string text = "INSERT INTO messages VALUES(NULL, " + id + ", 2000000000, ?)";
    sqlite3_prepare_v2(database_, text.c_str(), -1, &query, nullptr);
    sqlite3_bind_blob(query, 1, message.data(), static_cast<int>(message.size()), SQLITE_STATIC);
    EXPECT_EQ(sqlite3_step(query), SQLITE_DONE) << sqlite3_errmsg(database_);
    sqlite3_finalize(query);
  }

 private:
  sqlite3* database_ = nullptr;
  int next_id_ = 1;
};

}  // namespace fovea::cli::small_bags
