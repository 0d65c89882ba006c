#include "html_checker.h"

#include <algorithm>
#include <regex>
#include <set>
#include <vector>

namespace pcl::acmap::test {

namespace {

/** Checks the text between two tags, or the value of an attribute. */
bool
isEscaped(const std::string& text)
{
  static const std::regex entity("&(amp|lt|gt|quot|#39);");
  return std::regex_replace(text, entity, "").find_first_of("<>&") == std::string::npos;
}

/** \param[in] attributes text after the name of the element */
bool
areQuoted(std::string attributes)
{
  static const std::regex pair("^\\s+[a-zA-Z0-9:-]+(=\"([^\"]*)\")?");
  std::smatch found;
  while (std::regex_search(attributes, found, pair)) {
    if (!isEscaped(found[2]))
      return false;
    attributes = found.suffix();
  }
  return attributes.empty() || attributes == "/";
}

/** Checks that each lead byte is followed by its continuation bytes, as a decoder
 * would. */
bool
isUtf8(const std::string& text)
{
  int missing = 0;
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if ((byte & 0xC0U) == 0x80) {
      if (missing-- == 0)
        return false;
    }
    else if (missing != 0)
      return false;
    else
      missing = byte < 0x80 ? 0 : byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
  }
  return missing == 0;
}

/** Parses the tags. */
class Walk {
public:
  std::string
  faultOf(const std::string& page)
  {
    std::size_t at = 0;
    while (at < page.size()) {
      const std::size_t begin = page.find('<', at);
      const std::string text = page.substr(at, begin - at);
      if (!isStyle() && !isEscaped(text))
        return "not escaped: " + text;
      if (begin == std::string::npos)
        break;
      const std::size_t end = page.find('>', begin);
      if (end == std::string::npos)
        return "a tag without end";
      if (const std::string fault = enter(page.substr(begin + 1, end - begin - 1));
          !fault.empty())
        return fault;
      at = end + 1;
    }
    return open_.empty() ? "" : "not closed: " + open_.back();
  }

private:
  bool
  isStyle() const
  {
    return !open_.empty() && open_.back() == "style";
  }

  std::string
  enter(const std::string& tag)
  {
    static const std::set<std::string> alone = {"meta", "br", "img", "!DOCTYPE"};
    if (tag.rfind('/', 0) == 0) {
      if (open_.empty() || open_.back() != tag.substr(1))
        return "closed in the wrong place: " + tag;
      open_.pop_back();
      return {};
    }
    const std::string name = tag.substr(0, tag.find_first_of(" \n/"));
    if (!areQuoted(tag.substr(name.size())))
      return "attributes of " + tag.substr(0, 200);
    if (alone.count(name) == 0 && tag.back() != '/')
      open_.push_back(name);
    return {};
  }

  std::vector<std::string> open_;
};

} // namespace

std::string
htmlFault(const std::string& page)
{
  return isUtf8(page) ? Walk().faultOf(page) : "is no UTF-8";
}

} // namespace pcl::acmap::test
