#include "consolidation_tables.h"

#include "markdown_row.h"
#include "noise_clouds.h"
#include "noise_truth.h"

#include <pcl/core/noise_scale.h>

#include <iomanip>
#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double noise_reach = 15; // percent

double
deviation(double measured, double truth)
{
  return 100 * (measured / truth - 1);
}

/** A measured cloud of the corridor. */
struct MeasuredNoise {
  std::string name;
  NoiseScale scale;
  NoiseTruth truth;
};

MeasuredNoise
measure(const SimulatedCloud& cloud, double visible_area)
{
  return {cloud.name,
          measureNoiseScale(cloud.points(), cloud.sensors(), 1),
          measureTruth(cloud, visible_area)};
}

std::vector<MeasuredNoise>
measureCorridor(SceneData& corridor)
{
  std::vector<MeasuredNoise> all;
  for (const std::size_t view : {0, 40, 53})
    all.push_back(measure(makeViewCloud(corridor.scene(), view),
                          corridor.truthOfView(view).visibleArea()));
  const double area = corridor.wholeTruth().visibleArea();
  for (const std::size_t size : {100000, 1000000})
    all.push_back(measure(makeRandomPart(corridor.whole(), size, size), area));
  all.push_back(measure(corridor.whole(), area));
  return all;
}

void
printScales(const std::vector<MeasuredNoise>& all)
{
  printHead({"cloud",
             "sigma, true mm",
             "measured",
             "off by %",
             "spacing, true mm",
             "measured",
             "off by %",
             "confidence"});
  for (const MeasuredNoise& one : all)
    MarkdownRow()
        .text(one.name)
        .number(1000 * one.truth.sigma, 2)
        .number(1000 * one.scale.sigma, 2)
        .within(deviation(one.scale.sigma, one.truth.sigma), noise_reach, 1)
        .number(1000 * one.truth.spacing, 1)
        .number(1000 * one.scale.spacing, 1)
        .within(deviation(one.scale.spacing, one.truth.spacing), noise_reach, 1)
        .number(one.scale.confidence, 2)
        .print();
}

void
printRanges(const std::vector<MeasuredNoise>& all)
{
  printHead({"cloud", "distance, m", "along the ray, true mm", "measured", "off by %"});
  for (const MeasuredNoise& one : all)
    for (const NoiseScale::Range& range : one.scale.ranges) {
      const double truth = one.truth.ranges.at(rangeBin(range.distance));
      MarkdownRow()
          .text(one.name)
          .number(range.distance, 2)
          .number(1000 * truth, 2)
          .number(1000 * range.sigma, 2)
          .within(deviation(range.sigma, truth), noise_reach, 1)
          .print();
    }
}

std::size_t
countFinite(const PointView& points)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    count += points[i].allFinite();
  return count;
}

std::string
textOf(const std::vector<NoiseScale::Range>& ranges)
{
  std::ostringstream text;
  text << std::setprecision(2);
  for (const NoiseScale::Range& range : ranges)
    text << (text.tellp() > 0 ? ", " : "") << 1000 * range.sigma << " at "
         << range.distance << " m";
  return text.str();
}

std::string
verdictOf(const NoiseCloud& cloud, const NoiseScale& scale)
{
  std::string verdict;
  if (cloud.is_exact)
    verdict = scale.hasNoise() ? "**noise** (missed: none)" : "no noise (a model)";
  for (const std::string& remark : scale.remarks)
    verdict += (verdict.empty() ? "" : "; ") + remark;
  return verdict;
}

void
printReal()
{
  printHead({"real cloud",
             "points",
             "sigma, mm",
             "spacing, mm",
             "where sparse, mm",
             "confidence",
             "along the ray, mm",
             "remarks"});
  forEachNoiseCloud([](const NoiseCloud& cloud) {
    const PointView points = cloud.file.points();
    const SensorView sensors =
        cloud.is_view ? SensorView(cloud.file.sensor_origin) : SensorView();
    const NoiseScale scale = measureNoiseScale(points, sensors, 1);
    MarkdownRow()
        .text(cloud.name)
        .count(countFinite(points))
        .number(1000 * scale.sigma, 3)
        .number(1000 * scale.spacing, 2)
        .number(1000 * scale.sparse_spacing, 2)
        .number(scale.confidence, 2)
        .text(textOf(scale.ranges))
        .text(verdictOf(cloud, scale))
        .print();
  });
}

} // namespace

void
printNoise(SceneData& corridor)
{
  std::cout << "\n### Noise and spacing\n";
  const std::vector<MeasuredNoise> all = measureCorridor(corridor);
  printScales(all);
  printRanges(all);
  printReal();
}

} // namespace pcl::acmap::bench
