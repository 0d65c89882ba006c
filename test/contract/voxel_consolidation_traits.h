#pragma once

#include "contract.h"

#include <pcl/common/io.h>
#include <pcl/filters/voxel_consolidation.h>

#include <cstring>

namespace pcl::acmap::test {

struct VoxelConsolidationTraits : CommonTraits<VoxelConsolidation<PointNormal>> {
  static constexpr const char* header =
      "filters/include/pcl/filters/voxel_consolidation.h";

  struct Output : PointCloud<PointNormal> {
    /** Compares bytes, as normals may be NaN. */
    bool
    operator==(const Output& other) const
    {
      return size() == other.size() &&
             std::equal(
                 begin(), end(), other.begin(), [](const auto& a, const auto& b) {
                   return std::memcmp(a.data, b.data, sizeof a.data) == 0 &&
                          std::memcmp(a.normal, b.normal, sizeof a.normal) == 0 &&
                          a.curvature == b.curvature;
                 });
    }
  };

  static void
  setInput(Class& object, const Cloud& cloud)
  {
    const PointCloud<PointNormal>::Ptr input(new PointCloud<PointNormal>);
    copyPointCloud(cloud, *input);
    object.setInputCloud(input);
  }

  static void
  run(Class& object, Output& output)
  {
    object.filter(static_cast<PointCloud<PointNormal>&>(output));
  }

  static Output
  sentinel()
  {
    Output output;
    output.resize(2);
    output[1].getVector3fMap() = Eigen::Vector3f(41, 42, 43);
    return output;
  }

  static Calls
  refusedCalls()
  {
    Calls calls{
        {[](Class& object) {
           object.setViewpoints({{0, std::numeric_limits<float>::quiet_NaN(), 0}});
         },
         {"nan", "[-1e+09,", " m"}}};
    refuse(calls, &Class::setVoxelSize, nonsense, {"[0,", " m"});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "voxel " << object.getVoxelSize() << ", viewpoints "
          << object.getViewpoints().size() << ", sources " << object.getKeepSources()
          << ", threads " << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
