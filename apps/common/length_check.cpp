#include "length_check.h"

#include "exit_code.h"

#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/size_text.h>

namespace pcl::acmap {
namespace {

/** Limits for a length that divides a cloud, in extents: above the first it exceeds the
 * cloud, above the second it leaves only few parts. The extent is that of most points;
 * all points may reach farther. */
constexpr double extents_beyond = 2.0;
constexpr double coarse_extents = 0.1;

} // namespace

void
requireFineLength(const std::string& option,
                  double metres,
                  const PointView& points,
                  StageLog& log)
{
  const double extent = cloudExtent(points).diagonal();
  if (!(extent > 0) || metres <= coarse_extents * extent)
    return;
  std::string text = option + " " + shortNumber(metres) +
                     ": lengths are in metres, and most of the cloud lies within " +
                     shortNumber(extent) + " m";
  if (const double millimetres = 0.001 * metres; millimetres <= coarse_extents * extent)
    text += "; for " + shortNumber(metres) + " mm give " + shortNumber(millimetres);
  if (metres > extents_beyond * extent)
    throw UsageError(text);
  log.warn(text);
}

} // namespace pcl::acmap
