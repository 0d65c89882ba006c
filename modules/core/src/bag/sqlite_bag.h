#pragma once

#include "bag/bag_index.h"

#include <memory>
#include <mutex>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace pcl::acmap {

/** \brief A file of a bag in the format SQLite 3, as ROS 2 recorded by default before MCAP:
 * tables `topics` and `messages`. Thread-safe. */
class SqliteBag {
public:
  /** \throws InputFileException as \ref BagFile */
  explicit SqliteBag(const std::string& path);

  /** \brief Reads its topics, and where its messages are: their offsets are the numbers of
   * their rows.
   * \throws InputFileException as \ref BagFile */
  BagIndex
  readIndex();

  /** \brief Reads the bytes of a message.
   * \throws InputFileException if the file was changed since */
  std::string
  load(const BagMessage& message);

private:
  struct Close {
    void
    operator()(sqlite3* database) const;
    void
    operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;

  [[noreturn]] void
  fail(const std::string& fault) const;

  [[noreturn]] void
  failDamaged(const std::string& why) const;

  Statement
  prepare(const char* query) const;

  /** \return false after the last row */
  bool
  step(const Statement& statement) const;

  /** \brief A view or a virtual table could compute rows without end. */
  void
  requireTables() const;

  void
  readTopics(BagIndex& index, std::vector<std::int64_t>& ids) const;

  std::string path_;
  std::uint64_t size_ = 0; ///< bytes
  std::unique_ptr<sqlite3, Close> database_;
  Statement load_;
  std::mutex mutex_;
};

} // namespace pcl::acmap
