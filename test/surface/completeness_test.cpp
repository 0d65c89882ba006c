#include "dewall_runs.h"
#include "mesh_completeness.h"

namespace pcl::acmap::test {
namespace {

/** Small clouds of every kind, with several seeds each. */
std::vector<DeWallCase>
makeSmallCases()
{
  std::vector<DeWallCase> cases;
  const auto add = [&](const std::string& name, const Cloud& cloud, double length) {
    cases.push_back({name, cloud, length});
  };
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::string tail = "_" + std::to_string(seed);
    const auto sampling = [&](double noise) {
      return SheetSampling{15, 15, 1, 0.25, noise, seed};
    };
    add("plane" + tail, makeJitteredPlane(sampling(0)).cloud, 2.5);
    add("plane_noise_02" + tail, makeJitteredPlane(sampling(0.2)).cloud, 3);
    add("plane_noise_05" + tail, makeJitteredPlane(sampling(0.5)).cloud, 2);
    add("slab" + tail, makeJitteredPlane({12, 12, 1, 0.5, 2, seed}).cloud, 2.5);
    add("edge" + tail, makeFoldedPlane(sampling(0.1), M_PI / 2).cloud, 2.5);
    add("random_level" + tail, makeRandomPlane(200, ExactPlane::Level, seed), 0.2);
    add("random_box" + tail, makeRandomBox(120, seed), 0.35);
    add("sheets" + tail, makeParallelSheets({10, 10, 1, 0.25, 0.1, seed}, 1.2), 2.5);
    add("moebius" + tail, makeMoebiusBand(40, 5, 1, 0.5, seed), 0.3);
    add("corner" + tail, makeCorner({8, 8, 1, 0.25, 0.1, seed}), 2.5);
    add("sparse" + tail, makeRandomBox(40, seed), 0.3);
  }
  for (const std::uint64_t order : {131U, 185U})
    add("lattice_" + std::to_string(order), permuted(makeLattice(5), order), 1.5);
  add("grid", makeGrid(12, 12, 0.25, ExactPlane::Level), 0.5);
  add("grid_inclined", makeGrid(12, 12, 0.25, ExactPlane::Inclined), 0.6);
  add("hexagonal_grid", makeHexagonalGrid(12, 12, 1), 1.5);
  add("circle", makeExactCircle(5, false), 20);
  add("circle_with_center", makeExactCircle(5, true), 20);
  return cases;
}

const std::vector<DeWallCase>&
smallCases()
{
  static const std::vector<DeWallCase> cases = makeSmallCases();
  return cases;
}

class DeWallCompleteness : public testing::TestWithParam<std::size_t> {
protected:
  void
  expectComplete(DeWallRule rule, std::int32_t leaf_size) const
  {
    const DeWallCase& small = smallCases()[GetParam()];
    const DeWallRun run{rule, small.length};
    const DeWallResult result = triangulateInLeaves(small.cloud, run, leaf_size);
    ASSERT_TRUE(keepsGuarantees(result, run)) << "leaf size " << leaf_size;
    CompletenessRule demands;
    demands.edge_allowed = noLongerThan(result.points, small.length);
    demands.turn_limit = turn_limit;
    const auto missing =
        rule == DeWallRule::Guarded
            ? missingUnderPaperRule(result.points, result.mesh.triangles, demands)
            : missingUnderDenseRule(result.points, result.mesh.triangles, demands);
    EXPECT_TRUE(missing.empty())
        << "leaf size " << leaf_size << ", of " << result.mesh.triangles.size() << ": "
        << missing.size() << " missing, first "
        << describe(result.points, missing.front());
  }
};

TEST_P(DeWallCompleteness, paperMeshTakesNoFurtherTriangle)
{
  expectComplete(DeWallRule::Guarded, 100000);
  expectComplete(DeWallRule::Guarded, 16);
  expectComplete(DeWallRule::Guarded, 8);
}

TEST_P(DeWallCompleteness, denseMeshTakesNoFurtherTriangle)
{
  expectComplete(DeWallRule::Dense, 100000);
  expectComplete(DeWallRule::Dense, 16);
  expectComplete(DeWallRule::Dense, 8);
}

INSTANTIATE_TEST_SUITE_P(Small,
                         DeWallCompleteness,
                         testing::Range<std::size_t>(0, smallCases().size()),
                         [](const auto& info) {
                           return smallCases()[info.param].name;
                         });

} // namespace
} // namespace pcl::acmap::test
