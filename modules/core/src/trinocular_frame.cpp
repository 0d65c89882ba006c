#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>

#include <utility>

namespace pcl {

CameraImage
loadCameraImage(const std::string& path)
{
  RgbImage image = loadRgbImage(path);
  return {image.width, image.height, 3, std::move(image.values)};
}

} // namespace pcl
