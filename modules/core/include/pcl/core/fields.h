#pragma once

#include <pcl/core/build_config.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace pcl::acmap {

/** \brief Name and unit of a field of a report, or of another struct that names its fields
 * in a `visitFields` beside it.
 *
 * That function is the only list of the fields: report.json, the reports of Python and
 * the table of doc/report_fields.md are made from it.
 * \code
 * template <typename Visitor>
 * void
 * visitFields (const FittingReport& report, Visitor&& visit)
 * {
 *   visit ({"planes"}, report.planes);
 *   visit ({"sigma", "m"}, report.sigma);
 *   visit ({"outcome"}, Named{report.outcome, fitting_outcome_names});
 * }
 * \endcode
 * A value is a number, a bool, a text, a \ref Named, an Eigen vector, a struct with a
 * `visitFields`, or an optional, an array or a vector of these. A visitor is a function
 * object of a Field and of any value.
 * \ingroup core */
struct Field {
  const char* name; ///< in report.json and in Python
  /** \brief Of the value: m, rad, m^2, bits; empty for counts, shares and texts. */
  const char* unit = "";
};

/** \brief The name of an enumerator. \param[in] names of all, in their order
 * \throws std::out_of_range for a value that is none \ingroup core */
template <typename Enum, std::size_t size>
constexpr const char*
nameIn(const std::array<const char*, size>& names, Enum value)
{
  return names.at(static_cast<std::size_t>(value));
}

/** \brief The value of a field with the names that it has outside of C++: an enumerator,
 * or an array with one number per name.
 * \ingroup core */
template <typename Value, std::size_t size>
struct Named {
  const Value& value;
  const std::array<const char*, size>& names;
};

template <typename Value, std::size_t size>
Named(const Value&, const std::array<const char*, size>&) -> Named<Value, size>;

/** \brief What `visitFields` calls; only declared, for \ref has_fields. */
struct AnyFieldVisitor {
  template <typename Value>
  void
  operator()(const Field& field, const Value& value) const;
};

/** \brief Does a struct have a `visitFields`? \ingroup core */
template <typename Struct, typename = void>
inline constexpr bool has_fields = false;

template <typename Struct>
inline constexpr bool
    has_fields<Struct,
               std::void_t<decltype(visitFields(std::declval<const Struct&>(),
                                                AnyFieldVisitor()))>> = true;

} // namespace pcl::acmap
