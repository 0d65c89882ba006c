#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace pcl::acmap {

/** \brief A value in a JSON file that knows its position, so that a fault is reported
 * as "map.json: planes[3].rmse is no number". Every fault is an InputFileException.
 *
 * A cursor points to its parent, which must outlive it. */
class JsonCursor {
public:
  /** \brief The whole file. */
  JsonCursor(const nlohmann::json& value, const std::string& file)
  : value_(&value)
  , file_(&file)
  {}

  /** \brief Returns the value of a key of an object. A missing key is a fault. */
  JsonCursor
  at(const char* key) const;

  /** \brief Returns true if this is an object with that key. */
  bool
  has(const char* key) const;

  /** \brief The same, and the value is not null. */
  bool
  hasValue(const char* key) const
  {
    return has(key) && !at(key).value_->is_null();
  }

  /** \brief Number of elements of an array. */
  std::size_t
  size() const;

  JsonCursor
  operator[](std::size_t index) const;

  /** \brief A finite number. */
  double
  number() const;

  /** \brief A finite number, or NaN for null. */
  double
  numberOrNan() const;

  /** \brief A number within the range of a float. */
  float
  floatNumber() const;

  /** \brief An integer in [least, most]. */
  std::int64_t
  integer(std::int64_t minimum, std::int64_t maximum) const;

  bool
  boolean() const;

  std::string
  text() const;

  /** \brief An array of the given number of finite numbers. */
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

  /** \param[in] fault text after the name of the value, such as "is negative" */
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
  const char* key_ = nullptr; // nullptr for an element of an array
  std::size_t index_ = 0;
};

} // namespace pcl::acmap
