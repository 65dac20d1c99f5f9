#include "program/catalogue/groups.hpp"

#include <cctype>

namespace actio::scene {
namespace {

/// Letters and digits alone, small.
std::string plain(std::string_view word) {
  std::string out;
  for (unsigned char const c : word)
    if (std::isalnum(c) || c == '_') out += static_cast<char>(std::tolower(c));
  return out;
}
bool ends_in_digit(std::string const& word) {
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word.back()));
}
/// Without the number at the end: `so` from `so3` and from `son`, `sp` from `sp2n`.
std::string stem(std::string word) {
  if (!word.empty() && word.back() == 'n') word.pop_back();
  while (ends_in_digit(word)) word.pop_back();
  return word;
}

}  // namespace

std::vector<LibraryGroup> const& library_groups() {
  static std::string const folder = "actio/groups/";
  static std::vector<LibraryGroup> const groups{
      {"R^n", "n", "Translations of n-space: the abelian group.", "the vector itself",
       "actio::Translations<n>", folder + "unipotent_groups.hpp", "eq_3_19"},
      {"SO(n)", "n (n - 1) / 2", "Rotations of n-space.",
       "n = 2: the angle; n = 3: the rotation vector; n > 3: the entries above the diagonal, row by row",
       "actio::SO<n>", folder + "rotations.hpp", "thm_5_2_1"},
      {"SE(2)", "3", "Rigid motions of the plane.", "the angle, then the translation", "actio::SE<2>",
       folder + "motions.hpp", "eq_3_19"},
      {"SE(3)", "6", "Rigid motions of space.", "those of the rotation, then the translation", "actio::SE<3>",
       folder + "motions.hpp", "eq_3_19"},
      {"GL(n)", "n^2", "Invertible matrices, the component of the identity.", "the entries, row by row",
       "actio::GL<n>", folder + "linear_groups.hpp", "eq_3_19"},
      {"SL(n)", "n^2 - 1", "Matrices of determinant 1.",
       "those of E_kk - E_(k+1)(k+1), then the entries off the diagonal, row by row", "actio::SL<n>",
       folder + "special_linear.hpp", "eq_3_19"},
      {"U(n)", "n^2", "Unitary matrices A + iB, as real matrices ((A, -B), (B, A)).",
       "the phases on the diagonal, then (x, y) of each entry x + iy above it, row by row", "actio::U<n>",
       folder + "unitary_groups.hpp", "eq_3_19"},
      {"SU(2)", "3", "Unit quaternions, the double cover of SO(3).", "those of SO(3)", "actio::SU2",
       folder + "unit_quaternions.hpp", "eq_3_19"},
      {"SU(n)", "n^2 - 1", "Unitary matrices of determinant 1.",
       "those of i(E_kk - E_(k+1)(k+1)), then (x, y) as in U(n)", "actio::SU<n>",
       folder + "unitary_groups.hpp", "eq_3_19"},
      {"Sp(2n)", "n (2n + 1)", "Real matrices that preserve the symplectic form.",
       "of ((P, Q), (R, -P^T)): P row by row, then the upper triangles of Q and of R", "actio::Sp<2 * n>",
       folder + "symplectic_groups.hpp", "eq_3_19"},
      {"Aff(1)", "2", "Maps x -> ax + b of the line with a > 0.", "rate of stretching, rate of shifting",
       "actio::Aff1", folder + "affine_line.hpp", "eq_3_19"},
      {"Heisenberg", "3", "Upper triangular 3 by 3 matrices with ones on the diagonal.",
       "(x, y, z) with z in the corner", "actio::Heisenberg", folder + "unipotent_groups.hpp", "eq_3_19"},
      {"direct_product", "dim G + dim H", "G x H: pairs of elements of two of these groups.",
       "those of G, then those of H", "actio::DirectProduct<G, H>", folder + "direct_product.hpp", "eq_3_19"},
      {"semidirect_product", "dim G + n",
       "G |x R^n: a group of n by n matrices with the translations of the space it acts on.",
       "those of G, then the translation", "actio::SemidirectProduct<G>", folder + "semidirect_product.hpp",
       "eq_3_19"},
      {"spanned_group", "size of the basis",
       "Any group of matrices, from a basis of its algebra in whole numbers.", "the basis as it was given",
       "actio::SpannedGroup", folder + "spanned_group.hpp", "eq_3_19"},
  };
  return groups;
}

std::vector<LibraryGroup const*> find_groups(std::string_view word) {
  std::vector<LibraryGroup const*> exact, family, all;
  std::string const wanted = plain(word);
  for (auto const& group : library_groups()) {
    std::string const name = plain(group.name);
    if (name == wanted) exact.push_back(&group);
    if (wanted.empty() || stem(name) != stem(wanted) || stem(name) == name) continue;
    if (name.back() == 'n') family.push_back(&group);
    all.push_back(&group);
  }
  if (!exact.empty()) return exact;
  if (ends_in_digit(wanted)) return family;
  return all;
}

}  // namespace actio::scene
