#pragma once

#include <pcl/core/calibration_file.h>
#include <pcl/core/impl/yaml_node.h>

#include <string>
#include <vector>

namespace pcl::acmap {

using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

/** \brief Numbers of a matrix or list, row by row: a list, a list of rows, OpenCV's map
 * of rows, cols and data, or a text with blanks between them.
 * \throws InputFileException for something else, or more than 64 numbers */
std::vector<double>
numbersOf(const YamlNode& node);

/** \throws InputFileException unless there are so many numbers */
Eigen::MatrixXd
matrixOf(const YamlNode& node, int rows, int columns);

/** \brief A rotation with the digits that people print, made exact.
 * \throws InputFileException when it is none */
Eigen::Matrix3d
rotationOf(const YamlNode& node);

/** \brief A rigid motion of four rows, or of three, with the digits that people print.
 * \throws InputFileException when it is none */
Eigen::Isometry3d
motionOf(const YamlNode& node);

/** \brief A view of a camera matrix fx 0 cx, 0 fy cy, 0 0 1.
 * \param[in] node for messages
 * \throws InputFileException when it has another form, or the values are not those of a
 * camera */
CalibratedView
viewOf(const Eigen::Matrix3d& matrix, const YamlNode& node);

/** \brief A view of fx, fy, cx, cy. */
CalibratedView
viewOf(double fx, double fy, double cx, double cy, const YamlNode& node);

/** \brief A rectified view of P = K [1 t], whose camera stands at -t.
 * \return nothing for zeros, which stand for a camera without calibration */
std::optional<CalibratedView>
rectifiedView(const YamlNode& projection);

/** \brief Sets the distortion k1, k2, p1, p2, k3.
 * \param[in] model name in the file, empty where it has none
 * \throws InputFileException naming a model that is not Brown-Conrady, and further
 * coefficients unless they are 0 */
void
setDistortion(const std::string& model,
              const std::vector<double>& coefficients,
              const YamlNode& node,
              CameraCalibration& camera);

/** \brief Sets the pose of a view. */
void
setPose(const Eigen::Isometry3d& T_shared_camera, CalibratedView& view);

/** \brief Reads the size of images from two keys, if they are there. */
void
readSize(const YamlNode& map,
         const std::string& width,
         const std::string& height,
         CalibratedView& view);

/** \brief Size of images: a list of width and height. */
void
readSize(const YamlNode& list, CalibratedView& view);

/** \brief Adds a neighbour that has the same rectified view, at a place along x.
 * \param[in] baseline metres */
void
addNeighbour(double baseline, Calibration& calibration);

} // namespace pcl::acmap
