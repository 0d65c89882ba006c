#include "tool.h"

#include <pcl/core/exceptions.h>

#include <csignal>

namespace pcl::acmap {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t noted = 0;

void
note(int)
{
  noted = 1;
}

} // namespace

void
noteInterruptions()
{
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int signal : signals) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    // signals that the caller ignores (nohup) stay ignored
    if (before.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
}

void
obeyInterruptions()
{
  for (const int signal : signals) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == note)
      std::signal(signal, SIG_DFL);
  }
}

bool
interrupted()
{
  return noted != 0;
}

void
stopIfInterrupted()
{
  if (interrupted())
    throw CancelledException("interrupted");
}

} // namespace pcl::acmap
