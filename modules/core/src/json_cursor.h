#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace pcl::acmap {

/** \brief A value in a JSON file that knows where it stands, so that a fault is told as
 * "map.json: planes[3].rmse is no number". Every fault is an InputFileException.
 *
 * A cursor points to the one that it came from, which must live as long. */
class JsonCursor {
public:
  /** \brief The whole file. */
  JsonCursor(const nlohmann::json& value, const std::string& file)
  : value_(&value)
  , file_(&file)
  {}

  /** \brief The value of a key that an object must have. */
  JsonCursor
  at(const char* key) const;

  /** \brief Whether an object has that key. */
  bool
  has(const char* key) const;

  /** \brief Elements of an array. */
  std::size_t
  size() const;

  JsonCursor
  operator[](std::size_t index) const;

  /** \brief A finite number. */
  double
  number() const;

  /** \brief A finite number, or null for NaN. */
  double
  numberOrNan() const;

  /** \brief A number that a float can hold. */
  float
  floatNumber() const;

  /** \brief A whole number in [least, most]. */
  std::int64_t
  integer(std::int64_t least, std::int64_t most) const;

  std::string
  text() const;

  /** \brief An array of so many finite numbers. */
  template <int rows>
  Eigen::Matrix<double, rows, 1>
  vector() const
  {
    requireSize(rows);
    Eigen::Matrix<double, rows, 1> result;
    for (int row = 0; row < rows; ++row)
      result[row] = (*this)[static_cast<std::size_t>(row)].number();
    return result;
  }

  void
  requireSize(std::size_t size) const;

  /** \param[in] fault what follows the name of the value, as "is negative" */
  [[noreturn]] void
  fail(const std::string& fault) const;

private:
  JsonCursor(const nlohmann::json& value,
             const JsonCursor& parent,
             const char* key,
             std::size_t index)
  : value_(&value)
  , file_(parent.file_)
  , parent_(&parent)
  , key_(key)
  , index_(index)
  {}

  std::string
  place() const;

  const nlohmann::json* value_;
  const std::string* file_;
  const JsonCursor* parent_ = nullptr;
  const char* key_ = nullptr; // nullptr: an element
  std::size_t index_ = 0;
};

} // namespace pcl::acmap
