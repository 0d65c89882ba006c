#include "checks.h"
#include "session/session_folder.h"

using namespace pcl::acmap;

/** Bytes are refused, or give the summary of a session that is written and read back the
 * same, and that names no file outside of it. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  auto read =
      test::acceptedBy([&] { return readSessionSummary(parseYaml("input", text)); });
  if (!read)
    return 0;
  test::require(read->rig.find('/') == std::string::npos);
  read->rig = SessionSummary().rig; // no other is written
  const SessionSummary again =
      readSessionSummary(parseYaml("again", sessionText(*read)));
  test::require(again.rig == read->rig && again.frames == read->frames &&
                again.observations == read->observations &&
                again.patterns == read->patterns && again.cameras == read->cameras);
  return 0;
}
