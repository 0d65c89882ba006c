#include "pacing.h"

#include <poll.h>
#include <unistd.h>

#include <string>
#include <thread>

namespace pcl::acmap {

namespace {

constexpr std::chrono::milliseconds between_looks(50);

/** \brief Returns the line that was typed, up to Enter; nothing if there is none
 * yet. */
std::optional<std::string>
typedLine()
{
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, static_cast<int>(between_looks.count())) <= 0)
    return std::nullopt;
  char text[256];
  const ssize_t count = read(STDIN_FILENO, text, sizeof(text));
  return count > 0 ? std::string(text, static_cast<std::size_t>(count)) : std::string();
}

} // namespace

Pacing::Pacing(const std::optional<double>& every)
: every_(every)
, asks_(!every && isatty(STDIN_FILENO) != 0)
{}

void
Pacing::begin()
{
  begin_ = Clock::now();
}

bool
Pacing::wait(const std::function<void()>& idle)
{
  if (every_)
    while (std::chrono::duration<double>(Clock::now() - begin_).count() < *every_) {
      idle();
      std::this_thread::sleep_for(between_looks);
    }
  while (asks_) {
    idle();
    if (const auto line = typedLine())
      return !line->empty() && line->front() != 'q';
  }
  return true;
}

} // namespace pcl::acmap
