#include "checks.h"
#include "rgbd/recorded_poses.h"

#include <cmath>
#include <sstream>

using namespace pcl::acmap;

/** Bytes are rejected, or give rows of words, and of finite numbers up to the first
 * word that is not one; as poses they are rigid motions, or lost. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream stream(test::textOfInput(data, size));
  const auto rows = test::acceptedBy([&] { return readTextRows(stream, "input"); });
  if (!rows)
    return 0;
  if (const auto recorded =
          test::acceptedBy([&] { return posesOfRows(*rows, "input"); })) {
    test::require(recorded->numbers.empty() ||
                  recorded->numbers.size() == recorded->poses.size());
    for (const auto& pose : recorded->poses)
      test::require(!pose || pose->matrix().allFinite());
  }
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
