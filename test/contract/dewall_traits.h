#pragma once

#include "contract.h"

#include <pcl/surface/dewall_triangulation.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace pcl::acmap::test {

struct DeWallTraits {
  using Class = DeWallTriangulation<PointXYZ>;

  struct Output : TriangleMesh {
    bool
    operator==(const Output& other) const
    {
      return triangles == other.triangles && wall_depth == other.wall_depth;
    }
  };

  static void
  setInput(Class& object, const Cloud& cloud)
  {
    object.setInputCloud(cloud.makeShared());
  }

  static void
  run(Class& object, Output& output)
  {
    object.reconstruct(static_cast<TriangleMesh&>(output));
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.triangles.empty();
  }

  static Output
  sentinel()
  {
    Output output;
    output.triangles = {{7, 7, 7}};
    output.wall_depth = {42, 43};
    return output;
  }

  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    const auto length = [](double value) {
      return [value](Class& object) { object.setMaximumEdgeLength(value); };
    };
    return {
        {length(-0.5), {"-0.5", "[0,", " m"}},
        {length(std::numeric_limits<double>::quiet_NaN()), {"nan", "[0,", " m"}},
        {length(std::numeric_limits<double>::infinity()), {"inf", "[0,", " m"}},
        {[](Class& object) { object.setAcceptanceRule(static_cast<DeWallRule>(9)); },
         {"9", "Paper", "Dense", "Strict"}},
        {[](Class& object) { object.setLeafSize(-1); }, {"-1", "[0,", "points"}}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "rule " << static_cast<int>(object.getAcceptanceRule()) << ", length "
          << object.getMaximumEdgeLength() << ", depth " << object.getComputeWallDepth()
          << ", threads " << object.getNumberOfThreads() << ", leaf "
          << object.getLeafSize();
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
                       "/modules/surface/include/pcl/surface/dewall_triangulation.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
