#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Edge of the cells in which outlines are compared, metres. */
inline constexpr double raster_cell = 0.01;

/** \brief Frame of a plane; u, v and the normal are a right-handed basis. */
struct PlaneFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(); ///< unit
  Eigen::Vector3d v = Eigen::Vector3d::UnitY(); ///< unit

  /** \brief Metres along u and v of the point's projection. */
  Eigen::Vector2d
  flat(const Eigen::Vector3d& point) const
  {
    return {(point - origin).dot(u), (point - origin).dot(v)};
  }

  Eigen::Vector3d
  lifted(const Eigen::Vector2d& place) const
  {
    return origin + place.x() * u + place.y() * v;
  }
};

/** \brief A frame of a plane a x + b y + c z + d = 0; u is the projection of the x axis,
 * or of the z axis for planes that face along x: level for floors and walls. */
PlaneFrame
makePlaneFrame(const Eigen::Vector4d& coefficients);

using FlatLoop = std::vector<Eigen::Vector2d>; ///< metres

/** \brief A set of cells of a plane. Cell (i, j) covers [i, i + 1] x [j, j + 1] cells
 * from the origin of the plane's frame; cells outside of the box are not in the set. */
class CellSet {
public:
  CellSet() = default;

  /** \param[in] box metres */
  explicit CellSet(const Eigen::AlignedBox2d& box);

  bool
  has(int i, int j) const
  {
    return i >= first_i_ && i < end_i_ && j >= first_j_ && j < end_j_ &&
           cells_[indexOf(i, j)] != 0;
  }

  /** \brief Is the cell around a place, in metres, in the set? */
  bool
  hasPlace(const Eigen::Vector2d& place) const;

  /** \brief Adds a cell of the box. */
  void
  add(int i, int j)
  {
    cells_[indexOf(i, j)] = 1;
  }

  /** \brief Adds the cells whose centres are inside of an odd number of the loops: the
   * interior of a polygon with holes. */
  void
  addInside(const std::vector<FlatLoop>& loops);

  /** \brief Is a cell within \a reach cells, measured between centres, in the set? */
  bool
  hasNear(int i, int j, int reach) const;

  /** \brief Are all cells within \a reach cells in the set? */
  bool
  hasAllNear(int i, int j, int reach) const;

  /** \brief Square metres. */
  double
  area() const;

  /** \brief Calls visit (i, j) for each cell of the set. */
  template <typename Visitor>
  void
  forEach(const Visitor& visit) const
  {
    for (int i = first_i_; i < end_i_; ++i)
      for (int j = first_j_; j < end_j_; ++j)
        if (cells_[indexOf(i, j)] != 0)
          visit(i, j);
  }

private:
  std::size_t
  indexOf(int i, int j) const
  {
    return static_cast<std::size_t>(i - first_i_) *
               static_cast<std::size_t>(end_j_ - first_j_) +
           static_cast<std::size_t>(j - first_j_);
  }

  int first_i_ = 0, end_i_ = 0, first_j_ = 0, end_j_ = 0;
  std::vector<std::uint8_t> cells_;
};

/** \brief Centre of a cell, metres. */
inline Eigen::Vector2d
cellCenter(int i, int j)
{
  return {raster_cell * (i + 0.5), raster_cell * (j + 0.5)};
}

Eigen::AlignedBox2d
boxOf(const std::vector<FlatLoop>& loops);

} // namespace pcl::acmap::bench
