// A medium in the page of a run and in a picture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "book/png.hpp"
#include "book/program.hpp"
#include "book/svg.hpp"
#include "program/pictures/played_medium.hpp"

namespace actio::scene {
namespace {

constexpr int colours = 64;

/// Colours from the lowest to the highest, as even to the eye as those of viridis, whose corners these are.
std::array<double, 3> colour(int k) {
  constexpr int corners[][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  double const at = 4.0 * k / (colours - 1);
  int const first = std::min(3, static_cast<int>(at));
  std::array<double, 3> rgb;
  for (std::size_t i = 0; i < 3; ++i)
    rgb[i] = corners[first][i] + (at - first) * (corners[first + 1][i] - corners[first][i]);
  return rgb;
}
std::string text_of(std::array<double, 3> const& rgb) {
  auto const byte = [&](std::size_t i) { return static_cast<int>(std::lround(rgb[i])); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2));
}

/// Where a number lies between two others, from 0 to `most`; the middle where these are the same.
long step_between(double low, double high, double x, long most) {
  return high > low ? std::clamp(std::lround((x - low) / (high - low) * static_cast<double>(most)), 0L, most)
                    : most / 2;
}

/// Numbers of two bytes, the lower first.
template <class Numbers>
void append_short(std::string& out, Numbers const& numbers) {
  for (auto const x : numbers) out += static_cast<char>(x & 255), out += static_cast<char>(x >> 8 & 255);
}

using Point3 = PlayedMedium::Point;

/// How a point of a medium is looked at: to the right, upwards, and towards the eye. In the plane as it is,
/// in space from the front, the right and above.
Point3 looked_at(int dimension, Point3 const& p) {
  if (dimension == 2) return p;
  static double const c = std::cos(0.6), s = std::sin(0.6), up = std::cos(0.42), over = std::sin(0.42);
  double const right = c * p[0] + s * p[1], back = c * p[1] - s * p[0];
  return {right, up * p[2] + over * back, over * p[2] - up * back};
}

/// A point of a picture, in tenths of a pixel.
std::array<long, 2> in_tenths(Point3 const& p, book::svg::Point at, double scale) {
  return {std::lround(10 * (at.x + scale * p[0])), std::lround(10 * (at.y - scale * p[1]))};
}
std::string tenths(long n) { return book::svg::pixel(0.1 * static_cast<double>(n)); }

/// The faces of one frame as paths, each of one colour: in the plane those of a colour together, in space
/// from the back to the front, darker where they look away from the light.
class FramePicture {
 public:
  FramePicture(PlayedMedium const& medium, PlayedMedium::Field const& field, std::size_t frame)
      : medium_(medium), field_(field), frame_(frame), low_(field.lowest()), high_(field.highest()) {
    for (auto const& place : medium.places[frame]) seen_.push_back(looked_at(medium.dimension, place));
  }
  /// @param at     pixels of the origin
  /// @param scale  pixels for a length
  std::string svg(book::svg::Point at, double scale) const {
    std::string out;
    if (medium_.dimension == 3) {
      for (auto const& [depth, f] : from_the_back()) out += path(shaded(f), face(f, at, scale));
      return out;
    }
    std::vector<std::string> of_colour(colours);
    for (std::size_t f = 0; f < medium_.faces.size(); ++f)
      of_colour[static_cast<std::size_t>(colour_of(f))] += face(f, at, scale);
    for (int k = 0; k < colours; ++k)
      if (auto const& faces = of_colour[static_cast<std::size_t>(k)]; !faces.empty())
        out += path(text_of(colour(k)), faces);
    return out;
  }

 private:
  static std::string path(std::string const& fill, std::string const& d) {
    return fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\".7\" d=\"{1}\"/>\n", fill, d);
  }
  Point3 const& corner(std::size_t f, std::size_t k) const {
    return seen_[static_cast<std::size_t>(medium_.faces[f][k])];
  }
  int colour_of(std::size_t f) const {
    return static_cast<int>(step_between(low_, high_, field_.values[frame_][f], colours - 1));
  }
  std::string face(std::size_t f, book::svg::Point at, double scale) const {
    std::string out;
    std::array<long, 2> last{};
    for (std::size_t k = 0; k < 4; ++k) {
      if (k > 0 && medium_.faces[f][k] == medium_.faces[f][k - 1]) continue;
      std::array<long, 2> const p = in_tenths(corner(f, k), at, scale);
      out += k == 0 ? "M" + tenths(p[0]) + " " + tenths(p[1])
                    : (k == 1 ? "l" : " ") + tenths(p[0] - last[0]) + " " + tenths(p[1] - last[1]);
      last = p;
    }
    return out + "z";
  }
  /// Normal to a face, of no particular length.
  Point3 normal(std::size_t f) const {
    Point3 const &a = corner(f, 0), &b = corner(f, 1), &c = corner(f, 2), &d = corner(f, 3);
    Point3 const u{c[0] - a[0], c[1] - a[1], c[2] - a[2]}, v{d[0] - b[0], d[1] - b[1], d[2] - b[2]};
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  /// Those that look at the eye.
  std::vector<std::pair<double, std::size_t>> from_the_back() const {
    std::vector<std::pair<double, std::size_t>> out;
    for (std::size_t f = 0; f < medium_.faces.size(); ++f)
      if (normal(f)[2] > 0)
        out.emplace_back(corner(f, 0)[2] + corner(f, 1)[2] + corner(f, 2)[2] + corner(f, 3)[2], f);
    std::sort(out.begin(), out.end());
    return out;
  }
  std::string shaded(std::size_t f) const {
    Point3 const n = normal(f);
    double const length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    double const lit = length > 0 ? std::max(0.0, (-0.4 * n[0] + 0.6 * n[1] + 0.7 * n[2]) / length) : 0;
    auto rgb = colour(colour_of(f));
    for (double& x : rgb) x *= 0.6 + 0.4 * std::min(1.0, lit);
    return text_of(rgb);
  }

  PlayedMedium const& medium_;
  PlayedMedium::Field const& field_;
  std::size_t frame_;
  double low_, high_;
  std::vector<Point3> seen_;
};

/// The outline of a frame as a path; pieces that follow one another are joined.
std::string outline_of(PlayedMedium const& medium, std::size_t frame, book::svg::Point at, double scale) {
  auto const point = [&](int k) {
    return in_tenths(looked_at(medium.dimension, medium.places[frame][static_cast<std::size_t>(k)]), at,
                     scale);
  };
  std::multimap<int, int> next;
  for (auto const& [a, b] : medium.outline) next.emplace(a, b);
  std::string out;
  while (!next.empty()) {
    int at_point = next.begin()->first;
    std::array<long, 2> last = point(at_point);
    out += "M" + tenths(last[0]) + " " + tenths(last[1]);
    for (auto found = next.find(at_point); found != next.end(); found = next.find(at_point)) {
      at_point = found->second;
      next.erase(found);
      std::array<long, 2> const p = point(at_point);
      out += "l" + tenths(p[0] - last[0]) + " " + tenths(p[1] - last[1]);
      last = p;
    }
  }
  return out;
}
/// The box of all frames, as they are looked at.
struct SeenBox {
  double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;
  explicit SeenBox(PlayedMedium const& medium) {
    for (auto const& frame : medium.places)
      for (auto const& place : frame) {
        Point3 const p = looked_at(medium.dimension, place);
        left = std::min(left, p[0]), right = std::max(right, p[0]);
        bottom = std::min(bottom, p[1]), top = std::max(top, p[1]);
      }
  }
};
/// The first field that varies; the first of all where none does.
PlayedMedium::Field const& varying_field(PlayedMedium const& medium) {
  for (auto const& field : medium.fields)
    if (field.highest() > field.lowest()) return field;
  return medium.fields.front();
}

std::string in_base64(std::string const& bytes) { return "\"" + book::base64(bytes) + "\""; }

std::string field_json(PlayedMedium::Field const& field) {
  double const low = field.lowest(), high = field.highest();
  std::string bytes;
  for (auto const& frame : field.values)
    for (double const x : frame) bytes += static_cast<char>(step_between(low, high, x, 255));
  return fmt::format("{{\"name\":\"{}\",\"low\":{},\"high\":{},\"values\":{}}}", field.name, low, high,
                     in_base64(bytes));
}

}  // namespace

std::string medium_json(PlayedMedium const& medium) {
  if (medium.times.size() < 2) return "null";
  auto const [lower, upper] = medium.box();
  auto const dimension = static_cast<std::size_t>(medium.dimension);
  std::string faces, outline, places, fields, palette;
  for (auto const& face : medium.faces) append_short(faces, face);
  for (auto const& piece : medium.outline) append_short(outline, piece);
  for (auto const& frame : medium.places)
    for (auto const& place : frame) {
      std::array<long, 3> steps;
      for (std::size_t a = 0; a < 3; ++a) steps[a] = step_between(lower[a], upper[a], place[a], 65535);
      append_short(places, std::span(steps).first(dimension));
    }
  for (auto const& field : medium.fields) fields += (fields.empty() ? "" : ",\n") + field_json(field);
  for (int k = 0; k < colours; ++k) palette += (k ? ",\"" : "\"") + text_of(colour(k)) + "\"";
  return fmt::format(
      "{{\"dimension\":{},\"times\":[{}],\"of\":{},\"cells\":{},\"of_cells\":{},\"points\":{},"
      "\"lower\":[{}],\"upper\":[{}],\n\"faces\":{},\n\"outline\":{},\n\"places\":{},\n\"fields\":[{}],"
      "\n\"palette\":[{}]}}",
      medium.dimension, fmt::join(medium.times, ","), medium.snapshots, medium.faces.size(), medium.cells,
      medium.places[0].size(), fmt::join(lower, ","), fmt::join(upper, ","), in_base64(faces),
      in_base64(outline), in_base64(places), fields, palette);
}

std::string medium_picture(PlayedMedium const& medium, double width, std::string const& unit) {
  if (medium.times.empty()) return "";
  auto const& field = varying_field(medium);
  // About a megabyte and a half of paths.
  std::size_t const bytes = 40 * medium.faces.size(), most = std::clamp<std::size_t>(1'500'000 / bytes, 2, 6),
                    frames = std::min(most, medium.times.size());
  auto const [left, right, bottom, top] = SeenBox(medium);  // all frames in the same box
  double const gap = 16, one = frames > 1 ? (width - 3 * gap) / 2 : width - 2 * gap;
  double const scale = std::min(one / (right - left), one / (top - bottom));
  double const height = scale * (top - bottom), line = height + 34;
  std::string elements;
  for (std::size_t k = 0; k < frames; ++k) {
    std::size_t const frame =
        frames > 1 ? (k * (medium.times.size() - 1) + (frames - 1) / 2) / (frames - 1) : 0;
    double const x = gap + static_cast<double>(k % 2) * (one + gap), y = static_cast<double>(k / 2) * line;
    elements += book::svg::label(
        {x, y + 14}, fmt::format("t = {:.6g}", medium.times[frame]) + (unit.empty() ? "" : " " + unit));
    elements += FramePicture(medium, field, frame)
                    .svg({x + 0.5 * (one - scale * (left + right)), y + 22 + scale * top}, scale);
  }
  double const below = std::ceil(static_cast<double>(frames) / 2) * line, from = width / 2 - 130;
  for (int k = 0; k < colours; ++k)
    elements += fmt::format("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"4.4\" height=\"10\" fill=\"{}\"/>\n",
                            from + 260.0 / colours * k, below, text_of(colour(k)));
  elements += book::svg::label({from, below + 24}, book::number(field.lowest(), 4), "middle");
  elements += book::svg::label({from + 130, below + 24}, field.name, "middle");
  elements += book::svg::label({from + 260, below + 24}, book::number(field.highest(), 4), "middle");
  return book::svg::picture(width, below + 34, elements);
}

std::string medium_film(PlayedMedium const& medium, double width, std::string const& title) {
  constexpr std::size_t most_bytes = 500'000, least_frames = 8, most_frames = 120;
  std::size_t const bytes = 32 * medium.faces.size(),
                    frames = std::min({most_bytes / bytes, most_frames, medium.times.size()});
  if (frames < least_frames) return "";
  auto const& field = varying_field(medium);
  auto const [left, right, bottom, top] = SeenBox(medium);
  double const margin = 14, scale = (width - 2 * margin) / (right - left),
               height = scale * (top - bottom) + 2 * margin + 34, seconds = 8;
  book::svg::Point const at{margin - scale * left, margin + scale * top};
  std::string trace, moving;
  for (std::size_t k = 0; k < frames; ++k) {
    std::size_t const frame = (k * (medium.times.size() - 1) + (frames - 1) / 2) / (frames - 1);
    std::string const outline = outline_of(medium, frame, at, scale);
    if (k % std::max<std::size_t>(1, frames / 6) == 0)
      trace += "<path class=\"trace\" d=\"" + outline + "\"/>\n";
    moving += fmt::format(
        "<g class=\"frame{}\" style=\"animation-delay:{:.3f}s\">\n{}<path class=\"outline\" d=\"{}\"/></g>\n",
        k == 0 ? " first" : "", seconds * static_cast<double>(k) / static_cast<double>(frames),
        FramePicture(medium, field, frame).svg(at, scale), outline);
  }
  std::string bar;
  double const from = width / 2 - 130, below = height - 32;
  for (int k = 0; k < colours; ++k)
    bar += fmt::format("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"4.4\" height=\"8\" fill=\"{}\"/>\n",
                       from + 260.0 / colours * k, below, text_of(colour(k)));
  std::array<std::string, 3> const texts{book::number(field.lowest(), 3), field.name,
                                         book::number(field.highest(), 3)};
  for (std::size_t k = 0; k < 3; ++k)
    bar += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", from + 130.0 * static_cast<double>(k),
                       below + 22, book::svg::escape(texts[k]));
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" "
      "text-anchor=\"middle\">\n<title>{2}</title>\n"
      "<style>text{{fill:#5c6670}}.trace{{fill:none;stroke:#8a939c;stroke-width:.8;opacity:.55}}"
      ".outline{{fill:none;stroke:#22272d;stroke-width:1}}"
      "@media(prefers-color-scheme:dark){{text{{fill:#98a1aa}}.outline{{stroke:#d8dbde}}}}"
      ".frame{{visibility:hidden;animation:film {3}s step-end infinite}}"
      "@keyframes film{{0%{{visibility:visible}}{4:.3f}%{{visibility:hidden}}}}"
      "@media(prefers-reduced-motion:reduce){{.frame{{animation:none}}.first{{visibility:visible}}}}"
      "</style>\n"
      "{5}{6}{7}</svg>\n",
      width, height, book::svg::escape(title), seconds, 100.0 / static_cast<double>(frames), trace, moving,
      bar);
}

}  // namespace actio::scene
