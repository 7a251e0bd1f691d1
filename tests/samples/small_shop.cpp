#include "tests/samples/small_shop.h"

#include <array>
#include <cstdio>

namespace gouge::testing_samples {
namespace {

using Point = std::array<double, 3>;

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6f", value);
  return text.data();
}

void add_triangle(std::string& text, const Point& a, const Point& b, const Point& c) {
  text += "facet normal 0 0 0\nouter loop\n";
  for (const Point* p : {&a, &b, &c})
    text += "vertex " + number((*p)[0]) + " " + number((*p)[1]) + " " + number((*p)[2]) + "\n";
  text += "endloop\nendfacet\n";
}

// Corners against the clock, seen from outside; `cells` squares along both sides.
void add_face(std::string& text, const Point& origin, const Point& u, const Point& v, int cells) {
  const auto at = [&](int i, int j) {
    Point p{};
    for (std::size_t k = 0; k < 3; ++k) p.at(k) = origin.at(k) + (u.at(k) * i + v.at(k) * j) / cells;
    return p;
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      add_triangle(text, at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add_triangle(text, at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

}  // namespace

std::vector<Station> stations(const std::vector<Station>& changed) {
  std::vector<Station> all;
  for (int x = 10; x <= 90; x += 10) all.push_back({static_cast<double>(x), 0});
  for (const Station& one : changed) {
    for (Station& station : all) {
      if (static_cast<int>(station.x) == static_cast<int>(one.x)) station = one;
    }
  }
  return all;
}

std::string path_text(const std::vector<Station>& stations, const std::string& head) {
  std::string text = head + "RAPID\nGOTO/-20,50,30\nRAPID\nGOTO/-20,50,0\nFEDRAT/500,MMPM\n";
  for (const Station& at : stations) text += "GOTO/" + number(at.x) + ",50," + number(at.z) + "\n";
  return text + "GOTO/120,50,0\nRAPID\nGOTO/120,50,30\nFINI\n";
}

std::string plate_stl(int cells, double top) {
  const double height = top + 20;
  std::string text = "solid plate\n";
  add_face(text, {0, 0, top}, {100, 0, 0}, {0, 100, 0}, cells);
  add_face(text, {0, 0, -20}, {0, 100, 0}, {100, 0, 0}, cells);
  add_face(text, {0, 0, -20}, {100, 0, 0}, {0, 0, height}, cells);
  add_face(text, {0, 100, -20}, {0, 0, height}, {100, 0, 0}, cells);
  add_face(text, {0, 0, -20}, {0, 0, height}, {0, 100, 0}, cells);
  add_face(text, {100, 0, -20}, {0, 100, 0}, {0, 0, height}, cells);
  return text + "endsolid plate\n";
}

SmallShop::SmallShop() : folder_(fresh_folder()) { write("part.stl", plate_stl()); }

Outcome SmallShop::check(const std::string& name, const std::string& text, const std::vector<std::string>& more) const {
  write("path.apt", text);
  std::vector<std::string> arguments = {"check", "path.apt", "--json", name + ".json"};
  bool has_part = false;
  for (const std::string& one : more) has_part = has_part || one == "--part";
  if (!has_part) arguments.insert(arguments.end(), {"--part", "part.stl"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

}  // namespace gouge::testing_samples
