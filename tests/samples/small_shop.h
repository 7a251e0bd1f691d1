#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// A plate and a path over it, small enough that a person sees at once what must be stated of it: the flat cutter of 10 mm
// runs along y = 50 on the plate's top, z = 0, and is as deep in it as z is below.

namespace gouge::testing_samples {

/// A position of the path: x and z.
struct Station {
  double x = 0, z = 0;
};

/// Stations every 10 mm from x = 10 to 90 on the plate, with those of `changed` instead.
[[nodiscard]] std::vector<Station> stations(const std::vector<Station>& changed = {});

/// The text before the first station, and the path with these stations.
inline constexpr const char* kHead = "PARTNO/SHOP\nUNITS/MM\nCUTTER/10\nLOADTL/1\n";
[[nodiscard]] std::string path_text(const std::vector<Station>& stations, const std::string& head = kHead);

/// A box from (0, 0, -20) to (100, 100, top), whose top has `cells` x `cells` squares of two triangles.
[[nodiscard]] std::string plate_stl(int cells = 1, double top = 0);

class SmallShop {
 public:
  SmallShop();

  void write(const std::string& file, const std::string& text) const { write_text(folder_ + "/" + file, text); }
  [[nodiscard]] std::string read(const std::string& file) const { return text_of(folder_ + "/" + file); }
  [[nodiscard]] nlohmann::json json(const std::string& file) const { return nlohmann::json::parse(read(file)); }
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const {
    return run_gougecheck(folder_, arguments);
  }
  [[nodiscard]] Outcome run_script(const std::string& script) const {
    return testing_samples::run_script(folder_, script);
  }
  /// `gougecheck check path.apt --part part.stl --json NAME.json` with `text` as path.apt.
  Outcome check(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) const;

 private:
  std::string folder_;
};

}  // namespace gouge::testing_samples
