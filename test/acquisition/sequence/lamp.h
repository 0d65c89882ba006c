#pragma once

#include "light_clock.h"

#include <pcl/acquisition/pattern_projector.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pcl::acmap::test {

/** \brief A projector for patterns that consist of one grey level each. */
class Lamp : public PatternProjector {
public:
  explicit Lamp(std::shared_ptr<LightClock> light);

  /** \brief Called with each level before it is shown; may throw. */
  std::function<void(int level)> before = [](int) {};

  double power = 1;

  void
  show(const RgbImage& image) override;

  void
  showNothing() override;

  /** \brief Levels in the order in which they were shown; 0 is black. */
  std::vector<int>
  shown() const;

private:
  void
  cast(int level);

  const std::shared_ptr<LightClock> light_;
  mutable std::mutex mutex_;
  std::vector<int> shown_;
};

RgbImage
flatImage(int level);

/** \brief Patterns 0, 1, ... with levels 40, 80, ... */
std::vector<RgbImage>
levelPatterns(int count);

} // namespace pcl::acmap::test
