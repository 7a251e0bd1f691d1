#include "postproc/report_files/manifest.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "lib/base/files.h"
#include "lib/base/sha256.h"
#include "lib/json/json_file.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;  // keys stay in the order they are written

constexpr std::uintmax_t kMaxManifestBytes = 1 << 16;
constexpr const char* kFormat = "gougecheck-report-manifest";
constexpr int kVersion = 1;

std::optional<ManifestEntry> read_entry(const nlohmann::json& json) {
  if (!json.is_object() || !json.contains("name") || !json.contains("bytes") || !json.contains("sha256"))
    return std::nullopt;
  if (!json["name"].is_string() || !json["bytes"].is_number_unsigned() || !json["sha256"].is_string())
    return std::nullopt;
  return ManifestEntry{json["name"], json["bytes"], json["sha256"]};
}

}  // namespace

bool ReportManifest::has(const ManifestEntry& file) const { return std::ranges::find(files, file) != files.end(); }

std::string write_manifest(const ReportManifest& manifest) {
  Json files = Json::array();
  for (const ManifestEntry& file : manifest.files)
    files.push_back(Json{{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  Json json = {{"format", kFormat},
               {"format_version", kVersion},
               {"program", Json{{"name", kProgramName}, {"version", kProgramVersion}}},
               {"complete", manifest.is_complete},
               {"files", files}};
  if (!manifest.toolpath.empty()) json["toolpath"] = manifest.toolpath;
  return json.dump(1) + "\n";
}

std::optional<ReportManifest> read_manifest(std::string_view text) {
  const Result<JsonFile> read = parse_json(kManifestName, text, {"manifest", "manifest", "a manifest"});
  if (!read) return std::nullopt;
  const nlohmann::json& json = read->root;
  if (!json.is_object() || json.value("format", Json()) != kFormat || json.value("format_version", Json()) != kVersion)
    return std::nullopt;
  if (!json.contains("files") || !json["files"].is_array()) return std::nullopt;
  ReportManifest manifest;
  manifest.is_complete = json.value("complete", nlohmann::json()) == true;
  const nlohmann::json toolpath = json.value("toolpath", nlohmann::json(""));
  if (toolpath.is_string()) manifest.toolpath = toolpath;
  for (const nlohmann::json& file : json["files"]) {
    std::optional<ManifestEntry> entry = read_entry(file);
    if (!entry) return std::nullopt;
    manifest.files.push_back(std::move(*entry));
  }
  return manifest;
}

ManifestEntry describe_bytes(std::string name, std::string_view bytes) {
  return {std::move(name), bytes.size(), sha256_of(bytes)};
}

Result<ManifestEntry> describe_file(const std::string& folder, const std::string& name) {
  const std::string path = folder + "/" + name;
  std::ifstream file(path, std::ios::binary);
  ManifestEntry entry{name, 0, {}};
  Sha256 hash;
  std::string piece(1 << 16, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(file.gcount());
    hash.add(std::string_view(piece).substr(0, count));
    entry.bytes += count;
  }
  if (!file.eof()) return make_error("file-unreadable", "cannot read the file", path);
  entry.sha256 = hash.finish();
  return entry;
}

Result<std::optional<ReportManifest>> manifest_in(const std::string& folder) {
  const std::string path = folder + "/" + kManifestName;
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (!error && bytes > kMaxManifestBytes) return std::optional<ReportManifest>();
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  return read_manifest(*text);
}

}  // namespace gouge
