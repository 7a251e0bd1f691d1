#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

/// A triangulated surface, used exactly as given: a part, a fixture, or a body of a clash. Immutable. Copies share it,
/// and also the index that the first check makes of it.
class GOUGECHECK_EXPORT Mesh {
 public:
  /// Builds a mesh from arrays, which are copied. Vertices with identical coordinates become one, as in an STL file;
  /// triangles with two identical corners are left out.
  /// Throws   Error: an index beyond the vertices, a coordinate that is not a number or beyond 100 m, no triangle left.
  Mesh(std::span<const Vec3> vertices, std::span<const Triangle> faces, std::string name = "mesh");

  /// Reads an STL file. `unit` is um, mm, cm, m or inch. Empty: unknown; a check then takes the unit of its path, and
  /// all other functions take mm.
  /// Throws   Error: those of docs/errors.md for STL files.
  [[nodiscard]] static Mesh read_stl(const std::string& file, const std::string& unit = "");

  /// Returns the vertices after joining; valid as long as a copy of the mesh exists.
  [[nodiscard]] std::span<const Vec3> vertices() const;
  [[nodiscard]] std::span<const Triangle> faces() const;
  /// Returns for each face its index among the given triangles.
  [[nodiscard]] std::span<const std::uint32_t> given_face() const;
  [[nodiscard]] const std::string& name() const;

  /// Returns whether the mesh separates inside from outside. Only then is a buried tool found, and are depths of bodies
  /// defined.
  [[nodiscard]] bool is_solid() const;
  /// Returns warnings: open edges, wrong orientations, triangles left out.
  [[nodiscard]] std::vector<Note> notes() const;

  /// Returns the mesh for `from_bytes` of this version, in this or another process. The index is not part of it.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws   Error: saved-bytes.
  [[nodiscard]] static Mesh from_bytes(std::string_view bytes);

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  friend class Scene;
  friend struct MeshAccess;
  explicit Mesh(std::shared_ptr<const Content> content);
  std::shared_ptr<const Content> content_;
};

/// The stationary objects: parts, which must not be cut into, and fixtures, which must not be touched. Immutable.
/// Copies share the index, which the first check makes, from any thread.
class GOUGECHECK_EXPORT Scene {
 public:
  /// Builds a scene of one part. The index stays with the mesh, so several scenes of one mesh share it.
  Scene(const Mesh& part);  // NOLINT: a part is a scene
  /// Builds a scene. Each of `fixture_clearances` is the distance in mm that the tool keeps from one fixture; empty:
  /// all are 0.
  /// Errors  Code usage: no mesh, numbers of clearances and fixtures that differ, or a clearance that is not a length
  ///         of 0 or more.
  explicit Scene(std::vector<Mesh> parts, std::vector<Mesh> fixtures = {}, std::vector<double> fixture_clearances = {});

  [[nodiscard]] std::span<const Mesh> parts() const;
  [[nodiscard]] std::span<const Mesh> fixtures() const;
  /// Returns one clearance for each fixture, mm; empty: all are 0.
  [[nodiscard]] std::span<const double> fixture_clearances() const;

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace gougecheck
