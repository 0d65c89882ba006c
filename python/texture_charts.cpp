#include "array_view.h"
#include "bindings.h"
#include "members.h"

#include <pcl/core/compact_map.h>

namespace pcl::acmap::python {

namespace {

/** Bytes of all texels as (h, w) or (h, w, channels); without any if the picture has no
 * colours. */
py::array_t<std::uint8_t>
texelArray(const py::object& self,
           const std::uint8_t* first,
           const std::vector<py::ssize_t>& channels)
{
  const RgbImage& image = self.cast<const TexturePicture&>().colors;
  std::vector<py::ssize_t> shape = {0, 0};
  if (!image.values.empty())
    shape = {image.height, image.width};
  shape.insert(shape.end(), channels.begin(), channels.end());
  return py::array_t<std::uint8_t>(shape, first, self);
}

py::array_t<std::uint8_t>
colorsOf(const py::object& self)
{
  return texelArray(self, self.cast<const TexturePicture&>().colors.values.data(), {3});
}

py::array_t<std::uint8_t>
kindsOf(const py::object& self)
{
  static_assert(sizeof(TexelKind) == sizeof(std::uint8_t));
  const auto* const first = self.cast<const TexturePicture&>().kinds.data();
  return texelArray(self, reinterpret_cast<const std::uint8_t*>(first), {});
}

} // namespace

void
bindTextureCharts(py::module_& module)
{
  py::class_<TexturePicture>(module, "TexturePicture", "The colours of a surface.")
      .def_property_readonly(
          "colors", &colorsOf, "(h, w, 3) uint8: red, green, blue of the texels")
      .def_property_readonly(
          "kinds",
          &kindsOf,
          "(h, w) uint8: 0 not seen by any observation, 1 coloured by observations, 2 "
          "filled in from its neighbours");
  py::class_<TextureChart, TexturePicture>(
      module,
      "TextureChart",
      "The texture of a polygon, or of a part of it if it is large.")
      .def_readonly("plane", &TextureChart::plane, "index in CompactMap.planes")
      .def_readonly("polygon", &TextureChart::polygon, "index in PlanePatch.polygons")
      .def_property_readonly(
          "origin",
          memberArray<TextureChart, double>(
              {3}, [](const TextureChart& chart) { return chart.origin.data(); }),
          "(3,) float64, metres: the outer corner of texel [0, 0]; texel [row, column] "
          "begins at origin + column * texel_u + row * texel_v")
      .def_property_readonly(
          "texel_u",
          memberArray<TextureChart, double>(
              {3}, [](const TextureChart& chart) { return chart.texel_u.data(); }),
          "(3,) float64, metres: step of one column")
      .def_property_readonly(
          "texel_v",
          memberArray<TextureChart, double>(
              {3}, [](const TextureChart& chart) { return chart.texel_v.data(); }),
          "(3,) float64, metres: step of one row");
}

} // namespace pcl::acmap::python
