#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A reference to an instance of a STEP file (ISO 10303-21); 0: none. */
struct StepReference {
  std::size_t number = 0;
};

/** \brief An enumeration, such as ELEMENT. */
struct StepEnum {
  const char* name;
};

/** \brief A value that follows from others. */
struct StepDerived {};

/** \brief A measure of a named type, such as IFCLENGTHMEASURE. */
struct StepMeasure {
  const char* type;
  double value;
};

/** \brief Writes the instances of a STEP file one after the other. */
class StepFile {
public:
  StepFile()
  {
    text_.imbue(std::locale::classic());
  }

  /** \brief Adds an instance. Values are text, numbers, enumerations, references, and lists of
   * them; nullptr is what is not given. */
  template <typename... Values>
  StepReference
  add(const char* type, const Values&... values)
  {
    text_ << '#' << ++last_ << '=' << type << '(';
    std::size_t count = 0;
    ((text_ << (count++ > 0 ? "," : ""), put(values)), ...);
    text_ << ");\n";
    return {last_};
  }

  std::string
  text() const
  {
    return text_.str();
  }

private:
  void
  put(std::nullptr_t)
  {
    text_ << '$';
  }

  void
  put(StepDerived)
  {
    text_ << '*';
  }

  void
  put(StepReference reference)
  {
    if (reference.number == 0)
      text_ << '$';
    else
      text_ << '#' << reference.number;
  }

  void
  put(StepEnum value)
  {
    text_ << '.' << value.name << '.';
  }

  void
  put(const StepMeasure& measure)
  {
    text_ << measure.type << '(';
    put(measure.value);
    text_ << ')';
  }

  /** A number with its decimal point. */
  void
  put(double value)
  {
    if (!std::isfinite(value))
      value = 0;
    std::ostringstream number;
    number.imbue(std::locale::classic());
    number.setf(std::ios::uppercase);
    number.precision(9);
    number << value;
    std::string digits = number.str();
    if (digits.find('.') == std::string::npos)
      digits.insert(std::min(digits.find('E'), digits.size()), ".");
    text_ << digits;
  }

  void
  put(std::size_t value)
  {
    text_ << value;
  }

  void
  put(const std::string& value)
  {
    text_ << '\'' << value << '\'';
  }

  void
  put(const char* value)
  {
    put(std::string(value));
  }

  template <typename Value>
  void
  put(const std::vector<Value>& values)
  {
    text_ << '(';
    for (std::size_t i = 0; i < values.size(); ++i) {
      text_ << (i > 0 ? "," : "");
      put(values[i]);
    }
    text_ << ')';
  }

  std::ostringstream text_;
  std::size_t last_ = 0;
};

} // namespace pcl::acmap
