#include "tool.h"

#include "command_line.h"
#include "input_advice.h"
#include "output_target.h"
#include "setter_option.h"
#include "terminal_style.h"

#include <pcl/console/print.h>
#include <pcl/core/build_config.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/process_memory.h>
#include <pcl/core/run_times.h>

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <sstream>

namespace pcl::acmap {
namespace {

constexpr const char* exit_code_text =
    "Exit codes: 0 done, 1 failed, 2 usage, 3 input unreadable or malformed, 4 nothing "
    "found, 5 output could not be written, 6 not enough memory, 7 the result "
    "contradicts itself, 130 interrupted. "
    "Long options may also be spelt with one dash and underscores.";

/** \brief What follows `--help`, possibly nothing; none if there is no help to be shown. */
std::optional<std::string>
helpTopicIn(const std::vector<std::string>& arguments)
{
  const std::string flag = "--help";
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
    const std::string& argument = arguments[i];
    if (argument.rfind(flag + "=", 0) == 0)
      return argument.substr(flag.size() + 1);
    if (argument == flag || argument == "-h")
      return i + 1 < arguments.size() ? arguments[i + 1] : std::string();
  }
  return {};
}

std::string
summaryLine(const std::string& name,
            const std::string& value,
            const TerminalStyle& style)
{
  constexpr std::size_t name_width = 12;
  return style.name(name + ":") +
         std::string(name_width - std::min(name.size(), name_width - 1), ' ') + value;
}

} // namespace

Tool::Tool(std::string name, const std::string& purpose)
: name_(std::move(name))
, kind_(name_)
, app_(std::make_unique<CLI::App>(purpose, name_))
{
  app_->option_defaults()->always_capture_default();
  app_->set_help_flag(
      "-h,--help", "Print the help and stop; --help all and --help GROUP print more");
  app_->set_version_flag("--version", name_ + " (acmap) " ACMAP_VERSION);
  app_->get_option("--version")->description("Print the version and stop");
  app_->footer(exit_code_text);
  app_->add_option("--report", report_path_, "Write counts, seconds and remarks there")
      ->type_name("FILE.json")
      ->capture_default_str();
  app_->add_flag("--quiet", quiet_, "Print nothing but errors");
  app_->add_option(
          "--memory-limit",
          memory_limit_,
          "Memory this run may take, as 500MB or 2GB; one that needs more ends "
          "with exit code 6 [default: what this machine has left]")
      ->type_name("SIZE")
      ->default_str("")
      ->transform(memorySize().description(""));
}

Tool::~Tool() = default;

void
Tool::addThreads()
{
  app_->add_option(
          "--threads", threads_, "Threads; 0 = all cores; the result is the same")
      ->type_name("N")
      ->check(CLI::Range(0, int{max_threads}).description(""));
}

void
Tool::addSeed(std::uint64_t preset, const std::function<void(std::uint64_t)>& set)
{
  addSetter(*app_, "--seed", set, "Number that all randomness begins with", "N")
      ->default_str(std::to_string(preset));
}

void
Tool::addSensor(DepthSensor& sensor)
{
  addChoice<DepthSensor>(
      *app_,
      "--sensor",
      sensor,
      {{"auto", DepthSensor::Automatic},
       {"quantised", DepthSensor::Quantised},
       {"stereo", DepthSensor::Stereo},
       {"tof", DepthSensor::TimeOfFlight},
       {"laser", DepthSensor::Laser}},
      "What measured an organized cloud: quantised (structured light, as a Kinect) and "
      "stereo have noise that is even in inverse depth, and are worked on in their "
      "picture; tof and laser in space; auto: quantised where the depths have such "
      "steps, stereo where pixels err independently");
}

void
Tool::addLengthOrAuto(const std::string& name,
                      const std::function<void(double)>& set,
                      const std::string& description)
{
  automatic_options_.push_back(name);
  const std::function<void(std::string)> take = [name, set](const std::string& text) {
    double length = 0;
    if (text != "auto" && !CLI::detail::lexical_cast(text, length))
      throw CLI::ConversionError(text, name);
    set(length);
  };
  addSetter(*app_, name, take, description, "[M|auto]");
}

int
Tool::run(int argc, const char* const* argv, const std::function<void()>& work)
{
  // PCL's own messages would mix with those of the tool
  console::setVerbosityLevel(console::L_ALWAYS);
  // writing beyond the limit of the file size is reported as an error, and does not end
  // the process
  std::signal(SIGXFSZ, SIG_IGN);
  // if the reader of stdout or stderr is gone, the tool ends after its files are
  // written
  pipe_action_ = std::signal(SIGPIPE, SIG_IGN);
  noteInterruptions();
  try {
    if (const int code = parse(argc, argv); code >= 0)
      return code;
    limitMemory(memory_limit_, threads_);
    work();
    writeReport();
    bar_->stop();
    if (remembers_time_)
      rememberRunTimes(kind_, bar_->times());
    flushSummary();
    if (log_.contradiction.empty())
      return exit_done;
    complain(log_.contradiction + "; the result is in " + output_.setAside() +
             ", and nothing is in its folder");
    return exit_contradicted;
  }
  catch (...) {
    Failure failure = failureOf(std::current_exception());
    bar_->stop();
    // warnings about the input often explain the failure
    if (failure.code == exit_memory)
      for (const std::string& remark : log_.report.remarks)
        failure.line += "; " + remark;
    if (failure.code == exit_usage)
      failure.line += " (see --help)";
    if (failure.code == exit_usage || failure.code == exit_input)
      if (const std::string advice = otherDoor(); !advice.empty())
        failure.line += "; " + advice;
    complain(printable(failure.line));
    return failure.code;
  }
}

int
Tool::parse(int argc, const char* const* argv)
{
  command_line_.assign(argv, argv + argc);
  std::vector<std::string> arguments(command_line_.begin() + std::min(argc, 1),
                                     command_line_.end());
  arguments = withDoubleDashes(std::move(arguments), *app_);
  for (const std::string& name : automatic_options_)
    arguments = withAutomaticValue(std::move(arguments), name);
  if (const auto topic = helpTopicIn(arguments)) {
    print(*topic == "man" ? manPageOf(*app_, help_)
                          : helpOf(*app_, help_, *topic, terminalWidth()));
    return 0;
  }
  // CLI11 takes them in reverse order
  std::reverse(arguments.begin(), arguments.end());
  try {
    app_->parse(std::move(arguments));
  }
  catch (const CLI::Success& e) {
    std::ostringstream text;
    const int code = app_->exit(e, text, std::cerr);
    print(text.str());
    return code;
  }
  catch (const CLI::ParseError& e) {
    // the value of an unknown option is parsed as an input
    const std::string unknown = unknownOptionFault(app_->remaining(), *app_);
    if (!unknown.empty())
      throw UsageError(unknown);
    const bool is_incomplete = dynamic_cast<const CLI::RequiredError*>(&e) != nullptr;
    throw UsageError(e.what() +
                     (is_incomplete ? "; usage: " + usageOf(*app_) : std::string()));
  }
  return -1;
}

std::string
Tool::otherDoor() const
{
  for (const CLI::Option* option : app_->get_options()) {
    const bool is_input = option->get_positional() && option->get_name() != "output";
    if (!is_input)
      continue;
    for (const std::string& path : option->results())
      if (std::string advice = toolForInput(name_, option->get_name(), path);
          !advice.empty())
        return advice;
  }
  return {};
}

void
Tool::requireReportWritable(const std::vector<std::string>& others) const
{
  if (!report_path_.empty())
    requireWritable(report_path_, {".json"}, others);
}

RunControls
Tool::controls()
{
  const bool draws = !quiet_ && !is_silent_ && isatty(STDERR_FILENO);
  RunControls controls;
  controls.threads = threads_;
  controls.reader = reader_;
  controls.is_quiet = quiet_;
  controls.progress = [this, draws, bar = bar_](double fraction,
                                                const std::string& step) {
    bar->tell(fraction, printable(step));
    if (draws && !bar->isDrawn())
      bar->draw(recallRunTimes(kind_));
    return !interrupted();
  };
  controls.finished =
      [draws, bar = bar_, before = bar_->elapsed()](const std::string& stage) mutable {
        const double now = bar->elapsed();
        if (draws)
          bar->print(summaryLine(
              stage, shortNumber(now - before) + " s", TerminalStyle(STDERR_FILENO)));
        before = now;
      };
  controls.warn_at_once = [this](const std::string& remark) { warnAtOnce(remark); };
  return controls;
}

void
Tool::warnAtOnce(const std::string& remark) const
{
  if (!quiet_)
    complain(TerminalStyle(STDERR_FILENO).warning("warning: ") + printable(remark));
}

nlohmann::ordered_json
Tool::fullReport() const
{
  nlohmann::ordered_json json = {{"tool", name_},
                                 {"version", ACMAP_VERSION},
                                 {"format", file_formats::report},
                                 {"command_line", command_line_}};
  json.update(log_.details);
  if (!log_.report.seconds.empty())
    json["seconds"] = secondsOf(log_.report);
  const auto [silence, step] = bar_->longestSilence();
  json["seconds_without_progress"] = {{"seconds", silence}, {"step", step}};
  json["peak_memory_bytes"] = peakMemory();
  json["remarks"] = log_.report.remarks;
  return json;
}

void
Tool::writeReport() const
{
  if (!report_path_.empty() && !is_silent_)
    saveJson(report_path_, fullReport(), 2);
}

void
Tool::flushSummary() const
{
  if (quiet_)
    return;
  for (const std::string& remark : log_.report.remarks)
    warnAtOnce(remark);
  const TerminalStyle style(STDOUT_FILENO);
  std::string summary;
  for (const auto& [name, value] : log_.lines)
    summary +=
        summaryLine(name, name == "open" ? style.link(value) : value, style) + "\n";
  print(summary);
}

void
Tool::print(const std::string& text) const
{
  if (is_silent_)
    return;
  std::signal(SIGPIPE, pipe_action_);
  std::cout << text << std::flush;
  if (!std::cout)
    throw OutputFileException("standard output: could not be written");
}

void
Tool::complain(const std::string& line) const
{
  if (!is_silent_)
    bar_->print(name_ + ": " + line);
}

} // namespace pcl::acmap
