// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/load/detail/action_steps.hpp>

namespace hexagait::action {
namespace {

constexpr int kMaxNesting = 16;  // of repeat in repeat

/// How much there is of something; what is copied by `repeat` must stay small.
struct Amount {
  std::size_t steps = 0, commands = 0, knots = 0;
};

std::size_t num_knots(const LegCommand& command) {
  if (const auto* foot = std::get_if<EndEffectorTrajectory>(&command.motion))
    return foot->knots.size();
  if (const auto* joints = std::get_if<JointTrajectory>(&command.motion))
    return joints->knots.size();
  return 0;
}

Amount amount(const std::vector<Step>& steps) {
  Amount sum{.steps = steps.size()};
  for (const Step& step : steps) {
    sum.commands += step.legs.size() + (step.base ? 1U : 0U) + step.custom.size() +
                    (step.wait.duration > 0.0 ? 1U : 0U);
    for (const LegCommand& leg : step.legs) sum.knots += num_knots(leg);
    if (step.base)
      if (const auto* base = std::get_if<BaseTrajectory>(&step.base->motion))
        sum.knots += base->knots.size();
    // Letters take memory, too: as much as a knot each hundred.
    for (const CustomCommand& custom : step.custom) sum.knots += custom.command.size() / 100;
  }
  return sum;
}

bool is_too_much(const Amount& sum) {
  return sum.steps > kMaxSteps || sum.commands > kMaxCommands || sum.knots > kMaxKnots;
}

// Reading on would make it all again for every reference to it.
[[noreturn]] void stop_at_too_much(YamlReader& yaml, const Mark& mark) {
  yaml.stop(mark, fmt::format("makes more than {} steps, {} commands or {} knots", kMaxSteps,
                              kMaxCommands, kMaxKnots));
}

// Adds a command to its step, which has one motion per leg and one of the base.
class StepBuilder {
 public:
  StepBuilder(YamlReader& yaml, const ActionWords& words, const Mark& mark)
      : yaml_(yaml), words_(words) {
    step_.mark = mark;
  }

  [[nodiscard]] Step take() { return std::move(step_); }

  void add(AnyCommand command, const Mark& mark) {
    if (auto* leg = std::get_if<LegCommand>(&command)) return add_leg(std::move(*leg), mark);
    if (auto* base = std::get_if<BaseCommand>(&command)) return add_base(std::move(*base), mark);
    if (auto* wait = std::get_if<Wait>(&command)) return add_wait(*wait, mark);
    step_.custom.push_back(std::move(std::get<CustomCommand>(command)));
  }

 private:
  void add_leg(LegCommand&& command, const Mark& mark) {
    const LegId leg = leg_motion(command).leg;
    for (const LegCommand& other : step_.legs)
      if (leg_motion(other).leg == leg)
        return refuse(mark, "leg " + words_.model.legs[leg].name, other.mark);
    command.mark = mark;
    step_.legs.push_back(std::move(command));
  }

  void add_base(BaseCommand&& command, const Mark& mark) {
    if (step_.base) return refuse(mark, "the base", step_.base->mark);
    command.mark = mark;
    step_.base = std::move(command);
  }

  void add_wait(const Wait& wait, const Mark& mark) {
    if (waits_.line > 0)
      return yaml_.refuse(mark, fmt::format("wait: stands in this step already, at {}:{}",
                                            waits_.line, waits_.column));
    waits_ = mark;
    step_.wait = wait;
  }

  void refuse(const Mark& mark, const std::string& what, const Mark& first) {
    yaml_.refuse(mark, fmt::format("{} has a motion in this step already, at {}:{}; a step has one "
                                   "at most",
                                   what, first.line, first.column));
  }

  YamlReader& yaml_;
  const ActionWords& words_;
  Step step_;
  Mark waits_;
};

// The keys and values beside the one at `position`.
std::vector<int> siblings(const YamlNode& map, std::size_t position) {
  std::vector<int> rest = map.children;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(position),
             rest.begin() + static_cast<std::ptrdiff_t>(position) + 2);
  return rest;
}

// The options of the command that is the key at `position` of an entry: what stands under it, or,
// in the paper's own indentation, beside it. There an anchor (`end_effector_target: &foot`) is on
// the nothing between key and options; a reference to that nothing means the options beside it.
std::vector<int> options_of(YamlReader& yaml, const YamlNode& entry, std::size_t position) {
  const YamlNode& key = yaml.node(entry.children[position]);
  const int body_index = entry.children[position + 1];
  const YamlNode& body = yaml.node(body_index);
  const std::vector<int> beside = siblings(entry, position);
  if (!body.is_null() && !body.is_map()) {
    yaml.refuse(key.mark,
                fmt::format("{}: is {}; it must be a map of options", key.text, in_words(body)));
    return {};
  }
  const bool is_here = body.is_null() && &yaml.node(body.parent) == &entry;
  if (is_here) return beside;
  if (!beside.empty())
    yaml.refuse(key.mark,
                fmt::format("{}: has options under it and beside it; it must be either", key.text));
  if (body.is_map()) return body.children;

  // A reference to nothing.
  const YamlNode& there = yaml.node(body.parent);
  for (std::size_t i = 0; there.is_map() && i + 1 < there.children.size(); i += 2)
    if (there.children[i + 1] == body_index) return siblings(there, i);
  return {};
}

std::optional<std::size_t> position_of(const YamlReader& yaml, const YamlNode& map,
                                       std::string_view key) {
  for (std::size_t i = 0; i + 1 < map.children.size(); i += 2)
    if (yaml.node(map.children[i]).is_scalar() && yaml.node(map.children[i]).text == key) return i;
  return {};
}

void refuse_entry(YamlReader& yaml, const YamlField& field) {
  std::vector<std::string> names;
  for (const YamlKeys& command : kCommands) names.emplace_back(command.of);
  const YamlNode& entry = yaml.node(field.node);
  const YamlNode& name =
      entry.is_map() && !entry.children.empty() ? yaml.node(entry.children[0]) : entry;
  if (!name.is_scalar())
    yaml.refuse(field.mark,
                fmt::format("is {}; it must be a command, such as base_auto:", in_words(entry)));
  else if (std::ranges::find(names, name.text) != names.end())
    yaml.refuse(name.mark, fmt::format("{}: a command ends in a colon", name.text));
  else
    yaml.refuse_word(name.mark, "command", name.text, names);
}

void read_entry(YamlReader& yaml, const ActionWords& words, const YamlField& field,
                StepBuilder& step) {
  const YamlNode& entry = yaml.node(field.node);
  const YamlKeys* found = nullptr;
  std::size_t position = 0;
  for (const YamlKeys& command : kCommands) {
    const auto at = entry.is_map() ? position_of(yaml, entry, command.of) : std::nullopt;
    if (!at) continue;
    if (found) {
      yaml.refuse(yaml.node(entry.children[*at]).mark,
                  fmt::format("{}: stands in one entry with {}; each command is an entry with a "
                              "dash of its own",
                              command.of, found->of));
      return;
    }
    found = &command;
    position = *at;
  }
  if (!found) return refuse_entry(yaml, field);
  const Mark mark = yaml.node(entry.children[position]).mark;
  const YamlFields options = yaml.fields(mark, options_of(yaml, entry, position), *found);
  const std::size_t before = yaml.num_refused();
  AnyCommand command = read_command(yaml, words, options);
  // A command that is wrong stands for no leg: what is said of it would mislead.
  if (yaml.num_refused() == before) step.add(std::move(command), mark);
}

Step read_step(YamlReader& yaml, const ActionWords& words, const YamlField& body) {
  StepBuilder step(yaml, words, body.mark);
  const std::vector<YamlField> entries =
      yaml.node(body.node).is_null() ? std::vector<YamlField>{} : yaml.list(body);
  if (entries.empty() && !yaml.node(body.node).is_scalar() && !yaml.node(body.node).is_map())
    yaml.refuse(body.mark, "step: is empty; it must be a list of one command or more");
  for (const YamlField& entry : entries) read_entry(yaml, words, entry, step);
  return step.take();
}

std::vector<Step> read_steps(YamlReader& yaml, const ActionWords& words, const YamlField& list,
                             int nesting);

std::vector<Step> read_repeat(YamlReader& yaml, const ActionWords& words, const YamlFields& fields,
                              int nesting) {
  std::vector<Step> once, all;
  const std::optional<YamlField> count_field = yaml.require(fields, "count");
  if (const auto steps = yaml.require(fields, "steps"))
    once = read_steps(yaml, words, *steps, nesting + 1);
  if (!count_field) return once;

  const std::optional<double> count = yaml.number(*count_field, kPositive);
  if (!count) return once;
  if (*count != std::floor(*count) || *count > static_cast<double>(kMaxSteps)) {
    yaml.refuse(*count_field, fmt::format("a whole number from 1 to {}", kMaxSteps));
    return once;
  }
  const auto times = static_cast<std::size_t>(*count);
  const Amount sum = amount(once);
  if (is_too_much({sum.steps * times, sum.commands * times, sum.knots * times}))
    stop_at_too_much(yaml, fields.mark);
  for (std::size_t i = 0; i < times; ++i) all.insert(all.end(), once.begin(), once.end());
  return all;
}

std::vector<Step> read_item(YamlReader& yaml, const ActionWords& words, const YamlField& field,
                            int nesting) {
  const YamlNode& item = yaml.node(field.node);
  if (const auto at = item.is_map() ? position_of(yaml, item, "repeat") : std::nullopt) {
    const Mark mark = yaml.node(item.children[*at]).mark;
    const YamlFields fields = yaml.fields(mark, options_of(yaml, item, *at), kRepeatMap);
    return read_repeat(yaml, words, fields, nesting);
  }
  const YamlFields fields = yaml.fields(field, kStepItemMap);
  if (auto body = yaml.find(fields, "step")) {
    body->mark = yaml.node(item.children[*position_of(yaml, item, "step")]).mark;
    return {read_step(yaml, words, *body)};
  }
  if (item.is_map() && item.children.empty())
    yaml.refuse(field.mark, "is an empty map; it must be step: or repeat:");
  return {};
}

std::vector<Step> read_steps(YamlReader& yaml, const ActionWords& words, const YamlField& list,
                             int nesting) {
  if (nesting > kMaxNesting) {
    yaml.refuse(list.mark, fmt::format("repeat: is nested deeper than {}", kMaxNesting));
    return {};
  }
  std::vector<Step> steps;
  const std::vector<YamlField> items = yaml.list(list);
  if (items.empty() && yaml.node(list.node).is_list())
    yaml.refuse(list.mark, "steps: is empty; it must be a list of one step or more");
  Amount sum;
  for (const YamlField& item : items) {
    std::vector<Step> more = read_item(yaml, words, item, nesting);
    const Amount added = amount(more);
    sum = {sum.steps + added.steps, sum.commands + added.commands, sum.knots + added.knots};
    if (is_too_much(sum)) stop_at_too_much(yaml, item.mark);
    std::move(more.begin(), more.end(), std::back_inserter(steps));
  }
  return steps;
}

}  // namespace

std::vector<Step> read_steps(YamlReader& yaml, const ActionWords& words, const YamlField& list) {
  return read_steps(yaml, words, list, 0);
}

}  // namespace hexagait::action
