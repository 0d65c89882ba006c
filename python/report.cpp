#include "bindings.h"
#include "told.h"

namespace pcl::acmap::python {

namespace {

constexpr const char* about_reports =
    R"(What a stage tells of its run: fields named as in report.json, among them seconds and
remarks, in the reports of stages. repr tells its outcome, numbers and texts, str all.)";

/** The outcome first, then numbers and texts, then how many remarks there are. */
std::string
toldReport(const py::object& self)
{
  const py::dict fields = self.attr("__dict__");
  std::string names;
  for (const auto [name, value] : fields)
    if (py::isinstance<py::str>(value) || py::isinstance<py::float_>(value) ||
        py::isinstance<py::int_>(value))
      names = name.cast<std::string>() == "outcome"
                  ? "outcome " + names
                  : names + name.cast<std::string>() + " ";
  return toldFields(self, fields.contains("remarks") ? names + "remarks" : names);
}

} // namespace

void
bindReport(py::module_& module)
{
  const py::object base = py::module_::import("types").attr("SimpleNamespace");
  py::dict members;
  members["__doc__"] = about_reports;
  members["__module__"] = "acmap";
  members["__str__"] = base.attr("__repr__"); // with all fields
  const py::object report = py::type::of(base)("Report", py::make_tuple(base), members);
  report.attr("__repr__") =
      py::cpp_function(&toldReport, py::name("__repr__"), py::is_method(report));
  module.attr("Report") = report;
}

} // namespace pcl::acmap::python
