#pragma once

#include "contract.h"

#include <pcl/mapping/map_entropy.h>

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace pcl::acmap::test {

struct MapEntropyTraits {
  using Class = MapEntropy<PointNormal>;

  struct Output {
    MapEntropyTerms terms;
    std::vector<Eigen::Vector3d> gradient;

    /** Compares bytes. */
    bool
    operator==(const Output& other) const
    {
      const auto bytes = [](const MapEntropyTerms& terms) {
        return std::array<double, 4>{
            terms.total, terms.joint, terms.along_x, terms.along_z};
      };
      const auto a = bytes(terms), b = bytes(other.terms);
      return std::memcmp(a.data(), b.data(), sizeof a) == 0 &&
             terms.points == other.terms.points &&
             terms.dimensions == other.terms.dimensions && gradient == other.gradient;
    }
  };

  /** Adds the same cloud twice, because one observation alone always causes a
   * remark. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    PointCloud<PointNormal>::Ptr input(new PointCloud<PointNormal>);
    for (const PointXYZ& place : cloud) {
      input->push_back(PointNormal());
      input->back().getVector3fMap() = place.getVector3fMap();
    }
    object.clear();
    object.addPointCloud(input);
    object.addPointCloud(input);
  }

  static void
  run(Class& object, Output& output)
  {
    output.terms = object.computeGradient(output.gradient);
  }

  /** Points at one position or on one line have entropies, but do not determine a
   * pose. */
  static bool
  isEmpty(const Output& output)
  {
    return output.terms.dimensions < 2;
  }

  static Output
  sentinel()
  {
    Output output;
    output.terms.total = 42;
    output.gradient.assign(7, Eigen::Vector3d::Zero());
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
      calls.push_back({[value = value](Class& object) { object.setBinSize(value); },
                       {"bin size", word, "[0.001, 100]", " m"}});
      calls.push_back({[value = value](Class& object) { object.setSmoothing(value); },
                       {"sigma_XZ", word, "[0, 1000]", " m"}});
      calls.push_back(
          {[value = value](Class& object) { object.setProjectionWeight(value); },
           {"mu", word, "[0, 1000]", "no unit"}});
    }
    for (int axis = 0; axis < 3; ++axis)
      calls.push_back(
          {[axis](Class& object) {
             PlanarPose pose;
             (axis == 0   ? pose.x
              : axis == 1 ? pose.z
                          : pose.theta) = std::numeric_limits<double>::quiet_NaN();
             object.addPointCloud(std::make_shared<PointCloud<PointNormal>>(), pose);
           },
           {axis < 2 ? "of the pose" : "theta", "nan", axis < 2 ? " m" : "rad"}});
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "bin " << object.getBinSize() << ", sigma " << object.getSmoothing()
          << ", mu " << object.getProjectionWeight() << ", directions "
          << object.getDirectionAware() << ", threads " << object.getNumberOfThreads();
    return words.str();
  }

  /** Each cloud was added twice. */
  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points / 2;
  }

  static std::string
  header()
  {
    std::ifstream file(ACMAP_SOURCE_DIR
                       "/modules/mapping/include/pcl/mapping/map_entropy.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
