/// \file
/// What becomes of a pane: its cracks, and its shards where the scene asks for them. Plain values.
///
/// The plane of a pane is that of its outline: x to the right, y up, mm. In space, z is 0 in the middle of the glass and rises
/// towards the viewer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <shatterpave/geometry.h>

namespace shatterpave {

/// What a crack is. More kinds may come with a minor version.
enum class CrackKind {
  large,     ///< Radial, meant to reach the edge.
  radial,    ///< Every other radial; both kinds start at the impact.
  circular,  ///< One arm of a ring crack; the two arms of a starting point are two cracks.
  branch,    ///< Leaves a radial crack, or another branch, which goes on.
  dice,      ///< A border of the fragments of tempered glass.
  rung,      ///< One of two arms across the strip between two radials, on no ring.
  chip,      ///< The border of a lens-shaped flake beside a radial crack.
};

/// The word that files use for it, such as "circular".
std::string_view name_of(CrackKind kind);

/// Where a crack starts or ends.
struct CrackEnd {
  /// The kind of place.
  enum class At {
    impact,    ///< Starts at the impact.
    ring,      ///< Starts at the starting point of a ring crack, which its two arms share.
    origin,    ///< Starts within the glass, where no crack was yet (dice).
    edge,      ///< Ends on the edge of the pane.
    crack,     ///< Starts or ends on another crack, in a vertex of its polyline.
    enclosed,  ///< Stopped within a region that cracks closed about it.
    open,      ///< Growth ended before it met anything.
  };
  At at = At::open;          ///< The kind of place.
  std::optional<int> crack;  ///< For At::crack, the id of that one.

  /// Member by member.
  bool operator==(const CrackEnd&) const = default;
};

/// The word that files use for it, such as "edge".
std::string_view name_of(CrackEnd::At at);

/// A crack as a polyline in the plane of the pane. Cracks of a pane do not cross: two meet only where one starts or ends on the
/// other, or where they start together.
struct Crack {
  int id = 0;                          ///< Its index in Pane::cracks, and then in Pane::far_cracks.
  int impact = 0;                      ///< Index of the impact it belongs to.
  CrackKind kind = CrackKind::radial;  ///< What it is.
  std::vector<Point> points_mm;        ///< From start to tip: two or more, distinct from one to the next, in whole µm.
  CrackEnd start;                      ///< Where it starts.
  CrackEnd end;                        ///< Where it ends.
  bool through = true;                 ///< Whether it runs from face to face; in laminated glass it may be in one sheet only.

  /// Member by member.
  bool operator==(const Crack&) const = default;
};

/// Circles about an impact; they may reach beyond the edge.
struct Crater {
  double crushed_radius_mm = 0.0;  ///< Glass ground to powder, right through.
  double near_radius_mm = 0.0;     ///< Spall on the side of the impact, at least as wide.
  double far_radius_mm = 0.0;      ///< Spall on the other side, at least as wide again.
  double milky_radius_mm = 0.0;    ///< Laminated glass: white with fine cracks as far as here; 0: nowhere.

  /// Member by member.
  bool operator==(const Crater&) const = default;
};

/// What hit the pane, with the numbers of cracks as they were drawn.
struct Impact {
  Point at_mm;                   ///< Within the outline.
  int radial_count = 0;          ///< Radial cracks, the large ones among them.
  int large_count = 0;           ///< Those meant to reach the edge.
  int circular_count = 0;        ///< Starting points of ring cracks.
  std::optional<Crater> crater;  ///< None in the paper's model.

  /// Member by member.
  bool operator==(const Impact&) const = default;
};

/// Where a shard is.
enum class ShardState {
  standing,  ///< In the frame, where it was.
  fallen,    ///< Lies on the sill or the floor.
  missing,   ///< Gone.
};

/// The word that files use for it, such as "fallen".
std::string_view name_of(ShardState state);

/// A piece between cracks that is larger than a splinter. Its mesh is made by Model::shard_mesh.
struct Shard {
  std::string id;                           ///< Unique in its pane; depends on the cracks about it, not on an order.
  std::vector<std::string> joined;          ///< Ids of the pieces that are one body here: two or more, or none.
  Region face_mm;                           ///< Of the pane, before bevels and chips.
  ShardState state = ShardState::standing;  ///< Where it is.
  Transform transform;                      ///< From where it was in the pane to where it is.

  /// Member by member.
  bool operator==(const Shard&) const = default;
};

/// What a triangle of a shard is part of: two materials.
enum class ShardSurface {
  old,     ///< Front, back and edge of the pane.
  broken,  ///< Walls of cracks, bevels and chips along them.
};

/// A shard as a closed solid: every edge is shared by two triangles. No two shards that stand overlap, to the µm.
struct ShardMesh {
  std::vector<Point3> vertices_mm;     ///< Where it was in the pane, in whole µm; Shard::transform takes them to where it is.
  std::vector<Triangle> triangles;     ///< Counter-clockwise from outside; none without area.
  std::vector<Point3> normals;         ///< One a triangle, of unit length, outwards.
  std::vector<ShardSurface> surfaces;  ///< One a triangle.

  /// Member by member.
  bool operator==(const ShardMesh&) const = default;
};

/// A broken pane.
struct Pane {
  std::string name;             ///< Unique in its scene: letters, digits, '_' and '-'.
  Polygon outline_mm;           ///< Counter-clockwise.
  double thickness_mm = 0.0;    ///< Greater than 0.
  std::vector<Impact> impacts;  ///< In the order in which they happened.
  std::vector<Crack> cracks;    ///< By id.
  std::vector<Shard> shards;    ///< None unless the scene asks for them.
  /// Of laminated glass without shards: those of the sheet away from the impact. Their ids follow on those of `cracks`, which
  /// they cross.
  std::vector<Crack> far_cracks;

  /// Member by member.
  bool operator==(const Pane&) const = default;
};

}  // namespace shatterpave
