// What a camera sees of a corner of a room: a floor and two walls, as an organized cloud.
// Usage: make_view VIEW.pcd
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <random>

int
main(int argc, char** argv)
{
  constexpr int width = 320, height = 240;
  constexpr float focal = 260;                        // pixels
  constexpr float front = 3, right = 1.2F, floor = 1; // metres
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 0.001F); // metres
  pcl::PointCloud<pcl::PointXYZ> view(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const float x = (static_cast<float>(column) - width / 2.0F + 0.5F) / focal;
      const float y = (static_cast<float>(row) - height / 2.0F + 0.5F) / focal;
      float z = front;
      if (x > 0)
        z = std::min(z, right / x);
      if (y > 0)
        z = std::min(z, floor / y);
      z += noise(random);
      view(column, row) = pcl::PointXYZ(x * z, y * z, z);
    }
  return argc == 2 && pcl::io::savePCDFileBinary(argv[1], view) == 0 ? 0 : 1;
}
