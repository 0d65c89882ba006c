#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief What a class may do with an input. */
enum class Answer {
  Any,  ///< the input is sound: a result, which the report explains if it is empty
  Told, ///< it is not used as a whole: a remark, a count of what was skipped, a refusal
  Refused ///< it contradicts itself, or there is none: a refusal
};

/** \brief A kind of input. */
template <typename Value>
struct Kind {
  std::string name;
  Answer answer = Answer::Any;
  std::function<Value()> make;
};

template <typename Value>
using Kinds = std::vector<Kind<Value>>;

/** \brief What a run gave. */
struct Given {
  bool is_empty = false;
  bool is_told = false; ///< by a remark, a reason or a count of invalid points
};

/** \brief A class with one input of one kind. */
struct BadCase {
  std::string name;
  std::string fault; ///< kind of input, the same for all classes
  Answer answer = Answer::Any;
  std::function<Given()> run;
};

/** \brief How a case ended. */
struct Ending {
  std::string fault; ///< crash, hang, other exception, silence; empty if there is none
  std::string refusal; ///< message of an exception of PCL
};

/** \brief Runs a case in a process of its own, with limits of time and memory. */
Ending
endingOf(const BadCase& bad);

/** \brief A refusal without its numbers, names of inputs and parameters, and units. */
std::string
sentenceOf(const std::string& refusal);

/** \name The classes with all kinds of input
 * \{ */
void
addCloudCases(std::vector<BadCase>& cases);
void
addRowCases(std::vector<BadCase>& cases);
void
addMapCases(std::vector<BadCase>& cases);
void
addViewCases(std::vector<BadCase>& cases);
/** \} */

} // namespace pcl::acmap::test
