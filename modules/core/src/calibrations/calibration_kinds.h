#pragma once

#include <pcl/core/calibration_file.h>
#include <pcl/core/impl/yaml_node.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A kind of calibration: a row of the table of conventions. */
struct CalibrationKind {
  const char* name;
  const char* convention;

  /** \brief Is a document of this kind? Looks at its keys only. */
  bool (*is)(const YamlNode& map);

  /** \throws InputFileException naming what is wrong */
  void (*read)(const YamlNode& map, Calibration& calibration);
};

extern const CalibrationKind kalibr_kind;
extern const CalibrationKind euroc_kind;
extern const CalibrationKind orb_slam_kind;
extern const CalibrationKind orb_slam3_kind;
extern const CalibrationKind stella_kind;
extern const CalibrationKind camodocal_kind;
extern const CalibrationKind kitti_kind;
extern const CalibrationKind kitti_raw_kind;
extern const CalibrationKind camera_info_kind;
extern const CalibrationKind opencv_pair_kind;
extern const CalibrationKind camera_json_kind;
extern const CalibrationKind middlebury_kind;
extern const CalibrationKind plain_matrix_kind;

/** \brief Do two documents make one of OpenCV's stereo calibrations, of which one has
 * the matrices of both cameras, the other R and T? */
bool
areOpenCvHalves(const YamlNode& intrinsics, const YamlNode& extrinsics);

/** \brief Reads a calibration, or the two files of a pair.
 * \return one calibration, also of two files that are halves of it, or two
 * \throws InputFileException naming what cannot be read */
std::vector<Calibration>
loadCalibrations(const std::vector<std::string>& paths);

/** \brief Rewrites `key=[1 2 3; 4 5 6]`, the lines of Middlebury's calib.txt, as YAML. */
std::string
yamlOfMiddlebury(const std::string& text);

/** \brief Does a text have the sections of ROS' camera_calibration, ost.txt? */
bool
isOstText(const std::string& text);

/** \brief Rewrites ost.txt, of one camera or of two, as YAML. */
std::string
yamlOfOst(const std::string& text);

/** \brief Rewrites a file of nothing but numbers as YAML with the key `numbers`. */
std::string
yamlOfNumbers(const std::string& text);

} // namespace pcl::acmap
