#include "run_tool.h"

#include "temporary_folder.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

namespace pcl::acmap::test {
namespace {

void
limit(int resource, const std::optional<std::size_t>& bytes)
{
  if (!bytes)
    return;
  const rlimit both = {*bytes, *bytes};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void
redirect(int descriptor, const std::string& path)
{
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, descriptor);
  close(file);
}

[[noreturn]] void
becomeTool(const std::string& program,
           const std::vector<std::string>& arguments,
           const RunSettings& settings,
           const std::string& out,
           const std::string& err)
{
  redirect(STDOUT_FILENO, out);
  redirect(STDERR_FILENO, err);
  for (const auto& [name, value] : settings.environment)
    value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
  limit(RLIMIT_FSIZE, settings.file_size_limit);
  limit(RLIMIT_AS, settings.memory_limit);
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execvp(program.c_str(), words.data());
  _exit(127);
}

/** \brief Whether the process has put a handler of its own in place. */
bool
heedsInterruptions(pid_t process)
{
  const std::string status = contentOf("/proc/" + std::to_string(process) + "/status");
  const std::size_t at = status.find("SigCgt:");
  if (at == std::string::npos)
    return false;
  const unsigned long long caught = std::strtoull(&status[at + 7], nullptr, 16);
  return (caught >> (SIGINT - 1)) & 1;
}

/** \brief Waits for something, but no longer than half a minute. */
void
waitFor(const std::function<bool()>& condition)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds(30);
  while (!condition() && Clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

void
interrupt(pid_t process, const RunSettings& settings)
{
  waitFor([&] { return heedsInterruptions(process); });
  if (settings.interrupt_when)
    waitFor(settings.interrupt_when);
  if (settings.interrupt_after)
    std::this_thread::sleep_for(
        std::chrono::duration<double>(*settings.interrupt_after));
  kill(process, settings.interruption);
}

} // namespace

std::size_t
ToolRun::errorLines() const
{
  return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n'));
}

ToolRun
runTool(const std::string& program,
        const std::vector<std::string>& arguments,
        const RunSettings& settings)
{
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  const std::string err = folder.path("err");
  const pid_t process = fork();
  if (process == 0)
    becomeTool(program, arguments, settings, out, err);
  if (settings.interrupt_after || settings.interrupt_when)
    interrupt(process, settings);
  int status = 0;
  waitpid(process, &status, 0);

  ToolRun run;
  if (WIFEXITED(status))
    run.exit_code = WEXITSTATUS(status);
  else
    run.signal = WTERMSIG(status);
  run.out = contentOf(out);
  run.err = contentOf(err);
  return run;
}

} // namespace pcl::acmap::test
