#pragma once

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A text for HTML, between tags as well as in quoted attributes. Bytes that are
 * no UTF-8, and control characters, become U+FFFD. */
std::string
htmlText(const std::string& text);

/** \brief A command line for a shell, which gives the same arguments again. */
std::string
shellText(const std::vector<std::string>& arguments);

/** \brief A finite number with three significant digits, or all before the point;
 * thousands are grouped. */
std::string
numberText(double value);

/** \brief A finite number with so many digits behind the point, and a minus sign as the
 * printers know it. */
std::string
fixedText(double value, int digits);

/** \brief "0.25 s", "12.3 s", "3 min 05 s". \param[in] seconds finite */
std::string
secondsText(double seconds);

/** \brief "813 bytes", "1.2 MB", with powers of thousand. \param[in] bytes finite */
std::string
bytesText(double bytes);

} // namespace pcl::acmap
