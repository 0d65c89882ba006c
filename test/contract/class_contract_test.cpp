#include "box_fitting_traits.h"
#include "cylinder_hypothesis_clustering_traits.h"
#include "dewall_traits.h"
#include "entropy_rectification_traits.h"
#include "map_entropy_traits.h"
#include "map_levelling_traits.h"
#include "map_verdict_traits.h"
#include "normal_vector_voting_traits.h"
#include "plane_adjustment_traits.h"
#include "plane_hypothesis_clustering_traits.h"
#include "plane_texturing_traits.h"
#include "recess_fitting_traits.h"
#include "voxel_consolidation_traits.h"

namespace pcl::acmap::test {

/** The traits of every public class with a main function. */
using PublicClasses = testing::Types<BoxFittingTraits,
                                     CylinderHypothesisClusteringTraits,
                                     DeWallTraits,
                                     EntropyRectificationTraits,
                                     MapEntropyTraits,
                                     MapLevellingTraits,
                                     MapVerdictTraits,
                                     NormalVectorVotingTraits,
                                     PlaneAdjustmentTraits,
                                     PlaneHypothesisClusteringTraits,
                                     PlaneTexturingTraits,
                                     RecessFittingTraits,
                                     RectifyingFilterTraits,
                                     VoxelConsolidationTraits>;

INSTANTIATE_TYPED_TEST_SUITE_P(Public, ClassContract, PublicClasses);

} // namespace pcl::acmap::test
