#pragma once

#include <pcl/core/calibration_file.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Reference and neighbour of a calibration, under both hypotheses on their
 * images; at least one of them is known. A size is 0 where it is not known. */
struct CameraPair {
  std::array<std::string, 2> names;
  std::optional<RigCalibration> built;
  std::optional<RigCalibration> rectified;
};

/** \throws InputFileException naming the option that is needed where the pair, or its
 * baseline, is not known */
CameraPair
pairOf(const std::vector<std::string>& names,
       const std::vector<Calibration>& calibrations,
       const RigImages& images);

/** \brief Rows (columns of a vertical pair) by which corresponding pixels differ at
 * most, px, if the images are taken as rectified; the distortion is not considered. */
double
rowResidual(const RigCalibration& cameras);

/** \brief The rig of cameras whose images are rectified already.
 * \param[in] is_stated true if the file calls them rectified: they may then be less
 * precise
 * \return nothing if they are not rectified, or their pixels are not square */
std::optional<TrinocularRig>
plainRig(const RigCalibration& cameras, bool is_stated);

/** \brief Are images by both the same to a fraction of a pixel? */
bool
areAlike(const RigCalibration& built, const RigCalibration& rectified);

/** \brief Scales cameras to the images, if these have another size of the same shape.
 * \return true if they were scaled
 * \throws InputFileException for another shape, for a size that is not known, and for a
 * principal point that images of this size do not have */
bool
fitToImages(const std::string& name, const RigImages& images, RigCalibration& cameras);

/** \brief Scale from images of one size to another of the same shape; nothing if the
 * shapes differ by more than a pixel. */
std::optional<double>
scaleBetween(int width, int height, int new_width, int new_height);

/** \brief Scales a principal point; pixels are counted from the centre of the first. */
double
scaledCenter(double center, double scale);

} // namespace pcl::acmap
