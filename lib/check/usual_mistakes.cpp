#include "lib/check/usual_mistakes.h"

#include <array>
#include <string_view>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

using Matrix = Eigen::Matrix3d;

constexpr std::array<std::string_view, 3> kComponents = {"I", "J", "K"}, kCoordinates = {"X", "Y", "Z"};

Matrix with_sign(Eigen::Index component) {
  Matrix m = Matrix::Identity();
  m(component, component) = -1;
  return m;
}

Matrix exchange(Eigen::Index a, Eigen::Index b) {
  Matrix m = Matrix::Identity();
  m.col(a).swap(m.col(b));
  return m;
}

// Returns a rotation by quarter turns. It has whole numbers, so nothing is rounded.
Matrix quarter_turns(Eigen::Index about, int quarters) {
  const Eigen::Index x = (about + 1) % 3, y = (about + 2) % 3;
  Matrix quarter = Matrix::Zero();
  quarter(about, about) = 1;
  quarter(y, x) = 1;
  quarter(x, y) = -1;
  Matrix all = Matrix::Identity();
  for (int i = 0; i < quarters; ++i) all = quarter * all;
  return all;
}

class Mistakes {
 public:
  std::vector<UndoneMistake> all;

  UndoneMistake& add(std::string text) {
    all.emplace_back();
    all.back().text = std::move(text);
    return all.back();
  }

  void add_axes() {
    for (std::size_t i = 0; i < 3; ++i)
      add(std::string(kComponents[i]) + " negated").axis = with_sign(static_cast<Eigen::Index>(i));
    add("I, J and K negated").axis = -Matrix::Identity();
    for (const char* text : {"K of the tilted axes negated", "I, J and K of the tilted axes negated"}) {
      UndoneMistake& tilted = add(text);
      tilted.axis = text[0] == 'K' ? with_sign(2) : Matrix(-Matrix::Identity());
      tilted.is_of_tilted = true;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Matrix exchanged = exchange(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      add(std::string(kComponents[i]) + " and " + std::string(kComponents[j]) + " exchanged").axis = exchanged;
      UndoneMistake& both = add(std::string(kCoordinates[i]) + " and " + std::string(kCoordinates[j]) +
                                " of positions and axes exchanged");
      both.tip = both.axis = exchanged;
    }
  }

  // A part that is turned one way corresponds to a path that is turned the other way.
  void add_turns() {
    for (std::size_t i = 0; i < 3; ++i) {
      for (const int quarters : {1, 2, 3}) {
        UndoneMistake& turned = add("the part rotated by " + std::to_string(90 * quarters) + " degrees about " +
                                    std::string(kCoordinates[i]));
        turned.tip = turned.axis = quarter_turns(static_cast<Eigen::Index>(i), 4 - quarters);
      }
    }
  }

  void add_units(LengthUnit unit) {
    constexpr double kInch_mm = 25.4;
    const bool is_inch = unit == LengthUnit::inch;
    add(is_inch ? "the positions in millimetres (--path-units)" : "the positions in inches (--path-units)").tip =
        (is_inch ? 1 / kInch_mm : kInch_mm) * Matrix::Identity();
    add("a part 25.4 times as large (--stl-units)").part_scale = kInch_mm;
    add("a part 25.4 times smaller (--stl-units)").part_scale = 1 / kInch_mm;
  }
};

}  // namespace

Pose UndoneMistake::pose(const Pose& given, double corner_radius_mm) const {
  if (is_of_tilted && given.axis.cross(Vec3::UnitZ()).norm() < Tolerance::kNoSide) return given;
  Pose undone{tip * given.tip, axis * given.axis};
  undone.tip += corner_radii * corner_radius_mm * undone.axis;
  return undone;
}

std::vector<UndoneMistake> usual_mistakes(LengthUnit unit) {
  Mistakes mistakes;
  mistakes.add_axes();
  mistakes.add_turns();
  mistakes.add("positions of the centre of the cutter's corner instead of its tip").corner_radii = -1;
  mistakes.add("positions of the tip instead of the centre of the cutter's corner").corner_radii = 1;
  mistakes.add_units(unit);
  return std::move(mistakes.all);
}

}  // namespace gouge
