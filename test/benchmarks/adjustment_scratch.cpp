#include <pcl/core/trajectory_error.h>
#include <pcl/core/random.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>
#include "timing.h"
#include <iostream>
#include <cstdlib>
#include <sstream>

using namespace pcl;
using namespace pcl::acmap;

int main(int argc, char** argv)
{
  const std::string name = argc > 1 ? argv[1] : "corridor_survey";
  const double level = argc > 2 ? atof(argv[2]) : 1;
  const double told = argc > 3 ? atof(argv[3]) : 1;
  const int from = argc > 4 ? atoi(argv[4]) : 1, to = argc > 5 ? atoi(argv[5]) : 1;
  const SimulatedScene scene = standardScene(name);
  std::vector<SimulatedObservation> seen;
  for (std::size_t i = 0; i < scene.views.size(); ++i)
    seen.push_back(observe(scene, i, 1));
  const ViewReader read = [&](std::size_t i, const std::function<void(const AdjustedView&)>& use) {
    AdjustedView view;
    view.points = PointView(&seen[i].pixels[0].x, sizeof(ObservationPixel), seen[i].pixels.size());
    view.sigmas = getenv("NOSIGMA") ? nullptr : &seen[i].pixels[0].sigma;
    view.sigma_stride = sizeof(ObservationPixel);
    view.width = static_cast<std::size_t>(seen[i].width);
    use(view);
  };
  const double turn = 0.2 * M_PI / 180;
  for (int seed = from; seed <= to; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<Eigen::Isometry3d> given{scene.views[0]};
    for (std::size_t i = 1; i < scene.views.size(); ++i) {
      Eigen::Isometry3d motion = scene.views[i-1].inverse() * scene.views[i];
      const double length = level * 0.01 * motion.translation().norm();
      Eigen::Vector3d r, t;
      for (int k = 0; k < 3; ++k) { r[k] = level * turn * random.normal(); t[k] = length * random.normal(); }
      if (r.norm() > 0) motion.linear() = motion.linear() * Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix();
      motion.translation() += t;
      Eigen::Isometry3d p = given.back() * motion;
      p.linear() = Eigen::Quaterniond(p.linear()).normalized().toRotationMatrix();
      given.push_back(p);
    }
    PlaneAdjustmentSettings settings;
    const double tl = told * (level > 0 ? level : 1);
    settings.odometry = {1e-4 * tl, 0.01 * tl, turn * tl, 0};
    settings.estimate_odometry = !getenv("FIXED");
    PlaneAdjustmentReport report;
    std::vector<Eigen::Isometry3d> found;
    const auto cost = bench::measureCost([&]{ found = adjustPlanes(read, given, settings, Progress(), report); });
    double height = 0, moved = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      height = std::max(height, std::abs(found[i].translation().y() - scene.views[i].translation().y()));
      moved += (found[i].translation() - given[i].translation()).squaredNorm();
    }
    const double before = absoluteTrajectoryError(given, scene.views).unaligned, after = absoluteTrajectoryError(found, scene.views).unaligned;
    const auto len = [](const auto& p) { return (p.back().translation() - p.front().translation()).norm(); };
    std::cout << name << " x" << level << " told " << told << " seed " << seed << ": " << before << " -> " << after << " ratio " << after / before
              << " height mm " << 1000 * height << " rms move mm " << 1000 * std::sqrt(moved / found.size()) << " outcome " << (int) report.outcome << " cpu " << cost.cpu
              << " len% " << 100 * (len(given) / len(scene.views) - 1) << " -> " << 100 * (len(found) / len(scene.views) - 1)
              << " rays " << report.rays_before.near_share << ' ' << report.rays_before.far_share << " -> " << report.rays_after.near_share << ' ' << report.rays_after.far_share << " sig " << report.significance << " rounds " << report.rounds.size() << " fac " << report.odometry_factors[0] << " " << report.odometry_factors[1] << " thick " << report.thickness_before << " " << report.thickness_after << " unc " << (report.uncertainty.empty() ? 0 : report.uncertainty.back().position);
    if (getenv("TELL")) for (auto& r : report.rounds) std::cout << "\n gate " << r.gate << " floor " << r.floor << " lm " << r.landmarks << " pieces " << r.pieces << " prior " << r.prior << " thick " << r.thickness << " moved " << r.moved;
    for (auto& s : report.seconds) std::cout << ' ' << s.first << ' ' << s.second;
    std::cout << std::endl;
  }
}
