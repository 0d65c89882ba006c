// From clouds with poses to a compact map, as pcl_compact_mapping makes it.
#include <pcl/conversions.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/texture/compact_map_folder.h>

#include <iostream>

int
main(int argc, char** argv)
{
  if (argc != 2)
    return std::cerr << "usage: compact_map FOLDER\n", 2;
  try {
    // yours come from a camera or from files: organized, with colours, in the camera's frame
    const pcl::SimulatedScene office = pcl::standardScene("office");
    const pcl::Trajectory trajectory = pcl::trajectoryOf(office, 12);
    pcl::CompactMapping mapping;
    mapping.setRectify(false); // these poses are exact
    for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
      const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
      pcl::fromPCLPointCloud2(pcl::cloudOf(pcl::observe(office, i, 1)), *cloud);
      mapping.addObservation(cloud, trajectory.poses[i]);
    }
    pcl::CompactMap map;
    mapping.compute(map);
    std::cout << mapping.getReport().merging.points << " points, " << map.planes.size()
              << " planes, " << map.charts.size() << " textures\n";
    pcl::saveCompactMap(argv[1], map);
    return map.planes.size() < 3; // floor, ceiling and a wall at least
  }
  catch (const std::exception& error) {
    std::cerr << "compact_map" << error.what() << "\n";
    return 1;
  }
}
