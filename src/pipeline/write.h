// Files into a folder: all of them, or none.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "export/model.h"
#include "pipeline/publish.h"

namespace shatterpave::pipeline {

// Writes one file whole. Throws std::filesystem::filesystem_error, and Interrupted where a CancelScope says so.
void write_file(const std::filesystem::path& file, std::string_view content);

// SHA-256 of the content of a file. Throws std::filesystem::filesystem_error.
std::string sum_of(const std::filesystem::path& file);

// Each set of files, which takes long, says that it is being written, if `progress` is there.
void report_sets(exporting::Outputs& outputs, const Progress& progress);

// Writes all files, in order, then the sets of large files, into `output`, as files of the edition. On any exception, also
// Interrupted, the folder is as it was.
Published written_outputs(const exporting::Outputs& outputs, const Edition& edition, const std::filesystem::path& output,
                          const Cancelled& cancelled = {});
// The same without sets.
Published written(const std::vector<exporting::OutputFile>& files, const Edition& edition, const std::filesystem::path& output,
                  const Cancelled& cancelled = {});

}  // namespace shatterpave::pipeline
