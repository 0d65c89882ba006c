#pragma once

#include "clouds.h"
#include "test_data.h"

#include <pcl/core/point_cloud_file.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief The path of a file of the test data; nothing, with a message on stderr, if it
 * is missing. */
std::optional<std::string>
pathOfData(const std::string& relative);

/** \brief The folder of RedKitchen (7-Scenes): every tenth frame of a hand-held Kinect,
 * with given poses; nothing, as above, if it is missing. */
std::optional<std::string>
pathOfKitchen();

/** \brief The content of a file; one that ends in .xz is unpacked by the program xz.
 * \throws InputFileException if it could not be read or unpacked */
std::string
contentOf(const std::string& path);

/** \brief Reads a cloud; a file that ends in .xz is unpacked first.
 * \throws InputFileException as loadPointCloud and \ref contentOf */
PointCloudFile
loadMaybePacked(const std::string& path);

/** \brief A cloud of finite points with its spacing. */
struct FigureCloud {
  std::string name;
  test::Cloud cloud;
  double spacing = 0; ///< median distance to the nearest different position, metres
};

FigureCloud
loadFigureCloud(const std::string& name, const std::string& path);

/** \brief The clouds of the table of faults; missing ones are skipped. */
std::vector<FigureCloud>
realClouds();

/** \brief The single views of the time table: real ones and a simulated one. */
std::vector<FigureCloud>
singleViews();

} // namespace pcl::acmap::bench
