#include "disparity_back_projection_traits.h"
#include "disparity_fusion_traits.h"
#include "random_line_pattern_traits.h"
#include "rig_calibrator_traits.h"
#include "simulated_rig_grabber_traits.h"
#include "trinocular_matching_traits.h"
#include "trinocular_rectification_traits.h"

namespace pcl::acmap::test {

// only refusedCalls is used from that header
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClassContract);

/** Every public class with a main function for patterns, frames or rigs. Classes that
 * use a folder, a device or a signal (recorder, projectors, other grabbers) are not
 * included: their own tests check files, screens and threads. */
using ShotClasses = testing::Types<DisparityBackProjectionTraits,
                                   DisparityFusionTraits,
                                   RandomLinePatternTraits,
                                   RigCalibratorTraits,
                                   SimulatedRigGrabberTraits,
                                   TrinocularMatchingTraits,
                                   TrinocularRectificationTraits>;
using ReportingClasses = testing::Types<DisparityBackProjectionTraits,
                                        DisparityFusionTraits,
                                        RandomLinePatternTraits,
                                        RigCalibratorTraits,
                                        TrinocularMatchingTraits>;
using ThreadedClasses = testing::Types<DisparityBackProjectionTraits,
                                       DisparityFusionTraits,
                                       SimulatedRigGrabberTraits,
                                       TrinocularMatchingTraits,
                                       TrinocularRectificationTraits>;

INSTANTIATE_TYPED_TEST_SUITE_P(Public, ShotContract, ShotClasses);
INSTANTIATE_TYPED_TEST_SUITE_P(Public, ReportContract, ReportingClasses);
INSTANTIATE_TYPED_TEST_SUITE_P(Public, ThreadContract, ThreadedClasses);
INSTANTIATE_TYPED_TEST_SUITE_P(Public, HeaderContract, ShotClasses);

} // namespace pcl::acmap::test
