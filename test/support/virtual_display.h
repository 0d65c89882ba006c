#pragma once

#include <sys/types.h>

#include <string>

namespace pcl::acmap::test {

/** \brief An X server for the tests that draw: the one of the environment, else a virtual
 * one that lives as long as the object. Sets DISPLAY. */
class VirtualDisplay {
public:
  VirtualDisplay();
  ~VirtualDisplay();

  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay&
  operator=(const VirtualDisplay&) = delete;

  /** \brief False where no X server could be had, and drawing cannot be tested. */
  bool
  exists() const
  {
    return exists_;
  }

private:
  bool exists_ = false;
  pid_t server_ = -1;
};

} // namespace pcl::acmap::test
