#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Is a trajectory better than the odometry, by an independent estimate?
 * \ingroup mapping */
enum class VerdictOutcome {
  Consistent, ///< it is better than the given one, or as good, beyond reasonable doubt
  Undetermined, ///< nothing proves that it is better
  Contradicted  ///< it is worse than the given one, or parts of it cannot be true
};

namespace acmap {

/** \brief The names of \ref VerdictOutcome in files and in Python. */
inline constexpr std::array<const char*, 3> verdict_outcome_names{
    "consistent", "undetermined", "contradicted"};

} // namespace acmap

/** \brief Errors of the odometry, as scans of neighbouring places show them, in units of
 * what was assumed (\ref OdometryNoise). \ingroup mapping */
struct MeasuredOdometry {
  struct Component {
    std::size_t steps = 0; ///< that show it
    double scale = 1;      ///< standard deviation, robust; 1 if too few steps show it
    double bias = 0;       ///< the same in each step
  };

  Component across, ahead, turn; ///< x, z, theta
  std::size_t steps = 0;         ///< of the trajectory
  std::size_t slips = 0;         ///< steps in which the wheels slipped
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MeasuredOdometry::Component& component, Visitor&& visit)
{
  visit({"steps"}, component.steps);
  visit({"scale"}, component.scale);
  visit({"bias"}, component.bias);
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MeasuredOdometry& odometry, Visitor&& visit)
{
  visit({"across"}, odometry.across);
  visit({"ahead"}, odometry.ahead);
  visit({"turn"}, odometry.turn);
  visit({"steps"}, odometry.steps);
  visit({"slips"}, odometry.slips);
}

/** \brief A part of a trajectory that the estimate contradicts. \ingroup mapping */
struct ContradictedWindow {
  std::size_t first = 0, last = 0; ///< observations
  double sigmas = 0;               ///< of the relative pose of both
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const ContradictedWindow& window, Visitor&& visit)
{
  visit({"first"}, window.first);
  visit({"last"}, window.last);
  visit({"sigmas"}, window.sigmas);
}

/** \brief Report of \ref MapVerdict. \ingroup mapping */
struct MapVerdictReport : Report {
  std::size_t observations = 0;
  std::size_t invalid_points = 0; ///< that are not finite and were skipped
  VerdictOutcome outcome = VerdictOutcome::Undetermined;
  /** \brief That the error is larger than that of the given trajectory. */
  double probability_worse = 0.5;
  /** \brief The same without revisits. */
  double probability_worse_without_revisits = 0.5;
  /** \brief Metres, 95 %: absolute error of the trajectory, rms after alignment. */
  double e95 = 0;
  /** \brief Metres, 95 %, of the given trajectory. */
  double e95_given = 0;
  /** \brief Verdict on the given trajectory, without comparison. */
  VerdictOutcome given = VerdictOutcome::Undetermined;
  std::vector<std::string> reasons;        ///< sentences
  std::vector<ContradictedWindow> windows; ///< the worst ones
  MeasuredOdometry odometry;
  std::size_t revisits = 0, ambiguous_revisits = 0;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MapVerdictReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"invalid_points"}, report.invalid_points);
  visit({"outcome"}, acmap::Named{report.outcome, acmap::verdict_outcome_names});
  visit({"probability_worse"}, report.probability_worse);
  visit({"probability_worse_without_revisits"},
        report.probability_worse_without_revisits);
  visit({"e95", "m"}, report.e95);
  visit({"e95_given", "m"}, report.e95_given);
  visit({"given"}, acmap::Named{report.given, acmap::verdict_outcome_names});
  visit({"reasons"}, report.reasons);
  visit({"windows"}, report.windows);
  visit({"odometry"}, report.odometry);
  visit({"revisits"}, report.revisits);
  visit({"ambiguous_revisits"}, report.ambiguous_revisits);
}

} // namespace pcl
