#include "dewall_traits.h"
#include "voxel_consolidation_traits.h"

namespace pcl::acmap::test {

/** Every public class with a verb has its traits here. */
using PublicClasses = testing::Types<DeWallTraits, VoxelConsolidationTraits>;

INSTANTIATE_TYPED_TEST_SUITE_P(Public, ClassContract, PublicClasses);

} // namespace pcl::acmap::test
