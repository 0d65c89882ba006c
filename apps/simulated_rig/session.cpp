#include "session.h"

#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <memory>

namespace pcl::acmap {

namespace {

constexpr const char* session_name = "session.yaml";
// fraction of the time; the rest is for the ground truth
constexpr double share_of_filming = 0.85;

// metres: the default range of pcl_active_stereo
constexpr double nearest_measured = 0.5;
constexpr double farthest_measured = 10.0;

/** \brief Creates the grabber that films the scene.
 * \param[in] light its projector is given in the rectified reference camera's frame
 * \throws InputFileException when the cameras cannot be simulated */
std::unique_ptr<SimulatedRigGrabber>
grabberOf(const FilmedScene& filmed,
          const std::vector<RgbImage>& patterns,
          const SimulatedLight& light)
{
  if (!filmed.cameras)
    return std::make_unique<SimulatedRigGrabber>(filmed.scene, patterns, light);
  SimulatedScene scene = filmed.scene;
  for (Eigen::Isometry3d& view : scene.views)
    view = view * filmed.T_rectified_reference;
  SimulatedLight turned = light;
  Eigen::Isometry3d& projector = turned.projector.T_reference_projector;
  projector = filmed.T_rectified_reference.inverse() * projector;
  try {
    return std::make_unique<SimulatedRigGrabber>(
        scene, patterns, *filmed.cameras, turned);
  }
  catch (const BadArgumentException& exception) {
    throw InputFileException(filmed.cameras_path + ": " + exception.what());
  }
}

std::vector<RgbImage>
makePatterns(const SessionSettings& settings, const SimulatedProjector& projector)
{
  // as generated, and as the simulation stores them
  constexpr std::size_t bytes_per_pixel = 9;
  requireMemory(bytes_per_pixel * settings.patterns *
                    static_cast<std::size_t>(projector.width) *
                    static_cast<std::size_t>(projector.height),
                "the patterns");
  RandomLinePattern lines = settings.lines;
  lines.setSize(projector.width, projector.height);
  lines.setSeed(settings.seed);
  std::vector<RgbImage> patterns;
  for (std::uint32_t i = 0; i < settings.patterns; ++i)
    patterns.push_back(lines.generate(i));
  return patterns;
}

/** \brief Writes the ground truth of an observation for stereo. */
void
writeObservationTruth(const OutputFolder& folder,
                      const SimulatedScene& scene,
                      std::size_t observation,
                      const SimulatedProjector& projector,
                      SessionCounts& counts)
{
  const SimulatedTruth truth = truthOf(scene, observation, projector);
  const DisparityImage& disparities =
      truth.horizontal.values.empty() ? truth.vertical : truth.horizontal;
  if (!disparities.values.empty())
    savePfm(folder.path(numberedName("disparity", observation, ".pfm")), disparities);
  savePng(folder.path(numberedName("visible", observation, ".png")),
          scene.rig.width,
          scene.rig.height,
          truth.visible);
  addMeasurable(scene, truth, nearest_measured, farthest_measured, counts.measurable);
  for (std::size_t i = 0; i < truth.visible.size(); ++i) {
    counts.seen += truth.surfaces[i] >= 0 ? 1 : 0;
    counts.lit += (truth.visible[i] & SimulatedTruth::in_light) != 0 ? 1 : 0;
  }
}

/** \brief The poses, each with the stamp of the observation's first shot. */
Trajectory
stampedTrajectory(const SimulatedScene& scene, const SimulatedRigGrabber& grabber)
{
  Trajectory trajectory = trajectoryOf(scene, grabber.getNumberOfObservations());
  for (std::size_t i = 0; i < trajectory.stamps.size(); ++i)
    trajectory.stamps[i] = static_cast<double>(i * grabber.getShotsOfObservation()) /
                           grabber.getFramesPerSecond();
  return trajectory;
}

} // namespace

std::vector<std::string>
setBuiltCameras(const std::string& path, FilmedScene& filmed)
{
  filmed.cameras = loadRigCalibration(path);
  filmed.cameras_path = path;
  // images, rays and tables
  constexpr std::size_t bytes_per_pixel = 200;
  const RigCalibration& cameras = *filmed.cameras;
  requireMemory(bytes_per_pixel * static_cast<std::size_t>(cameras.width) *
                    static_cast<std::size_t>(cameras.height),
                "images of " + sizeText(cameras) + " pixels");
  TrinocularRectification rectification;
  try {
    rectification.setInputCalibration(cameras);
  }
  catch (const BadArgumentException& exception) {
    throw InputFileException(path + ": " + exception.what());
  }
  filmed.scene.rig = rectification.getRig();
  filmed.T_rectified_reference.linear() =
      rectification.getRotation(RigCamera::Reference);
  return rectification.getReport().remarks;
}

bool
isSessionName(const std::string& name)
{
  for (const char* const begin : {"disparity_", "visible_", "frame_"})
    if (name.rfind(begin, 0) == 0)
      return true;
  return isSequenceName(name) || name == rig_name || name == truth_name ||
         name == session_name;
}

SessionCounts
writeSession(const OutputFolder& folder,
             const FilmedScene& filmed,
             const SessionSettings& settings,
             const RunControls& controls)
{
  const Progress told(controls.progress);
  told.tell(0.0, "drawing patterns");
  const SimulatedLight& light = settings.light;
  const auto grabber =
      grabberOf(filmed, makePatterns(settings, light.projector), light);
  grabber->setSeed(settings.seed);
  grabber->setNumberOfThreads(controls.threads);
  grabber->setNumberOfObservations(settings.observations);
  const std::size_t frames = settings.observations * grabber->getShotsOfObservation();

  TrinocularRecorder recorder(folder.path("."), filmed.scene.rig, filmed.cameras);
  const std::function<TrinocularGrabber::FrameCallback> record =
      [&](const TrinocularFrame::ConstPtr& frame) {
        recorder.record(*frame);
        told.tell(share_of_filming * static_cast<double>(recorder.frames()) /
                      static_cast<double>(frames),
                  "filming");
      };
  grabber->registerCallback(record);
  grabber->start();
  grabber->wait();
  if (grabber->getError())
    std::rethrow_exception(grabber->getError());
  SessionCounts counts{TruthPoints(filmed.scene.geometry.planes().size())};
  counts.frames = recorder.frames();
  recorder.finish();

  for (std::size_t i = 0; i < settings.observations; ++i) {
    told.tell(share_of_filming + (1.0 - share_of_filming) * static_cast<double>(i) /
                                     static_cast<double>(settings.observations),
              "writing the truth");
    withThreads(controls.threads, [&] {
      writeObservationTruth(folder, filmed.scene, i, light.projector, counts);
    });
  }
  saveTrajectory(folder.path(trajectory_name),
                 stampedTrajectory(filmed.scene, *grabber));
  saveFrameTruth(folder.path(truth_name),
                 filmed.scene,
                 {settings.seed,
                  settings.observations,
                  settings.patterns,
                  settings.lines.getNumberOfLines(),
                  filmed.cameras.has_value(),
                  light},
                 counts.measurable);
  return counts;
}

} // namespace pcl::acmap
