#pragma once

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Escapes a text for HTML, for use between tags and in quoted attributes.
 * Invalid UTF-8 and control characters become U+FFFD. */
std::string
htmlText(const std::string& text);

/** \brief Quotes arguments as a command line for a shell. */
std::string
shellText(const std::vector<std::string>& arguments);

/** \brief Formats a finite number with three significant digits, or all digits before
 * the decimal point; thousands are grouped. */
std::string
numberText(double value);

/** \brief Formats a finite number with a fixed number of decimals and a typographic
 * minus sign. */
std::string
fixedText(double value, int digits);

/** \brief Formats a duration: "0.25 s", "12.3 s", "3 min 05 s".
 * \param[in] seconds finite */
std::string
secondsText(double seconds);

/** \brief Formats a size: "813 bytes", "1.2 MB", with powers of 1000.
 * \param[in] bytes finite */
std::string
bytesText(double bytes);

} // namespace pcl::acmap
