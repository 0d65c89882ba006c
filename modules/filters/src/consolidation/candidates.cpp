#include "consolidation/candidates.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

/** Sum of the cells of a voxel that are on one surface. */
struct OwnPoints {
  Moments moments;
  std::int32_t witness = 0;
  float range = std::numeric_limits<float>::infinity();
};

OwnPoints
ownPoints(const VoxelWindows& windows, std::size_t voxel, unsigned octants)
{
  OwnPoints own;
  const VoxelMoments& voxels = windows.voxels();
  for (std::size_t c = windows.firstCell(voxel); c < windows.firstCell(voxel + 1);
       ++c) {
    const VoxelCell& cell = voxels.cells[c];
    if (!(octants >> octantOf(cell.key) & 1))
      continue;
    own.moments += cell.moments;
    if (cell.range < own.range ||
        (cell.range == own.range && cell.witness < own.witness)) {
      own.range = cell.range;
      own.witness = cell.witness;
    }
  }
  return own;
}

/** If the points of the window are on one side of the voxel, it is at the border of the
 * surface. Its point is then moved outwards to the end of the points of the voxel,
 * because otherwise every border would recede by half a voxel. */
Eigen::Vector3d
reachRim(const Moments& own, const SurfaceFit& fit, const Eigen::Vector3d& place)
{
  constexpr double min_shift = 0.75; // of the mean of the window, in edges
  const Eigen::Vector3d normal = fit.normal.cast<double>();
  Eigen::Vector3d outwards = place - fit.mean.cast<double>();
  outwards -= outwards.dot(normal) * normal;
  if (outwards.norm() < min_shift)
    return place;
  outwards.normalize();
  const Eigen::Vector3d mean = own.mean();
  const Eigen::Vector3d second(
      own.xx * outwards.x() + own.xy * outwards.y() + own.xz * outwards.z(),
      own.xy * outwards.x() + own.yy * outwards.y() + own.yz * outwards.z(),
      own.xz * outwards.x() + own.yz * outwards.y() + own.zz * outwards.z());
  const double along = mean.dot(outwards);
  const double variance = second.dot(outwards) / own.count - along * along;
  // uniformly distributed points end at sqrt (3) standard deviations
  double reach = std::min(0.5, std::sqrt(3 * std::max(variance, 0.0)));
  for (int axis = 0; axis < 3; ++axis)
    if (outwards[axis] != 0) // not beyond the face of the voxel
      reach = std::min(
          reach, (std::copysign(0.5, outwards[axis]) - place[axis]) / outwards[axis]);
  return place + std::max(reach, 0.0) * outwards;
}

class CandidateMaker {
public:
  CandidateMaker(const VoxelWindows& windows, const SensorView& sensors)
  : windows_(windows)
  , sensors_(sensors)
  {}

  Candidate
  make(std::size_t voxel, const SurfaceFit& fit) const
  {
    const OwnPoints own = ownPoints(windows_, voxel, fit.octants);
    const VoxelLattice& lattice = windows_.voxels().lattice;
    const Eigen::Vector3d mean = own.moments.mean();
    const Eigen::Vector3d normal = fit.normal.cast<double>();
    const double move = (fit.mean.cast<double>() - mean).dot(normal);
    Eigen::Vector3d place = mean + move * normal;
    if (fit.is_whole)
      place = reachRim(own.moments, fit, place);

    Candidate candidate;
    candidate.voxel = static_cast<std::uint32_t>(voxel);
    candidate.octants = fit.octants;
    candidate.strayed =
        place.cwiseAbs().maxCoeff() <= 0.5 ? 0.0f : static_cast<float>(std::abs(move));
    Representative& representative = candidate.representative;
    const VoxelKey key = windows_.voxels().cells[windows_.firstCell(voxel)].key;
    representative.point =
        (lattice.center(placeOf(key)) + place * lattice.edge()).cast<float>();
    representative.witness = own.witness;
    representative.curvature = fit.curvature;
    representative.normal = orient(fit.normal, representative);
    return candidate;
  }

private:
  Eigen::Vector3f
  orient(const Eigen::Vector3f& normal, const Representative& representative) const
  {
    if (normal.isZero())
      return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    const Eigen::Vector3f* sensor =
        sensors_[static_cast<std::size_t>(representative.witness)];
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const float side =
        sensor ? normal.dot(*sensor - representative.point) : normal[axis];
    return side < 0 ? Eigen::Vector3f(-normal) : normal;
  }

  const VoxelWindows& windows_;
  const SensorView& sensors_;
};

} // namespace

LargeVector<Candidate>
makeCandidates(const VoxelWindows& windows,
               const SurfaceFits& fits,
               const SensorView& sensors)
{
  const CandidateMaker maker(windows, sensors);
  LargeVector<Candidate> candidates(windows.size() + fits.second.size());
  parallelForChunks(windows.size(), [&](std::size_t begin, std::size_t end) {
    auto second = std::lower_bound(
        fits.second.begin(), fits.second.end(), begin, [](const auto& fit, auto voxel) {
          return fit.first < voxel;
        });
    // each second side before this chunk is one more candidate
    auto next = candidates.begin() + static_cast<std::ptrdiff_t>(begin) +
                (second - fits.second.begin());
    for (std::size_t v = begin; v < end; ++v) {
      *next++ = maker.make(v, fits.first[v]);
      if (second != fits.second.end() && second->first == v)
        *next++ = maker.make(v, (second++)->second);
    }
  });
  return candidates;
}

} // namespace pcl::acmap
