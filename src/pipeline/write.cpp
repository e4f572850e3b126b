// Everything is first written to a temporary folder inside the output folder, so on the same file system. Renaming within one
// is atomic for each file; for all of them together, the files that are to be replaced are kept as hard links until the last
// one is in place.
#include "pipeline/write.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "core/error.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throw_last_error(const char* what, const fs::path& file) {
  throw fs::filesystem_error(what, file, std::error_code(errno, std::generic_category()));
}

// The missing folders on the way to `folder`, the outermost first.
std::vector<fs::path> missing_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path p = folder; !p.empty() && !fs::exists(p); p = p.parent_path()) {
    missing.push_back(p);
    if (p == p.parent_path()) break;
  }
  std::ranges::reverse(missing);
  return missing;
}

fs::path kept_copy(const Workplace& workplace, const std::string& name) { return workplace.folder() / (".old-" + name); }

// Puts the old file aside, if there is one.
void keep_old(const Workplace& workplace, const std::string& name, const fs::path& target) {
  if (!fs::exists(fs::symlink_status(target))) return;
  std::error_code error;
  fs::create_hard_link(target, kept_copy(workplace, name), error);
  // File systems without hard links: for a moment, there is no file of that name.
  if (error) fs::rename(target, kept_copy(workplace, name));
}

void put_back(const Workplace& workplace, const std::string& name, const fs::path& target) {
  std::error_code ignored;  // nothing more can be done about it, and the first error is the one to tell
  if (fs::exists(fs::symlink_status(kept_copy(workplace, name), ignored))) {
    fs::rename(kept_copy(workplace, name), target, ignored);
  } else {
    fs::remove(target, ignored);
  }
}

}  // namespace

void require_output_folder(const fs::path& folder) {
  if (folder.empty()) throw InputError("expected an output folder, got an empty name");
  for (fs::path p = folder; !p.empty(); p = p.parent_path()) {
    std::error_code error;
    const fs::file_status status = fs::status(p, error);
    if (fs::exists(status)) {
      if (fs::is_directory(status)) return;
      throw InputError(Place{folder.string(), 0, 0, ""}, fmt::format("expected an output folder, got a file: {}", p.string()));
    }
    if (fs::is_symlink(fs::symlink_status(p, error))) {
      throw InputError(Place{folder.string(), 0, 0, ""},
                       fmt::format("expected an output folder, got a link to nothing: {}", p.string()));
    }
    if (p == p.parent_path()) return;
  }
}

Workplace::Workplace(const fs::path& output) {
  const fs::path folder = fs::absolute(output).lexically_normal();
  const std::vector<fs::path> missing = missing_folders(folder);
  try {
    for (const fs::path& p : missing) {
      if (fs::create_directory(p)) made_.push_back(p);
    }
    std::string pattern = (folder / ".shatterpave-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw_last_error("cannot write to the output folder", output);
    temporary_ = pattern;
  } catch (...) {
    std::error_code ignored;
    for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
    throw;
  }
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
  // Only if empty: someone else may have put files there.
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
}

void write_file(const fs::path& file, std::string_view content) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw_last_error("cannot write", file);
  std::size_t done = 0;
  int failure = 0;
  while (done < content.size() && failure == 0) {
    const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      failure = errno;
    }
  }
  if (::close(descriptor) != 0 && failure == 0) failure = errno;
  if (failure == 0) return;
  errno = failure;
  throw_last_error("cannot write", file);
}

std::vector<fs::path> published(Workplace& workplace, const std::vector<std::string>& names, const fs::path& output) {
  std::vector<fs::path> paths;
  try {
    for (const std::string& name : names) {
      const fs::path target = output / name;
      if (fs::is_directory(fs::symlink_status(target))) {
        throw InputError(Place{target.string(), 0, 0, ""}, "expected a file to write, got a folder");
      }
      keep_old(workplace, name, target);
      paths.push_back(target);
      fs::rename(workplace.folder() / name, target);
    }
  } catch (...) {
    for (std::size_t i = paths.size(); i-- > 0;) put_back(workplace, names[i], paths[i]);
    throw;
  }
  workplace.keep();
  return paths;
}

std::vector<fs::path> written_outputs(const exporting::Outputs& outputs, const fs::path& output, const Cancelled& cancelled) {
  require_output_folder(output);
  Workplace workplace(output);
  std::vector<std::string> names;
  const auto take = [&](const std::string& name) {
    ENSURE(name == fs::path(name).filename());
    if (std::ranges::find(names, name) != names.end()) {
      throw InputError(fmt::format(
          "names: expected other ones of the scene and of what is in it, got such that two files are called '{}'", name));
    }
    names.push_back(name);
  };
  for (const exporting::OutputFile& file : outputs.files) {
    take(file.name);
    write_file(workplace.folder() / file.name, file.content);
    if (cancelled && cancelled()) throw Interrupted();
  }
  for (const exporting::FileSet& set : outputs.sets) {
    std::ranges::for_each(set.names, take);
    set.write(workplace.folder().string());
    if (cancelled && cancelled()) throw Interrupted();
  }
  return published(workplace, names, output);
}

std::vector<fs::path> written(const std::vector<exporting::OutputFile>& files, const fs::path& output,
                              const Cancelled& cancelled) {
  return written_outputs(exporting::Outputs{files, {}}, output, cancelled);
}

}  // namespace shatterpave::pipeline
