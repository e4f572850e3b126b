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
#include <sstream>
#include <string>
#include <thread>

#include "pipeline/subprocess.h"
#include "pipeline/write.h"
#include "support/places.h"

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

class Command : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "command-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    root = pattern;
    write_file(root / "s.toml", scene);
    fs::create_directory(root / "same");
  }
  void TearDown() override { fs::remove_all(root); }

  // The shell only takes the two streams apart.
  Outcome command(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) const {
    std::vector<std::string> all = {"sh", "-c", "exec \"$0\" \"$@\" >stdout.txt 2>stderr.txt", support::command()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ending ending = pipeline::run({all, root, environment, {}}, [](std::string_view) {}, {});
    EXPECT_EQ(ending.signal, 0);
    Outcome result{ending.status, text_of(root / "stdout.txt"), text_of(root / "stderr.txt")};
    fs::remove(root / "stdout.txt");
    fs::remove(root / "stderr.txt");
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

  fs::path root;
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
    return files_in(root / folder);
  };
  const Files first = exported("one", "1", {});
  EXPECT_GE(first.size(), 13U);
  EXPECT_TRUE(first.contains("path_BaseColor.png"));
  EXPECT_EQ(exported("two", "2", {"LC_ALL=de_DE.UTF-8"}), first);
  EXPECT_EQ(exported("seven", "7", {"LC_ALL=tr_TR.UTF-8", without_fma}), first);
  // A twin that must differ, or equality means nothing.
  const Outcome other = command({"export", "s.toml", "-o", "other", "--target", "json", "--seed", "4"});
  EXPECT_EQ(other.status, 0);
  EXPECT_NE(text_of(root / "other/s.json"), first.at("s.json"));
}

// The C library's functions really change by that switch, on a processor that has what it leaves out; on another they do not.
TEST_F(Command, TunablesChangeTheCLibrary) {
  const bool has_fma = text_of("/proc/cpuinfo").find(" fma ") != std::string::npos;
  const auto results = [&](const std::vector<std::string>& environment) {
    std::string text;
    const std::string script =
        "import math; print(hash(tuple(math.pow(1 + i / 999, 1.37) + math.sin(i) for i in range(50000))))";
    pipeline::run({{"python3", "-c", script}, root, environment, {}}, [&](std::string_view more) { text += more; }, {});
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
  EXPECT_EQ(check.out + check.err, "");
}

TEST_F(Command, WrongInputAndUsageEndWithTwoAndWriteNothing) {
  write_file(root / "a_file", "x");
  write_file(root / "path_textures.toml", scene);
  write_file(root / "bad.toml", "[[pane]]\nname = \"w\"\nsize_mm = [nan, 9]\n");
  const Files before = files_in(root);
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2) << message;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, message + "\n");
    EXPECT_EQ(files_in(root), before);
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
  expect({"check", "s.toml", "--set", "pavement.path.stone_mm=[50, 100]", "--set", "pavement.path.bond=herringbone"},
         "pavement 'path': stone_mm: expected stones at least as long as wide for this bond, got [50, 100]");
  expect({"export", "s.toml", "-o", "out", "--target", "foo"},
         "shatterpave: --target: expected json or obj or povray or svg or textures, got foo (see shatterpave --help)");
  expect({"export", "s.toml", "-o", "out", "--seed", "-1"},
         "--seed -1: seed: expected a whole number from 0 to 9223372036854775807, got -1");
  expect({"check", "s.toml", "--set", "pane[0].thickness_mm=nan"},
         "--set pane[0].thickness_mm=nan: pane[0].thickness_mm: expected a number from 0.1 to 1000, got nan");
  expect({"check", "s.toml", "--set", "seed"}, "--set seed: expected KEY=VALUE, got no '=' after a key");
  expect({"render", "s.toml", "-o", "out", "--size", "640"},
         "shatterpave: --size: expected WxH with 1 to 16384 pixels each, got \"640\"");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"trace", "s.toml"},
                                             {"export", "s.toml"},
                                             {"check", "s.toml", "--colour"},
                                             {"export", "s.toml", "-o", "out", "--target", "blender"}}) {
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(result.err.starts_with("shatterpave: ")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(files_in(root), before);
  }
}

// An empty file is an import that finds nothing, hours later.
TEST_F(Command, RefusesAnObjWithoutContent) {
  const std::string none =
      "target obj: expected a pane with a table [pane.shards], whose pieces are what it writes, got none with it\n";
  write_file(root / "gone.toml", R"(seed = 3
[[pane]]
name = "window"
size_mm = [100, 80]
impact = [{at_mm = [50, 40], radial_count = 9}]
[pane.shards]
splinter_mm2 = 100000
)");
  const Files before = files_in(root);
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, message);
    EXPECT_EQ(files_in(root), before);
  };
  expect({"export", "s.toml", "-o", "out", "--target", "json", "--target", "obj"}, none);
  expect({"check", "s.toml", "--target", "obj"}, none);
  expect(
      {"export", "gone.toml", "-o", "out", "--target", "obj"},
      "target obj: expected a shard that stands or has fallen, got none: every piece of window is gone, or is a splinter (see "
      "missing, missing_mm, held, fallen and splinter_mm2 of [pane.shards])\n");
  EXPECT_EQ(command({"check", "s.toml"}).status, 0);
  EXPECT_EQ(command({"check", "gone.toml", "--target", "obj"}).status, 0);
}

TEST_F(Command, MeasuresTheSameBytesWithAnyThreads) {
  const auto measured = [&](const std::string& folder, const std::string& threads, const std::string& seed) {
    const Outcome result = command(
        {"measure", "s.toml", "-o", folder, "--seeds", "3", "--radials", "24..90", "--threads", threads, "--seed", seed});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(result.out.starts_with(folder + "/s-measures.csv\n" + folder + "/s-measures.json\n")) << result.out;
    // Without the plotting library there is no report, and one line that says so.
    EXPECT_EQ(result.err.empty(), result.out.ends_with("s-measures.html\n")) << result.err;
    return files_in(root / folder);
  };
  const Files first = measured("one", "1", "3");
  EXPECT_GE(first.size(), 2U);
  EXPECT_EQ(measured("two", "2", "3"), first);
  EXPECT_NE(measured("other", "2", "4"), first);
}

TEST_F(Command, WrongUsageOfMeasureEndsWithTwoAndWritesNothing) {
  write_file(root / "path.toml", "[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n");
  const Files before = files_in(root);
  const auto expect = [&](const std::vector<std::string>& options, const std::string& message) {
    std::vector<std::string> arguments = {"measure"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome result = command(arguments);
    EXPECT_EQ(result.status, 2) << message;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(files_in(root), before);
  };
  expect({"s.toml", "--seeds", "3"}, "shatterpave: -o is required");
  expect({"s.toml", "-o", "out", "--seeds", "0"}, "shatterpave: --seeds: ");
  expect({"s.toml", "-o", "out", "--seeds", "-3"}, "shatterpave: ");
  expect({"s.toml", "-o", "out", "--seeds", "many"}, "shatterpave: ");
  expect({"s.toml", "-o", "out", "--seeds", "100001"}, "shatterpave: --seeds: ");
  for (const char* radials : {"24", "24..", "..195", "0..5", "9..8", "24..10001", "24...195", "a..b"}) {
    expect({"s.toml", "-o", "out", "--seeds", "3", "--radials", radials},
           std::string("shatterpave: --radials: expected LOW..HIGH, whole numbers from 1 to 10000, got \"") + radials + "\"");
  }
  expect({"path.toml", "-o", "out", "--radials", "24..90"},
         "path.toml: expected one or more tables [[pane]] for --radials, got none");
  expect({"none.toml", "-o", "out", "--seeds", "3"}, "none.toml: expected a file");
}

// What stands in the way of the last file takes back the ones before it.
TEST_F(Command, FailingMeasureLeavesWhatWasThere) {
  fs::create_directories(root / "out/s-measures.json");
  write_file(root / "out/s-measures.csv", "old");
  const Files before = files_in(root);
  EXPECT_EQ(command({"measure", "s.toml", "-o", "out", "--seeds", "2"}).status, 2);
  EXPECT_EQ(files_in(root), before);
}

// Two scenes, each with a pavement of the same name: the second is refused, and says why.
TEST_F(Command, FilesOfAnotherSceneAreNotReplaced) {
  for (const char* const target : {"povray", "textures"}) {
    const std::string textures = "[pavement.textures]\nsize_px = 256\n";
    write_file(root / "monday.toml", "[[pavement]]\nname = \"plaza\"\nsize_mm = [2000, 1000]\n" + textures);
    write_file(root / "tuesday.toml", "[[pavement]]\nname = \"plaza\"\nsize_mm = [1000, 2000]\n" + textures);
    const std::string folder = std::string("out-") + target;
    EXPECT_EQ(command({"export", "monday.toml", "-o", folder, "--target", target}).status, 0);
    const Files before = files_in(root / folder);
    const Outcome refused = command({"export", "tuesday.toml", "-o", folder, "--target", target});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(refused.err.starts_with(folder + "/plaza")) << refused.err;
    EXPECT_NE(refused.err.find("got one of the export of the scene 'monday'"), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(files_in(root / folder), before);
    // By another name it goes beside it, and the first scene may be written again.
    EXPECT_EQ(command({"export", "tuesday.toml", "-o", folder, "--target", target, "--set", "pavement[0].name=square"}).status,
              0);
    EXPECT_EQ(command({"export", "monday.toml", "-o", folder, "--target", target, "--seed", "9"}).status, 0);
  }
}

TEST_F(Command, FilesOfAnotherSeedDoNotStayBesideNewOnes) {
  EXPECT_EQ(command({"export", "s.toml", "-o", "out", "--target", "json", "--target", "svg"}).status, 0);
  // The same state of the scene, said in another way.
  write_file(root / "same/s.toml", "# A remark.\n" + std::string(scene));
  EXPECT_EQ(command({"export", "same/s.toml", "-o", "out", "--target", "json", "--seed", "3"}).err, "");
  EXPECT_TRUE(fs::exists(root / "out/s-path.svg"));
  const Outcome other = command({"export", "s.toml", "-o", "out", "--target", "json", "--seed", "4"});
  EXPECT_EQ(other.status, 0);
  EXPECT_EQ(other.out, "out/s.json\n");
  EXPECT_EQ(other.err,
            "shatterpave: out: removed files of another state of the scene 's': s-other.svg, s-path.svg, s-window.svg\n");
  EXPECT_EQ(files_in(root / "out").size(), 2U);
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
    fs::create_directories(root / "bin");
    write_file(root / "bin/povray", "#!/bin/sh\n" + script);
    fs::permissions(root / "bin/povray", fs::perms::owner_all);
    const char* path = std::getenv("PATH");
    return command({"render", "s.toml", "-o", "out"},
                   {"PATH=" + (root / "bin").string() + ":" + (path != nullptr ? path : "")});
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
  EXPECT_FALSE(fs::exists(root / "out"));
}

TEST_F(Command, MissingRendererEndsWithThree) {
  const Outcome result = command({"render", "s.toml", "-o", "out"}, {"PATH=" + root.string()});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.err, "POV-Ray was not found: expected the program povray (Debian package povray) in PATH\n");
  EXPECT_FALSE(fs::exists(root / "out"));
}

// Ctrl-C while the renderer is at work: it is ended, and nothing is left. It does not listen, and is a script that has started
// another program.
TEST_F(FailingRenderer, InterruptEndsTheRendererAndLeavesNothing) {
  fs::create_directories(root / "bin");
  const fs::path started = root / "started";
  const std::string script =
      "#!/bin/sh\ntrap '' INT TERM HUP\nsleep 60 &\necho $! > " + started.string() + "\nwhile :; do wait; done\n";
  write_file(root / "bin/povray", script);
  fs::permissions(root / "bin/povray", fs::perms::owner_all);
  const std::string command = support::command();
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("PATH", ((root / "bin").string() + ":" + std::getenv("PATH")).c_str(), 1);
    if (::chdir(root.c_str()) == 0) ::execl(command.c_str(), "shatterpave", "render", "s.toml", "-o", "out", nullptr);
    ::_exit(99);
  }
  for (int i = 0; i < 600 && text_of(started).find('\n') == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const pid_t renderer = std::atoi(text_of(started).c_str());
  ASSERT_GT(renderer, 0);
  EXPECT_TRUE(fs::exists(root / "out"));
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
  EXPECT_FALSE(fs::exists(root / "out"));
}

}  // namespace
}  // namespace shatterpave::pipeline
