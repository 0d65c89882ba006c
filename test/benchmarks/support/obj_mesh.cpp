#include "obj_mesh.h"

#include <pcl/core/exceptions.h>

#include <fstream>
#include <sstream>

namespace pcl::acmap::bench {

ObjMesh
loadObjMesh(const std::string& path)
{
  std::ifstream file(path);
  ObjMesh mesh;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Eigen::Vector3f point;
      words >> point.x() >> point.y() >> point.z();
      mesh.points.push_back(point.cast<double>());
    }
    else if (kind == "f") {
      std::vector<std::int32_t> corners;
      for (std::string corner; words >> corner;)
        corners.push_back(std::stoi(corner) - 1);
      for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  if (mesh.triangles.empty())
    throw InputFileException(path + " holds no face");
  return mesh;
}

} // namespace pcl::acmap::bench
