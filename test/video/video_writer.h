#pragma once

#include <pcl/core/image_file.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Writes the images of one camera as a video at 30 images per second: FFV1 in
 * Matroska, which is lossless, or raw bytes, blue first, for GStreamer. */
class VideoFile {
public:
  /** \param[in] path ends with .mkv or .raw */
  VideoFile(const std::string& path, int width, int height);
  ~VideoFile();

  void
  write(const CameraImage& image);

private:
  struct State;
  std::unique_ptr<State> state_;
};

/** \brief A simulated pair of cameras in front of a wall, with a projector. */
struct FilmedPair {
  TrinocularRig rig;
  std::vector<RgbImage> patterns;

  /** \brief The shots of an observation: without a pattern, then under each. */
  std::vector<TrinocularFrame::Ptr> shots;

  /** \brief The same shots with other noise. */
  std::vector<TrinocularFrame::Ptr> others;
};

/** \brief Films with three patterns. */
FilmedPair
filmPair();

/** \brief What the cameras see while a projector shows one pattern after another, seven
 * images for each: two of the light before, one mixed, two that are settled, and then
 * those that are compared and taken. Begins with a warm-up of ten images.
 * \param[in] ending of the files
 * \return paths of the videos of reference and neighbour */
std::vector<std::string>
writeVideos(const FilmedPair& pair,
            const std::string& folder,
            const std::string& ending);

} // namespace pcl::acmap::test
