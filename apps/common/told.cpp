#include "told.h"

namespace pcl::acmap {

using Json = nlohmann::ordered_json;

Json
jsonOf(const Told& told)
{
  Json seconds = Json::object(), summary = Json::array();
  for (const auto& [step, time] : told.report.seconds)
    seconds[step] = time;
  for (const auto& [name, value] : told.lines)
    summary.push_back({name, value});
  return {{"seconds", seconds},
          {"summary", summary},
          {"warnings", told.report.remarks},
          {"details", told.details}};
}

Told
toldIn(const Json& json)
{
  Told told;
  for (const auto& [step, time] : json.at("seconds").items())
    told.report.seconds.emplace_back(step, time.get<double>());
  for (const Json& line : json.at("summary"))
    told.lines.emplace_back(line.at(0).get<std::string>(),
                            line.at(1).get<std::string>());
  told.report.remarks = json.at("warnings").get<std::vector<std::string>>();
  told.details = json.at("details").get_ref<const Json::object_t&>();
  return told;
}

double
totalSeconds(const Told& told)
{
  double sum = 0;
  for (const auto& step : told.report.seconds)
    sum += step.second;
  return sum;
}

} // namespace pcl::acmap
