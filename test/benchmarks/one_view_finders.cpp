#include "one_view_finders.h"

#include "acmap_planes.h"

#include <pcl/common/point_tests.h>
#include <pcl/segmentation/depth_plane_segmentation.h>

namespace pcl::acmap::bench {

FoundPlanes
ourPlanes(const OneView& view)
{
  std::vector<std::int32_t> labels;
  FoundPlanes found = timedPlanes([&] {
    FoundPlanes planes;
    DepthPlaneSegmentation<PointXYZ> segmentation;
    segmentation.setNumberOfThreads(1);
    segmentation.setInputCloud(view.organized);
    std::vector<PlanePatch> patches;
    segmentation.segment(patches);
    for (const PlanePatch& patch : patches)
      planes.planes.push_back(patch.coefficients);
    labels.assign(segmentation.getLabels().begin(), segmentation.getLabels().end());
    return planes;
  });
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (pcl::isFinite((*view.organized)[i]))
      found.labels.push_back(labels[i]);
  return found;
}

std::vector<OneViewFinder>
oneViewFinders()
{
  std::vector<OneViewFinder> all{
      {"acmap", ourPlanes},
      {"acmap in space",
       [](const OneView& view) { return findAcmapPlanes(view.finite); }},
      {"PCL organized multi-plane", organizedPlanes}};
  for (const NamedFinder& peer : peers())
    all.push_back(
        {peer.name,
         [find = peer.find](const OneView& view) { return find(view.finite); },
         peer.is_slow});
  return all;
}

FoundPlanes
findInView(const OneViewFinder& finder, const OneView& view)
{
  const auto find = [&](const PlaneInput&) { return finder.find(view); };
  return findPlanes({finder.name, find}, view.finite);
}

} // namespace pcl::acmap::bench
