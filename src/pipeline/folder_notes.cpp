#include "pipeline/folder_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "core/error.h"

namespace shatterpave::pipeline {

namespace {

using Json = nlohmann::json;

constexpr std::string_view format = "shatterpave-folder";
constexpr int version = 1;

// Names are bytes, which need not be UTF-8: all but ASCII stand as in an address, such as %C3.
std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x80 && c != '%' ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return text;
}

std::string unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%') {
      unsigned byte = 0;
      const auto [end, error] = std::from_chars(text.data() + i + 1, text.data() + std::min(i + 3, text.size()), byte, 16);
      if (error != std::errc() || end != text.data() + i + 3) throw std::runtime_error("a name that is not escaped");
      name += static_cast<char>(byte);
      i += 2;
    } else {
      name += text[i];
    }
  }
  return name;
}

bool is_same_set(const Edition& a, const Edition& b) { return a.scene == b.scene && a.kind == b.kind; }

}  // namespace

FolderNotes notes_of_text(std::string_view text, const std::string& place) {
  FolderNotes notes;
  if (text.empty()) return notes;
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != format || json.at("version") != version) throw std::runtime_error("another format");
    for (const Json& set : json.at("sets")) {
      NotedSet noted{{unescaped(set.at("scene").get<std::string>()), set.at("set"), set.at("fingerprint")}, {}};
      for (const auto& [name, sum] : set.at("files").items()) noted.files.emplace(unescaped(name), sum);
      notes.push_back(std::move(noted));
    }
  } catch (const std::exception&) {
    throw InputError(
        Place{place, 0, 0, ""},
        "expected the notes of this version of shatterpave on the folder, got something else (use another folder, or "
        "remove this file: then nothing is known of what is there)");
  }
  return notes;
}

std::string text_of_notes(const FolderNotes& notes) {
  if (notes.empty()) return {};
  const auto quoted = [](const std::string& text) { return Json(text).dump(); };
  std::string text =
      "{\"format\": " + quoted(std::string(format)) + ", \"version\": " + std::to_string(version) + ",\n \"sets\": [";
  for (const NotedSet& set : notes) {
    text += &set == notes.data() ? "\n" : ",\n";
    text += "  {\"scene\": " + quoted(escaped(set.edition.scene)) + ", \"set\": " + quoted(set.edition.kind) +
            ",\n   \"fingerprint\": " + quoted(set.edition.fingerprint) + ",\n   \"files\": {";
    bool first = true;
    for (const auto& [name, sum] : set.files) {
      text += (first ? "\n    " : ",\n    ") + quoted(escaped(name)) + ": " + quoted(sum);
      first = false;
    }
    text += "}}";
  }
  return text + "]}\n";
}

const NotedSet* set_of(const FolderNotes& notes, const Edition& edition) {
  const auto found = std::ranges::find_if(notes, [&](const NotedSet& set) { return is_same_set(set.edition, edition); });
  return found == notes.end() ? nullptr : &*found;
}

const NotedSet* owner_of(const FolderNotes& notes, const Edition& edition, const std::string& name, const std::string& sum) {
  const auto found = std::ranges::find_if(notes, [&](const NotedSet& set) {
    const auto file = set.files.find(name);
    return !is_same_set(set.edition, edition) && file != set.files.end() && (sum.empty() || file->second != sum);
  });
  return found == notes.end() ? nullptr : &*found;
}

FileSums outdated(const FolderNotes& notes, const Edition& edition, const FileSums& files) {
  const NotedSet* const earlier = set_of(notes, edition);
  if (earlier == nullptr || earlier->edition == edition) return {};
  FileSums result;
  for (const auto& file : earlier->files) {
    const auto has_it = [&](const NotedSet& set) { return &set != earlier && set.files.contains(file.first); };
    if (!files.contains(file.first) && std::ranges::none_of(notes, has_it)) result.insert(file);
  }
  return result;
}

FolderNotes with_files(const FolderNotes& notes, const Edition& edition, const FileSums& files) {
  FolderNotes result;
  NotedSet now{edition, files};
  for (const NotedSet& set : notes) {
    if (set.edition == edition) now.files.insert(set.files.begin(), set.files.end());
    if (!is_same_set(set.edition, edition)) result.push_back(set);
  }
  result.push_back(std::move(now));
  std::ranges::sort(result, {}, [](const NotedSet& set) { return std::tie(set.edition.scene, set.edition.kind); });
  return result;
}

}  // namespace shatterpave::pipeline
