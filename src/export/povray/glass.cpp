#include "export/povray/glass.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "export/povray/bent_glass.h"
#include "export/povray/dirt.h"
#include "export/povray/sdl.h"
#include "export/povray/shards.h"
#include "export/povray/sheets.h"
#include "export/shapes/glass_meshes.h"
#include "export/shapes/tubes.h"
#include "geometry/bend.h"
#include "geometry/polygon.h"

namespace shatterpave::exporting::povray {

namespace {

bool is_rectangle(const geometry::Polygon& outline) {
  const geometry::Box box = geometry::bounding_box(outline);
  const auto at_corner = [&](vec2 p) {
    return (p.x == box.low.x || p.x == box.high.x) && (p.y == box.low.y || p.y == box.high.y);
  };
  return outline.size() == 4 && std::ranges::all_of(outline, at_corner);
}

// The points of a ring of a prism, the first one again at the end.
void append_ring(std::string& text, const geometry::Polygon& ring) {
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    text += i == 0 ? "   " : (i % 6 == 0 ? ",\n   " : ", ");
    append_point(text, ring[i % ring.size()]);
  }
}

// A prism sweeps along y what is given in x and z; this stands it up: y to -z, z to y.
constexpr std::string_view standing = "   matrix <1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0>\n";

// Of a bent pane: the corners of its box, and the slab as a mesh.
void append_bent_slab(std::string& text, const glass::Pane& pane, const std::string& prefix) {
  const geometry::Bend bend = glass::bend_of(pane);
  const shapes::Mesh slab = shapes::bent(shapes::slab_mesh(pane), bend, shapes::bent_pane_bound_mm);
  vec3 low = slab.points_mm.front();
  vec3 high = low;
  for (const vec3& p : slab.points_mm) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  text += fmt::format(
      "#declare {0}_Min = {1};\n#declare {0}_Max = {2};\n#declare {0}_Thickness = {3};\n#declare {0}_Rectangular = {4};\n",
      prefix, standing_point({low.x, low.y, high.z}), standing_point({high.x, high.y, low.z}), number(pane.thickness_mm),
      is_rectangle(pane.outline_mm) ? 1 : 0);
  text += bend_declarations(bend, prefix);
  text += fmt::format("#declare {}_Slab =\n{}\n", prefix, closed_mesh(slab));
}

void append_slab(std::string& text, const glass::Pane& pane, const std::string& prefix) {
  if (pane.bow_mm != vec2{0.0, 0.0}) {
    append_bent_slab(text, pane, prefix);
    return;
  }
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const double half = 0.5 * pane.thickness_mm;
  text += fmt::format(
      "#declare {0}_Min = {1};\n#declare {0}_Max = {2};\n#declare {0}_Thickness = {3};\n#declare {0}_Rectangular = {4};\n\n",
      prefix, standing_point({box.low, half}), standing_point({box.high, -half}), number(pane.thickness_mm),
      is_rectangle(pane.outline_mm) ? 1 : 0);
  if (is_rectangle(pane.outline_mm)) {
    text += fmt::format("#declare {0}_Slab = box {{ {0}_Min, {0}_Max }}\n\n", prefix);
    return;
  }
  text += fmt::format("#declare {}_Slab =\nprism {{\n   linear_sweep linear_spline {}, {}, {},\n", prefix, number(-half),
                      number(half), pane.outline_mm.size() + 1);
  append_ring(text, pane.outline_mm);
  text += fmt::format("\n{}}}\n\n", standing);
}

// `objects`, each with a newline at its end, as one object: POV-Ray warns of a union of fewer than two.
std::string together(const std::vector<std::string>& objects) {
  if (objects.size() == 1) return objects.front();
  std::string text = "union {\n";
  for (const std::string& object : objects) text += object;
  return text + "}\n";
}

// #declare of the objects together; nothing where there are none.
void append_declaration(std::string& text, const std::string& name, const std::vector<std::string>& objects) {
  if (!objects.empty()) text += fmt::format("#declare {} =\n{}\n", name, together(objects));
}

std::string tube_text(const shapes::Tube& tube, const geometry::Bend& bend) {
  if (!bend.is_flat()) return closed_mesh(shapes::bent(shapes::tube_mesh(tube), bend, shapes::bent_pane_bound_mm));
  std::string text = "   cylinder { ";
  append_standing_point(text, {tube.a_mm, tube.z_mm});
  text += ", ";
  append_standing_point(text, {tube.b_mm, tube.z_mm});
  text += ", ";
  append_number(text, tube.radius_mm);
  return text + " }\n";
}

std::vector<std::string> tube_texts(const std::vector<shapes::Tube>& tubes, const geometry::Bend& bend) {
  std::vector<std::string> texts;
  int crack = -1;
  for (const shapes::Tube& tube : tubes) {
    std::string text;
    if (tube.crack != crack) text += fmt::format("   // crack {}\n", tube.crack);
    crack = tube.crack;
    texts.push_back(text + tube_text(tube, bend));
  }
  return texts;
}

std::vector<std::string> crushed_texts(const std::vector<glass::ImpactZone>& zones, const glass::Pane& pane,
                                       const std::string& prefix) {
  const geometry::Bend bend = glass::bend_of(pane);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const glass::ImpactZone& zone = zones[i];
    if (!bend.is_flat()) {
      texts.push_back(crushed_layers(zone, bend, pane.thickness_mm, i));
      continue;
    }
    texts.push_back(fmt::format("   object {{ Shatterpave_Crushed({}, {}_Thickness, {}) translate {} }}\n",
                                number(zone.radius_mm), prefix, i, standing_point({zone.centre_mm, 0.0})));
  }
  return texts;
}

// Of what the cracks are made.
enum class Body { tubes, sheets };

constexpr std::string_view own_tubes = "material { Shatterpave_Crack }";

// Cracks as they are declared: in groups, each with a material of its own in the ready-made pane.
struct CrackGroup {
  std::string name;
  std::string material;  // as it stands in an object
  std::vector<std::string> objects;
};

// What of the call of a material is another one for bent panes.
struct Bending {
  std::string name;       // between Shatterpave_ and the rest of it
  std::string arguments;  // after the others
};
Bending bending_of(const geometry::Bend& bend, const std::string& prefix) {
  return bend.is_flat() ? Bending{} : Bending{"Bent_", ", " + bend_arguments(prefix)};
}

std::vector<CrackGroup> crack_groups(const BrokenPane& broken, const std::string& prefix) {
  const geometry::Bend bend = glass::bend_of(broken.pane);
  const Bending bending = bending_of(bend, prefix);
  const auto text_of = [&](shapes::Mesh mesh) {
    return closed_mesh(shapes::bent(std::move(mesh), bend, shapes::bent_pane_bound_mm));
  };
  const bool is_dice = std::holds_alternative<glass::Tempered>(broken.pane.glass);
  std::vector<CrackGroup> groups;
  for (std::size_t i = 0; i < broken.network.impacts.size(); ++i) {
    CrackGroup group{fmt::format("{}_Cracks_{}", prefix, i),
                     fmt::format("Shatterpave_{}Sheet({}, {}_Thickness, {}, {}{})", bending.name,
                                 standing_point({broken.network.impacts[i].at_mm, 0.0}), prefix,
                                 number(broken.pane.crack_sheet.relief), is_dice ? 1 : 0, bending.arguments),
                     {}};
    int crack = -1;
    for (const glass::CrackSurface& surface : broken.surfaces.surfaces) {
      if (surface.impact != static_cast<int>(i)) continue;
      const std::string comment = surface.crack != crack ? fmt::format("   // crack {}\n", surface.crack) : std::string();
      crack = surface.crack;
      group.objects.push_back(comment + (bend.is_flat() ? sheet_mesh(surface) : text_of(shapes::gap_mesh(surface))));
    }
    if (!group.objects.empty()) groups.push_back(std::move(group));
  }
  for (std::size_t i = 0; i < broken.surfaces.shot_holes.size(); ++i) {
    const glass::ShotHole& hole = broken.surfaces.shot_holes[i];
    groups.push_back({fmt::format("{}_Shot_Hole_{}", prefix, i),
                      fmt::format("Shatterpave_{}Shot_Hole({}, {}, {}, {}_Thickness{})", bending.name,
                                  standing_point({hole.shape.centre_mm, 0.0}), number(hole.shape.hole_radius_mm),
                                  number(hole.shape.spall_radius_mm), prefix, bending.arguments),
                      {bend.is_flat() ? shot_hole_mesh(hole) : text_of(shapes::hole_mesh(hole))}});
  }
  return groups;
}

// The material of the slab in NAME_Pane.
std::string slab_material(const glass::Pane& pane, const std::string& prefix) {
  if (pane.dirt == 0.0) return "Shatterpave_Glass";
  return fmt::format("texture {{ Shatterpave_Glass_Face }} texture {{ {}_Dirt }} interior {{ Shatterpave_Glass_Interior }}",
                     prefix);
}

// NAME_Broken with materials of the artist's, and NAME_Pane with ours.
void append_whole(std::string& text, const glass::Pane& pane, const std::vector<CrackGroup>& groups, bool crushed,
                  const std::string& prefix) {
  const auto parts = [&](std::string_view glass, bool own) {
    std::vector<std::string> objects{fmt::format("   object {{ {}_Slab material {{ {} }}{} }}\n", prefix, glass,
                                                 own && pane.dirt > 0.0 ? " double_illuminate" : "")};
    for (const CrackGroup& group : groups) {
      objects.push_back(fmt::format("   object {{ {} {} double_illuminate }}\n", group.name,
                                    own ? std::string_view(group.material) : std::string_view("material { Crack }")));
    }
    if (crushed) objects.push_back(fmt::format("   object {{ {}_Crushed double_illuminate }}\n", prefix));
    return together(objects);
  };
  text += fmt::format("#macro {0}_Broken(Glass, Crack)\n{1}#end\n\n", prefix, parts("Glass", false));
  const bool plain =
      pane.dirt == 0.0 && std::ranges::all_of(groups, [](const CrackGroup& group) { return group.material == own_tubes; });
  text += plain ? fmt::format("#declare {0}_Pane = object {{ {0}_Broken(Shatterpave_Glass, Shatterpave_Crack) }}\n", prefix)
                : fmt::format("#declare {}_Pane =\n{}", prefix, parts(slab_material(pane, prefix), true));
}

// A board about the outline, for frames that hold a pane of any shape.
void append_surround(std::string& text, const glass::Pane& pane, const std::string& prefix) {
  text += fmt::format(
      "#macro {0}_Surround(Width, Depth)\n   prism {{\n   linear_sweep linear_spline -Depth / 2, Depth / 2, {1},\n"
      "   <{0}_Min.x - Width, {0}_Min.y - Width>, <{0}_Max.x + Width, {0}_Min.y - Width>,\n"
      "   <{0}_Max.x + Width, {0}_Max.y + Width>, <{0}_Min.x - Width, {0}_Max.y + Width>,\n"
      "   <{0}_Min.x - Width, {0}_Min.y - Width>,\n",
      prefix, pane.outline_mm.size() + 6);
  append_ring(text, pane.outline_mm);
  text += fmt::format("\n{}   }}\n#end\n\n", standing);
}

std::vector<std::string> crack_lines(Body body) {
  if (body == Body::tubes) {
    return {"   {0}_Cracks     the tubes alone, without material; no two of them touch, so they may share one interior.",
            "                  Their radius is fixed, since they are trimmed by it"};
  }
  return {"   {0}_Cracks_0   the gaps alone, those of the first impact, without material; {0}_Cracks_1 those of the second …",
          "                  No two of them touch, so they may share one interior",
          "   {0}_Shot_Hole_0   the air of the first hole that goes through, with the cone on its far side; {0}_Shot_Hole_1 … "
          "The two",
          "                  faces of the slab go on over a hole as a skin of 0.01 mm, of which only a faint reflection shows"};
}

// Lines of the header that only bent panes have.
void describe_bend(const glass::Pane& pane, IncludeHeader& header) {
  if (pane.bow_mm == vec2{0.0, 0.0}) return;
  header.description.push_back(
      fmt::format("It is bent: {} mm across and {} mm along, above 0 towards -z; the corners of its box are at z = 0.",
                  number(pane.bow_mm.x), number(pane.bow_mm.y)));
}

IncludeHeader header(const BrokenPane& broken, const std::string& prefix, Body body) {
  IncludeHeader header;
  header.file = stem_of(broken) + ".inc";
  header.prefix = prefix;
  header.description = {
      fmt::format("Broken pane of glass \"{}\": {} cracks as {} of air in a slab.", broken.pane.name,
                  broken.network.cracks.size() + broken.far_network.cracks.size(), body == Body::tubes ? "tubes" : "thin gaps"),
      "1 unit = 1 mm. The pane stands upright as it is drawn in the scene file: x to the right, y up,",
      "the middle of its thickness at z = 0. Place it with object { … translate … }.",
      fmt::format("Needs max_trace_level 12 or more in global_settings: each {} and each face of the slab refracts.",
                  body == Body::tubes ? "tube" : "gap"),
  };
  describe_bend(broken.pane, header);
  const auto line = [&](std::string_view pattern) { return fmt::format(fmt::runtime(pattern), prefix); };
  header.declarations = {
      "Declares:",
      line("   {0}_Pane       all together, in materials of shatterpave_glass.inc: object {{ {0}_Pane }}"),
      line("   {0}_Broken(Glass, Crack)  macro: the same in materials of your own, which are"),
      "                  Glass   a material with an ior of about 1.5",
      "                  Crack   a material with an ior of 1: what fills the cracks is air",
      line("   {0}_Slab       the slab alone, without material"),
  };
  for (const std::string& pattern : crack_lines(body)) header.declarations.push_back(line(pattern));
  std::ranges::move(dirt_lines(broken.pane, prefix), std::back_inserter(header.declarations));
  for (const std::string_view pattern :
       {"   {0}_Crushed    the crushed zones about the impacts, with their materials",
        "                  (Cracks and Crushed are not declared where there are none)",
        "   {0}_Surround(Width, Depth)  macro: a board about the outline, Width wider than the bounding box, Depth",
        "                  thick, about z = 0, without texture: for a frame",
        "   {0}_Min, {0}_Max  corners of the bounding box of the slab", "   {0}_Thickness  of the slab",
        "   {0}_Rectangular  1 if the outline fills the bounding box, else 0"}) {
    header.declarations.push_back(line(pattern));
  }
  return header;
}

IncludeHeader shards_header(const BrokenPane& broken, const std::string& prefix, bool has_cracks) {
  IncludeHeader header;
  header.file = stem_of(broken) + ".inc";
  header.prefix = prefix;
  header.description = {
      fmt::format("Broken pane of glass \"{}\" as shards: closed meshes, no two of which touch.", broken.pane.name),
      "1 unit = 1 mm. The pane stands upright as it is drawn in the scene file: x to the right, y up,",
      "the middle of its thickness at z = 0. Place it with object { … translate … }.",
      "Needs max_trace_level 12 or more in global_settings: each face of a shard refracts.",
  };
  describe_bend(broken.pane, header);
  header.declarations = {"Declares:"};
  std::ranges::copy(shard_declarations(prefix, has_cracks), std::back_inserter(header.declarations));
  std::ranges::move(dirt_lines(broken.pane, prefix), std::back_inserter(header.declarations));
  for (const std::string_view pattern :
       {"   {0}_Slab       the whole pane alone, without material",
        "   {0}_Surround(Width, Depth)  macro: a board about the outline, Width wider than the bounding box, Depth",
        "                  thick, about z = 0, without texture: for a frame",
        "   {0}_Min, {0}_Max  corners of the bounding box of the pane", "   {0}_Thickness  of the pane",
        "   {0}_Rectangular  1 if the outline fills the bounding box, else 0"}) {
    header.declarations.push_back(fmt::format(fmt::runtime(pattern), prefix));
  }
  return header;
}

OutputFile shards_include(const BrokenPane& broken, const std::string& prefix, std::uint64_t seed) {
  const std::vector<shapes::Tube> tubes = shapes::joined_tubes(broken);
  std::string text = "#include \"shatterpave_shards.inc\"\n";
  text += tubes.empty() ? "\n" : "#include \"shatterpave_glass.inc\"\n\n";
  append_slab(text, broken.pane, prefix);
  append_surround(text, broken.pane, prefix);
  append_declaration(text, prefix + "_Cracks", tube_texts(tubes, glass::bend_of(broken.pane)));
  text += dirt_text(broken.pane, prefix, seed);
  append_shards(text, broken, prefix, !tubes.empty());
  const IncludeHeader about = shards_header(broken, prefix, !tubes.empty());
  return {about.file, include_text(about, text)};
}

}  // namespace

OutputFile pane_include(const BrokenPane& broken, const std::string& prefix, std::uint64_t seed) {
  if (broken.pane.shards) return shards_include(broken, prefix, seed);
  const Body body = broken.pane.crack_body == glass::CrackBody::sheet ? Body::sheets : Body::tubes;
  std::vector<glass::ImpactZone> zones = shapes::crushed_zones(broken.surfaces);
  std::vector<CrackGroup> groups;
  if (body == Body::sheets) {
    groups = crack_groups(broken, prefix);
  } else {
    const shapes::TubedCracks cracks = shapes::tubed_cracks(broken.pane, broken.network, broken.far_network);
    zones = cracks.zones;
    if (!cracks.tubes.empty())
      groups.push_back({prefix + "_Cracks", std::string(own_tubes), tube_texts(cracks.tubes, glass::bend_of(broken.pane))});
  }
  const bool is_flat = glass::bend_of(broken.pane).is_flat();
  std::string text = fmt::format("#include \"shatterpave_{}glass.inc\"\n\n", is_flat ? "" : "bent_");
  append_slab(text, broken.pane, prefix);
  for (const CrackGroup& group : groups) append_declaration(text, group.name, group.objects);
  append_declaration(text, prefix + "_Crushed", crushed_texts(zones, broken.pane, prefix));
  append_surround(text, broken.pane, prefix);
  text += dirt_text(broken.pane, prefix, seed);
  append_whole(text, broken.pane, groups, !zones.empty(), prefix);
  const IncludeHeader about = header(broken, prefix, body);
  return {about.file, include_text(about, text)};
}

}  // namespace shatterpave::exporting::povray
