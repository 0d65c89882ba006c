#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/scratch_memory.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::acmap {

/** \brief Points of a plane that an observation saw: places u, v on the plane, from its centre,
 * and distances d from it; metres. */
struct Glimpse {
  std::size_t count = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(),
                  d_sums = Eigen::Vector2d::Zero(); ///< of (u, v) and of d (u, v)
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double d_sum = 0;

  void
  add(const Eigen::Vector2d& place, double d)
  {
    ++count;
    sum += place;
    squares += place * place.transpose();
    d_sum += d;
    d_sums += d * place;
  }

  double
  number() const
  {
    return static_cast<double>(count);
  }

  Eigen::Vector2d
  center() const
  {
    return sum / number();
  }

  double
  offset() const
  {
    return d_sum / number();
  }

  Eigen::Matrix2d
  scatter() const
  {
    return squares / number() - center() * center().transpose();
  }

  /** \brief Covariance between the places and the distances. */
  Eigen::Vector2d
  bend() const
  {
    return d_sums / number() - offset() * center();
  }
};

/** \brief By observation. */
using Glimpses = std::map<std::int32_t, Glimpse>;

/** \brief A small flat piece of what is no plane of the map: clutter, columns, frames. */
struct LoosePiece {
  PlanePatch patch; ///< centre, axes and coefficients
  Glimpses glimpses;
  std::size_t count = 0;
};

/** \brief What observations saw of each plane, from 200 points on and from the side from which most
 * were seen; of the 300 largest planes.
 * \param[in] cloud points with the field `view`, metres, in the map frame; without it nothing is seen
 * \param[in] labels plane of each point, -1 for none
 * \param[in] poses T_map_camera of the observations */
std::vector<Glimpses>
glimpsesOfPlanes(const CloudRows& cloud,
                 const PointLabels& labels,
                 const std::vector<PlanePatch>& planes,
                 const std::vector<Eigen::Isometry3d>& poses);

/** \brief The flat pieces of what is on no plane that several observations saw: at most 500, those
 * with the most points first. The parameters are those of \ref glimpsesOfPlanes. */
std::vector<LoosePiece>
loosePieces(const CloudRows& cloud,
            const PointLabels& labels,
            const std::vector<Eigen::Isometry3d>& poses);

} // namespace pcl::acmap
