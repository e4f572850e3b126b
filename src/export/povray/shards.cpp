#include "export/povray/shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "export/povray/bent_glass.h"
#include "export/povray/sdl.h"
#include "geometry/bend.h"

namespace shatterpave::exporting::povray {

namespace {

// Elements of a list of a mesh, several a line.
template <typename List, typename Put>
void append_list(std::string& text, std::string_view name, const List& list, const Put& put) {
  text += fmt::format("   {} {{ {},\n", name, list.size());
  std::size_t i = 0;
  for (const auto& element : list) {
    text += i % 6 == 0 ? "      " : " ";
    put(element);
    ++i;
    text += i == list.size() ? " }\n" : (i % 6 == 0 ? ",\n" : ",");
  }
}

// The motion in POV-Ray's left-handed coordinates: z is turned round before and after. A row of its matrix is where an axis
// goes.
void append_motion(std::string& text, const glass::Motion& motion) {
  if (motion == glass::Motion{}) return;
  const auto& rows = motion.rows;
  const double values[] = {rows[0].x,         rows[1].x,         -rows[2].x,  //
                           rows[0].y,         rows[1].y,         -rows[2].y,  //
                           -rows[0].z,        -rows[1].z,        rows[2].z,   //
                           motion.shift_mm.x, motion.shift_mm.y, -motion.shift_mm.z};
  text += "   matrix <";
  for (const double& value : values) {
    if (&value != values) text += ", ";
    append_number(text, value);
  }
  text += ">\n";
}

void append_mesh(std::string& text, const glass::Shard& shard, const glass::Pane& pane) {
  const double thickness_mm = pane.thickness_mm;
  if (const geometry::Bend bend = glass::bend_of(pane); !bend.is_flat()) {
    text += shard_mesh_text(shard, bend, thickness_mm);
    append_motion(text, shard.motion);
    text += "}\n";
    return;
  }
  text += "mesh2 {\n";
  append_list(text, "vertex_vectors", shard.solid.vertices, [&](const geometry::LatticePoint3& vertex) {
    append_standing_point(text, glass::in_pane_mm(vertex, thickness_mm));
  });
  text += "   texture_list { 2, texture { Old } texture { Broken } }\n";
  // Counter-clockwise in right-handed coordinates is clockwise in left-handed ones; POV-Ray takes either.
  append_list(text, "face_indices", shard.solid.triangles, [&](const geometry::SolidTriangle& triangle) {
    fmt::format_to(std::back_inserter(text), "<{},{},{}>,{}", triangle.corners[0], triangle.corners[1], triangle.corners[2],
                   triangle.slot);
  });
  append_motion(text, shard.motion);
  text += "}\n";
}

}  // namespace

void append_shards(std::string& text, const BrokenPane& broken, const std::string& prefix, bool has_cracks) {
  std::vector<const glass::Shard*> there;
  for (const glass::Shard& shard : broken.shards) {
    if (shard.state != glass::ShardState::missing) there.push_back(&shard);
  }
  const glass::ShardRules& rules = *broken.pane.shards;
  text += fmt::format(
      "#declare {0}_Shard_Count = {1};\n#declare {0}_Sill_Drop = {2};\n#declare {0}_Sill_Depth = {3};\n"
      "#declare {0}_Frame = {4};\n#declare {0}_Reveal = {5};\n#declare {0}_Floor_Drop = {6};\n\n",
      prefix, there.size(), number(rules.sill_drop_mm), number(rules.sill_depth_mm), number(rules.frame_mm),
      number(rules.reveal_mm), number(rules.floor_drop_mm));
  for (std::size_t i = 0; i < there.size(); ++i) {
    text += fmt::format("#macro {}_Shard_{}(Old, Broken) // {}, {}\n", prefix, i, there[i]->id,
                        there[i]->state == glass::ShardState::standing ? "standing" : "fallen");
    append_mesh(text, *there[i], broken.pane);
    text += "#end\n";
  }
  text += fmt::format("\n#macro {}_Shard(I, Old, Broken)\n#switch (I)\n", prefix);
  for (std::size_t i = 0; i < there.size(); ++i)
    text += fmt::format("#case ({1}) {0}_Shard_{1}(Old, Broken) #break\n", prefix, i);
  text += "#end\n#end\n\n";
  // Each by its own name: a switch is read through to its case, so that n of them would take n² time.
  text += fmt::format("#macro {0}_Shards(Old, Broken, Inside)\n", prefix);
  if (has_cracks) text += "   union {\n";
  // POV-Ray warns of a union of one.
  const bool is_one_body = rules.joined && there.size() == 1;
  text += is_one_body ? "   object {\n" : "   union {\n";
  for (std::size_t i = 0; i < there.size(); ++i)
    text += fmt::format("      object {{ {0}_Shard_{1}(Old, Broken){2} }}\n", prefix, i,
                        there[i]->state == glass::ShardState::standing ? " Shatterpave_Standing()" : "");
  text += "      interior { Inside }\n      double_illuminate\n   }\n";
  if (has_cracks) {
    text += fmt::format("   object {{ {}_Cracks material {{ Shatterpave_Crack }} double_illuminate }}\n   }}\n", prefix);
  }
  const bool dirty = broken.pane.dirt > 0.0;
  text += "#end\n\n";
  if (dirty) text += fmt::format("#declare {0}_Old = texture {{ Shatterpave_Shard_Old }} texture {{ {0}_Dirt }}\n", prefix);
  text +=
      fmt::format("#declare {0}_Pane = object {{ {0}_Shards({1}, Shatterpave_Shard_Broken, Shatterpave_Shard_Interior) }}\n",
                  prefix, dirty ? prefix + "_Old" : "Shatterpave_Shard_Old");
}

std::vector<std::string> shard_declarations(const std::string& prefix, bool has_cracks) {
  const auto line = [&](std::string_view pattern) { return fmt::format(fmt::runtime(pattern), prefix); };
  std::vector<std::string> lines{
      line("   {0}_Shard_0(Old, Broken), {0}_Shard_1(Old, Broken) and so on  macros: one of the shards each, without interior"),
      line("   {0}_Pane       all shards, in materials of shatterpave_shards.inc: object {{ {0}_Pane }}"),
      line("   {0}_Shards(Old, Broken, Inside)  macro: the same in textures and an interior of your own, which are"),
      "                  Old     of the pane's faces and edge",
      "                  Broken  of the walls of cracks and of chips",
      "                  Inside  with an ior of about 1.5",
      line("   {0}_Shard(I, Old, Broken)  macro: the one of that number"),
      line("   {0}_Shard_Count"),
      line("   {0}_Sill_Drop, {0}_Floor_Drop  what fell lies so far below {0}_Min.y"),
      line("   {0}_Sill_Depth  the sill reaches so far out, towards -z"),
      line("   {0}_Frame      the frame stands out so far"),
      line("   {0}_Reveal     walls are so far beyond {0}_Min.x and {0}_Max.x"),
  };
  if (has_cracks) {
    lines.push_back(
        line("   {0}_Cracks     the tubes of the cracks within joined shards alone, without material; Shards has them in"));
    lines.emplace_back("                  Shatterpave_Crack. No two of them touch, and none touches a face of its shard");
  }
  return lines;
}

}  // namespace shatterpave::exporting::povray
