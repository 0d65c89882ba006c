#pragma once

#include "variant.h"

#include <pcl/core/scratch_memory.h>

#include <cstdint>
#include <utility>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Union-find over the seeds of the front that also stores whether two
 * components have the same orientation (parity 0) or one of them has to be flipped
 * (parity 1). */
class ParityUnion {
public:
  struct Root {
    std::int32_t component;
    bool flipped;
  };

  ParityUnion() = default;

  /** \brief Creates components, each in a set of its own. */
  explicit ParityUnion(std::int32_t components)
  {
    while (size() < components)
      addComponent();
  }

  std::int32_t
  addComponent()
  {
    const auto component = static_cast<std::int32_t>(parent_.size());
    parent_.push_back({component, false});
    return component;
  }

  std::int32_t
  size() const
  {
    return static_cast<std::int32_t>(parent_.size());
  }

  Root
  find(std::int32_t component)
  {
    std::int32_t root = component;
    bool flipped = false;
    while (at(root).component != root) {
      flipped ^= at(root).flipped;
      root = at(root).component;
    }
    const Root result{root, flipped};
    while (component != root) { // path compression
      const Root step = at(component);
      at(component) = {root, flipped};
      flipped ^= step.flipped;
      component = step.component;
    }
    return result;
  }

  /** \brief As unite (), but returns false if they are already joined with another
   * parity. */
  bool
  uniteIfConsistent(std::int32_t a, std::int32_t b, bool flipped)
  {
    if (unite(a, b, flipped))
      return true;
    return (find(a).flipped != find(b).flipped) == flipped;
  }

  /** \brief Joins two components; the lower root is kept.
   * \return false if they were joined before, with any parity */
  bool
  unite(std::int32_t a, std::int32_t b, bool flipped)
  {
    Root root_a = find(a), root_b = find(b);
    if (root_a.component == root_b.component)
      return false;
    if (root_b.component < root_a.component)
      std::swap(root_a, root_b);
    const bool turned = (root_a.flipped != root_b.flipped) != flipped;
    at(root_b.component) = {root_a.component, turned};
    return true;
  }

private:
  Root&
  at(std::int32_t component)
  {
    return parent_[static_cast<std::size_t>(component)];
  }

  LargeVector<Root> parent_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
