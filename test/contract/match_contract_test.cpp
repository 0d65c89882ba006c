#include "gradient_maximum_traits.h"
#include "log_polar_traits.h"
#include "planar_estimation_traits.h"
#include "revisit_detection_traits.h"
#include "visual_egomotion_traits.h"
#include "worst_out_traits.h"

namespace pcl::acmap::test {

// only refusedCalls is used from that header
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClassContract);

/** Every public class with a main function for matches, keypoints, or both. */
using MatchClasses = testing::Types<GradientMaximumTraits,
                                    LogPolarTraits,
                                    PlanarEstimationTraits,
                                    RevisitDetectionTraits,
                                    VisualEgomotionTraits,
                                    WorstOutTraits>;
using ReportingClasses = testing::Types<GradientMaximumTraits,
                                        LogPolarTraits,
                                        RevisitDetectionTraits,
                                        VisualEgomotionTraits,
                                        WorstOutTraits>;
using ThreadedClasses = testing::Types<GradientMaximumTraits,
                                       LogPolarTraits,
                                       RevisitDetectionTraits,
                                       VisualEgomotionTraits>;

INSTANTIATE_TYPED_TEST_SUITE_P(Public, ShotContract, MatchClasses);
INSTANTIATE_TYPED_TEST_SUITE_P(Public, ReportContract, ReportingClasses);
INSTANTIATE_TYPED_TEST_SUITE_P(Public, ThreadContract, ThreadedClasses);
INSTANTIATE_TYPED_TEST_SUITE_P(Public, HeaderContract, MatchClasses);

} // namespace pcl::acmap::test
