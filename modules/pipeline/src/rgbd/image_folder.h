#pragma once

#include <pcl/pipeline/rgbd_sequence.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief The first of several files or folders that a folder has, whatever the case of
 * its letters; empty if it has none of them.
 * \param[in] names in lower case, the preferred one first */
std::filesystem::path
findEntry(const std::filesystem::path& folder, const std::vector<std::string>& names);

/** \brief Colour images of a folder in the order of the numbers in their names; hidden
 * files are left out.
 * \param[in] prefix beginning of their names
 * \throws InputFileException if the folder cannot be listed */
std::vector<std::filesystem::path>
colorImagesIn(const std::filesystem::path& folder, const std::string& prefix = "");

/** \brief The same for depth images.
 * \throws InputFileException that names a command if the folder has only depths in a format
 * that is not read, such as arrays of numpy */
std::vector<std::filesystem::path>
depthImagesIn(const std::filesystem::path& folder, const std::string& prefix = "");

/** \brief Is a text before another one, with numbers by value? 9.png is before 10.png. */
bool
isBeforeByNumbers(const std::string& a, const std::string& b);

/** \brief The number that a name ends with before its extension: 12 of frame0012.png, 1.5
 * of rgb_1.50.png. */
std::optional<double>
numberInName(const std::filesystem::path& image);

/** \brief A frame with what its images are called. */
struct NamedFrame {
  RgbdFrame frame;
  std::size_t index = 0; ///< of the depth image among all
  std::optional<double>
      number; ///< in the name of the depth image; seconds if it is a time
};

/** \brief Depth and colour images that belong together. */
struct NamedFrames {
  std::vector<NamedFrame> frames;
  std::size_t depths = 0;    ///< depth images, with those without a colour image
  std::size_t unmatched = 0; ///< depth images without a colour image
  bool are_times = false;    ///< numbers in names are times, and so are the stamps
  std::string remark;        ///< how they were joined, if that is an assumption
};

/** \brief Joins images of the same name; else those whose names have the same number, or the
 * nearest times; else in their order if there are as many.
 * \param[in] gap seconds, maximum for times
 * \param[in] place folder, for messages
 * \throws InputFileException if nothing of that is possible
 * \throws EmptyInputException if there is no depth image */
NamedFrames
joinedImages(const std::vector<std::filesystem::path>& depths,
             const std::vector<std::filesystem::path>& colors,
             double gap,
             const std::string& place);

/** \brief Frames of depth images alone. */
NamedFrames
depthsAlone(const std::vector<std::filesystem::path>& depths);

} // namespace pcl::acmap
