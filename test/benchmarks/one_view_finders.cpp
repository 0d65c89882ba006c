#include "one_view_finders.h"

#include "acmap_planes.h"

namespace pcl::acmap::bench {

FoundPlanes
ourPlanes(const OneView& view)
{
  return findAcmapPlanes(view.finite);
}

std::vector<OneViewFinder>
oneViewFinders()
{
  std::vector<OneViewFinder> all{{"acmap", ourPlanes},
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
