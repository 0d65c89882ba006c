#include <pcl/core/cloud_fields.h>
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

PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return {points.data(), sizeof(Eigen::Vector3f), points.size()};
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
  Picture picture;
  if (width > 0 && width < points.size())
    picture.points = organized(points, width);
  else if ((picture.order = findPictureOrder(points)))
    picture.points =
        organized(viewOf(picture.order->arrange(points)), picture.order->width);
  if (picture.points &&
      DepthView::recognize(
          {&picture.points->front().x, sizeof(PointXYZ), picture.points->size()},
          picture.points->width))
    return picture;
  if (is_automatic)
    return std::nullopt;
  PCL_THROW_EXCEPTION(
      UnorganizedPointCloudException,
      "quantised depth and stereo need one organized view in its "
      "sensor's frame, z forward, with at least 1000 points, or what is "
      "left of one without its NaN pixels");
}

} // namespace acmap

bool
refineQuantisedDepth(PointCloud<PointXYZ>& view, DepthSensor sensor, unsigned threads)
{
  if (view.empty())
    return false;
  const std::optional<acmap::Picture> picture = acmap::pictureOf(
      {&view.front().x, sizeof(PointXYZ), view.size()}, view.width, sensor);
  if (!picture)
    return false;
  DepthRefinement<PointXYZ> refinement;
  refinement.setInputCloud(picture->points);
  refinement.setNumberOfThreads(threads);
  PointCloud<PointXYZ> refined;
  refinement.filter(refined);
  if (!picture->order)
    view.points = std::move(refined.points);
  else
    for (std::size_t i = 0; i < view.size(); ++i)
      if (const std::size_t pixel = picture->order->pixels[i];
          pixel != acmap::PictureOrder::nowhere)
        view[i] = refined[pixel];
  view.is_dense = false;
  return true;
}

std::shared_ptr<const PointCloudFile>
refineQuantisedDepth(const std::shared_ptr<const PointCloudFile>& observation,
                     DepthSensor sensor,
                     unsigned threads)
{
  if (!observation)
    throw BadArgumentException("the observation is a null pointer");
  const acmap::PointView points = observation->points();
  if (points.size() == 0)
    return observation;
  PointCloud<PointXYZ>::Ptr view = acmap::organized(points, observation->cloud.width);
  if (!refineQuantisedDepth(*view, sensor, threads))
    return observation;
  auto refined = std::make_shared<PointCloudFile>(*observation);
  PCLPointCloud2& cloud = refined->cloud;
  const std::size_t position = acmap::findField(cloud, "x")->offset;
  for (std::size_t i = 0; i < view->size(); ++i)
    std::memcpy(&cloud.data[i * cloud.point_step + position],
                (*view)[i].data,
                3 * sizeof(float));
  cloud.is_dense = 0;
  return refined;
}

} // namespace pcl
