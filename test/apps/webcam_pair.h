#pragma once

#include "filmed_by_camera.h"
#include "temporary_folder.h"

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace pcl::acmap::test {

/** \brief Two simulated webcams that film 30 images per second while they are read:
 * each writes its images into a pipe, which GStreamer reads as a camera. A camera that
 * is not read stops with some images in its buffers, as a driver does. */
class WebcamPair {
public:
  /** \param[in] film what the cameras see; the third camera of its rig is left out */
  explicit WebcamPair(FilmedByCamera& film);
  ~WebcamPair();

  WebcamPair(const WebcamPair&) = delete;
  WebcamPair&
  operator=(const WebcamPair&) = delete;

  /** \brief Pipelines of the reference camera and of its neighbour. */
  const std::vector<std::string>&
  devices() const
  {
    return devices_;
  }

  /** \brief From an image on, the neighbour is unplugged.
   * \param[in] image from 0 */
  void
  unplugAt(int image)
  {
    unplugged_at_ = image;
  }

  /** \brief From an image on, the cameras move. */
  void
  moveFrom(int image)
  {
    moves_from_ = image;
  }

private:
  struct Pipe {
    std::string path;
    int file = -1;
  };

  void
  film();

  void
  write(Pipe& pipe, const std::vector<std::uint8_t>& image) const;

  std::vector<std::uint8_t>
  imageOf(std::size_t camera, const std::vector<std::uint8_t>& bytes, int number) const;

  FilmedByCamera& film_;
  TemporaryFolder folder_;
  std::vector<Pipe> pipes_;
  std::vector<std::string> devices_;
  std::atomic<int> unplugged_at_{1000000000};
  std::atomic<int> moves_from_{1000000000};
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

/** \brief Records the session of a film without its third camera. */
void
recordPair(const FilmedByCamera& film, const std::string& session);

/** \brief Does GStreamer have what the cameras need? */
bool
canPipe();

} // namespace pcl::acmap::test
