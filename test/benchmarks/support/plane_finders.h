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

/** \brief Result of a plane detection method. */
struct FoundPlanes {
  std::vector<Eigen::Vector4d> planes; ///< unit normal n and d: n.p + d = 0, metres
  std::vector<std::int32_t> labels;    ///< plane of each point, -1 for none
  double seconds = 0;                  ///< total CPU time of the calling thread
};

using PlaneFinder = std::function<FoundPlanes(const PlaneInput&)>;

/** \brief A method with its name in the tables. */
struct NamedFinder {
  std::string name;
  PlaneFinder find;
  bool is_ours = false; ///< its figures are compared with targets

  /** Larger clouds would take too long and are skipped. */
  std::size_t max_points = std::numeric_limits<std::size_t>::max();

  bool is_slow = false; ///< takes several seconds for a view of 300,000 points
};

/** \brief Runs a function that returns planes, and measures its time. */
template <typename Function>
FoundPlanes
timedPlanes(const Function& find)
{
  const double begin = threadSeconds();
  FoundPlanes found = find();
  found.seconds = threadSeconds() - begin;
  return found;
}

/** \brief The methods of PCL and, if available, of CGAL. */
std::vector<NamedFinder>
peers();

/** \brief Runs a method; fast ones run three times, and the median time is returned. */
FoundPlanes
findPlanes(const NamedFinder& finder, const PlaneInput& input);

} // namespace pcl::acmap::bench
