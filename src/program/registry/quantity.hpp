// Quantities on demand: what a system can tell of its state, and what each of it needs.
//
//     attitude --.                        body_momentum --> angular_velocity --> energy
//                 `--> spatial_momentum <--'           `--> casimir
//
// A run evaluates what lies under the request, and nothing else.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "program/base/checkpoint_stream.hpp"

namespace actio::scene {

/// A quantity of a system, as `actio show` and the book tell it.
struct Quantity {
  /// What its numbers are.
  enum class Kind {
    scalar,      ///< one number
    vector,      ///< three components
    quaternion,  ///< four components, the scalar part first
    matrix,      ///< n by n, row by row
    skew,        ///< the upper triangle of a skew matrix, row by row
    list         ///< any number of numbers
  };

  /// How the page of a run shows it besides its curves.
  enum class Shown {
    by_curves,      ///< not otherwise
    beside_motion,  ///< it is in the rows that the motion is played from
    as_direction,   ///< likewise; and from one of these rows to the next it turns by no more than 30 degrees
    by_planes,      ///< of a skew matrix, each component in the cell of its plane
    as_trajectory,  ///< as a direction, and as the curve that it runs through in the space of its components
    on_sphere,      ///< likewise, where that curve lies on a sphere
    as_rotation,    ///< of a rotation matrix, as a frame whose axes turn by no more than 30 degrees
    as_motion       ///< likewise, of a rotation R and a place x as ((R, x), (0, 1))
  };

  std::string name;                ///< as scenes write it
  Kind kind;                       ///< what its numbers are
  std::string meaning;             ///< one sentence
  std::string formula;             ///< TeX
  std::string unit;                ///< in words: "energy x time"
  std::string statement = "";      ///< of the thesis; may be empty
  Shown shown = Shown::by_curves;  ///< besides its curves
  /// other quantities of the system that it is computed from; none: the state
  std::vector<std::string> needs = {};
  /// whether the motion keeps it, so that its drift is an error: as conservation.hpp has it
  bool conserved = false;

  /// The same, computed from these.
  Quantity from(std::vector<std::string> others) const {
    Quantity out = *this;
    out.needs = std::move(others);
    return out;
  }
};

/// What the numbers of a kind are, in words: "scalar", "skew matrix".
char const* kind_name(Quantity::Kind kind);

/// One quantity of a row, with the names of its columns.
struct ColumnGroup {
  Quantity quantity;                 ///< whose columns they are
  std::vector<std::string> columns;  ///< their names, in the order of the row

  /// Of the value: nothing for a number, n by n for a matrix, otherwise as many as there are columns.
  std::vector<std::size_t> shape() const;
};

/// Ends of the names of columns: `_x`, `_w`, and for matrices of n rows `_11 _12 ...`, indices apart where
/// one of them has two digits, `_1_10`.
std::vector<std::string> column_ends(Quantity::Kind kind, int n = 3);
/// `_first, ..., _last`, the numbers `apart` from each other.
std::vector<std::string> numbered(int first, int last, int apart = 1);

/// The quantities of one run.
class QuantityGraph {
 public:
  /// Writes the value, from those of what the quantity needs, in the order of `needs`.
  using Evaluate = std::function<void(std::span<double const* const> needs, double* value)>;
  /// What the drift of a conserved quantity is to be compared with where the quantity itself may be near
  /// zero, as an energy is where its parts cancel.
  struct Unit {
    double terms = 0,  ///< the moduli of what it is made of, added up; 0: its own modulus
        rounding = 0,  ///< terms up to this size are rounding, and the system is at rest
        at_rest = 0;   ///< the unit then: what the quantity is where the system moves at its own pace
    Unit() = default;  ///< no terms
    /// Terms that are never rounding alone.
    Unit(double of_terms) : terms(of_terms) {}  // NOLINT(google-explicit-constructor)
    /// With the unit at rest.
    Unit(double of_terms, double from_rounding, double of_rest)
        : terms(of_terms), rounding(from_rounding), at_rest(of_rest) {}
  };
  /// The unit of a conserved quantity now. Of a list, that of one of its numbers.
  using NaturalUnit =
      std::function<Unit(std::span<double const* const> needs, double const* value, std::size_t component)>;

  /// How often a quantity was evaluated.
  struct Count {
    std::string name;  ///< of the quantity
    bool asked;        ///< whether the rows hold it
    long evaluations;  ///< of the run so far
  };

  /// @param known  of the system, each after what it needs
  explicit QuantityGraph(std::vector<Quantity> known);
  /// Nodes are looked at by pointers, which moving keeps and copying would not.
  QuantityGraph(QuantityGraph&&) = default;
  QuantityGraph& operator=(QuantityGraph&&) = default;  ///< moves as well

  /// How a quantity comes from what it needs; `ends` name its columns.
  /// @param unit  of a conserved quantity; left out: its own modulus
  void define(std::string const& name, std::vector<std::string> ends, Evaluate evaluate,
              NaturalUnit unit = {});
  /// Says which quantities the motion conserves.
  void conserve(std::function<bool(std::string const& name)> const& conserved);
  /// What the rows hold, in this order. Once, before anything is evaluated.
  void ask(std::vector<std::string> const& names);

  /// The quantities of the system, asked for or not.
  std::vector<Quantity> known() const;
  /// Whether a quantity was asked for, or something that needs it.
  bool needed(std::string const& name) const;
  /// Names of the columns of a row, without the time.
  std::vector<std::string> columns() const;
  /// The same, quantity by quantity.
  std::vector<ColumnGroup> column_groups() const;
  /// How many numbers a row has, without the time.
  std::size_t row_size() const { return row_size_; }
  /// Evaluates what is needed for a row, each quantity once.
  void evaluate(std::span<double> row);
  /// For each quantity of the system, in its order.
  std::vector<Count> counts() const;
  /// Saves, or restores, how often each was evaluated.
  void remember(CheckpointStream& stream);

  /// Columns of a row that hold one conserved quantity: drift is measured over all of them together, for a
  /// list one by one.
  struct Conserved {
    std::string name;   ///< of the quantity; of a list, with the end of the column
    std::size_t first,  ///< its first column in a row without the time
        size;           ///< how many columns it has
  };
  /// The conserved quantities that the rows hold.
  std::vector<Conserved> conserved() const;
  /// Their units, in the same order, as of the last evaluation; of no terms where a quantity has none but its
  /// modulus, and an empty list where no quantity has one.
  std::vector<Unit> natural_units() const;

 private:
  struct Node {
    Quantity quantity;
    std::vector<std::string> ends;
    Evaluate evaluate;
    NaturalUnit unit;
    std::vector<double> value;
    std::vector<double const*> needs;
    bool needed = false;
    long evaluations = 0;
  };
  Node& node(std::string const& name);
  Node const& node(std::string const& name) const;
  void require(Node& node);

  std::vector<Node> nodes_;
  std::vector<Node*> asked_, plan_;
  std::size_t row_size_ = 0;
};

}  // namespace actio::scene
