#include "run_tool.h"

#include "temporary_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>
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

void
talkToNobody()
{
  int ends[2];
  if (pipe(ends) != 0)
    _exit(127);
  dup2(ends[1], STDOUT_FILENO);
  dup2(ends[1], STDERR_FILENO);
  close(ends[0]);
  close(ends[1]);
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
  if (settings.reader_is_gone)
    talkToNobody();
  for (const int signal : {SIGINT, SIGPIPE, SIGTERM})
    std::signal(signal, SIG_DFL); // ignored signals would be inherited
  for (const auto& [name, value] : settings.environment)
    value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
  limit(RLIMIT_FSIZE, settings.file_size_limit);
  limit(RLIMIT_AS, settings.memory_limit);
  if (!settings.folder.empty() && chdir(settings.folder.c_str()) != 0)
    _exit(127);
  alarm(settings.time_limit); // stays active after exec
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execvp(program.c_str(), words.data());
  _exit(127);
}

/** \brief Does the process have a handler for SIGINT? */
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

bool
hasEnded(pid_t process)
{
  siginfo_t info = {};
  const auto id = static_cast<id_t>(process);
  return waitid(P_PID, id, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
}

/** \brief Waits for a condition, but at most 30 s. */
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
  waitFor([&] { return heedsInterruptions(process) || hasEnded(process); });
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
ToolRun::succeeded() const
{
  if (exit_code != 0)
    throw std::runtime_error("ended with code " + std::to_string(exit_code) +
                             ", signal " + std::to_string(signal) + "\n" + err);
  return *this;
}

ToolRun
runTool(const std::string& program,
        const std::vector<std::string>& arguments,
        const RunSettings& settings)
{
  const TemporaryFolder folder;
  const std::string out =
      settings.out_file.empty() ? folder.path("out") : settings.out_file;
  const std::string err = folder.path("err");
  const pid_t process = fork();
  if (process == 0)
    becomeTool(program, arguments, settings, out, err);
  if (settings.interrupt_after || settings.interrupt_when)
    interrupt(process, settings);
  int status = 0;
  waitpid(process, &status, 0);

  ToolRun run;
  run.name = std::filesystem::path(program).filename().string();
  if (WIFEXITED(status))
    run.exit_code = WEXITSTATUS(status);
  else
    run.signal = WTERMSIG(status);
  if (settings.out_file.empty())
    run.out = contentOf(out);
  run.err = contentOf(err);
  return run;
}

std::vector<std::string>
joined(std::vector<std::string> arguments, const std::vector<std::string>& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

void
expectFails(const ToolRun& run, int exit_code, const std::string& word)
{
  EXPECT_EQ(run.exit_code, exit_code) << "signal " << run.signal << "\n" << run.err;
  EXPECT_EQ(run.out, "");
  const std::string lines = run.err.substr(0, run.err.size() - !run.err.empty());
  const std::string last = lines.substr(lines.rfind('\n') + 1);
  EXPECT_THAT(last, testing::StartsWith(run.name + ": "));
  EXPECT_THAT(last, testing::HasSubstr(word));
}

void
expectRefused(const ToolRun& run, int exit_code, const std::string& word)
{
  expectFails(run, exit_code, word);
  EXPECT_EQ(run.errorLines(), 1U) << run.err;
}

} // namespace pcl::acmap::test
