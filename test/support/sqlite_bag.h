#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

namespace pcl::acmap::test {

/** \brief Writes bags of ROS 2 with the tables that rosbag2_storage_sqlite3 makes. */
class SqliteWriter {
public:
  explicit SqliteWriter(const std::string& path)
  {
    if (sqlite3_open(path.c_str(), &database_) != SQLITE_OK)
      throw std::runtime_error(path);
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT "
        "NULL, serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
        "timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
        "CREATE INDEX timestamp_idx ON messages (timestamp ASC);");
  }

  ~SqliteWriter()
  {
    sqlite3_close(database_);
  }

  SqliteWriter(const SqliteWriter&) = delete;
  SqliteWriter&
  operator=(const SqliteWriter&) = delete;

  void
  add(const std::string& topic,
      const std::string& type,
      double time,
      const std::string& message)
  {
    const auto [known, is_new] = topics_.emplace(topic, topics_.size() + 1);
    if (is_new)
      run("INSERT INTO topics VALUES(" + std::to_string(known->second) + ", '" + topic +
          "', '" + type + "', 'cdr', '')");
    sqlite3_stmt* row = nullptr;
    sqlite3_prepare_v2(
        database_,
        "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)",
        -1,
        &row,
        nullptr);
    sqlite3_bind_int64(row, 1, static_cast<std::int64_t>(known->second));
    sqlite3_bind_int64(row, 2, static_cast<std::int64_t>(1e9 * time));
    sqlite3_bind_blob(
        row, 3, message.data(), static_cast<int>(message.size()), SQLITE_TRANSIENT);
    const int state = sqlite3_step(row);
    sqlite3_finalize(row);
    if (state != SQLITE_DONE)
      throw std::runtime_error(sqlite3_errmsg(database_));
  }

  void
  run(const std::string& query)
  {
    if (sqlite3_exec(database_, query.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
      throw std::runtime_error(sqlite3_errmsg(database_));
  }

private:
  sqlite3* database_ = nullptr;
  std::map<std::string, std::size_t> topics_;
};

} // namespace pcl::acmap::test
