#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

/// A triangulated surface, taken exactly as it is given: a part, a fixture, or a body of a clash. Immutable; copies
/// share it, and so the index that the first check makes of it.
class GOUGECHECK_EXPORT Mesh {
 public:
  /// Vertices with identical coordinates become one, as in an STL file; triangles with two identical corners are left
  /// out. The arrays are copied.
  /// Throws   Error: an index beyond the vertices, a coordinate that is not a number or beyond 100 m, no triangle left.
  Mesh(std::span<const Vec3> vertices, std::span<const Triangle> faces, std::string name = "mesh");

  /// `unit`: um, mm, cm, m or inch. Empty: not known; a check then takes that of its path, and all else takes mm.
  /// Throws   Error: those of docs/errors.md for STL files.
  [[nodiscard]] static Mesh read_stl(const std::string& file, const std::string& unit = "");

  /// Returns the vertices after joining; valid as long as a copy of the mesh lives.
  [[nodiscard]] std::span<const Vec3> vertices() const;
  [[nodiscard]] std::span<const Triangle> faces() const;
  /// Returns for each face its index among the triangles as given.
  [[nodiscard]] std::span<const std::uint32_t> given_face() const;
  [[nodiscard]] const std::string& name() const;

  /// Returns whether it separates inside from outside. Then a buried tool is found, and depths of bodies are defined.
  [[nodiscard]] bool is_solid() const;
  /// Returns warnings: open edges, wrong orientations, triangles left out.
  [[nodiscard]] std::vector<Note> notes() const;

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  friend class Scene;
  friend struct MeshAccess;
  explicit Mesh(std::shared_ptr<const Content> content);
  std::shared_ptr<const Content> content_;
};

/// The stationary objects: parts, which must not be cut into, and fixtures, which must not be touched. Immutable;
/// copies share the index, which is made at the first check, from any thread.
class GOUGECHECK_EXPORT Scene {
 public:
  /// Builds a scene of one part. The index stays with the mesh: a scene of the same mesh costs nothing.
  Scene(const Mesh& part);  // NOLINT: a part is a scene
  /// Builds a scene. Each of `fixture_clearances` is the distance in mm that the tool keeps from one fixture; empty:
  /// none has one.
  /// Errors  Code usage: no mesh, or another count of clearances than of fixtures. Also a clearance that is not a
  ///         length of 0 or more.
  explicit Scene(std::vector<Mesh> parts, std::vector<Mesh> fixtures = {}, std::vector<double> fixture_clearances = {});

  [[nodiscard]] std::span<const Mesh> parts() const;
  [[nodiscard]] std::span<const Mesh> fixtures() const;
  /// Returns one clearance for each fixture, mm; empty: none has one.
  [[nodiscard]] std::span<const double> fixture_clearances() const;

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace gougecheck
