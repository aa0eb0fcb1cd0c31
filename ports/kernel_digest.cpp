// The digest of what is below every field: products, quotients, roots and one table; and of one field, a ball. For
// targets where more does not compile.
#include <board/digests.hpp>
#include <golden/digests.hpp>
#include <golden/stream.hpp>
#include <nearfield/number/ratio.hpp>
#include <nearfield/number/sqrt.hpp>
#include <nearfield/shape/sphere.hpp>
#include <nearfield/table/table.hpp>
#include <work_cell/digest.hpp>

namespace {

using namespace nearfield;
using S = Fixed<27>;

// Eight cubic segments of any shape.
constexpr uint32_t kCoefficients[32] = {
    0x10000000, 0xf8000000, 0x04000000, 0xff000000, 0x0e000000, 0xf9000000, 0x03800000, 0xff200000,
    0x0c000000, 0xfa000000, 0x03000000, 0xff400000, 0x0a000000, 0xfb000000, 0x02800000, 0xff600000,
    0x08000000, 0xfc000000, 0x02000000, 0xff800000, 0x06000000, 0xfd000000, 0x01800000, 0xffa00000,
    0x04000000, 0xfe000000, 0x01000000, 0xffc00000, 0x02000000, 0xff000000, 0x00800000, 0xffe00000};

S in_domain(golden::Stream& stream) { return S::from_raw(stream.integer_of_bits(30)); }

}  // namespace

int main() {
  golden::Stream stream(0x6b65726eu);
  work_cell::Digest digest;
  for (int i = 0; i < 2000; ++i) {
    const uint32_t a = stream.next(), b = stream.next();
    digest.add(multiply_high(a, b));
    digest.add(ratio(a < b ? a : b, a < b ? b : a));
    const S x = S::from_raw(static_cast<int32_t>(a)), y = S::from_raw(static_cast<int32_t>(b));
    digest.add(static_cast<uint32_t>((x * y).raw()));
    digest.add(static_cast<uint32_t>((x + y).raw()));
    TableView<S> table{};
    table.coefficients = kCoefficients;
    table.index_bits = 3;
    table.slope_headroom = 1;
    const TableSample<S> sample = sample_table<true>(table, a >> 1);
    digest.add(static_cast<uint32_t>(sample.value.raw()));
    digest.add(static_cast<uint32_t>(sample.slope.raw()));
    digest.add(integer_sqrt(uint64_t{a} << 32 | b));
    const Sphere<S> ball{{S::from_raw(0x01000000), S{}, S{}}, S::from_raw(0x02000000)};
    const Vector3<S> p{in_domain(stream), in_domain(stream), in_domain(stream)};
    const Sample<S> at_p = ball.evaluate<Sample<S>>(p);
    digest.add(static_cast<uint32_t>(at_p.value.raw()));
    digest.add(static_cast<uint32_t>(at_p.gradient.x.raw()));
    digest.add(static_cast<uint32_t>(at_p.gradient.y.raw()));
    digest.add(static_cast<uint32_t>(at_p.gradient.z.raw()));
  }
  return board::print_digest("kernel", digest.value(), golden::kKernelDigest) ? 0 : 1;
}
