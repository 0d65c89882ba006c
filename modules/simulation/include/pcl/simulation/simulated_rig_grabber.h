#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/image_file.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/streamed_grabber.h>
#include <pcl/simulation/simulated_light.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

namespace acmap {
class RigSimulation;
}

/** \brief Simulates the rig and its projector in a building, as a grabber: a program
 * can use its frames like those of a camera. Section II-A of "Active Stereo Based
 * Compact Mapping".
 *
 * One observation is taken from each view of the scene: a shot with the projector off
 * (\ref TrinocularFrame::no_pattern), then one under each pattern. Each surface point
 * is lit by the ambient light and, unless occluded, by the projector;
 * \ref SimulatedLight contains all parameters of the grey levels. A view is cast once
 * for all its shots. Time stamps are 1/14 s apart, as with the paper's camera.
 *
 * Shots are delivered as fast as they are computed. The seed and the numbers of
 * observations and threads take effect at the first shot; for a stream that has begun,
 * they take effect after \ref rewind. After the last shot, \ref rewind must be called
 * first.
 *
 * The same scene, patterns, light and seed give identical bytes, for any number of
 * threads and any order of observations. Time O(pixels * shots). Memory: the views of
 * one observation, with 24 bytes per pixel and camera, 16 more for unrectified cameras;
 * one shot; and the patterns.
 * \code
 * pcl::SimulatedRigGrabber grabber (pcl::standardScene ("corridor"), patterns);
 * std::function<pcl::TrinocularGrabber::FrameCallback> see =
 *   [] (const pcl::TrinocularFrame::ConstPtr& frame) { use (*frame); };
 * grabber.registerCallback (see);
 * grabber.start ();
 * grabber.wait ();
 * \endcode
 * \ingroup simulation */
class ACMAP_EXPORT SimulatedRigGrabber : public acmap::StreamedGrabber {
public:
  using Ptr = shared_ptr<SimulatedRigGrabber>;
  using ConstPtr = shared_ptr<const SimulatedRigGrabber>;

  /** \brief Simulates the rectified cameras of the scene's rig.
   * \param[in] scene with at least one view
   * \param[in] patterns of the projector's size; may be empty
   * \param[in] light and camera model
   * \throws BadArgumentException for a scene without views, an invalid rig or light, or
   * a pattern of another size */
  SimulatedRigGrabber(const SimulatedScene& scene,
                      const std::vector<RgbImage>& patterns,
                      const SimulatedLight& light = {});

  /** \brief Simulates the unrectified cameras, with distortion and misalignment, as
   * input of rectification. The scene's views are poses of the reference camera.
   * \throws BadArgumentException as above, and for an invalid calibration or one that
   * does not match the number and size of the rig's cameras */
  SimulatedRigGrabber(const SimulatedScene& scene,
                      const std::vector<RgbImage>& patterns,
                      const RigCalibration& calibration,
                      const SimulatedLight& light = {});

  /** \brief Stops the stream. */
  ~SimulatedRigGrabber() noexcept override;

  /** \brief Sets the seed of all random numbers (default 1). */
  void
  setSeed(std::uint64_t seed);

  std::uint64_t
  getSeed() const;

  /** \brief Sets the number of observations of a stream (default: the views of the
   * scene).
   * \throws BadArgumentException unless within 1 and the number of views */
  void
  setNumberOfObservations(std::size_t observations);

  std::size_t
  getNumberOfObservations() const;

  /** \brief Sets the number of threads (default 0 = all). */
  void
  setNumberOfThreads(unsigned threads);

  unsigned
  getNumberOfThreads() const;

  /** \brief Number of shots of an observation: one per pattern and one without. */
  std::size_t
  getShotsOfObservation() const;

  void
  start() override;

  void
  trigger() override;

  void
  rewind() override;

  /** \brief Returns 14, which is the rate of the time stamps. Frames are delivered as
   * fast as they are computed. */
  float
  getFramesPerSecond() const override;

  /** \brief The scene's rig. */
  TrinocularRig
  getRig() const override;

  /** \brief Computes all shots of an observation, without callbacks; may be called at
   * any time.
   * \throws BadArgumentException when the scene has no such view */
  std::vector<TrinocularFrame::Ptr>
  observe(std::size_t observation) const;

private:
  acmap::StreamThread&
  stream() const override;

  class Stream;

  SimulatedRigGrabber(std::unique_ptr<const acmap::RigSimulation> simulation);

  std::unique_ptr<const acmap::RigSimulation> simulation_;
  std::unique_ptr<Stream> stream_;
};

} // namespace pcl
