#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/sensor_evidence.h>
#include <pcl/core/up_evidence.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace pcl {

/** \brief By what the unit of a cloud is known. \ingroup core */
enum class UnitOutcome {
  Stated,  ///< by the caller
  Assumed, ///< metres, and the points do not contradict
  Doubtful ///< metres, though the points look like another unit
};

/** \brief What the colours of a cloud are. \ingroup core */
enum class ColorContent {
  None,  ///< there is no field of them
  Empty, ///< there is one, but all points are black
  One,   ///< all points have the same colour
  Varied
};

namespace acmap {

/** \brief The names of \ref UnitOutcome in files and in Python. */
inline constexpr std::array<const char*, 3> unit_outcome_names{
    "stated", "assumed", "doubtful"};

/** \brief The names of \ref ColorContent in files and in Python. */
inline constexpr std::array<const char*, 4> color_content_names{
    "none", "empty", "one", "varied"};

} // namespace acmap

/** \brief What a cloud is, as far as its points show it (\ref CloudAssessment). Lengths are
 * metres, in the frame of the cloud. \ingroup core */
struct CloudAssessmentReport : Report {
  std::size_t points = 0;
  std::size_t finite_points = 0;
  std::size_t zero_points = 0; ///< at (0, 0, 0), as invalid ones of some programs are
  std::size_t duplicate_points = 0; ///< at the place of an earlier one, zeros left out
  std::size_t columns = 0;          ///< pixels of a row; 0: not organized
  Eigen::Vector3d minimum = Eigen::Vector3d::Zero(); ///< corners of the finite points
  Eigen::Vector3d maximum = Eigen::Vector3d::Zero();

  UpEvidence up;

  struct Unit {
    double value = 1; ///< metres in a unit of the file
    UnitOutcome outcome = UnitOutcome::Assumed;
    std::string evidence;
  };
  Unit unit;

  /** \brief What was subtracted from the coordinates of the file. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  std::string text_columns; ///< how those of a text were understood; empty: no text

  struct Noise {
    bool is_determined = false;
    double value = 0; ///< standard deviation across the surface
    /** \brief 95 % interval of the value; none without noise. */
    std::optional<std::array<double, 2>> interval;
    double confidence = 0;
    std::string evidence; ///< the reason if it is not determined
  };
  std::optional<Noise> noise; ///< if it was measured

  double spacing = 0;     ///< side of the square of surface for each point
  SensorEvidence sensors; ///< not asked of points whose field `view` names observations
  bool names_views = false;

  struct Colors {
    ColorContent content = ColorContent::None;
  };
  Colors colors;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CloudAssessmentReport::Unit& unit, Visitor&& visit)
{
  visit({"value", "m"}, unit.value);
  visit({"outcome"}, acmap::Named{unit.outcome, acmap::unit_outcome_names});
  visit({"evidence"}, unit.evidence);
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CloudAssessmentReport::Noise& noise, Visitor&& visit)
{
  visit({"value", "m"}, noise.value);
  visit({"interval", "m"}, noise.interval);
  visit({"is_determined"}, noise.is_determined);
  visit({"confidence"}, noise.confidence);
  visit({"evidence"}, noise.evidence);
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CloudAssessmentReport::Colors& colors, Visitor&& visit)
{
  visit({"content"}, acmap::Named{colors.content, acmap::color_content_names});
}

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CloudAssessmentReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"finite"}, report.finite_points);
  visit({"zeros"}, report.zero_points);
  visit({"duplicates"}, report.duplicate_points);
  visit({"columns"}, report.columns);
  visit({"minimum", "m"}, report.minimum);
  visit({"maximum", "m"}, report.maximum);
  visit({"up"}, report.up);
  visit({"unit"}, report.unit);
  visit({"shift", "m"}, report.shift);
  visit({"text_columns"}, report.text_columns);
  visit({"noise"}, report.noise);
  visit({"spacing", "m"}, report.spacing);
  visit({"sensors"}, report.sensors);
  visit({"names_views"}, report.names_views);
  visit({"colours"}, report.colors);
}

} // namespace pcl
