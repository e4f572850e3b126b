// Lays an L-shaped court with a tree pit, and tells what is to be ordered: stones by kind, and their area.
#include <shatterpave/shatterpave.h>

#include <exception>
#include <iostream>

using namespace shatterpave;

namespace {

Scene court() {
  Scene scene("court");
  const Polygon outline = {{0, 0}, {4000, 0}, {4000, 1500}, {1500, 1500}, {1500, 3000}, {0, 3000}};
  const Polygon tree_pit = {{500, 500}, {1000, 500}, {1000, 1000}, {500, 1000}};
  scene.add_pavement("yard", outline, {tree_pit});
  scene.set("pavement.yard.stone_mm", Point{200, 100});
  scene.set("pavement.yard.joint_mm", 5);
  scene.set("pavement.yard.bond", "running");
  return scene;
}

struct Sum {
  int count = 0;
  double area_mm2 = 0.0;
};

void print(const char* kind, const Sum& sum) {
  std::cout << "  " << kind << ": " << sum.count << " stones, " << sum.area_mm2 * 1e-6 << " m2\n";
}

}  // namespace

int main() {
  try {
    const Model model = generate(court());
    for (const Pavement& pavement : model.pavements()) {
      Sum whole;
      Sum cut;
      for (const Stone& stone : pavement.stones) {
        Sum& sum = stone.kind == StoneKind::whole ? whole : cut;
        ++sum.count;
        sum.area_mm2 += area(stone.outline_mm);
      }
      std::cout << pavement.name << ": " << area(pavement.area_mm) * 1e-6 << " m2\n";
      print("whole", whole);
      print("cut", cut);
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
