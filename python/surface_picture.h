#pragma once

#include "shown.h"

#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::python {

/** \brief Triangles for a picture. */
struct PictureMesh {
  std::function<Eigen::Vector3f(std::size_t)> point; ///< metres; may be not finite
  TriangleMesh::Triangles triangles;
  /** \brief Of each triangle, or one for all. */
  std::vector<std::array<std::uint8_t, 3>> colors;
};

/** \brief A picture of a surface, as a notebook shows it: parallel projection, seen from the side
 * to which most of it looks, brighter where it faces the view.
 * \return PNG; empty if there is nothing to be seen */
std::string
pictureOf(const PictureMesh& mesh);

/** \brief Gives a class that is bound the picture that notebooks ask for, `_repr_png_`.
 * \param[in] picture bytes of a PNG, or None */
template <typename Result>
void
addPicture(py::module_& module, const char* name, py::object (*picture)(const Result&))
{
  const py::object bound = module.attr(name);
  bound.attr("_repr_png_") =
      py::cpp_function(picture, py::name("_repr_png_"), py::is_method(bound));
}

} // namespace pcl::acmap::python
