#pragma once

#include <pcl/pipeline/ranks.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace pcl::acmap::test {

/** \brief Messages on their way between ranks. */
class Mailboxes {
public:
  using Way = std::pair<std::size_t, std::size_t>; // from, to

  void
  put(const Way& way, const Ranks::Bytes& bytes)
  {
    const std::lock_guard lock(mutex_);
    messages_[way].push_back(bytes);
  }

  bool
  take(const Way& way, Ranks::Bytes& bytes)
  {
    const std::lock_guard lock(mutex_);
    std::deque<Ranks::Bytes>& waiting = messages_[way];
    if (waiting.empty())
      return false;
    bytes = std::move(waiting.front());
    waiting.pop_front();
    return true;
  }

  bool
  isEmpty()
  {
    const std::lock_guard lock(mutex_);
    return std::all_of(messages_.begin(), messages_.end(), [](const auto& way) {
      return way.second.empty();
    });
  }

private:
  std::mutex mutex_;
  std::map<Way, std::deque<Ranks::Bytes>> messages_;
};

/** \brief One of several ranks in the threads of one process. */
class ThreadRanks : public Ranks {
public:
  ThreadRanks(std::size_t rank, std::size_t size, std::shared_ptr<Mailboxes> mailboxes)
  : rank_(rank)
  , size_(size)
  , mailboxes_(std::move(mailboxes))
  {}

  std::size_t
  rank() const override
  {
    return rank_;
  }

  std::size_t
  size() const override
  {
    return size_;
  }

protected:
  void
  beginSending(std::size_t to, const Bytes& bytes) override
  {
    mailboxes_->put({rank_, to}, bytes);
  }

  bool
  isSent() override
  {
    return true;
  }

  bool
  tryReceiving(std::size_t from, Bytes& bytes) override
  {
    return mailboxes_->take({from, rank_}, bytes);
  }

private:
  std::size_t rank_, size_;
  std::shared_ptr<Mailboxes> mailboxes_;
};

} // namespace pcl::acmap::test
