#pragma once

#include <pcl/acquisition/iidc_bus.h>
#include <pcl/acquisition/iidc_types.h>
#include <pcl/core/export.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief A digital camera after the IIDC specification (1.20 to 1.32): who it is, what it
 * can, what it is set to, its frames; over any \ref IidcBus.
 *
 * What is set is remembered: \ref open after the camera was unplugged sets it again.
 * Nothing the registers say is believed before it was checked, and no register is polled
 * for ever. May be called from any thread; \ref startStream, \ref nextFrame and \ref
 * stopStream from one at a time.
 * \code
 * pcl::IidcCamera camera ([] { return pcl::openUsbBus (); });
 * camera.open ();
 * std::cout << camera.identity ().model << '\n';
 * camera.setPhysical (pcl::IidcFeature::Shutter, 0.01F);
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT IidcCamera {
public:
  /** \param[in] opener gives the bus */
  explicit IidcCamera(IidcBusOpener opener);
  ~IidcCamera();

  IidcCamera(const IidcCamera&) = delete;
  IidcCamera&
  operator=(const IidcCamera&) = delete;

  /** \brief Opens the bus, reads the configuration ROM and the list of modes, and sets
   * again what was set before; nothing when it is open.
   * \throws CameraException what the bus throws; Malformed when this is no IIDC camera;
   * NotFound when it is another one than before */
  void
  open();

  /** \brief Gives the bus back; nothing when it is closed. */
  void
  close() noexcept;

  bool
  isOpen() const;

  /** \brief Where it is; of the last bus when it is closed. */
  std::string
  place() const;

  /** \brief Of the camera that was opened last. */
  IidcIdentity
  identity() const;

  /** \brief All modes whose registers make sense, ascending. */
  std::vector<IidcMode>
  modes() const;

  /** \brief The first mode of this size with so many cameras' images: of format 7 before
   * the others.
   * \throws CameraException Unsupported naming what there is */
  IidcMode
  findMode(int width, int height, int cameras) const;

  /** \brief Whether its images are of colour filters, and of which: `GBRG` and the like,
   * from the upper left corner; `YYYY` for none.
   * \throws CameraException Unplugged, Silent; Failed when it is closed */
  std::string
  colorFilter() const;

  /** \brief Mode and rate of the next stream. A rate that the mode has not becomes the
   * nearest that it has; of format 7, the frame rate feature or the packet size decides.
   * \param[in] frames_per_second wanted
   * \return the rate that the camera will have
   * \throws BadArgumentException unless the rate is within [0.001, 1000]
   * \throws CameraException Unsupported when this camera has no such mode; Malformed,
   * Silent, Unplugged */
  float
  setMode(const IidcMode& mode, float frames_per_second);

  /** \brief What the camera can do with a feature, and does.
   * \throws CameraException Unplugged, Silent, Malformed */
  IidcFeatureState
  feature(IidcFeature feature) const;

  /** \brief Sets a feature in steps of the camera's own.
   * \throws BadArgumentException naming the range; for the frame rate
   * \throws CameraException Unsupported without such a feature */
  void
  setValue(IidcFeature feature, unsigned value);

  /** \brief Sets a feature in physical units.
   * \throws BadArgumentException naming the range; for the frame rate
   * \throws CameraException Unsupported when the camera knows none */
  void
  setPhysical(IidcFeature feature, float value);

  /** \brief Leaves a feature to the camera.
   * \throws CameraException Unsupported when it cannot */
  void
  setAutomatic(IidcFeature feature);

  /** \throws CameraException Unsupported when it has no trigger input */
  void
  setTrigger(IidcTrigger trigger);

  IidcTrigger
  trigger() const;

  /** \brief Whether it can take one image when it is told to. */
  bool
  hasOneShot() const;

  /** \brief Whether it writes a counter into its frames, so that lost ones are known. */
  bool
  hasFrameCounter() const;

  /** \brief Gets ready for frames of the mode that was set; none come yet.
   * \param[in] frames how many may wait for \ref nextFrame
   * \throws CameraException Unsupported before \ref setMode; what the bus throws */
  void
  startStream(std::size_t frames);

  /** \brief Frames come from now on.
   * \throws CameraException Unplugged, Silent; Failed when it is closed */
  void
  runFreely();

  /** \brief One frame is exposed and comes.
   * \throws CameraException Unsupported when it has no one-shot; Unplugged, Silent; Failed
   * when it is closed */
  void
  takeOne();

  /** \brief As \ref IidcBus::nextFrame. */
  IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout);

  /** \brief No frames come. Does not throw when the camera is gone. */
  void
  stopStream() noexcept;

  /** \brief As \ref IidcBus::cancel; nothing when it is closed. */
  void
  cancel() noexcept;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
