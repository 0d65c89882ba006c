#include "stereo_observation.h"

#include "json_file.h"

#include <pcl/core/output_file.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>

#include <filesystem>
#include <future>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/** \brief The rig of image lists: cameras without a list are not used.
 * \throws UsageError for a list of a camera that is not in the rig */
TrinocularRig
rigOfLists(const StereoOptions& options)
{
  TrinocularRig rig = loadTrinocularRig(options.rig);
  const auto use =
      [&](RigCamera camera, const std::vector<std::string>& images, double& baseline) {
        const std::string name = nameOf(camera);
        if (images.empty())
          baseline = 0.0;
        else if (baseline == 0.0)
          throw UsageError("--" + name + ": " + options.rig + " has no " + name +
                           " camera");
      };
  use(RigCamera::Horizontal, options.images.horizontal, rig.baseline_horizontal);
  use(RigCamera::Vertical, options.images.vertical, rig.baseline_vertical);
  return rig;
}

std::unique_ptr<TrinocularFileGrabber>
openGrabber(const StereoOptions& options)
{
  if (options.hasLists())
    return std::make_unique<TrinocularFileGrabber>(options.images, rigOfLists(options));
  return std::make_unique<TrinocularFileGrabber>(options.session);
}

/** \brief The shots of the next observation, and the progress of the whole work. */
struct ComingShots {
  std::optional<ObservationShots> shots; ///< nothing at the end
  double done = 0;                       ///< fraction of all frames
};

/** \brief Reads the observations of a session, or the one of image lists, one after
 * another, and rectifies them if they are not rectified. */
class ShotSource {
public:
  /** \throws InputFileException when session, rig or the image for the colours are
   * missing or malformed, or the rig cannot be rectified or matched
   * \throws UsageError for lists of a camera that is not in the rig
   * \throws BadArgumentException for lists of different lengths */
  ShotSource(const StereoOptions& options, unsigned threads)
  : options_(options)
  , grabber_(openGrabber(options))
  , has_cameras_(hasBuiltCameras(options.rigPath()))
  // the rig.yaml of a session defines if its frames are rectified
  , rectifier_(options.rigPath(),
               grabber_->getRig(),
               options.hasLists() ? options.rectify : has_cameras_,
               threads)
  , broken_(grabber_->getReport().broken.size())
  , remarks_(grabber_->getReport().remarks)
  {
    const std::vector<std::string>& more = rectifier_.remarks();
    remarks_.insert(remarks_.end(), more.begin(), more.end());
    if (!options.color.empty())
      groups_.add(loadOffShot(options.color));
  }

  /** \brief Rig of the rectified frames. */
  const TrinocularRig&
  rig() const
  {
    return rectifier_.rig();
  }

  bool
  isRectifying() const
  {
    return rectifier_.isRectifying();
  }

  /** \brief Are images matched as they are, though the rig has unrectified cameras? */
  bool
  mayNeedRectification() const
  {
    return options_.hasLists() && has_cameras_ && !isRectifying();
  }

  /** \brief Reads the next observation. Broken frames of a session are left out and
   * reported in the remarks.
   * \throws InputFileException for an image of the lists that cannot be read */
  ComingShots
  next()
  {
    const auto count = static_cast<double>(grabber_->frames());
    while (next_ < grabber_->frames()) {
      const std::size_t index = next_++;
      try {
        const TrinocularFrame::Ptr frame = grabber_->frame(index);
        rectifier_.rectify(*frame);
        if (options_.isPassive())
          frame->pattern = TrinocularFrame::no_pattern;
        if (auto shots = groups_.add(frame))
          return {std::move(shots), static_cast<double>(index) / count};
      }
      catch (const InputFileException&) {
        if (options_.hasLists())
          throw;
        noteBroken();
      }
    }
    return {groups_.finish(), 1.0};
  }

  /** \brief Number of the last observation that can be read.
   * \throws InputFileException when no frame can be read */
  std::size_t
  lastObservation() const
  {
    for (std::size_t index = grabber_->frames(); index-- > 0;)
      try {
        return static_cast<std::size_t>(grabber_->frame(index)->observation);
      }
      catch (const InputFileException&) {
        if (index == 0)
          throw;
      }
    throw InputFileException("the session has no frames");
  }

  /** \brief Warnings so far. */
  std::vector<std::string>
  remarks() const
  {
    std::vector<std::string> all = remarks_;
    all.insert(all.end(), groups_.remarks().begin(), groups_.remarks().end());
    const TrinocularFileReport report = grabber_->getReport();
    const auto count = [&](const std::vector<std::uint64_t>& found,
                           const std::string& fault) {
      if (!found.empty())
        all.push_back(std::to_string(found.size()) + " of " +
                      std::to_string(grabber_->frames()) +
                      " frames have a camera that is " + fault + ", the first is " +
                      std::to_string(found.front()));
    };
    count(report.saturated, "saturated");
    count(report.black, "black");
    return all;
  }

  /** \brief Numbers of the frames that could not be read so far. */
  std::vector<std::uint64_t>
  broken() const
  {
    return grabber_->getReport().broken;
  }

private:
  TrinocularFrame::ConstPtr
  loadOffShot(const std::string& path) const
  {
    TrinocularFrame::Ptr frame(new TrinocularFrame);
    CameraImage& image = frame->image(RigCamera::Reference);
    image = loadCameraImage(path);
    const auto size = [](std::int32_t width, std::int32_t height) {
      return std::to_string(width) + " x " + std::to_string(height) + " pixels";
    };
    if (image.width != rig().width || image.height != rig().height)
      throw InputFileException(path + ": has " + size(image.width, image.height) +
                               ", the rig " + size(rig().width, rig().height));
    rectifier_.rectify(*frame);
    // a shot has an image of each camera, but colour is only taken from the reference
    for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
      if (hasCamera(rig(), camera))
        frame->image(camera) = image;
    return frame;
  }

  void
  noteBroken()
  {
    const TrinocularFileReport report = grabber_->getReport();
    if (report.broken.size() == broken_)
      return; // already found when the session was opened
    broken_ = report.broken.size();
    remarks_.push_back(report.remarks.back());
  }

  const StereoOptions& options_;
  std::unique_ptr<TrinocularFileGrabber> grabber_;
  bool has_cameras_;
  FrameRectifier rectifier_;
  std::size_t next_ = 0;
  ShotGroups groups_;
  std::size_t broken_; // number of frames that are known to be
  std::vector<std::string> remarks_;
};

/** \brief T_map_camera of an observation; the identity if no poses are given.
 * \throws InputFileException when there is none for it */
Eigen::Isometry3d
poseOf(std::size_t observation, const Trajectory& poses, const StereoOptions& options)
{
  if (options.poses.empty())
    return Eigen::Isometry3d::Identity();
  if (observation >= poses.poses.size())
    throw InputFileException(options.poses + ": has " +
                             std::to_string(poses.poses.size()) +
                             " poses, none for observation " +
                             std::to_string(observation) + " (counted from 0)");
  return poses.poses[observation];
}

/** \brief Name of the file that lists the finished observations, from which a later run
 * can continue. */
constexpr const char* finished_name = "finished.json";

StereoResults
finishedBefore(const StereoOptions& options)
{
  const fs::path folder = options.output;
  const Json entries = readJson((folder / finished_name).string());
  if (!options.goes_on || !entries.is_array())
    return {};
  try {
    StereoResults results;
    for (const Json& entry : entries) {
      const auto name = entry.at("file").get<std::string>();
      if (isPlainName(name) && fs::exists(folder / name))
        results.add(entry);
    }
    return results;
  }
  catch (const nlohmann::json::exception&) {
    return {}; // damaged: everything is computed again
  }
}

/** \brief Writes an observation into the hidden part of the folder. If a later run is
 * to continue from it, it is moved to its final place, with the statistics so far: a
 * run that is killed loses only the observation that it was working on. */
void
save(const OutputFolder& folder,
     const StereoOptions& options,
     std::size_t number,
     const MadeObservation& made,
     const Eigen::Isometry3d& pose,
     const StereoResults& results)
{
  if (!options.goes_on)
    return saveResults(folder, options, number, made, pose);
  OutputFolder finished(options.output);
  saveResults(finished, options, number, made, pose);
  const std::string text = results.observations.dump() + "\n";
  OutputFile file(finished.path(finished_name));
  file.write(text.data(), text.size());
  file.commit();
  finished.commit();
}

/** \brief Computes the observations one after another, while the next one is read.
 * Seconds of each step are summed over the observations. */
void
writeObservations(const StereoOptions& options,
                  const Trajectory& poses,
                  ShotSource& source,
                  ShotFusion& fusion,
                  const OutputFolder& folder,
                  const ProgressCallback& progress,
                  StereoResults& results,
                  Report& report)
{
  Report steps;
  StepTimer timer(steps);
  const Progress told(
      [&](double done, const auto& step) { return progress(done, step); });
  const auto read_on = [&] {
    return std::async(std::launch::async, [&] { return source.next(); });
  };
  double begin = 0;
  for (std::future<ComingShots> next = read_on();;) {
    told.tell(begin, "reading shots");
    const auto [shots, done] = next.get();
    timer.finish("wait for shots");
    if (!shots)
      break;
    next = read_on();
    if (!results.has(shots->number)) {
      const MadeObservation made = fusion.make(
          *shots, [&, end = done](double fraction, const std::string& step) {
            return progress(std::min(begin + fraction * (end - begin), end), step);
          });
      timer.finish("match");
      results.add(shots->number, shots->frames.size(), made);
      const Eigen::Isometry3d pose = poseOf(shots->number, poses, options);
      save(folder, options, shots->number, made, pose, results);
      timer.finish("write");
    }
    begin = done;
  }
  for (const char* const step : {"wait for shots", "match", "write"}) {
    double sum = 0;
    for (const auto& [name, seconds] : steps.seconds)
      sum += name == step ? seconds : 0;
    report.seconds.emplace_back(step, sum);
  }
}

void
warn(const StereoOptions& options,
     const ShotSource& source,
     const StereoResults& results,
     StageLog& log)
{
  warnOfFindings(log, source.remarks());
  results.warnOfRemarks(log);
  if (source.mayNeedRectification())
    log.warn("images are taken as rectified; if they are as the cameras in " +
             options.rig + " gave them, they need --rectify");
}

/** \throws InputFileException when there was no readable frame
 * \throws NothingFound when no observation has a point */
void
requirePoints(const StereoOptions& options,
              const StereoResults& results,
              const StageLog& log)
{
  if (results.points > 0)
    return;
  if (results.observations.empty())
    throw InputFileException(
        options.session + ": has no frame that can be read" +
        (log.report.remarks.empty() ? "" : ", " + log.report.remarks[0]));
  log.failWithNothing((options.session.empty() ? "" : options.session + ": ") +
                      "no pixel has a place: " + results.rejected());
}

/** \brief How the shots were matched. With one image per camera, which the user may have
 * taken with or without a pattern, the other possibility is named too. */
std::string
methodText(const StereoOptions& options)
{
  if (!options.hasOneShot())
    return options.method;
  return options.isPassive() ? "passive stereo, one image per camera "
                               "(--active: taken under a pattern)"
                             : "one shot under a pattern (--active)";
}

void
tell(const StereoOptions& options,
     const ShotSource& source,
     const SearchRange& range,
     const StereoResults& results,
     StageLog& log)
{
  // it is above the requested one if image or matcher limit the disparities
  const double nearest = std::max(options.nearest, depthOf(source.rig(), range.most()));
  log.details = {{"input", options.hasLists() ? options.rig : options.session},
                 {"output", options.output},
                 {"frames", source.isRectifying() ? "raw" : "rectified"},
                 {"method", options.isPassive() ? "passive" : options.method},
                 {"least_disparity", range.least},
                 {"most_disparity", range.most()},
                 {"least_depth", nearest},
                 {"most_depth", options.farthest},
                 {"has_poses", !options.poses.empty()},
                 {"points", results.points},
                 {"matched_share", results.matchedShare()},
                 {"outcomes", jsonOf(results.outcomes)},
                 {"broken_frames", source.broken()},
                 {"findings", source.remarks()},
                 {"observations", results.observations}};
  log.tell("observations", std::to_string(results.observations.size()));
  log.tell("frames",
           std::to_string(results.frames) +
               (source.isRectifying() ? ", rectified here" : ", taken as rectified"));
  log.tell("method", methodText(options));
  log.tell("searched",
           std::to_string(range.least) + " to " + std::to_string(range.most()) +
               " px, depths of " + shortNumber(nearest) + " to " +
               shortNumber(options.farthest) + " m");
  results.tellPoints(log);
  if (!options.hasLists())
    log.tell("poses", options.poses.empty() ? "none" : options.poses);
  log.tellSeconds();
  log.tell("folder", options.output);
}

} // namespace

void
makeObservations(const StereoOptions& options,
                 const RunControls& controls,
                 StageLog& log)
{
  StepTimer timer(log.report);
  ShotSource source(options, controls.threads);
  ShotFusion fusion(source.rig(), options, controls.threads);
  Trajectory poses;
  if (!options.poses.empty()) {
    poses = loadTrajectory(options.poses);
    poseOf(source.lastObservation(), poses, options);
  }
  OutputFolder folder(options.output);
  if (!options.goes_on)
    requireNoStereo(folder);
  if (!options.poses.empty())
    saveTrajectory(folder.path(trajectory_name), poses);
  timer.finish("open");

  StereoResults results = finishedBefore(options);
  try {
    writeObservations(
        options, poses, source, fusion, folder, controls.progress, results, log.report);
  }
  catch (const CancelledException&) {
    if (results.points == 0)
      throw;
    // each of them is complete
    folder.commit();
    throw InterruptedPartway("interrupted; observations finished by then, in " +
                             options.output + ": " +
                             std::to_string(results.observations.size()));
  }
  warn(options, source, results, log);
  requirePoints(options, results, log);
  folder.commit();
  std::error_code ignored;
  fs::remove(fs::path(options.output) / finished_name, ignored);
  tell(options, source, fusion.range(), results, log);
}

} // namespace pcl::acmap
