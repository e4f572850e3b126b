// Meshes are written as artists' tools like them: points that facets share, so that shards are closed and stones hang together,
// with normals and places in textures of facets' corners where the corners of a point differ.
#include "export/usd/element_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

#include "export/shapes/quaternion.h"
#include "export/usd/prim_text.h"
#include "export/usd/welded_mesh.h"

namespace shatterpave::exporting::usd {

namespace {

constexpr std::string_view binding_api = "prepend apiSchemas = [\"MaterialBindingAPI\"]";
constexpr std::string_view subcomponent = "kind = \"subcomponent\"";
constexpr std::string_view transform_order = "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]";

const std::string& material_name(const ThingPlace& place, const shapes::Piece& piece) {
  return (*place.materials)[piece.material].name;
}

void put_binding(PrimText& text, const ThingPlace& place, const shapes::Piece& piece) {
  text.line("rel material:binding = <{}/materials/{}>", place.path, material_name(place, piece));
}

template <std::size_t width>
void put_vector(Buffer& out, const std::array<std::int64_t, width>& value, double parts) {
  for (std::size_t k = 0; k < width; ++k) {
    constexpr std::string_view comma = ", ";
    if (k == 0) {
      out.push_back('(');
    } else {
      out.append(comma.data(), comma.data() + comma.size());
    }
    put_in_parts(out, value.at(k), parts);
  }
  out.push_back(')');
}

template <std::size_t width>
void put_vectors(PrimText& text, std::string_view declaration, const std::vector<std::array<std::int64_t, width>>& values,
                 double parts, std::string_view metadata = {}) {
  text.list(
      declaration, values.size(), [&](Buffer& out, std::size_t i) { put_vector(out, values[i], parts); }, metadata);
}

void put_extent(PrimText& text, const WeldedMesh& mesh) {
  std::array<std::int64_t, 3> low = mesh.points.front();
  std::array<std::int64_t, 3> high = low;
  for (const auto& point : mesh.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low.at(axis) = std::min(low.at(axis), point.at(axis));
      high.at(axis) = std::max(high.at(axis), point.at(axis));
    }
  }
  put_vectors(text, "float3[] extent", std::vector{low, high}, parts_of_m);
}

// Normals of corners are a primvar, since the attribute `normals` knows no indices.
template <std::size_t width>
void put_values(PrimText& text, std::string_view of_points, std::string_view of_corners, const CornerValues<width>& values,
                double parts) {
  if (values.of_corner.empty()) {
    put_vectors(text, of_points, values.values, parts, "interpolation = \"vertex\"");
    return;
  }
  put_vectors(text, of_corners, values.values, parts, "interpolation = \"faceVarying\"");
  const std::string_view name = of_corners.substr(of_corners.find(' ') + 1);
  text.list(fmt::format("int[] {}:indices", name), values.of_corner);
}

void put_subsets(PrimText& text, const ThingPlace& place, const std::vector<shapes::Piece>& pieces, const WeldedMesh& mesh) {
  text.line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
  std::size_t first = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t count = mesh.facets_of_piece[i];
    if (count > 0) {
      text.begin("def GeomSubset", material_name(place, pieces[i]), {std::string(binding_api)});
      text.line("uniform token elementType = \"face\"");
      text.line("uniform token familyName = \"materialBind\"");
      text.list("int[] indices", count,
                [&](Buffer& out, std::size_t k) { fmt::format_to(std::back_inserter(out), "{}", first + k); });
      put_binding(text, place, pieces[i]);
      text.end();
    }
    first += count;
  }
}

void put_mesh(PrimText& text, const ThingPlace& place, const std::vector<shapes::Piece>& pieces, const WeldedMesh& mesh) {
  if (mesh.corners.empty()) return;
  put_extent(text, mesh);
  text.list("int[] faceVertexCounts", mesh.corners.size() / 3, [](Buffer& out, std::size_t) { out.push_back('3'); });
  text.list("int[] faceVertexIndices", mesh.corners);
  put_values(text, "normal3f[] normals", "normal3f[] primvars:normals", mesh.normals, parts_of_one);
  text.line("uniform token orientation = \"rightHanded\"");
  put_vectors(text, "point3f[] points", mesh.points, parts_of_m);
  put_values(text, "texCoord2f[] primvars:st", "texCoord2f[] primvars:st", mesh.places, parts_of_uv);
  text.line("uniform token subdivisionScheme = \"none\"");
  if (pieces.size() > 1) put_subsets(text, place, pieces, mesh);
}

std::string prototype_name(const shapes::Body& body) { return fmt::format("shape_{}", *body.shared); }

// What follows the name of the thing.
std::string_view own_name(const shapes::Body& body) { return std::string_view(body.name).substr(body.name.find('.') + 1); }

// The id of what there are several of.
std::string_view id_of(const shapes::Body& body) {
  const std::string_view name = own_name(body);
  if (body.kind.starts_with("shard") || body.kind.starts_with("stone")) return name;
  const std::size_t dash = name.find('-');
  return dash == std::string_view::npos ? std::string_view() : name.substr(dash + 1);
}

std::string turn_text(const std::array<double, 4>& q) {
  Buffer turn;
  for (const std::size_t part : {3U, 0U, 1U, 2U}) {
    fmt::format_to(std::back_inserter(turn), "{}", part == 3 ? "(" : ", ");
    put_in_parts(turn, in_parts(q.at(part), parts_of_turn), parts_of_turn);
  }
  turn.push_back(')');
  return fmt::to_string(turn);
}

void put_turn(PrimText& text, const shapes::Placing& placing) {
  text.line("quatf xformOp:orient = {}", turn_text(shapes::quaternion(placing)));
}

std::string shift_text(const shapes::Placing& placing) { return vector_text(placing.at_mm / 1000.0, parts_of_m); }

void put_shift(PrimText& text, const shapes::Placing& placing) {
  text.line("double3 xformOp:translate = {}", shift_text(placing));
}

// Ids and kinds are custom attributes in the name space that Houdini, Maya and Blender take for users' own.
void put_placed(PrimText& text, const shapes::Body& body, int first_frame) {
  const std::string_view id = id_of(body);
  if (!id.empty()) text.line("custom string userProperties:id = {}", in_usd_quotes(id));
  text.line("custom string userProperties:kind = {}", in_usd_quotes(body.kind));
  if (!body.path.empty()) put_path(text, body.path, first_frame, body.is_seen);
  if (!body.shared) {
    if (body.placing != shapes::Placing{} || !body.path.empty()) put_placing(text, body.placing);
    return;
  }
  // The order of the operations is in the prototype, which is not turned.
  if (body.placing.turn != shapes::Placing{}.turn) put_turn(text, body.placing);
  put_shift(text, body.placing);
}

std::string instance_text(const shapes::Body& body, const ThingPlace& place) {
  Buffer out;
  PrimText text(out, place.depth);
  text.begin("def Xform", element_name(body),
             {"instanceable = true", fmt::format("prepend references = <{}/prototypes/{}>", place.path, prototype_name(body))});
  put_placed(text, body, place.first_frame);
  text.end();
  return fmt::to_string(out);
}

}  // namespace

// A time without a sample has the place between its neighbours; what is seen no more keeps its place.
void put_path(PrimText& text, const std::vector<std::optional<shapes::Placing>>& path, int first_frame, bool is_seen) {
  std::vector<std::string> turns;
  std::vector<std::string> shifts;
  std::vector<std::string> seen;
  std::array<double, 4> last{0.0, 0.0, 0.0, 1.0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const int frame = first_frame + static_cast<int>(i);
    if (i == 0 || path[i].has_value() != path[i - 1].has_value()) {
      seen.push_back(fmt::format("{}: {}", frame, path[i] ? "\"inherited\"" : "\"invisible\""));
    }
    if (!path[i]) continue;
    // A turn has two quaternions: the one that is nearer to that before, so that what is between two samples is too.
    std::array<double, 4> turn = shapes::quaternion(*path[i]);
    if (std::inner_product(turn.begin(), turn.end(), last.begin(), 0.0) < 0.0) {
      for (double& part : turn) part = -part;
    }
    last = turn;
    turns.push_back(fmt::format("{}: {}", frame, turn_text(turn)));
    shifts.push_back(fmt::format("{}: {}", frame, shift_text(*path[i])));
  }
  if (!is_seen) text.line("token visibility = \"invisible\"");
  if (seen.size() > 1) text.line("token visibility.timeSamples = {{ {} }}", fmt::join(seen, ", "));
  text.line("quatf xformOp:orient.timeSamples = {{ {} }}", fmt::join(turns, ", "));
  text.line("double3 xformOp:translate.timeSamples = {{ {} }}", fmt::join(shifts, ", "));
}

void put_placing(PrimText& text, const shapes::Placing& placing) {
  put_turn(text, placing);
  put_shift(text, placing);
  text.line("{}", transform_order);
}

std::string element_name(const shapes::Body& body) {
  std::string name = identifier(own_name(body));
  for (const std::string_view kind : {"shard", "stone"}) {
    if (body.kind.starts_with(kind)) return fmt::format("{}_{}", kind, own_name(body));
  }
  return name;
}

std::string element_text(const shapes::Body& body, const ThingPlace& place) {
  if (body.shared) return instance_text(body, place);
  const WeldedMesh mesh = welded(body.pieces);
  if (mesh.corners.empty()) return {};
  Buffer out;
  PrimText text(out, place.depth);
  text.begin("def Mesh", element_name(body), {std::string(binding_api), std::string(subcomponent)});
  put_mesh(text, place, body.pieces, mesh);
  put_binding(text, place, body.pieces.front());
  put_placed(text, body, place.first_frame);
  text.end();
  return fmt::to_string(out);
}

std::string prototype_text(const shapes::Body& body, const ThingPlace& place) {
  Buffer out;
  PrimText text(out, place.depth + 1);
  const WeldedMesh mesh = welded(body.pieces);
  text.begin("def Xform", prototype_name(body), {std::string(binding_api), std::string(subcomponent)});
  put_binding(text, place, body.pieces.front());
  put_turn(text, {});
  text.line("{}", transform_order);
  text.begin("def Mesh", "mesh");
  put_mesh(text, place, body.pieces, mesh);
  text.end();
  text.end();
  return fmt::to_string(out);
}

}  // namespace shatterpave::exporting::usd
