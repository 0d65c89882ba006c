#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/point_cloud_file.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Settings for turning a recording into a map. */
struct ChainWay {
  std::string name;
  std::size_t every = 1;            ///< one of this number of frames is used
  bool is_given = true;             ///< use the given poses, or else estimate them
  std::vector<std::string> mapping; ///< further options of pcl_compact_mapping
};

/** \brief An observation that has a pose. */
struct ChainView {
  std::vector<Eigen::Vector3d> points; ///< \ref thinnedPoints, camera frame, metres
  Eigen::Isometry3d given;             ///< T_map_camera given with the recording
  Eigen::Isometry3d found;             ///< T_map_camera of the map
};

/** \brief One of 4 x 4 pixels of an organized cloud, if it is finite. */
std::vector<Eigen::Vector3d>
thinnedPoints(const PointCloudFile& file);

/** \brief Result of a run. */
struct ChainRun {
  std::size_t observations = 0;
  std::vector<ChainView> views; ///< all views with a pose
  CompactMap map;
  double compactness = 0;      ///< 16 bytes per point divided by the size of map.glb
  double seconds = 0;          ///< CPU time of pcl_compact_mapping
  std::size_t peak_memory = 0; ///< bytes, of pcl_compact_mapping
};

/** \brief Imports frames of a recording in the layout of 7-Scenes and maps them.
 * \param[in] folder for the outputs, which take 10 MB per frame
 * \throws std::runtime_error when a tool fails, with its messages */
ChainRun
runChainOfTools(const ChainWay& way,
                const std::string& recording,
                const std::string& folder);

/** \brief Distances between the same points under different poses, after the rigid
 * motion that aligns them best. */
struct PointAgreement {
  Eigen::Isometry3d T_given_found = Eigen::Isometry3d::Identity();
  double median = 0, maximum = 0; ///< metres; \a maximum is the 95 % quantile
};

PointAgreement
comparePoints(const std::vector<ChainView>& views);

/** \brief Comparison of the planes of a map with those of a reference. */
struct PlaneAgreement {
  std::size_t planes = 0; ///< planes of the reference that have a partner
  double area = 0;        ///< fraction of the reference's area that is near a
                          ///< partner
  double angle = 0,
         angle_maximum = 0; ///< degrees, median and maximum over all partners

  /** Metres, as above, at the centre of the common area. */
  double offset = 0, offset_maximum = 0;
};

/** \brief A sample of the reference is near a plane of the map if the distance to its
 * polygons is at most 5 cm and the angle between the normals at most 5 degrees.
 * Partners are the pairs with most of such samples. Angles and offsets are evaluated
 * for planes of at least a quarter of a square metre. */
PlaneAgreement
comparePlanes(const std::vector<PlanePatch>& reference,
              const std::vector<PlanePatch>& planes,
              const Eigen::Isometry3d& T_reference_map);

/** \brief Distance between the same surface in two views. */
struct SurfaceAgreement {
  std::size_t pieces = 0;         ///< found in both views
  double median = 0, maximum = 0; ///< metres; \a maximum is the 90 % quantile
};

/** \brief Registers views with each other and measures distances across the surfaces
 * that both see: planar pieces in cubes of 10 cm, with partners within 5 cm along the
 * surface, 10 cm across and 15 degrees. No ground truth is needed: better poses bring
 * surfaces closer together.
 * \param[in] step from a view to its partner
 * \param[in] pose selects one of the poses of a view */
SurfaceAgreement
compareSurfaces(const std::vector<ChainView>& views,
                std::size_t step,
                Eigen::Isometry3d ChainView::*pose);

} // namespace pcl::acmap::bench
