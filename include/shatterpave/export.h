/// \file
/// From a model to files.
///
///     using namespace shatterpave;
///     for (const File& file : export_files(model, "svg")) upload(file.name, file.content);
///     write_targets(model, {"povray", "json"}, "out");             // into a folder, all of them or none
///     write_files(model, {{"stones.csv", table(model)}}, "out", "my tables");   // files of one's own beside them
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <shatterpave/generate.h>
#include <shatterpave/model.h>

namespace shatterpave {

/// A kind of files that can be made of a model.
struct Target {
  std::string_view name;      ///< As the command's `--target` takes it.
  std::string_view sentence;  ///< What is written, for help.
};

/// All targets, in the order in which help lists them.
const std::vector<Target>& targets();

/// A file in memory.
struct File {
  std::string name;     ///< Without folders.
  std::string content;  ///< Bytes.

  /// Byte by byte.
  bool operator==(const File&) const = default;
};

/// The files of a target, byte for byte those that the command writes. The same model and version give the same bytes. Texture
/// sets may be gigabytes: write_targets never holds more than a part of them.
///
/// Throws InputError where there is no such target, or it has nothing to write of this model (shards that are not asked for),
/// and Interrupted.
std::vector<File> export_files(const Model& model, std::string_view target, const WorkOptions& options = {});

/// What was written into a folder.
struct Written {
  std::vector<std::filesystem::path> files;  ///< What was asked for, in order.
  std::vector<std::string> removed;          ///< Names of files of an earlier state of the scene that are gone.
  std::vector<std::string> left;             ///< And of those that somebody has changed since, and that were left.
};

/// Writes the files of targets into a folder, which is made if it is missing: all of them, or none. Of several runs into one
/// folder, also of the command and on other machines, it holds the files of one; docs/output.md tells the rest. On any
/// exception the folder is as it was.
///
/// Throws InputError as export_files does, and where a file may not be written: a folder is in its way, or a file of another
/// scene; std::filesystem::filesystem_error where the folder cannot be written to; and Interrupted.
Written write_targets(const Model& model, const std::vector<std::string>& targets, const std::filesystem::path& folder,
                      const WorkOptions& options = {});

/// Writes files of one's own in the same way, as what `maker` made of the scene: a word that tells them from those of others,
/// and from "export", "picture" and "measures", which are the command's. When the same maker writes for a changed scene, its
/// files of the earlier state that are not written again are taken away.
///
/// Throws as write_targets does, also where two files have one name, a name has a folder in it, or `maker` is empty or one of
/// the command's.
Written write_files(const Model& model, const std::vector<File>& files, const std::filesystem::path& folder,
                    std::string_view maker, const WorkOptions& options = {});

}  // namespace shatterpave
