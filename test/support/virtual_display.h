#pragma once

#include <sys/types.h>

#include <atomic>
#include <string>
#include <thread>

namespace pcl::acmap::test {

/** \brief An X server for tests that draw: the one of the environment, else a virtual
 * one with the lifetime of this object. Sets DISPLAY. */
class VirtualDisplay {
public:
  VirtualDisplay();

  /** \brief Always a virtual one.
   * \param[in] screen width, height and depth, as 1280x960x24 */
  explicit VirtualDisplay(const std::string& screen);

  /** \brief One that all tests of a program share until it ends. */
  static const VirtualDisplay&
  shared();

  ~VirtualDisplay();

  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay&
  operator=(const VirtualDisplay&) = delete;

  /** \brief Returns false if there is no X server, so that drawing cannot be tested. */
  bool
  exists() const
  {
    return exists_;
  }

  /** \brief Ends the virtual server even if clients are connected. */
  void
  stop();

private:
  void
  start(const std::string& screen);

  bool exists_ = false;
  pid_t server_ = -1;
  std::string display_before_;
};

/** \brief Ends the server of a display once a file exists, or with its own lifetime. */
class StopAtFile {
public:
  StopAtFile(VirtualDisplay& display, const std::string& path);

  ~StopAtFile();

private:
  std::atomic<bool> is_over_ = false;
  std::thread thread_; // uses all other members
};

} // namespace pcl::acmap::test
