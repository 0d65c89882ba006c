#pragma once

#include <pcl/core/cylinder_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/noise_scale.h>
#include <pcl/segmentation/cylinder_clustering_types.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref clusterCylinders; see CylinderHypothesisClustering. */
struct CylinderClusteringSettings {
  double min_radius = 0;                  ///< metres
  double max_radius = 1e9;                ///< metres
  double sigma = 0;                       ///< metres; 0: measured
  std::optional<NoiseScale> source_scale; ///< of the source; none: measured
  unsigned threads = 0;                   ///< 0: all
};

/** \brief Planes that cylinders may replace. */
struct GivenPlanes {
  const std::vector<PlanePatch>& patches;
  const PointLabels& labels;        ///< for each hypothesis; may be empty
  const PointLabels& source_labels; ///< for each point of the source, or empty
};

struct CylinderClusters {
  std::vector<CylinderPatch> patches; ///< by decreasing area
  PointLabels labels;                 ///< for each hypothesis its patch, -1 for none
  PointLabels source_labels;          ///< the same for each point of the source
};

/** \brief The kernel of CylinderHypothesisClustering, independent of PCL's point types.
 * \param[in] hypotheses normals may be empty: then they are computed
 * \param[out] report counts, seconds, remarks; it is reset first
 * \throws CancelledException when the progress callback requested to stop
 * \ingroup segmentation */
ACMAP_EXPORT CylinderClusters
clusterCylinders(const PlaneHypotheses& hypotheses,
                 const PlaneSource& source,
                 const GivenPlanes& planes,
                 const CylinderClusteringSettings& settings,
                 const Progress& progress,
                 CylinderClusteringReport& report);

} // namespace pcl::acmap
