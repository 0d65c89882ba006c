#include "checks.h"
#include "session/session_folder.h"

using namespace pcl::acmap;

/** Bytes are rejected, or give the summary of a session that is unchanged by writing
 * and reading, and names no file outside the session. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  auto read =
      test::acceptedBy([&] { return readSessionSummary(parseYaml("input", text)); });
  if (!read)
    return 0;
  test::require(read->rig.find('/') == std::string::npos);
  read->rig = SessionSummary().rig; // other names are not written
  const SessionSummary again =
      readSessionSummary(parseYaml("again", sessionText(*read)));
  test::require(again.rig == read->rig && again.frames == read->frames &&
                again.observations == read->observations &&
                again.patterns == read->patterns && again.cameras == read->cameras);
  return 0;
}
