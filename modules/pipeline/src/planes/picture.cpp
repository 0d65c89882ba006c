#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/filters/impl/depth_refinement_kernel.h>
#include <pcl/pipeline/picture.h>

#include <cstring>
#include <utility>

namespace pcl {

namespace acmap {
namespace {

/** \param[in] step of the depths of the points, see \ref measureDepthStep */
std::optional<Picture>
recognize(const PointView& points, std::size_t width, double step)
{
  const std::optional<PictureView> picture = PictureView::find(points, width);
  if (!picture)
    return std::nullopt;
  std::optional<DepthView> view =
      DepthView::recognize(picture->points(), picture->width());
  if (!view)
    return std::nullopt;
  const NoiseScale::InverseDepth noise = measureInverseDepthNoise(
      *view, picture->order() ? measureDepthStep(picture->points()) : step);
  return Picture{{std::move(*view), noise}, picture->order()};
}

bool
isInSpace(DepthSensor sensor)
{
  return sensor == DepthSensor::TimeOfFlight || sensor == DepthSensor::Laser;
}

std::optional<Picture>
pictureWithStep(const PointView& points,
                std::size_t width,
                DepthSensor sensor,
                double step)
{
  const bool is_automatic = sensor == DepthSensor::Automatic;
  if (is_automatic && step == 0)
    return std::nullopt;
  std::optional<Picture> picture = recognize(points, width, step);
  if (picture || is_automatic)
    return picture;
  throw acmap::Unorganized(
      "quantised depth and stereo need one organized view in its "
      "sensor's frame, z forward, with at least 1000 points, or what is "
      "left of one without its NaN pixels");
}

} // namespace

std::optional<Picture>
pictureOf(const PointView& points, std::size_t width, DepthSensor sensor)
{
  if (isInSpace(sensor))
    return std::nullopt;
  return pictureWithStep(points, width, sensor, measureDepthStep(points));
}

std::optional<Picture>
planePictureOf(const PointView& points, std::size_t width, DepthSensor sensor)
{
  if (isInSpace(sensor))
    return std::nullopt;
  const double step = measureDepthStep(points);
  const bool is_organized = width > 1 && width < points.size();
  if (sensor != DepthSensor::Automatic || step > 0 || !is_organized)
    return pictureWithStep(points, width, sensor, step);
  std::optional<Picture> picture = recognize(points, width, step);
  if (picture && !picture->seen.noise.isIndependent())
    picture.reset();
  return picture;
}

} // namespace acmap

namespace {

/** Calls move (index, refined point) for each point of a view that has a pixel.
 * \return false if the view is not to be refined */
template <typename Move>
bool
refineView(const acmap::PointView& points,
           std::size_t width,
           DepthSensor sensor,
           unsigned threads,
           const Move& move)
{
  const std::optional<acmap::Picture> picture =
      points.size() > 0 ? acmap::pictureOf(points, width, sensor) : std::nullopt;
  if (!picture)
    return false;
  DepthRefinementReport report;
  const acmap::RefinedDepth refined = acmap::refineDepth(picture->seen.view,
                                                         picture->seen.noise,
                                                         nullptr,
                                                         threads,
                                                         acmap::Progress(),
                                                         report);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t pixel = picture->order ? picture->order->pixels[i] : i;
    if (pixel != acmap::PictureOrder::nowhere)
      move(i, refined.points[pixel]);
  }
  return true;
}

} // namespace

bool
refineQuantisedDepth(PointCloud<PointXYZ>& view, DepthSensor sensor, unsigned threads)
{
  const acmap::PointView points(
      view.empty() ? nullptr : &view.front().x, sizeof(PointXYZ), view.size());
  const bool is_refined = refineView(points,
                                     view.width,
                                     sensor,
                                     threads,
                                     [&](std::size_t i, const Eigen::Vector3f& point) {
                                       view[i].getVector3fMap() = point;
                                     });
  view.is_dense = view.is_dense && !is_refined;
  return is_refined;
}

std::shared_ptr<const PointCloudFile>
refineQuantisedDepth(const std::shared_ptr<const PointCloudFile>& observation,
                     DepthSensor sensor,
                     unsigned threads)
{
  acmap::requireGiven<acmap::BadArgument>(observation);
  std::shared_ptr<PointCloudFile> refined; // copied only if there is something to move
  std::size_t position = 0;
  const auto move = [&](std::size_t i, const Eigen::Vector3f& point) {
    if (!refined) {
      refined = std::make_shared<PointCloudFile>(*observation);
      refined->cloud.is_dense = 0;
      position = acmap::findField(refined->cloud, "x")->offset;
    }
    std::memcpy(&refined->cloud.data[i * refined->cloud.point_step + position],
                point.data(),
                3 * sizeof(float));
  };
  if (!refineView(
          observation->points(), observation->cloud.width, sensor, threads, move))
    return observation;
  return refined;
}

} // namespace pcl
