#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/mapping/map_verdict_types.h>
#include <pcl/pipeline/plane_sightings.h>
#include <pcl/pipeline/unseen_surfaces.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief May one measure in a map? \ingroup pipeline */
enum class MapQualityOutcome {
  Good,        ///< measure in it
  Usable,      ///< right where it was seen well; a figure is not good
  NotUsable,   ///< something in it is wrong
  Undetermined ///< its own evidence is not enough to tell
};

namespace acmap {

/** \brief The names of \ref MapQualityOutcome in files, in Python and as headings. */
inline constexpr std::array<const char*, 4> map_quality_names{
    "Good", "Usable", "Not usable", "Undetermined"};

} // namespace acmap

/** \brief One of the four figures by which a map is judged. \ingroup pipeline */
struct QualityFigure {
  double value = std::numeric_limits<double>::quiet_NaN(); ///< NaN: not known
  double good = 0;    ///< from here on a map can be good
  double bad = 0;     ///< from here on it is not good enough; see \ref MapQualityReport
  std::string advice; ///< what to do, one sentence

  bool
  isGood() const
  {
    return good < bad ? value <= good : value >= good;
  }

  bool
  isBad() const
  {
    return good < bad ? value >= bad : value <= bad;
  }
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const QualityFigure& figure, Visitor&& visit)
{
  visit({"value"}, figure.value);
  visit({"good"}, figure.good);
  visit({"bad"}, figure.bad);
  visit({"advice"}, figure.advice);
}

/** \brief Report of \ref assessMapQuality. \ingroup pipeline */
struct MapQualityReport : Report {
  MapQualityOutcome outcome = MapQualityOutcome::Undetermined;
  std::string sentence; ///< why, in one sentence
  /** \brief On the poses; nothing without a rectification. */
  std::optional<VerdictOutcome> verdict;
  /** \brief Metres, without noise: how far apart several observations see the same place of floors,
   * ceilings and walls (standard deviation); of one observation how uneven these are. */
  QualityFigure sharpness;
  QualityFigure
      coverage;       ///< share of floor, ceiling and walls of the rooms that was seen
  QualityFigure rays; ///< share of the rays that pass through no surface of the map
  /** \brief Share of what an observation saw that the others saw, too, of the one that is joined
   * worst. */
  QualityFigure overlap;
  std::size_t observations = 0;
  std::size_t weakest_observation = 0; ///< index of the one with the least overlap
  /** \brief Metres, of each plane: how far what observations saw of its parts is from it, without
   * noise; NaN: not known. */
  std::vector<double> roughness;
  double seen_area = 0, unseen_area = 0; ///< square metres of floor, ceiling and walls
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MapQualityReport& report, Visitor&& visit)
{
  visit({"outcome"}, acmap::Named{report.outcome, acmap::map_quality_names});
  visit({"sentence"}, report.sentence);
  visit({"verdict"},
        report.verdict
            ? std::optional(acmap::Named{*report.verdict, acmap::verdict_outcome_names})
            : std::nullopt);
  visit({"sharpness", "m"}, report.sharpness);
  visit({"coverage"}, report.coverage);
  visit({"rays"}, report.rays);
  visit({"overlap"}, report.overlap);
  visit({"observations"}, report.observations);
  visit({"weakest_observation"}, report.weakest_observation);
  visit({"roughness", "m"}, report.roughness);
  visit({"seen_area", "m^2"}, report.seen_area);
  visit({"unseen_area", "m^2"}, report.unseen_area);
}

/** \brief Judges a map by its own evidence: four figures, and the verdict on its poses.
 *
 * The documentation page of this header has the thresholds.
 * \param[in] map with roles of its planes (\ref nameSurfaces)
 * \param[in] sightings of the planes of this map
 * \param[in] unseen of this map
 * \param[in] verdict on its poses; nothing if none was asked \ingroup pipeline */
ACMAP_EXPORT MapQualityReport
assessMapQuality(const CompactMap& map,
                 const PlaneSightings& sightings,
                 const UnseenSurfaces& unseen,
                 const std::optional<VerdictOutcome>& verdict);

/** \brief "Good: planes are sharp to 4 mm, ...", for a line of a summary. \ingroup pipeline */
ACMAP_EXPORT std::string
describeQuality(const MapQualityReport& report);

} // namespace pcl
