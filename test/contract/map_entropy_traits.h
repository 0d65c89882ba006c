#pragma once

#include "contract.h"

#include <pcl/common/io.h>
#include <pcl/mapping/map_entropy.h>

#include <array>
#include <cstring>
#include <utility>

namespace pcl::acmap::test {

struct MapEntropyTraits : CommonTraits<MapEntropy<PointNormal>> {
  static constexpr const char* header = "mapping/include/pcl/mapping/map_entropy.h";

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
    const PointCloud<PointNormal>::Ptr input(new PointCloud<PointNormal>);
    copyPointCloud(cloud, *input);
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

  static Calls
  refusedCalls()
  {
    Calls calls;
    refuse(calls, &Class::setBinSize, nonsense, {"bin size", "[0.001, 100]", " m"});
    refuse(calls, &Class::setSmoothing, nonsense, {"sigma_XZ", "[0, 1000]", " m"});
    refuse(
        calls, &Class::setProjectionWeight, nonsense, {"mu", "[0, 1000]", "no unit"});
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
};

} // namespace pcl::acmap::test
