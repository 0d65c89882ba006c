#include "seen_surfaces.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/moments.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace pcl::acmap {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** \brief Calls see (point, observation, plane or -1) for the points of a cloud that observations
 * have seen. */
template <typename See>
void
forEachSeen(const CloudRows& cloud,
            const PointLabels& labels,
            std::size_t views,
            const See& see)
{
  const PCLPointField* const field =
      findField(cloud.layout(), "view", PCLPointField::INT32);
  if (!field || labels.size() != cloud.size())
    return;
  const PointView points = requirePoints(cloud);
  const std::size_t step = cloud.layout().point_step;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::int32_t view = 0;
    std::memcpy(&view, cloud.data() + i * step + field->offset, sizeof view);
    if (view >= 0 && static_cast<std::size_t>(view) < views)
      see(points[i], view, labels[i]);
  }
}

void
dropSparse(std::size_t min_count, Glimpses& glimpses)
{
  for (auto one = glimpses.begin(); one != glimpses.end();)
    one = one->second.count < min_count ? glimpses.erase(one) : std::next(one);
}

/** \brief Keeps the observations that see the front of a plane, which is where most of its points
 * were seen from: points of a thin wall's other face are labelled alike. */
void
keepFront(const PlanePatch& plane,
          const std::vector<Eigen::Isometry3d>& poses,
          Glimpses& glimpses)
{
  const auto isBefore = [&](std::int32_t view) {
    const Vector3d sensor = poses[static_cast<std::size_t>(view)].translation();
    return plane.coefficients.dot(sensor.homogeneous()) > 0;
  };
  double balance = 0;
  for (const auto& [view, glimpse] : glimpses)
    balance += isBefore(view) ? glimpse.number() : -glimpse.number();
  for (auto one = glimpses.begin(); one != glimpses.end();)
    one = isBefore(one->first) == (balance > 0) ? std::next(one) : glimpses.erase(one);
}

/** \brief Sum of the products p p^T. */
Matrix3d
productsOf(const Moments& sums)
{
  Matrix3d products;
  products << sums.xx, sums.xy, sums.xz, sums.xy, sums.yy, sums.yz, sums.xz, sums.yz,
      sums.zz;
  return products;
}

Matrix3d
covarianceOf(const Moments& sums)
{
  return productsOf(sums) / sums.count - sums.mean() * sums.mean().transpose();
}

/** \brief The points as they lie on a plane.
 * \param[in] center of the plane, in the frame of the sums */
Glimpse
glimpseOf(const Moments& sums, const PlanePatch& plane, const Vector3d& center)
{
  Eigen::Matrix<double, 2, 3> axes;
  axes << plane.axis_u.transpose(), plane.axis_v.transpose();
  const Vector3d normal = plane.coefficients.head<3>();
  const Vector3d sum(sums.x, sums.y, sums.z);
  const Vector3d arms = sum - sums.count * center;
  const Matrix3d products = productsOf(sums) - sum * center.transpose() -
                            center * sum.transpose() +
                            sums.count * center * center.transpose();
  Glimpse glimpse;
  glimpse.count = static_cast<std::size_t>(sums.count);
  glimpse.sum = axes * arms;
  glimpse.d_sums = axes * products * normal;
  glimpse.squares = axes * products * axes.transpose();
  glimpse.d_sum = normal.dot(arms);
  return glimpse;
}

/** \brief Cells of space with the points that belong to no plane, by observation. */
class LooseCells {
public:
  void
  add(const Eigen::Vector3f& point, std::int32_t view)
  {
    const Eigen::Array3d place = point.cast<double>().array() / edge;
    if (!((place.abs() < limit).all()))
      return;
    const Cell cell{static_cast<int>(std::floor(place[0])),
                    static_cast<int>(std::floor(place[1])),
                    static_cast<int>(std::floor(place[2]))};
    if (cells_.size() < max_cells || cells_.count(cell) > 0)
      cells_[cell][view] += momentsOf(point.cast<double>() - cornerOf(cell));
  }

  /** \brief The flat pieces that several observations saw, those with the most points. */
  std::vector<LoosePiece>
  pieces(const std::vector<Eigen::Isometry3d>& poses) const
  {
    std::vector<LoosePiece> found;
    for (const auto& [cell, by_view] : cells_)
      if (std::optional<LoosePiece> piece = pieceOf(cell, by_view, poses))
        found.push_back(std::move(*piece));
    std::stable_sort(
        found.begin(), found.end(), [](const LoosePiece& a, const LoosePiece& b) {
          return a.count > b.count;
        });
    found.resize(std::min(found.size(), max_pieces));
    return found;
  }

private:
  using Cell = std::array<int, 3>;

  static constexpr double edge = 0.25, limit = 1e8; // metres, cells
  static constexpr std::size_t max_cells = 100000, max_pieces = 500;

  static Vector3d
  cornerOf(const Cell& cell)
  {
    return edge * Vector3d(cell[0], cell[1], cell[2]);
  }

  static std::optional<LoosePiece>
  pieceOf(const Cell& cell,
          const std::map<std::int32_t, Moments>& by_view,
          const std::vector<Eigen::Isometry3d>& poses)
  {
    constexpr double min_of_view = 30;
    constexpr double max_thickness = 0.02, min_extent = 0.03; // metres
    Moments all;
    for (const auto& [view, moments] : by_view)
      if (moments.count >= min_of_view)
        all += moments;
    if (by_view.size() < 2 || all.count < 2 * min_of_view)
      return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covarianceOf(all));
    if (!(axes.eigenvalues()[0] < max_thickness * max_thickness) ||
        !(axes.eigenvalues()[1] > min_extent * min_extent))
      return std::nullopt;
    LoosePiece piece;
    PlanePatch& patch = piece.patch;
    patch.center = cornerOf(cell) + all.mean();
    const Vector3d normal = axes.eigenvectors().col(0);
    patch.axis_u = axes.eigenvectors().col(2);
    patch.axis_v = normal.cross(patch.axis_u);
    patch.coefficients << normal, -normal.dot(patch.center);
    for (const auto& [view, moments] : by_view)
      if (moments.count >= min_of_view)
        piece.glimpses[view] = glimpseOf(moments, patch, all.mean());
    keepFront(patch, poses, piece.glimpses);
    for (const auto& [view, glimpse] : piece.glimpses)
      piece.count += glimpse.count;
    return piece.glimpses.size() < 2 ? std::nullopt : std::optional(piece);
  }

  std::map<Cell, std::map<std::int32_t, Moments>> cells_;
};

} // namespace

std::vector<Glimpses>
glimpsesOfPlanes(const CloudRows& cloud,
                 const PointLabels& labels,
                 const std::vector<PlanePatch>& planes,
                 const std::vector<Eigen::Isometry3d>& poses)
{
  constexpr std::size_t max_planes = 300, min_points = 200;
  std::vector<Glimpses> glimpses(std::min(planes.size(), max_planes));
  forEachSeen(cloud,
              labels,
              poses.size(),
              [&](const Eigen::Vector3f& point, std::int32_t view, std::int32_t label) {
                if (label < 0 || static_cast<std::size_t>(label) >= glimpses.size())
                  return;
                const auto number = static_cast<std::size_t>(label);
                const PlanePatch& plane = planes[number];
                const Vector3d place = point.cast<double>();
                const Vector3d arm = place - plane.center;
                glimpses[number][view].add(
                    {arm.dot(plane.axis_u), arm.dot(plane.axis_v)},
                    plane.coefficients.dot(place.homogeneous()));
              });
  for (std::size_t plane = 0; plane < glimpses.size(); ++plane) {
    dropSparse(min_points, glimpses[plane]);
    keepFront(planes[plane], poses, glimpses[plane]);
  }
  return glimpses;
}

std::vector<LoosePiece>
loosePieces(const CloudRows& cloud,
            const PointLabels& labels,
            const std::vector<Eigen::Isometry3d>& poses)
{
  LooseCells cells;
  forEachSeen(cloud,
              labels,
              poses.size(),
              [&](const Eigen::Vector3f& point, std::int32_t view, std::int32_t label) {
                if (label < 0)
                  cells.add(point, view);
              });
  return cells.pieces(poses);
}

} // namespace pcl::acmap
