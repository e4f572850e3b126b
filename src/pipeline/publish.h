// Files of a workplace into its output folder: all of them, or none, whatever other runs do there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/cancel.h"
#include "pipeline/folder_notes.h"
#include "pipeline/workplace.h"

namespace shatterpave::pipeline {

struct Published {
  std::vector<std::filesystem::path> paths;  // of what was asked for, in that order
  std::vector<std::string> removed;          // names of files of an earlier state of the scene that are gone
  std::vector<std::string> left;             // and of those that somebody has changed since, and that were left
};

// A file of the workplace; without a sum it is not known yet.
struct StagedFile {
  std::string name;
  std::string sum{};
};

// Throws InputError where one of the files may not be written: a folder is in its way, or a file of another scene. For work
// that shall be refused before it is done; `published` looks again.
void require_publishable(const std::vector<StagedFile>& files, const Edition& edition, const Workplace& workplace,
                         const std::filesystem::path& output, const Cancelled& cancelled = {});

// Moves files of the workplace to `output`, its output folder as the user names it, in the given order, over what is there;
// takes away files of an earlier state of the edition; and notes all that. If anything fails, also where the program is killed
// (then by the next run), what was there before is put back. All that under the lock of the folder, which is not held for
// anything else: so of several runs at once, the folder holds the files of one. All files need a sum.
Published published(Workplace& workplace, const std::vector<StagedFile>& files, const Edition& edition,
                    const std::filesystem::path& output, const Cancelled& cancelled = {});

// Moves files of a workplace in the folder of a shot (pipeline/frame_folder.h) to the folder that this lies in, over what is
// there: all of them or none, as above, but without a note. May be called often.
void publish_above(Workplace& workplace, const std::vector<StagedFile>& files, const Cancelled& cancelled = {});

// Takes back what was half published from that workplace, if anything was.
void take_back(const std::filesystem::path& workplace, const FolderLock& lock);

}  // namespace shatterpave::pipeline
