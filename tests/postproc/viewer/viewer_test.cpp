#include <gtest/gtest.h>
#include <zlib.h>

#include <map>
#include <nlohmann/json.hpp>

#include "lib/base/parallel.h"
#include "postproc/viewer/refine_surface.h"
#include "postproc/viewer/write_viewer.h"
#include "tests/postproc/image/small_scene.h"

namespace gouge::viewer_test {
namespace {

using Json = nlohmann::json;

std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out.push_back(static_cast<char>(bits >> count & 0xFFU));
  }
  return out;
}

/// The scene of a page, unpacked as a browser does.
struct UnpackedScene {
  Json json;
  std::string planes;

  explicit UnpackedScene(const std::string& page) {
    const std::string open = "id=\"desk-data\">";
    const std::size_t first = page.find(open) + open.size();
    const std::string packed = from_base64(page.substr(first, page.find('<', first) - first));
    std::string bytes(50'000'000, '\0');
    uLongf size = bytes.size();
    EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                           static_cast<uLong>(packed.size())),
              Z_OK);
    std::size_t head = 0;
    for (std::size_t k = 0; k < 4; ++k) head |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[k])) << 8 * k;
    json = Json::parse(bytes.substr(4, head));
    planes = bytes.substr(4 + head, size - 4 - head);
  }

  [[nodiscard]] std::vector<std::uint32_t> numbers(const Json& run) const {
    const std::size_t at = run.at("at"), count = run.at("count"), width = run.at("bytes");
    std::vector<std::uint32_t> out(count, 0);
    for (std::size_t plane = 0; plane < width; ++plane) {
      for (std::size_t i = 0; i < count; ++i)
        out[i] |= static_cast<std::uint32_t>(static_cast<unsigned char>(planes.at(at + plane * count + i)))
                  << 8 * plane;
    }
    return out;
  }

  [[nodiscard]] std::vector<std::uint32_t> summed(const Json& run) const {
    std::vector<std::uint32_t> out = numbers(run);
    const std::uint32_t mask = run.at("bytes") == 4 ? 0xFFFFFFFFU : (1U << 8 * run.at("bytes").get<unsigned>()) - 1;
    std::uint32_t last = 0;
    for (std::uint32_t& one : out) one = last = (last + ((one & 1U) != 0 ? ~(one >> 1) : one >> 1)) & mask;
    return out;
  }

  [[nodiscard]] std::vector<Vec3> places(const Json& grid, const Json& axes) const {
    std::vector<Vec3> out;
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<std::uint32_t> along = summed(axes.at(static_cast<std::size_t>(axis)));
      out.resize(along.size(), Vec3::Zero());
      for (std::size_t i = 0; i < along.size(); ++i)
        out[i][axis] = grid.at("origin").at(static_cast<std::size_t>(axis)).get<double>() +
                       along[i] * grid.at("step").get<double>();
    }
    return out;
  }
};

std::string page_of(const SmallScene& small) { return *write_viewer({small.model, small.input}); }

TEST(WriteViewer, KeepsThePartAndThePath) {
  const SmallScene small;
  const UnpackedScene scene(page_of(small));
  Box3 box;
  for (const Vec3& p : scene.places(scene.json.at("surface"), scene.json.at("surface").at("positions"))) box.extend(p);
  const double step = scene.json.at("surface").at("step");
  EXPECT_LT(step, 40.0 / 65000);
  EXPECT_LT((box.min() - Vec3(0, 0, 0)).norm(), 2 * step);
  EXPECT_LT((box.max() - Vec3(40, 30, 10)).norm(), 2 * step);
  const Json& path = scene.json.at("paths").at(0);
  const std::vector<Vec3> tips = scene.places(path, path.at("tips"));
  ASSERT_EQ(tips.size(), small.path.moves.size());
  for (std::size_t i = 0; i < tips.size(); ++i) EXPECT_LT((tips[i] - small.path.moves[i].end.tip).norm(), 1e-4);
  EXPECT_EQ(scene.summed(path.at("lines")), (std::vector<std::uint32_t>{10, 11, 12, 13, 14}));
  EXPECT_EQ(scene.json.at("surface").at("meshes").at(0).at("name"), "block.stl");
}

TEST(WriteViewer, ColoursTheMiddleOfALargeTriangleAsTheFieldDoes) {
  const SmallScene small;
  const UnpackedScene scene(page_of(small));
  const Json& surface = scene.json.at("surface");
  const std::vector<Vec3> places = scene.places(surface, surface.at("positions"));
  const std::vector<std::uint32_t> values = scene.summed(surface.at("values").at(0));
  ASSERT_EQ(values.size(), places.size());
  const PicturedPath path(small.input);
  const SurfaceValues field(path);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3& p = places[i];
    if (p.z() < 10 - 1e-3 || p.x() < 5 || p.x() > 35 || std::abs(p.y() - 15) > 0.9) continue;
    const double expected = field.at({{Vec3(p.x(), p.y(), 10), Vec3::UnitZ(), 0}}).front();
    const double place = values[i] / 65535.0, high = scene.json.at("scale").at("high");
    const double told = high * (scene.json.at("scale").at("root") ? place * place : place);
    EXPECT_NEAR(told, expected, 0.02) << p.transpose();
    compared += told > 0.1 ? 1 : 0;
  }
  EXPECT_GT(compared, 100U);
}

TEST(WriteViewer, QuotesTheStatementWithThreeLinesAround) {
  SmallScene small;
  std::string source;
  for (int line = 1; line <= 20; ++line) {
    const std::size_t first = source.size();
    source += "GOTO/" + std::to_string(line) + "\r\n";
    small.path.statements.push_back({static_cast<std::size_t>(line), first, source.size()});
  }
  small.path.source = source;
  for (std::size_t i = 0; i < small.path.moves.size(); ++i) small.path.moves[i].statement = 9 + i;
  const UnpackedScene scene(page_of(small));
  const Json finding = scene.json.at("findings").begin().value();
  const std::size_t line = 10 + finding.at("move").get<std::size_t>();
  EXPECT_EQ(finding.at("quote").at("line"), line);
  EXPECT_EQ(finding.at("quote").at("first"), line - 3);
  ASSERT_EQ(finding.at("quote").at("lines").size(), 7U);
  EXPECT_EQ(finding.at("quote").at("lines").at(3), "GOTO/" + std::to_string(line));
  EXPECT_EQ(finding.at("state"), "gouge");
}

TEST(WriteViewer, IsTheSameAtAnyNumberOfThreads) {
  const SmallScene small;
  set_default_threads(1);
  const std::string one = page_of(small);
  set_default_threads(3);
  EXPECT_TRUE(one == page_of(small));
  set_default_threads(0);
}

TEST(WriteViewer, IsNothingWithoutTriangles) {
  SmallScene small;
  small.scene.parts.clear();
  small.check();
  EXPECT_EQ(page_of(small), "");
}

TEST(RefineSurface, LeavesNoGapBetweenTriangles) {
  const SmallScene small;
  const PictureScene pictures(*small.prepared);
  ViewerMesh mesh = ViewerMesh::from(pictures);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(mesh.positions.size(), 24U);  // three normals at each corner
  const PicturedPath path(small.input);
  const SurfaceValues field(path);
  const VertexValues values = refine_surface(mesh, {AskedValues{&field}}, {}, 50);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].size(), mesh.positions.size());
  EXPECT_GT(mesh.triangles.size(), 1000U);
  EXPECT_LT(mesh.triangles.size(), 160'000U);
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const auto place = [&](std::size_t k) -> Place {
      const Vec3& p = mesh.positions[t[k % 3]];
      return {p.x(), p.y(), p.z()};
    };
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{place(k), place(k + 1)}];
      --edges[{place(k + 1), place(k)}];
    }
    area +=
        0.5 * (mesh.positions[t[1]] - mesh.positions[t[0]]).cross(mesh.positions[t[2]] - mesh.positions[t[0]]).norm();
  }
  EXPECT_NEAR(area, 2 * (40 * 30 + 40 * 10 + 30 * 10), 1e-6);
  for (const auto& [edge, balance] : edges) ASSERT_EQ(balance, 0);
}

TEST(RefineSurface, KeepsALargeTriangleAfterMillionsOfSmallOnes) {
  ViewerMesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(0, 0.01, 0), Vec3(0, 0, 5), Vec3(50, 0, 5), Vec3(0, 50, 5)};
  mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitZ());
  mesh.mesh_of.assign(mesh.positions.size(), 0);
  constexpr std::size_t kSmall = 4'300'000;
  mesh.triangles.assign(kSmall, {0, 1, 2});
  mesh.triangles.push_back({3, 4, 5});
  (void)refine_surface(mesh, {}, {Vec3(15, 15, 5)}, 50);
  EXPECT_GT(mesh.triangles.size(), kSmall + 1);
  double area = 0;
  for (std::size_t t = kSmall; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    area += 0.5 * (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm();
  }
  EXPECT_NEAR(area, 1250, 1e-6);
}

TEST(Viewer, TellsOfEachStepUntilAllAreDone) {
  const SmallScene small;
  std::vector<std::size_t> told;
  std::size_t all = 0;
  const auto listen = [&](std::string_view stage, std::size_t done, std::size_t total) {
    EXPECT_EQ(stage, "drawing the 3D view");
    told.push_back(done);
    all = total;
  };
  ASSERT_TRUE(write_viewer({small.model, small.input}, listen));
  ASSERT_GT(told.size(), 3U);
  EXPECT_EQ(told.front(), 0U);
  EXPECT_EQ(told.back(), all);
  for (std::size_t k = 1; k < told.size(); ++k) EXPECT_EQ(told[k], told[k - 1] + 1);
}

}  // namespace
}  // namespace gouge::viewer_test
