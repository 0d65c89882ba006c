#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl {

/** \brief The processes that make one map together, and messages between them
 * (\ref MpiRanks). Rank 0 leads: the others do what it asks for (\ref serveRanks).
 * \ingroup pipeline */
class ACMAP_EXPORT Ranks {
public:
  using Bytes = std::vector<std::uint8_t>;

  virtual ~Ranks();

  /** \brief Number of this process, from 0. */
  virtual std::size_t
  rank() const = 0;

  /** \brief Number of processes, at least 1. */
  virtual std::size_t
  size() const = 0;

  /** \brief Sends a message to a rank, and may wait until it is received.
   * \throws what the idle callback throws */
  void
  send(std::size_t to, const Bytes& bytes);

  /** \brief Waits for the next message of a rank, without using the processor.
   * \throws what the idle callback throws */
  Bytes
  receive(std::size_t from);

  /** \brief Sets what is called again and again while this process waits. What it throws
   * ends the waiting. */
  void
  setIdleCallback(std::function<void()> idle)
  {
    idle_ = std::move(idle);
  }

  /** \brief Number of messages that this process has sent and received. */
  std::size_t
  getNumberOfMessages() const
  {
    return messages_;
  }

  /** \brief Length of these messages in bytes. */
  std::size_t
  getNumberOfBytes() const
  {
    return bytes_;
  }

protected:
  /** \brief Begins to send a message, which stays unchanged until \ref isSent. */
  virtual void
  beginSending(std::size_t to, const Bytes& bytes) = 0;

  virtual bool
  isSent() = 0;

  /** \brief Receives the next message of a rank; called with the same arguments until the
   * message has arrived. */
  virtual bool
  tryReceiving(std::size_t from, Bytes& bytes) = 0;

private:
  void
  pause(std::size_t& pauses) const;

  std::function<void()> idle_;
  std::size_t messages_ = 0;
  std::size_t bytes_ = 0;
};

} // namespace pcl
