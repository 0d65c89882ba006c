#pragma once

#include "contract.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/segmentation/plane_hypothesis_clustering.h>
#include <pcl/surface/dewall_triangulation.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace pcl::acmap::test {

struct PlaneHypothesisClusteringTraits {
  using Class = PlaneHypothesisClustering<PointXYZ>;

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
    output[1].support = 42;
    return output;
  }

  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<RefusedCall<Class>> calls;
    for (const auto& [value, word] :
         {std::pair(-0.5, "-0.5"), std::pair(nan, "nan"), std::pair(infinity, "inf")}) {
      calls.push_back(
          {[value = value](Class& object) { object.setClusterTolerance(value); },
           {"W_d", word, "[1e-09,", " m"}});
      calls.push_back(
          {[value = value](Class& object) { object.setSmoothnessThreshold(value); },
           {"W_n", word, "[1e-06,", " rad"}});
      calls.push_back(
          {[value = value](Class& object) { object.setDistanceThreshold(value); },
           {"W_t", word, "[1e-09,", " m"}});
      calls.push_back({[value = value](Class& object) { object.setMinArea(value); },
                       {"area", word, "[0,", " m^2"}});
    }
    calls.push_back({[](Class& object) {
                       const Cloud::ConstPtr source(new Cloud);
                       object.setSourceCloud(source, {{0, static_cast<float>(nan), 0}});
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
          << ' ' << object.getDistanceThreshold() << ' ' << object.getMinClusterSize()
          << ", area " << object.getMinArea() << ", regular " << object.getRegularize()
          << ", threads " << object.getNumberOfThreads();
    return words.str();
  }

  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points;
  }

  static std::string
  header()
  {
    std::ifstream file(
        ACMAP_SOURCE_DIR
        "/modules/segmentation/include/pcl/segmentation/plane_hypothesis_clustering.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
