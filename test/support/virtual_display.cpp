#include "virtual_display.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

[[noreturn]] void
becomeServer(int number_to, const std::string& screen)
{
  // a crashing test must not leave a server behind, which would keep ctest's pipe open
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const std::string descriptor = std::to_string(number_to);
  execlp("Xvfb",
         "Xvfb",
         "-displayfd",
         descriptor.c_str(),
         "-screen",
         "0",
         screen.c_str(),
         "-noreset",
         "-nolisten",
         "tcp",
         nullptr);
  _exit(127);
}

/** \brief The line that the server writes when it is ready; empty if it fails. */
std::string
lineFrom(int descriptor)
{
  std::string line;
  for (char c = 0; read(descriptor, &c, 1) == 1 && c != '\n';)
    line += c;
  return line;
}

} // namespace

VirtualDisplay::VirtualDisplay()
{
  if (const char* name = std::getenv("DISPLAY"); name && *name)
    exists_ = true;
  else
    start("1280x960x24");
}

VirtualDisplay::VirtualDisplay(const std::string& screen)
{
  start(screen);
}

const VirtualDisplay&
VirtualDisplay::shared()
{
  // never destroyed: libraries may still talk to it when the program ends, and then it ends
  static const auto* const display = new VirtualDisplay;
  return *display;
}

VirtualDisplay::~VirtualDisplay()
{
  stop();
}

void
VirtualDisplay::start(const std::string& screen)
{
  int ends[2];
  if (pipe(ends) != 0)
    return;
  server_ = fork();
  if (server_ == 0)
    becomeServer(ends[1], screen);
  close(ends[1]);
  const std::string number = lineFrom(ends[0]);
  close(ends[0]);
  exists_ = !number.empty();
  if (!exists_)
    return;
  if (const char* name = std::getenv("DISPLAY"))
    display_before_ = name;
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

void
VirtualDisplay::stop()
{
  if (server_ <= 0)
    return;
  if (display_before_.empty())
    unsetenv("DISPLAY");
  else
    setenv("DISPLAY", display_before_.c_str(), 1);
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
  server_ = -1;
  exists_ = false;
}

StopAtFile::StopAtFile(VirtualDisplay& display, const std::string& path)
: thread_([this, &display, path] {
  while (!is_over_ && !std::filesystem::exists(path))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  display.stop();
})
{}

StopAtFile::~StopAtFile()
{
  is_over_ = true;
  thread_.join();
}

} // namespace pcl::acmap::test
