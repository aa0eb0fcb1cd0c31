#pragma once
/// A certified bound: how often it was broken, and how near to it what was found came.

#include "property/conversion.hpp"
#include "property/failures.hpp"

#include <algorithm>

namespace nearfield::property {

struct Bound {
  Failures failures;
  Real share = 0;

  void note(Real found, Real bound) {
    failures.check(found <= bound, [&](std::ostream& out) { out << found << " of " << bound; });
    if (bound > 0) share = std::max(share, found / bound);
  }
};

}  // namespace nearfield::property
