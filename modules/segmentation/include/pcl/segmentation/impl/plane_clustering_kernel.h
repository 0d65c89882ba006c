#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/progress.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/segmentation/plane_clustering_types.h>
#include <pcl/types.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref clusterPlanes; see PlaneHypothesisClustering. */
struct PlaneClusteringSettings {
  bool noise_driven = true;                       ///< else the paper to the letter
  double member_distance = 0.8;                   ///< W_d, metres; unless noise-driven
  SupporterReach reach = SupporterReach::Members; ///< of W_d; unless noise-driven
  double normal_angle = 0.39269908169872414;      ///< W_n, radians
  /** \brief W_t, metres; none: computed from the noise, or the paper's. */
  std::optional<double> plane_distance;
  std::size_t min_support = 50; ///< W_h; unless noise-driven
  double min_area = 0;          ///< square metres; noise-driven; 0 is automatic
  bool regular = false;         ///< rotate planes to be parallel or perpendicular
  unsigned threads = 0;         ///< 0: all
};

/** \brief The paper's W_t, metres. */
inline constexpr double paper_plane_distance = 0.25;

/** \brief The hypotheses (p_i, n_i), and the mesh between them. */
struct PlaneHypotheses {
  PointView points;
  LargeVector<Eigen::Vector3f> normals; ///< unit; NaN where there is none
  LargeVector<std::uint8_t> is_crease;  ///< no seed if noise-driven; may be empty
  LargeVector<float> curvatures;     ///< seed order: ascending, NaN last; may be empty
  TriangleMesh::Triangles triangles; ///< may be empty
  SensorView sensors; ///< of the points; unknown: nothing was looked through
};

/** \brief The indices in ascending order, without duplicates. \ingroup segmentation */
ACMAP_EXPORT std::vector<std::int32_t>
chosenOf(const Indices& indices);

/** \brief Keeps only the chosen hypotheses and the triangles between them.
 * \param[in] chosen ascending, without duplicates
 * \param[in] points number of points of the whole array
 * \param[in,out] hypotheses in: for a whole array of points, except for \c points and
 * \c sensors, which are those of the view through \a chosen; out: for this view
 * \ingroup segmentation */
ACMAP_EXPORT void
keepChosen(const std::vector<std::int32_t>& chosen,
           std::size_t points,
           PlaneHypotheses& hypotheses);

/** \brief Is a \ref VertexClass, as a number, a crease or a corner? */
constexpr bool
isCrease(std::uint32_t vertex_class)
{
  return vertex_class >= 2;
}

/** \brief Normals of unit length; NaN where they have no direction.
 * \ingroup segmentation */
ACMAP_EXPORT LargeVector<Eigen::Vector3f>
unitNormals(const PointView& normals);

/** \brief The cloud from which the hypotheses were consolidated; may be empty. */
struct PlaneSource {
  PointView points;
  SensorView sensors;
  /** \brief Are the sensors known, so that planes are turned to them? The default origin of a
   * point cloud is only a hypothesis. */
  bool has_known_sensors = false;
};

struct PlaneClusters {
  std::vector<PlanePatch> patches; ///< by decreasing area; 0 without a mesh
  PointLabels labels;              ///< for each hypothesis its patch, -1 for none
  PointLabels source_labels;       ///< the same for each point of the source
};

/** \brief Estimates how long the paper's growth of planes takes: each hypothesis that is
 * on no plane is compared with all others within W_d.
 * \param[in] member_distance W_d, metres
 * \return seconds on a processor of 2020, if every twentieth point is on no plane
 * \ingroup segmentation */
ACMAP_EXPORT double
secondsOfPaperGrowth(const PointView& points, double member_distance);

/** \brief The kernel of PlaneHypothesisClustering, independent of PCL's point types.
 * \param[out] report counts, seconds, remarks; it is reset first
 * \throws CancelledException when the progress callback requested to stop
 * \ingroup segmentation */
ACMAP_EXPORT PlaneClusters
clusterPlanes(const PlaneHypotheses& hypotheses,
              const PlaneSource& source,
              const PlaneClusteringSettings& settings,
              const Progress& progress,
              PlaneClusteringReport& report);

} // namespace pcl::acmap
