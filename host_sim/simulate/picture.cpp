#include "draw/scene_picture.hpp"

#include <algorithm>
#include <cmath>

#include <nearfield/field/program.hpp>
#include <nearfield/query/clearance.hpp>

#include "simulate/report.hpp"

namespace nearfield::host {
namespace {

draw::Vec3 drawn(const Vector3d& v) { return {v.x, v.y, v.z}; }

struct RealSegment {
  Vector3d from, to;
  double radius = 0.0;
  Vector3d at(double share) const { return from + share * (to - from); }
};

RealSegment segment_of(const nearfield::Capsule<Q>& capsule) {
  const Vector3d from = real(capsule.from);
  const Vector3d axis{capsule.axis.x.to_double(), capsule.axis.y.to_double(), capsule.axis.z.to_double()};
  return {from, from + capsule.length.to_double() * axis, capsule.radius.to_double()};
}

std::vector<draw::PictureCapsule> drawn(const std::vector<nearfield::Capsule<Q>>& bodies) {
  std::vector<draw::PictureCapsule> capsules;
  for (const nearfield::Capsule<Q>& body : bodies) {
    const RealSegment segment = segment_of(body);
    capsules.push_back({drawn(segment.from), drawn(segment.to), segment.radius});
  }
  return capsules;
}

// The place on a segment where `distance` is least, good enough for a picture.
template <class Distance> double least_share(const Distance& distance) {
  double low = 0.0, high = 1.0;
  for (int round = 0; round < 3; ++round) {
    int best = 0;
    for (int i = 1; i <= 32; ++i) {
      if (distance(low + (high - low) * i / 32.0) < distance(low + (high - low) * best / 32.0)) best = i;
    }
    const double width = (high - low) / 32.0, middle = low + width * best;
    low = std::max(0.0, middle - width);
    high = std::min(1.0, middle + width);
  }
  return 0.5 * (low + high);
}

class Painter {
 public:
  Painter(const CompiledWorkCell& cell, const SimulationResult& result, const TellingMoment& moment)
      : cell_(cell), result_(result), moment_(moment), tick_(result.ticks[moment.tick]),
        program_(load<Q>(cell.cell.image.data(), cell.cell.image.size() * sizeof(std::uint32_t))),
        arm_(place_bodies(cell.arm, tick_.arm_joints)), person_(place_bodies(cell.person, tick_.person_joints)) {}

  std::string svg() {
    const ArmTick<Q>& d = tick_.decided;
    draw::ScenePicture picture;
    picture.title = moment_.title;
    picture.letter = moment_.letter;
    picture.time = tick_.time;
    picture.zone = d.zone == Zone::free ? draw::Zone::free : d.zone == Zone::slow ? draw::Zone::slow : draw::Zone::stop;
    picture.speed_override = d.speed_override.to_double();
    picture.clearances.push_back({"to the cell", d.cell.clearance.distance.to_double()});
    if (!person_.bodies.empty()) picture.clearances.push_back({"to the person", d.person.clearance.distance.to_double()});
    if (!cell_.arm.self_pairs.empty()) picture.clearances.push_back({"to itself", d.itself.clearance.distance.to_double()});
    picture.arm = drawn(arm_.bodies);
    for (const Vector3d& origin : arm_.link_origins) picture.joints.push_back(drawn(origin));
    picture.person = drawn(person_.bodies);
    picture.nearest = nearest();
    if (d.repulsion.x != Q{} || d.repulsion.y != Q{} || d.repulsion.z != Q{}) {
      const double strength = 0.3 * std::min(1.0, d.intensity.to_double());
      picture.repulsion = draw::RepulsionArrow{drawn(tick_.tool), drawn(strength * real(d.repulsion))};
    }
    for (std::size_t i = moment_.tick > 7000 ? moment_.tick - 7000 : 0; i <= moment_.tick; i += 20) {
      picture.tool_path.push_back(drawn(result_.ticks[i].tool));
    }
    const Vector3d cut = picture.nearest ? Vector3d{picture.nearest->on_robot[0], picture.nearest->on_robot[1],
                                                    picture.nearest->on_robot[2]}
                                         : tick_.tool;
    picture.top = view("Top view", cut, true);
    picture.side = view("Side view", cut, false);
    picture.contour_spacing = 0.1;
    picture.contour_count = 6;
    picture.id_prefix = "moment" + moment_.letter;
    return draw::scene_picture_svg(picture);
  }

 private:
  std::optional<draw::NearestPair> nearest() const {
    const ArmTick<Q>& d = tick_.decided;
    const bool person_first = d.person.body != kNoBody && moment_.shown == Nearness::person;
    if (person_first) {
      const RealSegment arm = segment_of(arm_.bodies[d.person.body]), limb = segment_of(person_.bodies[d.person.other]);
      double t = 0.0;
      const auto best_on_limb = [&](double s) {
        t = least_share([&](double share) { return length(arm.at(s) - limb.at(share)); });
        return length(arm.at(s) - limb.at(t));
      };
      const double s = least_share(best_on_limb);
      const double apart = best_on_limb(s);
      if (!(apart > 0.0)) return std::nullopt;
      const Vector3d away = (1.0 / apart) * (arm.at(s) - limb.at(t));
      return draw::NearestPair{drawn(arm.at(s) - arm.radius * away), drawn(limb.at(t) + limb.radius * away),
                               d.person.clearance.distance.to_double(), drawn(real(d.person.clearance.direction))};
    }
    if (d.cell.body == kNoBody) return std::nullopt;
    const RealSegment arm = segment_of(arm_.bodies[d.cell.body]);
    const double s = least_share([&](double share) { return value_at(arm.at(share)); });
    const double value = value_at(arm.at(s));
    const Vector3d away = real(d.cell.clearance.direction);
    return draw::NearestPair{drawn(arm.at(s) - arm.radius * away), drawn(arm.at(s) - value * away),
                             d.cell.clearance.distance.to_double(), drawn(away)};
  }

  double value_at(const Vector3d& p) const {
    const Clearance<Q> c = clearance(program_, nearfield::Vector3<Q>{Q(p.x), Q(p.y), Q(p.z)});
    return c.status == ClearanceStatus::invalid ? std::nan("") : c.distance.to_double();
  }

  // What the tool reaches in the run and half a metre around it, at least 1.4 m each way; centred between the arm's
  // base and the middle of the tool's path, in whole decimetres.
  draw::WorldWindow window(bool from_above) const {
    const auto up = [from_above](const Vector3d& v) { return from_above ? v.y : v.z; };
    double left = tick_.tool.x, right = left, bottom = up(tick_.tool), top = bottom;
    for (const TickRecord& tick : result_.ticks) {
      left = std::min(left, tick.tool.x);
      right = std::max(right, tick.tool.x);
      bottom = std::min(bottom, up(tick.tool));
      top = std::max(top, up(tick.tool));
    }
    const auto decimetres = [](double metres) { return std::round(10.0 * metres) / 10.0; };
    const double x = decimetres(0.25 * (left + right)), y = decimetres(0.25 * (bottom + top));
    const double reach = std::max(std::max(std::abs(left - x), std::abs(right - x)), std::max(std::abs(bottom - y), std::abs(top - y)));
    const double half = std::max(1.4, decimetres(reach + 0.5));
    return {x - half, x + half, y - half, y + half};
  }

  draw::SceneView view(const std::string& title, const Vector3d& cut, bool from_above) const {
    draw::SceneView view;
    char at[48];
    std::snprintf(at, sizeof at, ", cut at %s = %.2f m", from_above ? "z" : "y", from_above ? cut.z : cut.y);
    view.title = title + at;
    view.window = window(from_above);
    const double spacing = 0.02;
    const auto samples = [spacing](double low, double high) {
      return static_cast<std::size_t>(std::lround((high - low) / spacing)) + 1;
    };
    view.field = draw::sample_grid({view.window.left, view.window.bottom}, {view.window.right, view.window.top},
                                   samples(view.window.left, view.window.right),
                                   samples(view.window.bottom, view.window.top), [&](double x, double up) {
                                     return value_at(from_above ? Vector3d{x, up, cut.z} : Vector3d{x, cut.y, up});
                                   });
    return view;
  }

  const CompiledWorkCell& cell_;
  const SimulationResult& result_;
  const TellingMoment& moment_;
  const TickRecord& tick_;
  Program<Q> program_;
  PlacedBodies arm_, person_;
};

}  // namespace

std::string picture_of(const CompiledWorkCell& cell, const SimulationResult& result, const TellingMoment& moment) {
  return Painter(cell, result, moment).svg();
}

}  // namespace nearfield::host
