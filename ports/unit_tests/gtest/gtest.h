// What tests/unit/freestanding/ uses of GoogleTest, for targets without a C++ library. Tests are collected by the linker
// in a section of their own: nothing runs before main(). Of what a test writes with << text and integers are printed.
#pragma once

#include <board/console.hpp>

#if __has_include(<initializer_list>)
#include <initializer_list>
#else
namespace std {
// What the compiler makes of a list in braces.
template <class T>
class initializer_list {
 public:
  constexpr const T* begin() const { return first_; }
  constexpr const T* end() const { return first_ + size_; }
  constexpr size_t size() const { return size_; }

 private:
  constexpr initializer_list(const T* first, size_t size) : first_(first), size_(size) {}
  const T* first_;
  size_t size_;
};
}  // namespace std
#endif

namespace testing {

struct Test {};
template <class...>
struct Types {};

// One TEST, or one TYPED_TEST with each of its types.
struct Case {
  const char* suite;
  const char* name;
  int types;
  void (*run)(int type);
};

// Of the test that runs.
inline bool failed;

struct Message {
  const Message& operator<<(const char* text) const {
    nearfield::board::write(text);
    return *this;
  }
  template <class T>
  const Message& operator<<(const T& value) const {
    if constexpr (__is_enum(T) || (T(0) < T(1) && static_cast<T>(0.5f) == T(0))) {
      const auto number = static_cast<int64_t>(value);
      if (number < 0) *this << "-";
      nearfield::board::write_decimal(number < 0 ? 0 - static_cast<uint64_t>(number) : static_cast<uint64_t>(number));
    } else {
      *this << "(a number)";
    }
    return *this;
  }
};

// Assigned to after the message was written, as in `Failure{...} = Message() << "note"`.
struct Failure {
  const char* file;
  int line;
  const char* what;

  void operator=(const Message& message) const {
    failed = true;
    message << " " << file << ":" << line << ": " << what << "\n";
  }
};

template <template <class> class TypedTest, class... T>
void run_typed(Types<T...>, int type) {
  int index = 0;
  const auto run_if_its_turn = [&](auto&& test) {
    if (index++ == type) test.body();
  };
  (run_if_its_turn(TypedTest<T>()), ...);
}
template <class... T>
constexpr int count_of(Types<T...>) {
  return sizeof...(T);
}

template <class A, class B, class Tolerance>
bool is_near(A a, B b, Tolerance tolerance) {
  const auto difference = a - b;
  return difference <= tolerance && -difference <= tolerance;
}

}  // namespace testing

#define NEARFIELD_TEST_CASE(suite, name, types, run)                                \
  [[gnu::section("test_cases"), gnu::used]] const ::testing::Case suite##_##name##_case = { \
      #suite, #name, types, run};

#define TEST(suite, name)                                   \
  void suite##_##name##_body();                             \
  NEARFIELD_TEST_CASE(suite, name, 1, [](int) { suite##_##name##_body(); }) \
  void suite##_##name##_body()

#define TYPED_TEST_SUITE(suite, types, ...) using suite##_Types = types
#define TYPED_TEST(suite, name)                                                        \
  template <class T>                                                                   \
  struct suite##_##name : suite<T> {                                                   \
    using TypeParam = T;                                                               \
    void body();                                                                       \
  };                                                                                   \
  NEARFIELD_TEST_CASE(suite, name, ::testing::count_of(suite##_Types{}),               \
                      [](int type) { ::testing::run_typed<suite##_##name>(suite##_Types{}, type); }) \
  template <class T>                                                                   \
  void suite##_##name<T>::body()

#define NEARFIELD_FAILURE(what) ::testing::Failure{__FILE__, __LINE__, what} = ::testing::Message()
#define NEARFIELD_EXPECT(condition, what) \
  if (condition) {                        \
  } else                                  \
    NEARFIELD_FAILURE(what)
#define NEARFIELD_ASSERT(condition, what) \
  if (condition) {                        \
  } else                                  \
    return NEARFIELD_FAILURE(what)

#define ADD_FAILURE() NEARFIELD_FAILURE("failure")
#define FAIL() return NEARFIELD_FAILURE("failure")
#define EXPECT_TRUE(a) NEARFIELD_EXPECT(a, #a)
#define EXPECT_FALSE(a) NEARFIELD_EXPECT(!(a), "not " #a)
#define EXPECT_EQ(a, b) NEARFIELD_EXPECT((a) == (b), #a " == " #b)
#define EXPECT_NE(a, b) NEARFIELD_EXPECT((a) != (b), #a " != " #b)
#define EXPECT_LT(a, b) NEARFIELD_EXPECT((a) < (b), #a " < " #b)
#define EXPECT_LE(a, b) NEARFIELD_EXPECT((a) <= (b), #a " <= " #b)
#define EXPECT_GT(a, b) NEARFIELD_EXPECT((a) > (b), #a " > " #b)
#define EXPECT_GE(a, b) NEARFIELD_EXPECT((a) >= (b), #a " >= " #b)
#define EXPECT_NEAR(a, b, tolerance) NEARFIELD_EXPECT(::testing::is_near(a, b, tolerance), #a " near " #b)
#define ASSERT_TRUE(a) NEARFIELD_ASSERT(a, #a)
#define ASSERT_FALSE(a) NEARFIELD_ASSERT(!(a), "not " #a)
#define ASSERT_EQ(a, b) NEARFIELD_ASSERT((a) == (b), #a " == " #b)
#define ASSERT_NE(a, b) NEARFIELD_ASSERT((a) != (b), #a " != " #b)
#define ASSERT_LT(a, b) NEARFIELD_ASSERT((a) < (b), #a " < " #b)
#define ASSERT_LE(a, b) NEARFIELD_ASSERT((a) <= (b), #a " <= " #b)
