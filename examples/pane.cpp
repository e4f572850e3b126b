// Breaks a shop window in two places, counts its cracks by kind, and writes a drawing of it.
//   pane FOLDER   writes shop-window.svg there
#include <shatterpave/shatterpave.h>

#include <exception>
#include <iostream>
#include <map>
#include <string_view>

using namespace shatterpave;

namespace {

// Every key of docs/scene-file.md can be set.
Scene shop() {
  Scene scene("shop");
  scene.set("seed", 7);
  scene.add_pane("window", {{0, 0}, {1200, 0}, {1200, 900}, {0, 900}});
  scene.set("pane.window.thickness_mm", 6);
  for (const Point at : {Point{400, 500}, Point{900, 300}}) {
    const std::string impact = scene.add_impact("window", at);
    scene.set(impact + ".radial_count", 30);
    scene.set(impact + ".large_count", 8);
  }
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: pane FOLDER\n";
    return 2;
  }
  try {
    const Model model = generate(shop());
    for (const Pane& pane : model.panes()) {
      std::map<std::string_view, int> counts;
      for (const Crack& crack : pane.cracks) ++counts[name_of(crack.kind)];
      std::cout << pane.name << ": " << pane.impacts.size() << " impacts, " << pane.cracks.size() << " cracks\n";
      for (const auto& [kind, count] : counts) std::cout << "  " << kind << ": " << count << '\n';
    }
    for (const auto& file : write_targets(model, {"svg"}, argv[1]).files) std::cout << file.string() << '\n';
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';  // which key, what was expected, what was found
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
