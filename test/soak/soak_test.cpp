#include "soak.h"

#include "dewall_traits.h"
#include "entropy_rectification_traits.h"
#include "normal_vector_voting_traits.h"
#include "plane_hypothesis_clustering_traits.h"
#include "rectification_worlds.h"
#include "soak_cloud.h"
#include "voxel_consolidation_traits.h"

#include <pcl/PolygonMesh.h>
#include <pcl/core/impl/parallel.h>

namespace pcl::acmap::test {
namespace {

// their tests are instantiated elsewhere
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClassContract);

template <typename Traits>
struct OnClouds : Traits {
  static void
  setInput(typename Traits::Class& object, unsigned round)
  {
    Traits::setInput(object, makeSoakCloud(round));
  }
};

/** Also tests the output as a PCL mesh, and the memory limit. */
struct Meshes : OnClouds<DeWallTraits> {
  static void
  run(Class& object, Output& output)
  {
    DeWallTraits::run(object, output);
    PolygonMesh mesh;
    object.reconstruct(mesh);

    Class limited;
    limited.setInputCloud(object.getInputCloud());
    limited.setMemoryLimit(1);
    if (!isEmpty(output)) {
      EXPECT_THROW(limited.reconstruct(mesh), MemoryLimitException);
    }
  }
};

/** Rooms scanned by a robot with drift; every eighth one contains an invalid
 * observation. */
struct Rectifications : EntropyRectificationTraits {
  static void
  setInput(Class& object, unsigned round)
  {
    PosedClouds map =
        scanAlong(makeRoomPlan(), pathRound({4.5, 3.5}, {2.6, 2.2}, 8), {60}, round);
    map.poses = drifted(map.poses, drift, round);
    if (round % 8 == 7)
      (*map.clouds[3])[0].x = round % 16 == 7 ? 3e38F : std::nanf("");
    object.clear();
    for (std::size_t i = 0; i < map.clouds.size(); ++i)
      object.addPointCloud(map.clouds[i], isometryOf(map.poses[i]));
    object.setMode(round % 4 == 3 ? RectificationMode::Paper
                                  : RectificationMode::Guarded);
  }
};

/** Tests the task arenas in which all kernels run. */
TEST(Soak, arenas)
{
  const auto use_after = [](unsigned calls) {
    for (unsigned call = 0; call < calls; ++call)
      withThreads(1 + call % 3,
                  [] { parallelForChunks(5 * parallel_chunk, [](auto, auto) {}); });
    return currentUse();
  };
  const ProcessUse before = use_after(100);
  const ProcessUse growth = use_after(1000 * soakRounds()) - before;
  std::cout << "arenas, " << 1000 * soakRounds() << " rounds: " << growth << std::endl;
  EXPECT_LE(growth.allocated, 16 << 10);
  EXPECT_LE(growth.resident, 4 << 20);
}

TEST(Soak, meshes)
{
  Soak<Meshes>().check("meshes");
}

TEST(Soak, rectifications)
{
  Soak<Rectifications>().check("rectifications");
}

TEST(Soak, consolidations)
{
  Soak<OnClouds<VoxelConsolidationTraits>>().check("consolidations");
}

TEST(Soak, votings)
{
  Soak<OnClouds<NormalVectorVotingTraits>>().check("votings");
}

TEST(Soak, planes)
{
  Soak<OnClouds<PlaneHypothesisClusteringTraits>>().check("planes");
}

} // namespace
} // namespace pcl::acmap::test
