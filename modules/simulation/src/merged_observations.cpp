#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_observation.h>

#include <cmath>

namespace pcl {

void
appendObservation(const SimulatedObservation& observation,
                  std::size_t view,
                  MergedObservations& merged)
{
  if (view >= merged.trajectory.poses.size())
    throw acmap::BadArgument("the merged trajectory has no pose " +
                             std::to_string(view));
  const Eigen::Isometry3d& T_map_camera = merged.trajectory.poses[view];
  for (const ObservationPixel& pixel : observation.pixels) {
    if (!std::isfinite(pixel.x))
      continue;
    const Eigen::Vector3d point(pixel.x, pixel.y, pixel.z);
    merged.points.emplace_back((T_map_camera * point).cast<float>());
    merged.rgb.push_back(pixel.rgb);
    merged.view.push_back(static_cast<std::int32_t>(view));
    merged.label.push_back(pixel.label);
  }
}

MergedObservations
mergeObservations(const SimulatedScene& scene,
                  std::size_t views,
                  std::uint64_t seed,
                  const ProgressCallback& progress)
{
  const acmap::Progress told(progress);
  MergedObservations merged;
  merged.trajectory = trajectoryOf(scene, views == 0 ? scene.views.size() : views);
  merged.planes = planesInMap(scene);
  const std::size_t count = merged.trajectory.poses.size();
  const std::size_t expected = count * scene.mostPointsOfView();
  merged.points.reserve(expected);
  merged.rgb.reserve(expected);
  merged.view.reserve(expected);
  merged.label.reserve(expected);
  for (std::size_t view = 0; view < count; ++view) {
    appendObservation(observe(scene, view, seed), view, merged);
    told.tell(static_cast<double>(view + 1) / static_cast<double>(count), "observing");
  }
  return merged;
}

} // namespace pcl
