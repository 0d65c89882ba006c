#pragma once

#include "contract.h"

#include <pcl/surface/dewall_triangulation.h>

namespace pcl::acmap::test {

struct DeWallTraits : CommonTraits<DeWallTriangulation<PointXYZ>> {
  static constexpr const char* header =
      "surface/include/pcl/surface/dewall_triangulation.h";

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

  static Calls
  refusedCalls()
  {
    Calls calls{
        {[](Class& object) { object.setAcceptanceRule(static_cast<DeWallRule>(9)); },
         {"9", "Paper", "Dense", "Strict"}},
        {[](Class& object) { object.setLeafSize(-1); }, {"-1", "[0,", "points"}}};
    refuse(calls, &Class::setMaximumEdgeLength, nonsense, {"[0,", " m"});
    return calls;
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
};

} // namespace pcl::acmap::test
