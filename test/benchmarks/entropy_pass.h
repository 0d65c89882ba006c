#pragma once

#include "entropy_maps.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief The minimum work of any entropy of points: transforms each point by its pose
 * and computes its bin, from arrays of floats, eight at once if the processor supports
 * it. */
class EntropyPass {
public:
  EntropyPass(const EntropyMap& map, double bin_size);

  /** \brief Computes all bins.
   * \return a value that depends on all bins, so that nothing is optimized away */
  std::int64_t
  find();

  /** \brief Computes all bins and counts their points: the plain histogram. */
  std::int64_t
  count();

private:
  struct Observation {
    std::vector<float> x, z; ///< in bins
    PlanarPose pose;
  };

  template <typename Visit>
  void
  forEachChunk(const Visit& visit);

  std::vector<Observation> observations_;
  float x0_, z0_; ///< first bin
  std::int32_t row_;
  double bin_size_;
  std::vector<std::uint32_t> counts_;
};

} // namespace pcl::acmap::bench
