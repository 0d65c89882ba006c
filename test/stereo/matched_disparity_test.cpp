#include <pcl/stereo/matched_disparity.h>

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

namespace pcl::acmap::test {
namespace {

TEST(MatchedDisparity, EveryOutcomeHasANameOfItsOwn)
{
  std::set<std::string> names;
  for (std::size_t i = 0; i < disparity_outcomes; ++i)
    names.insert(nameOf(static_cast<DisparityOutcome>(i)));
  EXPECT_EQ(names.size(), disparity_outcomes);
  EXPECT_EQ(names.count(""), 0u);
  EXPECT_EQ(nameOf(DisparityOutcome::OneSided), std::string("one-sided"));
  EXPECT_THROW(nameOf(static_cast<DisparityOutcome>(disparity_outcomes)),
               std::out_of_range);
}

TEST(MatchedDisparity, OutcomesAreCounted)
{
  MatchedDisparity matched;
  EXPECT_EQ(countOutcomes(matched), (std::array<std::size_t, disparity_outcomes>{}));
  matched.outcome = {DisparityOutcome::Inconsistent,
                     DisparityOutcome::Matched,
                     DisparityOutcome::Untextured,
                     DisparityOutcome::Matched,
                     DisparityOutcome::Matched};
  EXPECT_EQ(countOutcomes(matched),
            (std::array<std::size_t, disparity_outcomes>{3, 0, 1, 0, 0, 0, 0, 0, 1}));
}

TEST(MatchedDisparity, DisparitiesAreOfTheHorizontalPairIfThereIsOne)
{
  TrinocularRig rig;
  rig.baseline_horizontal = -0.12;
  rig.baseline_vertical = 0.08;
  EXPECT_EQ(disparityBaseline(rig), 0.12);
  rig.baseline_horizontal = 0;
  EXPECT_EQ(disparityBaseline(rig), 0.08);
  rig.baseline_vertical = 0;
  EXPECT_EQ(disparityBaseline(rig), 0.0);
}

} // namespace
} // namespace pcl::acmap::test
