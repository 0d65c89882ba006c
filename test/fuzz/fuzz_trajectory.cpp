#include "files/trajectory_text.h"
#include "source_checks.h"

using namespace pcl::acmap;

/** Bytes are rejected, or give a trajectory that is unchanged by writing and
 * reading. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto read = test::acceptedBy(readTrajectory, data, size);
  if (!read)
    return 0;
  const std::string text = trajectoryText(*read);
  ByteSource source("again", text.data(), text.size());
  const pcl::Trajectory again = readTrajectory(source);
  test::require(again.stamps == read->stamps);
  test::require(again.poses.size() == read->poses.size());
  for (std::size_t i = 0; i < again.poses.size(); ++i) {
    test::require(again.poses[i].translation() == read->poses[i].translation());
    const Eigen::Matrix3d turn = again.poses[i].linear() - read->poses[i].linear();
    test::require(turn.cwiseAbs().maxCoeff() < 1e-12);
  }
  return 0;
}
