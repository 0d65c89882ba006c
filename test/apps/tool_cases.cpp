#include "tool_cases.h"

#include "clouds.h"

#include <gtest/gtest.h>

#include <sstream>

namespace pcl::acmap::test {

ToolRun
runSurface(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_DEWALL_SURFACE, arguments, settings);
}

ToolRun
runViewer(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_COMPACT_VIEWER, arguments, settings);
}

ToolRun
runPlanes(const std::vector<std::string>& arguments, const RunSettings& settings)
{
  return runTool(ACMAP_PLANE_EXTRACTION, arguments, settings);
}

std::string
pcdText(const PointCloud<PointXYZ>& cloud)
{
  std::ostringstream text;
  text.precision(9);
  text << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
       << cloud.size() << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << cloud.size()
       << "\nDATA ascii\n";
  for (const PointXYZ& p : cloud)
    text << p.x << " " << p.y << " " << p.z << "\n";
  return text.str();
}

std::string
planePcd(int columns)
{
  SheetSampling sampling;
  sampling.columns = columns;
  sampling.rows = columns;
  sampling.spacing = 0.01;
  sampling.noise = 0.05;
  return pcdText(makeJitteredPlane(sampling).cloud);
}

} // namespace pcl::acmap::test
