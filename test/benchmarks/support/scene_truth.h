#pragma once

#include "bench.h"
#include "mesh_checker.h"

#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Core>

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

  /** \brief Calls visit (i, j) for the cells of a square with half the edge \a reach.
   * \param[in] place see coordinates */
  template <typename Visit>
  void
  visitCells(const Eigen::Vector3d& place, double reach, const Visit& visit) const
  {
    const auto cellAt = [&](int axis, double along) {
      return static_cast<int>(std::floor(along / size[axis] * cells[axis]));
    };
    const int end_i = std::min(cells[0], cellAt(0, place[0] + reach) + 1);
    const int end_j = std::min(cells[1], cellAt(1, place[1] + reach) + 1);
    for (int i = std::max(0, cellAt(0, place[0] - reach)); i < end_i; ++i)
      for (int j = std::max(0, cellAt(1, place[1] - reach)); j < end_j; ++j)
        visit(i, j);
  }
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

/** \brief Angles between normals and true normals, degrees. They are signed: a normal
 * that points into the wall is off by more than 90. */
struct NormalErrors {
  double median_away = 0; ///< away from creases, see \ref creaseMargin
  double p95_away = 0;
  double median_all = 0;
  double p95_all = 0;
  double backs_away = 0; ///< percentage of those that point into the surface
  double backs_all = 0;
};

/** \brief Compares each normal with that of the nearest surface; normals that are not
 * finite are ignored.
 * \param[in] places positions in the scene frame
 * \param[in] normals unit, scene frame
 * \param[in] voxel metres, for the distance to creases */
NormalErrors
measureNormals(const SceneTruth& truth,
               const test::Points& places,
               const test::Points& normals,
               double voxel);

/** \brief Adds these figures to a row, as far as they have targets with these. */
void
addErrors(const NormalErrors& errors,
          Row& row,
          double median_reach = no_reach,
          double p95_reach = no_reach);

/** \brief Comparison of a mesh with the truth. */
struct MeshFigures {
  NormalErrors normals; ///< of the faces
  double cover = 0;     ///< percentage of the visible raster with a triangle near it
  double overlap = 0;   ///< percentage with more than one triangle
  double area = 0;      ///< excess over the visible area, percent
  double boundary = 0;  ///< percentage of the edges with one triangle
};

/** \param[in] points scene frame
 * \param[in] voxel metres; a triangle covers the truth if their distance along the
 * normal of the truth is at most half a voxel or 5 cm, whichever is more */
MeshFigures
measureMesh(const SceneTruth& truth,
            const test::Points& points,
            const test::Triangles& triangles,
            double voxel);

} // namespace pcl::acmap::bench
