#include "terminal_style.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace pcl::acmap {
namespace {

std::string
valueOf(const char* variable)
{
  const char* const value = std::getenv(variable);
  return value ? value : "";
}

/** Do the variables name a terminal that shows OSC 8 as a link? */
bool
knowsLinks()
{
  for (const char* const variable :
       {"VTE_VERSION", "KITTY_WINDOW_ID", "KONSOLE_VERSION", "WT_SESSION", "DOMTERM"})
    if (!valueOf(variable).empty())
      return true;
  const std::string program = valueOf("TERM_PROGRAM");
  return program == "iTerm.app" || program == "WezTerm" || program == "vscode" ||
         program == "ghostty";
}

/** A path as a part of an address: all but letters, digits and some marks in percent. */
std::string
addressOf(const std::string& path)
{
  constexpr std::string_view plain = "/-_.~", digits = "0123456789ABCDEF";
  std::string address;
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_letter = byte < 0x80 && std::isalnum(byte) != 0;
    if (is_letter || plain.find(letter) != std::string_view::npos)
      address += letter;
    else
      address += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return address;
}

} // namespace

TerminalStyle::TerminalStyle(int file_descriptor)
{
  const std::string terminal = valueOf("TERM");
  if (isatty(file_descriptor) == 0 || terminal.empty() || terminal == "dumb")
    return;
  has_colour_ = valueOf("NO_COLOR").empty();
  has_links_ = knowsLinks();
}

std::string
TerminalStyle::name(const std::string& text) const
{
  return has_colour_ ? "\x1b[1m" + text + "\x1b[0m" : text;
}

std::string
TerminalStyle::warning(const std::string& text) const
{
  return has_colour_ ? "\x1b[33m" + text + "\x1b[0m" : text;
}

std::string
TerminalStyle::link(const std::string& path) const
{
  std::error_code error;
  const std::string whole = std::filesystem::absolute(path, error).string();
  if (!has_links_ || error)
    return path;
  return "\x1b]8;;file://" + addressOf(whole) + "\x1b\\" + path + "\x1b]8;;\x1b\\";
}

} // namespace pcl::acmap
