#include "simulate/report.hpp"

#include <algorithm>
#include <cstdio>

#include "draw/timeline.hpp"

namespace nearfield::host {
namespace {

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

const char* name_of(Zone zone) {
  switch (zone) {
    case Zone::stop: return "stop";
    case Zone::slow: return "slow";
    case Zone::free: return "free";
  }
  return "";
}
const char* name_of(ClearanceStatus status) {
  switch (status) {
    case ClearanceStatus::invalid: return "invalid";
    case ClearanceStatus::touching: return "touching";
    case ClearanceStatus::undecided: return "undecided";
    case ClearanceStatus::clear: return "clear";
  }
  return "";
}

using Nearest = NearestBodies<Q> ArmTick<Q>::*;

std::size_t least_tick(const SimulationResult& result, Nearest which) {
  const auto nearer = [which](const TickRecord& a, const TickRecord& b) {
    return (a.decided.*which).clearance.distance < (b.decided.*which).clearance.distance;
  };
  return static_cast<std::size_t>(std::min_element(result.ticks.begin(), result.ticks.end(), nearer) -
                                  result.ticks.begin());
}

std::string body_name(const CompiledRobot<Q>& robot, std::uint16_t body) {
  return body < robot.bodies.size() ? robot.link_names[robot.bodies[body].link] : "-";
}

}  // namespace

std::vector<TellingMoment> telling_moments(const CompiledWorkCell& cell, const SimulationResult& result) {
  const std::size_t count = result.ticks.size();
  const auto first = [&result, count](std::size_t from, auto&& holds) {
    std::size_t tick = from;
    while (tick < count && !holds(result.ticks[tick].decided)) ++tick;
    return tick;
  };
  const auto below = [](Q limit) {
    return [limit](const ArmTick<Q>& d) { return d.person.clearance.distance < limit; };
  };
  const std::size_t slow = first(0, below(cell.settings.person_free));
  const std::size_t stop = first(slow, [](const ArmTick<Q>& d) { return d.zone == Zone::stop; });
  const std::size_t again = first(stop, [](const ArmTick<Q>& d) { return d.zone == Zone::free; });
  std::vector<TellingMoment> found = {
      {0, "", "The arm starts its cycle", Nearness::cell},
      {slow, "", "The arm slows down for the person", Nearness::person},
      {stop, "", "The arm stops", Nearness::person},
      {least_tick(result, &ArmTick<Q>::person), "", "Least clearance to the person", Nearness::person},
      {least_tick(result, &ArmTick<Q>::cell), "", "Least clearance to the cell", Nearness::cell},
      {again, "", "The arm runs freely again", Nearness::person}};
  if (cell.person.bodies.empty()) {
    for (TellingMoment& moment : found) moment.shown = Nearness::cell;
    found[3].tick = count;
  }
  std::vector<TellingMoment> moments;
  std::stable_sort(found.begin(), found.end(), [](const TellingMoment& a, const TellingMoment& b) { return a.tick < b.tick; });
  for (TellingMoment& moment : found) {
    if (moment.tick >= count || (!moments.empty() && moments.back().tick == moment.tick)) continue;
    moment.letter = std::string(1, static_cast<char>('A' + moments.size()));
    moments.push_back(moment);
  }
  return moments;
}

std::string trace_csv(const CompiledWorkCell& cell, const SimulationResult& result) {
  std::string text = "time_s,zone,speed_override";
  for (const char* to : {"cell", "person", "self"}) {
    const std::string name = to;
    text += "," + name + "_status," + name + "_clearance_m," + name + "_body," + name + "_other," + name + "_away_x," +
            name + "_away_y," + name + "_away_z";
  }
  text += ",tool_x_m,tool_y_m,tool_z_m,intensity,repulsion_x,repulsion_y,repulsion_z";
  for (const std::string& joint : cell.arm.variable_names) text += "," + joint;
  text += "\n";
  const auto number = [&text](double value) { text += format(",%.9f", value); };
  const auto vector = [&number](const Vector3d& v) {
    number(v.x);
    number(v.y);
    number(v.z);
  };
  for (const TickRecord& tick : result.ticks) {
    const ArmTick<Q>& d = tick.decided;
    text += format("%.3f", tick.time) + "," + name_of(d.zone);
    number(d.speed_override.to_double());
    const auto nearest = [&](const NearestBodies<Q>& n, const CompiledRobot<Q>& others) {
      text += std::string(",") + name_of(n.clearance.status);
      number(n.clearance.distance.to_double());
      text += "," + body_name(cell.arm, n.body) + "," + body_name(others, n.other);
      vector(real(n.clearance.direction));
    };
    nearest(d.cell, cell.arm);
    nearest(d.person, cell.person);
    nearest(d.itself, cell.arm);
    vector(tick.tool);
    number(d.intensity.to_double());
    vector(real(d.repulsion));
    for (const Q joint : tick.arm_joints) number(joint.to_double());
    text += "\n";
  }
  return text;
}

std::string timeline_of(const CompiledWorkCell& cell, const SimulationResult& result,
                        const std::vector<TellingMoment>& moments) {
  draw::Timeline timeline;
  timeline.title = "Clearances, zone and speed";
  timeline.curves = {{"to the cell", {}}, {"to the person", {}}, {"to itself", {}}};
  if (cell.person.bodies.empty()) timeline.curves.erase(timeline.curves.begin() + 1);
  for (const TickRecord& tick : result.ticks) {
    const ArmTick<Q>& d = tick.decided;
    timeline.times.push_back(tick.time);
    std::vector<double> values = {d.cell.clearance.distance.to_double(), d.person.clearance.distance.to_double(),
                                  d.itself.clearance.distance.to_double()};
    if (cell.person.bodies.empty()) values.erase(values.begin() + 1);
    for (std::size_t i = 0; i < values.size(); ++i) timeline.curves[i].clearances.push_back(values[i]);
    timeline.zones.push_back(d.zone == Zone::free   ? draw::Zone::free
                             : d.zone == Zone::slow ? draw::Zone::slow
                                                    : draw::Zone::stop);
    timeline.speed_override.push_back(d.speed_override.to_double());
  }
  if (!cell.person.bodies.empty()) {
    timeline.thresholds = {{"free", cell.settings.person_free.to_double()},
                           {"stop", cell.settings.person_stop.to_double()}};
  }
  for (const TellingMoment& moment : moments) timeline.markers.push_back({result.ticks[moment.tick].time, moment.letter});
  timeline.greatest_clearance = 2.0;
  return draw::timeline_svg(timeline);
}

std::string summary_of(const CompiledWorkCell& cell, const SimulationResult& result) {
  std::size_t ticks_in[3] = {};
  for (const TickRecord& tick : result.ticks) ++ticks_in[static_cast<std::size_t>(tick.decided.zone)];
  std::string text;
  const auto least = [&](const char* to, Nearest which, const CompiledRobot<Q>& others) {
    const TickRecord& tick = result.ticks[least_tick(result, which)];
    const NearestBodies<Q>& n = tick.decided.*which;
    text += std::string("least clearance ") + to + format(" %9.3f mm", 1000.0 * n.clearance.distance.to_double()) +
            format(" at %6.3f s", tick.time) + " (" + body_name(cell.arm, n.body) +
            (n.other == kNoBody ? "" : " - " + body_name(others, n.other)) + ", " + name_of(n.clearance.status) + ")\n";
  };
  least("to the cell  ", &ArmTick<Q>::cell, cell.arm);
  if (!cell.person.bodies.empty()) least("to the person", &ArmTick<Q>::person, cell.person);
  if (!cell.arm.self_pairs.empty()) least("to itself    ", &ArmTick<Q>::itself, cell.arm);
  text += "time in zones: free" + format(" %.3f s", 0.001 * static_cast<double>(ticks_in[2])) + ", slow" +
          format(" %.3f s", 0.001 * static_cast<double>(ticks_in[1])) + ", stop" +
          format(" %.3f s", 0.001 * static_cast<double>(ticks_in[0])) + "; cycles completed: " +
          std::to_string(result.cycles) + "\n";
  text += "worst tick: at most " + std::to_string(result.tick_budget) + " instructions on a Cortex-M4 by the budget; " +
          std::to_string(cell.arm.bodies.size()) + " bodies, " + std::to_string(cell.person.bodies.size()) +
          " of the person, " + std::to_string(cell.arm.self_pairs.size()) + " pairs of its own\n";
  if (cell.arm.greatest_cover > 0.0) {
    text += "boxes and cylinders of the robot are covered by capsules that stand out by up to" +
            format(" %.1f mm", 1000.0 * cell.arm.greatest_cover) + ": its clearances are that much smaller\n";
  }
  return text;
}

}  // namespace nearfield::host
