// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "app/interrupt.h"
#include "c1mesh/result.h"

namespace c1mesh::app {
std::string safe_name(const std::string& wanted) {
  std::string out;
  for (const char c : wanted)
    out += c == '/' || c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f
               ? '_'
               : c;
  if (out.empty() || out.front() == '.' || out.front() == '-') out.insert(0, "_");
  return out;
}

Status guarded(Console& console, const std::string& input, const std::function<Status()>& work) {
  const auto fail = [&](Status status, const std::string& text) {
    if (interrupted()) {  // whatever failed, the signal is why the user sees it
      console.error(fmt::format("{}: stopped by a signal; nothing was written for it", input));
      return Status::limit;
    }
    const bool named = text.find(input) != std::string::npos;
    console.error(named ? text : fmt::format("{}: {}", input, text));
    return status;
  };
  try {
    return work();
  } catch (const InputError& e) {
    say_defects(console, input, e.defects());
    return fail(Status::input, "the input cannot be used; nothing was written for it");
  } catch (const FileError& e) {
    return fail(Status::input, e.what());
  } catch (const Interrupted& e) {
    return fail(Status::limit, fmt::format("stopped ({}); nothing was written for it", e.what()));
  } catch (const std::bad_alloc&) {
    return fail(Status::limit, "out of memory; nothing was written for it");
  } catch (const WriteError& e) {
    return fail(Status::internal, e.what());
  } catch (const std::invalid_argument& e) {
    return fail(Status::usage, e.what());
  } catch (const std::exception& e) {
    // As TBB says it; the memory for its stack is what a thread lacks first.
    if (std::string_view(e.what()).find("pthread_create") != std::string_view::npos)
      return fail(Status::limit, "no memory for another thread; nothing was written for it");
    return fail(
        Status::internal,
        fmt::format("internal error: {}. Please report it with this input, the command line "
                    "and the output of c1mesh --version",
                    e.what()));
  }
}

std::vector<Drawing> read_input(const std::string& path, const ReadOptions& options) {
  std::vector<Drawing> drawings = read_drawings(path, options);
  if (drawings.empty()) throw FileError("there is no shape in it");
  return drawings;
}

void say_defects(Console& console, const std::string& input, const std::vector<Defect>& defects) {
  for (const Defect& defect : defects) {
    const bool harmless = defect.repaired || defect.kind == DefectKind::note;
    const std::string line = printable(fmt::format("{}: {}", input, describe(defect)));
    if (harmless)
      console.say(line);
    else
      console.error(line);
  }
}

void deliver(const std::string& path, const std::string& text) {
  if (path == "-") {
    const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!whole || std::fflush(stdout) != 0)
      throw WriteError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
    return;
  }
  deliver_together({{path, text}});
}

void deliver_together(const std::vector<FileText>& files) {
  std::vector<FileText> named;
  for (const FileText& file : files)
    if (file.path == "-")
      deliver(file.path, file.text);
    else
      named.push_back(file);
  try {
    write_files(named);
  } catch (const FileError& e) {
    throw WriteError(e.what());
  }
}

void create_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw WriteError(fmt::format("cannot create the folder {}{}{}", path, error ? ": " : "",
                                 error ? error.message() : ""));
}

void create_folder_of(const std::string& file) {
  const std::size_t slash = file.find_last_of('/');
  if (slash != std::string::npos && slash > 0) create_folder(file.substr(0, slash));
}

std::string OutputNames::claim(const std::string& wanted) {
  std::string name = safe_name(wanted);
  if (taken_.insert(name).second) return name;
  int& number = last_.emplace(name, 1).first->second;
  while (true) {
    std::string numbered = fmt::format("{}-{}", name, ++number);
    if (taken_.insert(numbered).second) return numbered;
  }
}

}  // namespace c1mesh::app
