#include "checks.h"
#include "rgbd/recorded_poses.h"

#include <cmath>
#include <sstream>

using namespace pcl::acmap;

namespace {

void
checkPoses(const std::optional<RecordedPoses>& recorded)
{
  if (!recorded)
    return;
  test::require(recorded->numbers.empty() ||
                recorded->numbers.size() == recorded->poses.size());
  for (const auto& pose : recorded->poses)
    test::require(!pose || pose->matrix().allFinite());
}

} // namespace

/** Bytes are rejected, or give rows of words, and of finite numbers up to the first
 * word that is not one; as poses they are rigid motions, or lost. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  if (text.substr(0, 1) == "{")
    checkPoses(
        test::acceptedBy([&] { return posesOfFrames(parseYaml("input", text)); }));
  std::istringstream stream(text);
  const auto rows = test::acceptedBy([&] { return readTextRows(stream, "input"); });
  if (!rows)
    return 0;
  checkPoses(test::acceptedBy([&] { return posesOfRows(*rows, "input"); }));
  std::size_t line = 0;
  for (const TextRow& row : *rows) {
    test::require(row.line > line && !row.words.empty());
    line = row.line;
    for (std::size_t word = 0; word < row.words.size(); ++word) {
      test::require(!row.words[word].empty());
      const auto number =
          test::acceptedBy([&] { return numberOf("input", row, word); });
      if (!number)
        return 0; // as its reader does
      test::require(std::isfinite(*number));
    }
  }
  return 0;
}
