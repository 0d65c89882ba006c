#include "labeling/survey.h"

#include <pcl/core/parallel.h>

namespace pcl::acmap::labeling {

Survey::Survey(const PointView& points,
               const SensorView& sensors,
               const CandidateGrid& grid)
: points_(points)
, sensors_(sensors)
, entries_(points.size(), -1)
{
  parallelForChunks(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      VoxelHit hit;
      if (grid.lattice().locate(points[i], hit))
        entries_[i] = grid.find(voxelKey(hit.place));
    }
  });
}

} // namespace pcl::acmap::labeling
