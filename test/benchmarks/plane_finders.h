#pragma once

#include "cpu_time.h"
#include "plane_input.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief What a finder of planes gives. */
struct FoundPlanes {
  std::vector<Eigen::Vector4d> planes; ///< unit normal n and d: n.p + d = 0, metres
  std::vector<std::int32_t> labels;    ///< for each point index of its plane, -1 none
  double seconds = 0;                  ///< CPU of the calling thread, all in
};

using PlaneFinder = std::function<FoundPlanes(const PlaneInput&)>;

/** \brief A finder as it appears in the tables. */
struct NamedFinder {
  std::string name;
  PlaneFinder find;
  bool is_ours = false; ///< its figures stand beside what they should reach

  /** \brief Larger clouds take it too long, and are left out. */
  std::size_t most_points = std::numeric_limits<std::size_t>::max();

  bool is_slow = false; ///< takes several seconds for a view of 300,000 points
};

/** \brief Runs a function that gives found planes, and notes what it took. */
template <typename Function>
FoundPlanes
timedPlanes(const Function& find)
{
  const double begin = threadSeconds();
  FoundPlanes found = find();
  found.seconds = threadSeconds() - begin;
  return found;
}

/** \brief The methods of PCL and, where it is there, of CGAL. */
std::vector<NamedFinder>
peers();

/** \brief Runs a finder; three times if it is fast, and then tells the median time. */
FoundPlanes
findPlanes(const NamedFinder& finder, const PlaneInput& input);

} // namespace pcl::acmap::bench
