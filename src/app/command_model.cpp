// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_model.h"

#include <algorithm>

namespace c1mesh::app {
namespace {

/// "{a,b}" -> a, b; else none.
std::vector<std::string> choices_in(const std::string& range) {
  if (range.rfind('{', 0) != 0) return {};
  return CLI::detail::split(range.substr(1, range.find('}') - 1), ',');
}

OptionModel model_of(const CLI::Option& option) {
  OptionModel out;
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  out.positional = out.names.empty();
  if (out.positional) out.names.push_back(option.get_name(true));
  out.flag = option.get_items_expected_max() == 0;
  out.required = option.get_required();
  out.many = option.get_items_expected_max() > 1;
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  if (!out.flag) {
    out.value = type.substr(0, colon);
    if (colon != std::string::npos) out.range = type.substr(colon + 1);
    // "INT in [0 - 10]" has the type said already.
    if (out.range.rfind(out.value + " in ", 0) == 0) out.range.erase(0, out.value.size() + 1);
    out.choices = choices_in(out.range);
    out.initial = option.get_default_str();
    if (out.initial.size() > 1 && out.initial.front() == '[')
      out.initial = out.initial.substr(1, out.initial.size() - 2);
  }
  out.help = option.get_description();
  out.group = option.get_group();
  return out;
}

// Option groups are nameless subcommands.
void add_options(const CLI::App& app, std::vector<OptionModel>& options) {
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) options.push_back(model_of(*option));
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    if (group->get_name().empty()) add_options(*group, options);
}

CommandModel model_of(const CLI::App& app) {
  CommandModel out;
  out.name = app.get_parent() == nullptr ? "" : app.get_name();
  out.description = app.get_description();
  out.footer = app.get_footer();
  add_options(app, out.options);
  return out;
}

}  // namespace

std::vector<OptionModel> CommandModel::with_dashes(bool wanted) const {
  std::vector<OptionModel> out;
  std::copy_if(options.begin(), options.end(), std::back_inserter(out),
               [&](const OptionModel& option) { return option.positional != wanted; });
  return out;
}

std::vector<CommandModel> models_of(const CLI::App& program) {
  std::vector<CommandModel> out = {model_of(program)};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_name().empty()) out.push_back(model_of(*command));
  return out;
}

}  // namespace c1mesh::app
