#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/stage_controls.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/texture/texturing_types.h>

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace pcl {

namespace acmap {
struct TexturingSettings;
}

/** \brief Paints planes with the colours of the observations: the last step of
 * "Active Stereo Based Compact Mapping" (II-C), which turns planes into a compact map.
 *
 * Each polygon of a plane gets a rectangular chart of texels. A point colours the closest
 * plane whose polygon its foot is in, within 0.3 m, as in the paper. An organized cloud as a
 * pinhole camera sees it is projected into instead, texel by texel: a texel is seen where
 * the view's own depth around its pixel is of its plane, and colours next to depth edges
 * hardly count. Of each texel the four best samples are kept (near, frontal, off the image's
 * rim), brought to one exposure by a gain for each view, and those that agree with their
 * median are averaged. Holes are filled from their rims a few texels far; what remains
 * unknown stays so (\ref TexelKind).
 *
 * Metres, in the frame of the planes; colours as in the clouds. Time O(n p + t v) for n
 * points, p planes near a view, t texels and v views that see them; the same bytes for every
 * number of threads.
 * \code
 * pcl::PlaneTexturing<pcl::PointXYZRGB> texturing;
 * texturing.setPlanes (planes);                        // of PlaneHypothesisClustering
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   texturing.addObservation (clouds[i], poses[i]);    // organized, camera frame
 * pcl::CompactMap map;
 * texturing.texture (map);
 * pcl::saveCompactMap ("map", map);
 * \endcode
 * \ingroup texture
 */
template <typename PointT>
class PlaneTexturing : public StageControls<TexturingReport> {
public:
  using Ptr = shared_ptr<PlaneTexturing<PointT>>;
  using ConstPtr = shared_ptr<const PlaneTexturing<PointT>>;
  using PointCloudConstPtr = typename PointCloud<PointT>::ConstPtr;

  /** \brief Sets the planes; those without polygons get no chart, nor do polygons that have
   * no area or are not finite, and the report says so. */
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

  /** \brief Adds what was seen from one pose. An organized cloud is one that was seen from
   * the origin of its frame: it colours no plane that looks away from there.
   * \param[in] cloud organized or not; its points may be NaN, its colours are valid at each
   * of them
   * \param[in] T_map_camera from the frame of the cloud to that of the planes
   * \throws BadArgumentException when the cloud is missing or the pose is no rigid motion */
  void
  addObservation(const PointCloudConstPtr& cloud,
                 const Eigen::Isometry3d& T_map_camera = Eigen::Isometry3d::Identity());

  /** \brief Adds an observation that is loaded when it is painted, and not kept: so memory
   * holds one of a long sequence at a time.
   * \param[in] load called once by each \ref texture, which passes on what it throws
   * \throws BadArgumentException without a loader */
  void
  addObservation(TexturedObservationLoader load);

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

  /** \brief Sets the edge of a texel (default 0.02 m).
   * \throws BadArgumentException unless within [1e-4, 10] m */
  void
  setTexelSize(double metres);

  double
  getTexelSize() const
  {
    return texel_size_;
  }

  /** \brief Sets how far a point may be from the plane it colours (default 0.3 m, the
   * paper's). \throws BadArgumentException unless within (0, 1e3] m */
  void
  setMaximumDistance(double metres);

  double
  getMaximumDistance() const
  {
    return maximum_distance_;
  }

  /** \brief Sets how many texels a side of a chart may have (default 4096); larger polygons
   * get several charts. \throws BadArgumentException unless within [16, 65500] */
  void
  setMaximumTextureSize(int texels);

  int
  getMaximumTextureSize() const
  {
    return maximum_texture_size_;
  }

  /** \brief Sets how far holes are filled from their rims (default 5 texels; 0: only the rim
   * that interpolation needs).
   * \throws BadArgumentException unless within [0, 1000] */
  void
  setFillDistance(int texels);

  int
  getFillDistance() const
  {
    return fill_distance_;
  }

  /** \brief Brings the observations to one exposure (default true). */
  void
  setCorrectExposure(bool correct)
  {
    correct_exposure_ = correct;
  }

  bool
  getCorrectExposure() const
  {
    return correct_exposure_;
  }

  /** \brief Estimates the memory that \ref texture takes, whatever the number of
   * observations. \return bytes */
  double
  estimateMemory() const;

  /** \brief Paints the planes.
   * \param[out] map the planes with their charts, which observations saw which plane, and
   * the poses; of no planes it is empty, and the report says why
   * \throws InitFailedException when no planes were set, or an observation has no
   * coordinates
   * \throws BadArgumentException when the charts have more than 2^28 texels
   * \throws CancelledException when the progress callback stopped it */
  void
  texture(CompactMap& map);

private:
  struct Observation {
    PointCloudConstPtr cloud;
    Eigen::Isometry3d T_map_camera;
    TexturedObservationLoader load; ///< in place of both
  };

  acmap::TexturingSettings
  settings() const;

  std::vector<PlanePatch> planes_;
  bool has_planes_ = false;
  std::vector<Observation> observations_;
  double texel_size_ = 0.02;
  double maximum_distance_ = 0.3;
  int maximum_texture_size_ = 4096;
  int fill_distance_ = 5;
  bool correct_exposure_ = true;
};

} // namespace pcl
