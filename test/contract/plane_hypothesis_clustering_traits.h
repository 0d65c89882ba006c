#pragma once

#include "contract.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/surface/dewall_triangulation.h>

#include <cstring>
#include <utility>

namespace pcl::acmap::test {

struct PlaneHypothesisClusteringTraits
: CommonTraits<PlaneHypothesisClustering<PointXYZ>> {
  static constexpr const char* header =
      "segmentation/include/pcl/segmentation/plane_hypothesis_clustering.h";

  struct Output : std::vector<PlanePatch> {
    /** Compares bytes, as covariances may be NaN. */
    bool
    operator==(const Output& other) const
    {
      return std::equal(begin(), end(), other.begin(), other.end(), areSame);
    }

    static bool
    areSame(const PlanePatch& a, const PlanePatch& b)
    {
      return std::memcmp(&a.coefficients, &b.coefficients, sizeof a.coefficients) ==
                 0 &&
             std::memcmp(&a.covariance, &b.covariance, sizeof a.covariance) == 0 &&
             a.center == b.center && a.axis_u == b.axis_u && a.axis_v == b.axis_v &&
             a.support == b.support && a.rms == b.rms && a.area == b.area &&
             std::equal(a.polygons.begin(),
                        a.polygons.end(),
                        b.polygons.begin(),
                        b.polygons.end(),
                        [](const PlanePolygon& x, const PlanePolygon& y) {
                          return x.outer == y.outer && x.holes == y.holes;
                        });
    }
  };

  /** Also sets normals and mesh from other classes; degenerate clouds have none. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    DeWallTriangulation<PointXYZ> dewall;
    dewall.setInputCloud(cloud.makeShared());
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    NormalVectorVoting<PointXYZ> voting;
    voting.setInputCloud(cloud.makeShared());
    voting.setTriangles(mesh);
    const auto normals = std::make_shared<PointCloud<Normal>>();
    voting.compute(*normals);
    object.setInputCloud(cloud.makeShared());
    object.setInputNormals(normals);
    object.setTriangles(mesh);
  }

  static void
  run(Class& object, Output& output)
  {
    object.segment(static_cast<std::vector<PlanePatch>&>(output));
  }

  static Output
  sentinel()
  {
    Output output;
    output.resize(2);
    output[1].support = 42;
    return output;
  }

  static Calls
  refusedCalls()
  {
    Calls calls;
    refuse(calls, &Class::setClusterTolerance, nonsense, {"W_d", "[1e-09,", " m"});
    refuse(calls, &Class::setSmoothnessThreshold, nonsense, {"W_n", "[1e-06,", " rad"});
    refuse(calls, &Class::setDistanceThreshold, nonsense, {"W_t", "[1e-09,", " m"});
    refuse(calls, &Class::setMinArea, nonsense, {"area", "[0,", " m^2"});
    calls.push_back({[](Class& object) {
                       const Cloud::ConstPtr source(new Cloud);
                       object.setSourceCloud(
                           source, {{0, std::numeric_limits<float>::quiet_NaN(), 0}});
                     },
                     {"nan", "[-1e+09,", " m"}});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "noise " << object.getNoiseDriven() << ", thresholds "
          << object.getClusterTolerance() << ' ' << object.getSmoothnessThreshold()
          << ' ' << object.getDistanceThreshold().value_or(0) << ' '
          << object.getMinClusterSize() << ", area " << object.getMinArea()
          << ", regular " << object.getRegularize() << ", threads "
          << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
