#include <pcl/simulation/merged_rows.h>

#include <utility>

namespace pcl {

MergedRows::MergedRows(const Trajectory& trajectory)
{
  part_.trajectory = trajectory;
}

void
MergedRows::append(const SimulatedObservation& observation, std::size_t view)
{
  appendObservation(observation, view, part_);
  const PCLPointCloud2 cloud = cloudOf(part_);
  rows_.insert(rows_.end(), cloud.data.begin(), cloud.data.end());
  part_.points.clear();
  part_.rgb.clear();
  part_.view.clear();
  part_.label.clear();
}

CloudRows
MergedRows::finish()
{
  return CloudRows(cloudOf(part_), std::move(rows_));
}

} // namespace pcl
