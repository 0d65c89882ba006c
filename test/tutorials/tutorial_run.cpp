#include "tutorial_run.h"

#include "run_tool.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <numeric>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

/** \brief Runs a script in the folder; returns its standard and error output. */
std::string
runScript(const TutorialStep& step, const std::string& folder)
{
  const ToolRun run =
      runTool("sh", {"-euc", "cd '" + folder + "'\nexec 2>&1\n" + step.text});
  if (run.exit_code != 0)
    throw std::runtime_error("script of line " + std::to_string(step.line) +
                             " failed with " + std::to_string(run.exit_code) + ":\n" +
                             run.out + run.err);
  return run.out;
}

void
writeFile(const TutorialStep& step, const std::string& folder)
{
  std::ofstream file(folder + "/" + step.name, std::ios::binary);
  if (!(file << step.text << std::flush))
    throw std::runtime_error("cannot write " + step.name);
}

/** \brief Splits a line into words and numbers. */
std::vector<std::string>
partsOf(const std::string& line)
{
  static const std::regex part(R"(-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?|[^0-9\s-]+|-)");
  std::vector<std::string> parts;
  for (std::sregex_iterator at(line.begin(), line.end(), part), end; at != end; ++at)
    parts.push_back(at->str());
  return parts;
}

bool
areAlike(const std::string& a, const std::string& b)
{
  if (a == b)
    return true;
  char *end_a = nullptr, *end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
  return end_a != a.c_str() && end_b != b.c_str() && !*end_a && !*end_b &&
         std::abs(x - y) <= 0.1 * std::max(std::abs(x), std::abs(y));
}

bool
linesAreAlike(const std::string& a, const std::string& b)
{
  const std::vector<std::string> one = partsOf(a), other = partsOf(b);
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), &areAlike);
}

} // namespace

std::string
missingLine(const std::string& text, const std::string& wanted)
{
  std::istringstream lines(text), wanted_lines(wanted);
  for (std::string wish; std::getline(wanted_lines, wish);) {
    std::string line;
    do
      if (!std::getline(lines, line))
        return wish;
    while (!linesAreAlike(line, wish));
  }
  return "";
}

void
followTutorial(const TutorialPage& page, const std::string& folder)
{
  std::string told;
  for (const TutorialStep& step : page.steps)
    switch (step.kind) {
    case TutorialStep::Kind::File:
      writeFile(step, folder);
      break;
    case TutorialStep::Kind::Script:
      told = runScript(step, folder);
      break;
    case TutorialStep::Kind::Output:
      if (const std::string missing = missingLine(told, step.text); !missing.empty())
        throw std::runtime_error("output of line " + std::to_string(step.line) +
                                 ": no \"" + missing + "\" in\n" + told);
    }
}

void
comparePictures(const TutorialPage& page,
                const std::string& folder,
                const std::string& committed)
{
  for (const std::string& name : page.pictures) {
    const double difference = pictureDifference(loadRgbImage(folder + "/" + name),
                                                loadRgbImage(committed + "/" + name));
    if (difference >= picture_tolerance)
      throw std::runtime_error(name + " is another picture: it differs by " +
                               std::to_string(difference) + " grey levels");
  }
}

double
pictureDifference(const RgbImage& a, const RgbImage& b)
{
  if (a.width != b.width || a.height != b.height)
    throw std::runtime_error("pictures of another size");
  const double sum =
      std::transform_reduce(a.values.begin(),
                            a.values.end(),
                            b.values.begin(),
                            0.0,
                            std::plus<>(),
                            [](int x, int y) { return std::abs(x - y); });
  return sum / static_cast<double>(a.values.size());
}

} // namespace pcl::acmap::test
