#include "egomotion_methods.h"

#include <pcl/egomotion/visual_egomotion.h>

#include <memory>

namespace pcl::acmap::bench {

EgomotionMethod
oursMethod(bool refines)
{
  const auto egomotion = std::make_shared<VisualEgomotion<PointXYZRGBSigma>>();
  egomotion->setNumberOfThreads(1);
  egomotion->setRefinement(refines);
  return {refines ? "acmap" : "acmap, features alone",
          [egomotion](const EgomotionSequence& sequence,
                      std::size_t source,
                      std::size_t target) -> std::optional<Eigen::Isometry3d> {
            egomotion->setMotionModel(sequence.is_planar ? MotionModel::Planar
                                                         : MotionModel::Rigid);
            egomotion->setInputSource(sequence.clouds[source]);
            egomotion->setInputTarget(sequence.clouds[target]);
            const auto estimate = egomotion->compute();
            if (!estimate)
              return std::nullopt;
            return estimate->T_target_source;
          }};
}

} // namespace pcl::acmap::bench
