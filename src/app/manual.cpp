// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh manual: manual pages (roff, man(7)) of the program and its commands.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/command_model.h"
#include "app/endings.h"
#include "app/self_description.h"
#include "c1mesh/version.h"

namespace c1mesh::app {
namespace {

/// The code point that begins at text[at]; `at` goes to its last byte. The help is valid UTF-8.
unsigned code_point(const std::string& text, std::size_t& at) {
  const unsigned char first = text[at];
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  unsigned value = first & (0x3F >> more);
  for (int k = 0; k < more && at + 1 < text.size(); ++k)
    value = (value << 6) | (static_cast<unsigned char>(text[++at]) & 0x3F);
  return value;
}

/// Text that roff sets as it stands, whatever it begins with.
std::string roff(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (static_cast<unsigned char>(c) >= 0x80)
      out += fmt::format("\\[u{:04X}]", code_point(text, k));
    else if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\'')
      out += "\\(aq";
    else if (c == '`')
      out += "\\(ga";
    else if (c == '^')
      out += "\\(ha";
    else if (c == '~')
      out += "\\(ti";
    else
      out += c;
  }
  if (!out.empty() && out.front() == '.') out.insert(0, "\\&");
  return out;
}

std::vector<std::string> lines_of(const std::string& text) {
  return CLI::detail::split(text, '\n');
}

std::string joined_names(const OptionModel& option) {
  std::string out;
  for (const std::string& name : option.names)
    out += (out.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  if (!option.positional && !option.flag) out += " \\fI" + roff(option.value) + "\\fR";
  if (option.many) out += " ...";
  return out;
}

std::string sentence_end(const std::string& text) {
  return text.empty() || std::string(".:;").find(text.back()) != std::string::npos ? "" : ".";
}

/// What is known of the values, after the help.
std::string remarks(const OptionModel& option) {
  std::string out;
  if (!option.choices.empty())
    out += " One of: " + CLI::detail::join(option.choices, ", ") + ".";
  else if (!option.range.empty())
    out += " Value: " + option.range + ".";
  if (!option.initial.empty()) out += " Default: " + option.initial + ".";
  if (option.required) out += " Required.";
  return out;
}

std::string option_text(const OptionModel& option) {
  std::string out = ".TP\n" + joined_names(option) + "\n";
  const std::vector<std::string> lines = lines_of(option.help);
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) out += roff(lines[k]) + "\n.br\n";
  const std::string last = lines.empty() ? "" : lines.back();
  return out + roff(last + sentence_end(last) + remarks(option)) + "\n";
}

std::string options_text(const CommandModel& command, bool with_dashes, const std::string& title) {
  std::string out, group;
  for (const OptionModel& option : command.with_dashes(with_dashes)) {
    if (out.empty()) out = ".SH " + title + "\n";
    if (option.group != group) {
      if (!group.empty()) out += ".SS " + roff(option.group) + "\n";
      group = option.group;
    }
    out += option_text(option);
  }
  return out;
}

// One line: roff breaks before what begins with a space.
std::string synopsis(const CommandModel& command) {
  std::string out = ".SH SYNOPSIS\n\\fBc1mesh";
  if (!command.name.empty()) out += " " + roff(command.name);
  out += "\\fR [\\fIOPTIONS\\fR]";
  if (command.name.empty()) out += " \\fICOMMAND\\fR";
  for (const OptionModel& option : command.with_dashes(false)) {
    const std::string name =
        "\\fI" + roff(option.names.front()) + "\\fR" + (option.many ? " ..." : "");
    out += option.required ? " " + name : " [" + name + "]";
  }
  return out + "\n";
}

/// Exit statuses and notes as paragraphs, examples as they stand.
std::string footer_text(const std::string& footer) {
  const std::size_t at = footer.find(kExamples);
  std::string out = ".SH EXIT STATUS\n";
  std::string before = footer.substr(0, at);
  const std::string title = "Exit status: ";
  if (const std::size_t begin = before.find(title); begin != std::string::npos)
    before.erase(0, begin + title.size());
  for (const std::string& line : lines_of(before))
    if (!line.empty()) out += roff(line) + "\n";
  if (at == std::string::npos) return out;
  out += ".SH EXAMPLES\n.nf\n";
  for (const std::string& line : lines_of(footer.substr(at + std::string(kExamples).size())))
    if (!line.empty()) out += roff(line.substr(line.find_first_not_of(' '))) + "\n";
  return out + ".fi\n";
}

std::string page_name(const CommandModel& command) {
  return command.name.empty() ? "c1mesh" : "c1mesh-" + command.name;
}

std::string commands_text(const std::vector<CommandModel>& models) {
  std::string out = ".SH COMMANDS\n";
  for (const CommandModel& command : models)
    if (!command.name.empty())
      out +=
          ".TP\n\\fB" + roff(page_name(command)) + "\\fR(1)\n" + roff(command.description) + "\n";
  return out;
}

std::string see_also(const CommandModel& command, const std::vector<CommandModel>& models) {
  std::string out;
  for (const CommandModel& other : models)
    if (other.name != command.name)
      out += (out.empty() ? "" : ",\n") + (".BR " + roff(page_name(other)) + " (1)");
  return ".SH SEE ALSO\n" + out + "\n";
}

std::string manual_page(const CommandModel& command, const std::vector<CommandModel>& models) {
  std::string title = page_name(command);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  std::string out =
      fmt::format(".\\\" Made by c1mesh manual.\n.TH {} 1 \"\" \"c1mesh {}\" \"c1mesh\"\n.nh\n",
                  roff(title), version());
  out += ".SH NAME\n" + roff(page_name(command)) + " \\- " + roff(command.description) + "\n";
  out += synopsis(command);
  if (command.name.empty()) out += commands_text(models);
  out += options_text(command, false, "ARGUMENTS");
  out += options_text(command, true, "OPTIONS");
  if (!command.name.empty()) out += ".P\nThose of\n.BR c1mesh (1)\nmay stand here too.\n";
  out += footer_text(command.footer);
  return out + see_also(command, models);
}

struct ManualArguments {
  std::string command, folder;
};

Status write_manual(const CLI::App& program, const ManualArguments& arguments) {
  const std::vector<CommandModel> models = models_of(program);
  if (!arguments.folder.empty()) create_folder(arguments.folder);
  bool found = false;
  for (const CommandModel& command : models) {
    const std::string file = arguments.folder + "/" + page_name(command) + ".1";
    const bool one = command.name == arguments.command;
    found = found || one;
    if (!arguments.folder.empty())
      deliver(file, manual_page(command, models));
    else if (one)
      deliver("-", manual_page(command, models));
  }
  if (!found) throw std::invalid_argument("there is no command '" + arguments.command + "'");
  return Status::ok;
}

}  // namespace

Command add_manual(CLI::App& app) {
  auto arguments = std::make_shared<ManualArguments>();
  CLI::App* cli = app.add_subcommand("manual", "Write manual pages, made of what --help says");
  CLI::Option* command = cli->add_option("COMMAND", arguments->command,
                                         "The page of this command; without it, of the program");
  cli->add_option("-o,--output", arguments->folder,
                  "Every page, into this folder, instead of one to standard output")
      ->excludes(command);
  return {cli, [arguments, &app](Console& console) {
            return guarded(console, "manual", [&] { return write_manual(app, *arguments); });
          }};
}

}  // namespace c1mesh::app
