#include "bindings.h"
#include "mesh_argument.h"
#include "path_argument.h"
#include "results.h"

#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>

#include <pybind11/stl.h>

#include <cstring>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

struct ShownFields {
  static constexpr auto name = py::detail::const_name("Dict[str, numpy.ndarray]");
};

/** Result of read_cloud: arrays that refer to a PointCloudFile. */
struct Cloud {
  py::array_t<float> points;
  ShownAs<ShownFields> fields;
  py::array_t<float> sensor_origin, sensor_orientation;
  std::optional<py::array_t<float>> up;
  std::vector<std::string> remarks;
};

/** The numpy name of a field's type; nullptr for types that a cloud cannot have. */
const char*
typeNameOf(const PCLPointField& field)
{
  switch (field.datatype) {
  case PCLPointField::INT8:
    return "i1";
  case PCLPointField::UINT8:
    return "u1";
  case PCLPointField::INT16:
    return "i2";
  case PCLPointField::UINT16:
    return "u2";
  case PCLPointField::INT32:
    return "i4";
  case PCLPointField::UINT32:
    return "u4";
  case PCLPointField::FLOAT32:
    return "f4";
  case PCLPointField::FLOAT64:
    return "f8";
  default:
    return nullptr;
  }
}

/** Values of all points at an offset, as (n, columns) or (h, w, columns); 0 columns:
 * one value per point. */
py::array
pointArray(const PCLPointCloud2& cloud,
           std::size_t offset,
           const py::dtype& type,
           py::ssize_t columns,
           const py::handle& owner)
{
  const auto step = static_cast<py::ssize_t>(cloud.point_step);
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(cloud.width)};
  std::vector<py::ssize_t> strides = {step};
  if (cloud.height > 1) {
    shape.insert(shape.begin(), static_cast<py::ssize_t>(cloud.height));
    strides.insert(strides.begin(), step * shape.back());
  }
  if (columns > 0) {
    shape.push_back(columns);
    strides.push_back(type.itemsize());
  }
  return py::array(type, shape, strides, cloud.data.data() + offset, owner);
}

Cloud
readCloud(const PathArgument& argument)
{
  const std::string path = pathOf("path", argument);
  PointCloudFile read;
  {
    const py::gil_scoped_release others_may_run;
    read = loadPointCloud(path);
  }
  const auto [file, owner] = owned(std::move(read));
  Cloud cloud;
  py::dict fields;
  for (const PCLPointField& field : file.cloud.fields) {
    const char* const type = typeNameOf(field);
    if (field.name == "x")
      cloud.points = py::reinterpret_borrow<py::array_t<float>>(
          pointArray(file.cloud, field.offset, py::dtype::of<float>(), 3, owner));
    else if (type && field.name != "y" && field.name != "z")
      fields[py::str(field.name)] =
          pointArray(file.cloud,
                     field.offset,
                     py::dtype(type),
                     field.count > 1 ? static_cast<py::ssize_t>(field.count) : 0,
                     owner);
  }
  cloud.fields = fields;
  cloud.sensor_origin = py::array_t<float>(3, file.sensor_origin.data(), owner);
  cloud.sensor_orientation =
      py::array_t<float>(4, file.sensor_orientation.coeffs().data(), owner);
  if (file.up)
    cloud.up = py::array_t<float>(3, file.up->data(), owner);
  cloud.remarks = file.remarks;
  return cloud;
}

void
addField(PCLPointCloud2& cloud, const std::string& name)
{
  PCLPointField field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = PCLPointField::FLOAT32;
  field.count = 1;
  cloud.fields.push_back(field);
  cloud.point_step += sizeof(float);
}

/** A cloud of x y z, and of the normals if they are given. */
PCLPointCloud2
cloudOfRows(const PointRows& points, const PointView* normals)
{
  PCLPointCloud2 cloud;
  for (const char* name : {"x", "y", "z"})
    addField(cloud, name);
  if (normals)
    for (const char* name : {"normal_x", "normal_y", "normal_z"})
      addField(cloud, name);
  const std::size_t size = points.view.size();
  cloud.height = points.width > 0 ? static_cast<std::uint32_t>(size / points.width) : 1;
  cloud.width = static_cast<std::uint32_t>(points.width > 0 ? points.width : size);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data.resize(size * cloud.point_step);
  for (std::size_t i = 0; i < size; ++i) {
    std::uint8_t* const place = cloud.data.data() + i * cloud.point_step;
    const Eigen::Vector3f point = points.view[i];
    std::memcpy(place, point.data(), 3 * sizeof(float));
    if (normals) {
      const Eigen::Vector3f normal = (*normals)[i];
      std::memcpy(place + 3 * sizeof(float), normal.data(), 3 * sizeof(float));
    }
  }
  return cloud;
}

void
writeMesh(const PathArgument& argument,
          const PointArgument& points,
          const MeshArgument& triangles,
          const std::optional<PointArgument>& normals)
{
  const std::string path = pathOf("path", argument);
  const PointRows rows = pointRowsOf("points", points);
  const std::shared_ptr<const TriangleMesh> mesh = meshOf(triangles, rows.view.size());
  PointView sides;
  if (normals) {
    sides = pointRowsOf("normals", *normals).view;
    requireAsMany("normals", sides.size(), rows.view.size());
  }
  const py::gil_scoped_release others_may_run;
  saveTriangleMesh(path, cloudOfRows(rows, normals ? &sides : nullptr), *mesh);
}

void
bindCloud(py::module_& module)
{
  bindResult<Cloud>(
      module,
      "Cloud",
      "A point cloud as it came from a file.",
      "points fields sensor_origin up remarks",
      field("points",
            &Cloud::points,
            "(n, 3) float32, or (h, w, 3) of an organized cloud, metres"),
      field("fields",
            &Cloud::fields,
            "dict of the other fields by name, one value a point: 'view', 'rgb' "
            "(packed), 'normal_x' ..."),
      field("sensor_origin", &Cloud::sensor_origin, "(3,) float32, metres"),
      field("sensor_orientation",
            &Cloud::sensor_orientation,
            "(4,) float32, quaternion x y z w"),
      field("up",
            &Cloud::up,
            "(3,) float32, direction upwards if nothing else is known of the "
            "sensor (LAS); else None"),
      field("remarks", &Cloud::remarks, "oddities that did not prevent reading"));
}

} // namespace

void
bindFiles(py::module_& module)
{
  bindCloud(module);
  module.def(
      "read_cloud",
      &readCloud,
      "Reads a point cloud: .pcd, .ply, .obj or .xyz. Returns a Cloud, whose arrays "
      "look at what was read. Raises OSError.",
      "path"_a);
  module.def(
      "read_mesh",
      [](const PathArgument& path) {
        return pythonMesh(loadTriangleMesh(pathOf("path", path)), py::none());
      },
      "Reads the faces of a .ply or .obj, polygons as triangles. Returns a Mesh, whose "
      "corners are the points that read_cloud gives. Raises OSError.",
      "path"_a);
  module.def(
      "write_mesh",
      &writeMesh,
      "Writes a mesh as binary .ply or .vtk, beside its place first: an older file "
      "stays whole if it fails. points and normals are (n, 3) float32 arrays. "
      "Raises OSError.",
      "path"_a,
      "points"_a,
      "triangles"_a,
      "normals"_a = py::none());
}

} // namespace pcl::acmap::python
