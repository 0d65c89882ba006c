#pragma once

#include "tutorial_page.h"

#include <pcl/core/image_file.h>

#include <string>

namespace pcl::acmap::test {

/** \brief Executes a tutorial in a folder: writes its files, runs its scripts with `sh
 * -eu` one after another, and checks their output.
 * \throws std::runtime_error with the first script that fails and its output, or the
 * first missing line of output */
void
followTutorial(const TutorialPage& page, const std::string& folder);

/** \brief Compares the pictures created in the folder with the committed ones.
 * \throws std::runtime_error with the first picture that differs
 * \throws InputFileException when one of the two is missing or damaged */
void
comparePictures(const TutorialPage& page,
                const std::string& folder,
                const std::string& committed);

/** \brief Checks that a text contains these lines in this order, possibly with other
 * lines in between. White space is collapsed, and numbers may differ by 10 %.
 * \return the first missing line, empty if there is none */
std::string
missingLine(const std::string& text, const std::string& wanted);

/** \brief Mean absolute difference of two pictures in grey levels of 0 to 255.
 * Renderers of different machines differ by a few tenths.
 * \throws std::runtime_error when their sizes differ */
double
pictureDifference(const RgbImage& a, const RgbImage& b);

/** \brief Maximum difference of equal pictures. */
constexpr double picture_tolerance = 1.5;

} // namespace pcl::acmap::test
