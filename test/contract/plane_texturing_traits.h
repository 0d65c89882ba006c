#pragma once

#include "plane_hypothesis_clustering_traits.h"

#include <pcl/texture/plane_texturing.h>

namespace pcl::acmap::test {

struct PlaneTexturingTraits : CommonTraits<PlaneTexturing<PointXYZRGB>> {
  static constexpr const char* header = "texture/include/pcl/texture/plane_texturing.h";

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

  static Calls
  refusedCalls()
  {
    Calls calls;
    refuse(calls, &Class::setTexelSize, nonsense, {"texel size", "[0.0001,", " m"});
    std::vector<double> values = nonsense;
    values.push_back(0);
    refuse(calls, &Class::setMaximumDistance, values, {"distance", "[1e-06,", " m"});
    const std::vector<int> counts{-1, 70000};
    refuse(calls,
           &Class::setMaximumTextureSize,
           counts,
           {"texture size", "[16, 65500]", "texels"});
    refuse(calls,
           &Class::setFillDistance,
           std::vector<int>{-2, 70000},
           {"fill distance", "[-1, 1000]", "texels"});
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
};

} // namespace pcl::acmap::test
