#include "room_map.h"
#include "virtual_display.h"

#include <pcl/visualization/pcl_visualizer.h>
#include <pcl/visualization/visualizer_layers.h>

#include <gtest/gtest.h>
#include <vtkRendererCollection.h>

namespace pcl::acmap::test {
namespace {

TEST(Visualizer, TakesLayers)
{
  const VirtualDisplay& display = VirtualDisplay::shared();
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  visualization::PCLVisualizer viewer("layers", false);
  vtkRenderer& renderer = *viewer.getRendererCollection()->GetFirstRenderer();
  const int before = renderer.VisibleActorCount();
  const CompactMap map = makeRoomMap();
  addPlaneLayer(viewer, map);
  addTextureLayer(viewer, map, true);
  vtkProp* const way = addTrajectoryLayer(viewer, makeRoomWay());
  EXPECT_EQ(renderer.VisibleActorCount(), before + 3);
  way->SetVisibility(0);
  EXPECT_EQ(renderer.VisibleActorCount(), before + 2);
}

} // namespace
} // namespace pcl::acmap::test
