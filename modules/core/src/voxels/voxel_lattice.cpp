#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/voxel_lattice.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::acmap {

namespace {

struct Box {
  Eigen::Array3f minimum = Eigen::Array3f::Constant(std::numeric_limits<float>::max());
  Eigen::Array3f maximum =
      Eigen::Array3f::Constant(std::numeric_limits<float>::lowest());
};

Box
boxOf(const PointView& points)
{
  return parallelReduceChunks(
      points.size(),
      Box{},
      [&](std::size_t begin, std::size_t end) {
        Box box;
        for (std::size_t i = begin; i < end; ++i) {
          const Eigen::Array3f p = points[i];
          if (!p.allFinite())
            continue;
          box.minimum = box.minimum.min(p);
          box.maximum = box.maximum.max(p);
        }
        return box;
      },
      [](Box& box, const Box& next) {
        box.minimum = box.minimum.min(next.minimum);
        box.maximum = box.maximum.max(next.maximum);
      });
}

/** A robust centre of the points that is not affected by a few outliers. */
Eigen::Vector3d
medianPoint(const PointView& points)
{
  constexpr std::size_t enough = 1024;
  const std::size_t step = points.size() / enough + 1;
  std::array<std::vector<float>, 3> values;
  for (std::size_t i = 0; i < points.size(); i += step) {
    pollRun();
    if (points[i].allFinite())
      for (int axis = 0; axis < 3; ++axis)
        values[axis].push_back(points[i][axis]);
  }
  Eigen::Vector3d median = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    auto& list = values[axis];
    if (list.empty())
      break;
    median[axis] = medianOf(list);
  }
  return median;
}

} // namespace

VoxelLattice::VoxelLattice(const PointView& points, double edge)
: edge_(edge)
{
  const Box box = boxOf(points);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  if ((box.minimum <= box.maximum).all())
    middle = (box.minimum.cast<double>() + box.maximum.cast<double>()) / 2;
  // A multiple of this stays even after several halvings, so that coarser lattices keep
  // the voxels together.
  constexpr std::int64_t even = 64;
  constexpr double half = (1 << (voxel_axis_bits - 1)) - 2 * margin - even;
  const double reach = (box.maximum.cast<double>() - middle.array()).maxCoeff() / edge;
  if (reach > half)
    middle = medianPoint(points);
  for (int axis = 0; axis < 3; ++axis) {
    const double place = std::floor(middle[axis] / edge / even);
    first_[axis] = static_cast<std::int64_t>(std::clamp(place, -1e15, 1e15)) * even -
                   (1 << (voxel_axis_bits - 1));
  }
  derive();
}

VoxelLattice
VoxelLattice::coarser() const
{
  VoxelLattice result;
  result.edge_ = 2 * edge_;
  for (int axis = 0; axis < 3; ++axis)
    result.first_[axis] = first_[axis] / 2;
  result.derive();
  return result;
}

void
VoxelLattice::derive()
{
  scale_ = (1 << offset_bits) / edge_;
  for (int axis = 0; axis < 3; ++axis)
    shift_[axis] = -static_cast<double>(first_[axis]) * (1 << offset_bits);
}

} // namespace pcl::acmap
