#include "rectification_steps.h"

#include <cmath>

namespace pcl::acmap {

std::vector<PlanarPose>
turnedMap(const std::vector<PlanarPose>& poses, double turn)
{
  std::vector<PlanarPose> turned;
  for (const PlanarPose& pose : poses)
    turned.push_back(moved({0, 0, turn}, {pose.x, pose.z, pose.theta}));
  return turned;
}

double
buildingDirection(const std::vector<EntropyCells>& observations,
                  const std::vector<PlanarPose>& poses,
                  const MapEntropySettings& settings)
{
  MapEntropyEvaluator evaluator(observations, settings);
  double best = 0;
  double minimum = INFINITY;
  const auto look = [&](double turn) {
    MapEntropyReport ignored;
    const MapEntropyTerms terms = evaluator.evaluate(turnedMap(poses, turn), ignored);
    if (terms.points && terms.along_x + terms.along_z < minimum) {
      minimum = terms.along_x + terms.along_z;
      best = turn;
    }
  };
  constexpr double degree = M_PI / 180;
  for (int i = 0; i < 45; ++i)
    look(2 * i * degree);
  for (double step = degree; step > 0.04 * degree; step /= 2) {
    const double middle = best;
    look(middle - step);
    look(middle + step);
  }
  return best - M_PI / 2 * std::floor(best / (M_PI / 2));
}

} // namespace pcl::acmap
