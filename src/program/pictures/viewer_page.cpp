// The page of a run: a template that the program carries, and the run as JSON inside it.
#include <Eigen/Core>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "book/svg.hpp"
#include "program/base/embedded.hpp"
#include "program/base/printable.hpp"
#include "program/catalogue/body_shape.hpp"
#include "program/pictures/pictures.hpp"
#include "program/registry/units.hpp"

namespace actio::scene {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers as a JSON list, with as many digits as show a hundred-thousandth of their range.
std::string numbers(std::vector<double> const& values, int least_digits = 6) {
  double largest = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (double const x : values)
    if (std::isfinite(x))
      largest = std::max(largest, std::abs(x)), low = std::min(low, x), high = std::max(high, x);
  // Of values that are all the same, every digit.
  int const digits = high > low
                         ? static_cast<int>(std::clamp(6 + std::ceil(std::log10(largest / (high - low))),
                                                       double(least_digits), 17.0))
                         : 17;
  std::string out = "[";
  for (double const x : values)
    out += std::isfinite(x) ? fmt::format("{}{:.{}g}", out.size() > 1 ? "," : "", x, digits)
                            : std::string(out.size() > 1 ? ",null" : "null");
  return out + "]";
}

template <class Value>
std::string each(Envelope const& envelope, Value const& value, int least_digits = 6) {
  std::vector<double> out;
  for (auto const& piece : envelope.pieces()) out.push_back(value(piece));
  return numbers(out, least_digits);
}

/// The curve itself where every row is there, otherwise the band that it lies in.
std::string values(Envelope const& envelope) {
  auto const low = [](auto const& p) { return p.low.value; };
  if (envelope.rows_per_piece() == 1) return "{\"value\":" + each(envelope, low) + "}";
  return "{\"low\":" + each(envelope, low) +
         ",\"high\":" + each(envelope, [](auto const& p) { return p.high.value; }) + "}";
}

std::string curves(Scene const& scene, Overview const& overview) {
  std::string out;
  for (auto const& drawn : overview.quantities) {
    Json head{{"name", drawn.quantity.name},
              {"words", words(drawn.quantity.name)},
              {"meaning", drawn.quantity.meaning},
              {"kind", kind_name(drawn.quantity.kind)},
              {"unit", unit_of(scene, drawn.quantity)},
              {"of", drawn.size}};
    std::string components;
    for (std::size_t i = 0; i < drawn.components.size(); ++i) {
      std::string const label = drawn.ends[i].empty() ? "" : drawn.ends[i].substr(1);
      components += (i ? "," : "") + fmt::format("{{\"label\":{},\"curve\":{}}}", Json(label).dump(),
                                                 values(drawn.components[i]));
    }
    std::string text = head.dump();
    text.pop_back();
    out += (out.empty() ? "" : ",\n") + text + ",\"components\":[" + components + "]}";
  }
  return "[" + out + "]";
}

std::string drifts(Overview const& overview) {
  std::string out;
  for (auto const& d : overview.drifts) {
    std::vector<double> relative;
    for (auto const& piece : d.difference.pieces())
      relative.push_back(d.unit > 0 ? piece.high.value / d.unit : 0);
    out += (out.empty() ? "" : ",\n") + fmt::format("{{\"label\":{},\"curve\":{{\"value\":{}}}}}",
                                                    Json(words(d.name)).dump(), numbers(relative));
  }
  return "[" + out + "]";
}

std::string motion(Overview const& overview) {
  auto const& rows = overview.key_frames.rows();
  std::string columns;
  for (std::size_t i = 0; i <= overview.motion.size(); ++i) {
    std::vector<double> column;
    for (auto const& row : rows) column.push_back(row[i]);
    columns +=
        (i ? ",\n" : "") + Json(i ? overview.motion[i - 1] : "t").dump() + ":" + numbers(column, i ? 6 : 12);
  }
  return fmt::format("{{\"stride\":{},\"beginning_only\":{},\"columns\":{{{}}}}}",
                     overview.key_frames.stride(), overview.key_frames.beginning_only(), columns);
}

Json list(Eigen::Vector3d const& v) { return {v[0], v[1], v[2]}; }

Json axes_and_moments(PrincipalInertia const& of) {
  auto const& [inertia, axes] = of;
  return {{"moments", list(inertia.moments)},
          {"axes", {list(axes.col(0)), list(axes.col(1)), list(axes.col(2))}}};
}

Json body(Scene const& scene) {
  if (!scene.system->shape) return nullptr;
  BodyShape const shape = scene.system->shape(scene.file);
  Json out = axes_and_moments(shape.inertia);
  out["parts"] = Json::array(), out["torqued"] = shape.torqued;
  for (auto const& part : shape.parts)
    out["parts"].push_back({{"cylinder", part.cylinder},
                            {"radius", part.radius},
                            {"length", part.length},
                            {"at", list(part.at)},
                            {"along", list(part.along)}});
  if (shape.top)
    out["top"] = {{"mass", shape.top->mass},
                  {"centre_of_mass", list(shape.top->centre_of_mass)},
                  {"gravity", list(shape.top->gravity)}};
  return out;
}

/// Two bodies; null where the scene is none of such.
Json bodies(Scene const& scene) {
  if (!scene.system->bodies) return nullptr;
  Json out;
  for (auto const& one : scene.system->bodies(scene.file)) {
    out.push_back(axes_and_moments(one.inertia));
    out.back()["mass"] = one.mass, out.back()["radius"] = one.radius;
  }
  return out;
}

/// How the page shows a quantity, in the words of its script; null: by curves.
char const* shown_how(Quantity::Shown shown) {
  constexpr char const* words[] = {nullptr,      "beside", "direction", "planes",
                                   "trajectory", "sphere", "rotation",  "motion"};
  return words[static_cast<std::size_t>(shown)];
}

Json head(Scene const& scene) {
  SceneTable const method = scene.file.section("method");
  Json out{{"title", scene.title},
           {"system", scene.system->title},
           {"meaning", scene.system->meaning},
           {"time_unit", time_unit(scene)},
           {"until", scene.schedule.until()}};
  for (auto const& quantity : scene.simulation.quantities.known())
    if (char const* const how = shown_how(quantity.shown)) out["shown"][quantity.name] = how;
  if (scene.system->snapshots) out["snapshots"] = scene.snapshots.has_value();
  if (SceneTable const system = scene.file.section("system"); system.has("side"))
    out["side"] = system.text("side");
  if (method.has("name") && method.is_text("name")) out["method"] = words(method.text("name"));
  if (method.has("order"))
    out["order"] = method.is_text("order") ? method.text("order") : fmt::format("{}", method.number("order"));
  if (!scene.simulation.exact && std::isfinite(scene.simulation.step)) out["step"] = scene.simulation.step;
  return out;
}

/// The whole run. No text in it can end the element that holds it: every `<` is written as \u003c.
std::string run_json(Scene const& scene, Overview const& overview, std::string const& summary,
                     std::string const& maps, std::string const& medium) {
  Json const told = Json::parse(summary, nullptr, false);
  Envelope const* times = nullptr;
  for (auto const& drawn : overview.quantities)
    if (!drawn.components.empty()) times = &drawn.components[0];
  std::string const t = times ? fmt::format("{{\"rows\":{},\"rows_per_piece\":{},\"from\":{},\"to\":{}}}",
                                            overview.rows, times->rows_per_piece(),
                                            each(
                                                *times, [](auto const& p) { return p.first.t; }, 12),
                                            each(
                                                *times, [](auto const& p) { return p.last.t; }, 12))
                              : std::string("null");
  std::string const json = fmt::format(
      "{{\"scene\":{},\n\"body\":{},\n\"bodies\":{},\n\"summary\":{},\n\"times\":{},\n\"quantities\":{},\n"
      "\"drifts\":{},\n\"motion\":{},\n\"maps\":{},\n\"medium\":{}}}",
      head(scene).dump(), body(scene).dump(), bodies(scene).dump(),
      told.is_discarded() ? "null" : told.dump(), t, curves(scene, overview), drifts(overview),
      motion(overview), maps, medium);
  std::string out;
  for (char const c : json) out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

/// A template with texts in place of its marks; what is put in is not searched for marks again.
std::string filled(std::string_view page,
                   std::vector<std::pair<std::string_view, std::string>> const& marks) {
  std::string out;
  for (auto const& [mark, text] : marks) {
    std::size_t const at = page.find(mark);
    if (at == std::string_view::npos)
      throw std::logic_error("viewer.html: a mark is missing: " + std::string(mark));
    out.append(page.substr(0, at)).append(text);
    page.remove_prefix(at + mark.size());
  }
  return out.append(page);
}

}  // namespace

std::string viewer_page(Scene const& scene, Overview const& overview, std::string const& summary_json,
                        std::string const& maps_json, std::string const& medium_json) {
  std::string script;
  for (auto const piece :
       {embedded::viewer_algebra, embedded::viewer_stage, embedded::viewer_shapes, embedded::viewer_motion,
        embedded::viewer_space, embedded::viewer_pair, embedded::viewer_momentum_sphere,
        embedded::viewer_curves, embedded::viewer_planes, embedded::viewer_box, embedded::viewer_frame_motion,
        embedded::viewer_frame, embedded::viewer_trajectory, embedded::viewer_map, embedded::viewer_medium,
        embedded::viewer_player, embedded::viewer_page})
    script.append(piece);
  return filled(embedded::viewer_html,
                {{"<!-- title -->", book::svg::escape(printable(scene.title))},
                 {"/* style */", std::string(embedded::viewer_css)},
                 {"<!-- run -->", run_json(scene, overview, summary_json, maps_json, medium_json)},
                 {"/* script */", script}});
}

}  // namespace actio::scene
