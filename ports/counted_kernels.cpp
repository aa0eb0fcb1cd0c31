// Whether the instruction counter counts each instruction: blocks of known length must measure as just that, wherever they
// begin between two ticks of the timer. Then kernels whose counts a counter outside of the program can confirm: each is one
// function, counted_..., and what is printed is the count of its calls, the instruction that calls included.
#include <nearfield/field/builder.hpp>
#include <nearfield/nearfield.hpp>

#include <board/console.hpp>
#include <board/instruction_counter.hpp>

namespace {

using namespace nearfield;
using Q = Fixed<27>;

int failures = 0;

#ifdef __riscv
#define NEARFIELD_NUMBER "%0"
#define NEARFIELD_RETURN "ret"
#else
#define NEARFIELD_NUMBER "%c0"
#define NEARFIELD_RETURN "bx lr"
#endif

// With the call and the return as many instructions.
template <int length> [[gnu::naked, gnu::noinline]] void run_block() {
  asm volatile(
      ".rept " NEARFIELD_NUMBER
      "\nnop\n.endr\n" NEARFIELD_RETURN ::"i"(length - 2));
}
template <int length> void check_block() {
  for (uint32_t begin = 0; begin < 64; ++begin) {
    for (uint32_t i = 0; i < begin; ++i) run_block<3>();
    board::start_instruction_count();
    run_block<length>();
    const uint32_t count = board::stop_instruction_count();
    if (count == length) continue;
    ++failures;
    board::write("a block of ");
    board::write_decimal(length);
    board::write(" instructions measures as ");
    board::write_decimal(count);
    board::write("\n");
  }
}

Vector3<Q> point;
uint64_t radicand;
volatile uint32_t root;
volatile int32_t answer;
constexpr Sphere<Q> kBall = {{0.1, 0.2, 0.0}, 0.3};
constexpr Capsule<Q> kCapsule(Vector3<Q>{-0.3, 0.1, 0.0}, Vector3<Q>{0.4, 0.2, 0.3}, Q(0.1));
constexpr Box<Q> kBox = {{0.1, 0.0, 0.0}, {0.3, 0.2, 0.4}};
constexpr auto kUnion = field(unite(kBall, kCapsule));

using Chosen = OnlyOperations<Operation::sphere, Operation::box, Operation::sharp_union>;
constexpr auto kImage = [] {
  ImageBuilder<Q, 64> image;
  image.operation(kBall).operation(kBox).operation(SharpUnion<Q>{});
  image.finish();
  return image;
}();
Program<Q, Chosen> program;

}  // namespace

// Without parameters, so that calling is one instruction.
extern "C" {
[[gnu::noinline]] void counted_nothing() { asm volatile(""); }
[[gnu::noinline]] void counted_square_root() { root = integer_sqrt(radicand); }
[[gnu::noinline]] void counted_sphere() { answer = kBall.evaluate<Value<Q>>(point).value.raw(); }
[[gnu::noinline]] void counted_capsule() { answer = kCapsule.evaluate<Value<Q>>(point).value.raw(); }
[[gnu::noinline]] void counted_box() { answer = kBox.evaluate<Value<Q>>(point).value.raw(); }
[[gnu::noinline]] void counted_union() { answer = kUnion.evaluate<Value<Q>>(point, {}).value.raw(); }
[[gnu::noinline]] void counted_clearance() { answer = clearance(kUnion, point).distance.raw(); }
[[gnu::noinline]] void counted_program_query() { answer = clearance(program, point).distance.raw(); }
}

namespace {

// Has nothing else to do that could be done between the two readings.
template <void kernel()> [[gnu::noinline]] void count_into(volatile uint32_t& count) {
  board::start_instruction_count();
  kernel();
  count = board::stop_instruction_count();
}
// Calls at five points, on one line.
template <void kernel()> void report(const char* name) {
  board::write(name);
  for (int32_t i = 0; i < 5; ++i) {
    point = {Q::from_raw(i * 70000003), Q::from_raw(30000001 - i * 9000011), Q::from_raw(i * i * 11000027)};
    radicand = uint64_t{1} << (12 * i) | 12345u;
    volatile uint32_t count = 0;
    count_into<kernel>(count);
    board::write(" ");
    board::write_decimal(count);
  }
  board::write("\n");
}

}  // namespace

int main() {
  if (!board::prepare_instruction_counter()) return 1;
  check_block<2>();
  check_block<3>();
  check_block<7>();
  check_block<100>();
  check_block<1001>();
  check_block<4999>();
  program = load<Q, Chosen>(kImage.words(), kImage.size() * 4);
  if (!program.valid()) ++failures;
  report<counted_nothing>("nothing");
  report<counted_square_root>("square_root");
  report<counted_sphere>("sphere");
  report<counted_capsule>("capsule");
  report<counted_box>("box");
  report<counted_union>("union");
  report<counted_clearance>("clearance");
  report<counted_program_query>("program_query");
  return failures == 0 ? 0 : 1;
}
