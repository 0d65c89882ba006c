#include "map/map_format.h"
#include "source_checks.h"

using namespace pcl::acmap;

namespace {

std::string
textOf(const pcl::CompactMap& map)
{
  std::string text;
  writeMap(map, [&](const std::string& piece) { text += piece; });
  return text;
}

void
requireSame(pcl::CompactMap& a, pcl::CompactMap& b)
{
  test::require(a.trajectory.stamps == b.trajectory.stamps);
  test::require(a.trajectory.poses.size() == b.trajectory.poses.size());
  for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i) {
    const Eigen::Matrix4d change =
        a.trajectory.poses[i].matrix() - b.trajectory.poses[i].matrix();
    test::require(change.topLeftCorner<3, 3>().cwiseAbs().maxCoeff() < 1e-12 &&
                  (change.col(3).array() == 0).all());
  }
  // The last digit of a quaternion may change; everything else is equal.
  a.trajectory = b.trajectory = {};
  test::require(textOf(a) == textOf(b));
}

} // namespace

/** Bytes are rejected, or give a map that is unchanged by writing and reading. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  auto map = test::acceptedBy(
      [](ByteSource& source) { return readMap("input", source); }, data, size);
  if (!map)
    return 0;
  const std::string text = textOf(*map);
  ByteSource source("again", text.data(), text.size());
  pcl::CompactMap again = readMap("again", source);
  requireSame(*map, again);
  return 0;
}
