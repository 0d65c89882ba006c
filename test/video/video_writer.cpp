#include "video_writer.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <opencv2/videoio.hpp>

#include <fstream>
#include <stdexcept>

namespace pcl::acmap::test {

struct VideoFile::State {
  cv::VideoWriter writer;
  std::ofstream raw;
};

VideoFile::VideoFile(const std::string& path, int width, int height)
: state_(new State)
{
  constexpr double rate = 30; // Hz
  if (path.find(".raw") != std::string::npos)
    state_->raw.open(path, std::ios::binary);
  else if (!state_->writer.open(path,
                                cv::CAP_FFMPEG,
                                cv::VideoWriter::fourcc('F', 'F', 'V', '1'),
                                rate,
                                cv::Size(width, height)))
    throw std::runtime_error("OpenCV cannot write FFV1");
}

VideoFile::~VideoFile() = default;

void
VideoFile::write(const CameraImage& image)
{
  cv::Mat pixels(image.height, image.width, CV_8UC3);
  for (std::size_t i = 0; i < pixels.total(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      pixels.data[3 * i + c] =
          image.channels == 1 ? image.values[i] : image.values[3 * i + 2 - c];
  if (state_->raw.is_open())
    state_->raw.write(reinterpret_cast<const char*>(pixels.data),
                      static_cast<std::streamsize>(3 * pixels.total()));
  else
    state_->writer.write(pixels);
}

FilmedPair
filmPair()
{
  FilmedPair pair;
  SimulatedScene scene = standardScene("office");
  scene.rig.baseline_vertical = 0;
  scene.views.resize(1);
  pair.rig = scene.rig;
  RandomLinePattern lines;
  for (std::uint32_t i = 0; i < 3; ++i)
    pair.patterns.push_back(lines.generate(i));
  SimulatedRigGrabber grabber(scene, pair.patterns);
  pair.shots = grabber.observe(0);
  grabber.setSeed(2);
  pair.others = grabber.observe(0);
  return pair;
}

namespace {

/** \brief The image of an exposure during which the light changes. */
CameraImage
mixed(const CameraImage& a, const CameraImage& b)
{
  CameraImage image = a;
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<std::uint8_t>((a.values[i] + b.values[i]) / 2);
  return image;
}

} // namespace

std::vector<std::string>
writeVideos(const FilmedPair& pair,
            const std::string& folder,
            const std::string& ending)
{
  std::vector<std::string> paths;
  for (const RigCamera camera : {RigCamera::Reference, RigCamera::Horizontal}) {
    paths.push_back(folder + "/" + nameOf(camera) + ending);
    VideoFile video(paths.back(), pair.rig.width, pair.rig.height);
    const auto shot = [&](std::size_t i) -> const CameraImage& {
      return pair.shots[i]->image(camera);
    };
    const auto other = [&](std::size_t i) -> const CameraImage& {
      return pair.others[i]->image(camera);
    };
    for (int i = 0; i < 10; ++i)
      video.write(i % 2 == 0 ? shot(0) : other(0));
    for (std::size_t i = 0; i < pair.shots.size(); ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1;
      video.write(shot(before));
      video.write(other(before));
      video.write(mixed(shot(before), shot(i)));
      video.write(other(i));
      video.write(shot(i));
      video.write(other(i));
      video.write(shot(i)); // is taken
    }
  }
  return paths;
}

} // namespace pcl::acmap::test
