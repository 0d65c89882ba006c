#include "plan/stroke_font.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pcl::acmap {

namespace {

/** \brief A character as strokes, between which a bar stands: a column and a row for each
 * point. Descenders end at row 0, letters stand on row 2, small ones end at row 6 and
 * capital ones at row 8. */
struct Glyph {
  char32_t character;
  std::string_view strokes;
};

constexpr std::string_view missing = "0208383202";

constexpr Glyph glyphs[] = {
    {U'0', "030718384743321203"},
    {U'1', "062822|1242"},
    {U'2', "07183847460242"},
    {U'3', "07183847463525|354443321203"},
    {U'4', "32380444"},
    {U'5', "480805354443321203"},
    {U'6', "473818070312324344351504"},
    {U'7', "084812"},
    {U'8', "15060718384746351504031232434435"},
    {U'9', "031232434738180706153546"},
    {U'A', "022842|1535"},
    {U'B', "02083847463505|3544433202"},
    {U'C', "4738180703123243"},
    {U'D', "020828374644332202"},
    {U'E', "48080242|0535"},
    {U'F', "480802|0535"},
    {U'G', "47381807031232434525"},
    {U'H', "0208|4248|0545"},
    {U'I', "0208"},
    {U'J', "4843321203"},
    {U'K', "0208|480542"},
    {U'L', "080242"},
    {U'M', "0208244842"},
    {U'N', "02084248"},
    {U'O', "030718384743321203"},
    {U'P', "02083847463505"},
    {U'Q', "030718384743321203|2442"},
    {U'R', "02083847463505|2542"},
    {U'S', "473818070615354443321203"},
    {U'T', "0848|2822"},
    {U'U', "080312324348"},
    {U'V', "082248"},
    {U'W', "0812263248"},
    {U'X', "0248|0842"},
    {U'Y', "082548|2522"},
    {U'Z', "08480242"},
    {U'a', "3632|3526160503122233"},
    {U'b', "0802|0516263533221203"},
    {U'c', "3526160503122233"},
    {U'd', "3832|3526160503122233"},
    {U'e', "04343526160503122233"},
    {U'f', "281712|0626"},
    {U'g', "3631201001|3526160503122233"},
    {U'h', "0802|0516263532"},
    {U'i', "0602|08"},
    {U'j', "161100|18"},
    {U'k', "0802|360432"},
    {U'l', "0802"},
    {U'm', "0602|05162522|25364542"},
    {U'n', "0602|0516263532"},
    {U'o', "051626353322120305"},
    {U'p', "0600|0516263533221203"},
    {U'q', "3630|3526160503122233"},
    {U'r', "0602|051626"},
    {U's', "35261605142433221203"},
    {U't', "181322|0626"},
    {U'u', "0603122233|3632"},
    {U'v', "062246"},
    {U'w', "0612243246"},
    {U'x', "0632|0236"},
    {U'y', "0622|46221000"},
    {U'z', "06360232"},
    {U'.', "02"},
    {U',', "0201"},
    {U':', "02|06"},
    {U';', "0201|06"},
    {U'-', "0525"},
    {U'\u2013', "0545"},
    {U'+', "0545|2327"},
    {U'=', "0444|0646"},
    {U'/', "0248"},
    {U'(', "18060412"},
    {U')', "08161402"},
    {U'\'', "0807"},
    {U'"', "0807|1817"},
    {U'!', "0804|02"},
    {U'?', "07182837362524|22"},
    {U'_', "0242"},
    {U'%', "0248|08|42"},
    {U'#', "1218|3238|0444|0646"},
    {U'\u00B1', "0545|2327|0242"},
    {U'\u00D7', "0337|0733"},
    {U'\u00B2', "081928270525"},
    {U'\u00B3', "09192817|17261505"},
    {U'\u00B0', "08191708"},
};

/** \brief The letters below the accents of Latin-1, from U+00C0 on. */
constexpr std::string_view without_accents =
    "AAAAAAACEEEEIIIIDNOOOOO*OUUUUYPsaaaaaaaceeeeiiiidnooooo/ouuuuypy";

/** \brief Takes the next character from a text. */
char32_t
nextOf(std::string_view& text)
{
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  const std::size_t more = first < 0xC0 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
  constexpr std::uint8_t masks[] = {0xFF, 0x1F, 0x0F, 0x07};
  char32_t character = first & masks[more];
  for (std::size_t k = 0; k < more && !text.empty() && (text.front() & 0xC0) == 0x80;
       ++k) {
    character = character << 6 | (static_cast<unsigned char>(text.front()) & 0x3FU);
    text.remove_prefix(1);
  }
  return character;
}

std::string_view
strokesOf(char32_t character)
{
  const auto find = [&](char32_t wanted) {
    return std::find_if(std::begin(glyphs), std::end(glyphs), [&](const Glyph& glyph) {
      return glyph.character == wanted;
    });
  };
  const Glyph* glyph = find(character);
  if (glyph == std::end(glyphs) && character >= 0xC0 &&
      character < 0xC0 + without_accents.size())
    glyph = find(static_cast<char32_t>(without_accents[character - 0xC0]));
  return glyph == std::end(glyphs) ? missing : glyph->strokes;
}

} // namespace

StrokedText
strokesOf(const std::string& text)
{
  constexpr double capital = 6, base = 2, space = 3, between = 2, narrow = 0.9;
  StrokedText stroked;
  double from = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const char32_t character = nextOf(rest);
    if (character == U' ') {
      from += space;
      continue;
    }
    int right = 0, column = -1;
    stroked.strokes.emplace_back();
    for (const char sign : strokesOf(character))
      if (sign == '|')
        stroked.strokes.emplace_back();
      else if (column < 0)
        column = sign - '0';
      else {
        stroked.strokes.back().emplace_back(narrow * (from + column) / capital,
                                            (sign - '0' - base) / capital - 0.5);
        right = std::max(right, column);
        column = -1;
      }
    from += right + between;
  }
  stroked.width = narrow * std::max(from - between, 0.0) / capital;
  return stroked;
}

double
widthOf(const std::string& text)
{
  return strokesOf(text).width;
}

} // namespace pcl::acmap
