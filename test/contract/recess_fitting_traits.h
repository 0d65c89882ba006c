#pragma once

#include "box_fitting_traits.h"

#include <pcl/segmentation/recess_fitting.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace pcl::acmap::test {

struct RecessFittingTraits {
  using Class = RecessFitting;

  struct Output : std::vector<RecessPatch> {
    bool
    operator==(const Output& other) const
    {
      return std::equal(begin(), end(), other.begin(), other.end(), areSame);
    }

    static bool
    areSame(const RecessPatch& a, const RecessPatch& b)
    {
      return a.center == b.center && a.axes == b.axes && a.size == b.size &&
             a.wall == b.wall && a.leaf == b.leaf &&
             a.reaches_floor == b.reaches_floor && a.covariance == b.covariance &&
             a.template_id == b.template_id && a.saved_bits == b.saved_bits;
    }
  };

  /** A niche in a wall above a floor, of the size of the largest plane of a cloud; none
   * if the cloud has no plane. Points that are not finite are planes that are not. */
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
      const Eigen::Vector3d right = edge * Eigen::Vector3d::UnitX(),
                            up = -edge * Eigen::Vector3d::UnitY(),
                            back = edge * Eigen::Vector3d::UnitZ();
      const auto square = [&](const Eigen::Vector3d& center,
                              const Eigen::Vector3d& edge_u,
                              const Eigen::Vector3d& edge_v) {
        return BoxFittingTraits::square(largest, center, edge_u, edge_v);
      };
      PlanePatch wall = square({0, 0, 0}, 3 * right, 3 * up);
      const PlanePatch opening = square({0, 0, 0}, up, right);
      wall.polygons[0].holes.push_back(opening.polygons[0].outer);
      planes.push_back(wall);
      planes.push_back(square({0, 0, 0.1}, right, up));
      planes.push_back(square(-1.5 * up - 3 * back, 3 * right, 6 * back));
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
    object.segment(static_cast<std::vector<RecessPatch>&>(output));
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
    std::ifstream file(
        ACMAP_SOURCE_DIR
        "/modules/segmentation/include/pcl/segmentation/recess_fitting.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
