// Files into a folder: all of them, or none.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vector>

#include "export/model.h"

namespace shatterpave::pipeline {

// Asked from time to time whether work shall stop; may be empty. Once it says yes it must go on saying so.
using Cancelled = std::function<bool()>;

// Thrown where work stopped because it was asked to. Whatever it had written is gone.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// Throws InputError if `folder` cannot be an output folder: it, or something on the way to it, is a file.
void require_output_folder(const std::filesystem::path& folder);

// A folder for temporary files inside an output folder, which is made if it is missing. Both are taken away again at the
// end: the temporary one always, the output folder if it was made here and `keep` was not called.
class Workplace {
 public:
  explicit Workplace(const std::filesystem::path& output);
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const std::filesystem::path& folder() const { return temporary_; }
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;  // folders that did not exist, the outermost first
  std::filesystem::path temporary_;
};

// Writes one file whole. Throws std::filesystem::filesystem_error.
void write_file(const std::filesystem::path& file, std::string_view content);

// Moves files of the workplace to the output folder, in the given order, over what is there; if one cannot be moved, puts back
// what was there. Returns their new paths. The workplace must be on the same file system.
std::vector<std::filesystem::path> published(Workplace& workplace, const std::vector<std::string>& names,
                                             const std::filesystem::path& output);

// Writes all files, in order, into `output`. Returns their paths. On any exception, also Interrupted, the folder is as it was.
std::vector<std::filesystem::path> written(const std::vector<exporting::OutputFile>& files, const std::filesystem::path& output,
                                           const Cancelled& cancelled = {});
// The same with sets of large files, which follow.
std::vector<std::filesystem::path> written_outputs(const exporting::Outputs& outputs, const std::filesystem::path& output,
                                                   const Cancelled& cancelled = {});

}  // namespace shatterpave::pipeline
