#pragma once

#include "tutorial_page.h"

#include <pcl/core/image_file.h>

#include <string>

namespace pcl::acmap::test {

/** \brief Follows a tutorial in a folder: writes its files, runs its scripts by `sh -eu`
 * one after another, and looks at what they tell.
 * \throws std::runtime_error naming the first script that fails, with what it told, or
 * the first line of output that does not come */
void
followTutorial(const TutorialPage& page, const std::string& folder);

/** \brief Looks whether each picture of the page was made in the folder as the committed
 * one is.
 * \throws std::runtime_error naming the first that was not
 * \throws InputFileException where one of the two is missing or damaged */
void
comparePictures(const TutorialPage& page,
                const std::string& folder,
                const std::string& committed);

/** \brief Whether a text has all of these lines in this order, with others between. Space
 * counts once, and numbers may differ by a tenth.
 * \return the first line that it has not, empty when it has them all */
std::string
missingLine(const std::string& text, const std::string& wanted);

/** \brief Mean absolute difference of two pictures, grey levels of 0 to 255; another
 * machine's renderer makes a few tenths.
 * \throws std::runtime_error for another size */
double
pictureDifference(const RgbImage& a, const RgbImage& b);

/** \brief The same picture differs by less. */
constexpr double picture_tolerance = 1.5;

} // namespace pcl::acmap::test
