#pragma once

#include "contract.h"

#include <pcl/filters/voxel_consolidation.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace pcl::acmap::test {

struct VoxelConsolidationTraits {
  using Class = VoxelConsolidation<PointNormal>;

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
    PointCloud<PointNormal>::Ptr input(new PointCloud<PointNormal>);
    for (const PointXYZ& place : cloud) {
      input->push_back(PointNormal());
      input->back().getVector3fMap() = place.getVector3fMap();
    }
    input->is_dense = cloud.is_dense;
    object.setInputCloud(input);
  }

  static void
  run(Class& object, Output& output)
  {
    object.filter(static_cast<PointCloud<PointNormal>&>(output));
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
    output[1].getVector3fMap() = Eigen::Vector3f(41, 42, 43);
    return output;
  }

  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto size = [](double value) {
      return [value](Class& object) { object.setVoxelSize(value); };
    };
    const auto viewpoint = [](double value) {
      return [value](Class& object) {
        object.setViewpoints({{0, static_cast<float>(value), 0}});
      };
    };
    return {{size(-0.5), {"-0.5", "[0,", " m"}},
            {size(nan), {"nan", "[0,", " m"}},
            {size(std::numeric_limits<double>::infinity()), {"inf", "[0,", " m"}},
            {viewpoint(nan), {"nan", "[-1e+09,", " m"}}};
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

  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points;
  }

  static std::string
  header()
  {
    std::ifstream file(ACMAP_SOURCE_DIR
                       "/modules/filters/include/pcl/filters/voxel_consolidation.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
