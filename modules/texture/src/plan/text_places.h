#pragma once

#include "plan/plan_drawing.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief The part of a drawing that texts, and what they must not hide, take. */
class TextPlaces {
public:
  /** \param[in] quad convex, metres */
  void
  block(const std::array<Eigen::Vector2d, 4>& quad);

  /** \brief Are all lines of a text free of what was blocked before? */
  bool
  areFree(const std::vector<PlanText>& lines, double scale) const;

  /** \brief Blocks the place of a text. */
  void
  take(const PlanText& text, double scale);

private:
  struct Taken {
    std::array<Eigen::Vector2d, 4> quad;
    Eigen::AlignedBox2d box;
  };

  std::vector<Taken> taken_;
};

/** \brief The rectangle around a text with a small margin, metres. */
std::array<Eigen::Vector2d, 4>
quadOf(const PlanText& text, double scale);

} // namespace pcl::acmap
