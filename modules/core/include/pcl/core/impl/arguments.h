#pragma once

#include <pcl/core/exceptions.h>

#include <Eigen/Core>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Rejects an argument. The message contains its value, legal range and unit.
 * \throws pcl::BadArgumentException always */
[[noreturn]] inline void
refuseArgument(const std::string& name, double value, const std::string& legal)
{
  std::ostringstream text;
  text << name << " = " << value << " is refused: it must be " << legal;
  throw acmap::BadArgument(text.str());
}

/** \brief Checks that a value is finite and in [least, most].
 * \throws pcl::BadArgumentException otherwise */
inline void
requireInRange(const std::string& name,
               double value,
               double minimum,
               double maximum,
               const std::string& unit)
{
  if (std::isfinite(value) && value >= minimum && value <= maximum)
    return;
  std::ostringstream legal;
  legal << "within [" << minimum << ", " << maximum << "] " << unit;
  refuseArgument(name, value, legal.str());
}

/** \brief The most threads of a class or a tool. */
inline constexpr unsigned max_threads = 1024;

/** \brief Checks a number of threads, 0 for all.
 * \return the same
 * \throws pcl::BadArgumentException above \ref max_threads, as for a negative number that
 * was converted */
inline unsigned
requiredThreads(unsigned threads)
{
  requireInRange("number of threads", threads, 0, max_threads, "(0 = all)");
  return threads;
}

/** \brief Checks that all sensor positions, in metres, are finite and within 1e9 m.
 * \throws pcl::BadArgumentException otherwise */
inline void
requireViewpoints(const std::vector<Eigen::Vector3f>& viewpoints)
{
  for (const Eigen::Vector3f& viewpoint : viewpoints)
    for (const float coordinate : viewpoint)
      requireInRange("viewpoint", coordinate, -1e9, 1e9, "m");
}

/** \brief Checks an up direction.
 * \return the same of length 1
 * \throws pcl::BadArgumentException if it is not finite or zero */
inline Eigen::Vector3d
requiredDirection(const Eigen::Vector3d& up)
{
  const double largest = up.cwiseAbs().maxCoeff();
  if (!up.allFinite() || !(largest > 0))
    throw acmap::BadArgument("the up direction must be finite and not zero");
  return (up / largest).normalized();
}

} // namespace pcl::acmap
