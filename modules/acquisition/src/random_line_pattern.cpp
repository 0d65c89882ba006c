#include "pattern/pattern_lines.h"
#include "pattern/side_lobes.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/random.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl {
namespace {

constexpr int max_redraws = 16;

/** \brief A generated pattern and its rating. */
struct LineCandidate {
  RgbImage image;
  acmap::SideLobes rows;
  acmap::SideLobes columns;
  double judged = std::numeric_limits<double>::infinity(); ///< lower is better
};

/** \brief A different seed for each attempt at each pattern. */
std::uint64_t
seedOf(std::uint64_t seed, std::uint32_t index, int attempt)
{
  const std::uint64_t of_pattern = acmap::Random(seed).bits() + index;
  const std::uint64_t of_attempt =
      acmap::Random(of_pattern).bits() + static_cast<std::uint64_t>(attempt);
  return acmap::Random(of_attempt).bits();
}

LineCandidate
drawCandidate(const acmap::PatternLaw& law, int range, std::uint64_t seed)
{
  LineCandidate candidate;
  candidate.image = acmap::paintLines(law, acmap::sampleLines(law, seed));
  candidate.rows = acmap::rowSideLobes(candidate.image, range);
  candidate.columns = acmap::columnSideLobes(candidate.image, range);
  // a minimum angle is set for rigs that compare only rows
  candidate.judged = law.minimum_angle > 0
                         ? candidate.rows.gated
                         : std::max(candidate.rows.gated, candidate.columns.gated);
  return candidate;
}

} // namespace

void
RandomLinePattern::setSize(int width, int height)
{
  acmap::requireInRange("pattern width", width, 16, 8192, "px");
  acmap::requireInRange("pattern height", height, 16, 8192, "px");
  width_ = width;
  height_ = height;
}

void
RandomLinePattern::setNumberOfLines(int lines)
{
  acmap::requireInRange("number of lines", lines, 1, 10000, "lines");
  lines_ = lines;
}

void
RandomLinePattern::setLineWidths(int minimum, int maximum)
{
  acmap::requireInRange("maximum line width", maximum, 1, 64, "px");
  acmap::requireInRange("minimum line width", minimum, 1, maximum, "px");
  min_line_width_ = minimum;
  max_line_width_ = maximum;
}

void
RandomLinePattern::setMinimumAngle(double radians)
{
  acmap::requireInRange("minimum angle", radians, 0, 1.5, "rad");
  minimum_angle_ = radians;
}

void
RandomLinePattern::setDisparityRange(int pixels)
{
  acmap::requireInRange("disparity range", pixels, 4, 1024, "px");
  disparity_range_ = pixels;
}

RgbImage
RandomLinePattern::generate(std::uint32_t index)
{
  report_ = {};
  acmap::StepTimer timer(report_);
  const acmap::PatternLaw law{width_,
                              height_,
                              lines_,
                              min_line_width_,
                              max_line_width_,
                              colored_,
                              minimum_angle_};
  LineCandidate best;
  int attempt = 0;
  do {
    LineCandidate next =
        drawCandidate(law, disparity_range_, seedOf(seed_, index, attempt));
    if (next.judged < best.judged)
      best = std::move(next);
  } while (best.judged >= acmap::highest_side_lobe && attempt++ < max_redraws);
  report_.lines = lines_;
  report_.redraws = std::min(attempt, max_redraws);
  report_.coverage = acmap::coverageOf(best.image);
  report_.row_side_lobe = best.rows.gated;
  report_.column_side_lobe = best.columns.gated;
  report_.worst_row_side_lobe = best.rows.worst;
  report_.worst_column_side_lobe = best.columns.worst;
  if (best.judged >= acmap::highest_side_lobe)
    report_.remarks.push_back(
        "pattern " + std::to_string(index) + " repeats itself (side lobe " +
        std::to_string(best.judged) + "): the best of " +
        std::to_string(max_redraws + 1) + "; more lines would help");
  timer.finish("generate");
  return std::move(best.image);
}

} // namespace pcl
