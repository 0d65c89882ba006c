#include "bad_case.h"

#include <pcl/exceptions.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <exception>
#include <regex>
#include <sstream>
#include <typeinfo>

namespace pcl::acmap::test {

namespace {

constexpr unsigned time_limit = 20;              // seconds
constexpr rlim_t memory_limit = rlim_t{4} << 30; // bytes

#if defined(__has_feature)
#define ACMAP_HAS_FEATURE(feature) __has_feature(feature)
#else
#define ACMAP_HAS_FEATURE(feature) 0
#endif
/** Sanitizers reserve terabytes of addresses. */
constexpr bool limits_memory =
    !ACMAP_HAS_FEATURE(address_sanitizer) && !ACMAP_HAS_FEATURE(thread_sanitizer);

/** A message that a user can read: some words, no signature, no path. */
bool
isPlain(const std::string& message)
{
  std::istringstream text(message);
  std::size_t words = 0;
  for (std::string word; text >> word; ++words)
    if (word.find("::") != std::string::npos || word.find(".h") != std::string::npos ||
        word.find(".cpp") != std::string::npos)
      return false;
  return words >= 3 && message.front() != ':';
}

/** 'f' and a fault, 'r' and a refusal, or nothing. */
std::string
toldBy(const BadCase& bad)
{
  try {
    const Given given = bad.run();
    if (bad.answer == Answer::Refused)
      return "faccepted";
    if (!given.is_told && (given.is_empty || bad.answer == Answer::Told))
      return std::string("fsilence") + (given.is_empty ? ", nothing found" : "");
    return "";
  }
  catch (const PCLException& error) {
    return (isPlain(error.what()) ? "r" : "fno plain message: ") +
           std::string(error.what());
  }
  catch (const std::exception& error) {
    return std::string("f") + typeid(error).name() + ": " + error.what();
  }
}

[[noreturn]] void
runChild(const BadCase& bad, int pipe)
{
  if (limits_memory) {
    const rlimit limit{memory_limit, memory_limit};
    setrlimit(RLIMIT_AS, &limit);
  }
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  alarm(time_limit);
  const std::string told = toldBy(bad);
  const bool is_written =
      write(pipe, told.data(), told.size()) == static_cast<ssize_t>(told.size());
  _exit(is_written ? 0 : 1);
}

std::string
readAll(int pipe)
{
  std::string text;
  std::array<char, 4096> part;
  for (ssize_t size = 0; (size = read(pipe, part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(size));
  return text;
}

} // namespace

Ending
endingOf(const BadCase& bad)
{
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
    return {"no pipe", ""};
  const pid_t child = fork();
  if (child == 0)
    runChild(bad, ends[1]);
  close(ends[1]);
  const std::string told = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return {WTERMSIG(status) == SIGALRM
                ? "hang"
                : std::string("crash: ") + strsignal(WTERMSIG(status)),
            ""};
  if (WEXITSTATUS(status) != 0)
    return {"exit " + std::to_string(WEXITSTATUS(status)), ""};
  if (told.empty())
    return {};
  return told.front() == 'f' ? Ending{told.substr(1), ""} : Ending{"", told.substr(1)};
}

std::string
sentenceOf(const std::string& refusal)
{
  static const std::regex range(".* = [^ ]+ is refused: it must be .*"),
      number("-?([0-9][0-9.e+-]*|nan|inf)\\b"), file("^[^ ]+[.]pcd: "),
      input("no ([a-z]+ )?[a-z]+ (was|were) (set|added)");
  if (std::regex_match(refusal, range))
    return "NAME = # is refused: it must be LEGAL";
  const std::string sentence = std::regex_replace(refusal, file, "");
  return std::regex_replace(
      std::regex_replace(sentence, input, "no INPUT was set"), number, "#");
}

} // namespace pcl::acmap::test
