#include <pcl/acquisition/frame_file.h>
#include <pcl/core/random.h>

#include <exception>
#include <filesystem>
#include <iostream>

namespace {

/** Image values that are noise within a spread: 0 packs well, 256 does not. */
pcl::CameraImage
imageOf(std::int32_t channels, std::uint64_t spread)
{
  pcl::acmap::Random random(spread);
  pcl::CameraImage image{8, 6, channels, {}};
  for (std::int32_t i = 0; i < 48 * channels; ++i)
    image.values.push_back(
        static_cast<std::uint8_t>(spread > 0 ? random.bits() % spread : 90));
  return image;
}

} // namespace

int
main(int argc, char** argv)
try {
  if (argc != 2) {
    std::cerr << "usage: write_frame_seeds FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (const std::uint64_t spread : {0U, 8U, 256U}) {
    pcl::TrinocularFrame frame;
    frame.number = spread;
    frame.images = {imageOf(1, spread), imageOf(3, spread), imageOf(1, spread)};
    saveTrinocularFrame((folder / ("three_" + std::to_string(spread))).string(), frame);
    frame.images[2] = {};
    saveTrinocularFrame((folder / ("two_" + std::to_string(spread))).string(), frame);
  }
  return 0;
}
catch (const std::exception& exception) {
  std::cerr << exception.what() << "\n";
  return 1;
}
