#pragma once

#include "curves/curve_study.hpp"
#include "draw/curve_picture.hpp"

namespace nearfield::host {

// A curve, its derivatives and the error of its table as a picture; a little of the constants outside its
// range is shown.
draw::CurvePicture picture_of(const CurveStudy& study);

}  // namespace nearfield::host
