#include "drawn_apart.h"

#include "exit_code.h"
#include "tool.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/process_memory.h>
#include <pcl/core/progress.h>
#include <pcl/visualization/display_connection.h>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

namespace pcl::acmap {
namespace {

/** \brief Result of a drawing process. */
struct Ended {
  int code = -1;    ///< its exit code; -1 if a signal ended it
  std::string said; ///< first line of its standard error
};

/** \brief Draws, and tells a failure on standard error. */
[[noreturn]] void
drawAndExit(const std::function<void()>& draw, int said_to)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN); // of the terminal; the parent process ends this one
  dup2(said_to, STDERR_FILENO);
  int code = exit_done;
  try {
    const UnlimitedMemory while_drawing;
    draw();
  }
  catch (...) {
    const Failure failure = failureOf(std::current_exception());
    code = failure.code;
    const std::string line = failure.line + "\n";
    if (write(said_to, line.data(), line.size()) < 0)
      code = exit_failed;
  }
  _exit(code);
}

/** \brief A child process that is killed if it is not waited for. */
class DrawingProcess {
public:
  explicit DrawingProcess(const std::function<void()>& draw)
  {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
      throw acmap::InitFailed(std::string("no pipe: ") + std::strerror(errno));
    process_ = fork();
    if (process_ == 0) {
      close(ends[0]);
      drawAndExit(draw, ends[1]);
    }
    close(ends[1]);
    said_ = ends[0];
    if (process_ < 0) {
      close(said_);
      throw acmap::InitFailed(std::string("no process: ") + std::strerror(errno));
    }
  }

  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess&
  operator=(const DrawingProcess&) = delete;

  ~DrawingProcess()
  {
    close(said_);
    if (process_ <= 0)
      return;
    kill(process_, SIGKILL);
    wait();
  }

  /** \throws CancelledException after an interruption */
  Ended
  end()
  {
    constexpr int between_looks = 50; // milliseconds
    std::string said;
    std::array<char, 512> part{};
    pollfd news = {said_, POLLIN, 0};
    while (true) {
      stopIfInterrupted();
      pollRun();
      if (poll(&news, 1, between_looks) <= 0)
        continue;
      const ssize_t size = read(said_, part.data(), part.size());
      if (size <= 0)
        break;
      said.append(part.data(), static_cast<std::size_t>(size));
    }
    const int status = wait();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, firstLine(said)};
  }

private:
  static std::string
  firstLine(const std::string& text)
  {
    const std::size_t begin = std::min(text.find_first_not_of(" \r\n"), text.size());
    return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  }

  int
  wait()
  {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR)
      ;
    process_ = -1;
    return status;
  }

  pid_t process_ = -1;
  int said_ = -1;
};

} // namespace

PicturesApart::PicturesApart(bool are_wanted, StageLog& log)
{
  if (!are_wanted)
    return;
  try {
    display_ = std::make_unique<DisplayConnection>();
  }
  catch (const InitFailedException&) {
    log.warn("no pictures: no X server answers; run the tool under xvfb-run -a");
  }
}

PicturesApart::~PicturesApart() = default;

bool
PicturesApart::draw(const std::function<void()>& draw, StageLog& log) const
{
  Ended ended;
  try {
    ended = DrawingProcess(draw).end();
  }
  catch (const InitFailedException& error) {
    ended.said = error.what();
  }
  catch (const CancelledException&) {
    throw InterruptedPartway("interrupted; all but the pictures is written");
  }
  if (ended.code == exit_output)
    throw OutputFileException(ended.said);
  if (ended.code != exit_done)
    log.warn("not all pictures could be drawn" +
             (ended.said.empty() ? std::string() : ": " + ended.said));
  return ended.code == exit_done;
}

} // namespace pcl::acmap
