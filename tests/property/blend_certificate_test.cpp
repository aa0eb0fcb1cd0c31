/// Certificates of random compositions of each blend by itself, judged by the reference, and how near to its bounds each
/// comes: a bound that is merely loose shows.

#include <nearfield/query/clearance.hpp>

#include "property/failures.hpp"
#include "property/random_field.hpp"

#include <cstdio>

namespace nearfield::property {
namespace {

using reference::Random;
using reference::Vec3;

constexpr int fields_per_family = 2200;
constexpr int points_per_field = 20;

template <class S>
class BlendTrial {
 public:
  BlendTrial(BlendFamily family, Random& random) : family_(family), random_(random) {}

  void run() {
    for (int i = 0; i < fields_per_family; ++i) {
      FieldTaste taste;
      taste.greatest_depth = 6;
      taste.family = family_;
      taste.slots = false;
      taste.size = real(ScalarTraits<S>::domain()) * random_.uniform(0.05L, 0.6L);
      const RandomField<S> field = random_field<S>(random_, taste);
      ASSERT_TRUE(field.program.valid()) << static_cast<int>(field.program.status());
      for (int k = 0; k < points_per_field; ++k) judge(field, taste.size);
    }
    conclude();
  }

 private:
  void judge(const RandomField<S>& field, Real size) {
    const Certificate<S>& certificate = field.program.certificate();
    const S limit = ScalarTraits<S>::domain();
    const Vector3<S> anywhere = rounded<S>(random_.vector(-size, size));
    const Vector3<S> p = {clamp(anywhere.x, -limit, limit), clamp(anywhere.y, -limit, limit), clamp(anywhere.z, -limit, limit)};
    const Vec3 at = real(p);
    const Real truth = reference::value(field.node, at), sharp = reference::sharp_value(field.node, at);

    const Real error = std::fabs(real(field.program.template evaluate<Value<S>>(p, nullptr).value) - truth);
    error_.note(error, real(certificate.error));
    const Real slack = 1e-17L * (1 + size);
    erosion_.note(truth - sharp - slack, real(certificate.erosion));
    inflation_.note(sharp - truth - slack, real(certificate.inflation));
    const Vec3 other = at + size * std::pow(Real{10}, random_.uniform(-6, 0)) * random_.unit_vector();
    const Real rate = (std::fabs(reference::value(field.node, other) - truth) - slack) / reference::distance(at, other);
    rate_.note(rate, real(certificate.lipschitz));
    ++triples_;
  }

  void conclude() const {
    std::printf("  %-26s %6lld: error %.3Lf, rate %.6Lf, erosion %.3Lf, inflation %.3Lf of the certified\n",
                family_name(family_), triples_, error_.share, rate_.share, erosion_.share, inflation_.share);
    error_.failures.expect_none("|evaluated - f(p)| <= error");
    rate_.failures.expect_none("|f(p) - f(q)| <= lipschitz |p - q|");
    erosion_.failures.expect_none("blended <= sharp + erosion");
    inflation_.failures.expect_none("blended >= sharp - inflation");
    EXPECT_GT(rate_.share, 0.95L) << family_name(family_);
  }

  struct Bound {
    Failures failures;
    Real share = 0;

    void note(Real found, Real bound) {
      failures.check(found <= bound, [&](std::ostream& out) { out << found << " of " << bound; });
      if (bound > 0) share = std::max(share, found / bound);
    }
  };

  BlendFamily family_;
  Random& random_;
  Bound error_, rate_, erosion_, inflation_;
  long long triples_ = 0;
};

template <class S>
void judge_all_families(const char* test, std::uint64_t seed) {
  Random random(reference::announced_seed(test, seed));
  std::printf("%s: greatest observed of what is certified\n", ScalarName<S>::text().c_str());
  for (int family = 0; family < static_cast<int>(BlendFamily::count); ++family) {
    BlendTrial<S>(static_cast<BlendFamily>(family), random).run();
  }
}

TEST(BlendCertificate, OfEachBlendInFixed27) {
  judge_all_families<Fixed<27>>("OfEachBlendInFixed27", 111);
}
TEST(BlendCertificate, OfEachBlendInFixed16) {
  judge_all_families<Fixed<16>>("OfEachBlendInFixed16", 112);
}
TEST(BlendCertificate, OfEachBlendInFloat) {
  judge_all_families<float>("OfEachBlendInFloat", 113);
}

}  // namespace
}  // namespace nearfield::property
