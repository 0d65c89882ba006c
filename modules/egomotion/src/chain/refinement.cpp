#include "chain/refinement.h"

#include "chain/appearance_term.h"
#include "chain/motion_step.h"
#include "chain/surface_term.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

/** \brief All information on a motion, by kind. */
struct AllEvidence {
  Evidence features, appearance;
  SurfaceTerm surfaces;

  /** \brief Weights of the kinds. Errors of adjacent pixels are correlated; features
   * and brightness that fit worse than expected get a lower weight. This does not apply
   * to surfaces: if their noise had to be estimated, it is that of the flattest ones.
   */
  struct Trust {
    double features, surfaces, appearance;
  };

  Trust
  trust() const
  {
    constexpr double surface_share = 0.8, appearance_share = 0.01;
    return {
        1 / features.excess(), surface_share, appearance_share / appearance.excess()};
  }

  NormalEquations
  equations() const
  {
    const Trust factor = trust();
    NormalEquations all;
    all.add(features.equations, factor.features);
    all.add(surfaces.evidence.equations, factor.surfaces);
    all.add(appearance.equations, factor.appearance);
    return all;
  }

  /** \brief Scatter of the gradient between tiles and between kinds.
   * \param[in] freedoms number of parameters of the motion: the gradients sum up to
   * zero for each */
  Matrix6
  scatter(double freedoms) const
  {
    const Trust factor = trust();
    Matrix6 of_tiles = Matrix6::Zero();
    for (std::size_t tile = 0; tile < tile_count; ++tile) {
      const Vector6 gradient = factor.features * features.gradients[tile] +
                               factor.surfaces * surfaces.evidence.gradients[tile] +
                               factor.appearance * appearance.gradients[tile];
      of_tiles += gradient * gradient.transpose();
    }
    constexpr double kinds = 3;
    Matrix6 of_kinds = Matrix6::Zero();
    for (const Vector6& gradient :
         {Vector6(factor.features * features.equations.gradient),
          Vector6(factor.surfaces * surfaces.evidence.equations.gradient),
          Vector6(factor.appearance * appearance.equations.gradient)})
      of_kinds += gradient * gradient.transpose();
    return tile_count / (tile_count - freedoms) * of_tiles +
           kinds / (kinds - 1) * of_kinds;
  }
};

/** \brief Two views and the data that are compared. */
struct ViewPair {
  const EgomotionView& source;
  const EgomotionView& target;
  const std::vector<FeaturePair>& features;
  MotionModel model;

  std::size_t
  levels() const
  {
    return std::min(source.appearance.size(), target.appearance.size());
  }

  LightChange
  light(const Eigen::Isometry3d& T_target_source, std::size_t level) const
  {
    if (level >= levels())
      return {};
    return lightChange(source.appearance[level],
                       target.appearance[level],
                       *target.pinhole,
                       T_target_source);
  }

  AllEvidence
  evidence(const Eigen::Isometry3d& T_target_source,
           std::size_t level,
           double reach,
           const LightChange& light) const
  {
    AllEvidence all;
    all.features = featureTerm(features, T_target_source, &*target.pinhole);
    all.surfaces = surfaceTerm(
        source.surfaces, target.surfaces, *target.pinhole, T_target_source, reach);
    if (level < levels())
      all.appearance = appearanceTerm(source.appearance[level],
                                      target.appearance[level],
                                      *target.pinhole,
                                      T_target_source,
                                      light);
    return all;
  }
};

constexpr std::size_t passes = 3;   // at an eighth, a quarter, a half of the size
constexpr double fine_reach = 0.05; // reach of the last pass, metres

Eigen::Isometry3d
descended(const ViewPair& pair,
          Eigen::Isometry3d T_target_source,
          std::size_t level,
          double reach)
{
  constexpr int max_iterations = 5;
  constexpr double min_step = 5e-5; // metres, radians
  const LightChange light = pair.light(T_target_source, level);
  for (int i = 0; i < max_iterations; ++i) {
    const Vector6 step = solvedStep(
        pair.evidence(T_target_source, level, reach, light).equations(), pair.model);
    T_target_source = afterStep(step, T_target_source);
    if (step.norm() < min_step)
      break;
  }
  return T_target_source;
}

/** \brief Returns true if the surfaces are not farther apart than before, and at least
 * half of the pairs remain. */
bool
isNearer(const SurfaceTerm& after, const SurfaceTerm& before)
{
  return 2 * after.evidence.count >= before.evidence.count &&
         (before.evidence.count == 0 || after.distance() <= before.distance());
}

/** \brief Compares mean costs, with the weights of the kinds after the refinement. */
bool
fitsBetter(const AllEvidence& after, const AllEvidence& before)
{
  const AllEvidence::Trust factor = after.trust();
  const auto gain = [](const Evidence& a, const Evidence& b) {
    return (b.meanCost() - a.meanCost()) * static_cast<double>(a.count);
  };
  return factor.features * gain(after.features, before.features) +
             factor.surfaces * gain(after.surfaces.evidence, before.surfaces.evidence) +
             factor.appearance * gain(after.appearance, before.appearance) >
         0;
}

} // namespace

RefinedMotion
refinedMotion(const EgomotionView& source,
              const EgomotionView& target,
              const std::vector<FeaturePair>& features,
              const Eigen::Isometry3d& T_target_source,
              MotionModel model,
              bool refines)
{
  const ViewPair pair{source, target, features, model};
  RefinedMotion refined;
  refined.T_target_source = T_target_source;
  const Evidence alone = featureTerm(features, T_target_source);
  refined.equations.add(alone.equations, 1 / alone.excess());
  if (!refines || !target.pinhole)
    return refined;

  Eigen::Isometry3d candidate = T_target_source;
  for (std::size_t level = passes; level-- > 0;)
    candidate = descended(
        pair, candidate, level, fine_reach * static_cast<double>(1U << level));

  // Uses the widest reach, so that pairs beyond a narrow one after a bad start count.
  constexpr double reach = fine_reach * (1U << (passes - 1));
  const LightChange light = pair.light(candidate, 0);
  const AllEvidence before = pair.evidence(T_target_source, 0, reach, light);
  const AllEvidence after = pair.evidence(candidate, 0, reach, light);
  refined.surface_pairs = after.surfaces.evidence.count;
  refined.surface_before = before.surfaces.distance();
  refined.surface_after = after.surfaces.distance();
  refined.is_refined =
      isNearer(after.surfaces, before.surfaces) && fitsBetter(after, before);
  if (refined.is_refined) {
    refined.T_target_source = candidate;
    refined.equations = after.equations();
    refined.scatter = after.scatter(model == MotionModel::Planar ? 3 : 6);
  }
  return refined;
}

} // namespace pcl::acmap
