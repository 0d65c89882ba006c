#include "files/json_cursor.h"

#include "files/record_moves.h"

#include <pcl/core/exceptions.h>

#include <cmath>
#include <limits>

namespace pcl::acmap {

JsonCursor
JsonCursor::at(const char* key) const
{
  if (!value_->is_object())
    fail("is no object");
  const auto found = value_->find(key);
  if (found == value_->end())
    fail("has no \"" + std::string(key) + "\"");
  return {*found, *this, key, 0};
}

bool
JsonCursor::has(const char* key) const
{
  return value_->is_object() && value_->contains(key);
}

std::size_t
JsonCursor::size() const
{
  if (!value_->is_array())
    fail("is no array");
  return value_->size();
}

JsonCursor
JsonCursor::operator[](std::size_t index) const
{
  return {(*value_)[index], *this, nullptr, index};
}

double
JsonCursor::number() const
{
  if (!value_->is_number())
    fail("is no number");
  const auto number = value_->get<double>();
  if (!std::isfinite(number))
    fail("is not finite");
  return number;
}

double
JsonCursor::numberOrNan() const
{
  return value_->is_null() ? std::numeric_limits<double>::quiet_NaN() : number();
}

float
JsonCursor::floatNumber() const
{
  const float narrow = narrowed(number());
  if (!std::isfinite(narrow))
    fail("is too large");
  return narrow;
}

std::int64_t
JsonCursor::integer(std::int64_t minimum, std::int64_t maximum) const
{
  const auto outside = [&] {
    fail("is outside of " + std::to_string(minimum) + " to " + std::to_string(maximum));
  };
  if (!value_->is_number_integer())
    fail("is no whole number");
  // Values above the signed range are stored as unsigned.
  if (value_->is_number_unsigned() &&
      value_->get<std::uint64_t>() >
          std::uint64_t{std::numeric_limits<std::int64_t>::max()})
    outside();
  const auto number = value_->get<std::int64_t>();
  if (number < minimum || number > maximum)
    outside();
  return number;
}

bool
JsonCursor::boolean() const
{
  if (!value_->is_boolean())
    fail("is neither true nor false");
  return value_->get<bool>();
}

std::string
JsonCursor::text() const
{
  if (!value_->is_string())
    fail("is no text");
  return value_->get<std::string>();
}

void
JsonCursor::requireSize(std::size_t size) const
{
  if (this->size() != size)
    fail("has " + std::to_string(this->size()) + " elements, " + std::to_string(size) +
         " are needed");
}

std::string
JsonCursor::place() const
{
  if (!parent_)
    return "";
  const std::string before = parent_->place();
  if (!key_)
    return before + "[" + std::to_string(index_) + "]";
  return before.empty() ? key_ : before + "." + key_;
}

void
JsonCursor::fail(const std::string& fault) const
{
  const std::string name = place();
  throw InputFileException(*file_ + ": " + (name.empty() ? "the file" : name) + " " +
                           fault);
}

} // namespace pcl::acmap
