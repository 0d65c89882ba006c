#pragma once

#include "contract.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/surface/dewall_triangulation.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace pcl::acmap::test {

struct NormalVectorVotingTraits : CommonTraits<NormalVectorVoting<PointXYZ>> {
  static constexpr const char* header =
      "features/include/pcl/features/normal_vector_voting.h";

  struct Output : PointCloud<Normal> {
    /** Compares bytes, as normals may be NaN; ignores padding after the curvature. */
    bool
    operator==(const Output& other) const
    {
      return size() == other.size() &&
             std::equal(
                 begin(), end(), other.begin(), [](const auto& a, const auto& b) {
                   return std::memcmp(a.data_n, b.data_n, sizeof a.data_n) == 0 &&
                          std::memcmp(&a.curvature, &b.curvature, sizeof a.curvature) ==
                              0;
                 });
    }
  };

  /** Also sets the mesh that the class needs, from DeWall; it is empty for degenerate
   * clouds. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    DeWallTriangulation<PointXYZ> dewall;
    dewall.setInputCloud(cloud.makeShared());
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    object.setInputCloud(cloud.makeShared());
    object.setTriangles(mesh);
  }

  static void
  run(Class& object, Output& output)
  {
    object.compute(static_cast<PointCloud<Normal>&>(output));
  }

  /** A vertex without triangles has no normal. */
  static bool
  isEmpty(const Output& output)
  {
    return std::none_of(output.begin(), output.end(), [](const Normal& normal) {
      return normal.getNormalVector3fMap().allFinite();
    });
  }

  static Output
  sentinel()
  {
    Output output;
    output.resize(2);
    output[1].getNormalVector3fMap() = Eigen::Vector3f(41, 42, 43);
    return output;
  }

  static Calls
  refusedCalls()
  {
    Calls calls;
    refuse(calls, &Class::setRadiusSearch, nonsense, {"[0,", " m"});
    refuse(calls, &Class::setCreaseWeight, nonsense, {"crease weight", "[1e-06,"});
    refuse(calls, &Class::setCornerWeight, nonsense, {"corner weight", "[1e-06,"});
    calls.push_back(
        {[](Class& object) {
           object.setViewpoints({{0, std::numeric_limits<float>::quiet_NaN(), 0}});
         },
         {"nan", "[-1e+09,", " m"}});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "radius " << object.getRadiusSearch() << ", weights "
          << object.getCreaseWeight() << " and " << object.getCornerWeight()
          << ", viewpoints " << object.getViewpoints().size() << ", curvatures "
          << object.getComputeCurvatures() << ", paper " << object.getPaperMode()
          << ", threads " << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
