#pragma once

#include <pcl/core/point_cloud_reader.h>
#include <pcl/pipeline/bag_settings.h>

#include <CLI/App.hpp>

namespace pcl::acmap {

/** \brief The group in the help of what is stated of the input. */
inline constexpr const char* input_group = "Input: what is stated is not measured";

/** \brief Adds `--scale`. */
void
addScale(CLI::App& app, PointCloudReader& reader);

/** \brief Adds `--up`. \param[in] more of what the tool does with it */
void
addUp(CLI::App& app, PointCloudReader& reader, const std::string& more = {});

/** \brief Adds `--sensor-pose`, for bags. */
CLI::Option*
addSensorPose(CLI::App& app, BagSettings& bag);

/** \brief Adds all options of what is stated of a cloud. */
void
addReading(CLI::App& app, PointCloudReader& reader);

} // namespace pcl::acmap
