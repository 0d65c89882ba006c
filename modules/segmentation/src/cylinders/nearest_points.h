#pragma once

#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::cylinders {

/** Finds the nearest points of a position with a balanced tree. Points that are not
 * finite are omitted. */
class NearestPoints {
public:
  explicit NearestPoints(const LargeVector<Eigen::Vector3d>& points);

  /** \param[out] found the nearest points in ascending order of distance, those of one
   * distance in the order of their numbers; fewer than \a count if there are no more */
  void
  find(const Eigen::Vector3d& place,
       std::size_t count,
       std::vector<std::int32_t>& found) const;

private:
  struct Candidate {
    double squared_distance;
    std::int32_t point;

    bool
    operator<(const Candidate& other) const
    {
      return squared_distance != other.squared_distance
                 ? squared_distance < other.squared_distance
                 : point < other.point;
    }
  };

  /** The nearest points so far, in ascending order. */
  struct Search {
    Eigen::Vector3d place;
    std::size_t count;
    std::vector<Candidate> nearest;

    bool
    isFull() const
    {
      return nearest.size() == count;
    }

    void
    consider(const Candidate& candidate);
  };

  void
  arrange(const LargeVector<Eigen::Vector3d>& points,
          std::size_t begin,
          std::size_t end);

  void
  visit(std::size_t begin, std::size_t end, Search& search) const;

  void
  consider(std::size_t i, Search& search) const
  {
    search.consider({(places_[i] - search.place).squaredNorm(), order_[i]});
  }

  LargeVector<std::int32_t> order_;     ///< the middle of a range divides it
  LargeVector<std::int8_t> axes_;       ///< of the division at each place of the order
  LargeVector<Eigen::Vector3d> places_; ///< of the points, in the order
};

} // namespace pcl::acmap::cylinders
