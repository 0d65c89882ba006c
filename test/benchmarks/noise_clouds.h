#pragma once

#include <pcl/core/point_cloud_file.h>

#include <functional>
#include <string>

namespace pcl::acmap::bench {

/** \brief A real cloud that NoiseScale is tried on. */
struct NoiseCloud {
  std::string name;
  PointCloudFile file;
  bool is_view = false;  ///< seen from its viewpoint; elsewhere the sensors are unknown
  bool is_exact = false; ///< a model: has no noise
};

/** \brief Calls a function for one real cloud after the other, so that one at a time is in
 * memory. Those that are not there, or packed where there is no xz, are named on stderr
 * and left out. */
void
forEachNoiseCloud(const std::function<void(const NoiseCloud&)>& use);

} // namespace pcl::acmap::bench
