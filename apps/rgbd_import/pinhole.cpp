#include "pinhole.h"

#include "output_target.h"
#include "text_rows.h"

#include <pcl/core/trinocular_rig.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

Pinhole
loadPinhole(const std::string& path)
{
  const std::string ending = endingOf(path);
  if (ending == ".yaml" || ending == ".yml") {
    const TrinocularRig rig = loadTrinocularRig(path);
    return {rig.focal_length, rig.focal_length, rig.center_x, rig.center_y};
  }
  constexpr double least = 1e-6;
  constexpr double most = 1e6;
  const std::vector<double> m = loadSquareMatrix(path, 3);
  const bool is_sound = std::min(m[0], m[4]) >= least && std::max(m[0], m[4]) <= most &&
                        std::max(std::abs(m[2]), std::abs(m[5])) <= most;
  if (!is_sound || m[1] != 0 || m[3] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1)
    throw InputFileException(
        path + ": is no matrix of a camera: fx 0 cx, 0 fy cy, 0 0 1 is needed");
  return {m[0], m[4], m[2], m[5]};
}

} // namespace pcl::acmap
