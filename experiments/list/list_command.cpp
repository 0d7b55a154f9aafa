#include "experiments/list/list_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "experiments/experiment.h"
#include "experiments/option_values.h"
#include "experiments/scenes/builtin_scene.h"
#include "experiments/technique_list.h"

namespace lode::experiments {
namespace {

using nlohmann::ordered_json;

struct ListOptions {
  std::string what;  ///< a kind, or empty for all
  bool json = false;
};

/// Something that can be named on the command line.
struct Entry {
  std::string name, summary;
  std::vector<Parameter> parameters;
  std::string promise = {};  ///< of a technique, with the parameters' defaults
};
struct Kind {
  std::string name;
  std::vector<Entry> entries;
};

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds = {{"scenes", {}}, {"techniques", {}}, {"experiments", {}}};
  for (const BuiltinScene& s : builtin_scenes()) kinds[0].entries.push_back({s.name, s.summary, s.parameters});
  for (const TechniqueEntry& t : technique_list()) {
    kinds[1].entries.push_back(
        {t.name, t.summary, t.parameters, techniques::name_of(read_technique("list", t.name).make().promise())});
  }
  for (const Experiment& e : experiment_list()) kinds[2].entries.push_back({e.name, e.summary, e.parameters});
  return kinds;
}

ordered_json as_json(const Entry& entry) {
  ordered_json parameters = ordered_json::array();
  const auto number = [](const Parameter& p, double value) {
    return p.whole ? ordered_json(std::int64_t(value)) : ordered_json(value);
  };
  for (const Parameter& p : entry.parameters) {
    if (!p.choices.empty()) {
      parameters.push_back({{"name", p.name},
                            {"meaning", p.meaning},
                            {"choices", p.choices},
                            {"default", value_text(p, p.default_value)}});
      continue;
    }
    parameters.push_back({{"name", p.name},
                          {"meaning", p.meaning},
                          {"low", number(p, p.low)},
                          {"high", number(p, p.high)},
                          {"default", number(p, p.default_value)},
                          {"whole", p.whole}});
  }
  ordered_json json = {{"name", entry.name}, {"summary", entry.summary}};
  if (!entry.promise.empty()) json["promise"] = entry.promise;
  json["parameters"] = parameters;
  return json;
}

std::string padded(std::string text, std::size_t n) {
  text.resize(std::max(n, text.size() + 1), ' ');
  return text;
}

std::string as_text(const Kind& kind) {
  std::string text = kind.name + ":\n";
  if (kind.entries.empty()) text += "  none\n";
  const auto assignment = [](const Parameter& p) { return p.name + "=" + value_text(p, p.default_value); };
  std::size_t name_width = 0, assignment_width = 0;
  for (const Entry& entry : kind.entries) {
    name_width = std::max(name_width, entry.name.size() + 2);
    for (const Parameter& p : entry.parameters) {
      assignment_width = std::max(assignment_width, assignment(p).size() + 2);
    }
  }
  for (const Entry& entry : kind.entries) {
    text += "  " + padded(entry.name, name_width) + entry.summary;
    text += (entry.promise.empty() ? "" : "; " + entry.promise) + "\n";
    for (const Parameter& p : entry.parameters) {
      text += "    " + padded(assignment(p), assignment_width) + p.meaning + " (" + range_text(p) + ")\n";
    }
  }
  return text;
}

void list(const ListOptions& options, const Streams& streams) {
  const std::vector<Kind> kinds = all_kinds();
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds) names.push_back(kind.name);
  const std::size_t wanted = options.what.empty() ? kinds.size() : read_choice("list", options.what, names);

  ordered_json json = ordered_json::object();
  std::string text;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (wanted != kinds.size() && wanted != k) continue;
    json[kinds[k].name] = ordered_json::array();
    for (const Entry& entry : kinds[k].entries) json[kinds[k].name].push_back(as_json(entry));
    text += (text.empty() ? "" : "\n") + as_text(kinds[k]);
  }
  streams.out << (options.json ? json.dump(1) + "\n" : text) << std::flush;
  if (!streams.out) throw Error(Status::machine_failed, "standard output: cannot be written");
}

}  // namespace

Command list_command() {
  const auto options = std::make_shared<ListOptions>();
  return {.name = "list",
          .summary = "What there is: built-in scenes, techniques, experiments, and their parameters",
          .footer = "A scene with parameters: NAME:PARAMETER=VALUE,PARAMETER=VALUE; the others keep their defaults.\n",
          .examples = {"lodestone list", "lodestone list scenes --json"},
          .add_options =
              [options](CLI::App& app) {
                app.add_option("KIND", options->what, "scenes, techniques or experiments (default all)");
                app.add_flag("--json", options->json, "For programs");
              },
          .run =
              [options](const CommonOptions&, const Streams& streams) {
                list(*options, streams);
                return Status::done;
              }};
}

}  // namespace lode::experiments
