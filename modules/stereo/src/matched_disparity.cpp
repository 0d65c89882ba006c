#include <pcl/stereo/matched_disparity.h>

namespace pcl {

const char*
nameOf(DisparityOutcome outcome)
{
  constexpr std::array<const char*, disparity_outcomes> names = {"matched",
                                                                 "out of view",
                                                                 "untextured",
                                                                 "uncorrelated",
                                                                 "ambiguous",
                                                                 "one-sided",
                                                                 "pairs disagree",
                                                                 "too few shots",
                                                                 "inconsistent"};
  return names.at(static_cast<std::size_t>(outcome));
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
