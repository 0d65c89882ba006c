#include "depth_stage.h"

#include "cloud_fields.h"
#include "command_line.h"
#include "stage_reports.h"

#include <pcl/filters/depth_refinement_kernel.h>

#include <array>

namespace pcl::acmap {

namespace {

void
setPlaces(PCLPointCloud2& cloud, const std::vector<Eigen::Vector3f>& points)
{
  const std::size_t place = findField(cloud, "x")->offset;
  for (std::size_t i = 0; i < points.size(); ++i)
    std::memcpy(&cloud.data[i * cloud.point_step + place], points[i].data(), 12);
  cloud.is_dense = 0;
}

void
setNormals(PCLPointCloud2& cloud, const std::vector<Eigen::Vector3f>& normals)
{
  constexpr std::array<const char*, 3> names = {"normal_x", "normal_y", "normal_z"};
  std::vector<FieldWish> wishes;
  for (const char* name : names)
    wishes.push_back({name, PCLPointField::FLOAT32});
  const std::uint32_t width = cloud.width, height = cloud.height;
  cloud = withFields(std::move(cloud), wishes);
  cloud.width = width;
  cloud.height = height;
  cloud.row_step = width * cloud.point_step;
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    const std::size_t offset = findField(cloud, names[axis])->offset;
    for (std::size_t i = 0; i < normals.size(); ++i)
      setValue(cloud, i, offset, normals[i][static_cast<Eigen::Index>(axis)]);
  }
}

} // namespace

void
addSensor(Tool& tool, DepthSensor& sensor)
{
  addChoice<DepthSensor>(
      tool.options(),
      "--sensor",
      sensor,
      {{"auto", DepthSensor::Automatic},
       {"quantised", DepthSensor::Quantised},
       {"stereo", DepthSensor::Stereo},
       {"tof", DepthSensor::TimeOfFlight},
       {"laser", DepthSensor::Laser}},
      "What measured an organized cloud: quantised (structured light, as a Kinect) and "
      "stereo have noise that is even in inverse depth, and are worked on in their "
      "picture; tof and laser in space; auto: quantised where the depths have such "
      "steps");
}

namespace {

std::optional<MeasuredView>
viewOfPoints(const PointView& points, std::size_t width, DepthSensor sensor)
{
  if (sensor == DepthSensor::TimeOfFlight || sensor == DepthSensor::Laser)
    return std::nullopt;
  const bool is_automatic = sensor == DepthSensor::Automatic;
  const bool is_organized = width > 0 && width < points.size();
  const double step = measureDepthStep(points);
  if (is_automatic && (step == 0 || !is_organized))
    return std::nullopt;
  std::optional<DepthView> view =
      is_organized ? DepthView::recognize(points, width) : std::nullopt;
  if (!view) {
    if (is_automatic)
      return std::nullopt;
    throw UsageError("--sensor quantised and stereo are for one organized view in its "
                     "sensor's frame, with at least 1000 points: rows of pixels, z "
                     "forward; leave --sensor out for this cloud");
  }
  const NoiseScale::InverseDepth noise = measureInverseDepthNoise(*view, step);
  return MeasuredView{std::move(*view), noise};
}

} // namespace

std::optional<MeasuredView>
viewOfFile(const PointCloudFile& file, DepthSensor sensor)
{
  return viewOfPoints(file.points(), file.cloud.width, sensor);
}

void
tellDepthNoise(Tool& tool, const MeasuredView& measured)
{
  const NoiseScale::InverseDepth& noise = measured.noise;
  tool.details()["depth"] = {{"step", noise.step},
                             {"independent_sigma", noise.independent},
                             {"correlated_sigma", noise.correlated},
                             {"sigma", noise.sigma()}};
  const auto at = [](double inverse_depth, double depth) {
    return shortNumber(1000 * inverse_depth * depth * depth) + " mm";
  };
  tool.tell("depth",
            (noise.step > 0 ? "quantised, steps of " + at(noise.step, 2) + " at 2 m, " +
                                  at(noise.step, 4) + " at 4 m"
                            : std::string("not quantised")) +
                "; noise " + at(noise.sigma(), 2) + " at 2 m, " + at(noise.sigma(), 4) +
                " at 4 m");
}

void
refineInput(Tool& tool,
            const MeasuredView& measured,
            const DepthPlanes* known,
            PointCloudFile& file)
{
  DepthRefinementReport report;
  RefinedDepth refined;
  tool.withProgress([&](const ProgressCallback& progress) {
    refined = refineDepth(measured.view,
                          measured.noise,
                          known,
                          tool.threads(),
                          Progress(progress),
                          report);
  });
  setPlaces(file.cloud, refined.points);
  setNormals(file.cloud, refined.normals);
  tool.details()["refinement"] = {{"points", report.points},
                                  {"invalid_points", report.invalid_points},
                                  {"on_planes", report.on_planes},
                                  {"smoothed", report.smoothed},
                                  {"withdrawn", report.withdrawn},
                                  {"planes", report.planes},
                                  {"seconds", secondsOf(report)}};
  const std::size_t measured_points = report.points - report.invalid_points;
  tool.tell("refined",
            percent(report.on_planes, measured_points) + " of the points onto " +
                std::to_string(report.planes) + " planes, " +
                percent(report.smoothed, measured_points) +
                " onto their neighbourhood");
}

bool
refineIfQuantised(std::vector<Eigen::Vector3f>& points,
                  std::size_t width,
                  DepthSensor sensor,
                  unsigned threads)
{
  const std::optional<MeasuredView> measured = viewOfPoints(
      {points.data(), sizeof(Eigen::Vector3f), points.size()}, width, sensor);
  if (!measured)
    return false;
  DepthRefinementReport report;
  points =
      refineDepth(measured->view, measured->noise, nullptr, threads, Progress(), report)
          .points;
  return true;
}

bool
refineIfQuantised(PointCloudFile& file, DepthSensor sensor, unsigned threads)
{
  std::vector<Eigen::Vector3f> points;
  const PointView view = file.points();
  for (std::size_t i = 0; i < view.size(); ++i)
    points.push_back(view[i]);
  if (!refineIfQuantised(points, file.cloud.width, sensor, threads))
    return false;
  setPlaces(file.cloud, points);
  return true;
}

} // namespace pcl::acmap
