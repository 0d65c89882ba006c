#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A plane as a file of planes or of truth holds it: unit normal and offset. */
Eigen::Vector4d
coefficientsOf(const nlohmann::json& plane);

Eigen::Vector3d
pointOf(const nlohmann::json& point);

/** \brief Angle between the normals, degrees. */
double
angleBetween(const Eigen::Vector4d& a, const Eigen::Vector4d& b);

/** \brief The plane of a file that is nearest to one in direction, within a tolerance in
 * degrees, and off it by no more than so many metres at its centre; null without one. */
nlohmann::json
matchOf(const nlohmann::json& planes,
        const Eigen::Vector4d& truth,
        double degrees,
        double metres);

nlohmann::json
jsonOfFile(const std::string& path);

/** \brief The field `label` of a cloud's file. */
std::vector<std::uint32_t>
labelsOfFile(const std::string& path);

/** \brief Floor and four walls with a noise of 6 mm as a PCD, seen from the origin. */
std::string
roomPcd();

/** \brief The five planes of it, normals inwards. */
std::vector<Eigen::Vector4d>
roomPlanes();

/** \brief A cube of side 1 m about the origin as OBJ, its sides of squares. */
std::string
cubeObj();

} // namespace pcl::acmap::test
