#include "curves/curve_drawing.hpp"

#include <algorithm>

#include "curves/curve_report.hpp"
#include "text/number.hpp"

namespace nearfield::host {
namespace {

constexpr int samples_of_a_range = 4000;
constexpr double margin_of_a_range = 0.04;
// Longer titles would be too small to read.
constexpr std::size_t longest_title = 90;

// The three series of a picture while they grow.
struct Series {
  draw::CurvePicture& picture;

  void begin() {
    for (auto* lines : {&picture.value, &picture.first, &picture.second}) lines->emplace_back();
  }
  void add(double x, const Differentiable& here) {
    picture.value.back().points.push_back({x, here.value});
    picture.first.back().points.push_back({x, here.first});
    picture.second.back().points.push_back({x, here.second});
  }
};

// One piece between two breaks, with the limits at its ends.
void add_piece(Series& series, const AnyCurve& curve, double from, double to, int count) {
  const double beside = (to - from) * detail::kBeside;
  series.begin();
  series.add(from, detail::limit_from(curve, from, beside));
  for (int i = 1; i < count; ++i) {
    const double x = from + (to - from) * i / count;
    series.add(x, curve(Differentiable::argument(x)));
  }
  series.add(to, detail::limit_from(curve, to, -beside));
}

void add_constant(Series& series, double from, double to, double value) {
  series.begin();
  series.add(from, value);
  series.add(to, value);
}

std::vector<double> ends_of_pieces(const CurveFacts& facts) {
  std::vector<double> ends{facts.from};
  for (int i = 0; i < facts.break_count; ++i)
    ends.push_back(facts.from + facts.breaks[i] * (facts.to - facts.from));
  if (facts.middle_jump > 0.0) ends.push_back(facts.middle());
  ends.push_back(facts.to);
  std::sort(ends.begin(), ends.end());
  return ends;
}

// The same function of `factor` times the argument's part.
void stretch(draw::CurvePicture& picture, double factor) {
  const auto scale = [factor](std::vector<draw::Polyline>& lines, double of_values) {
    for (draw::Polyline& line : lines) {
      for (draw::Point& p : line.points) p = {factor * p.x, of_values * p.y};
    }
  };
  scale(picture.value, 1.0);
  scale(picture.first, 1.0 / factor);
  scale(picture.second, 1.0 / (factor * factor));
  for (draw::Point& p : picture.errors) p.x *= factor;
  for (double& knot : picture.knots) knot *= factor;
}

bool has_long_title(const CurveStudy& study) { return headline_of(study).size() > longest_title; }

std::vector<std::string> captions_of(const CurveStudy& study) {
  std::vector<std::string> captions;
  if (has_long_title(study)) captions.push_back(study.configured.parameters + ".");
  if (!study.table) {
    captions.push_back("Drawn without a table: " + missed_error_of(study) + ".");
    return captions;
  }
  const StudiedTable& table = *study.table;
  captions.push_back("Table: " + type_name(study.scalar) + ", " + table_in_words(study) +
                     ", coefficients of " + std::to_string(table.shape.bits) + " bits" +
                     (table.mirrored ? ", half of the range, the other half mirrored." : "."));
  captions.push_back(
      "|table − exact| at most " + error_in_words(table.error) +
      (table.slope_error < 127.9 ? ", slope within " + error_in_words(table.slope_error) + "." : "."));
  if (!study.within_error) captions.push_back("As near as it gets: " + missed_error_of(study) + ".");
  return captions;
}

}  // namespace

draw::CurvePicture picture_of(const CurveStudy& study, double rising_range) {
  const AnyCurve& curve = study.curve();
  const CurveFacts facts = curve.facts();
  const double length = facts.to - facts.from;
  draw::CurvePicture picture;
  picture.title = has_long_title(study) ? study.configured.name : headline_of(study);
  picture.captions = captions_of(study);
  picture.argument = study.argument_name();
  picture.function = study.function_name();
  picture.low = facts.from - margin_of_a_range * length;
  picture.high = facts.to + margin_of_a_range * length;

  Series series{picture};
  add_constant(series, picture.low / rising_range, facts.from, facts.before);
  const std::vector<double> ends = ends_of_pieces(facts);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const int count = 2 + static_cast<int>(samples_of_a_range * (ends[i] - ends[i - 1]) / length);
    add_piece(series, curve, ends[i - 1], ends[i], count);
  }
  add_constant(series, facts.to, picture.high / rising_range, facts.after);

  const ControlPoints points = curve.control_points();
  for (int i = 0; i < points.count; ++i) picture.control_points.push_back({points.x[i], points.y[i]});
  if (study.table) {
    for (const CurveRow& row : rows_of(study, samples_of_a_range + 1))
      picture.errors.push_back({row.argument, row.error()});
    picture.error_bound = study.table->error;
    picture.knots = study.table->knots;
  }
  if (rising_range != 1.0) {
    stretch(picture, rising_range);
    picture.title += ", rising range " + format_number(rising_range);
  }
  return picture;
}

}  // namespace nearfield::host
