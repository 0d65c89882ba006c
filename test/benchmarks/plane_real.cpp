#include "plane_tables.h"

#include "annotated_clouds.h"
#include "markdown_row.h"
#include "segment_scores.h"

#include <iostream>

namespace pcl::acmap::bench {
namespace {

void
printCloud(const AnnotatedCloud& cloud, const SegmentScores& scores)
{
  std::cout << "\n"
            << cloud.name << ": " << cloud.labels.size() << " points; " << scores.truths
            << " marked planes, " << scores.large << " with 0.3 % of the points, rms "
            << 1000 * cloud.median_rms << " (median) to " << 1000 * cloud.largest_rms
            << " mm; measured sigma " << 1000 * cloud.input.sigma << " mm, spacing "
            << 1000 * cloud.input.spacing << " mm; tolerance of the peers "
            << 1000 * cloud.input.tolerance << " mm\n";
}

void
printSegmentsHead()
{
  printHead({"finder",
             "planes given",
             "correct",
             "of them with 0.3 %",
             "over-segmented",
             "under-segmented",
             "missed",
             "noise",
             "marked points right %",
             "CPU s"});
}

void
printSegments(const std::string& finder, const SegmentScores& scores, double seconds)
{
  MarkdownRow()
      .text(finder)
      .count(scores.given)
      .count(scores.correct)
      .count(scores.correct_large)
      .count(scores.over)
      .count(scores.under)
      .count(scores.missed)
      .count(scores.noise)
      .number(scores.labels, 1)
      .number(seconds, 3)
      .print();
}

SegmentScores
scoreCloud(const AnnotatedCloud& cloud, const FoundPlanes& found)
{
  return scoreSegments(
      PlaneOverlaps(cloud.labels, cloud.planes, found.labels, found.planes.size()),
      largeCount(cloud.labels.size()));
}

} // namespace

void
printRealPlanes(const NamedFinders& finders)
{
  std::cout << "\n### Annotated real clouds\n";
  forEachAnnotatedCloud([&](const AnnotatedCloud& cloud) {
    FoundPlanes none;
    none.labels.assign(cloud.labels.size(), -1);
    printCloud(cloud, scoreCloud(cloud, none));
    printSegmentsHead();
    for (const NamedFinder& finder : finders) {
      const FoundPlanes found = findPlanes(finder, cloud.input);
      printSegments(finder.name, scoreCloud(cloud, found), found.seconds);
    }
  });
}

} // namespace pcl::acmap::bench
