#pragma once

#include <pcl/core/compact_map.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief Describes what is wrong with the equation of a plane, as a continuation of
 * the name of its coefficients; empty if it is valid. */
std::string
faultOfCoefficients(const Eigen::Vector4d& coefficients);

/** \brief Describes what is wrong with a cylinder of a map, and the cylinders before it, as
 * a continuation of its name; empty if it is valid. Its covariance and its rms may be
 * NaN. */
std::string
faultOfCylinder(const CompactMap& map, std::size_t number);

/** \brief As above, for a box of a map, its planes, and the boxes before it. */
std::string
faultOfBox(const CompactMap& map, std::size_t number);

/** \brief As above, for a recess of a map, its planes, and the recesses before it. */
std::string
faultOfRecess(const CompactMap& map, std::size_t number);

/** \brief As above, for a loop of a polygon. */
std::string
faultOfLoop(const std::vector<Eigen::Vector3f>& loop);

/** \brief As above, for the factor of the colours in files. */
std::string
faultOfExposure(double exposure);

/** \brief Empty if an up direction has length 1, or is zero. */
std::string
faultOfUp(const Eigen::Vector3d& up);

/** \brief Describes what is wrong with the place of a picture in its files, as a
 * continuation of its name; empty if it is valid. */
std::string
faultOfPlace(const TexturePicture& picture);

/** \brief As above, for the number of texels of all pictures so far, as a continuation of
 * the name of the last one. */
std::string
faultOfTexels(std::int64_t texels);

/** \brief As above, for the file name of the image of a chart; an empty name means no
 * image. */
std::string
faultOfImageName(const std::string& name);

/** \brief Implementation of \ref loadMapFile.
 * \param[in] name file name in messages
 * \param[in] source the contents of the file
 * \throws InputFileException naming file and fault */
CompactMap
readMap(const std::string& name, ByteSource& source);

/** \brief Passes the output of \ref saveMapFile to a function in several pieces, so
 * that there is no second copy of the whole map in memory.
 * \throws BadArgumentException as \ref saveMapFile */
void
writeMap(const CompactMap& map, const std::function<void(const std::string&)>& write);

} // namespace pcl::acmap
