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

/** \brief A digital camera according to the IIDC specification (1.20 to 1.32): its
 * identity, capabilities, settings and frames, over any \ref IidcBus.
 *
 * Settings are remembered: \ref open applies them again after the camera was unplugged.
 * All values read from registers are checked before use, and no register is polled
 * without a limit. All functions may be called from any thread, except that
 * \ref startStream, \ref nextFrame and \ref stopStream must be called from one thread
 * at a time.
 * \code
 * pcl::IidcCamera camera ([] { return pcl::openUsbBus (); });
 * camera.open ();
 * std::cout << camera.identity ().model << '\n';
 * camera.setPhysical (pcl::IidcFeature::Shutter, 0.01F);
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT IidcCamera {
public:
  /** \param[in] opener opens the bus */
  explicit IidcCamera(IidcBusOpener opener);
  ~IidcCamera();

  IidcCamera(const IidcCamera&) = delete;
  IidcCamera&
  operator=(const IidcCamera&) = delete;

  /** \brief Opens the bus, reads the configuration ROM and the list of modes, and
   * applies the settings that were made before. Does nothing if the camera is open.
   * \throws CameraException as the bus; Malformed when this is not an IIDC camera;
   * NotFound when it is not the same camera as before */
  void
  open();

  /** \brief Releases the bus; does nothing if the camera is closed. */
  void
  close() noexcept;

  bool
  isOpen() const;

  /** \brief Location of the camera; that of the last bus if the camera is closed. */
  std::string
  place() const;

  /** \brief Identity of the camera that was opened last. */
  IidcIdentity
  identity() const;

  /** \brief All modes whose registers are valid, in ascending order. */
  std::vector<IidcMode>
  modes() const;

  /** \brief Finds the first mode of this size that contains the images of this number
   * of cameras. Format 7 is preferred to the others.
   * \throws CameraException Unsupported; the message lists the available modes */
  IidcMode
  findMode(int width, int height, int cameras) const;

  /** \brief Colour filter of its sensors: `GBRG` or similar, beginning at the upper
   * left corner; `YYYY` if there is none.
   * \throws CameraException Unplugged, Silent; Failed when the camera is closed */
  std::string
  colorFilter() const;

  /** \brief Sets mode and frame rate of the next stream. If the mode does not have the
   * requested rate, the nearest one is used; in format 7, the rate is set by the frame
   * rate feature or by the packet size.
   * \param[in] mode one of \ref modes
   * \param[in] frames_per_second requested rate
   * \return the actual rate of the camera
   * \throws BadArgumentException unless the rate is within [0.001, 1000]
   * \throws CameraException Unsupported when the camera does not have this mode;
   * Malformed, Silent, Unplugged; Failed when the camera is closed */
  float
  setMode(const IidcMode& mode, float frames_per_second);

  /** \brief Capabilities and current state of a feature.
   * \throws CameraException Unplugged, Silent; Failed when the camera is closed */
  IidcFeatureState
  feature(IidcFeature feature) const;

  /** \brief Sets a feature in the camera's own units.
   * \throws BadArgumentException naming the valid range; always for the frame rate
   * \throws CameraException Unsupported if the camera does not have the feature */
  void
  setValue(IidcFeature feature, unsigned value);

  /** \brief Sets a feature in physical units.
   * \throws BadArgumentException naming the valid range; always for the frame rate
   * \throws CameraException Unsupported when the feature has no physical units */
  void
  setPhysical(IidcFeature feature, float value);

  /** \brief Lets the camera control a feature automatically.
   * \throws CameraException Unsupported when the camera cannot do this */
  void
  setAutomatic(IidcFeature feature);

  /** \throws CameraException Unsupported when the camera has no trigger input */
  void
  setTrigger(IidcTrigger trigger);

  IidcTrigger
  trigger() const;

  /** \brief Returns true if the camera can take a single image on request. */
  bool
  hasOneShot() const;

  /** \brief Returns true if the camera writes a counter into its frames, so that lost
   * frames are detected. */
  bool
  hasFrameCounter() const;

  /** \brief Prepares for receiving frames in the mode that was set; the camera does not
   * send yet.
   * \param[in] frames maximum number of frames that wait for \ref nextFrame
   * \throws CameraException Unsupported before \ref setMode; Failed when the camera is
   * closed; as the bus */
  void
  startStream(std::size_t frames);

  /** \brief Starts continuous transmission of frames.
   * \throws CameraException Unplugged, Silent; Failed when the camera is closed */
  void
  runFreely();

  /** \brief Requests one frame, which is exposed after the call.
   * \throws CameraException Unsupported when the camera has no one-shot; Unplugged,
   * Silent; Failed when the camera is closed */
  void
  takeOne();

  /** \brief As \ref IidcBus::nextFrame. */
  IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout);

  /** \brief Ends the transmission of frames. Does not throw when the camera was
   * removed. */
  void
  stopStream() noexcept;

  /** \brief As \ref IidcBus::cancel; does nothing if the camera is closed. */
  void
  cancel() noexcept;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
