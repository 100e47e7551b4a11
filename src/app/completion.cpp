// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh completion: what a shell needs to complete a command line.
#include <fmt/format.h>

#include <memory>

#include "app/command_model.h"
#include "app/self_description.h"

namespace c1mesh::app {
namespace {

using Models = std::vector<CommandModel>;

/// The command's options; the program's own are known to every command.
std::vector<OptionModel> options_of(const Models& models, const CommandModel& command) {
  std::vector<OptionModel> out = command.with_dashes(true);
  if (command.name.empty()) return out;
  for (const OptionModel& option : models.front().with_dashes(true))
    if (option.names.back() != "--help" && option.names.back() != "--version")
      out.push_back(option);
  return out;
}

std::string command_names(const Models& models) {
  std::vector<std::string> names;
  for (const CommandModel& command : models)
    if (!command.name.empty()) names.push_back(command.name);
  return CLI::detail::join(names, " ");
}

std::string option_names(const std::vector<OptionModel>& options) {
  std::vector<std::string> names;
  for (const OptionModel& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return CLI::detail::join(names, " ");
}

// Values are file names where nothing else is known.
std::string bash_script(const Models& models) {
  std::string values, options, arguments;
  for (const CommandModel& command : models) {
    for (const OptionModel& option : options_of(models, command))
      if (!option.choices.empty())
        for (const std::string& name : option.names)
          values += fmt::format("    \"{} {}\") values=\"{}\" ;;\n", command.name, name,
                                CLI::detail::join(option.choices, " "));
    options += fmt::format("    \"{}\") options=\"{}\" ;;\n", command.name,
                           option_names(options_of(models, command)));
    for (const OptionModel& option : command.with_dashes(false))
      if (!option.choices.empty())
        arguments += fmt::format("    \"{}\") values=\"{}\" ;;\n", command.name,
                                 CLI::detail::join(option.choices, " "));
  }
  return fmt::format(R"(# Completion of c1mesh for bash; made by c1mesh completion bash.
_c1mesh() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  local command="" word values="" options="" commands="{}"
  # bash takes --name=value apart at the sign.
  if [[ $current == "=" ]]; then
    current=""
  elif [[ $before == "=" ]]; then
    before=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    if [[ " $commands " == *" $word "* ]]; then
      command=$word
      break
    fi
  done
  COMPREPLY=()
  case "$command $before" in
{}  esac
  if [[ -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
    return
  fi
  if [[ $current == -* ]]; then
    case "$command" in
{}    esac
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi
  case "$command" in
    "") values=$commands ;;
{}  esac
  [[ -z $values ]] || mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
}}
complete -o default -o bashdefault -F _c1mesh c1mesh
)",
                     command_names(models), values, options, arguments);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// In single quotes, with the characters that zsh's _arguments takes for its own escaped.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : first_line(text)) {
    if (c == '\'') {
      out += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_value(const OptionModel& option) {
  const std::string what = zsh_text(option.positional ? option.names.front() : option.value);
  if (!option.choices.empty())
    return ":" + what + ":(" + CLI::detail::join(option.choices, " ") + ")";
  return ":" + what + ":_files";
}

std::string zsh_options(const std::vector<OptionModel>& options, const std::string& indent) {
  std::string out;
  for (const OptionModel& option : options)
    for (const std::string& name : option.names) {
      const std::string text = zsh_text(option.help);
      const std::string value = option.flag ? "" : zsh_value(option);
      const char* joined = option.flag ? "" : name.rfind("--", 0) == 0 ? "=" : "+";
      out += fmt::format("{}'*{}{}[{}]{}' \\\n", indent, name, joined, text, value);
    }
  return out;
}

std::string zsh_script(const Models& models) {
  std::string described, cases;
  for (const CommandModel& command : models) {
    if (command.name.empty()) continue;
    described += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.description));
    std::string arguments;
    for (const OptionModel& option : command.with_dashes(false))
      arguments += fmt::format("        '{}{}' \\\n", option.many ? "*" : "", zsh_value(option));
    cases +=
        fmt::format("    {})\n      _arguments -s \\\n{}{}        && return ;;\n", command.name,
                    zsh_options(options_of(models, command), "        "), arguments);
  }
  return fmt::format(R"(#compdef c1mesh
# Completion of c1mesh for zsh; made by c1mesh completion zsh.
_c1mesh() {{
  local -a commands
  local line state
  commands=(
{}  )
  _arguments -C \
{}    '1:command:->command' '*::argument:->argument' && return
  if [[ $state == command ]]; then
    _describe command commands
    return
  fi
  case $line[1] in
{}  esac
}}
_c1mesh "$@"
)",
                     described, zsh_options(models.front().with_dashes(true), "    "), cases);
}

/// In single quotes.
std::string fish_text(const std::string& text) {
  std::string out;
  for (const char c : first_line(text)) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string fish_option(const OptionModel& option, const std::string& condition) {
  std::string out = "complete -c c1mesh" + condition;
  for (const std::string& name : option.names)
    out += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.flag) out += " -r";
  if (!option.choices.empty())
    out += " -f -a '" + fish_text(CLI::detail::join(option.choices, " ")) + "'";
  return out + " -d '" + fish_text(option.help) + "'\n";
}

std::string fish_script(const Models& models) {
  std::string out = "# Completion of c1mesh for fish; made by c1mesh completion fish.\n";
  for (const OptionModel& option : models.front().with_dashes(true)) out += fish_option(option, "");
  for (const CommandModel& command : models) {
    if (command.name.empty()) continue;
    out += fmt::format("complete -c c1mesh -n __fish_use_subcommand -f -a {} -d '{}'\n",
                       command.name, fish_text(command.description));
    const std::string inside = " -n '__fish_seen_subcommand_from " + command.name + "'";
    for (const OptionModel& option : command.with_dashes(true))
      if (option.names.back() != "--help") out += fish_option(option, inside);
    for (const OptionModel& option : command.with_dashes(false))
      if (!option.choices.empty())
        out += fmt::format("complete -c c1mesh{} -f -a '{}'\n", inside,
                           fish_text(CLI::detail::join(option.choices, " ")));
  }
  return out;
}

struct CompletionArguments {
  std::string shell, output = "-";
};

Status write_completion(const CLI::App& program, const CompletionArguments& arguments) {
  const Models models = models_of(program);
  const auto script = arguments.shell == "bash"  ? bash_script
                      : arguments.shell == "zsh" ? zsh_script
                                                 : fish_script;
  create_folder_of(arguments.output);
  deliver(arguments.output, script(models));
  return Status::ok;
}

}  // namespace

Command add_completion(CLI::App& app) {
  auto arguments = std::make_shared<CompletionArguments>();
  CLI::App* cli =
      app.add_subcommand("completion", "Write what a shell needs to complete the command line");
  cli->add_option("SHELL", arguments->shell, "The shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  cli->add_option("-o,--output", arguments->output, "File, - for standard output")
      ->capture_default_str();
  return {cli, [arguments, &app](Console& console) {
            return guarded(console, "completion",
                           [&] { return write_completion(app, *arguments); });
          }};
}

}  // namespace c1mesh::app
