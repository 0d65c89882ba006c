#include "case_list.h"

#include "spoilt_file.h"

#include <utility>

namespace pcl::acmap::test {

CaseList::CaseList(Prepare good,
                   std::vector<std::string> arguments,
                   std::map<std::string, UglyOutcome> outcomes)
: good_(std::move(good))
, arguments_(std::move(arguments))
, outcomes_(std::move(outcomes))
{}

void
CaseList::addFile(const std::string& file)
{
  for (const Ugliness kind : {Ugliness::Missing,
                              Ugliness::Empty,
                              Ugliness::Truncated,
                              Ugliness::Garbage,
                              Ugliness::Device,
                              Ugliness::Folder})
    add(kind, "`" + file + "` " + stateOf(kind), file, [=](const auto& folder) {
      spoil(folder.path(file), kind);
    });
}

void
CaseList::add(Ugliness kind,
              const std::string& what,
              const std::string& file,
              const Prepare& spoil)
{
  addRun(kind, what, file, arguments_, spoil);
}

void
CaseList::addRun(Ugliness kind,
                 const std::string& what,
                 const std::string& file,
                 const std::vector<std::string>& arguments,
                 const Prepare& spoil)
{
  const auto outcome = outcomes_.find(what);
  const UglyOutcome wanted =
      outcome == outcomes_.end() ? UglyOutcome{3, file} : outcome->second;
  const auto prepare = [good = good_, spoil](const TemporaryFolder& folder) {
    good(folder);
    spoil(folder);
  };
  cases_.push_back({kind, what, prepare, arguments, wanted.exit_code, wanted.told});
}

void
CaseList::addSenseless(Ugliness kind, const std::string& why)
{
  cases_.push_back({kind, why, {}, {}, 0, {}});
}

void
CaseList::addAll(const std::vector<UglyCase>& cases)
{
  cases_.insert(cases_.end(), cases.begin(), cases.end());
}

} // namespace pcl::acmap::test
