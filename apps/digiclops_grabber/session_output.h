#pragma once

#include "device.h"

#include <pcl/acquisition/trinocular_recorder.h>

#include <cstdint>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief The raw session of a run; it is removed if no frame was received. */
class SessionOutput {
public:
  /** \throws OutputFileException as \ref TrinocularRecorder */
  SessionOutput(const std::string& folder, const Device& device);
  ~SessionOutput();

  SessionOutput(const SessionOutput&) = delete;
  SessionOutput&
  operator=(const SessionOutput&) = delete;

  TrinocularRecorder&
  recorder()
  {
    return *recorder_;
  }

  const TrinocularRecorder&
  recorder() const
  {
    return *recorder_;
  }

private:
  std::string folder_;
  bool is_new_;
  std::optional<TrinocularRecorder> recorder_;
};

} // namespace pcl::acmap
