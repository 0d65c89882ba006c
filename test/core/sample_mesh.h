#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap::test {

/** \brief A cloud with all fields that mesh files store, and a mesh of random
 * triangles. */
struct SampleMesh {
  explicit SampleMesh(int points = 30000);

  PCLPointCloud2 cloud;
  TriangleMesh mesh;
};

} // namespace pcl::acmap::test
