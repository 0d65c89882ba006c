#pragma once

#include <pcl/core/point_cloud_file.h>

#include <functional>
#include <string>

namespace pcl::acmap::bench {

/** \brief A real cloud to test NoiseScale. */
struct NoiseCloud {
  std::string name;
  PointCloudFile file;
  bool is_view = false;  ///< observed from its viewpoint; otherwise the sensors are
                         ///< unknown
  bool is_exact = false; ///< a noise-free model
};

/** \brief Calls a function for one real cloud after another, so that only one is in
 * memory. Missing clouds, and packed ones if there is no xz, are reported on stderr
 * and skipped. */
void
forEachNoiseCloud(const std::function<void(const NoiseCloud&)>& use);

} // namespace pcl::acmap::bench
