#include "pipeline/frame_folder.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>

#include "core/error.h"
#include "core/sha256.h"
#include "pipeline/frame_sidecar.h"
#include "pipeline/publish.h"
#include "pipeline/write.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view state_file = ".state";
constexpr std::string_view shared_prefix = "shared-";
constexpr std::string_view sums_file = "SHA256SUMS";  // as sha256sum(1) writes and checks it

// Of one name whatever bytes the scene's has, and never too long.
fs::path shot_folder(const fs::path& output, const std::string& scene) {
  return output / fmt::format("{}{}", shot_folder_prefix, sha256(scene).substr(0, 16));
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

std::string sums_of(const std::vector<exporting::OutputFile>& files) {
  std::string text;
  for (const exporting::OutputFile& file : files) text += fmt::format("{}  {}\n", sha256(file.content), file.name);
  return text;
}

// Whether all files are there as their sums say: a host that lost its power may have left some of them empty.
bool is_whole(const fs::path& folder) {
  constexpr std::size_t digits = 64;
  std::istringstream sums(content_of(folder / sums_file));
  bool any = false;
  for (std::string line; std::getline(sums, line); any = true) {
    if (line.size() < digits + 3) return false;
    const fs::path file = folder / line.substr(digits + 2);
    std::error_code error;
    if (!fs::is_regular_file(file, error) || sum_of(file) != line.substr(0, digits)) return false;
  }
  return any;
}

void admit(const FolderLock& lock, const fs::path& own, const FrameFolder::Shot& shot, const fs::path& output) {
  for (const fs::path& other : living_workplaces(lock, own)) {
    if (content_of(other / state_file) == shot.state) continue;
    throw InputError(
        Place{output.string(), 0, 0, ""},
        fmt::format(
            "expected no other run that writes frames of the scene '{}', or one with the same settings, got one with others "
            "(wait for its end, or write into another folder)",
            shot.scene));
  }
  write_file(own / state_file, shot.state);
}

}  // namespace

FrameFolder::FrameFolder(const fs::path& output, const Shot& shot, const Cancelled& cancelled)
    : output_(output),
      shot_(shot),
      workplace_(
          std::make_unique<Workplace>(shot_folder(output, shot.scene), cancelled,
                                      [&](const FolderLock& lock, const fs::path& own) { admit(lock, own, shot, output); })) {}

FrameFolder::~FrameFolder() {
  try {
    end();
  } catch (...) {
    // What is left is cleared by the next run.
  }
}

std::string FrameFolder::shared(const std::string& key, const std::function<std::vector<exporting::OutputFile>()>& make) {
  const std::string name = fmt::format("{}{}", shared_prefix, key);
  const fs::path folder = workplace_->output() / name;
  if (whole_ == key) return "../" + name;
  if (is_whole(folder)) {
    whole_ = key;
    return "../" + name;
  }
  const std::vector<exporting::OutputFile> files = make();
  const fs::path made = workplace_->folder() / name;
  fs::create_directory(made);
  for (const exporting::OutputFile& file : files) write_file(made / file.name, file.content);
  write_file(made / sums_file, sums_of(files));
  const FolderLock lock(workplace_->output());
  clear_shared(lock, name);
  if (is_whole(folder)) {  // another run was quicker
    fs::remove_all(made);
  } else {
    if (fs::exists(folder)) fs::rename(folder, workplace_->folder() / (name + "-broken"));
    fs::rename(made, folder);
    has_made_shared_ = true;
  }
  whole_ = key;
  return "../" + name;
}

void FrameFolder::publish(const std::vector<StagedFile>& files, const Cancelled& cancelled) {
  publish_above(*workplace_, files, cancelled);
  has_published_ = true;
}

void FrameFolder::clear_shared(const FolderLock& lock, const std::string& but) const {
  if (!living_workplaces(lock, workplace_->folder()).empty()) return;
  std::vector<fs::path> gone;
  for (const fs::directory_entry& entry : fs::directory_iterator(lock.folder())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(shared_prefix) && name != but) gone.push_back(entry.path());
  }
  for (const fs::path& folder : gone) fs::remove_all(folder);
}

// From the end: a shot that is not complete mostly lacks its last frame.
bool FrameFolder::is_complete() const {
  for (int frame = shot_.range.last; frame >= shot_.range.first; --frame) {
    std::error_code error;
    if (!fs::exists(output_ / sidecar_name(shot_.scene, frame), error)) return false;
  }
  return true;
}

void FrameFolder::end() {
  const fs::path folder = workplace_->output();
  {
    const FolderLock lock(folder);
    if ((has_made_shared_ && !has_published_) || is_complete()) clear_shared(lock, "");
  }
  workplace_.reset();
  // Only if it is empty. Another run may look into it at this moment, and leave it.
  constexpr int attempts = 5;
  for (int i = 0; i < attempts; ++i) {
    std::error_code error;
    fs::remove(folder, error);
    if (error != std::errc::directory_not_empty || !fs::is_empty(folder, error)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace shatterpave::pipeline
