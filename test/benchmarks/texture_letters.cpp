#include "bench.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/image_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/random.h>
#include <pcl/core/trajectory.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/texture/compact_map_folder.h>

#include <opencv2/imgproc.hpp>

#include <filesystem>
#include <iomanip>

namespace pcl::acmap::bench {
namespace {

constexpr char tesseract[] = "/usr/bin/tesseract";

const std::vector<std::string> lines = {
    "WORKSHOP 17", "KEEP THE DOOR SHUT", "MEETING AT NINE", "PHONE 40 52 86"};

/** A poster on a wall. Its pixels are half a millimetre. */
class Poster {
public:
  static constexpr double pixel = 0.0005; ///< metres
  static constexpr int width = 1100, height = 560;
  /** Of its top left corner, in the frame of the scene; the wall is at this depth. */
  const Eigen::Vector3d corner{-0.275, -0.14, 1.5};

  Poster()
  : image_(height, width, CV_8UC1, cv::Scalar(235))
  {
    constexpr int capitals = 50, step = 120; // pixels: letters of 25 mm
    constexpr int font = cv::FONT_HERSHEY_DUPLEX, thickness = 5;
    const double scale = cv::getFontScaleFromHeight(font, capitals, 1);
    for (std::size_t i = 0; i < lines.size(); ++i)
      cv::putText(image_,
                  lines[i],
                  {40, 100 + step * static_cast<int>(i)},
                  font,
                  scale,
                  cv::Scalar(25),
                  thickness,
                  cv::LINE_AA);
  }

  /** Level at a point of the wall; nothing beside the poster. */
  std::optional<double>
  levelAt(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d way = (point - corner) / pixel;
    const auto column = static_cast<int>(std::floor(way.x()));
    const auto row = static_cast<int>(std::floor(way.y()));
    if (std::abs(way.z()) > 1 || column < 0 || row < 0 || column >= width ||
        row >= height)
      return std::nullopt;
    return image_.at<std::uint8_t>(row, column);
  }

private:
  cv::Mat image_;
};

/** A corner of a room whose far wall has the poster, filmed from 1.5 m with a camera that moves
 * along it. */
SimulatedScene
sceneWithPoster()
{
  SimulatedScene scene;
  scene.name = "poster";
  const SurfaceLook plaster{{186, 184, 178}, 2}, boards{{98, 92, 84}, 4};
  const auto rectangle = [&](const char* name,
                             const Eigen::Vector3d& corner,
                             const Eigen::Vector3d& u,
                             const Eigen::Vector3d& v,
                             const SurfaceLook& look) {
    scene.geometry.addRectangle(name, name, {corner, u, v}, look);
  };
  rectangle("wall", {-2, 1.2, 1.5}, {4, 0, 0}, {0, -2.6, 0}, plaster);
  rectangle("floor", {-2, 1.2, -2}, {4, 0, 0}, {0, 0, 3.5}, boards);
  rectangle("left", {-2, 1.2, -2}, {0, 0, 3.5}, {0, -2.6, 0}, plaster);
  rectangle("right", {2, 1.2, 1.5}, {0, 0, -3.5}, {0, -2.6, 0}, plaster);
  for (int i = 0; i < 9; ++i) {
    Eigen::Isometry3d& view = scene.views.emplace_back(Eigen::Isometry3d::Identity());
    const double along = (i - 4) * 0.12;
    view.translation() = Eigen::Vector3d(along, 0.03 * (i % 3), 0);
    view.linear() =
        Eigen::AngleAxisd(-0.3 * along, Eigen::Vector3d::UnitY()).toRotationMatrix();
  }
  return scene;
}

/** Draws the poster into a view: each pixel gets the mean of what it sees, with the noise of a
 * camera. */
void
draw(const Poster& poster,
     const SimulatedScene& scene,
     std::size_t view,
     SimulatedObservation& observation)
{
  constexpr int samples = 4; // a side of a pixel
  constexpr double noise = 2;
  Random random(1 + view);
  const Eigen::Isometry3d& pose = scene.views[view];
  const auto meet = [&](double column, double row) -> Eigen::Vector3d {
    const Eigen::Vector3d ray =
        pose.linear() *
        Eigen::Vector3d((column - scene.rig.center_x) / scene.rig.focal_length,
                        (row - scene.rig.center_y) / scene.rig.focal_length,
                        1);
    return pose.translation() +
           (poster.corner.z() - pose.translation().z()) / ray.z() * ray;
  };
  for (int row = 0; row < observation.height; ++row)
    for (int column = 0; column < observation.width; ++column) {
      double sum = 0;
      bool is_inside = true;
      for (int s = 0; s < samples * samples && is_inside; ++s) {
        const auto level =
            poster.levelAt(meet(column + (s % samples + 0.5) / samples - 0.5,
                                row + (s / samples + 0.5) / samples - 0.5));
        is_inside = level.has_value();
        sum += level.value_or(0);
      }
      if (!is_inside)
        continue;
      const auto grey = static_cast<std::uint32_t>(std::lround(
          std::clamp(sum / (samples * samples) + noise * random.normal(), 0.0, 255.0)));
      observation.pixels[static_cast<std::size_t>(row * observation.width + column)]
          .rgb = grey << 16U | grey << 8U | grey;
    }
}

void
film(const std::string& folder)
{
  const Poster poster;
  const SimulatedScene scene = sceneWithPoster();
  std::filesystem::create_directories(folder);
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    SimulatedObservation observation = observe(scene, view, 1);
    draw(poster, scene, view, observation);
    std::ostringstream name;
    name << folder << "/observation_" << std::setw(4) << std::setfill('0') << view
         << ".pcd";
    savePointCloud(name.str(), cloudOf(observation));
  }
  saveTrajectory(folder + "/trajectory.txt", trajectoryOf(scene, scene.views.size()));
}

/** The poster as the map shows it, with some wall around it, a pixel a millimetre. */
RgbImage
posterIn(const CompactMap& map, const Eigen::Isometry3d& T_map_scene)
{
  constexpr double border = 0.03, step = 0.001; // metres
  const Poster poster;
  RgbImage image;
  image.width = static_cast<int>((Poster::width * Poster::pixel + 2 * border) / step);
  image.height = static_cast<int>((Poster::height * Poster::pixel + 2 * border) / step);
  image.values.assign(3 * static_cast<std::size_t>(image.width) *
                          static_cast<std::size_t>(image.height),
                      255);
  for (const TextureChart& chart : map.charts) {
    const Eigen::Vector3d normal = chart.texel_v.cross(chart.texel_u).normalized();
    const Eigen::Vector3d middle =
        T_map_scene * (poster.corner + Eigen::Vector3d(0.2, 0.1, 0));
    if (std::abs(normal.dot(middle - chart.origin)) > 0.05 ||
        std::abs(normal.dot(T_map_scene.linear().col(2))) < 0.9)
      continue;
    const cv::Mat texels(chart.colors.height,
                         chart.colors.width,
                         CV_8UC3,
                         const_cast<std::uint8_t*>(chart.colors.values.data()));
    cv::Mat x(image.height, image.width, CV_32FC1), y = x.clone();
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column) {
        const Eigen::Vector3d way =
            T_map_scene *
                (poster.corner +
                 Eigen::Vector3d(column * step - border, row * step - border, 0)) -
            chart.origin;
        x.at<float>(row, column) = static_cast<float>(
            way.dot(chart.texel_u) / chart.texel_u.squaredNorm() - 0.5);
        y.at<float>(row, column) = static_cast<float>(
            way.dot(chart.texel_v) / chart.texel_v.squaredNorm() - 0.5);
      }
    cv::Mat drawn(image.height, image.width, CV_8UC3, image.values.data());
    cv::remap(texels, drawn, x, y, cv::INTER_CUBIC, cv::BORDER_TRANSPARENT);
  }
  return image;
}

/** Changes, insertions and losses of characters between two texts. */
std::size_t
editsOf(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string
letters(const std::string& text)
{
  std::string kept;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)))
      kept += c;
  return kept;
}

void
printReading(const std::string& name, const std::vector<std::string>& options)
{
  const test::TemporaryFolder work;
  film(work.path("film"));
  std::vector<std::string> arguments = {
      work.path("film"), "-o", work.path("map"), "--no-pictures"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  test::runTool(ACMAP_COMPACT_MAPPING, arguments).succeeded();
  const CompactMap map = loadCompactMap(work.path("map"));
  const RgbImage image = posterIn(map, sceneWithPoster().views.front().inverse());
  const std::string file = work.path("poster.png");
  savePng(file, image);
  if (const char* const kept = std::getenv("ACMAP_KEEP_POSTER"))
    savePng(std::string(kept) + "/" + name + ".png", image);
  const std::string read =
      test::runTool(tesseract, {file, "stdout", "--psm", "6", "--dpi", "150"})
          .succeeded()
          .out;
  std::string truth;
  for (const std::string& line : lines)
    truth += letters(line);
  const std::size_t edits = editsOf(truth, letters(read));
  Row() << name << figure(milli * map.charts.at(0).texel_u.norm(), 1) << truth.size()
        << edits
        << atLeast(100 - percent(std::min(edits, truth.size()), truth.size()), 95, 1);
}

/** Letters of 25 mm, filmed from 1.5 m, read by tesseract. */
const Section letters_section("letters", [] {
  if (!std::filesystem::exists(tesseract)) {
    std::cerr << "left out: letters, there is no tesseract\n";
    return;
  }
  printHead("texture | texel, mm | letters and digits | errors | read, %");
  printReading("default", {});
  printReading("texels of 2 cm", {"--texel", "0.02"});
});

} // namespace
} // namespace pcl::acmap::bench
