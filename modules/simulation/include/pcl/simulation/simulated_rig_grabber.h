#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/image_file.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_grabber.h>
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

/** \brief The rig and its projector in a simulated building, as a grabber: what a program
 * does with the frames of a camera, it does with these. Section II-A of "Active Stereo
 * Based Compact Mapping".
 *
 * An observation is taken from each view of the scene: a shot with the projector off
 * (\ref TrinocularFrame::no_pattern), then one under each pattern. Each place of a
 * surface is lit by the room and, where nothing stands between, by the projector; \ref
 * SimulatedLight has all that makes a grey level of it. A view is cast once for all its
 * shots. Stamps are 1/14 s apart, as the paper's camera works.
 *
 * Shots come as fast as they are made. Seed, number of observations and of threads count
 * from the first shot on: for a stream that has begun, after \ref rewind. After the last
 * shot, \ref rewind comes first.
 *
 * The same scene, patterns, light and seed give the same bytes, for any number of
 * threads and whichever observation is asked for first. Time O(pixels * shots).
 * Memory: one observation's views, 24 bytes for each pixel of each camera, 16 more where
 * they are raw, a shot, and the patterns.
 * \code
 * pcl::SimulatedRigGrabber grabber (pcl::standardScene ("corridor"), patterns);
 * std::function<pcl::TrinocularGrabber::FrameCallback> see =
 *   [] (const pcl::TrinocularFrame::ConstPtr& frame) { use (*frame); };
 * grabber.registerCallback (see);
 * grabber.start ();
 * grabber.wait ();
 * \endcode
 * \ingroup simulation */
class ACMAP_EXPORT SimulatedRigGrabber : public TrinocularGrabber {
public:
  using Ptr = shared_ptr<SimulatedRigGrabber>;
  using ConstPtr = shared_ptr<const SimulatedRigGrabber>;

  /** \brief The rectified cameras of the scene's rig.
   * \param[in] scene with at least one view
   * \param[in] patterns of the projector's size; may be none
   * \throws BadArgumentException for a scene without views, a rig or light that cannot
   * be, a pattern of another size */
  SimulatedRigGrabber(const SimulatedScene& scene,
                      const std::vector<RgbImage>& patterns,
                      const SimulatedLight& light = {});

  /** \brief The cameras as they are built, with distortion and out of line; what
   * rectification is for. The scene's views are places of the reference camera.
   * \throws BadArgumentException as above, and for cameras that cannot be or are not
   * those of the scene's rig, in number and size */
  SimulatedRigGrabber(const SimulatedScene& scene,
                      const std::vector<RgbImage>& patterns,
                      const RigCalibration& calibration,
                      const SimulatedLight& light = {});

  /** \brief Stops the stream. */
  ~SimulatedRigGrabber() noexcept override;

  /** \brief Sets what all randomness begins with (default 1). */
  void
  setSeed(std::uint64_t seed);

  std::uint64_t
  getSeed() const;

  /** \brief Sets how many observations a stream has (default: the views of the scene).
   * \throws BadArgumentException unless within 1 and the views of the scene */
  void
  setNumberOfObservations(std::size_t observations);

  std::size_t
  getNumberOfObservations() const;

  /** \brief Sets the number of threads (default 0 = all). */
  void
  setNumberOfThreads(unsigned threads);

  unsigned
  getNumberOfThreads() const;

  /** \brief Shots of an observation: one a pattern and one without. */
  std::size_t
  getShotsOfObservation() const;

  void
  start() override;

  void
  stop() override;

  void
  trigger() override;

  void
  rewind() override;

  bool
  isRunning() const override;

  void
  wait() override;

  std::exception_ptr
  getError() const override;

  /** \brief "SimulatedRigGrabber". */
  std::string
  getName() const override;

  /** \brief 14: what the stamps say. Frames come as fast as they are made. */
  float
  getFramesPerSecond() const override;

  /** \brief The scene's rig. */
  TrinocularRig
  getRig() const override;

  /** \brief All shots of an observation, without callbacks; may be called at any time.
   * \throws BadArgumentException when the scene has no such view */
  std::vector<TrinocularFrame::Ptr>
  observe(std::size_t observation) const;

private:
  class Stream;

  SimulatedRigGrabber(std::unique_ptr<const acmap::RigSimulation> simulation);

  std::unique_ptr<const acmap::RigSimulation> simulation_;
  std::unique_ptr<Stream> stream_;
};

} // namespace pcl
