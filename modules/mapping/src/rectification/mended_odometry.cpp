#include "mended_odometry.h"

#include "../odometry_sigmas.h"

#include <pcl/core/impl/size_text.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

double
factorOf(const MeasuredOdometry::Component& one)
{
  return std::hypot(one.scale, one.bias);
}

/** A power of two, since rounding of the residuals must not change the energy. */
double
scaleOf(double factor)
{
  return std::exp2(std::round(std::log2(std::max(1.0, factor))));
}

std::vector<PlanarPose>
withoutBias(const MeasuredOdometry& measured,
            const std::vector<PlanarPose>& given,
            const OdometryNoise& noise)
{
  std::vector<PlanarPose> mended{given.front()};
  for (std::size_t t = 1; t < given.size(); ++t) {
    PlanarAction action = actionBetween(given[t - 1], given[t]);
    const double length = lengthSigma(noise, std::hypot(action.dx, action.dz));
    const double angle = turnSigma(noise, std::abs(action.dtheta));
    action.dx -= measured.across.bias * length;
    action.dz -= measured.ahead.bias * length;
    action.dtheta -= measured.turn.bias * angle;
    mended.push_back(moved(mended.back(), action));
  }
  return mended;
}

} // namespace

OdometryNoise
scaled(OdometryNoise noise, double lengths, double turns)
{
  noise.length *= lengths;
  noise.length_per_metre *= lengths;
  noise.turn *= turns;
  noise.turn_per_radian *= turns;
  return noise;
}

std::vector<PlanarPose>
mendedOdometry(const MeasuredOdometry& measured,
               const std::vector<PlanarPose>& given,
               OdometryNoise& noise,
               EntropyRectificationReport& report)
{
  constexpr double usual = 2.5; // factors: what any search permits,
  constexpr double most = 10;   // and what none of them finds back from
  const double largest = std::max(
      {factorOf(measured.across), factorOf(measured.ahead), factorOf(measured.turn)});
  if (largest <= usual)
    return given;
  if (largest > most) {
    report.outcome = RectificationOutcome::Refused;
    report.reason =
        "neighbouring scans contradict the given poses: from one to the next they "
        "err by " +
        shortNumber(largest) +
        " times what odometry is assumed to; their unit or their convention may be "
        "another one";
    return given;
  }
  const std::vector<PlanarPose> mended = withoutBias(measured, given, noise);
  const double lengths = scaleOf(std::max(measured.across.scale, measured.ahead.scale));
  const double turns = scaleOf(measured.turn.scale);
  noise = scaled(noise, lengths, turns);
  report.remarks.push_back(
      "the odometry errs more than is assumed, as neighbouring scans show: " +
      shortNumber(lengths) + " times as much in lengths and " + shortNumber(turns) +
      " times in turns, and by " + shortNumber(measured.turn.bias) +
      " standard deviations in each turn; this was taken (--odometry-noise states "
      "another)");
  return mended;
}

} // namespace pcl::acmap
