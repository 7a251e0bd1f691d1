#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/sealed_result.h"

// gougecheck verify on the results and certificates of the samples, and on what was made of them by hand.

namespace gouge::testing_samples::verify_test {
namespace {

using nlohmann::json;

SampleFolder checked_sample(const std::string& name, const std::vector<std::string>& more = {}) {
  SampleFolder sample = open_sample(name);
  std::vector<std::string> options{"--json", "result.json", "--certificate", "proofs.gcp", "-q"};
  options.insert(options.end(), more.begin(), more.end());
  const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), options));
  EXPECT_LE(ran.exit_status, 4) << ran.err;
  return sample;
}

Outcome verify(const SampleFolder& sample, const std::vector<std::string>& more = {"--certificate", "proofs.gcp"}) {
  std::vector<std::string> arguments{"verify", "result.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_gougecheck(sample.path, arguments);
}

json result_of(const SampleFolder& sample) { return json::parse(text_of(sample.path + "/result.json")); }

/// What a refutation states, and the change of a result that it refutes.
using Changes = std::vector<std::pair<const char*, std::function<void(json&)>>>;

/// That each change of `whole`, with a right digest, is refuted.
void expect_refuted(const SampleFolder& sample, const json& whole, const Changes& changes) {
  for (const auto& [what, change] : changes) {
    json changed = whole;
    change(changed);
    write_text(sample.path + "/result.json", sealed(changed));
    const Outcome ran = verify(sample, {});
    EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
    EXPECT_NE(ran.out.find(what), std::string::npos) << ran.out;
  }
}

class Verify : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Samples, Verify, ::testing::ValuesIn(sample_names()),
                         [](const auto& test) { return test.param; });

TEST_P(Verify, AcceptsTheCertificateOfEverySample) {
  const SampleFolder sample = checked_sample(GetParam());
  const json totals = result_of(sample).at("totals");
  const bool is_all_covered =
      totals.at("buried") == 0 && totals.at("not_checked") == 0 && totals.at("not_certified") == 0;
  const Outcome ran = verify(sample);
  EXPECT_EQ(ran.exit_status, is_all_covered ? 0 : 4) << ran.out << ran.err;
  EXPECT_EQ(ran.out.find("refuted:"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("said to be clean"), std::string::npos) << ran.out;
}

TEST(VerifyCommand, SaysThatWithoutACertificateCleanMovesAreOnlySampled) {
  const SampleFolder sample = checked_sample("pocket");
  const Outcome ran = verify(sample, {});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("only sampled: 134 moves said to be clean (no certificate)"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("verified: 4 witnesses"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("result: verified"), std::string::npos) << ran.out;
}

TEST(VerifyCommand, FindsInputsBesideTheResultAndRefusesThoseThatChanged) {
  const SampleFolder sample = checked_sample("pocket");
  const std::string above = std::filesystem::path(sample.path).parent_path();
  EXPECT_EQ(run_gougecheck(above, {"verify", "pocket/result.json", "-q"}).exit_status, 0);
  for (const char* name : {"pocket.apt", "part.stl", "clamp.stl", "tools.json"}) {
    const std::string file = sample.path + "/" + name, whole = text_of(file);
    std::string changed = whole;
    changed[changed.size() / 2] ^= 1;
    write_text(file, changed);
    const Outcome ran = verify(sample);
    EXPECT_EQ(ran.exit_status, 1) << name << ran.out << ran.err;
    EXPECT_NE(ran.out.find("is not the file that was checked (its SHA-256 differs)"), std::string::npos) << ran.out;
    write_text(file, whole);
  }
  EXPECT_EQ(verify(sample).exit_status, 0);
}

TEST(VerifyCommand, RefusesTheCertificateOfAnotherSetUp) {
  const SampleFolder sample = checked_sample("pocket");
  const auto check = [&](const std::vector<std::string>& more) {
    (void)run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), more));
  };
  check({"--place", "0,0,5", "--json", "moved.json", "--certificate", "moved.gcp", "-q"});
  check({"--stl-units", "inch", "--assume", "placement", "--certificate", "inch.gcp", "-q"});
  check({"--stock-to-leave", "0.05", "--certificate", "offset.gcp", "-q"});
  check({"--rapid", "skip", "--certificate", "skip.gcp", "-q"});
  check({"--path-units", "inch", "--assume", "placement", "--certificate", "path.gcp", "-q"});
  const auto verify_by = [&](const std::string& certificate) {
    return run_gougecheck(sample.path, {"verify", "result.json", "--certificate", certificate});
  };
  for (const char* other : {"moved.gcp", "inch.gcp", "offset.gcp", "skip.gcp", "path.gcp"}) {
    const Outcome ran = verify_by(other);
    EXPECT_EQ(ran.exit_status, 3) << other << ran.out << ran.err;
    EXPECT_EQ(ran.out.find("refuted"), std::string::npos) << ran.out;
  }
  EXPECT_NE(run_gougecheck(sample.path, {"verify", "moved.json", "--certificate", "moved.gcp"}).exit_status, 3);
}

// The library is changed by 0.01 mm and the result states that it was so: the proofs and witnesses must show.
TEST(VerifyCommand, FindsAToolThatIsNotTheOneThatWasChecked) {
  const SampleFolder sample = checked_sample("pocket");
  json tools = json::parse(text_of(sample.path + "/tools.json"));
  auto& cutter = tools.at("tools").at(0).at("cutter");
  cutter["diameter"] = cutter.at("diameter").get<double>() + 0.01;
  write_text(sample.path + "/tools.json", tools.dump());
  const Outcome sum = run_script(sample.path, "sha256sum tools.json");
  json result = result_of(sample);
  for (json& input : result.at("inputs"))
    if (input.at("role") == "tools") {
      input["checksum"] = "sha256:" + sum.out.substr(0, 64);
      input["bytes"] = tools.dump().size();
    }
  write_text(sample.path + "/result.json", sealed(result));
  EXPECT_EQ(verify(sample, {}).exit_status, 1);
  EXPECT_EQ(verify(sample).exit_status, 3);  // the certificate is about other inputs
}

// As the library and Python write it, which take parts and tools from memory.
TEST(VerifyCommand, RefusesAResultThatNamesNoFileOfAPartOrATool) {
  const SampleFolder sample = checked_sample("pocket");
  for (const auto& [role, what] : {std::pair("part", "the part part.stl"), {"tools", "the tool "}}) {
    json result = result_of(sample), kept = json::array();
    for (const json& input : result.at("inputs"))
      if (input.at("role") != role) kept.push_back(input);
    result["inputs"] = kept;
    const std::string whole = text_of(sample.path + "/result.json");
    write_text(sample.path + "/result.json", sealed(result));
    const Outcome ran = verify(sample, {});
    EXPECT_EQ(ran.exit_status, 3) << ran.out;
    EXPECT_NE(ran.err.find(std::string("the result does not name the file of ") + what), std::string::npos) << ran.err;
    write_text(sample.path + "/result.json", whole);
  }
}

TEST(VerifyCommand, FindsWhatIsChangedInAResult) {
  const SampleFolder sample = checked_sample("pocket");
  const json whole = result_of(sample);
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes = {
      {"depth", [](json& r) { r["moves"][0]["depth"] = r["moves"][0]["depth"].get<double>() - 1e-5; }},
      {"bound", [](json& r) { r["moves"][0]["depth_upper"] = r["moves"][0]["depth"].get<double>() - 1e-5; }},
      {"instant", [](json& r) { r["moves"][0]["witness"]["t"] = 1.5; }},
      {"triangle", [](json& r) { r["moves"][0]["witness"]["triangle"] = 0; }},
      {"no triangle", [](json& r) { r["moves"][0]["witness"]["triangle"] = 4000000000U; }},
      {"no mesh", [](json& r) { r["moves"][0]["witness"]["mesh"] = "other.stl"; }},
      {"line", [](json& r) { r["moves"][0]["line"] = 1; }},
      {"move removed", [](json& r) { r["moves"].erase(0); }},
      {"move removed and counted so",
       [](json& r) {
         r["moves"].erase(0);
         r["totals"]["gouge"] = r["totals"]["gouge"].get<int>() - 1;
         r["totals"]["clean"] = r["totals"]["clean"].get<int>() + 1;
       }},
      {"all gouges removed and called clean",
       [](json& r) {
         r["moves"] = json::array();
         r["events"] = json::array();
         r["totals"]["clean"] = r["totals"]["moves"];
         r["totals"]["gouge"] = 0;
         r["verdict"] = "clean";
         r["exit_status"] = 0;
       }},
      {"one gouge removed with its finding",
       [](json& r) {
         r["moves"].erase(3);
         r["events"].erase(2);
         r["totals"]["gouge"] = r["totals"]["gouge"].get<int>() - 1;
         r["totals"]["clean"] = r["totals"]["clean"].get<int>() + 1;
       }},
      {"finding removed", [](json& r) { r["events"].erase(0); }},
      {"verdict", [](json& r) { r["verdict"] = "clean"; }},
      {"called near", [](json& r) { r["moves"][0]["state"] = "near"; }},
      {"moves", [](json& r) { r["totals"]["moves"] = 10; }},
      {"tolerance", [](json& r) { r["options"]["tolerance"] = 100; }},
      {"largest depth", [](json& r) { r["totals"]["worst_depth"] = r["totals"]["worst_depth"].get<double>() / 2; }},
      {"largest overcut", [](json& r) { r["totals"]["worst_overcut"] = 1e-3; }},
      {"overcut", [](json& r) { r["moves"][0]["overcut"] = 50; }},
  };
  for (const auto& [what, change] : changes) {
    json changed = whole;
    change(changed);
    write_text(sample.path + "/result.json", sealed(changed));
    const Outcome ran = verify(sample, {});
    EXPECT_EQ(ran.exit_status, 1) << what << ": " << ran.out << ran.err;
    EXPECT_NE(ran.out.find("refuted: "), std::string::npos) << what;
  }
}

TEST(VerifyCommand, FindsInputsInTheFoldersAboveAReport) {
  const SampleFolder sample = open_sample("pocket");
  const std::vector<std::string> report{"--report", "deep/er/rep", "-q"};
  EXPECT_EQ(run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), report)).exit_status, 1);
  EXPECT_EQ(run_gougecheck("/", {"verify", sample.path + "/deep/er/rep", "-q"}).exit_status, 0);
  const std::string link = std::filesystem::path(sample.path).parent_path().string() + "/link";
  std::filesystem::create_directory_symlink(sample.path + "/deep/er", link);
  EXPECT_EQ(run_gougecheck("/", {"verify", link + "/rep", "-q"}).exit_status, 0) << "the folders of its target";
  std::filesystem::remove(sample.path + "/part.stl");
  const Outcome ran = run_gougecheck("/", {"verify", sample.path + "/deep/er/rep"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("nor in the folder of the result or in one above it; expected the part"), std::string::npos)
      << ran.err;
}

TEST(VerifyCommand, RefutesAFileWhoseBytesWereChanged) {
  const SampleFolder sample = checked_sample("pocket");
  const std::string whole = text_of(sample.path + "/result.json");
  std::string edited = whole;
  const std::size_t at = edited.find("\"description\": \"");
  ASSERT_NE(at, std::string::npos);
  edited.insert(at + std::string("\"description\": \"").size(), "another ");
  write_text(sample.path + "/result.json", edited);
  const Outcome ran = verify(sample);
  EXPECT_EQ(ran.exit_status, 1) << ran.out;
  EXPECT_NE(ran.out.find("refuted: its digest is of other bytes"), std::string::npos) << ran.out;
  json without = json::parse(whole);
  without.erase("digest");
  write_text(sample.path + "/result.json", without.dump(1) + "\n");
  EXPECT_NE(verify(sample).out.find("refuted: it has no digest"), std::string::npos);
  write_text(sample.path + "/result.json", sealed(json::parse(whole)));
  EXPECT_EQ(verify(sample).exit_status, 0) << "other blanks under a right digest";
}

TEST(VerifyCommand, AResultThatSaysWhatCannotBeIsRefusedByLineAndField) {
  const SampleFolder sample = checked_sample("pocket");
  const json whole = result_of(sample);
  const std::vector<std::pair<const char*, std::function<void(json&)>>> changes = {
      {"'/unit' is \"furlong\"; expected one of mm, in", [](json& r) { r["unit"] = "furlong"; }},
      {"'/totals/moves' is -1; expected a whole number of 0 or more", [](json& r) { r["totals"]["moves"] = -1; }},
      {"'/options/rapid' is \"bent\"; expected one of straight", [](json& r) { r["options"]["rapid"] = "bent"; }},
      {"'/options/tolerance' is -0.01; expected a length of 0 or more",
       [](json& r) { r["options"]["tolerance"] = -0.01; }},
      {"'/options/resolution' is 1e+308; expected a length",
       [](json& r) { r["unit"] = "in", r["options"]["resolution"] = 1e308; }},
      {"'/options/more/place/0' is 1; expected a text", [](json& r) { r["options"]["more"]["place"] = {1}; }},
      {"'/moves/0/state' is \"fine\"; expected one of clean, near", [](json& r) { r["moves"][0]["state"] = "fine"; }},
      {"'/moves/0/move' is 2.5; expected a whole number", [](json& r) { r["moves"][0]["move"] = 2.5; }},
      {"'/moves/1/depth' is \"deep\"; expected a number", [](json& r) { r["moves"][1]["depth"] = "deep"; }},
      {"'/moves/1/witness/point' is [1,2]; expected three numbers",
       [](json& r) {
         r["moves"][1]["witness"]["point"] = {1, 2};
       }},
      {"'/moves/1/witness/body' is \"spoon\"; expected one of cutter",
       [](json& r) { r["moves"][1]["witness"]["body"] = "spoon"; }},
      {"'/inputs/0/name' is \"pocket.apt\\u0000\"; expected the name of a file",
       [](json& r) { r["inputs"][0]["name"] = std::string("pocket.apt\0", 11); }},
      {"'/baseline' is nothing; expected it to be there", [](json& r) { r.erase("baseline"); }},
  };
  for (const auto& [message, change] : changes) {
    json changed = whole;
    change(changed);
    write_text(sample.path + "/result.json", sealed(changed));
    const Outcome ran = verify(sample, {});
    EXPECT_EQ(ran.exit_status, 3) << message << ": " << ran.out << ran.err;
    EXPECT_EQ(ran.err.rfind("result.json:", 0), 0U) << ran.err;
    EXPECT_NE(ran.err.find(std::string(": error: ") + message), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find(" [result-field]\n"), std::string::npos) << ran.err;
  }
}

// Its moves are what it states, and its first lines what people and scripts examine.
TEST(VerifyCommand, FindsAVerdictThatIsNotThatOfTheMoves) {
  const SampleFolder sample = checked_sample("pocket");
  const json whole = result_of(sample);
  const Changes changes = {
      {"its verdict is 'clean', that of its totals 'gouges'", [](json& r) { r["verdict"] = "clean"; }},
      {"its verdict is 'accepted-gouges', that of its totals 'gouges'",
       [](json& r) { r["verdict"] = "accepted-gouges"; }},
      {"its exit status is 0, that of its verdict 1", [](json& r) { r["exit_status"] = 0; }},
  };
  expect_refuted(sample, whole, changes);
}

// The verdict "accepted gouges" rests on the file of accepted findings, so that file and what it accepts are verified.
TEST(VerifyCommand, VerifiesAcceptancesByTheFileOfAcceptedFindings) {
  const SampleFolder sample = checked_sample("pocket");
  const auto run = [&](const std::vector<std::string>& words) { return run_gougecheck(sample.path, words); };
  ASSERT_EQ(run({"accept", "result.json", "-o", "accepted.json", "--all", "--reason", "r", "--by", "b"}).exit_status,
            0);
  const Outcome checked =
      run(sample.arguments("check", sample.toolpath(), {"--baseline", "accepted.json", "--json", "result.json", "-q"}));
  ASSERT_EQ(checked.exit_status, 0) << checked.out << checked.err;
  const Outcome right = verify(sample, {});
  EXPECT_EQ(right.exit_status, 0) << right.out << right.err;
  const json whole = result_of(sample);
  const Changes changes = {
      {"its '/baseline/entries/0/by' is \"c\"", [](json& r) { r["baseline"]["entries"][0]["by"] = "c"; }},
      {"its '/baseline/accepted_moves' is 99", [](json& r) { r["baseline"]["accepted_moves"] = 99; }},
      {"its '/events/0/acceptance/is_accepted' is false",
       [](json& r) { r["events"][0]["acceptance"]["is_accepted"] = false; }}};
  expect_refuted(sample, whole, changes);
  write_text(sample.path + "/result.json", whole.dump(1) + "\n");
  EXPECT_EQ(run({"accept", "accepted.json", "--withdraw", "1"}).exit_status, 0);
  const Outcome withdrawn = verify(sample, {});
  EXPECT_EQ(withdrawn.exit_status, 1) << withdrawn.out;
  EXPECT_NE(withdrawn.out.find("the baseline accepted.json is not the file that was checked"), std::string::npos)
      << withdrawn.out;
  std::filesystem::remove(sample.path + "/accepted.json");
  EXPECT_EQ(verify(sample, {}).exit_status, 3);
}

TEST(VerifyCommand, ComparesTheProjectFileWithTheResult) {
  const SampleFolder sample = open_sample("between_rib");
  write_text(sample.path + "/gougecheck.json", R"({"part": "part.stl", "tools": "tools.json", "tolerance": 0.02})");
  (void)run_gougecheck(sample.path, {"check", sample.toolpath(), "--json", "result.json", "-q"});
  EXPECT_EQ(verify(sample, {}).exit_status, 0);
  write_text(sample.path + "/gougecheck.json", R"({"part": "part.stl", "tools": "tools.json", "tolerance": 0.03})");
  const Outcome ran = verify(sample, {});
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("the project gougecheck.json is not the file that was checked"), std::string::npos) << ran.out;
}

TEST(VerifyCommand, AResultOfATrillionMovesTakesNoMemory) {
  const SampleFolder sample = checked_sample("between_rib");
  json result = result_of(sample);
  result["totals"]["moves"] = 1'000'000'000'000;
  write_text(sample.path + "/result.json", sealed(result));
  const Outcome ran = verify(sample, {});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("the result has 1000000000000 moves and the toolpath 2"), std::string::npos) << ran.out;
}

TEST(VerifyCommand, NamesTheMoveTheInstantAndThePointThatRefuteAResult) {
  const SampleFolder sample = checked_sample("pocket");
  json result = result_of(sample);
  const json first = result.at("moves").at(0);
  result.at("moves").at(0).at("depth") = 1;
  write_text(sample.path + "/result.json", sealed(result));
  const Outcome ran = verify(sample, {});
  const std::string start = "pocket.apt:" + std::to_string(first.at("line").get<int>()) + ": refuted: its witness: ";
  EXPECT_NE(ran.out.find(start), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(", move " + std::to_string(first.at("move").get<int>()) + " t="), std::string::npos)
      << ran.out;
}

TEST(VerifyCommand, RefusesWhatIsNoResultAndNoCertificate) {
  const SampleFolder sample = checked_sample("pocket");
  const auto status = [&](const std::string& result, const std::string& certificate) {
    return run_gougecheck(sample.path, {"verify", result, "--certificate", certificate}).exit_status;
  };
  write_text(sample.path + "/no.json", "{\"format\": \"gougecheck-report\", \"format_version\": 1}");
  write_text(sample.path + "/empty", "");
  EXPECT_EQ(status("no.json", "proofs.gcp"), 3);
  EXPECT_EQ(status("empty", "proofs.gcp"), 3);
  EXPECT_EQ(status("part.stl", "proofs.gcp"), 3);
  EXPECT_EQ(status("missing.json", "proofs.gcp"), 3);
  EXPECT_EQ(status("result.json", "missing.gcp"), 3);
  EXPECT_EQ(status("result.json", "empty"), 3);
  EXPECT_EQ(status("result.json", "result.json"), 3);
  EXPECT_EQ(status("result.json", ""), 2);
  EXPECT_EQ(run_gougecheck(sample.path, {"verify", "result.json", "--seconds", "x"}).exit_status, 2);
  EXPECT_NE(run_gougecheck(sample.path, {"verify", "result.json", "--seconds", "1e9"}).err.find("from 0 to 1000000"),
            std::string::npos);
  EXPECT_EQ(run_gougecheck(sample.path, {"verify", "result.json", "--seconds", "0.1", "-q"}).exit_status, 0);
  std::filesystem::remove(sample.path + "/part.stl");
  EXPECT_EQ(status("result.json", "proofs.gcp"), 3);
}

TEST(VerifyCommand, TakesTheOptionsOfTheCheckFromTheResult) {
  const SampleFolder sample =
      checked_sample("inch", {"--tolerance", "0.02", "--stock-to-leave", "0.03", "--clearance", "shank=0.1,holder=0.2",
                              "--rapid", "dogleg", "--near-miss", "0.5", "--extend-up"});
  const Outcome ran = verify(sample);
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
}

}  // namespace
}  // namespace gouge::testing_samples::verify_test
