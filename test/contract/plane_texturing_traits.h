#pragma once

#include "plane_hypothesis_clustering_traits.h"

#include <pcl/texture/plane_texturing.h>

namespace pcl::acmap::test {

struct PlaneTexturingTraits {
  using Class = PlaneTexturing<PointXYZRGB>;

  struct Output : CompactMap {
    bool
    operator==(const Output& other) const
    {
      return std::equal(planes.begin(),
                        planes.end(),
                        other.planes.begin(),
                        other.planes.end(),
                        PlaneHypothesisClusteringTraits::Output::areSame) &&
             std::equal(charts.begin(),
                        charts.end(),
                        other.charts.begin(),
                        other.charts.end(),
                        areSame) &&
             observations == other.observations;
    }

    static bool
    areSame(const TextureChart& a, const TextureChart& b)
    {
      return a.plane == b.plane && a.polygon == b.polygon && a.origin == b.origin &&
             a.texel_u == b.texel_u && a.texel_v == b.texel_v &&
             a.colors.values == b.colors.values && a.kinds == b.kinds;
    }
  };

  /** Also sets the planes from another class; degenerate clouds have none. */
  static void
  setInput(Class& object, const Cloud& cloud)
  {
    PlaneHypothesisClustering<PointXYZ> clustering;
    PlaneHypothesisClusteringTraits::setInput(clustering, cloud);
    std::vector<PlanePatch> planes;
    clustering.segment(planes);
    object.setPlanes(planes);
    const PointCloud<PointXYZRGB>::Ptr colored(new PointCloud<PointXYZRGB>);
    for (const PointXYZ& p : cloud)
      colored->push_back(PointXYZRGB(
          p.x, p.y, p.z, static_cast<std::uint8_t>(colored->size() % 251), 100, 200));
    object.clearObservations();
    object.addObservation(colored);
  }

  static void
  run(Class& object, Output& output)
  {
    object.texture(output);
  }

  static bool
  isEmpty(const Output& output)
  {
    return output.charts.empty();
  }

  static Output
  sentinel()
  {
    Output output;
    output.planes.resize(2);
    output.observations = {{42}, {43}};
    return output;
  }

  static std::vector<RefusedCall<Class>>
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<RefusedCall<Class>> calls;
    for (const auto& [value, word] : {std::pair(-0.5, "-0.5"),
                                      std::pair(0.0, "0"),
                                      std::pair(nan, "nan"),
                                      std::pair(infinity, "inf")}) {
      calls.push_back({[value = value](Class& object) { object.setTexelSize(value); },
                       {"texel size", word, "[0.0001,", " m"}});
      calls.push_back(
          {[value = value](Class& object) { object.setMaximumDistance(value); },
           {"distance", word, "[1e-06,", " m"}});
    }
    for (const auto& [value, word] : {std::pair(-1, "-1"), std::pair(70000, "70000")}) {
      calls.push_back(
          {[value = value](Class& object) { object.setMaximumTextureSize(value); },
           {"texture size", word, "[16, 65500]", "texels"}});
      calls.push_back(
          {[value = value](Class& object) { object.setFillDistance(value); },
           {"fill distance", word, "[0, 1000]", "texels"}});
    }
    return calls;
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << "texel " << object.getTexelSize() << ", distance "
          << object.getMaximumDistance() << ", size " << object.getMaximumTextureSize()
          << ", fill " << object.getFillDistance() << ", paper "
          << object.getPaperMode() << ", exposure " << object.getCorrectExposure()
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
                       "/modules/texture/include/pcl/texture/plane_texturing.h");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

} // namespace pcl::acmap::test
