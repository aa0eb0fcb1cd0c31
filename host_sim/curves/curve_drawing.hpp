#pragma once

#include "curves/curve_study.hpp"
#include "draw/curve_picture.hpp"

namespace nearfield::host {

// A curve, its derivatives and the error of its table as a picture; a little of the constants outside its
// range is shown. A step may have a rising range in (0, 1]: it is drawn as a function of t whose argument is
// t over that, over the whole of [-1, 1].
draw::CurvePicture picture_of(const CurveStudy& study, double rising_range = 1.0);

}  // namespace nearfield::host
