#pragma once

#include "filmed_by_camera.h"
#include "temporary_folder.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <mutex>
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

  /** \brief The neighbour is unplugged.
   * \param[in] image the first one that it does not give */
  void
  unplugAt(int image)
  {
    unplugged_at_ = image;
  }

  /** \brief The cameras move.
   * \param[in] image the first exposure at which they do */
  void
  moveFrom(int image)
  {
    moves_from_ = image;
  }

private:
  /** \brief The pipe of a camera, and the newest image that is not yet in it. */
  struct Pipe {
    std::string path;
    int file = -1;
    std::vector<std::uint8_t> next; // empty if there is none
    std::thread thread;
  };

  void
  film();

  void
  feed(Pipe& pipe);

  void
  write(const Pipe& pipe, const std::vector<std::uint8_t>& image) const;

  std::vector<std::uint8_t>
  imageOf(std::size_t camera, const std::vector<std::uint8_t>& bytes, int number) const;

  FilmedByCamera& film_;
  TemporaryFolder folder_;
  std::array<Pipe, 2> pipes_;
  std::mutex mutex_; // protects the images of the pipes
  std::condition_variable changed_;
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
