#include "depth_stage.h"

#include "command_line.h"
#include "stage_reports.h"

#include <pcl/core/cloud_fields.h>
#include <pcl/filters/depth_refinement_kernel.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cstring>
#include <limits>

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
  if (is_automatic && step == 0)
    return std::nullopt;
  std::optional<PictureOrder> order;
  std::optional<DepthView> view;
  if (is_organized)
    view = DepthView::recognize(points, width);
  else if ((order = findPictureOrder(points))) {
    const std::vector<Eigen::Vector3f> arranged = order->arrange(points);
    view = DepthView::recognize({arranged.data(), sizeof arranged[0], arranged.size()},
                                order->width);
  }
  if (!view) {
    if (is_automatic)
      return std::nullopt;
    throw UsageError(
        "--sensor quantised and stereo are for one organized view in its "
        "sensor's frame, z forward, with at least 1000 points, or for what "
        "is left of one without its NaN pixels; leave --sensor out for this "
        "cloud");
  }
  const NoiseScale::InverseDepth noise = measureInverseDepthNoise(*view, step);
  return MeasuredView{std::move(*view), noise, std::move(order)};
}

/** Makes an organized cloud of the points of a view; pixels without one are NaN. */
PCLPointCloud2
arrangedCloud(const PCLPointCloud2& cloud, const PictureOrder& order)
{
  PCLPointCloud2 arranged = cloud;
  arranged.width = static_cast<std::uint32_t>(order.width);
  arranged.height = static_cast<std::uint32_t>(order.height);
  arranged.row_step = arranged.width * cloud.point_step;
  arranged.data.assign(order.width * order.height * cloud.point_step, 0);
  const std::size_t place = findField(cloud, "x")->offset;
  const Eigen::Vector3f none =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t pixel = 0; pixel < order.width * order.height; ++pixel)
    std::memcpy(&arranged.data[pixel * cloud.point_step + place], none.data(), 12);
  for (std::size_t i = 0; i < order.pixels.size(); ++i)
    if (order.pixels[i] != PictureOrder::nowhere)
      std::memcpy(&arranged.data[order.pixels[i] * cloud.point_step],
                  &cloud.data[i * cloud.point_step],
                  cloud.point_step);
  arranged.is_dense = 0;
  return arranged;
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
  if (measured.order)
    file.cloud = arrangedCloud(file.cloud, *measured.order);
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
  std::vector<Eigen::Vector3f> refined =
      refineDepth(measured->view, measured->noise, nullptr, threads, Progress(), report)
          .points;
  if (!measured->order) {
    points = std::move(refined);
    return true;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (measured->order->pixels[i] != PictureOrder::nowhere)
      points[i] = refined[measured->order->pixels[i]];
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
