#include <pcl/stereo/matched_disparity.h>

namespace pcl {

const char*
nameOf(DisparityOutcome outcome)
{
  return acmap::disparity_outcome_names.at(static_cast<std::size_t>(outcome));
}

std::array<std::size_t, disparity_outcomes>
countOutcomes(const MatchedDisparity& matched)
{
  std::array<std::size_t, disparity_outcomes> counts{};
  for (const DisparityOutcome outcome : matched.outcome)
    ++counts.at(static_cast<std::size_t>(outcome));
  return counts;
}

} // namespace pcl
