#include "raw_mesh.h"

namespace pcl::acmap::bench {

RawMesh
meshRaw(const PointView& points, DeWallRule rule, unsigned threads)
{
  DeWallSettings settings;
  settings.rule = rule;
  settings.threads = threads;
  RawMesh result;
  result.mesh = triangulateDeWall(points, settings, Progress(), result.report);
  return result;
}

std::string
ruleName(DeWallRule rule)
{
  return rule == DeWallRule::Paper ? "DeWall paper" : "DeWall dense";
}

} // namespace pcl::acmap::bench
