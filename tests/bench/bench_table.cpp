#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

// Reads what the measuring programs wrote (Google Benchmark's JSON) and prints the table of ratios, then the
// times and wrong results behind them.   bench_table FILE.json...

namespace {

using Counters = std::map<std::string, double>;

const std::vector<std::string> kTools = {"ball", "bull", "taper"};
const std::vector<std::string> kSizes = {"2400", "20000", "200000", "2000000"};

/// Everything measured, by name "<measurement>/<part>/<tool>/<size>": medians where there are several runs.
class Measured {
 public:
  void read(const std::string& file) {
    std::ifstream stream(file);
    const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
    if (json.is_discarded() || !json.contains("benchmarks")) return;
    for (const auto& run : json["benchmarks"]) {
      if (run.value("error_occurred", false)) continue;
      const bool is_median = run.value("aggregate_name", "") == "median";
      if (run.value("run_type", "") == "aggregate" && !is_median) continue;
      std::string name = run.value("run_name", "");
      name = name.substr(0, name.find("/process_time"));
      name = name.substr(0, name.find("/iterations"));
      Counters counters;
      for (const auto& [key, value] : run.items()) {
        if (value.is_number()) counters[key] = value.get<double>();
      }
      if (is_median || found_.count(name) == 0) found_[name] = counters;
    }
  }

  [[nodiscard]] std::optional<double> value(const std::string& name, const std::string& counter) const {
    const auto run = found_.find(name);
    if (run == found_.end()) return {};
    const auto at = run->second.find(counter);
    if (at == run->second.end()) return {};
    return at->second;
  }
  /// Moves or poses a second of processor time.
  [[nodiscard]] std::optional<double> rate(const std::string& name) const { return value(name, "items_per_second"); }

 private:
  std::map<std::string, Counters> found_;
};

std::optional<double> ratio(std::optional<double> a, std::optional<double> b) {
  if (!a || !b || *b <= 0) return {};
  return *a / *b;
}

std::string number(std::optional<double> x) {
  if (!x) return "-";
  char text[32];
  std::snprintf(text, sizeof text, *x >= 100 ? "%.0f" : *x >= 10 ? "%.1f" : *x >= 0.1 ? "%.2f" : "%.3f", *x);
  return text;
}

enum class Wanted { at_least, at_most };

/// A line of the table: what is divided by what, and what is wanted of it.
struct Line {
  std::string title;
  std::string over, over_size, under, under_size;
  Wanted wanted = Wanted::at_least;
  double limit = 0;
};

const std::vector<Line>& lines() {
  static const std::vector<Line> kLines = {
      {"moves / Embree poses, 2.4k", "engine.moves", "2400", "embree.pose", "2400", Wanted::at_least, 1},
      {"moves / Embree poses, 200k", "engine.moves", "200000", "embree.pose", "200000", Wanted::at_least, 5},
      {"moves / Embree poses, 2M", "engine.moves", "2000000", "embree.pose", "2000000", Wanted::at_least, 30},
      {"moves / Bullet sweeps, 2.4k", "engine.moves", "2400", "bullet.sweep", "2400", Wanted::at_least, 20},
      {"moves / Bullet sweeps, 200k", "engine.moves", "200000", "bullet.sweep", "200000", Wanted::at_least, 400},
      {"cost per move, 2M / 2.4k", "engine.moves", "2400", "engine.moves", "2000000", Wanted::at_most, 2},
      {"cost, air / contact, 2.4k", "engine.contact", "2400", "engine.air", "2400", Wanted::at_most, 0.1},
      {"cost, air / contact, 200k", "engine.contact", "200000", "engine.air", "200000", Wanted::at_most, 0.1},
      {"cost, air / contact, 2M", "engine.contact", "2000000", "engine.air", "2000000", Wanted::at_most, 0.1},
      {"cost per move / floor, 2.4k", "floor.pose", "2400", "engine.moves", "2400", Wanted::at_most, 0},
      {"cost per move / floor, 200k", "floor.pose", "200000", "engine.moves", "200000", Wanted::at_most, 0},
      {"cost per move / floor, 2M", "floor.pose", "2000000", "engine.moves", "2000000", Wanted::at_most, 0}};
  return kLines;
}

std::string cell(std::optional<double> x, Wanted wanted, double limit) {
  if (!x || limit <= 0) return number(x);
  const bool is_reached = wanted == Wanted::at_least ? *x >= limit : *x <= limit;
  return number(x) + (is_reached ? "" : " (missed)");
}

std::string wanted_text(Wanted wanted, double limit) {
  if (limit <= 0) return "shown";
  return (wanted == Wanted::at_least ? ">= " : "<= ") + number(limit);
}

std::optional<double> ratio_of(const Measured& m, const Line& line, const std::string& part, const std::string& tool) {
  return ratio(m.rate(line.over + "/" + part + "/" + tool + "/" + line.over_size),
               m.rate(line.under + "/" + part + "/" + tool + "/" + line.under_size));
}

void print_row(const std::string& title, const std::string& wanted, const std::vector<std::string>& cells) {
  std::printf("| %s | %s |", title.c_str(), wanted.c_str());
  for (const std::string& text : cells) std::printf(" %s |", text.c_str());
  std::printf("\n");
}

/// Ten times the positions: cost of the whole path over that of the plain one at the same size.
std::optional<double> dense_cost(const Measured& m, const std::string& part, const std::string& tool) {
  for (const std::string& size : kSizes) {
    const std::string rest = "/" + part + "/" + tool + "/" + size;
    const auto dense = m.rate("engine.dense" + rest);
    if (!dense) continue;
    const auto factor = ratio(m.value("engine.dense" + rest, "moves"), m.value("engine.moves" + rest, "moves"));
    const auto slower = ratio(m.rate("engine.moves" + rest), dense);
    if (factor && slower) return *factor * *slower;
  }
  return {};
}

/// Wall-clock time of one thread over that of two.
std::optional<double> speedup(const Measured& m, const std::string& part, const std::string& tool,
                              const std::string& size) {
  const std::string rest = "/" + part + "/" + tool + "/" + size;
  return ratio(m.value("engine.moves" + rest, "real_time"), m.value("engine.two_threads" + rest, "real_time"));
}

std::string same_bytes(const Measured& m, const std::string& part, const std::string& tool) {
  bool is_any = false;
  for (const std::string& size : kSizes) {
    const std::string rest = "/" + part + "/" + tool + "/" + size;
    const auto one = m.value("engine.moves" + rest, "hash"), two = m.value("engine.two_threads" + rest, "hash");
    if (!one || !two) continue;
    is_any = true;
    if (std::abs(*one - *two) > 0) return "no (missed)";
  }
  return is_any ? "yes" : "-";
}

void print_ratios(const Measured& m, const std::string& part) {
  std::printf("\n## Ratios, %s part\n\n| ratio | wanted | ball | bull-nose | taper |\n|---|---|---|---|---|\n",
              part.c_str());
  for (const Line& line : lines()) {
    std::vector<std::string> cells;
    for (const std::string& tool : kTools) {
      cells.push_back(cell(ratio_of(m, line, part, tool), line.wanted, line.limit));
    }
    print_row(line.title, wanted_text(line.wanted, line.limit), cells);
  }
  for (const std::string& size : kSizes) {
    std::vector<std::string> cells;
    for (const std::string& tool : kTools) cells.push_back(cell(speedup(m, part, tool, size), Wanted::at_least, 1.8));
    print_row("two threads / one, " + size, ">= 1.80", cells);
  }
  std::vector<std::string> dense, bytes;
  for (const std::string& tool : kTools) {
    dense.push_back(cell(dense_cost(m, part, tool), Wanted::at_most, 3));
    bytes.push_back(same_bytes(m, part, tool));
  }
  print_row("cost of ten times as many positions", "< 3", dense);
  print_row("same bytes with two threads", "yes", bytes);
}

void print_loading(const Measured& m) {
  const auto load_ms = m.value("loading.all", "cpu_time");
  const auto embree_ms = ratio(m.value("embree.build/wavy/ball/2000000", "cpu_time"), 1e3);
  std::printf("\n## Files, 2,000,000 triangles\n\n| what | wanted | measured |\n|---|---|---|\n");
  print_row("load, weld and tree / Embree's tree of medium quality", "<= 2",
            {cell(ratio(load_ms, embree_ms), Wanted::at_most, 2)});
  print_row("load, weld and tree, ms", "shown", {number(load_ms)});
  print_row("of it reading and welding, ms", "shown", {number(m.value("loading.read_and_weld", "cpu_time"))});
  print_row("of it the tree, ms", "shown", {number(m.value("loading.tree", "cpu_time"))});
  print_row("Embree's tree, ms", "shown", {number(embree_ms)});
  print_row("peak memory, bytes a triangle", "<= 120",
            {cell(m.value("loading.peak", "bytes_per_triangle"), Wanted::at_most, 120)});
  print_row("toolpath text, MB/s", ">= 150",
            {cell(ratio(m.value("loading.parse", "bytes_per_second"), 1e6), Wanted::at_least, 150)});
}

/// How the ratios of the part that was not tuned for compare with those of the other.
void print_unseen(const Measured& m) {
  std::printf(
      "\n## Ratios of the unseen part over those of the wavy one\n\n"
      "Within a third: from 0.67, where more is better, or up to 1.33, where less is.\n\n"
      "| ratio | wanted | ball | bull-nose | taper |\n|---|---|---|---|---|\n");
  const auto print = [&](const std::string& title, Wanted wanted, const auto& of) {
    std::vector<std::string> cells;
    const double limit = wanted == Wanted::at_least ? 2.0 / 3 : 4.0 / 3;
    for (const std::string& tool : kTools) {
      cells.push_back(cell(ratio(of("unseen", tool), of("wavy", tool)), wanted, limit));
    }
    print_row(title, wanted_text(wanted, limit), cells);
  };
  for (const Line& line : lines()) {
    if (line.limit <= 0) continue;
    print(line.title, line.wanted,
          [&](const std::string& part, const std::string& tool) { return ratio_of(m, line, part, tool); });
  }
  print("cost of ten times as many positions", Wanted::at_most,
        [&](const std::string& part, const std::string& tool) { return dense_cost(m, part, tool); });
}

/// "12.3; 1+2 of 400": microseconds, then results that missed a gouge and that invented one.
std::string time_cell(const Measured& m, const std::string& name) {
  const auto rate = m.rate(name);
  if (!rate || *rate <= 0) return "-";
  if (name.find("two_threads") != std::string::npos) {
    return number(ratio(m.value(name, "real_time"), m.value(name, "moves")));
  }
  std::string text = number(1e6 / *rate);
  const auto asked = m.value(name, "asked");
  if (!asked) return text;
  const auto count = [&](const char* counter) {
    return std::to_string(std::lround(m.value(name, counter).value_or(0)));
  };
  text += "; " + count("missed") + "+" + count("invented") + " of " + std::to_string(std::lround(*asked));
  if (m.value(name, "broken_bounds").value_or(0) > 0) text += ", bounds broken: " + count("broken_bounds");
  return text;
}

void print_times(const Measured& m, const std::string& part) {
  static const std::vector<std::string> kNames = {
      "engine.moves",  "engine.contact",  "engine.air",  "engine.gouge",     "engine.holder", "engine.two_threads",
      "engine.dense",  "floor.pose",      "embree.pose", "embree.one_cover", "bullet.sweep",  "bullet.pose",
      "fcl.ten_steps", "fcl.advancement", "fcl.pose",    "ode.pose",         "cgal.pose"};
  std::printf(
      "\n## Microseconds a move or pose, %s part; missed gouges + invented ones of those asked\n\nOf the processor; "
      "with two threads of the clock.\n\n",
      part.c_str());
  std::printf("| what | tool | 2.4k | 20k | 200k | 2M |\n|---|---|---|---|---|---|\n");
  for (const std::string& name : kNames) {
    for (const std::string& tool : kTools) {
      std::vector<std::string> cells;
      for (const std::string& size : kSizes) cells.push_back(time_cell(m, name + "/" + part + "/" + tool + "/" + size));
      if (std::all_of(cells.begin(), cells.end(), [](const std::string& c) { return c == "-"; })) continue;
      print_row(name, tool, cells);
    }
  }
}

}  // namespace

int main(int count, char** words) {
  Measured measured;
  for (int k = 1; k < count; ++k) measured.read(words[k]);
  for (const char* part : {"wavy", "unseen"}) print_ratios(measured, part);
  print_unseen(measured);
  print_loading(measured);
  for (const char* part : {"wavy", "unseen"}) print_times(measured, part);
  return 0;
}
