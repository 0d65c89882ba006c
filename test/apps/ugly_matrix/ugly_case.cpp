#include "ugly_case.h"

#include <stdexcept>

namespace pcl::acmap::test {

const std::vector<Ugliness>&
uglinesses()
{
  static const std::vector<Ugliness> all = {Ugliness::Missing,
                                            Ugliness::Empty,
                                            Ugliness::Truncated,
                                            Ugliness::Garbage,
                                            Ugliness::NanOnly,
                                            Ugliness::OnePoint,
                                            Ugliness::Doubled,
                                            Ugliness::WrongFields,
                                            Ugliness::Huge,
                                            Ugliness::Millimetres,
                                            Ugliness::Names,
                                            Ugliness::Device,
                                            Ugliness::Folder};
  return all;
}

const char*
nameOf(Ugliness kind)
{
  switch (kind) {
  case Ugliness::Missing:
    return "missing";
  case Ugliness::Empty:
    return "empty";
  case Ugliness::Truncated:
    return "truncated";
  case Ugliness::Garbage:
    return "garbage";
  case Ugliness::NanOnly:
    return "NaN only";
  case Ugliness::OnePoint:
    return "one point";
  case Ugliness::Doubled:
    return "doubled";
  case Ugliness::WrongFields:
    return "wrong fields";
  case Ugliness::Huge:
    return "huge numbers";
  case Ugliness::Millimetres:
    return "millimetres";
  case Ugliness::Names:
    return "odd names";
  case Ugliness::Device:
    return "device, pipe";
  case Ugliness::Folder:
    return "folder, file";
  }
  throw std::logic_error("no such ugliness");
}

} // namespace pcl::acmap::test
