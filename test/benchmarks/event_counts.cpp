#include "event_counts.h"

#include "run_tool.h"
#include "temporary_folder.h"

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

/** A counter of the processor for the calling thread, without the system's part. */
class Counter {
public:
  explicit Counter(std::uint64_t event)
  {
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = event;
    attributes.disabled = 1;
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    file_ =
        static_cast<int>(::syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0UL));
  }

  ~Counter()
  {
    if (isOpen())
      ::close(file_);
  }

  Counter(const Counter&) = delete;
  Counter&
  operator=(const Counter&) = delete;

  bool
  isOpen() const
  {
    return file_ >= 0;
  }

  void
  start() const
  {
    ::ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
  }

  std::uint64_t
  stop() const
  {
    ::ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
    std::uint64_t count = 0;
    if (::read(file_, &count, sizeof count) != static_cast<ssize_t>(sizeof count))
      throw std::runtime_error("a counter of the processor cannot be read");
    return count;
  }

private:
  int file_ = -1;
};

/** The numbers of callgrind's summary, in the order of its events. */
EventCounts
readSummary(const std::string& path)
{
  EventCounts counts;
  std::vector<std::string> events;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "events:")
      for (std::string event; words >> event;)
        events.push_back(event);
    else if (key == "totals:")
      for (const std::string& event : events) {
        std::uint64_t count = 0;
        words >> count;
        if (event == "Ir")
          counts.instructions = count;
        else if (event == "Bcm" || event == "Bim") // conditional, indirect
          counts.mispredictions += count;
      }
  }
  return counts;
}

} // namespace

std::optional<EventCounts>
countByProcessor(const std::function<void()>& function)
{
  const Counter instructions(PERF_COUNT_HW_INSTRUCTIONS);
  const Counter mispredictions(PERF_COUNT_HW_BRANCH_MISSES);
  if (!instructions.isOpen() || !mispredictions.isOpen())
    return std::nullopt;
  instructions.start();
  mispredictions.start();
  function();
  return EventCounts{instructions.stop(), mispredictions.stop()};
}

EventCounts
countByCallgrind(const std::string& function, const std::vector<std::string>& arguments)
{
  const test::TemporaryFolder folder;
  const std::string counted = folder.path("callgrind.out");
  std::vector<std::string> all{"--tool=callgrind",
                               "--branch-sim=yes",
                               "--toggle-collect=" + function,
                               "--callgrind-out-file=" + counted,
                               std::filesystem::read_symlink("/proc/self/exe")};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const test::ToolRun run = test::runTool("valgrind", all);
  const EventCounts counts = readSummary(counted);
  if (run.exit_code != 0 || counts.instructions == 0)
    throw std::runtime_error("valgrind counted nothing: is it installed?\n" + run.err);
  return counts;
}

} // namespace pcl::acmap::bench
