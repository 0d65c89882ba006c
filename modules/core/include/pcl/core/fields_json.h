#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief A field that a file has under another key, or does not have. \ingroup core */
struct FieldKey {
  std::string_view field;
  std::string key = {}; ///< empty: the file does not have the field
};

template <typename Struct>
nlohmann::ordered_json
fieldsOf(const Struct& fields, std::initializer_list<FieldKey> changes = {});

template <typename StageReport>
nlohmann::ordered_json
jsonOf(const StageReport& report, std::initializer_list<FieldKey> changes = {});

/** \brief Converts the value of a field. */
struct FieldValueJson {
  using Json = nlohmann::ordered_json;

  template <typename Value>
  Json
  operator()(const Value& value) const
  {
    if constexpr (std::is_base_of_v<Report, Value>)
      return jsonOf(value);
    else if constexpr (has_fields<Value>)
      return fieldsOf(value);
    else
      return value;
  }

  Json
  operator()(const Eigen::Vector3d& value) const
  {
    return {value.x(), value.y(), value.z()};
  }

  template <typename Element>
  Json
  operator()(const std::vector<Element>& values) const
  {
    Json list = Json::array();
    for (const Element& value : values)
      list.push_back((*this)(value));
    return list;
  }

  template <typename Value, std::size_t size>
  Json
  operator()(const Named<Value, size>& named) const
  {
    if constexpr (std::is_enum_v<Value>)
      return nameIn(named.names, named.value);
    else {
      Json json = Json::object();
      for (std::size_t i = 0; i < size; ++i)
        json[named.names[i]] = (*this)(named.value[i]);
      return json;
    }
  }
};

/** \brief Visitor that makes a JSON object of the fields; those without a value are left
 * out. */
class FieldsJson {
public:
  explicit FieldsJson(std::initializer_list<FieldKey> changes)
  : changes_(changes)
  {}

  template <typename Value>
  void
  operator()(const Field& field, const Value& value)
  {
    const auto* const change =
        std::find_if(changes_.begin(), changes_.end(), [&](const FieldKey& any) {
          return any.field == field.name;
        });
    const std::string key = change == changes_.end() ? field.name : change->key;
    if (!key.empty())
      json[key] = FieldValueJson()(value);
  }

  template <typename Value>
  void
  operator()(const Field& field, const std::optional<Value>& value)
  {
    if (value)
      (*this)(field, *value);
  }

  nlohmann::ordered_json json = nlohmann::ordered_json::object();

private:
  std::initializer_list<FieldKey> changes_;
};

/** \brief The fields of a struct that names them as a JSON object, without seconds and
 * remarks; fields without a value are left out.
 *
 * This header alone needs nlohmann-json of the program that includes it.
 * \code
 * std::cout << pcl::acmap::fieldsOf (dewall.getReport ()).dump (2) << "\n";
 * \endcode
 * \param[in] changes keys that differ from the names of the fields \ingroup core */
template <typename Struct>
nlohmann::ordered_json
fieldsOf(const Struct& fields, std::initializer_list<FieldKey> changes)
{
  FieldsJson visitor(changes);
  visitFields(fields, visitor);
  return std::move(visitor.json);
}

/** \brief The structs of a list as columns: each field is the list of its values.
 * \ingroup core */
template <typename Struct>
nlohmann::ordered_json
columnsOf(const std::vector<Struct>& rows)
{
  nlohmann::ordered_json columns;
  visitFields(Struct(), [&](const Field& field, const auto&) {
    columns[field.name] = nlohmann::ordered_json::array();
  });
  for (const Struct& row : rows)
    visitFields(row, [&](const Field& field, const auto& value) {
      columns[field.name].push_back(value);
    });
  return columns;
}

/** \brief The seconds of the steps of a stage. \ingroup core */
inline nlohmann::ordered_json
secondsOf(const Report& report)
{
  nlohmann::ordered_json seconds = nlohmann::ordered_json::object();
  for (const auto& [step, time] : report.seconds)
    seconds[step] = time;
  return seconds;
}

/** \brief The fields of a stage's report, and its seconds; remarks are not included.
 * \ingroup core */
template <typename StageReport>
nlohmann::ordered_json
jsonOf(const StageReport& report, std::initializer_list<FieldKey> changes)
{
  nlohmann::ordered_json json = fieldsOf(report, changes);
  json["seconds"] = secondsOf(report);
  return json;
}

} // namespace pcl::acmap
