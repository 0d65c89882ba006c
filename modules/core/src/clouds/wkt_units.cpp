#include "clouds/coordinate_units.h"
#include "files/text_number.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace pcl::acmap {

namespace {

bool
isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/** Has a system with this keyword lengths as coordinates? */
bool
hasLengths(std::string_view keyword)
{
  return isOneOf(keyword,
                 {"PROJCS",
                  "PROJCRS",
                  "PROJECTEDCRS",
                  "GEOCCS",
                  "LOCAL_CS",
                  "ENGCRS",
                  "ENGINEERINGCRS"});
}

/** \brief Walks over the nodes of a well-known text, KEYWORD["name",number,NODE[...]]. */
class WktWalk {
public:
  explicit WktWalk(std::string_view text)
  : text_(text)
  {}

  CoordinateUnits
  units()
  {
    constexpr std::size_t deepest = 64; // of real ones: 6
    for (; at_ < text_.size() && nodes_.size() < deepest; ++at_)
      switch (text_[at_]) {
      case '"':
        at_ = std::min(text_.find('"', at_ + 1), text_.size() - 1);
        break;
      case '[':
      case '(':
        open();
        break;
      case ']':
      case ')':
        endWord();
        if (!nodes_.empty())
          nodes_.pop_back();
        break;
      case ',':
        endWord();
        break;
      default:
        break;
      }
    units_.are_degrees = is_geographic_ && !has_lengths_;
    return units_;
  }

private:
  /** The word that ends here. */
  std::string_view
  word() const
  {
    constexpr const char* around = " \t\r\n";
    std::string_view word = text_.substr(begin_, at_ - begin_);
    word.remove_prefix(std::min(word.find_first_not_of(around), word.size()));
    return word.substr(0, word.find_last_not_of(around) + 1);
  }

  void
  open()
  {
    nodes_.push_back(word());
    has_lengths_ = has_lengths_ || hasLengths(word());
    is_geographic_ =
        is_geographic_ || isOneOf(word(), {"GEOGCS", "GEOGCRS", "GEOGRAPHICCRS"});
    begin_ = at_ + 1;
  }

  /** The number of a unit is its size; names are no numbers. */
  void
  endWord()
  {
    double metres = 0;
    if (!nodes_.empty() && isOneOf(nodes_.back(), {"UNIT", "LENGTHUNIT"}) &&
        parseNumber(word(), metres))
      take(metres);
    begin_ = at_ + 1;
  }

  /** A unit is that of the node around it, or of the node of which that is an axis. */
  void
  take(double metres)
  {
    std::size_t unit = nodes_.size() - 1;
    if (unit > 0 && nodes_[unit - 1] == "AXIS")
      --unit;
    if (unit == 0)
      return;
    const std::string_view system = nodes_[unit - 1];
    if (hasLengths(system) && !units_.across)
      units_.across = metres;
    if (isOneOf(system, {"VERT_CS", "VERTCRS", "VERTICALCRS"}) && !units_.up)
      units_.up = metres;
  }

  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0;
  std::vector<std::string_view> nodes_; ///< keywords of those that are open
  bool has_lengths_ = false, is_geographic_ = false;
  CoordinateUnits units_;
};

} // namespace

CoordinateUnits
unitsOfWkt(std::string_view text)
{
  return WktWalk(text.substr(0, text.find('\0'))).units();
}

} // namespace pcl::acmap
