#include "bench.h"
#include "curve_chart.h"
#include "paper_runs.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/pipeline/observation_files.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t observations = 12;
constexpr std::size_t max_raw_points = 0; // nothing is meshed raw

/** \brief A value of a setting, and what the map is worth with it. */
struct CurvePoint {
  double x = 0;
  std::string failure; ///< empty if there is a map
  PaperWayScores scores;
};

/** \brief A row of results, such as those of a way of fusion. */
struct Series {
  std::string name;
  std::vector<CurvePoint> points;
};

std::string
textOf(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/** \brief Films the first observations of a scene.
 * \param[in] options of pcl_simulated_rig */
void
film(const std::string& session,
     const std::string& scene,
     const std::vector<std::string>& options)
{
  test::runTool(ACMAP_SIMULATED_RIG,
                test::joined({"-o",
                              session,
                              "--scene",
                              scene,
                              "--observations",
                              std::to_string(observations)},
                             options))
      .succeeded();
}

void
nothing(CompactMapping& /*mapping*/)
{}

/** \brief What a map is worth, if there is one. */
CurvePoint
pointOf(const PaperWayRun& run, const SessionTruth& truth)
{
  CurvePoint point;
  point.failure = run.failure;
  if (run.failure.empty())
    point.scores = scoresOf(run, truth);
  return point;
}

/** \brief The map of a film, compared with its truth.
 * \param[in] has_poses the true poses are given */
CurvePoint
mapFilm(const std::string& session,
        const char* stereo,
        const std::function<void(CompactMapping&)>& change = nothing,
        bool has_poses = false)
{
  const test::TemporaryFolder folder;
  const std::string clouds = folder.path("clouds");
  std::vector<std::string> arguments = {session, "-o", clouds, stereo};
  if (has_poses)
    arguments.insert(arguments.end(), {"--poses", session + "/trajectory.txt"});
  test::runTool(ACMAP_ACTIVE_STEREO, arguments).succeeded();
  const PaperWayRun run = runPaperWay({"", stereo, false, change},
                                      ObservationSequence(observationPaths(clouds)),
                                      false,
                                      max_raw_points,
                                      has_poses);
  return pointOf(run, loadSessionTruth(session));
}

void
printSeriesHead(const std::string& setting)
{
  printHead(setting +
            " | planes found | not found | spurious | cover, m² | angle, degrees | "
            "offset, mm | ATE, cm");
}

void
printPoint(const std::string& name, const CurvePoint& point)
{
  Row row;
  row << name;
  if (!point.failure.empty()) {
    row << point.failure;
    for (int column = 0; column < 6; ++column)
      row << "";
    return;
  }
  const PaperWayScores& scores = point.scores;
  row << std::to_string(scores.found) + " of " + std::to_string(scores.planes)
      << scores.missing << scores.spurious << figure(scores.cover, 1)
      << figure(scores.angle, 3) << figure(milli * scores.offset, 1)
      << figure(centi * scores.ate, 1);
}

/** \brief Prints and keeps a point of a series. */
void
add(Series& series, double x, CurvePoint point)
{
  point.x = x;
  printPoint(series.name + ", " + textOf(x), point);
  series.points.push_back(std::move(point));
}

using Measure = double (*)(const PaperWayScores&);

CurvePanel
panelOf(const std::vector<Series>& all, const char* title, Measure measure)
{
  CurvePanel panel{title, {}};
  for (const Series& series : all) {
    Curve curve{series.name, {}, {}};
    for (const CurvePoint& point : series.points) {
      curve.x.push_back(point.x);
      curve.y.push_back(point.failure.empty()
                            ? measure(point.scores)
                            : std::numeric_limits<double>::quiet_NaN());
    }
    panel.curves.push_back(curve);
  }
  return panel;
}

/** \brief Draws a figure into the folder that ACMAP_CURVES names, if it is set. */
void
draw(const std::string& name,
     const std::string& x_title,
     bool is_logarithmic,
     const std::vector<Series>& all)
{
  const char* const folder = std::getenv("ACMAP_CURVES");
  if (!folder)
    return;
  std::filesystem::create_directories(folder);
  drawCurves(
      folder + ("/curves_" + name) + ".png",
      x_title,
      is_logarithmic,
      {panelOf(all,
               "planes found",
               [](const PaperWayScores& s) { return static_cast<double>(s.found); }),
       panelOf(
           all, "area covered, m²", [](const PaperWayScores& s) { return s.cover; }),
       panelOf(all,
               "angle of planes, degrees",
               [](const PaperWayScores& s) {
                 return s.found > 0 ? s.angle
                                    : std::numeric_limits<double>::quiet_NaN();
               }),
       panelOf(all, "offset of planes, mm", [](const PaperWayScores& s) {
         return s.found > 0 ? milli * s.offset
                            : std::numeric_limits<double>::quiet_NaN();
       })});
}

/** \brief Maps films that differ by one option of pcl_simulated_rig, by each stereo. */
void
printOption(const std::string& name,
            const std::string& x_title,
            const std::vector<int>& values,
            std::vector<std::pair<Series, const char*>> ways)
{
  printSeriesHead("stereo, " + name);
  for (const int value : values) {
    const test::TemporaryFolder folder;
    const std::string session = folder.path("session");
    film(session, "corridor_survey", {"--" + name, std::to_string(value)});
    for (auto& [series, stereo] : ways)
      add(series, value, mapFilm(session, stereo));
  }
  std::vector<Series> all;
  for (auto& way : ways)
    all.push_back(std::move(way.first));
  draw(name, x_title, true, all);
}

const Section patterns_section("patterns", [] {
  printOption("patterns",
              "patterns N of an observation",
              {1, 2, 3, 5, 10, 20},
              {{{"all patterns at once", {}}, spacetime},
               {{"median of the disparities", {}}, median_of_shots},
               {{"those that agree", {}}, statistical}});
});

const Section lines_section("lines", [] {
  printOption("lines",
              "lines L of a pattern",
              {10, 25, 50, 100, 200, 400, 800},
              {{{"all patterns at once", {}}, spacetime},
               {{"median of the disparities", {}}, median_of_shots}});
});

/** \brief Light of the room and of the projector. */
struct Lighting {
  const char* name;
  std::vector<std::string> options;
  const char* stereo;
};

/** The true poses are given: at night there is no picture without a pattern, by which
 * the egomotion could be found. */
const Section light_section("light", [] {
  const std::vector<std::string> night = {"--ambient", "0.01"},
                                 narrow = {"--ambient", "0.01", "--aperture", "300"};
  const auto no_rectification = [](CompactMapping& mapping) {
    mapping.setRectify(false);
  };
  printSeriesHead("light");
  for (const Lighting& light :
       {Lighting{"room and patterns, all at once", {}, spacetime},
        Lighting{"room and patterns, median", {}, median_of_shots},
        Lighting{"room alone", {}, unlit},
        Lighting{"night, all at once", night, spacetime},
        Lighting{"night, median", night, median_of_shots},
        Lighting{"night, narrow aperture, all at once", narrow, spacetime},
        Lighting{"night, narrow aperture, median", narrow, median_of_shots}}) {
    const test::TemporaryFolder folder;
    const std::string session = folder.path("session");
    film(session, "corridor_survey", light.options);
    printPoint(light.name, mapFilm(session, light.stereo, no_rectification, true));
  }
});

const Section rectification_section("rectification", [] {
  const test::TemporaryFolder folder;
  const std::string session = folder.path("session");
  film(session, "corridor_survey", {});
  printSeriesHead("egomotion, rectification");
  const auto no_rectification = [](CompactMapping& mapping) {
    mapping.setRectify(false);
  };
  printPoint("ours, none", mapFilm(session, spacetime, no_rectification));
  printPoint("ours, ours", mapFilm(session, spacetime));
  printPoint("ours, paper's", mapFilm(session, spacetime, setPaperRectification));
  printPoint("paper's, none", mapFilm(session, spacetime, [&](CompactMapping& mapping) {
               setPaperEgomotion(mapping);
               no_rectification(mapping);
             }));
  printPoint("paper's, ours", mapFilm(session, spacetime, setPaperEgomotion));
  printPoint("paper's, paper's",
             mapFilm(session, spacetime, [](CompactMapping& mapping) {
               setPaperEgomotion(mapping);
               setPaperRectification(mapping);
             }));
});

/** \brief Each fourth view of a drive, with poses that turn a little more at each
 * step than the robot did, so that a straight corridor appears bent. */
ObservationSequence
bentDrive(const std::string& session, const SessionTruth& truth)
{
  constexpr std::size_t every = 4;
  constexpr double too_much = 0.75 * degree;
  const ObservationSequence all(observationPaths(session));
  std::vector<std::size_t> places;
  Trajectory poses;
  for (std::size_t i = 0; i < all.size() && places.size() < observations; i += every) {
    const Eigen::Isometry3d T_map_camera = truth.trajectory.poses[i];
    if (places.empty())
      poses.poses.push_back(T_map_camera);
    else {
      const Eigen::Isometry3d step =
          truth.trajectory.poses[places.back()].inverse() * T_map_camera;
      poses.poses.push_back(poses.poses.back() * step *
                            Eigen::AngleAxisd(too_much, Eigen::Vector3d::UnitY()));
    }
    poses.stamps.push_back(static_cast<double>(i));
    places.push_back(i);
  }
  return all.withPoses(places, poses);
}

/** \brief Maps of a drive with bent poses, over mu. */
void
printMu(const std::string& name, const std::string& scene)
{
  const test::TemporaryFolder folder;
  const std::string session = folder.path("session");
  test::runTool(ACMAP_SIMULATED_RIG, {"-o", session, "--scene", scene, "--clouds"})
      .succeeded();
  const SessionTruth truth = loadSessionTruth(session);
  const ObservationSequence drive = bentDrive(session, truth);
  printSeriesHead("rectification, mu");
  std::vector<Series> all = {{"guarded", {}}, {"paper's", {}}};
  for (Series& series : all)
    for (const double mu : {0.0, 0.05, 0.1, 0.2, 0.5, 1.0}) {
      const bool is_paper = series.name != "guarded";
      const PaperWayRun run =
          runPaperWay({"",
                       nullptr,
                       false,
                       [&](CompactMapping& mapping) {
                         CompactMapping::Rectification rectification =
                             mapping.getRectification();
                         rectification.setMode(is_paper ? RectificationMode::Paper
                                                        : RectificationMode::Guarded);
                         rectification.setProjectionWeight(mu);
                         mapping.setRectification(rectification);
                       }},
                      drive,
                      false,
                      max_raw_points,
                      true);
      add(series, mu, pointOf(run, truth));
    }
  draw(name, "mu", false, all);
}

const Section mu_section("mu", [] { printMu("mu", "corridor_drive"); });

const Section mu_bent_section("mu_bent",
                              [] { printMu("mu_bent", ACMAP_BENT_CORRIDOR); });

} // namespace
} // namespace pcl::acmap::bench
