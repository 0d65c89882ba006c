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
  double member_distance = 0.8;  ///< W_d, metres
  double angle = 0.392699081699; ///< W_n, radians
  double plane_distance = 0.25;  ///< W_t, metres
  std::size_t support = 50;      ///< W_h
  /** \brief Is W_d the distance from any that was considered before as part of the plane, and not
   * from p_i alone? */
  bool by_members = true;
};

/** \brief A plane with p_i and its supporters in ascending order. */
struct NaivePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
  std::vector<std::int32_t> members;
};

struct NaiveGrowth {
  std::vector<NaivePlane> planes;
  std::size_t tested = 0;        ///< hypotheses
  std::size_t reestimations = 0; ///< of the parameters of a plane
};

/** \brief Literal implementation of the paper's clustering (II-C.2), O(n^2).
 * \param[in] order in which the hypotheses are tested */
NaiveGrowth
growNaively(const NaiveHypotheses& all,
            const NaiveThresholds& limits,
            const std::vector<std::int32_t>& order);

} // namespace pcl::acmap::test
