#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::acmap {

class ByteSource;

/** \brief What a column of a text is. */
enum class TextRole {
  None, ///< left out
  X,
  Y,
  Z,
  Red,
  Green,
  Blue,
  Intensity,
  NormalX,
  NormalY,
  NormalZ
};

inline constexpr std::size_t text_roles = 11;

/** \brief How the rows of a text are to be read. */
struct TextLayout {
  enum class Separators {
    Any,        ///< blanks, tabs, commas, semicolons, bars, each as often as it likes
    Blanks,     ///< blanks and tabs
    Commas,     ///< one between two fields
    Semicolons, ///< one between two fields
    Bars,       ///< one between two fields
    Tabs        ///< one between two fields
  };

  Separators separators = Separators::Any;
  bool has_decimal_commas = false;
  std::vector<TextRole> roles;    ///< of the columns; of those that follow, None
  std::vector<std::string> names; ///< of the columns, for \ref told
  /** \brief Metres in the unit that the names of x, y and z have. */
  std::optional<double> unit;
  bool is_guessed = false; ///< the colours are known by their numbers only
  std::vector<std::string> remarks;

  /** \brief Number of columns that a row must have. */
  std::size_t
  needed() const;

  bool
  has(TextRole role) const;

  /** \brief "id (left out), x, y, z". */
  std::string
  told() const;
};

/** \brief The fields of a line, without blanks and quotes around them. */
void
splitRow(std::string_view line,
         TextLayout::Separators separators,
         std::vector<std::string_view>& fields);

/** \brief Reads a number that may have a decimal comma, and marks of thousands. */
bool
parseField(std::string_view field, bool has_decimal_comma, double& value);

/** \brief What a name of a header says, in the usual spellings; None for others. */
TextRole
roleOfName(std::string_view name);

/** \brief Role of a column by a name of surveys, of another language, or of one letter; only where
 * no column has a usual name for that role, since the letters may name other quantities. */
TextRole
roleOfForeignName(std::string_view name);

/** \brief Metres in a unit of length, by its usual spellings. */
std::optional<double>
metresInUnit(std::string_view unit);

/** \brief The unit behind a name, in brackets or behind a low line; empty without one. */
std::string_view
unitOfName(std::string_view name);

/** \brief What stated names of columns mean.
 * \throws BadArgumentException for a name that is none, one that comes twice, or without x,
 * y and z */
std::vector<TextRole>
rolesOfColumns(const std::vector<std::string>& columns);

/** \brief The name of a role in texts and messages. */
const char*
nameOf(TextRole role);

/** \brief A line that is no row, or the beginning of one after a sign of comments. */
bool
isTextComment(std::string_view line);

/** \brief Does a line have three numbers or more? What is above the first such line is no row.
 */
bool
isTextRow(std::string_view line);

/** \brief Finds out how the rows are to be read, from the first ones and the names above them.
 * \param[in] head the beginning of the file, without the mark of its encoding
 * \param[in] is_pts see \ref readText
 * \param[in] columns that are stated; none: found
 * \throws InputFileException if that is ambiguous, naming what settles it */
TextLayout
findTextLayout(std::string_view head,
               bool is_pts,
               const std::vector<std::string>& columns,
               const ByteSource& source);

} // namespace pcl::acmap
