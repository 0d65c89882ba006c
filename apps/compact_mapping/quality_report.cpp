#include "quality_report.h"

#include <pcl/core/fields_json.h>

namespace pcl::acmap {

void
tellQuality(const CompactMappingReport& report, StageLog& log)
{
  if (report.quality) {
    log.details["quality"] = fieldsOf(*report.quality);
    log.tell("quality", describeQuality(*report.quality));
  }
  if (report.next_positions)
    log.details["next_positions"] = fieldsOf(*report.next_positions);
}

} // namespace pcl::acmap
