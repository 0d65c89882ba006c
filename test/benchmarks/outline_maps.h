#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief What is done besides printing tables; paths are empty if it is not wanted. */
struct OutlineOptions {
  std::string save;     ///< folder for the judged maps, NAME.json
  std::string from;     ///< folder of such files, which are judged instead
  std::string pictures; ///< folder for pictures of the outlines, NAME.png
};

/** \brief A map whose outlines are judged. */
struct JudgedMap {
  std::vector<PlanePatch> planes;
  double seconds = 0; ///< CPU time of the outlines; NaN for a map from a file
};

/** \brief A cloud with the sensor positions of its field `view`. */
struct JudgedCloud {
  std::shared_ptr<const PointCloudFile> cloud;
  std::vector<Eigen::Vector3f> viewpoints;
};

/** \brief All views of a scene, with their true poses. */
JudgedCloud
observeScene(const SimulatedScene& scene);

/** \brief Finds the planes of a cloud with the defaults of PlaneMapping, or reads them,
 * and saves and draws them, as the options say.
 * \param[in] makeCloud called unless the map is read */
template <typename MakeCloud>
JudgedMap
makeJudgedMap(const std::string& name,
              const OutlineOptions& options,
              const MakeCloud& makeCloud);

JudgedMap
readJudgedMap(const std::string& name, const OutlineOptions& options);

JudgedMap
findJudgedMap(const JudgedCloud& cloud);

/** \brief Saves and draws a map, as the options say. */
void
keepJudgedMap(const std::string& name,
              const OutlineOptions& options,
              const JudgedMap& map);

template <typename MakeCloud>
JudgedMap
makeJudgedMap(const std::string& name,
              const OutlineOptions& options,
              const MakeCloud& makeCloud)
{
  const JudgedMap map =
      options.from.empty() ? findJudgedMap(makeCloud()) : readJudgedMap(name, options);
  keepJudgedMap(name, options, map);
  return map;
}

} // namespace pcl::acmap::bench
