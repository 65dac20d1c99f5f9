// Records and judgements of a claim: what does not depend on its scalar.
#include "claim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace actio::checks {

namespace {

/// Least squares of log error against log step, and the largest distance of a local slope from the fitted
/// one.
std::pair<double, double> fit(std::vector<double> const& steps, std::vector<double> const& errors) {
  double n = static_cast<double>(steps.size()), sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    double const x = std::log(steps[i]), y = std::log(errors[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  double const slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  double spread = 0;
  for (std::size_t i = 1; i < steps.size(); ++i)
    spread = std::max(
        spread, std::abs(std::log(errors[i] / errors[i - 1]) / std::log(steps[i] / steps[i - 1]) - slope));
  return {slope, spread};
}
/// `what (model)`, for messages.
std::string at(std::string_view what, std::string_view model) {
  return std::string(what) + " (" + std::string(model) + ")";
}

}  // namespace

AnyClaim::AnyClaim(std::string_view id, std::string_view title, std::string_view scalar, std::uint64_t seed,
                   double epsilon)
    : draw(seed), epsilon_(exact() ? 0 : std::max(epsilon, least_epsilon)) {
  record.id = id, record.title = title, record.scalar = scalar, record.seed = seed;
}

void AnyClaim::holds(std::string_view note) { record.verdict = "holds", record.note = note; }
void AnyClaim::convention(std::string_view note) { record.verdict = "convention", record.note = note; }
void AnyClaim::corrected(std::string_view printed, std::string_view right, std::string_view note) {
  record.verdict = "corrected", record.printed = printed, record.corrected = right, record.note = note;
}
void AnyClaim::scope(std::string_view note) { record.verdict = "scope", record.note = note; }
void AnyClaim::maybe_scan() { record.scan = true; }
void AnyClaim::same_slip_as(std::string_view id) { record.first = id; }
void AnyClaim::leaves(std::string_view sentence) { record.left = sentence; }
void AnyClaim::fail(std::string_view message) { record.failures.emplace_back(message); }

double AnyClaim::degree_of_residual() {
  return current_arithmetic().kind() == ArithmeticKind::prime
             ? std::ldexp(largest_degree(), 2 * std::min(roots_taken(), 100))
             : 0;
}

void AnyClaim::vanishes(std::string_view what, std::string_view model, double relative, double condition,
                        double degree) {
  Evidence& e = entry(what, exact() ? "exact" : "precision", model);
  ++e.points;
  if (!(relative <= e.measured)) e.measured = relative;
  e.epsilon = epsilon_;
  e.bound = exact() ? 0 : std::max(e.bound, rounding * condition * e.epsilon);
  if (exact()) {
    bool const field = current_arithmetic().kind() == ArithmeticKind::prime;
    if (!field && degrees)
      if (auto const known = degrees->find(at(what, model)); known != degrees->end()) degree = known->second;
    e.degree = std::max(e.degree, degree);
    // Numbers are drawn from all of the field, and from 129 fractions. A residual that no draw enters is of
    // degree 0: it is 0 or it is not.
    double const drawn_from = field ? static_cast<double>(current_arithmetic().modulus()) : 129;
    double const once = field || e.degree > 0 ? std::min(1.0, e.degree / drawn_from) : 1;
    e.probability = e.degree > 0 ? std::max(std::pow(once, e.points), std::numeric_limits<double>::min()) : 0;
  }
  if (!(relative <= e.bound))
    fail(at(what, model) + ": residual " + show(relative) + " of its terms, bound " + show(e.bound));
}

void AnyClaim::stays(std::string_view what, std::string_view model, double relative, double floor) {
  Control& c = control_entry(what, model, relative, floor);
  ++c.points, c.draws.push_back(relative);
  if (!std::isnan(c.measured) && !(relative <= c.measured)) c.measured = relative;
}

void AnyClaim::order(std::string_view what, std::string_view model, std::vector<double> const& steps,
                     std::vector<double> const& errors, double expected, double tolerance) {
  auto const [slope, spread] = fit(steps, errors);
  Evidence& e = entry(what, "order", model);
  e.steps = steps, e.errors = errors, e.slope = slope, e.spread = spread;
  e.measured = std::abs(slope - expected), e.bound = tolerance, e.points = static_cast<int>(e.steps.size());
  if (e.steps.size() < 6) fail(at(what, model) + ": an order needs five refinements");
  if (!(e.measured <= tolerance))
    fail(at(what, model) + ": order " + show(slope) + ", claimed " + show(expected));
}
void AnyClaim::refutes_order(std::string_view what, std::string_view model, std::vector<double> const& steps,
                             std::vector<double> const& errors, double claimed) {
  double const shortfall = claimed - fit(steps, errors).first;
  Control& c = control_entry(what, model, shortfall, 0.5);
  c.measured = shortfall, c.draws.push_back(shortfall), ++c.points;
}

void AnyClaim::fact(std::string_view what, std::string_view model, bool truth) {
  Evidence& e = entry(what, exact() ? "exact" : "precision", model);
  ++e.points;
  e.degree = 0;
  if (!truth) e.measured = 1, fail(at(what, model) + ": not so");
}
void AnyClaim::refused(std::string_view what, std::string_view model, bool truth) {
  Control& c = control_entry(what, model, 0, 0.5);
  ++c.points, c.draws.push_back(truth);
  if (truth)
    c.measured = 1;
  else
    fail("control '" + std::string(what) + "' (" + std::string(model) + "): nothing was refused");
}
void AnyClaim::enclosed(std::string_view what, std::string_view model, Enclosure const& found, bool claimed) {
  if (!claimed) {
    std::string const how = found.shown ? "" : found.refuted ? ", decided false" : ", not decided";
    Control& c = control_entry(std::string(what) + how, model, found.shown ? 0 : 1, 0.5);
    c.scalar = "ball", c.points = found.boxes;
    return;
  }
  Evidence& e = entry(what, "enclosure", model);
  e.scalar = "ball", e.margin = found.margin, e.points = found.boxes, e.measured = found.shown ? 0 : 1;
  if (!found.shown)
    fail(at(what, model) + ": balls do not decide it on the whole set, " + std::to_string(found.boxes) +
         " boxes, margin " + show(found.margin));
}

void AnyClaim::judge_controls() {
  for (Control& c : record.control) {
    if (c.draws.empty() || std::isnan(c.measured)) c.draws = {c.measured};
    auto const middle = c.draws.begin() + static_cast<std::ptrdiff_t>((c.draws.size() - 1) / 2);
    std::nth_element(c.draws.begin(), middle, c.draws.end());
    c.median = *middle;
  }
  for (Control const& c : record.control)
    if (!(c.measured > c.floor))
      fail("control '" + c.what + "' (" + c.model + "): " + show(c.measured) + " passes, floor " +
           show(c.floor));
}

Evidence& AnyClaim::entry(std::string_view what, std::string_view kind, std::string_view model) {
  for (Evidence& e : record.evidence)
    if (e.what == what && e.model == model && e.kind == kind) return e;
  return record.evidence.emplace_back(Evidence{.what = std::string(what),
                                               .kind = std::string(kind),
                                               .scalar = record.scalar,
                                               .model = std::string(model),
                                               .steps = {},
                                               .errors = {}});
}
Control& AnyClaim::control_entry(std::string_view what, std::string_view model, double measured,
                                 double floor) {
  for (Control& c : record.control)
    if (c.what == what && c.model == model) return c;
  return record.control.emplace_back(Control{.what = std::string(what),
                                             .scalar = record.scalar,
                                             .model = std::string(model),
                                             .measured = measured,
                                             .floor = floor,
                                             .draws = {}});
}

}  // namespace actio::checks
