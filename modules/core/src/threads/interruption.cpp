#include <pcl/core/exceptions.h>
#include <pcl/core/interruption.h>

#include <csignal>

namespace pcl::acmap {

namespace {

constexpr int interruptions[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t interruption_noted = 0;

void
noteInterruption(int)
{
  interruption_noted = 1;
}

} // namespace

void
noteInterruptions()
{
  struct sigaction action = {};
  action.sa_handler = noteInterruption;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int signal : interruptions) {
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
  for (const int signal : interruptions) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == noteInterruption)
      std::signal(signal, SIG_DFL);
  }
}

bool
interrupted()
{
  return interruption_noted != 0;
}

void
forgetInterruption()
{
  interruption_noted = 0;
  noteInterruptions();
}

void
stopIfInterrupted()
{
  if (interrupted())
    throw CancelledException("interrupted");
}

} // namespace pcl::acmap
