#include "plane_finders.h"

#include "pcl_planes.h"
#include "statistics.h"
#ifdef ACMAP_HAVE_CGAL
#include "cgal_planes.h"
#endif

namespace pcl::acmap::bench {

std::vector<NamedFinder>
peers()
{
  constexpr std::size_t one_view = 400000;
  constexpr std::size_t million = 1000000;
  std::vector<NamedFinder> all{
      {"PCL SAC, iterated", sacPlanes, false, million},
      {"PCL region growing", pclRegionPlanes, false, one_view, true},
  };
#ifdef ACMAP_HAVE_CGAL_REGIONS
  all.push_back({"CGAL region growing", cgalRegionPlanes, false, million, true});
#endif
#ifdef ACMAP_HAVE_CGAL
  all.push_back({"CGAL efficient RANSAC", cgalRansacPlanes, false, million});
#endif
  return all;
}

FoundPlanes
findPlanes(const NamedFinder& finder, const PlaneInput& input)
{
  constexpr double fast = 1; // seconds
  constexpr int more_rounds = 2;
  FoundPlanes found = finder.find(input);
  if (found.seconds > fast)
    return found;
  std::vector<double> seconds{found.seconds};
  for (int round = 0; round < more_rounds; ++round)
    seconds.push_back(finder.find(input).seconds);
  found.seconds = median(seconds);
  return found;
}

} // namespace pcl::acmap::bench
