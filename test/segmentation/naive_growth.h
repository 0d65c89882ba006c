#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief Points with unit normals. */
struct NaiveHypotheses {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
};

struct NaiveThresholds {
  double member_distance = 0.8; ///< W_d, metres
  double cosine = 0.923879533;  ///< of W_n
  double plane_distance = 0.25; ///< W_t, metres
  std::size_t support = 50;     ///< W_h
};

/** \brief A plane with its supporters, ascending. */
struct NaivePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
  std::vector<std::int32_t> members;
};

/** \brief Do a point's normal and place agree with a plane? */
bool
supports(const NaiveHypotheses& all,
         std::size_t point,
         const NaivePlane& plane,
         const NaiveThresholds& limits);

/** \brief Is a point nearer than W_d to some supporter other than itself? */
bool
isNearSome(const NaiveHypotheses& all,
           std::size_t point,
           const NaivePlane& plane,
           const NaiveThresholds& limits);

/** \brief The plane of least squares through members, to the side of a normal. */
NaivePlane
planeThrough(const NaiveHypotheses& all,
             const std::vector<std::int32_t>& members,
             const Eigen::Vector3d& front);

/** \brief The paper's clustering (II-C.2) read literally, O(n^2): each supporter that is
 * found recomputes the plane from all; seeds are tried in their order. */
std::vector<NaivePlane>
growNaively(const NaiveHypotheses& all, const NaiveThresholds& limits);

} // namespace pcl::acmap::test
