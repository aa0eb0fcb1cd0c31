/// Certificates of random compositions of rays, algebraic values and intensities, each blend by itself,
/// judged by the reference, and how near to its bounds each comes. Distances: blend_certificate_test.cpp.

#include "property/bound.hpp"
#include "property/random_kinds.hpp"

#include <cstdio>

namespace nearfield::property {
namespace {

constexpr int greatest_depth = 6;
constexpr int points_per_field = 20;

/// A field, within which points are drawn: a cube of half the edge `size`, or a ball.
template <class S>
struct Drawn {
  CertifiedField<S> field;
  Real size;
  bool in_ball;
};

/// What was seen of one blend.
template <class S>
class KindTrial {
 public:
  KindTrial(const char* name, Random& random) : name_(name), random_(random) {}

  /// Draws fields until `count` have a certificate that says something. make(depth) gives one.
  void run(int count, const std::function<Drawn<S>(int)>& make) {
    for (int drawn = 0; fields_ < count; ++drawn) {
      ASSERT_LT(drawn, 20 * count) << name_ << ": nearly all are refused";
      const auto [field, size, in_ball] = make(static_cast<int>(random_.integer(1, greatest_depth)));
      const Certificate<S>& certificate = field->certificate;
      if (!certificate.valid || !(certificate.error < ScalarTraits<S>::greatest())) continue;
      if (in_ball && !(certificate.magnitude < algebraic_limit<S>())) continue;
      // Sums of intensities that leave the number range saturate.
      if (!(field->weights < real(ScalarTraits<S>::greatest()))) continue;
      ++fields_;
      deepest_ = std::max(deepest_, field->depth);
      for (int i = 0; i < points_per_field; ++i) judge(*field, size, in_ball);
    }
  }

  void conclude(Real least_error_share, Real least_rate_share) const {
    std::printf("  %-38s %6lld, to depth %d: error %.3Lf", name_.c_str(), triples_, deepest_, error_.share);
    if (rate_.share > 0) std::printf(", rate %.6Lf", rate_.share);
    std::printf(" of the certified\n");
    error_.failures.expect_none(name_ + ": |evaluated - f(p)| <= error");
    rate_.failures.expect_none(name_ + ": |f(p) - f(q)| <= lipschitz |p - q|");
    magnitude_.failures.expect_none(name_ + ": |f(p)| <= magnitude");
    EXPECT_GT(error_.share, least_error_share) << name_;
    EXPECT_GE(rate_.share, least_rate_share) << name_;
  }

 private:
  /// Where the field rises most, by differences over h.
  Vec3 steepest(const CertifiedNode<S>& field, const Vec3& at, Real value, Real h) {
    const Vec3 rise{field.exact(at + Vec3{h, 0, 0}) - value, field.exact(at + Vec3{0, h, 0}) - value,
                    field.exact(at + Vec3{0, 0, h}) - value};
    return reference::norm(rise) > 0 ? rise / reference::norm(rise) : random_.unit_vector();
  }

  void judge(const CertifiedNode<S>& field, Real size, bool in_ball) {
    const Certificate<S>& certificate = field.certificate;
    const Vec3 anywhere =
        in_ball ? 0.999L * size * random_.uniform() * random_.unit_vector() : random_.vector(-size, size);
    const Vector3<S> p = rounded<S>(anywhere);
    const Vec3 at = real(p);
    const Real truth = field.exact(at), evaluated = real(field.evaluated(p));
    error_.note(std::fabs(evaluated - truth), real(certificate.error));
    if (in_ball) {
      magnitude_.note(std::max(std::fabs(truth), std::fabs(evaluated)), real(certificate.magnitude));
    }
    ++triples_;
    if (certificate.lipschitz == kNoRateBound) return;
    const Vec3 towards =
        random_.chance(0.3L) ? steepest(field, at, truth, 1e-6L * size) : random_.unit_vector();
    const Vec3 other = at + size * std::pow(Real{10}, random_.uniform(-5, 0)) * towards;
    if (in_ball && !(reference::norm(other) < size)) return;
    const Real slack = 1e-16L * (1 + std::fabs(truth));
    const Real rate = (std::fabs(field.exact(other) - truth) - slack) / reference::distance(at, other);
    rate_.note(std::ldexp(rate, kGradientLengthLog2), real(certificate.lipschitz));
  }

  std::string name_;
  Random& random_;
  Bound error_, rate_, magnitude_;
  long long triples_ = 0;
  int fields_ = 0, deepest_ = 0;
};

/// Metres: mostly of a robot's size, sometimes up to what coordinates can be.
template <class S>
Real random_size(Random& random) {
  const Real domain = real(ScalarTraits<S>::domain());
  const Real least = 0.05L * std::min<Real>(domain, 16),
             most = 0.9L * (random.chance(0.1L) ? domain : std::min<Real>(domain, 16));
  return least * std::pow(most / least, random.uniform());
}

template <class S>
void judge_rays(Random& random) {
  std::vector<std::string> names{"sharp", "any"};
  for (const RayProfile& profile : ray_profiles()) names.push_back(profile.name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& name : names) {
    KindTrial<S> trial(name == "sharp" || name == "any" ? ("rays, " + name).c_str() : name.c_str(), random);
    trial.run(440, [&](int depth) {
      const Real size = random_size<S>(random);
      return Drawn<S>{RayMaker<S>(random, size, name).field(depth, domain_reach<S>()), size, false};
    });
    trial.conclude(5e-5L, 0.4L);
  }
}

template <class S>
void judge_algebraic(Random& random) {
  constexpr const char* names[] = {"Hoffmann-Hopcroft union",
                                   "Hoffmann-Hopcroft intersection",
                                   "Hoffmann-Hopcroft difference",
                                   "Liming",
                                   "functional spline",
                                   "patch with ribbons",
                                   "patch with corners",
                                   "algebraic, sharp",
                                   "algebraic, any"};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    KindTrial<S> trial(names[i], random);
    trial.run(500, [&](int depth) {
      const Real reach = 0.1L * std::pow(Real{15}, random.uniform());
      const Reach<S> certified{rounded<S>(reach)};
      return Drawn<S>{
          AlgebraicMaker<S>(random, reach, static_cast<AlgebraicBlend>(i)).field(depth, certified), reach,
          true};
    });
    const bool is_patch = i == 5 || i == 6;  // certified by their magnitude alone
    trial.conclude(is_patch ? 0 : 5e-3L, is_patch ? 0 : 0.4L);
  }
}

template <class S>
void judge_intensities(Random& random) {
  struct Family {
    const char* name;
    SoftLeaf leaf;
    SoftBlend blend;
  };
  constexpr Family families[] = {{"sum of soft points", SoftLeaf::point, SoftBlend::sum},
                                 {"sum of soft segments", SoftLeaf::segment, SoftBlend::sum},
                                 {"sum of potentials of distances", SoftLeaf::of_distance, SoftBlend::sum},
                                 {"sum of potentials of rays", SoftLeaf::of_ray, SoftBlend::sum},
                                 {"union of intensities", SoftLeaf::any, SoftBlend::unite},
                                 {"intersection of intensities", SoftLeaf::any, SoftBlend::intersect},
                                 {"intensities, any", SoftLeaf::any, SoftBlend::any}};
  for (const Family& family : families) {
    KindTrial<S> trial(family.name, random);
    trial.run(500, [&](int depth) {
      const Real size = random_size<S>(random);
      IntensityMaker<S> maker(random, size, family.leaf, family.blend);
      return Drawn<S>{maker.field(depth, domain_reach<S>()), size, false};
    });
    trial.conclude(5e-5L, 0.15L);
  }
}

template <class S>
void judge_all(const char* test, std::uint64_t seed, void (*judge)(Random&)) {
  Random random(reference::announced_seed(test, seed));
  std::printf("%s: greatest observed of what is certified\n", ScalarName<S>::text().c_str());
  judge(random);
}

TEST(KindsCertificate, OfRaysInFixed27) {
  judge_all<Fixed<27>>("OfRaysInFixed27", 121, judge_rays<Fixed<27>>);
}
TEST(KindsCertificate, OfRaysInFixed16) {
  judge_all<Fixed<16>>("OfRaysInFixed16", 122, judge_rays<Fixed<16>>);
}
TEST(KindsCertificate, OfRaysInFloat) { judge_all<float>("OfRaysInFloat", 123, judge_rays<float>); }

TEST(KindsCertificate, OfAlgebraicFieldsInFixed27) {
  judge_all<Fixed<27>>("OfAlgebraicFieldsInFixed27", 124, judge_algebraic<Fixed<27>>);
}
TEST(KindsCertificate, OfAlgebraicFieldsInFixed16) {
  judge_all<Fixed<16>>("OfAlgebraicFieldsInFixed16", 125, judge_algebraic<Fixed<16>>);
}
TEST(KindsCertificate, OfAlgebraicFieldsInFloat) {
  judge_all<float>("OfAlgebraicFieldsInFloat", 126, judge_algebraic<float>);
}

TEST(KindsCertificate, OfIntensitiesInFixed27) {
  judge_all<Fixed<27>>("OfIntensitiesInFixed27", 127, judge_intensities<Fixed<27>>);
}
TEST(KindsCertificate, OfIntensitiesInFixed16) {
  judge_all<Fixed<16>>("OfIntensitiesInFixed16", 128, judge_intensities<Fixed<16>>);
}
TEST(KindsCertificate, OfIntensitiesInFloat) {
  judge_all<float>("OfIntensitiesInFloat", 129, judge_intensities<float>);
}

}  // namespace
}  // namespace nearfield::property
