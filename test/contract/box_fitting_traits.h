#pragma once

#include "plane_hypothesis_clustering_traits.h"

#include <pcl/segmentation/box_fitting.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace pcl::acmap::test {

struct BoxFittingTraits {
  using Class = BoxFitting;

  struct Output : std::vector<BoxPatch> {
    bool
    operator==(const Output& other) const
    {
      return std::equal(begin(), end(), other.begin(), other.end(), areSame);
    }

    static bool
    areSame(const BoxPatch& a, const BoxPatch& b)
    {
      for (std::size_t side = 0; side < a.faces.size(); ++side)
        if (a.faces[side].kind != b.faces[side].kind ||
            a.faces[side].plane != b.faces[side].plane)
          return false;
      return a.center == b.center && a.axes == b.axes && a.size == b.size &&
             a.covariance == b.covariance && a.template_id == b.template_id &&
             a.saved_bits == b.saved_bits;
    }
  };

  /** A square that is seen from the side of edge_u x edge_v. */
  static PlanePatch
  square(const PlanePatch& like,
         const Eigen::Vector3d& center,
         const Eigen::Vector3d& edge_u,
         const Eigen::Vector3d& edge_v)
  {
    PlanePatch patch = like;
    const Eigen::Vector3d normal = edge_u.cross(edge_v).normalized();
    patch.coefficients << normal, -normal.dot(center);
    patch.center = center;
    patch.axis_u = edge_u.normalized();
    patch.axis_v = edge_v.normalized();
    PlanePolygon polygon;
    for (const auto& [u, v] :
         {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      polygon.outer.push_back((center + u * edge_u + v * edge_v).cast<float>());
    patch.polygons = {polygon};
    return patch;
  }

  /** A cube on a floor, of the size of the largest plane of a cloud; none if the cloud
   * has no plane. Points that are not finite are planes that are not. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    PlaneHypothesisClustering<PointXYZ> clustering;
    PlaneHypothesisClusteringTraits::setInput(clustering, cloud);
    std::vector<PlanePatch> found, planes;
    clustering.segment(found);
    if (!found.empty()) {
      const PlanePatch& largest = found.front();
      const double edge = std::sqrt(largest.area);
      const Eigen::Vector3d u = edge * largest.axis_u, v = edge * largest.axis_v,
                            n = u.cross(v) / edge;
      for (const Eigen::Vector3d& way : {u, v}) {
        const Eigen::Vector3d across = n.cross(way) / edge;
        planes.push_back(square(largest, largest.center + way / 2, across, n));
        planes.push_back(square(largest, largest.center - way / 2, n, across));
      }
      planes.push_back(square(largest, largest.center + n / 2, u, v));
      planes.push_back(square(largest, largest.center - n / 2, 3 * u, 3 * v));
    }
    for (const PointXYZ& point : cloud)
      if (!point.getVector3fMap().allFinite()) {
        PlanePatch invalid;
        invalid.coefficients.head<3>() = point.getVector3fMap().cast<double>();
        planes.push_back(invalid);
      }
    object.setPlanes(planes);
  }

  static void
  run(Class& object, Output& output)
  {
    object.segment(static_cast<std::vector<BoxPatch>&>(output));
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.empty();
  }

  static Output
  sentinel()
  {
    Output output;
    output.resize(2);
    output[1].template_id = 42;
    return output;
  }

  /** There are no settings. */
  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    return {};
  }

  static std::string
  parameters(const Class& object)
  {
    return "threads " + std::to_string(object.getNumberOfThreads());
  }

  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_planes;
  }

  static std::string
  header()
  {
    std::ifstream file(ACMAP_SOURCE_DIR
                       "/modules/segmentation/include/pcl/segmentation/box_fitting.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
