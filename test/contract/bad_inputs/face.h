#pragma once

#include "bad_case.h"

#include <pcl/core/plane_patch.h>
#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

template <typename Report, typename = void>
struct HasReason : std::false_type {};
template <typename Report>
struct HasReason<Report, std::void_t<decltype(std::declval<Report>().reason)>>
: std::true_type {};
template <typename Report, typename = void>
struct CountsInvalid : std::false_type {};
template <typename Report>
struct CountsInvalid<Report,
                     std::void_t<decltype(std::declval<Report>().invalid_points)>>
: std::true_type {};

template <typename Report>
Given
given(bool is_empty, const Report& report)
{
  bool is_told = !report.remarks.empty();
  if constexpr (HasReason<Report>::value)
    is_told = is_told || !report.reason.empty();
  if constexpr (CountsInvalid<Report>::value)
    is_told = is_told || (report.invalid_points > 0 && !is_empty);
  return {is_empty, is_told};
}

template <typename Class>
Given
planesOf(Class& object)
{
  std::vector<PlanePatch> planes;
  object.segment(planes);
  return given(planes.empty(), object.getReport());
}

/** \brief Numbers that no setter expects. */
inline const std::vector<double> odd_numbers{std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             -1,
                                             0,
                                             1e-300,
                                             1e-6,
                                             3,
                                             1e6,
                                             1e300};

/** \brief A value as a parameter of a setter: the nearest one that it can have. */
template <typename Number>
Number
nearest(double value)
{
  if constexpr (std::is_floating_point_v<Number>)
    return static_cast<Number>(value);
  if (std::isnan(value))
    return 0;
  if (value < 0) // as programs convert -1
    return static_cast<Number>(-1);
  return value >= static_cast<double>(std::numeric_limits<Number>::max())
             ? std::numeric_limits<Number>::max()
             : static_cast<Number>(value);
}

/** \brief A public class with its inputs, one of which is bad in each case. */
template <typename Class>
class Face {
public:
  using Change = std::function<void(Class&)>;
  using Run = std::function<Given(Class&)>;

  /** \param[in] good sets all inputs */
  Face(std::string name, Change good, Run run)
  : name_(std::move(name))
  , good_(std::move(good))
  , run_(std::move(run))
  {}

  /** \brief Adds a case of each kind of an input.
   * \param[in] set (object, value) sets it */
  template <typename Value, typename Set>
  Face&
  give(const std::string& input, const Kinds<Value>& kinds, const Set& set)
  {
    for (const Kind<Value>& kind : kinds)
      add(input + " " + kind.name,
          faultOf(kind.name),
          kind.answer,
          [kind, set, run = run_](Class& object) {
            set(object, kind.make());
            return run(object);
          });
    return *this;
  }

  /** \brief Adds a case of each odd number for a setter of the class or its base. */
  template <typename Base, typename Number, typename Result>
  Face&
  number(const std::string& setter, Result (Base::*set)(Number))
  {
    for (const double value : odd_numbers)
      add(setter + " " + std::to_string(value),
          "number",
          Answer::Any,
          [=, run = run_](Class& object) {
            (object.*set)(nearest<std::decay_t<Number>>(value));
            try {
              return run(object);
            }
            catch (const PCLException&) {
              return Given{false, true}; // texts of setters are compared
            }
          });
    return *this;
  }

  /** \brief Adds cases of numbers of threads and of orders of calls. */
  Face&
  common(const std::function<void(Class&, unsigned)>& set_threads = {})
  {
    if (set_threads)
      for (const unsigned threads : {0U, 1U, 3U, 1025U, 1000000U, 4294967295U})
        add("threads " + std::to_string(threads),
            "threads",
            threads > 1024 ? Answer::Refused : Answer::Any,
            [=, run = run_](Class& object) {
              set_threads(object, threads);
              return run(object);
            });
    add("good", "good", Answer::Any, run_);
    add("run twice", "good", Answer::Any, [run = run_](Class& object) {
      run(object);
      return run(object);
    });
    add("set twice", "good", Answer::Any, [good = good_, run = run_](Class& object) {
      good(object);
      return run(object);
    });
    cases_.push_back(
        {name_ + ": nothing set", "nothing set", Answer::Refused, [run = run_] {
           Class object;
           return run(object);
         }});
    return *this;
  }

  void
  addTo(std::vector<BadCase>& cases) const
  {
    cases.insert(cases.end(), cases_.begin(), cases_.end());
  }

private:
  /** The same kind of all inputs. */
  static std::string
  faultOf(const std::string& kind)
  {
    for (const char* base : {"view ", "room ", "rows "})
      if (kind.rfind(base, 0) == 0)
        return kind.substr(5);
    return kind;
  }

  void
  add(const std::string& input, const std::string& fault, Answer answer, const Run& run)
  {
    cases_.push_back({name_ + ": " + input, fault, answer, [good = good_, run] {
                        Class object;
                        good(object);
                        return run(object);
                      }});
  }

  std::string name_;
  Change good_;
  Run run_;
  std::vector<BadCase> cases_;
};

} // namespace pcl::acmap::test
