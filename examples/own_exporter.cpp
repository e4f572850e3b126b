// An exporter of one's own: the stones of a scene as closed polylines in DXF (AutoCAD R12), for drawing programs and for
// machines that cut stone. Whole and cut stones, and the border of the area, are on layers of their own; units are millimetres.
//   own_exporter SCENE.toml FOLDER   writes SCENE.dxf there
#include <shatterpave/shatterpave.h>

#include <exception>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>

using namespace shatterpave;

namespace {

// DXF is pairs of lines: a code that says what the value is, and the value.
class Dxf {
 public:
  Dxf() {
    text_.imbue(std::locale::classic());
    text_.precision(17);
    put(0, "SECTION");
    put(2, "ENTITIES");
  }

  void put_closed_polyline(const std::string& layer, const Polygon& polygon) {
    put(0, "POLYLINE");
    put(8, layer);
    put(66, 1);  // vertices follow
    put(70, 1);  // closed
    for (const Point& point : polygon) {
      put(0, "VERTEX");
      put(8, layer);
      put(10, point.x);
      put(20, point.y);
    }
    put(0, "SEQEND");
  }

  std::string finished() {
    put(0, "ENDSEC");
    put(0, "EOF");
    return text_.str();
  }

 private:
  template <typename Number>
  void put(int code, const Number& value) {
    text_ << code << '\n' << value << '\n';
  }

  std::ostringstream text_;
};

std::string dxf(const Model& model) {
  Dxf out;
  for (const Pavement& pavement : model.pavements()) {
    out.put_closed_polyline(pavement.name + "-area", pavement.area_mm.outline);
    for (const Polygon& hole : pavement.area_mm.holes) out.put_closed_polyline(pavement.name + "-area", hole);
    for (const Stone& stone : pavement.stones) {
      out.put_closed_polyline(pavement.name + "-" + std::string(name_of(stone.kind)), stone.outline_mm);
    }
  }
  return out.finished();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: own_exporter SCENE.toml FOLDER\n";
    return 2;
  }
  try {
    const Scene scene = Scene::from_file(argv[1]);
    for (const Note& note : scene.notes()) std::cerr << note.place.key << ": " << note.what << '\n';
    const Model model = generate(scene);
    // Like the command's own files: all of them or none, and never mixed with those of another state of the scene.
    const Written written = write_files(model, {{model.name() + ".dxf", dxf(model)}}, argv[2], "dxf");
    for (const auto& file : written.files) std::cout << file.string() << '\n';
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
