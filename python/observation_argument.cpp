#include "observation_argument.h"

#include <pcl/core/impl/cloud_fields.h>

#include <cstring>

namespace pcl::acmap::python {

namespace {

/** An array with three values per pixel. */
py::array
pixelsOf(const std::string& name, const py::handle& argument, const py::dtype& type)
{
  const std::string shape = "(h, w, 3)";
  py::array pixels = arrayOf(name, argument, type, {3}, shape);
  if (pixels.shape(2) != 3)
    refuseShape(name, pixels, shape);
  return pixels;
}

void
requireSameSize(const py::array& points, const py::array& colors)
{
  if (points.shape(0) != colors.shape(0) || points.shape(1) != colors.shape(1))
    refuseShape("colors", colors, py::str(points.attr("shape")));
}

/** A view is organized, which one row or column of points is not. */
void
requireRowsAndColumns(const py::array& points)
{
  const py::ssize_t height = points.shape(0), width = points.shape(1);
  if (height < 2 || width < 2)
    refuseShape("points", points, "(h, w, 3) with two or more rows and columns");
  requireCountable("points",
                   static_cast<std::size_t>(height) * static_cast<std::size_t>(width));
}

PCLPointCloud2
organizedCloud(py::ssize_t height, py::ssize_t width)
{
  PCLPointCloud2 cloud = layoutWith(PCLPointCloud2(),
                                    {{"x", PCLPointField::FLOAT32},
                                     {"y", PCLPointField::FLOAT32},
                                     {"z", PCLPointField::FLOAT32},
                                     {"rgb", PCLPointField::FLOAT32}});
  resizeRows(cloud, static_cast<std::size_t>(height) * static_cast<std::size_t>(width));
  cloud.height = static_cast<std::uint32_t>(height);
  cloud.width = static_cast<std::uint32_t>(width);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = 0;
  return cloud;
}

/** Copies a channel of all pixels to the bytes at an offset in the points. */
void
copyChannel(const py::array& pixels,
            int channel,
            PCLPointCloud2& cloud,
            std::size_t offset)
{
  const auto bytes = static_cast<std::size_t>(pixels.itemsize());
  const py::ssize_t row_step = pixels.strides(0), column_step = pixels.strides(1);
  const char* const first =
      static_cast<const char*>(pixels.data()) + channel * pixels.strides(2);
  std::size_t place = offset;
  for (py::ssize_t row = 0; row < pixels.shape(0); ++row)
    for (py::ssize_t column = 0; column < pixels.shape(1); ++column) {
      std::memcpy(
          &cloud.data[place], first + row * row_step + column * column_step, bytes);
      place += cloud.point_step;
    }
}

} // namespace

std::shared_ptr<const PointCloudFile>
observationOf(const ViewArgument& points, const ColorArgument& colors)
{
  const py::array places = pixelsOf("points", points, py::dtype::of<float>());
  const py::array shades = pixelsOf("colors", colors, py::dtype::of<std::uint8_t>());
  requireRowsAndColumns(places);
  requireSameSize(places, shades);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = organizedCloud(places.shape(0), places.shape(1));
  const std::size_t rgb = findColor(file->cloud)->offset;
  for (int channel = 0; channel < 3; ++channel) {
    const auto place = static_cast<std::size_t>(channel);
    copyChannel(places, channel, file->cloud, place * sizeof(float));
    copyChannel(shades, channel, file->cloud, rgb + 2 - place); // blue comes first
  }
  return file;
}

} // namespace pcl::acmap::python
