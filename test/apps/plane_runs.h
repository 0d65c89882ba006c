#pragma once

#include "json_file.h"
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A plane of a planes file or a truth file: unit normal and offset. */
Eigen::Vector4d
coefficientsOf(const nlohmann::json& plane);

Eigen::Vector3d
pointOf(const nlohmann::json& point);

/** \brief Angle between the normals, degrees. */
double
angleBetween(const Eigen::Vector4d& a, const Eigen::Vector4d& b);

/** \brief The plane of a file with the most similar normal within a tolerance in
 * degrees and at most this distance, in metres, at its centre; null if there is
 * none. */
nlohmann::json
matchOf(const nlohmann::json& planes,
        const Eigen::Vector4d& truth,
        double degrees,
        double metres);

/** \brief The field `label` of a cloud file. */
std::vector<std::uint32_t>
labelsOfFile(const std::string& path);

/** \brief PCD of a floor and four walls with a noise of 6 mm, seen from the origin. */
std::string
roomPcd();

/** \brief Its five planes, normals pointing inwards. */
std::vector<Eigen::Vector4d>
roomPlanes();

/** \brief OBJ of a cube with a side of 1 m about the origin, its sides divided into
 * squares. */
std::string
cubeObj();

} // namespace pcl::acmap::test
