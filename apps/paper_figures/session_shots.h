#pragma once

#include "active_stereo/stereo_shots.h"

#include <pcl/core/trinocular_rig.h>

#include <memory>
#include <string>

namespace pcl {
class TrinocularFileGrabber;
}

namespace pcl::acmap {

/** \brief Random access to the observations of a session. */
class SessionShots {
public:
  /** \param[in] threads 0 = all
   * \throws InputFileException as pcl::TrinocularFileGrabber */
  SessionShots(const std::string& session, unsigned threads);
  ~SessionShots();

  /** \brief Rig of the rectified frames. */
  const TrinocularRig&
  rig() const;

  /** \brief The shots of an observation, rectified.
   * \throws InputFileException for a frame that cannot be read, or if there is none */
  ObservationShots
  of(std::size_t observation) const;

private:
  std::string session_;
  std::unique_ptr<TrinocularFileGrabber> grabber_;
  std::unique_ptr<FrameRectifier> rectifier_;
};

/** \brief The shot under a pattern, or the one without a pattern.
 * \throws InputFileException when the observation has none */
const TrinocularFrame&
shotUnder(const ObservationShots& shots, std::int32_t pattern);

} // namespace pcl::acmap
