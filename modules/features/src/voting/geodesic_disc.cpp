#include "voting/geodesic_disc.h"

#include <utility>

namespace pcl::acmap::voting {

// Uses waves of relaxation instead of a heap: a disc is only a few edges wide, so that
// hardly any vertex is reached again by a shorter path.
void
GeodesicDisc::fill(std::int32_t middle, float radius)
{
  ++round_;
  vertices_.assign(1, middle);
  marks_[static_cast<std::size_t>(middle)] = {0.0f, round_};
  wave_.assign(1, middle);
  while (!wave_.empty()) {
    next_wave_.clear();
    for (const std::int32_t vertex : wave_) {
      const float so_far = distance(vertex);
      for (const Spoke& spoke : rings_.spokes(vertex)) {
        Mark& mark = marks_[static_cast<std::size_t>(spoke.vertex)];
        const float length = so_far + spoke.length;
        if (length > radius || (mark.round == round_ && length >= mark.distance))
          continue;
        if (mark.round != round_)
          vertices_.push_back(spoke.vertex);
        mark = {length, round_};
        next_wave_.push_back(spoke.vertex);
      }
    }
    std::swap(wave_, next_wave_);
  }
}

} // namespace pcl::acmap::voting
