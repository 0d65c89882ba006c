#include "bag/sqlite_bag.h"

#include "files/byte_source.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace pcl::acmap {

namespace {

/** \brief The URI of a file that is only read. A file that nobody writes is opened without
 * locks, so that its folder may be read-only. */
std::string
uriOf(const std::string& path)
{
  namespace fs = std::filesystem;
  std::string uri = "file:";
  for (const char letter : fs::absolute(path).string())
    uri += letter == '%'   ? "%25"
           : letter == '?' ? "%3f"
           : letter == '#' ? "%23"
                           : std::string(1, letter);
  std::error_code error;
  const bool has_journal = fs::exists(path + "-wal", error);
  return uri + (has_journal ? "?mode=ro" : "?mode=ro&immutable=1");
}

std::string
textAt(sqlite3_stmt* row, int column)
{
  const unsigned char* const text = sqlite3_column_text(row, column);
  return text ? reinterpret_cast<const char*>(text) : "";
}

} // namespace

void
SqliteBag::Close::operator()(sqlite3* database) const
{
  sqlite3_close_v2(database);
}

void
SqliteBag::Close::operator()(sqlite3_stmt* statement) const
{
  sqlite3_finalize(statement);
}

SqliteBag::SqliteBag(const std::string& path)
: path_(path)
, size_(ByteSource(path).size())
{
  sqlite3* database = nullptr;
  const int opened =
      sqlite3_open_v2(uriOf(path).c_str(),
                      &database,
                      SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_FULLMUTEX,
                      nullptr);
  database_.reset(database);
  if (!database)
    throw std::bad_alloc();
  if (opened != SQLITE_OK)
    fail(sqlite3_errmsg(database));
  // nothing that a file may define is run, and no value is longer than the file
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  constexpr std::uint64_t min_limit = 1 << 20, max_limit = 2147483647;
  sqlite3_limit(database,
                SQLITE_LIMIT_LENGTH,
                static_cast<int>(std::clamp(size_, min_limit, max_limit)));
  step(prepare("PRAGMA cache_size = -1000")); // KiB
  requireTables();
  const Statement page = prepare("PRAGMA page_size");
  if (!step(page) ||
      size_ % static_cast<std::uint64_t>(sqlite3_column_int64(page.get(), 0)) != 0)
    failDamaged("truncated");
}

void
SqliteBag::fail(const std::string& fault) const
{
  throw InputFileException(path_ + ": " + fault);
}

void
SqliteBag::failDamaged(const std::string& why) const
{
  fail("is damaged (" + why + "): sqlite3 " + path_ +
       " .recover | sqlite3 NEW.db3 repairs it");
}

SqliteBag::Statement
SqliteBag::prepare(const char* query) const
{
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), query, -1, &statement, nullptr) != SQLITE_OK)
    fail("is no bag of ROS 2, or a damaged one: " +
         std::string(sqlite3_errmsg(database_.get())));
  return Statement(statement);
}

bool
SqliteBag::step(const Statement& statement) const
{
  const int state = sqlite3_step(statement.get());
  if (state == SQLITE_NOMEM)
    throw std::bad_alloc();
  if (state != SQLITE_ROW && state != SQLITE_DONE)
    failDamaged(sqlite3_errmsg(database_.get()));
  return state == SQLITE_ROW;
}

void
SqliteBag::requireTables() const
{
  const Statement tables =
      prepare("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND "
              "rootpage > 0 AND name IN ('topics', 'messages')");
  step(tables);
  if (sqlite3_column_int(tables.get(), 0) != 2)
    fail("is no bag of ROS 2: it has no tables topics and messages");
}

void
SqliteBag::readTopics(BagIndex& index, std::vector<std::int64_t>& ids) const
{
  const Statement topics =
      prepare("SELECT id, name, type, serialization_format FROM topics");
  while (step(topics)) {
    if (ids.size() > size_)
      fail("is damaged: it has more topics than bytes");
    ids.push_back(sqlite3_column_int64(topics.get(), 0));
    index.channels.push_back(
        {textAt(topics.get(), 1), textAt(topics.get(), 2), textAt(topics.get(), 3)});
  }
}

BagIndex
SqliteBag::readIndex()
{
  BagIndex index;
  std::vector<std::int64_t> ids;
  readTopics(index, ids);
  std::map<std::int64_t, std::size_t> channels;
  for (std::size_t i = 0; i < ids.size(); ++i)
    channels[ids[i]] = i;
  const Statement rows = prepare(
      "SELECT rowid, topic_id, timestamp, length(data), typeof(data) FROM messages");
  constexpr std::uint64_t min_row_bytes = 8;
  while (step(rows)) {
    sqlite3_stmt* const row = rows.get();
    const auto channel = channels.find(sqlite3_column_int64(row, 1));
    if (channel == channels.end())
      fail("has a message of topic " + std::to_string(sqlite3_column_int64(row, 1)) +
           ", which is not among its topics");
    if (textAt(row, 4) != "blob" || index.messages.size() > size_ / min_row_bytes)
      fail("is damaged: its messages are none");
    BagMessage message;
    message.channel = channel->second;
    message.time = 1e-9 * static_cast<double>(sqlite3_column_int64(row, 2));
    message.offset = static_cast<std::uint64_t>(sqlite3_column_int64(row, 0));
    message.bytes = static_cast<std::uint64_t>(sqlite3_column_int64(row, 3));
    index.messages.push_back(message);
    ++index.channels[message.channel].messages;
  }
  return index;
}

std::string
SqliteBag::load(const BagMessage& message)
{
  const std::lock_guard lock(mutex_);
  if (!load_)
    load_ = prepare("SELECT data FROM messages WHERE rowid = ?");
  sqlite3_reset(load_.get());
  sqlite3_bind_int64(load_.get(), 1, static_cast<std::int64_t>(message.offset));
  if (!step(load_))
    fail("was changed while it was read");
  const auto* const bytes =
      static_cast<const char*>(sqlite3_column_blob(load_.get(), 0));
  const auto count = static_cast<std::size_t>(sqlite3_column_bytes(load_.get(), 0));
  return bytes ? std::string(bytes, count) : std::string();
}

} // namespace pcl::acmap
