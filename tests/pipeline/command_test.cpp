// The built command, as a user runs it: exit status, what it prints, and that the same scene gives the same bytes.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <thread>

#include "pipeline/subprocess.h"
#include "pipeline/write.h"
#include "support/places.h"
#include "support/temporary_folder.h"

namespace shatterpave::pipeline {
namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Leaves AVX2 and FMA out of the C library's choice of functions. The names ending in _Usable are those of glibc before 2.33,
// which later ones ignore, the others those since.
const std::string without_fma = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4";

struct Outcome {
  int status = 0;
  std::string out;  // stdout
  std::string err;  // stderr
};

class Command : public support::FolderTest {
 protected:
  void SetUp() override {
    write_file(folder_ / "s.toml", scene);
    fs::create_directory(folder_ / "same");
  }

  // The shell only takes the two streams apart.
  Outcome command(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) const {
    std::vector<std::string> all = {"sh", "-c", "exec \"$0\" \"$@\" >stdout.txt 2>stderr.txt", support::command()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ending ending = pipeline::run({all, folder_, environment, {}}, [](std::string_view) {}, {});
    EXPECT_EQ(ending.signal, 0);
    // A slow machine, or one under a sanitizer, gets to the first line of progress, of which tests of ProgressReport speak.
    static const std::regex progress("[^\n]*: [0-9]+ %, [0-9]+ s\n");
    Outcome result{ending.status, text_of(folder_ / "stdout.txt"),
                   std::regex_replace(text_of(folder_ / "stderr.txt"), progress, "")};
    fs::remove(folder_ / "stdout.txt");
    fs::remove(folder_ / "stderr.txt");
    return result;
  }

  Files files_in(const fs::path& folder) const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      files[fs::relative(entry.path(), folder).string()] = entry.is_directory() ? "folder" : text_of(entry.path());
    }
    return files;
  }

  static constexpr std::string_view scene = R"(seed = 3
[[pane]]
name = "window"
preset = "agui1992-fig15b"
impact = [{at_mm = [150, 150], radial_count = 75}]
[[pane]]
name = "other"
size_mm = [200, 150]
[[pane.impact]]
at_mm = [60, 70]
radial_count = 24
[[pavement]]
name = "path"
outline_mm = [[0, 0], [1500, 100], [1600, 800], [800, 700], [0, 900]]
holes_mm = [[[300, 300], [500, 300], [500, 500]]]
[pavement.direction]
kind = "boundary"
[pavement.textures]
size_px = 256
)";
};

TEST_F(Command, WritesTheSameBytesWithAnyThreadsLocaleAndProcessor) {
  const std::vector<std::string> targets = {"--target", "povray", "--target", "json",
                                            "--target", "svg",    "--target", "textures"};
  const auto exported = [&](const std::string& folder, const std::string& threads,
                            const std::vector<std::string>& environment) {
    std::vector<std::string> arguments = {"export", "s.toml", "-o", folder, "--threads", threads};
    arguments.insert(arguments.end(), targets.begin(), targets.end());
    const Outcome result = command(arguments, environment);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return files_in(folder_ / folder);
  };
  const Files first = exported("one", "1", {});
  EXPECT_GE(first.size(), 13U);
  EXPECT_TRUE(first.contains("path_BaseColor.png"));
  EXPECT_EQ(exported("two", "2", {"LC_ALL=de_DE.UTF-8"}), first);
  EXPECT_EQ(exported("seven", "7", {"LC_ALL=tr_TR.UTF-8", without_fma}), first);
  // A twin that must differ, or equality means nothing.
  const Outcome other = command({"export", "s.toml", "-o", "other", "--target", "json", "--seed", "4"});
  EXPECT_EQ(other.status, 0);
  EXPECT_NE(text_of(folder_ / "other/s.json"), first.at("s.json"));
}

// The C library's functions really change by that switch, on a processor that has what it leaves out; on another they do not.
TEST_F(Command, TunablesChangeTheCLibrary) {
  const bool has_fma = text_of("/proc/cpuinfo").find(" fma ") != std::string::npos;
  const auto results = [&](const std::vector<std::string>& environment) {
    std::string text;
    const std::string script =
        "import math; print(hash(tuple(math.pow(1 + i / 999, 1.37) + math.sin(i) for i in range(50000))))";
    pipeline::run({{"python3", "-c", script}, folder_, environment, {}}, [&](std::string_view more) { text += more; }, {});
    return text;
  };
  const std::string usual = results({});
  EXPECT_FALSE(usual.empty());
  EXPECT_EQ(results({}), usual);
  EXPECT_EQ(results({without_fma}) != usual, has_fma);
}

TEST_F(Command, PrintsOneLineForEachFileAndNothingElse) {
  const Outcome result = command({"export", "s.toml", "-o", "out", "--target", "svg", "--target", "json", "--target", "svg"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "out/s.json\nout/s-window.svg\nout/s-other.svg\nout/s-path.svg\n");
  EXPECT_EQ(result.err, "");
  const Outcome check = command({"check", "s.toml"});
  EXPECT_EQ(check.status, 0);
  EXPECT_EQ(check.out,
            "s.toml: 2 panes (window, 300 × 300 mm, 1 impact; other, 200 × 150 mm, 1 impact), 1 pavement (path, 1.1 m², about "
            "100 stones)\n");
  EXPECT_EQ(check.err, "");
}

TEST_F(Command, WrongInputAndUsageEndWithTwoAndWriteNothing) {
  write_file(folder_ / "a_file", "x");
  write_file(folder_ / "path_textures.toml", scene);
  write_file(folder_ / "bad.toml", "[[pane]]\nname = \"w\"\nsize_mm = [nan, 9]\n");
  const Files before = files_in(folder_);
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2) << message;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, message + "\n");
    EXPECT_EQ(files_in(folder_), before);
  };
  expect({"export", "bad.toml", "-o", "out"},
         "bad.toml:3:12: pane[0].size_mm[0]: expected a number above 0 and of at most 1000000, got nan");
  expect({"render", "none.toml", "-o", "out"}, "none.toml: expected a file, got none of that name");
  expect({"export", "s.toml", "-o", "a_file"}, "a_file: expected an output folder, got a file: a_file");
  expect({"export", "s.toml", "-o", ""}, "expected an output folder, got an empty name");
  expect({"export", "s.toml", "-o", "out", "--target", "json", "--target", "svg", "--set", "pane[1].name=shatterpave_glass"},
         "--set pane[1].name=shatterpave_glass: pane[1].name: expected a name that no file of materials has, got "
         "\"shatterpave_glass.inc\"");
  expect({"export", "path_textures.toml", "-o", "out", "--target", "json", "--target", "textures"},
         "names: expected other ones of the scene and of what is in it, got such that two files are called "
         "'path_textures.json'");
  // What laying would refuse, checking does.
  expect(
      {"check", "s.toml", "--set", "pavement.path.stone_mm=[50, 100]", "--set", "pavement.path.bond=herringbone"},
      "--set pavement.path.stone_mm=[50, 100]: pavement[0].stone_mm: expected stones at least as long as wide for this bond, "
      "got [50, 100]");
  expect({"export", "s.toml", "-o", "out", "--target", "foo"},
         "shatterpave: --target: expected povray, json, svg, textures, csv, gltf, obj, ply, usd or mitsuba, got \"foo\"");
  expect({"export", "s.toml", "-o", "out", "--seed", "-1"},
         "--seed -1: seed: expected a whole number from 0 to 9223372036854775807, got -1");
  expect({"check", "s.toml", "--set", "pane[0].thickness_mm=nan"},
         "--set pane[0].thickness_mm=nan: pane[0].thickness_mm: expected a number from 0.1 to 1000, got nan");
  expect({"check", "s.toml", "--set", "seed"}, "--set seed: expected KEY=VALUE, got no '=' after a key");
  expect({"render", "s.toml", "-o", "out", "--size", "640"},
         "shatterpave: --size: expected WIDTHxHEIGHT in pixels, each from 1 to 16384, such as 640x480, got \"640\"");
}

// Each message names the word, what was expected, the names there are, and the one that was probably meant.
TEST_F(Command, WrongUsageNamesTheWordAndWhatWasMeant) {
  write_file(folder_ / "t.toml", scene);
  write_file(folder_ / "binary.toml", std::string("\x7f"
                                                  "ELF\x02\x01\x01\0\xff\xfe",
                                                  10));
  fs::create_directories(folder_ / "folder.toml");
  const Files before = files_in(folder_);
  struct Usage {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::string commands =
      "shatterpave: expected a command, export, check, farm, fit, keys, manual, measure, render, serve or trace, got ";
  const std::string of_export =
      "shatterpave: export: expected an option of -h, --help, --set, --seed, -o, --target, --scale, --frames or --threads, "
      "got ";
  const std::string size = "shatterpave: --size: expected WIDTHxHEIGHT in pixels, each from 1 to 16384, such as 640x480, got ";
  const std::string seed = "seed: expected a whole number from 0 to 9223372036854775807, got ";
  const std::vector<Usage> usages = {
      {{}, commands + "none (see shatterpave --help)"},
      {{"exprot", "s.toml", "-o", "out"}, commands + "\"exprot\"; did you mean export?"},
      {{"rendr", "s.toml"}, commands + "\"rendr\"; did you mean render?"},
      {{"polish", "s.toml"}, commands + "\"polish\""},
      {{"s.toml"}, commands + "\"s.toml\""},
      {{"-o", "out", "export", "s.toml"}, commands + "\"-o\""},
      {{"export", "-o", "out"}, "shatterpave: export: expected a scene file, SCENE.toml, got none"},
      {{"export", "", "-o", "out"}, "shatterpave: export: expected a scene file, SCENE.toml, got an empty name"},
      {{"check", "s.toml", "t.toml"}, "shatterpave: check: expected one scene file, got 2: \"s.toml\" and \"t.toml\""},
      {{"export", "s.toml", "check"}, "shatterpave: export: expected one scene file, got 2: \"s.toml\" and \"check\""},
      {{"export", "s.toml"}, "shatterpave: export: expected -o DIR, the output folder, got none"},
      {{"export", "s.toml", "-o"}, "shatterpave: -o: expected DIR after it, got nothing"},
      {{"export", "s.toml", "-o", "--seed", "3"}, "shatterpave: -o: expected DIR after it, got the option --seed"},
      {{"export", "s.toml", "-o", "a", "-o", "b"}, "shatterpave: -o: expected it once, got it 2 times, with \"a\" and \"b\""},
      {{"export", "s.toml", "-o", "out", "--seed", "3", "--seed=3"},
       "shatterpave: --seed: expected it once, got it 2 times, with \"3\" and \"3\""},
      {{"export", "s.toml", "-o", "out", "--targt", "json"}, of_export + "\"--targt\"; did you mean --target?"},
      {{"export", "s.toml", "-o", "out", "--size", "9x9"}, of_export + "\"--size\", an option of render"},
      {{"export", "s.toml", "-o", "out", "--frobnicate"}, of_export + "\"--frobnicate\""},
      {{"check", "s.toml", "--threads", "2"},
       "shatterpave: check: expected an option of -h, --help, --set, --seed or --target, got \"--threads\", an option of "
       "trace"},
      {{"export", "s.toml", "-o", "out", "--target", "jsn"},
       "shatterpave: --target: expected povray, json, svg, textures, csv, gltf, obj, ply, usd or mitsuba, got \"jsn\"; did you "
       "mean "
       "json?"},
      {{"export", "s.toml", "-o", "out", "--target", "json,svg"},
       "shatterpave: --target: expected povray, json, svg, textures, csv, gltf, obj, ply, usd or mitsuba, got \"json,svg\""},
      {{"export", "s.toml", "-o", "out", "--target="}, "shatterpave: --target: expected TARGET after it, got \"\""},
      {{"render", "s.toml", "-o", "out", "--quality", "fianl"},
       "shatterpave: --quality: expected draft or final, got \"fianl\"; did you mean final?"},
      {{"render", "s.toml", "-o", "out", "--size", "0x0"}, size + "\"0x0\""},
      {{"render", "s.toml", "-o", "out", "--size", "640x480px"}, size + "\"640x480px\""},
      {{"render", "s.toml", "-o", "out", "--size", "640*480"}, size + "\"640*480\""},
      {{"render", "s.toml", "-o", "out", "--size", ""}, size + "\"\""},
      {{"export", "s.toml", "-o", "out", "--threads", "-1"},
       "shatterpave: --threads: expected a whole number from 0 to 1024, got \"-1\""},
      {{"export", "s.toml", "-o", "out", "--threads", "2x"},
       "shatterpave: --threads: expected a whole number from 0 to 1024, got \"2x\""},
      {{"export", "s.toml", "-o", "out", "--threads", "99999999999999999999"},
       "shatterpave: --threads: expected a whole number from 0 to 1024, got \"99999999999999999999\""},
      {{"check", "s.toml", "--seed", ""}, "--seed : " + seed + "the text \"\""},
      {{"check", "s.toml", "--seed", "3x"}, "--seed 3x: " + seed + "the text \"3x\""},
      {{"check", "s.toml", "--seed", "1.5"}, "--seed 1.5: " + seed + "1.5"},
      {{"check", "s.toml", "--set", "pane.windw.thickness_mm=3"},
       "--set pane.windw.thickness_mm=3: expected pane[0], pane[1], pane.window or pane.other, got \"windw\"; did you mean "
       "pane.window?"},
      {{"check", "folder.toml"}, "folder.toml: expected a file, got a folder"},
      {{"check", "binary.toml"}, "binary.toml:1:9: expected UTF-8 text, got the byte 0xff"},
  };
  for (const Usage& usage : usages) {
    const Outcome result = command(usage.arguments);
    EXPECT_EQ(result.status, 2) << usage.message;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, usage.message + "\n");
    EXPECT_EQ(files_in(folder_), before);
  }
}

// An empty file is an import that finds nothing, hours later.
TEST_F(Command, RefusesAnObjWithoutContent) {
  write_file(folder_ / "gone.toml", R"(seed = 3
[[pane]]
name = "window"
size_mm = [100, 80]
impact = [{at_mm = [50, 40], radial_count = 9}]
[pane.shards]
splinter_mm2 = 100000
)");
  const Files before = files_in(folder_);
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, message);
    EXPECT_EQ(files_in(folder_), before);
  };
  expect(
      {"export", "gone.toml", "-o", "out", "--target", "obj"},
      "target obj: expected a shard that stands or has fallen, got none: every piece of window is gone, or is a splinter (see "
      "missing, missing_mm, held, fallen and splinter_mm2 of [pane.shards])\n");
  EXPECT_EQ(command({"check", "gone.toml", "--target", "obj"}).status, 0);
  EXPECT_EQ(command({"check", "s.toml", "--target", "obj"}).status, 0);
}

// What no machine could hold is refused before it is made.
TEST_F(Command, RefusesMeshesOfTooManyStones) {
  write_file(folder_ / "square.toml", R"([[pavement]]
name = "square"
size_mm = [80000, 80000]
stone_mm = [100, 100]
joint_mm = 0
)");
  for (const char* target : {"gltf", "obj", "ply", "usd", "mitsuba"}) {
    const Outcome result = command({"check", "square.toml", "--target", target});
    EXPECT_EQ(result.status, 2) << target;
    EXPECT_EQ(
        result.err,
        "square.toml:4:12: pavement[0].stone_mm: expected at most 500000 stones for meshes, got an area for about 640000\n");
  }
  EXPECT_EQ(command({"check", "square.toml", "--target", "json"}).status, 0);
}

TEST_F(Command, AFolderThatCannotBeMadeIsWrongInput) {
  fs::create_symlink(folder_ / "nowhere" / "at" / "all", folder_ / "dangling");
  const auto expect = [&](const std::string& folder, const std::string& words) {
    const Outcome result = command({"export", "s.toml", "-o", folder, "--target", "json"});
    EXPECT_EQ(result.status, 2) << folder;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.err.find("filesystem error"), std::string::npos) << result.err;
  };
  expect("/proc/foo", "/proc/foo: expected an output folder that can be written to, got: ");
  expect("dangling", "dangling: expected an output folder, got a link to nothing");
  expect("dangling/below", "expected an output folder, got a link to nothing");
  expect("/proc", "/proc: expected an output folder that can be written to, got: ");
  expect(std::string(300, 'x'), "expected a folder that can be made and written to, got an error: ");
  if (::geteuid() == 0) return;  // who may write everywhere
  fs::create_directories(folder_ / "locked");
  fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  expect("locked", "locked: expected a folder that can be made and written to, got an error: ");
  expect("locked/below", "expected a folder that can be made and written to, got an error: ");
}

// What cannot be laid, or has no effect, is told at its place; and the work is done.
TEST_F(Command, TellsWhatHasNoEffectAndWhereNothingIsLaid) {
  write_file(folder_ / "told.toml", R"([[pane]]
name = "w"
size_mm = [90, 70]
[[pane.impact]]
at_mm = [40, 30]
radial_count = 12
speed_m_s = 15
[[pavement]]
name = "p"
size_mm = [6, 6]
[[pavement]]
name = "q"
size_mm = [300, 300]
bond = "running"
border_course = "soldier"
stone_mm = [200, 150]
[[pavement]]
name = "none"
size_mm = [300, 300]
variation.missing = 1
)");
  const std::string idle =
      "told.toml:7:13: pane[0].impact[0].speed_m_s: note: has no effect beside radial_count, mean_radial_count or preset\n";
  const std::string empty =
      "told.toml:8:1: pavement[0].stone_mm: note: no stone of p is laid: none fits in its 6 × 6 mm with joints of 8 mm\n"
      "told.toml:15:17: pavement[1].border_course: note: leaves nothing within: of q the border course alone is laid\n"
      "told.toml:20:21: pavement[2].variation.missing: note: leaves no stone of none\n";
  const Outcome check = command({"check", "told.toml"});
  EXPECT_EQ(check.status, 0);
  EXPECT_EQ(check.err, idle + empty);
  const Outcome exported = command({"export", "told.toml", "-o", "out", "--target", "json"});
  EXPECT_EQ(exported.status, 0);
  EXPECT_EQ(exported.out, "out/told.json\n");
  EXPECT_EQ(exported.err, idle + empty);
}

// What laying and seamless tiles refuse has the place of the key.
TEST_F(Command, RefusalsOfLayingHaveTheirPlaces) {
  const auto expect = [&](const std::string& lines, const std::string& message) {
    write_file(folder_ / "laid.toml", "[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n" + lines);
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"check", "laid.toml"},
                                               {"export", "laid.toml", "-o", "out", "--target", "json"},
                                               {"measure", "laid.toml", "-o", "out"}}) {
      const Outcome result = command(arguments);
      EXPECT_EQ(result.status, 2) << arguments.front();
      EXPECT_EQ(result.err, message + "\n");
      EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
  };
  expect("bond = \"fan\"\nbond_span_mm = 40\n",
         "laid.toml:5:16: pavement[0].bond_span_mm: expected 0, or at least 540 (five stones), got 40");
  expect("bond = \"fan\"\nstone_mm = [300, 100]\n",
         "laid.toml:5:12: pavement[0].stone_mm: expected stones at most twice as long as wide for this bond, got [300, 100]");
  expect("bond = \"ashlar\"\n[pavement.textures]\nseamless = true\n",
         "laid.toml:6:12: pavement[0].textures.seamless: expected a bond that repeats (not ashlar or crazy), rows in one "
         "direction and stones of one size");
  expect("textures = {seamless = true, tile_mm = [3, 3]}\n",
         "laid.toml:4:40: pavement[0].textures.tile_mm: expected a tile that whole periods of the bond fit, such as [108.000, "
         "1080.000], got [3, 3]");
}

TEST_F(Command, MeasuresTheSameBytesWithAnyThreads) {
  const auto measured = [&](const std::string& folder, const std::string& threads, const std::string& seed) {
    const Outcome result = command(
        {"measure", "s.toml", "-o", folder, "--seeds", "3", "--radials", "24..90", "--threads", threads, "--seed", seed});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(result.out.starts_with(folder + "/s-measures.csv\n" + folder + "/s-measures.json\n")) << result.out;
    // Without the plotting library there is no report, and one line that says so.
    EXPECT_EQ(result.err.empty(), result.out.ends_with("s-measures.html\n")) << result.err;
    return files_in(folder_ / folder);
  };
  const Files first = measured("one", "1", "3");
  EXPECT_GE(first.size(), 2U);
  EXPECT_EQ(measured("two", "2", "3"), first);
  EXPECT_NE(measured("other", "2", "4"), first);
}

TEST_F(Command, WrongUsageOfMeasureEndsWithTwoAndWritesNothing) {
  write_file(folder_ / "path.toml", "[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n");
  const Files before = files_in(folder_);
  const auto expect = [&](const std::vector<std::string>& options, const std::string& message) {
    std::vector<std::string> arguments = {"measure"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2) << message;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(files_in(folder_), before);
  };
  expect({"s.toml", "--seeds", "3"}, "shatterpave: measure: expected -o DIR, the output folder, got none");
  for (const char* seeds : {"0", "-3", "many", "100001", "3x", ""}) {
    expect({"s.toml", "-o", "out", "--seeds", seeds},
           std::string("shatterpave: --seeds: expected a whole number from 1 to 100000, got \"") + seeds + "\"");
  }
  const std::string sweep = "shatterpave: --radials: expected LOW..HIGH, whole numbers from 1 to 10000";
  for (const char* radials : {"24", "24..", "..195", "0..5", "24..10001", "24...195", "a..b", "24-195", ""}) {
    expect({"s.toml", "-o", "out", "--seeds", "3", "--radials", radials}, sweep + ", got \"" + radials + "\"");
  }
  expect({"s.toml", "-o", "out", "--radials", "195..24"},
         sweep + ", the lower one first, got \"195..24\"; did you mean 24..195?");
  expect({"path.toml", "-o", "out", "--radials", "24..90"},
         "path.toml: expected one or more tables [[pane]] for --radials, got none");
  expect({"none.toml", "-o", "out", "--seeds", "3"}, "none.toml: expected a file");
}

// What stands in the way of the last file takes back the ones before it.
TEST_F(Command, FailingMeasureLeavesWhatWasThere) {
  fs::create_directories(folder_ / "out/s-measures.json");
  write_file(folder_ / "out/s-measures.csv", "old");
  const Files before = files_in(folder_);
  EXPECT_EQ(command({"measure", "s.toml", "-o", "out", "--seeds", "2"}).status, 2);
  EXPECT_EQ(files_in(folder_), before);
}

// Two scenes, each with a pavement of the same name: the second is refused, and says why.
TEST_F(Command, FilesOfAnotherSceneAreNotReplaced) {
  for (const char* const target : {"povray", "textures"}) {
    const std::string textures = "[pavement.textures]\nsize_px = 256\n";
    write_file(folder_ / "monday.toml", "[[pavement]]\nname = \"plaza\"\nsize_mm = [2000, 1000]\n" + textures);
    write_file(folder_ / "tuesday.toml", "[[pavement]]\nname = \"plaza\"\nsize_mm = [1000, 2000]\n" + textures);
    const std::string folder = std::string("out-") + target;
    EXPECT_EQ(command({"export", "monday.toml", "-o", folder, "--target", target}).status, 0);
    const Files before = files_in(folder_ / folder);
    const Outcome refused = command({"export", "tuesday.toml", "-o", folder, "--target", target});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(refused.err.starts_with(folder + "/plaza")) << refused.err;
    EXPECT_NE(refused.err.find("got one of the export of the scene 'monday'"), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(files_in(folder_ / folder), before);
    // By another name it goes beside it, and the first scene may be written again.
    EXPECT_EQ(command({"export", "tuesday.toml", "-o", folder, "--target", target, "--set", "pavement[0].name=square"}).status,
              0);
    EXPECT_EQ(command({"export", "monday.toml", "-o", folder, "--target", target, "--seed", "9"}).status, 0);
  }
}

TEST_F(Command, FilesOfAnotherSeedDoNotStayBesideNewOnes) {
  EXPECT_EQ(command({"export", "s.toml", "-o", "out", "--target", "json", "--target", "svg"}).status, 0);
  // The same state of the scene, said in another way.
  write_file(folder_ / "same/s.toml", "# A remark.\n" + std::string(scene));
  EXPECT_EQ(command({"export", "same/s.toml", "-o", "out", "--target", "json", "--seed", "3"}).err, "");
  EXPECT_TRUE(fs::exists(folder_ / "out/s-path.svg"));
  const Outcome other = command({"export", "s.toml", "-o", "out", "--target", "json", "--seed", "4"});
  EXPECT_EQ(other.status, 0);
  EXPECT_EQ(other.out, "out/s.json\n");
  EXPECT_EQ(other.err,
            "shatterpave: out: removed files of another state of the scene 's': s-other.svg, s-path.svg, s-window.svg\n");
  EXPECT_EQ(files_in(folder_ / "out").size(), 2U);
}

TEST_F(Command, ShowsHelpAndVersion) {
  const Outcome help = command({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("export"), std::string::npos);
  EXPECT_EQ(command({"render", "--help"}).status, 0);
  EXPECT_TRUE(command({"--version"}).out.starts_with("shatterpave "));
}

// A program in place of POV-Ray, which fails as the test asks for.
class FailingRenderer : public Command {
 protected:
  Outcome render_with(const std::string& script) {
    fs::create_directories(folder_ / "bin");
    write_file(folder_ / "bin/povray", "#!/bin/sh\n" + script);
    fs::permissions(folder_ / "bin/povray", fs::perms::owner_all);
    const char* path = std::getenv("PATH");
    return command({"render", "s.toml", "-o", "out"},
                   {"PATH=" + (folder_ / "bin").string() + ":" + (path != nullptr ? path : "")});
  }
};

TEST_F(FailingRenderer, EndsWithThreeAndItsOwnMessage) {
  const Outcome parse = render_with(
      "echo '==== [Parsing...] ====' >&2; echo 'Parsing 1024K tokens' >&2;"
      "echo \"File 'still.pov' line 3: Parse Error: No.\" >&2; exit 1\n");
  EXPECT_EQ(parse.status, 3);
  EXPECT_EQ(parse.err, "POV-Ray failed with status 1:\nFile 'still.pov' line 3: Parse Error: No.\n");
  const Outcome crash = render_with("kill -SEGV $$\n");
  EXPECT_EQ(crash.status, 3);
  EXPECT_TRUE(crash.err.starts_with("POV-Ray was ended by signal 11")) << crash.err;
  const Outcome nothing = render_with("exit 0\n");
  EXPECT_EQ(nothing.status, 3);
  EXPECT_TRUE(nothing.err.starts_with("POV-Ray left no picture")) << nothing.err;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Command, MissingRendererEndsWithThree) {
  const Outcome result = command({"render", "s.toml", "-o", "out"}, {"PATH=" + folder_.string()});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.err, "POV-Ray was not found: expected the program povray (Debian package povray) in PATH\n");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

// Ctrl-C while the renderer is at work: it is ended, and nothing is left. It does not listen, and is a script that has started
// another program.
TEST_F(FailingRenderer, InterruptEndsTheRendererAndLeavesNothing) {
  fs::create_directories(folder_ / "bin");
  const fs::path started = folder_ / "started";
  const std::string script =
      "#!/bin/sh\ntrap '' INT TERM HUP\nsleep 60 &\necho $! > " + started.string() + "\nwhile :; do wait; done\n";
  write_file(folder_ / "bin/povray", script);
  fs::permissions(folder_ / "bin/povray", fs::perms::owner_all);
  const std::string command = support::command();
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + std::getenv("PATH")).c_str(), 1);
    if (::chdir(folder_.c_str()) == 0) ::execl(command.c_str(), "shatterpave", "render", "s.toml", "-o", "out", nullptr);
    ::_exit(99);
  }
  for (int i = 0; i < 600 && text_of(started).find('\n') == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const pid_t renderer = std::atoi(text_of(started).c_str());
  ASSERT_GT(renderer, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out"));
  ::kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
  bool runs = true;  // as an orphan it stays for a moment after its end
  for (int i = 0; i < 100 && runs; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::string state = text_of("/proc/" + std::to_string(renderer) + "/stat");
    runs = !state.empty() && state.find(") Z") == std::string::npos;
  }
  EXPECT_FALSE(runs) << "the renderer still runs";
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace shatterpave::pipeline
