#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/rigid_motion.h>
#include <pcl/core/stage_controls.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/texture/impl/texturing_kernel.h>
#include <pcl/texture/texturing_types.h>

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace pcl {

/** \brief Textures planes and cylinders with the colours of the observations: the last step of
 * "Active Stereo Based Compact Mapping" (II-C), which turns planes into a compact map.
 *
 * Each polygon of a plane gets a rectangular chart of texels. As in the paper, a point
 * colours the closest plane within 0.3 m whose polygon contains the projection of the
 * point. If the cloud is organized like the image of a pinhole camera, the texels are
 * projected into this image instead: a texel is visible where the depth measured
 * around its pixel belongs to its plane, and colours next to depth edges get little
 * weight. For each texel the four best samples are kept (near, frontal, far from the
 * image border). The samples are brought to a common exposure with one gain per view. Where
 * images show the same places differently, because their poses are not exact, their samples
 * are moved onto each other. Each region shows one image, chosen by minimum cuts, whose mean
 * over some decimetres is that of all. Of other clouds, a texel has the robust middle of the
 * points that are nearest to it. Holes are filled from their borders over 10 cm; the remaining
 * texels stay unknown (\ref TexelKind). \ref setPaperMode leaves only the points.
 *
 * Clouds without colour are painted with their field `intensity` as grey, if they have
 * one; the first of them decides the scale.
 *
 * Lengths are in metres, in the frame of the planes; colours are as in the clouds. The
 * time is O(n p + t v) for n points, p planes near a view, t texels and v views that
 * see them. The output is byte-identical for every number of threads.
 * \code
 * pcl::PlaneTexturing<pcl::PointXYZRGB> texturing;
 * texturing.setPlanes (planes);                        // of PlaneHypothesisClustering
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   texturing.addObservation (clouds[i], poses[i]);    // organized, camera frame
 * pcl::CompactMap map;
 * texturing.texture (map);
 * pcl::saveCompactMap ("map", map);
 * \endcode
 * \ingroup texture */
template <typename PointT>
class PlaneTexturing : public StageControls<TexturingReport> {
public:
  using Ptr = shared_ptr<PlaneTexturing<PointT>>;
  using ConstPtr = shared_ptr<const PlaneTexturing<PointT>>;
  using PointCloudConstPtr = typename PointCloud<PointT>::ConstPtr;

  /** \brief Sets the planes. Planes without polygons get no chart. Polygons that have
   * no area or are not finite get none either, and the report mentions them. */
  void
  setPlanes(std::vector<PlanePatch> planes)
  {
    planes_ = std::move(planes);
    has_planes_ = true;
  }

  const std::vector<PlanePatch>&
  getPlanes() const
  {
    return planes_;
  }

  /** \brief Sets the cylinders (default none). Each gets one picture, unrolled
   * (CompactMap::cylinder_pictures), whose texels are enlarged where it would have
   * more than \ref setMaximumTextureSize permits. They are coloured as planes are; cylinders
   * without an area, or that are not finite, get no picture, and the report mentions
   * them. */
  void
  setCylinders(std::vector<CylinderPatch> cylinders)
  {
    cylinders_ = std::move(cylinders);
  }

  const std::vector<CylinderPatch>&
  getCylinders() const
  {
    return cylinders_;
  }

  /** \brief Adds the cloud that was observed from one pose. An organized cloud is
   * assumed to be observed from the origin of its frame: it does not colour planes
   * that face away from there.
   * \param[in] cloud organized or not; its points may be NaN, its colours are valid at
   * every point
   * \param[in] T_map_camera transform from the frame of the cloud to that of the
   * planes
   * \throws BadArgumentException when the cloud is missing or the pose is not a rigid
   * motion */
  void
  addObservation(
      const PointCloudConstPtr& cloud,
      const acmap::RigidMotion& T_map_camera = Eigen::Isometry3d::Identity());

  /** \brief Adds an observation that is loaded when it is painted, and not kept: so memory
   * holds one of a long sequence at a time.
   * \param[in] load called once by each \ref texture, which passes on what it throws
   * \throws BadArgumentException without a loader */
  void
  addObservationLoader(TexturedObservationLoader load);

  /** \brief Adds observations with which another process paints the same surfaces with the same
   * settings (acmap::sendPainted), as if they had been added here.
   * \param[in] next returns its next message, nothing after the last one; called by one
   * \ref texture only, which passes on what it throws
   * \throws BadArgumentException without it */
  void
  addPaintedObservations(acmap::PaintedObservations next);

  void
  clearObservations()
  {
    observations_.clear();
  }

  std::size_t
  getNumberOfObservations() const
  {
    return observations_.size();
  }

  /** \brief Colours the planes as the paper does (default false): the colour of each
   * point goes to its closest plane within the maximum distance, and a texel has the mean
   * colour of its points in all observations. Nothing is projected into images, exposures
   * stay as they are, points behind a plane count too, and no hole is filled. */
  void
  setPaperMode(bool paper_mode)
  {
    settings_.paper = paper_mode;
  }

  bool
  getPaperMode() const
  {
    return settings_.paper;
  }

  /** \brief Sets the edge length of a texel (default 0: automatic, a pixel of the first
   * observation on what is near, or half the spacing of points that are in no image, at least
   * 3 mm, acmap::automaticTexelSize; in paper mode 0.02 m). Up to sixteen times as large ones are
   * taken, with a remark, where the charts would have more than 50 million, which the pages of a
   * map hold; automatic ones are at most 8 million.
   * \throws BadArgumentException unless within [1e-4, 10] m, or 0 */
  void
  setTexelSize(double metres);

  double
  getTexelSize() const
  {
    return settings_.texel_size;
  }

  /** \brief Sets the maximum distance of a point from the plane it colours (default 0.3
   * m, as in the paper). \throws BadArgumentException unless within [1e-6, 1e3] m */
  void
  setMaximumDistance(double metres);

  double
  getMaximumDistance() const
  {
    return settings_.maximum_distance;
  }

  /** \brief Sets the maximum width and height of a chart in texels (default 4088, which
   * fits into a page of a saved map); larger polygons get several charts.
   * \throws BadArgumentException unless within [16, 65500] */
  void
  setMaximumTextureSize(int texels);

  int
  getMaximumTextureSize() const
  {
    return settings_.maximum_texture_size;
  }

  /** \brief Sets how far holes are filled from their borders (default -1: automatic, 0.1 m, at
   * least 5 texels; 0, and in paper mode: only the texels next to the polygon that
   * interpolation needs). \throws BadArgumentException unless within [-1, 1000] */
  void
  setFillDistance(int texels);

  int
  getFillDistance() const
  {
    return settings_.fill_distance;
  }

  /** \brief Enables the correction of the observations to a common exposure (default
   * true; not used in paper mode). */
  void
  setCorrectExposure(bool correct)
  {
    settings_.correct_exposure = correct;
  }

  bool
  getCorrectExposure() const
  {
    return settings_.correct_exposure;
  }

  /** \brief All settings. */
  acmap::TexturingSettings
  settings() const;

  /** \brief Estimates the memory that \ref texture takes for any number of observations.
   * \return bytes */
  double
  estimateMemory() const;

  /** \brief Textures the planes.
   * \param[out] map planes and cylinders with their pictures, the observations that saw each
   * plane, and the poses; empty when there are no planes, and the report says why
   * \throws InitFailedException when no planes were set, or an observation has no
   * coordinates
   * \throws BadArgumentException when the charts would have more of sixteen times the size
   * \throws CancelledException when the progress callback cancelled the run */
  void
  texture(CompactMap& map);

private:
  struct Observation {
    PointCloudConstPtr cloud;
    Eigen::Isometry3d T_map_camera;
    TexturedObservationLoader load;     ///< in place of both
    acmap::PaintedObservations painted; ///< in place of all
  };

  std::vector<PlanePatch> planes_;
  std::vector<CylinderPatch> cylinders_;
  bool has_planes_ = false;
  std::vector<Observation> observations_;
  acmap::TexturingSettings settings_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/texture/impl/plane_texturing.hpp>
#endif
