#include "bench/path_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <vector>

#include "geometry/number_text.hpp"
#include "planner/path/interval_measure.hpp"

namespace volute::bench {

namespace {

using geometry::Vec2;
using geometry::Vec3;
using Polyline = std::vector<Vec2>;

// Whole pixels of a large page: steps between them are short as text.
constexpr double width_px = 1800.0, margin_px = 40.0, foot_px = 150.0, kept_px = 1.2, row_px = 44.0;

/// From far too near (blue) over just right (green) to too wide (red); each up to its ratio.
struct Shade {
  double ratio_max;
  const char *colour, *label;
};
constexpr std::array<Shade, 6> shades{{{0.25, "#313695", "under 0.25"},
                                       {0.5, "#4575b4", "0.25 to 0.5"},
                                       {0.75, "#74add1", "0.5 to 0.75"},
                                       {0.9, "#66bd63", "0.75 to 0.9"},
                                       {1.05, "#1a9850", "0.9 to 1.05"},
                                       {1e300, "#d73027", "over 1.05"}}};

std::size_t shade_of(double ratio) {
  std::size_t k = 0;
  while (ratio > shades[k].ratio_max) ++k;
  return k;
}

/// An SVG drawing whose content is scaled to the page's width, y upwards.
class Drawing {
 public:
  Drawing(const Vec2& low, const Vec2& high, double height_over_width) : low_(low) {
    const Vec2 size = high - low;
    scale_.x() = (width_px - 2.0 * margin_px) / size.x();
    const double height =
        height_over_width > 0.0 ? height_over_width * (width_px - 2.0 * margin_px) : size.y() * scale_.x();
    scale_.y() = height / size.y();
    height_px_ = height + 2.0 * margin_px;
  }

  void line(const Polyline& points, const std::string& style) {
    if (points.size() < 2) return;
    Polyline px;
    for (const Vec2& p : points)
      px.emplace_back(margin_px + (p.x() - low_.x()) * scale_.x(),
                      height_px_ - margin_px - (p.y() - low_.y()) * scale_.y());
    body_ += "<path d=\"";
    Vec2 at = Vec2::Zero();
    for (const Vec2& p : thinned(px)) {
      const Vec2 to = p.array().round();
      body_ += (at.isZero() ? "M" : body_.back() == 'l' ? "" : " ") + step(to - at);
      if (at.isZero()) body_ += "l";
      at = to;
    }
    body_ += "\" " + style + "/>\n";
  }
  /// Below the content, in rows of text.
  void text(double x_px, int row, const std::string& words) {
    body_ +=
        "<text x=\"" + whole(x_px) + "\" y=\"" + whole(height_px_ + 32.0 + row_px * row) + "\">" + words + "</text>\n";
  }
  void swatch(double x_px, int row, const std::string& colour) {
    body_ += "<rect x=\"" + whole(x_px) + "\" y=\"" + whole(height_px_ + 12.0 + row_px * row) +
             "\" width=\"36\" height=\"20\" fill=\"" + colour + "\"/>\n";
  }
  [[nodiscard]] bool write(const std::filesystem::path& file) const {
    std::ofstream out(file, std::ios::binary);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << whole(width_px) << ' '
        << whole(height_px_ + foot_px)
        << "\" font-family=\"sans-serif\" font-size=\"28\" fill=\"none\" stroke-linejoin=\"round\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<style>text{fill:#222}</style>\n"
        << body_ << "</svg>\n";
    return static_cast<bool>(out.flush());
  }

 private:
  static std::string whole(double x) { return geometry::short_text(std::round(x)); }
  /// "dx dy"; a minus sign parts the two as well as a space does.
  static std::string step(const Vec2& by) {
    const std::string dy = whole(by.y());
    return whole(by.x()) + (dy.front() == '-' ? "" : " ") + dy;
  }

  /// Douglas and Peucker: no point left out lies farther off than kept_px.
  static Polyline thinned(const Polyline& px) {
    std::vector<char> keep(px.size(), 0);
    keep.front() = keep.back() = 1;
    std::vector<std::array<std::size_t, 2>> spans{{0, px.size() - 1}};
    while (!spans.empty()) {
      const auto [i, j] = spans.back();
      spans.pop_back();
      const Vec2 chord = px[j] - px[i];
      double worst = kept_px;
      std::size_t at = 0;
      for (std::size_t k = i + 1; k < j; ++k) {
        const Vec2 off = px[k] - px[i];
        const double share = chord.isZero() ? 0.0 : std::clamp(off.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        const double distance = (off - share * chord).norm();
        if (distance <= worst) continue;
        worst = distance;
        at = k;
      }
      if (at == 0) continue;
      keep[at] = 1;
      spans.push_back({i, at});
      spans.push_back({at, j});
    }
    Polyline kept;
    for (std::size_t k = 0; k < px.size(); ++k)
      if (keep[k]) kept.push_back(px[k]);
    return kept;
  }

  Vec2 low_, scale_ = Vec2::Ones();
  double height_px_ = 0.0;
  std::string body_;
};

Vec2 from_above(const Vec3& p) { return {p.x(), p.y()}; }

std::string caption(const PathPicture& picture) {
  const auto& report = picture.result.report;
  return picture.name + ": length " + geometry::short_text(report.length_ratio, 3) + " times the bound, " +
         std::to_string(report.pieces) + (report.pieces == 1 ? " piece, " : " pieces, ") +
         std::to_string(report.sharp_corners_60) + " corners over 60 degrees";
}

void draw_coloured(const PathPicture& picture, Drawing& drawing) {
  const planner::IntervalField intervals(picture.surface,
                                         planner::interval_rule(picture.cutter, picture.options.scallop_mm, {}));
  const double apart_mm = intervals.rule().interval_mm(0.0);
  Polyline run;
  std::size_t shade = 0;
  const auto finish = [&] {
    drawing.line(run, std::string("stroke=\"") + shades[shade].colour + "\" stroke-width=\"2.6\"");
  };
  Vec3 last = Vec3::Zero();
  for (const auto& sample : planner::interval_samples(picture.surface, intervals, picture.result.path)) {
    const std::size_t here = shade_of(sample.ratio);
    const bool joins = !run.empty() && (sample.point_P_mm - last).norm() < apart_mm;
    if (!joins || here != shade) {
      finish();
      run.clear();
      if (joins) run.push_back(from_above(last));
      shade = here;
    }
    run.push_back(from_above(sample.point_P_mm));
    last = sample.point_P_mm;
  }
  finish();
}

bool draw_path(const PathPicture& picture, const std::filesystem::path& file) {
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Vec3& v : picture.surface.vertices_mm) {
    low = low.cwiseMin(from_above(v));
    high = high.cwiseMax(from_above(v));
  }
  Drawing drawing(low, high, 0.0);
  for (const planner::CcPiece& piece : picture.result.path.pieces) {
    Polyline line;
    for (const planner::CcPoint& p : piece.points) line.push_back(from_above(p.point_P_mm));
    drawing.line(line, "stroke=\"#bbb\" stroke-width=\"1\"");
  }
  draw_coloured(picture, drawing);
  const auto topology = geometry::MeshTopology::build(picture.surface);
  if (!topology) return false;
  for (const geometry::BoundaryLoop& loop : topology->boundary_loops()) {
    Polyline line;
    for (geometry::Index v : loop.vertices)
      line.push_back(from_above(picture.surface.vertices_mm[static_cast<std::size_t>(v)]));
    line.push_back(line.front());
    drawing.line(line, "stroke=\"#000\" stroke-width=\"3\"");
  }
  for (const auto& bridge : picture.result.map.bridges_P) {
    Polyline line;
    for (const Vec3& p : bridge) line.push_back(from_above(p));
    drawing.line(line, "stroke=\"#000\" stroke-width=\"4\" stroke-dasharray=\"12 8\"");
  }
  drawing.text(margin_px, 0, caption(picture));
  // Turns of `even` differ by more than one across a floating hole: its scallops are measured, not told from turns.
  const bool even = picture.result.report.method == "even";
  drawing.text(margin_px, 1,
               even ? "distance to the next turn by number (another may lie between; grey: none has it) over the allowed one:"
                    : "distance to the next turn over the allowed one:");
  for (std::size_t k = 0; k < shades.size(); ++k) {
    const double x = margin_px + 260.0 * static_cast<double>(k);
    drawing.swatch(x, 2, shades[k].colour);
    const bool too_wide = k + 1 == shades.size() && !even;
    drawing.text(x + 48.0, 2, too_wide ? "over 1.05: scallop too high" : shades[k].label);
  }
  return drawing.write(file);
}

bool draw_map(const PathPicture& picture, const std::filesystem::path& file) {
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Vec2& v : picture.result.map.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  Drawing drawing(low, high, 0.5);
  drawing.line({low, {high.x(), low.y()}, high, {low.x(), high.y()}, low}, "stroke=\"#000\" stroke-width=\"3\"");
  for (const Polyline& line : picture.result.map.guide_lines)
    drawing.line(line, "stroke=\"#4575b4\" stroke-width=\"1.6\"");
  drawing.text(margin_px, 0, picture.name + ": guide lines in the map");
  drawing.text(margin_px, 1,
               "below: outer boundary; above: holes and the bridges between them; left and right: the seam");
  return drawing.write(file);
}

}  // namespace

bool write_pictures(const PathPicture& picture, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!draw_path(picture, folder / (picture.name + ".svg"))) return false;
  return picture.result.map.guide_lines.empty() || draw_map(picture, folder / (picture.name + "-map.svg"));
}

}  // namespace volute::bench
