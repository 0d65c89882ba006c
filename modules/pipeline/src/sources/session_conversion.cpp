#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/impl/json_text.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/disparity_picture.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/session_conversion.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>

namespace pcl {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto matched_outcome = static_cast<std::size_t>(DisparityOutcome::Matched);
constexpr const char* disparity_begin = "disparity";

/** Lists the finished observations, from which a later run can go on. */
constexpr const char* finished_name = "finished.json";

Json
figuresOf(const SessionObservation& made)
{
  std::vector<std::string> remarks = made.fusion.remarks;
  const std::vector<std::string>& more = made.projection.remarks;
  remarks.insert(remarks.end(), more.begin(), more.end());
  Json figures = {{"observation", made.number},
                  {"file", acmap::observationName(made.number)},
                  {"frames", made.frames}};
  figures.update(acmap::fieldsOf(made.fusion, {{"is_passive"}}));
  figures["matched"] = made.fusion.outcomes[matched_outcome];
  figures.update(acmap::fieldsOf(made.projection, {{"invalid"}}));
  figures["remarks"] = remarks;
  return figures;
}

/** \throws nlohmann::json::exception for figures of another form */
void
addSums(const Json& figures, ConvertedSession& converted)
{
  const auto count = [&](const char* name) {
    return figures.at(name).get<std::size_t>();
  };
  SessionReport& report = converted.report;
  report.frames += count("frames");
  report.points += count("points");
  report.too_near += count("too_near");
  report.too_far += count("too_far");
  for (std::size_t i = 0; i < report.outcomes.size(); ++i)
    report.outcomes[i] += figures.at("outcomes")
                              .at(acmap::disparity_outcome_names.at(i))
                              .get<std::size_t>();
  for (const Json& remark : figures.at("remarks"))
    converted.remarks_of[remark.get<std::string>()].push_back(count("observation"));
  ++report.observations;
}

/** Known poses by the numbers of the observations. */
class NumberedPoses {
public:
  /** \throws InputFileException if there are too few for the session */
  NumberedPoses(std::string path, const SessionSource& session)
  : path_(std::move(path))
  {
    if (path_.empty())
      return;
    trajectory_ = loadTrajectory(path_);
    if (session.size() > 0)
      of(session.numberOf(session.size() - 1));
  }

  const Trajectory&
  trajectory() const
  {
    return trajectory_;
  }

  Eigen::Isometry3d
  of(std::size_t number) const
  {
    if (path_.empty())
      return Eigen::Isometry3d::Identity();
    if (number >= trajectory_.poses.size())
      throw InputFileException(path_ + ": has " +
                               std::to_string(trajectory_.poses.size()) +
                               " poses, none for observation " +
                               std::to_string(number) + " (counted from 0)");
    return trajectory_.poses[number];
  }

private:
  std::string path_;
  Trajectory trajectory_;
};

void
saveDisparity(const SessionConversion& conversion,
              const acmap::OutputFolder& folder,
              const SessionObservation& made)
{
  const auto path = [&](const char* ending) {
    return folder.path(conversion.numbers_disparities
                           ? acmap::numberedName(disparity_begin, made.number, ending)
                           : std::string(disparity_begin) + ending);
  };
  const DisparityImage& disparity = made.matched.disparity;
  savePfm(path(".pfm"), disparity);
  savePng(path(".png"), disparity.width, disparity.height, disparityPicture(disparity));
}

/** Moves an observation to its final place, with the figures so far: a run that is killed
 * loses only the observation that it was working on. The next one is written at the same
 * place. */
void
putInPlace(std::optional<acmap::OutputFolder>& part, const ConvertedSession& converted)
{
  acmap::saveJson(part->path(finished_name), Json::parse(converted.figuresText()), -1);
  part->commit();
  const std::string name = part->name();
  part.emplace(name);
}

/** The sums of equal steps. */
void
addSeconds(const Report& steps, Report& report)
{
  for (const char* const step : {"wait for shots", "match", "write"}) {
    double sum = 0;
    for (const auto& [name, seconds] : steps.seconds)
      sum += name == step ? seconds : 0;
    report.seconds.emplace_back(step, sum);
  }
}

} // namespace

void
ConvertedSession::add(const SessionObservation& made)
{
  const Json figures = figuresOf(made);
  addSums(figures, *this);
  figures_.emplace_back(made.number, acmap::jsonText(figures));
}

bool
ConvertedSession::has(std::size_t number) const
{
  return std::any_of(figures_.begin(), figures_.end(), [&](const auto& figures) {
    return figures.first == number;
  });
}

std::size_t
ConvertedSession::pixels() const
{
  return std::accumulate(
      report.outcomes.begin(), report.outcomes.end(), std::size_t{0});
}

std::size_t
ConvertedSession::matched() const
{
  return report.outcomes[matched_outcome];
}

std::string
ConvertedSession::figuresText() const
{
  std::string text;
  for (const auto& [number, figures] : figures_)
    text += (text.empty() ? "" : ",") + figures;
  return "[" + text + "]";
}

bool
ConvertedSession::addFigures(const std::string& text,
                             const std::function<bool(const std::string&)>& is_there)
{
  const Json all = acmap::parsedJson(text);
  if (!all.is_array())
    return false;
  try {
    ConvertedSession sum = *this;
    for (const Json& figures : all) {
      if (!is_there(figures.at("file").get<std::string>()))
        continue;
      addSums(figures, sum);
      sum.figures_.emplace_back(figures.at("observation").get<std::size_t>(),
                                acmap::jsonText(figures));
    }
    *this = std::move(sum);
    return true;
  }
  catch (const nlohmann::json::exception&) {
    return false;
  }
}

bool
isConvertedName(const std::string& name)
{
  return acmap::isSequenceName(name) || name.rfind(disparity_begin, 0) == 0;
}

void
convertSession(SessionSource& session,
               const SessionConversion& conversion,
               acmap::OutputFolder& folder,
               ConvertedSession& converted)
{
  const NumberedPoses poses(conversion.poses, session);
  if (!conversion.poses.empty())
    saveTrajectory(folder.path(acmap::trajectory_name), poses.trajectory());
  const fs::path place = folder.name();
  if (conversion.goes_on)
    converted.addFigures(
        acmap::jsonText(acmap::readJson((place / finished_name).string())),
        [&](const std::string& name) {
          return acmap::isPlainName(name) && fs::exists(place / name);
        });
  std::optional<acmap::OutputFolder> part;
  const acmap::OutputFolder& files =
      conversion.goes_on ? part.emplace(folder.name()) : folder;
  Report steps;
  acmap::StepTimer timer(steps);
  const acmap::Progress progress(conversion.progress);
  const auto count = static_cast<double>(session.size());
  for (std::size_t i = 0; i < session.size(); ++i) {
    const double begin = static_cast<double>(i) / count;
    progress.tell(begin, "reading shots");
    const std::optional<acmap::ObservationShots> shots = session.nextShots();
    timer.finish("wait for shots");
    if (!shots || converted.has(shots->number))
      continue;
    const SessionObservation made = session.fuse(
        *shots, acmap::partOf(conversion.progress, begin, begin + 1 / count));
    timer.finish("match");
    converted.add(made);
    PCLPointCloud2 cloud;
    toPCLPointCloud2(made.cloud, cloud);
    acmap::saveObservation(
        files.path(acmap::observationName(made.number)), cloud, poses.of(made.number));
    if (conversion.writes_disparities)
      saveDisparity(conversion, files, made);
    if (part)
      putInPlace(part, converted);
    timer.finish("write");
  }
  addSeconds(steps, converted.report);
  if (conversion.goes_on) {
    std::error_code ignored;
    fs::remove(place / finished_name, ignored);
  }
}

} // namespace pcl
