#include "quality/quality_figures.h"

#include <pcl/pipeline/map_quality.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl {

namespace {

using Figure = QualityFigure;

std::string
printed(const char* format, double value)
{
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string
percent(double share)
{
  return printed("%.0f %%", std::floor(100 * share));
}

std::string
millimetres(double length)
{
  return printed(length < 0.01 ? "%.1f mm" : "%.0f mm", 1000 * length);
}

void
adviseOnSharpness(Figure& figure)
{
  figure.advice =
      std::isnan(figure.value) ? "No plane was seen often enough to tell."
      : figure.isGood()
          ? "Nothing to do."
          : "Move slower, turn by at most 30 degrees between two observations, and "
            "return to the first place; with poses from elsewhere, check their "
            "convention and the scale of the depth.";
}

void
adviseOnCoverage(Figure& figure)
{
  figure.advice =
      std::isnan(figure.value)
          ? "No room was found: record a floor with the walls around it."
      : figure.isGood()
          ? "Nothing to do; what is hatched was not seen."
          : "Look from the proposed positions, and extend the map (--extend).";
}

void
adviseOnRays(Figure& figure)
{
  figure.advice =
      std::isnan(figure.value)
          ? "It is not known from where the points were seen; --sensor-at states it."
      : figure.isGood() ? "Nothing to do."
                        : "Rays pass through surfaces: a place was mapped twice, "
                          "something moved, or a "
                          "mirror or glass was seen. Record again while nothing moves, "
                          "and cover glass.";
}

void
adviseOnOverlap(Figure& figure, std::size_t weakest)
{
  figure.advice = std::isnan(figure.value) ? "One cloud has no overlap to tell."
                  : figure.isGood()
                      ? "Nothing to do."
                      : "Observation " + std::to_string(weakest) +
                            " shows too little of what the others saw: record more "
                            "views between.";
}

/** \brief Do the figures prove that one may measure in the map? */
bool
isProved(const MapQualityReport& report)
{
  return report.sharpness.isGood() && report.coverage.isGood() &&
         report.rays.isGood() && (report.observations < 2 || report.overlap.isGood());
}

MapQualityOutcome
outcomeOf(const MapQualityReport& report)
{
  if (report.verdict == VerdictOutcome::Contradicted || report.sharpness.isBad() ||
      report.rays.isBad())
    return MapQualityOutcome::NotUsable;
  if (isProved(report))
    return MapQualityOutcome::Good;
  if (std::isnan(report.sharpness.value) ||
      (report.observations > 1 && report.overlap.isBad()))
    return MapQualityOutcome::Undetermined;
  return MapQualityOutcome::Usable;
}

/** \brief Joins "a", "b" and "c". */
std::string
enumerated(const std::vector<std::string>& parts)
{
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += (k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ") + parts[k];
  return text;
}

std::string
sentenceOf(const MapQualityReport& report)
{
  const Figure &sharpness = report.sharpness, &coverage = report.coverage,
               &rays = report.rays, &overlap = report.overlap;
  switch (report.outcome) {
  case MapQualityOutcome::Good:
    return (report.observations > 1 ? "observations agree to "
                                    : "surfaces are even to ") +
           millimetres(sharpness.value) + ", " + percent(coverage.value) +
           " of floor, ceiling and walls was seen, and nothing contradicts the map; "
           "lengths are as true as the scale of the sensor.";
  case MapQualityOutcome::NotUsable:
    if (report.verdict == VerdictOutcome::Contradicted)
      return "the observations contradict the poses.";
    if (sharpness.isBad())
      return report.observations > 1
                 ? "observations of the same place are " +
                       millimetres(sharpness.value) + " apart."
                 : "surfaces are " + millimetres(sharpness.value) + " uneven.";
    return percent(1 - rays.value) + " of the rays pass through surfaces of the map.";
  case MapQualityOutcome::Undetermined:
    return report.observations > 1 && overlap.isBad()
               ? "observation " + std::to_string(report.weakest_observation) +
                     " hardly overlaps the others, so nothing proves where it was."
               : "no surface was seen well enough to judge the map.";
  case MapQualityOutcome::Usable:
    break;
  }
  std::vector<std::string> reasons;
  if (!sharpness.isGood())
    reasons.push_back(report.observations > 1
                          ? "observations are " + millimetres(sharpness.value) +
                                " apart"
                          : "surfaces are " + millimetres(sharpness.value) + " uneven");
  if (std::isnan(coverage.value))
    reasons.emplace_back("no room is enclosed");
  else if (!coverage.isGood())
    reasons.push_back("only " + percent(coverage.value) +
                      " of floor, ceiling and walls was seen");
  if (std::isnan(rays.value))
    reasons.emplace_back("its sensors are not known");
  else if (!rays.isGood())
    reasons.push_back(percent(1 - rays.value) + " of the rays pass through surfaces");
  if (overlap.value < overlap.good)
    reasons.push_back("observation " + std::to_string(report.weakest_observation) +
                      " overlaps little");
  return "right where it was seen well, but " + enumerated(reasons) + ".";
}

} // namespace

MapQualityReport
assessMapQuality(const CompactMap& map,
                 const PlaneSightings& sightings,
                 const UnseenSurfaces& unseen,
                 const std::optional<VerdictOutcome>& verdict)
{
  MapQualityReport report;
  report.verdict = verdict;
  report.observations = sightings.observations;
  report.seen_area = unseen.seen_area;
  report.unseen_area = unseen.unseen_area;
  report.roughness = acmap::roughnessOf(sightings);
  // Errors of poses that bend a building by 2 cm part neighbouring observations by 1.5 mm; walls that
  // one sensor saw are more uneven than that.
  report.sharpness =
      sightings.observations > 1
          ? Figure{acmap::disagreementOf(map, sightings), 0.0014, 0.02, ""}
          : Figure{acmap::unevennessOf(map, report.roughness), 0.008, 0.03, ""};
  report.coverage = {unseen.seenShare(), 0.6, 0.25, ""};
  report.rays = {acmap::rayAgreement(map, sightings), 0.98, 0.9, ""};
  const acmap::WeakestOverlap weakest = acmap::weakestOverlap(sightings);
  report.overlap = {weakest.share, 0.2, 0.05, ""};
  report.weakest_observation = weakest.observation;
  adviseOnSharpness(report.sharpness);
  adviseOnCoverage(report.coverage);
  adviseOnRays(report.rays);
  adviseOnOverlap(report.overlap, weakest.observation);
  report.outcome = outcomeOf(report);
  report.sentence = sentenceOf(report);
  return report;
}

std::string
describeQuality(const MapQualityReport& report)
{
  return acmap::nameIn(acmap::map_quality_names, report.outcome) +
         (": " + report.sentence);
}

} // namespace pcl
