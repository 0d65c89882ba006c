#pragma once

#include "contract.h"

#include <pcl/features/normal_vector_voting.h>
#include <pcl/surface/dewall_triangulation.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace pcl::acmap::test {

struct NormalVectorVotingTraits {
  using Class = NormalVectorVoting<PointXYZ>;

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

  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<RefusedCall<Class>> calls;
    for (const auto& [value, word] :
         {std::pair(-0.5, "-0.5"), std::pair(nan, "nan"), std::pair(infinity, "inf")}) {
      calls.push_back(
          {[value = value](Class& object) { object.setRadiusSearch(value); },
           {word, "[0,", " m"}});
      calls.push_back(
          {[value = value](Class& object) { object.setCreaseWeight(value); },
           {"crease weight", word, "[1e-06,"}});
      calls.push_back(
          {[value = value](Class& object) { object.setCornerWeight(value); },
           {"corner weight", word, "[1e-06,"}});
    }
    calls.push_back({[](Class& object) {
                       object.setViewpoints({{0, static_cast<float>(nan), 0}});
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

  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points;
  }

  static std::string
  header()
  {
    std::ifstream file(ACMAP_SOURCE_DIR
                       "/modules/features/include/pcl/features/normal_vector_voting.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
