#pragma once

#include "shot_contract.h"

#include <pcl/acquisition/random_line_pattern.h>

namespace pcl::acmap::test {

/** \brief The class has no input except its settings, and its setters reject invalid
 * values, so that no run can fail. */
struct RandomLinePatternTraits : CommonTraits<RandomLinePattern> {
  static constexpr const char* header =
      "acquisition/include/pcl/acquisition/random_line_pattern.h";
  using Output = std::vector<std::uint8_t>;

  static void
  run(Class& object, int which, Output& output)
  {
    output = object.generate(static_cast<std::uint32_t>(which)).values;
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.size() != 3u * 1024 * 768; // size of the paper's projector
  }

  static Output
  sentinel()
  {
    return {42};
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {
        {[](Class& o) { o.setSize(15, 768); }, {"width", "15", "[16, 8192] px"}},
        {[](Class& o) { o.setSize(1024, 8193); }, {"height", "8193", "[16, 8192] px"}},
        {[](Class& o) { o.setNumberOfLines(0); }, {"lines", "0", "[1, 10000] lines"}},
        {[](Class& o) { o.setLineWidths(7, 6); }, {"width", "7", "[1, 6] px"}},
        {[](Class& o) { o.setLineWidths(2, 65); }, {"width", "65", "[1, 64] px"}},
        {[=](Class& o) { o.setMinimumAngle(nan); }, {"angle", "nan", "[0, 1.5] rad"}},
        {[](Class& o) { o.setDisparityRange(3); }, {"range", "3", "[4, 1024] px"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << object.getWidth() << " x " << object.getHeight() << ", lines "
          << object.getNumberOfLines() << ", widths " << object.getLeastLineWidth()
          << ' ' << object.getMostLineWidth() << ", colour " << object.getColored()
          << ", angle " << object.getMinimumAngle() << ", range "
          << object.getDisparityRange() << ", seed " << object.getSeed();
    return words.str();
  }
};

} // namespace pcl::acmap::test
