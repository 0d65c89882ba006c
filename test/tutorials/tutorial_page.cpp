#include "tutorial_page.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pcl::acmap::test {
namespace {

const std::string fence = "```";

/** \brief A page, line by line. */
class PageReader {
public:
  explicit PageReader(const std::string& markdown)
  : text_(markdown)
  {}

  TutorialPage
  read()
  {
    std::string line;
    while (next(line)) {
      const std::size_t indent = line.find_first_not_of(' ');
      if (indent == std::string::npos)
        continue;
      if (line.compare(indent, fence.size(), fence) == 0)
        takeBlock(line.substr(indent + fence.size()), indent);
      else
        takeText(line);
    }
    if (page_.steps.empty() || page_.pictures.empty())
      throw std::runtime_error("a tutorial needs something to do and a picture");
    return std::move(page_);
  }

private:
  bool
  next(std::string& line)
  {
    ++number_;
    return static_cast<bool>(std::getline(text_, line));
  }

  void
  takeText(const std::string& line)
  {
    static const std::regex named("^ *`([^`/ ]+)`:$");
    static const std::regex shown(
        R"(!\[[^\]]*\]\(\.\./pictures/tutorials/([^/)]+\.png)\))");
    std::smatch found;
    file_ = std::regex_match(line, found, named) ? found[1].str() : "";
    for (std::sregex_iterator at(line.begin(), line.end(), shown), end; at != end; ++at)
      page_.pictures.push_back((*at)[1]);
  }

  void
  takeBlock(const std::string& language, std::size_t indent)
  {
    TutorialStep step;
    step.line = number_;
    step.name = std::exchange(file_, "");
    for (std::string line; next(line);) {
      if (line.find(fence) == line.find_first_not_of(' ') && line.size() > indent) {
        keep(std::move(step), language);
        return;
      }
      step.text += line.substr(std::min(indent, line.size())) + "\n";
    }
    throw std::runtime_error("block of line " + std::to_string(step.line) + " is open");
  }

  void
  keep(TutorialStep step, const std::string& language)
  {
    const bool follows_script =
        !page_.steps.empty() && page_.steps.back().kind == TutorialStep::Kind::Script;
    if (language == "console")
      return;
    if (!step.name.empty())
      step.kind = TutorialStep::Kind::File;
    else if (language == "text" && follows_script)
      step.kind = TutorialStep::Kind::Output;
    else if (language != "sh")
      throw std::runtime_error("block of line " + std::to_string(step.line) +
                               " is neither to be run nor to be written nor output");
    page_.steps.push_back(std::move(step));
  }

  std::istringstream text_;
  int number_ = 0;
  std::string file_; // named in the line before the block
  TutorialPage page_;
};

} // namespace

TutorialPage
parseTutorial(const std::string& markdown)
{
  return PageReader(markdown).read();
}

} // namespace pcl::acmap::test
