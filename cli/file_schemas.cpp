#include "cli/file_schemas.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands/job_words.h"
#include "cli/output/json_text.h"
#include "cli/project_file.h"

namespace gouge {
namespace {

constexpr const char* kDraft = "https://json-schema.org/draft/2020-12/schema";

Json reference(const char* definition) { return {{"$ref", std::string("#/$defs/") + definition}}; }

/// Returns the schema of the values of an option.
Json schema_of(const OptionKind& kind) {
  if (kind.is_flag) return {{"type", "boolean"}};
  if (!kind.choices.empty()) return {{"enum", kind.choices}};
  if (kind.is_repeatable) return reference("texts");
  if (kind.type == "BODY=LENGTH") return {{"oneOf", {reference("text"), reference("lengths_of_bodies")}}};
  if (kind.type == "LENGTH") return reference("length");
  if (kind.type == "SIZE" || kind.type.starts_with("DEG")) return {{"type", {"string", "number"}}};
  return reference("text");
}

/// Returns the schemas of all options by their keys. With `is_job` they allow null, which removes a value of the
/// defaults.
Json option_schemas(bool is_job) {
  const Json none = {{"type", "null"}};
  Json all = Json::object();
  for (const OptionKind& kind : project_options()) {
    const Json values = schema_of(kind);
    all[key_of_option(kind.key)] = is_job ? Json({{"anyOf", {values, none}}}) : values;
  }
  return all;
}

/// Adds the options of a command that a job may have and a project file may not, such as outputs.
void add_options_of_jobs(const std::string& command, Json& all) {
  for (const CLI::Option* option : option_table(command).get_options()) {
    if (option->get_lnames().empty() || job_rules().why_not(*option)) continue;
    const std::string key = key_of_option(option->get_lnames().front());
    if (key == "help" || all.contains(key)) continue;
    const bool is_flag = option->get_items_expected_max() == 0, is_repeatable = option->get_items_expected_max() > 1;
    const Json values = is_flag ? Json({{"type", "boolean"}}) : reference(is_repeatable ? "texts" : "text");
    all[key] = {{"anyOf", {values, {{"type", "null"}}}}};
  }
}

Json definitions() {
  const Json text = {{"type", {"string", "number"}}, {"minLength", 1}};
  const Json body = {{"shank", reference("length")}, {"holder", reference("length")}};
  return {
      {"text", text},
      {"texts", {{"type", {"string", "number", "array"}}, {"minLength", 1}, {"items", text}, {"minItems", 1}}},
      {"length",
       {{"description", "A number is in mm; a text may carry a unit: \"0.0005in\"."}, {"type", {"string", "number"}}}},
      {"lengths_of_bodies",
       {{"type", "object"}, {"minProperties", 1}, {"properties", body}, {"additionalProperties", false}}}};
}

}  // namespace

std::string project_schema() {
  const Json schema = {{"$schema", kDraft},
                       {"title", "Project file of gougecheck (gougecheck.json)"},
                       {"type", "object"},
                       {"properties", option_schemas(false)},
                       {"additionalProperties", false},
                       {"$defs", definitions()}};
  return schema.dump(1) + "\n";
}

std::string jobs_schema() {
  Json properties = {
      {"command", {{"enum", {"check", "correct"}}}}, {"path", reference("texts")}, {"report", {{"type", "boolean"}}}};
  properties.update(option_schemas(true));
  for (const char* const command : {"check", "correct"}) add_options_of_jobs(command, properties);
  Json all = definitions();
  all["options"] = {{"description", "The options of check and correct, by their long names."},
                    {"type", "object"},
                    {"properties", std::move(properties)}};
  all["job"] = {{"description", "Options that a job leaves out come from the defaults."},
                {"type", "object"},
                {"properties", {{"name", {{"type", "string"}, {"minLength", 1}, {"maxLength", 100}}}}},
                {"$ref", "#/$defs/options"},
                {"unevaluatedProperties", false}};
  Json defaults = reference("options");
  defaults["unevaluatedProperties"] = false;
  const Json schema = {{"$schema", kDraft},
                       {"title", "Job list of gougecheck batch"},
                       {"type", "object"},
                       {"required", {"jobs"}},
                       {"properties",
                        {{"defaults", std::move(defaults)},
                         {"jobs", {{"type", "array"}, {"minItems", 1}, {"items", reference("job")}}}}},
                       {"additionalProperties", false},
                       {"$defs", std::move(all)}};
  return schema.dump(1) + "\n";
}

}  // namespace gouge
