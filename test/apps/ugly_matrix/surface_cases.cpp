#include "input_cases.h"
#include "ugly_tools.h"

namespace pcl::acmap::test {
namespace {

const UglyOutcome well;
const UglyOutcome millimetres = {0, "looks like millimetres"};
const UglyOutcome vast = {0, "cannot be metres"};

} // namespace

UglyTool
uglyDewallSurface()
{
  const std::string output = "mesh.ply";
  const auto command = [output](const std::string& file) {
    return std::vector<std::string>{file, output};
  };
  return {"pcl_dewall_surface",
          output,
          false,
          false,
          cloudCases(command,
                     {{nan_points, {4, "nan.pcd"}},
                      {one_point, {4, "one.pcd"}},
                      {doubled_points, {0, "repeat the place"}},
                      {vast_points, vast},
                      {far_points, {4, "in steps of"}},
                      {millimetre_points, millimetres},
                      {odd_cloud, well}})};
}

UglyTool
uglyPlaneExtraction()
{
  const std::string output = "planes.json";
  const auto command = [output](const std::string& file) {
    return std::vector<std::string>{file, output};
  };
  return {"pcl_plane_extraction",
          output,
          false,
          false,
          cloudCases(command,
                     {{nan_points, {4, "nan.pcd"}},
                      {one_point, {4, "one.pcd"}},
                      {doubled_points, {0, "repeat the place"}},
                      {vast_points, {4, "cannot be metres"}},
                      {far_points, {4, "in steps of"}},
                      {millimetre_points, millimetres},
                      {odd_cloud, well}})};
}

UglyTool
uglyCloudInfo()
{
  const std::string output = "report.json";
  const auto command = [output](const std::string& file) {
    return std::vector<std::string>{file, "--report", output};
  };
  return {"pcl_cloud_info",
          output,
          false,
          false,
          cloudCases(command,
                     {{nan_points, {4, "nan.pcd"}},
                      {one_point, well},
                      {doubled_points, well},
                      {vast_points, {0, "cannot be metres"}},
                      {far_points, {0, "in steps of"}},
                      {millimetre_points, {0, "looks like millimetres"}},
                      {odd_cloud, well}})};
}

UglyTool
uglyCompactViewer()
{
  const std::string output = "picture.png";
  const auto command = [output](const std::string& file) {
    return std::vector<std::string>{file, "--screenshot", output};
  };
  return {"pcl_compact_viewer",
          output,
          false,
          true,
          cloudCases(command,
                     {{nan_points, {4, "nan.pcd"}},
                      {one_point, well},
                      {doubled_points, well},
                      {vast_points, vast},
                      {far_points, {0, "in steps of"}},
                      {millimetre_points, millimetres},
                      {odd_cloud, well}})};
}

} // namespace pcl::acmap::test
