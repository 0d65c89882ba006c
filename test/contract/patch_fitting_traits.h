#pragma once

#include "plane_hypothesis_clustering_traits.h"

#include <fstream>
#include <iterator>

namespace pcl::acmap::test {

/** \brief What the traits of the classes that fit patches to planes have in common. Traits
 * tells areSame (patch, patch), and planesLike (largest): the planes of a scene that has one
 * patch, of the size of a plane. */
template <typename Traits, typename Fitting, typename Patch>
struct PatchFittingTraits : CommonTraits<Fitting> {
  using typename CommonTraits<Fitting>::Calls;
  using typename CommonTraits<Fitting>::Class;

  struct Output : std::vector<Patch> {
    bool
    operator==(const Output& other) const
    {
      return std::equal(
          this->begin(), this->end(), other.begin(), other.end(), Traits::areSame);
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
      polygon.outer.push_back(
          (center + u * edge_u + v * edge_v).template cast<float>());
    patch.polygons = {polygon};
    return patch;
  }

  /** The scene of the largest plane of a cloud; none if the cloud has no plane. Points that
   * are not finite are planes that are not. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    PlaneHypothesisClustering<PointXYZ> clustering;
    PlaneHypothesisClusteringTraits::setInput(clustering, cloud);
    std::vector<PlanePatch> found, planes;
    clustering.segment(found);
    if (!found.empty())
      planes = Traits::planesLike(found.front());
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
    object.segment(static_cast<std::vector<Patch>&>(output));
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
};

} // namespace pcl::acmap::test
