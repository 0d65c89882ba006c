#pragma once

#include <pcl/exceptions.h>

#include <cmath>
#include <sstream>
#include <string>

namespace pcl::acmap {

/** \brief Refuses an argument, naming value, legal range and unit.
 * \throws pcl::BadArgumentException always */
[[noreturn]] inline void
refuseArgument(const std::string& name, double value, const std::string& legal)
{
  std::ostringstream text;
  text << name << " = " << value << " is refused: it must be " << legal;
  throw BadArgumentException(text.str());
}

/** \brief Lets finite values in [least, most] pass.
 * \throws pcl::BadArgumentException otherwise */
inline void
requireInRange(const std::string& name,
               double value,
               double least,
               double most,
               const std::string& unit)
{
  if (std::isfinite(value) && value >= least && value <= most)
    return;
  std::ostringstream legal;
  legal << "within [" << least << ", " << most << "] " << unit;
  refuseArgument(name, value, legal.str());
}

} // namespace pcl::acmap
