// What killed runs leave, and locks. A run that is killed is a copy of this program that ends without a word.
#include "pipeline/publish.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/sha256.h"
#include "pipeline/write.h"
#include "support/temporary_folder.h"

namespace shatterpave::pipeline {
namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

const Edition first{"s", "export", "1"};
const Edition second{"s", "export", "2"};

class Publishing : public support::FolderTest {
 protected:
  Files content() const {
    Files files;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      std::ostringstream text;
      if (!entry.is_directory()) text << stream.rdbuf();
      files[entry.path().filename().string()] = entry.is_directory() ? "folder" : text.str();
    }
    return files;
  }

  // Runs `work` in another process, which ends as a killed one does: nothing is tidied up.
  static void in_killed_run(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
  }

  static std::vector<StagedFile> staged(const Workplace& workplace, const Files& files) {
    std::vector<StagedFile> result;
    for (const auto& [name, text] : files) {
      write_file(workplace.folder() / name, text);
      result.push_back({name, sha256(text)});
    }
    return result;
  }
};

TEST_F(Publishing, WorkplaceOfAKilledRunIsCleared) {
  in_killed_run([&] {
    Workplace workplace(folder_);
    write_file(workplace.folder() / "a.txt", "half");
    ::_exit(0);
  });
  fs::create_directory(folder_ / ".shatterpave-abcdef");  // as earlier versions have left them
  write_file(folder_ / ".shatterpave-abcdef/b.txt", "half");
  fs::create_directory(folder_ / ".shatterpave-mine");  // not one of ours
  EXPECT_EQ(content().size(), 3U);
  written({{"c.txt", "1"}}, first, folder_);
  EXPECT_EQ(content().size(), 3U);
  EXPECT_TRUE(fs::exists(folder_ / ".shatterpave-mine"));
}

TEST_F(Publishing, WorkplaceOfALivingRunStays) {
  Workplace living(folder_);
  write_file(living.folder() / "a.txt", "1");
  in_killed_run([&] { written({{"b.txt", "1"}}, second, folder_); });
  EXPECT_TRUE(fs::exists(living.folder() / "a.txt"));
  published(living, staged(living, {{"a.txt", "1"}}), first, folder_);
  EXPECT_EQ(content().at("a.txt"), "1");
}

// Killed after each step of a publication: the next run, of another scene, puts back all that was there before.
TEST_F(Publishing, HalfOfAPublicationIsTakenBack) {
  written({{"s.json", "1"}, {"s.svg", "1"}, {"s.obj", "1"}}, first, folder_);
  const Files before = content();
  constexpr int steps = 7;
  int mixed = 0;
  for (int step = 0; step <= steps; ++step) {
    in_killed_run([&] {
      Workplace workplace(folder_);
      const fs::path& place = workplace.folder();
      staged(workplace, {{"s.json", "2"}, {"s.new", "2"}});
      fs::create_directory(place / ".kept");
      // By hand what `published` does, up to that step.
      write_file(place / ".journal", "kept s.json\nkept s.svg\nkept s.obj\nfresh s.new\n\n" + before.at(".scenes.shatterpave"));
      if (step > 0) fs::create_hard_link(folder_ / "s.json", place / ".kept/s.json");
      if (step > 1) fs::create_hard_link(folder_ / "s.svg", place / ".kept/s.svg");
      if (step > 2) fs::rename(folder_ / "s.obj", place / ".kept/s.obj");  // as where there are no hard links
      if (step > 3) fs::rename(place / "s.json", folder_ / "s.json");
      if (step > 4) fs::rename(place / "s.new", folder_ / "s.new");
      if (step > 5) fs::remove(folder_ / "s.svg");
      if (step > 6) write_file(folder_ / notes_file, "half of a no");
      ::_exit(0);
    });
    Files left = content();
    std::erase_if(left, [](const auto& file) { return file.second == "folder"; });
    if (left != before) ++mixed;
    {
      const FolderLock lock(folder_);
      clear_killed(lock);
    }
    ASSERT_EQ(content(), before) << "killed after step " << step;
  }
  EXPECT_EQ(mixed, 5) << "too few of the steps change the folder for this to tell anything";
}

TEST_F(Publishing, FailureWhileFilesMoveTakesThemBack) {
  written({{"s.json", "1"}, {"s.svg", "1"}}, first, folder_);
  const Files before = content();
  Workplace workplace(folder_);
  std::vector<StagedFile> files = staged(workplace, {{"s.json", "2"}, {"s.new", "2"}});
  files.push_back({"s.never", sha256("")});  // is not there, so it cannot be moved
  EXPECT_THROW(published(workplace, files, second, folder_), fs::filesystem_error);
  Files after = content();
  std::erase_if(after, [](const auto& file) { return file.second == "folder"; });
  EXPECT_EQ(after, before);
}

TEST_F(Publishing, FolderThatWentAwayIsAnError) {
  Workplace workplace(folder_ / "out");
  const std::vector<StagedFile> files = staged(workplace, {{"s.json", "1"}});
  fs::remove_all(folder_ / "out");
  EXPECT_THROW(published(workplace, files, first, folder_ / "out"), fs::filesystem_error);
  EXPECT_EQ(content(), Files());
}

TEST_F(Publishing, NamesNeedNotBeUtf8) {
  const std::string name =
      "stra\xDF"
      "e 50%.json";
  written({{name, "1"}, {"s.svg", "1"}},
          {"stra\xDF"
           "e",
           "export", "1"},
          folder_);
  EXPECT_EQ(written({{"s.svg", "2"}},
                    {"stra\xDF"
                     "e",
                     "export", "2"},
                    folder_)
                .removed,
            std::vector<std::string>{name});
  EXPECT_THROW(written({{"s.svg", "3"}}, first, folder_), InputError);
}

TEST(FolderNotes, AreReadAsTheyAreWritten) {
  const FolderNotes notes = {{{"a \"b\" %", "export", "12"}, {{"a.json", "34"}, {"ä.svg", "56"}}},
                             {{"a", "picture", "78"}, {}}};
  EXPECT_EQ(notes_of_text(text_of_notes(notes), "notes"), notes);
  EXPECT_EQ(text_of_notes({}), "");
  for (
      const char* const text :
      {"x", "[]", "{}", R"({"format": "shatterpave-folder", "version": 2, "sets": []})",
       R"({"format": "shatterpave-folder", "version": 1, "sets": [{}]})",
       R"({"format": "shatterpave-folder", "version": 1, "sets": [{"scene": "%z", "set": "", "fingerprint": "", "files": {}}]})"}) {
    EXPECT_THROW(notes_of_text(text, "notes"), InputError) << text;
  }
}

// --- Locks, by the kernel and by age ---

class Locks : public Publishing, public testing::WithParamInterface<Locking> {};
INSTANTIATE_TEST_SUITE_P(Both, Locks, testing::Values(Locking::kernel, Locking::age));

TEST_P(Locks, OneAtATime) {
  std::optional<FolderLock> lock(std::in_place, folder_, Cancelled(), GetParam());
  int asked = 0;
  EXPECT_THROW(FolderLock(
                   folder_, [&] { return ++asked > 5; }, GetParam()),
               Interrupted);
  EXPECT_EQ(asked, 6);
  lock.reset();
  EXPECT_EQ(content(), Files()) << "a lock leaves nothing";
  EXPECT_NO_THROW(FolderLock(
      folder_, [] { return true; }, GetParam()));
}

// Runs that add one to a number in the notes, each many times.
TEST_P(Locks, NoneIsInTheMiddleOfAnother) {
  constexpr int runs = 4;
  constexpr int turns = 50;
  std::vector<pid_t> children;
  for (int run = 0; run < runs; ++run) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    for (int turn = 0; turn < turns; ++turn) {
      const FolderLock lock(folder_, {}, GetParam());
      const std::string before = lock.notes();
      lock.write_notes(std::to_string((before.empty() ? 0 : std::stoi(before)) + 1));
    }
    ::_exit(0);
  }
  for (const pid_t child : children) ::waitpid(child, nullptr, 0);
  EXPECT_EQ(FolderLock(folder_, {}, GetParam()).notes(), std::to_string(runs * turns));
}

// Where every lock finds the file of notes missing, makes it, and takes it away again.
TEST_P(Locks, NoneIsInTheMiddleOfAnotherWithoutNotes) {
  constexpr int runs = 4;
  constexpr int turns = 50;
  std::vector<pid_t> children;
  for (int run = 0; run < runs; ++run) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    int together = 0;
    for (int turn = 0; turn < turns; ++turn) {
      const FolderLock lock(folder_, {}, GetParam());
      if (!fs::create_directory(folder_ / "inside")) ++together;
      fs::remove(folder_ / "inside");
    }
    ::_exit(together);
  }
  int together = 0;
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    together += status;
  }
  EXPECT_EQ(together, 0);
  EXPECT_EQ(content(), Files());
}

TEST_P(Locks, KilledRunLeavesNone) {
  in_killed_run([&] {
    const FolderLock lock(folder_, {}, GetParam());
    ::_exit(0);
  });
  if (GetParam() == Locking::age) {
    const auto old = fs::file_time_type::clock::now() - stale_lock - std::chrono::seconds(5);
    fs::last_write_time(folder_ / ".scenes.shatterpave-held", old);
  }
  int asked = 0;
  EXPECT_NO_THROW(FolderLock(
      folder_, [&] { return ++asked > 5; }, GetParam()));
  EXPECT_EQ(content(), Files());
}

TEST_P(Locks, MarkTellsWhoLives) {
  const FolderLock lock(folder_, {}, GetParam());
  EXPECT_FALSE(lock.is_alive(folder_ / "none"));
  {
    LifeMark mark(folder_ / "mark", GetParam());
    EXPECT_TRUE(lock.is_alive(folder_ / "mark"));
  }
  if (GetParam() == Locking::age) {
    EXPECT_TRUE(lock.is_alive(folder_ / "mark")) << "nobody can know";
    fs::last_write_time(folder_ / "mark", fs::file_time_type::clock::now() - stale_mark - std::chrono::seconds(5));
  }
  EXPECT_FALSE(lock.is_alive(folder_ / "mark"));
}

}  // namespace
}  // namespace shatterpave::pipeline
