#pragma once
/// What every shape and modifier must hold, whatever it is. A new one is a row: a struct with
///   static constexpr const char* name;
///   static constexpr bool exact_solid;          certified within 16 units in the last place of what is observed
///   using Operations = OnlyOperations<...>;     what its program is made of
///   struct Parameters;                          as a caller thinks of them, long double
///   static Parameters draw(Random&, Real size);           allowed ones, of everything up to `size` metres
///   static std::vector<Parameters> degenerate(Real size); zero lengths, zero radii ...
///   static std::vector<Vec3> places(const Parameters&);   centres, edges, axes: where things happen
///   template <class S> static auto node(const Parameters&);   a static composition of them, rounded
///   static Real value(const Parameters&, const Vec3& p);      written independently; exact
/// if its composition samples tables, `template <class S, class Writer> static void tables(Writer&)`; if its
/// directions are found by iteration, `static constexpr Real direction_tolerance`; if its reference takes long,
/// `static constexpr int one_draw_in`: only one of so many is made; and if queries hand it anything, `template <class S>
/// static Given<S> given(const Parameters&)`. One that blends distances has `static constexpr bool unit_directions =
/// false`: its gradients may be shorter.

#include <golden/node_writer.hpp>
#include <nearfield/field/program.hpp>

#include "property/conversion.hpp"
#include "property/failures.hpp"
#include "reference/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace nearfield::property {

using reference::Random;
using reference::Vec3;

namespace conformance {

template <class S>
constexpr int draws = std::is_same_v<S, Fixed<27>> ? 400 : 200;
constexpr int points_of_a_draw = 120;
constexpr Real least_step_of_slopes = 1e-5L;     // m, for differences of the reference
constexpr Real kinks_that_slopes_miss = 1e-4L;  // by which they may be off where they count as settled

template <class Row, class S, class = void>
constexpr int draws_of = draws<S>;
template <class Row, class S>
constexpr int draws_of<Row, S, std::void_t<decltype(Row::one_draw_in)>> = draws<S> / Row::one_draw_in;

template <class Row, class Writer, class S, class = void>
struct TablesOf {
  static void add(Writer&) {}
};
template <class Row, class Writer, class S>
struct TablesOf<Row, Writer, S, decltype(Row::template tables<S>(std::declval<Writer&>()))> {
  static void add(Writer& writer) { Row::template tables<S>(writer); }
};

/// The pose and the parameter of slot 0.
template <class S>
struct Given {
  Pose<S> pose;
  S parameter{};
};
template <class Row, class S, class = void>
struct GivenTo {
  static Given<S> by(const typename Row::Parameters&) { return {}; }
};
template <class Row, class S>
struct GivenTo<Row, S, std::void_t<decltype(Row::template given<S>(std::declval<typename Row::Parameters>()))>> {
  static Given<S> by(const typename Row::Parameters& parameters) { return Row::template given<S>(parameters); }
};

template <class Row, class = void>
struct UnitDirections : std::true_type {};
template <class Row>
struct UnitDirections<Row, std::void_t<decltype(Row::unit_directions)>> : std::bool_constant<Row::unit_directions> {};

/// A node as a static field and as a program.
template <class Row, class S>
class Entry {
 public:
  using Node = decltype(Row::template node<S>(std::declval<typename Row::Parameters>()));
  using Writer = golden::NodeWriter<S, 4096, typename Row::Operations>;

  explicit Entry(const typename Row::Parameters& parameters)
      : node_(Row::template node<S>(parameters)), field_(node_), given_(GivenTo<Row, S>::by(parameters)), writer_(std::make_unique<Writer>()) {
    TablesOf<Row, Writer, S>::add(*writer_);
    writer_->write(node_);
    const Inspection<S> inspection = writer_->builder().finish();
    program_ = {writer_->builder().words(), inspection};
  }
  bool valid() const { return field_.valid(); }
  bool program_valid() const { return program_.valid(); }
  const Certificate<S>& certificate() const { return field_.certificate(); }
  const Certificate<S>& program_certificate() const { return program_.certificate(); }
  template <class Out>
  Out in_field(const Vector3<S>& p) const {
    return field_.template evaluate<Out>(p, slots());
  }
  template <class Out>
  Out in_program(const Vector3<S>& p) const {
    return program_.template evaluate<Out>(p, slots());
  }

 private:
  Slots<S> slots() const { return {&given_.pose, 1, &given_.parameter, 1}; }

  Node node_;
  Field<Node> field_;
  Given<S> given_;
  std::unique_ptr<Writer> writer_;
  Program<S, typename Row::Operations> program_;
};

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Of the reference: the mean of the slopes forwards and backwards, and how far apart these are, per metre.
struct Slopes {
  Vec3 mean, apart;
};
template <class Row>
Slopes slopes_of(const typename Row::Parameters& parameters, const Vec3& p, Real step) {
  const Real here = Row::value(parameters, p);
  Slopes slopes;
  const auto along = [&](const Vec3& unit, Real& mean, Real& apart) {
    const Real before = (here - Row::value(parameters, p - step * unit)) / step;
    const Real after = (Row::value(parameters, p + step * unit) - here) / step;
    mean = (before + after) / 2;
    apart = after - before;
  };
  along({1, 0, 0}, slopes.mean.x, slopes.apart.x);
  along({0, 1, 0}, slopes.mean.y, slopes.apart.y);
  along({0, 0, 1}, slopes.mean.z, slopes.apart.z);
  return slopes;
}

template <class Row, class S>
class Judge {
 public:
  explicit Judge(std::uint64_t seed) : random_(seed) {}

  void run() {
    const Real domain = real(ScalarTraits<S>::domain());
    for (const auto& parameters : Row::degenerate(0.25L * domain)) judge(parameters, true);
    for (int i = 0; i < draws_of<Row, S>; ++i) {
      const Real size = domain * (random_.chance(0.5L) ? 0.25L : random_.uniform(0.02L, 0.6L));
      judge(Row::draw(random_, size), false);
    }
    conclude();
  }

 private:
  static constexpr bool is_distance = Entry<Row, S>::Node::kind == Kind::distance;
  static constexpr bool has_unit_directions = is_distance && UnitDirections<Row>::value;
  static constexpr Real per_metre = is_distance ? 1 : 16;  // of gradients and rates

  void judge(const typename Row::Parameters& parameters, bool must_be_valid) {
    const Entry<Row, S> entry(parameters);
    agreement_.check(entry.valid() == entry.program_valid(), [&](std::ostream& out) { out << "validity"; });
    if (!entry.valid()) {
      validity_.check(!must_be_valid, [&](std::ostream& out) { out << "degenerate parameters"; });
      return;
    }
    ++valid_;
    const Certificate<S>&a = entry.certificate(), &b = entry.program_certificate();
    agreement_.check(a.lipschitz == b.lipschitz && a.error == b.error, [&](std::ostream& out) { out << "certificate"; });
    certified_ = std::max(certified_, real(a.error));
    std::vector<Vec3> places = Row::places(parameters);
    const Real nudge = last_place<S>(real(ScalarTraits<S>::domain()));
    for (const Vec3& place : places) {
      for (int i = 0; i < 9; ++i) {
        const Vec3 off{nudge * static_cast<Real>(random_.integer(-1, 1)), nudge * static_cast<Real>(random_.integer(-1, 1)),
                       nudge * static_cast<Real>(random_.integer(-1, 1))};
        judge(parameters, entry, in_domain(i == 0 ? place : place + off));
      }
    }
    for (int i = 0; i < points_of_a_draw; ++i) judge(parameters, entry, in_domain(point(parameters, places)));
  }

  Vec3 point(const typename Row::Parameters& parameters, const std::vector<Vec3>& places) {
    const Real domain = real(ScalarTraits<S>::domain());
    if (random_.chance(0.2L)) return random_.vector(-domain, domain);
    const Vec3 near = places.empty() ? Vec3{} : places[static_cast<std::size_t>(
        random_.integer(0, static_cast<std::int64_t>(places.size()) - 1))];
    Vec3 p = near + random_.uniform(0, 1) * random_.uniform(0, 0.5L * domain) * random_.unit_vector();
    if (is_distance && random_.chance(0.5L))
      p = p - random_.uniform(0.9L, 1.1L) * Row::value(parameters, p) * slopes_of<Row>(parameters, p, 1e-6L).mean;
    return p;
  }
  static Vector3<S> in_domain(const Vec3& p) {
    const S limit = ScalarTraits<S>::domain();
    const Vector3<S> q = rounded<S>(p);
    return {clamp(q.x, -limit, limit), clamp(q.y, -limit, limit), clamp(q.z, -limit, limit)};
  }

  void judge(const typename Row::Parameters& parameters, const Entry<Row, S>& entry, const Vector3<S>& p) {
    ++points_;
    const Vec3 at = real(p);
    const auto place = [&](std::ostream& out) {
      out << " at " << at.x << " " << at.y << " " << at.z;
    };
    const Sample<S> sample = entry.template in_field<Sample<S>>(p);
    const S value = entry.template in_field<Value<S>>(p).value;
    agreement_.check(same_bits(value, sample.value), [&](std::ostream& out) {
      out << "value alone " << real(value) << " with gradient " << real(sample.value);
      place(out);
    });
    agreement_.check(same_bits(sample, entry.template in_program<Sample<S>>(p)) &&
                         same_bits(value, entry.template in_program<Value<S>>(p).value),
                     [&](std::ostream& out) { out << "program"; place(out); });

    const Real truth = Row::value(parameters, at), certified = real(entry.certificate().error);
    const Real off = real(value) - truth;
    above_ = std::max(above_, off);
    below_ = std::max(below_, -off);
    if (certified > 0) share_ = std::max(share_, std::fabs(off) / certified);
    error_.check(std::fabs(off) <= certified, [&](std::ostream& out) {
      out << real(value) << " instead of " << truth << ", certified " << certified;
      place(out);
    });
    judge_direction(parameters, sample, at, certified);
    judge_rate(parameters, entry.certificate(), at, truth);
  }

  // A unit vector or none; compared with differences of the reference where these settle.
  void judge_direction(const typename Row::Parameters& parameters, const Sample<S>& sample, const Vec3& at, Real certified) {
    const Vec3 gradient = real(sample.gradient);
    if constexpr (has_unit_directions) {
      const Real length = reference::norm(gradient);
      const Real unit = last_place<S>(1);
      const Real off = std::fabs(length - 1) / unit;
      if (!is_zero(sample.gradient)) length_ = std::max(length_, off);
      unit_.check(is_zero(sample.gradient) || off <= 16, [&](std::ostream& out) {
        out << "length " << length << " at " << at.x << " " << at.y << " " << at.z;
      });
    }
    // Wide enough to see a kink on whose other side the point may be taken for.
    const Real step = std::max(least_step_of_slopes, 4 * certified);
    const Slopes slopes = slopes_of<Row>(parameters, at, step);
    const Real steepness = 1 + reference::norm(slopes.mean), apart = reference::norm(slopes.apart);
    if (apart > 1e-3L * steepness) return;
    ++directions_;
    // Where values are off by as much as is certified, directions are those of a place as far away.
    const Real tolerance = 8 * last_place<S>(steepness) + 8 * apart + 2 * certified * apart / step +
                           Tolerance<Row>::value * steepness;
    const Real off = reference::distance(per_metre * gradient, slopes.mean);
    worst_direction_ = std::max(worst_direction_, off / steepness);
    if (apart < 1e-4L * steepness) worst_smooth_ = std::max(worst_smooth_, off / steepness);
    direction_.check(off <= tolerance + per_metre * last_place<S>(1), [&](std::ostream& out) {
      out << "off by " << off << ", allowed " << tolerance << " at " << at.x << " " << at.y << " " << at.z << ", gradient "
          << gradient.x << " " << gradient.y << " " << gradient.z << " times " << per_metre << " instead of "
          << slopes.mean.x << " " << slopes.mean.y << " " << slopes.mean.z;
    });
  }
  // Of shapes that are found by iteration: how far their directions may be off.
  template <class R, class = void>
  struct Tolerance {
    static constexpr Real value = 0;
  };
  template <class R>
  struct Tolerance<R, std::void_t<decltype(R::direction_tolerance)>> {
    static constexpr Real value = R::direction_tolerance;
  };

  void judge_rate(const typename Row::Parameters& parameters, const Certificate<S>& certificate, const Vec3& at, Real truth) {
    if (certificate.lipschitz == kNoRateBound) return;
    const Real domain = real(ScalarTraits<S>::domain());
    const Real apart = random_.chance(0.3L) ? random_.uniform(0, domain) : std::pow(Real{10}, random_.uniform(-6, -1));
    const Vec3 other = at + apart * random_.unit_vector();
    if (std::max({std::fabs(other.x), std::fabs(other.y), std::fabs(other.z)}) > domain) return;
    const Real change = std::fabs(Row::value(parameters, other) - truth) / (reference::distance(at, other) * per_metre);
    const Real bound = real(certificate.lipschitz);
    if (bound > 0) rate_share_ = std::max(rate_share_, change / bound);
    rate_.check(change <= bound * (1 + 1e-9L), [&](std::ostream& out) { out << change << " certified " << bound; });
  }

  void conclude() {
    const std::string name = std::string(Row::name) + " in " + ScalarName<S>::text();
    agreement_.expect_none(name + ": field and program, value and gradient agree to the bit");
    validity_.expect_none(name + ": allowed parameters are valid");
    error_.expect_none(name + ": within the certified error");
    unit_.expect_none(name + ": directions are unit vectors or none");
    direction_.expect_none(name + ": directions");
    rate_.expect_none(name + ": Lipschitz");
    EXPECT_GT(valid_, (draws_of<Row, S> / 2)) << name;
    EXPECT_GT(directions_, points_ / 8) << name;
    EXPECT_LE(worst_smooth_, kinks_that_slopes_miss + Tolerance<Row>::value + 4 * per_metre * last_place<S>(1)) << name;
    const Real unit = last_place<S>(real(ScalarTraits<S>::domain()));
    if constexpr (Row::exact_solid && std::is_same_v<S, Fixed<27>>) {
      EXPECT_LE(certified_, std::max(above_, below_) + 16 * unit) << name;
    }
    std::printf("%-36s %7lld points: error %.3g below to %.3g above, certified %.3g (share %.3f); direction off by "
                "%.2g (%.2g), its length by %.1f units; rate %.4f of the certified\n",
                name.c_str(), points_, static_cast<double>(below_ / unit), static_cast<double>(above_ / unit),
                static_cast<double>(certified_ / unit), static_cast<double>(share_), static_cast<double>(worst_direction_), static_cast<double>(worst_smooth_),
                static_cast<double>(length_), static_cast<double>(rate_share_));
  }

  Random random_;
  Failures agreement_, validity_, error_, unit_, direction_, rate_;
  Real above_ = 0, below_ = 0, certified_ = 0, share_ = 0, worst_direction_ = 0, worst_smooth_ = 0, length_ = 0, rate_share_ = 0;
  long long points_ = 0, directions_ = 0;
  int valid_ = 0;
};

}  // namespace conformance

/// Judges a row in every scalar. Errors are printed in units in the last place (float: of the domain).
template <class Row>
void judge_row(std::uint64_t usual_seed) {
  const std::uint64_t seed = reference::announced_seed(Row::name, usual_seed);
  conformance::Judge<Row, Fixed<27>>(seed).run();
  conformance::Judge<Row, Fixed<16>>(seed + 1).run();
  conformance::Judge<Row, float>(seed + 2).run();
}

}  // namespace nearfield::property
