#include "poses.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/rigid_motion.h>

#include <cstring>

namespace pcl::acmap::python {

namespace {

/** Checks the last two axes of an array of poses. */
py::array
matricesOf(const std::string& name,
           const py::handle& argument,
           int ranks,
           const std::string& shape)
{
  py::array array = arrayOf(name, argument, py::dtype::of<double>(), {ranks}, shape);
  if (array.shape(ranks - 2) != 4 || array.shape(ranks - 1) != 4)
    refuseShape(name, array, shape);
  return array;
}

/** \param[in] first address of the first value of the pose in the array */
Eigen::Isometry3d
poseAt(const std::string& name, const py::array& array, const char* first)
{
  const int row_axis = static_cast<int>(array.ndim()) - 2;
  Eigen::Matrix4d pose;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      std::memcpy(&pose(row, column),
                  first + row * array.strides(row_axis) +
                      column * array.strides(row_axis + 1),
                  sizeof(double));
  try {
    return requirePlace(RigidMotion(pose));
  }
  catch (const BadArgumentException& fault) {
    throw py::value_error(name + ": " + fault.what());
  }
}

} // namespace

Eigen::Isometry3d
poseOf(const std::string& name, const py::handle& argument)
{
  const py::array array = matricesOf(name, argument, 2, "(4, 4)");
  return poseAt(name, array, static_cast<const char*>(array.data()));
}

Poses
posesOf(const std::string& name, const py::handle& argument)
{
  const py::array array = matricesOf(name, argument, 3, "(k, 4, 4)");
  const char* const first = static_cast<const char*>(array.data());
  Poses poses;
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    poses.push_back(poseAt(
        name + "[" + std::to_string(i) + "]", array, first + i * array.strides(0)));
  return poses;
}

py::array_t<double>
arrayOfPoses(const Poses& poses, const py::handle& owner)
{
  static_assert(sizeof(Eigen::Isometry3d) == 16 * sizeof(double));
  constexpr py::ssize_t size = sizeof(double);
  return py::array_t<double>(
      {static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}},
      {16 * size, size, 4 * size}, // column-major
      poses.empty() ? nullptr : poses.front().data(),
      owner);
}

} // namespace pcl::acmap::python
