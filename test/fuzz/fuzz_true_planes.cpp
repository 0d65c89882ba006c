#include "checks.h"

#include <pcl/pipeline/session_truth.h>

#include <cmath>

using namespace pcl;
using namespace pcl::acmap;

/** Bytes are rejected, or give planes with unit normals and an extent. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  const auto planes =
      test::acceptedBy([&] { return readTruePlanes(parseYaml("input", text)); });
  if (!planes)
    return 0;
  test::require(!planes->empty());
  for (const TruePlane& plane : *planes)
    test::require(std::abs(plane.coefficients.head<3>().norm() - 1) < 1e-5 &&
                  !plane.rectangles.empty() && !plane.name.empty());
  SessionTruth truth;
  truth.planes = *planes;
  test::require(truth.mainPlanes().size() <= planes->size());
  return 0;
}
