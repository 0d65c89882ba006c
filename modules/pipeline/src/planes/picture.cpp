#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/pipeline/picture.h>

#include <cstring>

namespace pcl {

namespace acmap {
namespace {

PointCloud<PointXYZ>::Ptr
organized(const PointView& points, std::size_t width)
{
  PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
  cloud->resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    (*cloud)[i].getVector3fMap() = points[i];
  cloud->width = static_cast<std::uint32_t>(width);
  cloud->height = static_cast<std::uint32_t>(points.size() / width);
  cloud->is_dense = false;
  return cloud;
}

} // namespace

std::optional<Picture>
pictureOf(const PointView& points, std::size_t width, DepthSensor sensor)
{
  if (sensor == DepthSensor::TimeOfFlight || sensor == DepthSensor::Laser)
    return std::nullopt;
  const bool is_automatic = sensor == DepthSensor::Automatic;
  if (is_automatic && measureDepthStep(points) == 0)
    return std::nullopt;
  const std::optional<PictureView> view = PictureView::find(points, width);
  if (view && DepthView::recognize(view->points(), view->width()))
    return Picture{organized(view->points(), view->width()), view->order()};
  if (is_automatic)
    return std::nullopt;
  throw acmap::Unorganized(
      "quantised depth and stereo need one organized view in its "
      "sensor's frame, z forward, with at least 1000 points, or what is "
      "left of one without its NaN pixels");
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
  DepthRefinement<PointXYZ> refinement;
  refinement.setInputCloud(picture->points);
  refinement.setNumberOfThreads(threads);
  PointCloud<PointXYZ> refined;
  refinement.filter(refined);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t pixel = picture->order ? picture->order->pixels[i] : i;
    if (pixel != acmap::PictureOrder::nowhere)
      move(i, refined[pixel]);
  }
  return true;
}

} // namespace

bool
refineQuantisedDepth(PointCloud<PointXYZ>& view, DepthSensor sensor, unsigned threads)
{
  const acmap::PointView points(
      view.empty() ? nullptr : &view.front().x, sizeof(PointXYZ), view.size());
  const bool is_refined = refineView(
      points, view.width, sensor, threads, [&](std::size_t i, const PointXYZ& point) {
        view[i] = point;
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
  const auto move = [&](std::size_t i, const PointXYZ& point) {
    if (!refined) {
      refined = std::make_shared<PointCloudFile>(*observation);
      refined->cloud.is_dense = 0;
      position = acmap::findField(refined->cloud, "x")->offset;
    }
    std::memcpy(&refined->cloud.data[i * refined->cloud.point_step + position],
                point.data,
                3 * sizeof(float));
  };
  if (!refineView(
          observation->points(), observation->cloud.width, sensor, threads, move))
    return observation;
  return refined;
}

} // namespace pcl
