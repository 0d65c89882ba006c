#include "soak_cloud.h"

#include <pcl/core/random.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

Cloud
makeFairCloud(unsigned kind, std::uint64_t seed)
{
  Random random(seed);
  const SheetSampling sheet{static_cast<int>(random.uniform(20, 44)),
                            static_cast<int>(random.uniform(20, 44)),
                            random.uniform(0.01, 0.05),
                            0.25,
                            random.uniform(0, 0.5),
                            seed};
  switch (kind) {
  case 0:
    return makeJitteredPlane(sheet).cloud;
  case 1:
    return makeFoldedPlane(sheet, random.uniform(-1.5, 1.5)).cloud;
  case 2:
    return makeSphereCap(sheet, random.uniform(2, 4)).cloud;
  case 3: {
    const double noise = random.uniform(0, 0.02);
    return makeRoom(random.uniform(0.18, 0.25), noise, seed);
  }
  case 4:
    return makeCorridorView(2000, seed);
  default:
    return makeRandomBox(400, seed);
  }
}

Cloud
makeUglyCloud(unsigned kind, std::uint64_t seed)
{
  const Cloud some = makeRandomBox(300, seed);
  switch (kind) {
  case 0:
    return {};
  case 1:
    return makeRandomBox(1 + seed % 3, seed);
  case 2:
    return makeCollinear(40);
  case 3:
    return makeCoincident(1000);
  case 4:
    return lacedWithNan(some, 1 + seed % 5);
  case 5:
    return withOutlier(some, seed % 2 == 0 ? 1e9F : 3e38F);
  case 6:
    return doubled(makeLattice(5));
  default:
    Cloud invalid;
    invalid.resize(50, PointXYZ(0, 0, std::numeric_limits<float>::quiet_NaN()));
    invalid.is_dense = false;
    return invalid;
  }
}

} // namespace

Cloud
makeSoakCloud(unsigned round)
{
  constexpr unsigned fair = 6;
  constexpr unsigned ugly = 8;
  return round % 3 == 2 ? makeUglyCloud(round / 3 % ugly, round)
                        : makeFairCloud((round - round / 3) % fair, round);
}

} // namespace pcl::acmap::test
