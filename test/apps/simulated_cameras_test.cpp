#include "json_file.h"
#include "run_tool.h"
#include "simulated_runs.h"
#include "temporary_folder.h"

#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trajectory.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr const char* built_rig = ACMAP_SHARE "/rigs/digiclops_built.yaml";

/** A slanted wall and a box in front of it, filmed from two positions in different
 * directions. */
constexpr const char* painted_room = R"(name: room
looks:
  wall: {color: [150, 140, 130], texture: 2}
surfaces:
  - rectangle: {name: wall, corner: [-9, 9, 2], edges: [[18, 0, 1], [0, -18, 0]], look: wall}
  - box: {name: box, least: [-0.4, -0.4, 1.6], most: [0.4, 0.4, 2], look: wall}
path:
  - line: {from: [-0.2, 0, -0.2], to: [-0.1, 0.1, 0], views: 2, yaw: [8, -10]}
)";

const std::vector<std::string> noiseless = {
    "--read-noise", "0", "--shot-noise", "0", "--patterns", "6"};

/** \brief Index of a channel of a pixel. */
std::size_t
indexOf(const CameraImage& image, int column, int row, int channel)
{
  return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(column)) +
         static_cast<std::size_t>(channel);
}

double
medianOf(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/** \brief Compares rectified shots with disparities: finds the shift of a neighbour's
 * image for which a small window fits best, in all shots together. */
class WindowSearch {
public:
  /** \param[in] disparities px, of the reference
   * \param[in] step displacement in the neighbour for 1 px of disparity */
  WindowSearch(const std::vector<TrinocularFrame>& shots,
               const DisparityImage& disparities,
               RigCamera neighbour,
               const Eigen::Vector2d& step)
  : shots_(shots)
  , disparities_(disparities)
  , neighbour_(neighbour)
  , step_(step)
  {}

  /** \return px along the step */
  double
  offset(int column, int row) const
  {
    constexpr int tries = 40;
    constexpr double farthest = 2.0; // px
    double best = 0;
    double minimum =
        difference(column, row, 0, std::numeric_limits<double>::infinity());
    for (int i = 1; i <= tries; ++i)
      for (const double at : {farthest * i / tries, -farthest * i / tries})
        if (const double off = difference(column, row, at, minimum); off < minimum) {
          minimum = off;
          best = at;
        }
    return best;
  }

  /** \brief Is all of a window on one surface? */
  bool
  isSmooth(int column, int row) const
  {
    const float here = disparities_.at(column, row);
    for (int y = row - 2 * reach; y <= row + 2 * reach; y += reach)
      for (int x = column - 2 * reach; x <= column + 2 * reach; x += reach)
        if (!(std::abs(disparities_.at(x, y) - here) < 0.5f))
          return false;
    return true;
  }

private:
  static constexpr int reach = 6; // px

  /** \param[in] maximum at which the sum over the window may end */
  double
  difference(int column, int row, double offset, double maximum) const
  {
    const Eigen::Vector2d shift = offset * step_.normalized();
    double sum = 0;
    for (int y = row - reach; y <= row + reach && sum < maximum; ++y)
      for (int x = column - reach; x <= column + reach; ++x) {
        const Eigen::Vector2d there =
            Eigen::Vector2d(x, y) + double(disparities_.at(x, y)) * step_ + shift;
        for (const TrinocularFrame& shot : shots_)
          sum += difference(shot, x, y, there);
      }
    return sum;
  }

  double
  difference(const TrinocularFrame& shot,
             int column,
             int row,
             const Eigen::Vector2d& there) const
  {
    const CameraImage& reference = shot.image(RigCamera::Reference);
    double sum = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const double off = value(shot.image(neighbour_), there, channel) -
                         reference.values[indexOf(reference, column, row, channel)];
      sum += off * off;
    }
    return sum;
  }

  /** \brief Bilinear interpolation. */
  static double
  value(const CameraImage& image, const Eigen::Vector2d& at, int channel)
  {
    const int column = static_cast<int>(std::floor(at.x()));
    const int row = static_cast<int>(std::floor(at.y()));
    const double right = at.x() - column;
    const double below = at.y() - row;
    const auto of = [&](int x, int y) {
      return double(image.values[indexOf(image,
                                         std::min(x, image.width - 1),
                                         std::min(y, image.height - 1),
                                         channel)]);
    };
    return (1 - below) * ((1 - right) * of(column, row) + right * of(column + 1, row)) +
           below *
               ((1 - right) * of(column, row + 1) + right * of(column + 1, row + 1));
  }

  const std::vector<TrinocularFrame>& shots_;
  const DisparityImage& disparities_;
  RigCamera neighbour_;
  Eigen::Vector2d step_;
};

class SimulatedCameras : public testing::Test {
protected:
  /** \brief Films a scene into a folder. */
  ToolRun
  film(const std::string& scene,
       const std::string& session,
       const std::vector<std::string>& more) const
  {
    return runTool(
        ACMAP_SIMULATED_RIG,
        joined(
            {"-o", folder_.path(session), "--scene", folder_.write("room.yaml", scene)},
            more));
  }

  /** \brief Links the room, filmed with the unrectified cameras without noise; once for
   * all tests, which only read it. */
  void
  filmRaw() const
  {
    static const TemporaryFolder kept;
    const std::string session = kept.path("raw");
    if (!std::filesystem::exists(session)) {
      std::vector<std::string> all = noiseless;
      all.insert(all.end(), {"--cameras", built_rig});
      const ToolRun run = film(painted_room, "filmed", all).succeeded();
      ASSERT_EQ(run.err, "");
      std::filesystem::rename(folder_.path("filmed"), session);
    }
    std::filesystem::create_directory_symlink(session, folder_.path("raw"));
  }

  std::vector<TrinocularFrame>
  rectified(const std::string& session) const
  {
    TrinocularRectification rectification;
    rectification.setInputCalibration(
        loadRigCalibration(folder_.path(session + "/rig.yaml")));
    std::vector<TrinocularFrame> frames;
    for (const TrinocularFrame::ConstPtr& frame : framesOf(folder_.path(session)))
      rectification.rectify(*frame, frames.emplace_back());
    return frames;
  }

  void
  expectRefused(const ToolRun& run, int exit_code, const std::string& word) const
  {
    test::expectRefused(run, exit_code, word);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("session")));
  }

  TemporaryFolder folder_;
};

TEST_F(SimulatedCameras, ShippedRigIsOfOnePiece)
{
  TrinocularRectification rectification;
  rectification.setInputCalibration(loadRigCalibration(built_rig));
  const std::string again = folder_.path("again.yaml");
  saveTrinocularRig(again, rectification.getRig());
  const std::string rectified = folder_.path("rectified.yaml");
  saveTrinocularRig(rectified, loadTrinocularRig(built_rig));
  EXPECT_EQ(contentOf(again), contentOf(rectified));
  EXPECT_TRUE(rectification.getReport().remarks.empty());
}

TEST_F(SimulatedCameras, SessionHoldsRigAndCameras)
{
  filmRaw();
  saveRigCalibration(folder_.path("expected.yaml"),
                     loadTrinocularRig(built_rig),
                     loadRigCalibration(built_rig));
  EXPECT_EQ(contentOf(folder_.path("raw/rig.yaml")),
            contentOf(folder_.path("expected.yaml")));
}

TEST_F(SimulatedCameras, RectifiedFramesAreThoseOfTheRectifiedRig)
{
  filmRaw();
  saveTrinocularRig(folder_.path("rig.yaml"), loadTrinocularRig(built_rig));
  std::string rig = "rig:\n";
  std::istringstream lines(contentOf(folder_.path("rig.yaml")));
  for (std::string line; std::getline(lines, line);)
    if (line.find(": ") != std::string::npos)
      rig += "  " + line + "\n";
  film(rig + painted_room, "ideal", noiseless).succeeded();

  for (const char* name : {"disparity_0000.pfm",
                           "disparity_0001.pfm",
                           "visible_0001.png",
                           "trajectory.txt"})
    EXPECT_EQ(contentOf(folder_.path(std::string("raw/") + name)),
              contentOf(folder_.path(std::string("ideal/") + name)))
        << name;
  const auto told = [&](const char* session) {
    return jsonOfFile(folder_.path(std::string(session) + "/truth.json"));
  };
  EXPECT_EQ(told("raw")["planes"], told("ideal")["planes"]);
  EXPECT_EQ(told("raw")["frames"], "raw");
  EXPECT_EQ(told("ideal")["frames"], "rectified");
  const std::vector<TrinocularFrame> frames = rectified("raw");
  const auto ideal = framesOf(folder_.path("ideal"));
  ASSERT_EQ(frames.size(), 14u);
  ASSERT_EQ(ideal.size(), 14u);
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t camera = 0; camera < 3; ++camera) {
      std::vector<double> off;
      double sum = 0;
      const CameraImage& image = ideal[i]->images[camera];
      for (std::size_t k = 0; k < image.values.size(); ++k) {
        off.push_back(std::abs(frames[i].images[camera].values[k] - image.values[k]));
        sum += off.back();
      }
      EXPECT_LE(medianOf(off), 1.0) << i << " " << camera;
      EXPECT_LE(sum / static_cast<double>(off.size()), 2.0) << i << " " << camera;
    }
}

/** \brief Does not use the simulation's own model of a rectified camera. */
TEST_F(SimulatedCameras, TrueDisparitiesAreFoundInTheFrames)
{
  filmRaw();
  const TrinocularRig rig = loadTrinocularRig(folder_.path("raw/rig.yaml"));
  const Eigen::Vector2d right = Eigen::Vector2d::UnitX();
  const Eigen::Vector2d down =
      rig.baseline_vertical / rig.baseline_horizontal * Eigen::Vector2d::UnitY();
  const std::vector<TrinocularFrame> frames = rectified("raw");
  ASSERT_EQ(frames.size(), 14u);
  for (const int observation : {0, 1}) {
    const std::string number = std::to_string(observation);
    const DisparityImage truth =
        loadPfm(folder_.path("raw/disparity_000" + number + ".pfm"));
    const GrayImage16 visible =
        loadGrayImage16(folder_.path("raw/visible_000" + number + ".png"));
    const auto first = frames.begin() + 7 * observation;
    const std::vector<TrinocularFrame> shots(first + 1, first + 7);
    for (const RigCamera neighbour : {RigCamera::Horizontal, RigCamera::Vertical}) {
      const bool in_row = neighbour == RigCamera::Horizontal;
      const WindowSearch search(shots, truth, neighbour, in_row ? right : down);
      std::vector<double> offsets;
      std::vector<double> distances;
      for (int row = 40; row < rig.height - 60; row += 40)
        for (int column = 40; column < rig.width - 60; column += 40)
          if (visible.values[static_cast<std::size_t>(row * rig.width + column)] == 7 &&
              search.isSmooth(column, row)) {
            offsets.push_back(search.offset(column, row));
            distances.push_back(std::abs(offsets.back()));
          }
      ASSERT_GT(offsets.size(), 80u);
      std::sort(distances.begin(), distances.end());
      EXPECT_LE(std::abs(medianOf(offsets)), 0.05);
      EXPECT_LE(distances[distances.size() * 9 / 10], 0.1);
    }
  }
}

TEST_F(SimulatedCameras, CamerasThatCannotBeAreRefused)
{
  const auto refused = [&](const std::string& rig, int exit_code, const char* word) {
    expectRefused(film(painted_room, "session", {"--cameras", rig, "--patterns", "1"}),
                  exit_code,
                  word);
  };
  const std::string text = contentOf(built_rig);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    const std::size_t at = other.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    other.replace(at, from.size(), to);
    return folder_.write("cameras.yaml", other);
  };
  refused(folder_.path("none.yaml"), 3, "none.yaml");
  refused(folder_.write("empty.yaml", ""), 3, "empty.yaml");
  saveTrinocularRig(folder_.path("rectified.yaml"), TrinocularRig());
  refused(folder_.path("rectified.yaml"), 3, "has no 'camera_reference'");
  refused(changed("519.6, 0,", ".nan, 0,"), 3, "cameras.yaml:");
  refused(changed("-0.201, 0.064", "-90, 0.064"), 3, "no inverse");
  refused(changed("-0.1002,", "0.1e-8,"), 3, "cameras.yaml:");
  refused(changed("height: 480", "height: 32768"), 3, "cameras.yaml:");
  refused(changed("width: 640\nheight: 480", "width: 32768\nheight: 32768"), 6, "GB");
}

} // namespace
} // namespace pcl::acmap::test
