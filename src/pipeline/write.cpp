// Everything is first written to a temporary folder inside the output folder, so on the same file system, and then published.
#include "pipeline/write.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sha256.h"

namespace shatterpave::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t bytes_at_once = std::size_t{4} << 20;  // between two questions whether to stop

[[noreturn]] void throw_last_error(const char* what, const fs::path& file) {
  throw fs::filesystem_error(what, file, std::error_code(errno, std::generic_category()));
}

// A file that is open, and closed in the end.
class OpenFile {
 public:
  OpenFile(const fs::path& file, int flags, const char* what) : descriptor_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) throw_last_error(what, file);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }
  // Over a network, only this tells whether all was written.
  bool closed() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

// The files as they will be staged, without the sums of those that are not made yet.
std::vector<StagedFile> expected_files(const exporting::Outputs& outputs) {
  std::vector<StagedFile> files;
  for (const exporting::OutputFile& file : outputs.files) files.push_back({file.name});
  parallel_for(files.size(), [&](std::size_t i) { files[i].sum = sha256(outputs.files[i].content); });
  for (const exporting::FileSet& set : outputs.sets) {
    for (const std::string& name : set.names) files.push_back({name});
  }
  std::set<std::string> names;
  for (const StagedFile& file : files) {
    ENSURE(file.name == fs::path(file.name).filename() && file.name.find('\n') == std::string::npos);
    if (names.insert(file.name).second) continue;
    throw InputError(fmt::format(
        "names: expected other ones of the scene and of what is in it, got such that two files are called '{}'", file.name));
  }
  return files;
}

}  // namespace

void write_file(const fs::path& file, std::string_view content) {
  OpenFile open(file, O_WRONLY | O_CREAT | O_TRUNC, "cannot write");
  std::size_t done = 0;
  while (done < content.size()) {
    stop_if_cancelled();
    const ssize_t count = ::write(open.descriptor(), content.data() + done, std::min(content.size() - done, bytes_at_once));
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      throw_last_error("cannot write", file);
    }
  }
  if (!open.closed()) throw_last_error("cannot write", file);
}

std::string sum_of(const fs::path& file) {
  const OpenFile open(file, O_RDONLY, "cannot read");
  Sha256 hash;
  std::vector<char> buffer(bytes_at_once);
  for (;;) {
    stop_if_cancelled();
    const ssize_t count = ::read(open.descriptor(), buffer.data(), buffer.size());
    if (count == 0) return hash.sum();
    if (count > 0) hash.add({buffer.data(), static_cast<std::size_t>(count)});
    if (count < 0 && errno != EINTR) throw_last_error("cannot read", file);
  }
}

void report_sets(exporting::Outputs& outputs, const Progress& progress) {
  if (!progress) return;
  const double count = static_cast<double>(outputs.sets.size());
  for (std::size_t i = 0; i < outputs.sets.size(); ++i) {
    exporting::FileSet& set = outputs.sets[i];
    const std::string what = fmt::format("writing {} …", set.names.empty() ? std::string() : set.names.front());
    set.write = [write = std::move(set.write), what, done = static_cast<double>(i) / count,
                 progress](const std::string& folder) {
      progress(what, done);
      write(folder);
    };
  }
}

Published written_outputs(const exporting::Outputs& outputs, const Edition& edition, const fs::path& output,
                          const Cancelled& cancelled) {
  require_output_folder(output);
  std::vector<StagedFile> files = expected_files(outputs);
  Workplace workplace(output, cancelled);
  const fs::path& folder = workplace.folder();
  require_publishable(files, edition, workplace, output, cancelled);
  {
    const CancelScope scope([&] {
      workplace.touch();
      return cancelled && cancelled();
    });
    for (const exporting::OutputFile& file : outputs.files) write_file(folder / file.name, file.content);
    for (const exporting::FileSet& set : outputs.sets) set.write(folder.string());
    parallel_for(files.size(), [&](std::size_t i) {
      if (files[i].sum.empty()) files[i].sum = sum_of(folder / files[i].name);
    });
    stop_if_cancelled();
  }
  return published(workplace, files, edition, output, cancelled);
}

Published written(const std::vector<exporting::OutputFile>& files, const Edition& edition, const fs::path& output,
                  const Cancelled& cancelled) {
  return written_outputs(exporting::Outputs{files, {}}, edition, output, cancelled);
}

}  // namespace shatterpave::pipeline
