#include <pcl/pipeline/ranks.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace pcl {

Ranks::~Ranks() = default;

void
Ranks::send(std::size_t to, const Bytes& bytes)
{
  beginSending(to, bytes);
  ++messages_;
  bytes_ += bytes.size();
  for (std::size_t pauses = 0; !isSent();)
    pause(pauses);
}

Ranks::Bytes
Ranks::receive(std::size_t from)
{
  Bytes bytes;
  for (std::size_t pauses = 0; !tryReceiving(from, bytes);)
    pause(pauses);
  ++messages_;
  bytes_ += bytes.size();
  return bytes;
}

/** The longer a process waits, the longer are its pauses: the others need the processors. */
void
Ranks::pause(std::size_t& pauses) const
{
  constexpr std::size_t longest = 1000; // microseconds; long messages move in between
  ++pauses;
  std::this_thread::sleep_for(
      std::chrono::microseconds(std::min(longest, 20 * pauses)));
  if (idle_)
    idle_();
}

} // namespace pcl
