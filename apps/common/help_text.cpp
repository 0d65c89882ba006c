#include "help_text.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

#include <pcl/core/build_config.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace pcl::acmap {

namespace {

using Options = std::vector<const CLI::Option*>;

/** \brief Number of characters of a text in UTF-8. */
std::size_t
lengthOf(const std::string& text)
{
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/** \brief Appends words, with line breaks before those that would pass the width.
 * \param[in] indent of the lines after the first one
 * \param[in] column at which the first word begins; the text has as many characters in its last
 * line */
void
wrap(const std::string& words,
     std::size_t indent,
     std::size_t column,
     std::size_t width,
     std::string& text)
{
  std::istringstream stream(words);
  bool is_first = true;
  for (std::string word; stream >> word; is_first = false) {
    if (!is_first && column + 1 + lengthOf(word) > width) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    }
    else if (!is_first) {
      text += ' ';
      ++column;
    }
    text += word;
    column += lengthOf(word);
  }
  text += '\n';
}

bool
isList(const CLI::Option& option)
{
  return option.get_expected_max() == CLI::detail::expected_max_vector_size;
}

/** \brief "-o, --output OUT_DIR" */
std::string
headOf(const CLI::Option& option)
{
  std::string head;
  for (const std::string& name : option.get_snames())
    head += (head.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames())
    head += (head.empty() ? "--" : ", --") + name;
  if (head.empty())
    return option.get_type_name() + (isList(option) ? " ..." : "");
  if (option.get_type_size() > 0 && !option.get_type_name().empty())
    head += " " + option.get_type_name();
  if (isList(option))
    head += " ...";
  else if (option.get_type_size() > 0 && option.get_expected_min() > 1)
    head += " x " + std::to_string(option.get_expected());
  return head;
}

std::string
namesOf(const char* heading, const std::set<CLI::Option*>& options)
{
  // sets of pointers have another order in each run
  std::set<std::string> names;
  for (const CLI::Option* option : options)
    names.insert(option->get_name());
  return names.empty() ? std::string() : heading + CLI::detail::join(names, ", ") + "]";
}

std::string
descriptionOf(const CLI::Option& option)
{
  std::string text = option.get_description();
  const std::string preset = option.get_default_str();
  if (!preset.empty() && option.get_type_size() > 0 &&
      text.find("[default") == std::string::npos)
    text += " [default: " + preset + "]";
  if (option.get_required())
    text += " [required]";
  return text + namesOf(" [needs ", option.get_needs()) +
         namesOf(" [not with ", option.get_excludes());
}

void
appendOption(const CLI::Option& option, std::size_t width, std::string& text)
{
  const std::size_t column = std::min<std::size_t>(28, width / 3);
  const std::string head = "  " + headOf(option);
  text += head;
  if (lengthOf(head) + 2 > column)
    text += '\n' + std::string(column, ' ');
  else
    text += std::string(column - lengthOf(head), ' ');
  wrap(descriptionOf(option), column, column, width, text);
}

void
appendOptions(const std::string& title,
              const Options& options,
              std::size_t width,
              std::string& text)
{
  if (options.empty())
    return;
  text += '\n';
  wrap(title + ":", 2, 0, width, text);
  for (const CLI::Option* option : options)
    appendOption(*option, width, text);
}

/** \brief The options that fulfil a condition, in their order. */
template <typename Condition>
Options
optionsOf(const CLI::App& app, const Condition& condition)
{
  Options options;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty() && condition(*option))
      options.push_back(option);
  return options;
}

/** \brief Titles of the groups of options, in their order. */
std::vector<std::string>
groupsOf(const CLI::App& app)
{
  std::vector<std::string> groups;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional() && !option->get_group().empty() &&
        std::find(groups.begin(), groups.end(), option->get_group()) == groups.end())
      groups.push_back(option->get_group());
  return groups;
}

/** \brief Does a word of a title begin with a topic? */
bool
isAbout(const std::string& title, const std::string& topic)
{
  std::istringstream words(CLI::detail::to_lower(title));
  for (std::string word; words >> word;)
    if (word.rfind(CLI::detail::to_lower(topic), 0) == 0)
      return true;
  return false;
}

/** \brief The first word of each group, in small letters: what follows --help. */
std::string
topicsOf(const CLI::App& app)
{
  std::vector<std::string> topics;
  for (const std::string& group : groupsOf(app)) {
    std::string word =
        CLI::detail::to_lower(group.substr(0, group.find_first_of(" ,:")));
    if (std::find(topics.begin(), topics.end(), word) == topics.end())
      topics.push_back(std::move(word));
  }
  return CLI::detail::join(topics, ", ");
}

void
appendGroup(const CLI::App& app,
            const std::string& group,
            std::size_t width,
            std::string& text)
{
  appendOptions(group,
                optionsOf(app,
                          [&](const CLI::Option& option) {
                            return !option.get_positional() &&
                                   option.get_group() == group;
                          }),
                width,
                text);
}

/** \brief Usage, purpose and examples. */
std::string
introductionOf(const CLI::App& app, const HelpText& help, std::size_t width)
{
  std::string text = "Usage: ";
  wrap(usageOf(app), text.size(), text.size(), width, text);
  text += '\n';
  wrap(app.get_description(), 0, 0, width, text);
  if (!help.examples.empty())
    text += "\nExamples:\n";
  for (const auto& [command, what] : help.examples) {
    text += "  ";
    wrap(command, 6, 2, width, text);
    text += "      ";
    wrap(what, 6, 6, width, text);
  }
  appendOptions("Arguments",
                optionsOf(app, [](const CLI::Option& o) { return o.get_positional(); }),
                width,
                text);
  return text;
}

void
appendCommon(const CLI::App& app,
             const HelpText& help,
             std::size_t width,
             std::string& text)
{
  Options options;
  for (const std::string& name : help.common)
    options.push_back(app.get_option(name));
  appendOptions("Common options", options, width, text);
  text += '\n';
  wrap("All options: --help all. Those of one subject: --help " + topicsOf(app) + ".",
       0,
       0,
       width,
       text);
}

/** \brief A text in troff: no line begins with a control character. */
std::string
troff(const std::string& text)
{
  std::string escaped;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
      escaped += "\\&";
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return escaped;
}

} // namespace

std::string
helpOf(const CLI::App& app,
       const HelpText& help,
       const std::string& topic,
       std::size_t width)
{
  std::string text = introductionOf(app, help, width);
  const std::vector<std::string> groups = groupsOf(app);
  std::vector<std::string> shown;
  if (!topic.empty() && topic != "all")
    std::copy_if(groups.begin(),
                 groups.end(),
                 std::back_inserter(shown),
                 [&](const std::string& group) { return isAbout(group, topic); });
  if (topic == "all" || (shown.empty() && help.common.empty()))
    shown = groups;
  for (const std::string& group : shown)
    appendGroup(app, group, width, text);
  if (shown.empty())
    appendCommon(app, help, width, text);
  text += '\n';
  wrap(app.get_footer(), 0, 0, width, text);
  return text;
}

std::string
manPageOf(const CLI::App& app, const HelpText& help)
{
  const std::string& name = app.get_name();
  std::string text = ".TH " + name + " 1 \"\" \"acmap " ACMAP_VERSION "\"\n.SH NAME\n" +
                     name + " \\- " + troff(app.get_description()) +
                     "\n.SH SYNOPSIS\n" + troff(usageOf(app)) + "\n";
  if (!help.examples.empty())
    text += ".SH EXAMPLES\n";
  for (const auto& [command, what] : help.examples)
    text += ".TP\n.B " + troff(command) + "\n" + troff(what) + "\n";
  const auto append = [&](const std::string& title, const Options& options) {
    if (options.empty())
      return;
    text += ".SH \"" + troff(title) + "\"\n";
    for (const CLI::Option* option : options)
      text += ".TP\n.B " + troff(headOf(*option)) + "\n" +
              troff(descriptionOf(*option)) + "\n";
  };
  append("ARGUMENTS",
         optionsOf(app, [](const CLI::Option& o) { return o.get_positional(); }));
  for (const std::string& group : groupsOf(app))
    append(group, optionsOf(app, [&](const CLI::Option& option) {
             return !option.get_positional() && option.get_group() == group;
           }));
  return text + ".SH \"EXIT STATUS\"\n" + troff(app.get_footer()) + "\n";
}

} // namespace pcl::acmap
