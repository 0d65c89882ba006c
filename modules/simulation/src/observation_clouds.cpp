#include <pcl/simulation/simulated_observation.h>

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace pcl {

namespace {

// Points are copied to a cloud without conversion.
static_assert(sizeof(ObservationPixel) == 24 &&
              std::is_trivially_copyable_v<ObservationPixel>);

struct MergedPoint {
  float x, y, z;
  std::uint32_t rgb;
  std::int32_t view;
  std::uint32_t label;
};

/** \brief An \ref ObservationPixel of a sensor that does not report its noise. */
struct PlainPixel {
  float x, y, z;
  std::uint32_t rgb;
  std::uint32_t label;
};

PCLPointField
field(const char* name, std::size_t offset, std::uint8_t datatype)
{
  PCLPointField made;
  made.name = name;
  made.offset = static_cast<uindex_t>(offset);
  made.datatype = datatype;
  made.count = 1;
  return made;
}

template <typename Point>
PCLPointCloud2
emptyCloud(std::size_t width, std::size_t height)
{
  PCLPointCloud2 cloud;
  cloud.width = static_cast<uindex_t>(width);
  cloud.height = static_cast<uindex_t>(height);
  cloud.point_step = sizeof(Point);
  cloud.row_step = static_cast<uindex_t>(width * sizeof(Point));
  cloud.fields = {field("x", offsetof(Point, x), PCLPointField::FLOAT32),
                  field("y", offsetof(Point, y), PCLPointField::FLOAT32),
                  field("z", offsetof(Point, z), PCLPointField::FLOAT32),
                  field("rgb", offsetof(Point, rgb), PCLPointField::FLOAT32)};
  return cloud;
}

PCLPointCloud2
cloudWithoutSigma(const SimulatedObservation& observation)
{
  auto cloud = emptyCloud<PlainPixel>(static_cast<std::size_t>(observation.width),
                                      static_cast<std::size_t>(observation.height));
  cloud.fields.push_back(
      field("label", offsetof(PlainPixel, label), PCLPointField::UINT32));
  cloud.is_dense = observation.points == observation.pixels.size() ? 1 : 0;
  cloud.data.resize(observation.pixels.size() * sizeof(PlainPixel));
  std::uint8_t* to = cloud.data.data();
  for (const ObservationPixel& pixel : observation.pixels) {
    const PlainPixel plain{pixel.x, pixel.y, pixel.z, pixel.rgb, pixel.label};
    std::memcpy(to, &plain, sizeof(plain));
    to += sizeof(plain);
  }
  return cloud;
}

} // namespace

PCLPointCloud2
cloudOf(const SimulatedObservation& observation)
{
  if (!observation.has_sigma)
    return cloudWithoutSigma(observation);
  using Pixel = ObservationPixel;
  auto cloud = emptyCloud<Pixel>(static_cast<std::size_t>(observation.width),
                                 static_cast<std::size_t>(observation.height));
  cloud.fields.push_back(
      field("sigma", offsetof(Pixel, sigma), PCLPointField::FLOAT32));
  cloud.fields.push_back(field("label", offsetof(Pixel, label), PCLPointField::UINT32));
  cloud.is_dense = observation.points == observation.pixels.size() ? 1 : 0;
  const auto* const bytes =
      reinterpret_cast<const std::uint8_t*>(observation.pixels.data());
  cloud.data.assign(bytes, bytes + observation.pixels.size() * sizeof(Pixel));
  return cloud;
}

PCLPointCloud2
cloudOf(const MergedObservations& merged)
{
  auto cloud = emptyCloud<MergedPoint>(merged.points.size(), 1);
  cloud.fields.push_back(
      field("view", offsetof(MergedPoint, view), PCLPointField::INT32));
  cloud.fields.push_back(
      field("label", offsetof(MergedPoint, label), PCLPointField::UINT32));
  cloud.is_dense = 1;
  cloud.data.resize(merged.points.size() * sizeof(MergedPoint));
  std::uint8_t* to = cloud.data.data();
  for (std::size_t i = 0; i < merged.points.size(); ++i, to += sizeof(MergedPoint)) {
    const Eigen::Vector3f& p = merged.points[i];
    const MergedPoint point{
        p.x(), p.y(), p.z(), merged.rgb[i], merged.view[i], merged.label[i]};
    std::memcpy(to, &point, sizeof(point));
  }
  return cloud;
}

} // namespace pcl
