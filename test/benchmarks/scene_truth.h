#pragma once

#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A rectangle of a scene with a raster of what was seen of it. Scene frame. */
struct TruthSurface {
  SimulatedRectangle rectangle;
  std::int32_t plane = -1; ///< index of the truth plane
  Eigen::Vector3d unit_u;
  Eigen::Vector3d unit_v;
  Eigen::Vector3d normal; ///< unit, to the side it is seen from
  Eigen::Vector2d size;   ///< metres
  Eigen::Vector2i cells;
  std::vector<std::uint8_t> visible; ///< by u, then v

  /** \brief Metres along u, along v and off the surface. */
  Eigen::Vector3d
  coordinates(const Eigen::Vector3d& point) const;

  /** \brief To the nearest point of the rectangle. */
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

/** \brief The rectangles of a simulated scene, and which part of them its views show: what
 * a mesh of the scene is held against. Curved surfaces are left out. */
class SceneTruth {
public:
  /** \param[in] cell edge of the raster's cells, metres; slightly less where an edge of a
   * rectangle is no multiple of it */
  explicit SceneTruth(const SimulatedScene& scene, double cell = 0.02);

  /** \brief Marks what a view sees within its reach.
   * \param[in] factor how many times the pixels of the rig along each axis */
  void
  see(const SimulatedScene& scene, std::size_t view, int factor);

  const std::vector<TruthSurface>&
  surfaces() const
  {
    return surfaces_;
  }

  /** \brief Square metres seen. */
  double
  visibleArea() const;

  const TruthSurface&
  nearest(const Eigen::Vector3d& point) const;

  /** \brief Distance to the nearest surface of another plane than that of \a own.
   * \param[in] parallel whether surfaces that lie parallel to it count */
  double
  distanceToOthers(const Eigen::Vector3d& point,
                   const TruthSurface& own,
                   bool parallel = true) const;

private:
  std::vector<TruthSurface> surfaces_;
  std::vector<std::int32_t> of_scene_; ///< for each of the scene its place here, or -1
};

/** \brief So far from another plane a surface is clear of the crease: a voxel and two
 * standard deviations of the noise. */
double
creaseMargin(double voxel);

} // namespace pcl::acmap::bench
