#pragma once

#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A rectangle of a scene with a raster of its observed part. Scene frame. */
struct TruthSurface {
  SimulatedRectangle rectangle;
  std::int32_t plane = -1; ///< index of the truth plane
  Eigen::Vector3d unit_u;
  Eigen::Vector3d unit_v;
  Eigen::Vector3d normal; ///< unit, towards the observed side
  Eigen::Vector2d size;   ///< metres
  Eigen::Vector2i cells;
  std::vector<std::uint8_t> visible; ///< see cellIndex

  /** \brief Metres along u, along v and along the normal. */
  Eigen::Vector3d
  coordinates(const Eigen::Vector3d& point) const;

  /** \brief Distance to the nearest point of the rectangle. */
  double
  distance(const Eigen::Vector3d& point) const;

  double
  cellArea() const;

  std::size_t
  cellIndex(int i, int j) const
  {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(cells[1]) +
           static_cast<std::size_t>(j);
  }

  Eigen::Vector3d
  cellCenter(int i, int j) const;
};

/** \brief The rectangles of a simulated scene with the parts that its views show: the
 * reference for meshes of the scene. Curved surfaces are ignored. */
class SceneTruth {
public:
  /** \param[in] cell edge of the raster's cells, metres; slightly reduced if an edge of
   * a rectangle is not a multiple of it */
  explicit SceneTruth(const SimulatedScene& scene, double cell = 0.02);

  /** \brief Marks what a view sees within its range.
   * \param[in] factor of the rig's resolution along each axis */
  void
  see(const SimulatedScene& scene, std::size_t view, int factor);

  const std::vector<TruthSurface>&
  surfaces() const
  {
    return surfaces_;
  }

  /** \brief Observed area in square metres. */
  double
  visibleArea() const;

  const TruthSurface&
  nearest(const Eigen::Vector3d& point) const;

  /** \brief Distance to the nearest surface that belongs to another plane than \a own.
   * \param[in] parallel do parallel surfaces count? */
  double
  distanceToOthers(const Eigen::Vector3d& point,
                   const TruthSurface& own,
                   bool parallel = true) const;

private:
  std::vector<TruthSurface> surfaces_;
  std::vector<std::int32_t> of_scene_; ///< index here of each surface of the scene, or
                                       ///< -1
};

/** \brief Distance from other planes at which a surface is not affected by creases: a
 * voxel plus two standard deviations of the noise. */
double
creaseMargin(double voxel);

} // namespace pcl::acmap::bench
