(** * Legendre maps and Casimir functions of the body

Section 5.3 of the thesis, with the conventions of the file on the body. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed slopes rigid_body body_multipliers moser_veselov body_integrals.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.
(** ** Legendre maps and Casimir functions

Section 5.3. *)

Section Casimirs.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f L M x y v w xi eta theta : 'M[R]_n).
Implicit Types omegas : nat -> 'M[R]_n.

Add Ring laws_for_casimirs : (laws_of_a_ring R).

(** The pairing of coordinates is half of the trace, \f$\tfrac12\mathrm{Tr}(A^TB)\f$: for skew matrices the
sum over the planes, each counted once. It is the pairing of the library.
C++: `actio::pair`, `groups/group.hpp`. *)
Definition coordinate_pairing M x := 2%:R^-1 * pairing M x.

(** ** The Legendre map on the group

For \f$\ell(f) = \mathrm{Tr}(f\Lambda)\f$ and the pairing of coordinates,
\f$L_f^*\,d\ell(f) = f^T\Lambda - \Lambda f\f$ on skew matrices: the momentum before the step. The printed
matrix \f$f\Lambda - \Lambda f^T\f$ is the other translation, \f$-R_f^*\,d\ell(f)\f$. *)
Theorem claim_5_3_group_legendre f L theta :
  (2%:R : R) \is a GRing.unit -> symmetric L -> skew theta ->
  reduced_differential L (left_translation f theta) = coordinate_pairing (f^T *m L - L *m f) theta /\
  reduced_differential L (right_translation f theta) = coordinate_pairing (- (f *m L - L *m f^T)) theta.
Proof.
move=> two L_sym theta_skew; rewrite /coordinate_pairing opprB.
by rewrite pairing_before // pairing_after // !mulKr.
Qed.

(** The function (5.10) on the group, \f$C(f) = \mathrm{Tr}(f\Lambda f\Lambda)\f$.
C++: `actio::trace_casimir`, `rigid_body/casimirs.hpp`. *)
Definition trace_casimir L f := \tr (f *m L *m f *m L).

Lemma trace_of_square f L :
  symmetric L -> orthogonal f ->
  \tr (momentum_before f L *m momentum_before f L) = 2%:R * (trace_casimir L f - \tr (L *m L)).
Proof.
move=> L_sym o; rewrite /momentum_before mulmxBl !mulmxBr !trace_sub !mulmxA.
have -> : \tr (f^T *m L *m f^T *m L) = trace_casimir L f.
  rewrite trace_product_transpose !trmx_mul trmxK L_sym /trace_casimir mxtrace_mulC !mulmxA.
  by rewrite -!mulmxA.
have -> : \tr (f^T *m L *m L *m f) = \tr (L *m L) by rewrite mxtrace_mulC !mulmxA o mul1mx.
have -> : \tr (L *m f *m f^T *m L) = \tr (L *m L) by rewrite (turn_back _ o).
have -> : \tr (L *m f *m L *m f) = trace_casimir L f.
  by rewrite /trace_casimir -!mulmxA mxtrace_mulC !mulmxA.
by calculate_in R.
Qed.

Lemma trace_of_square_after f L :
  orthogonal f ->
  \tr (momentum_after f L *m momentum_after f L) = \tr (momentum_before f L *m momentum_before f L).
Proof.
move=> o; rewrite -!claim_5_2_update_by_conjugation_within_a_step // !mulmxA (turn_forth _ o).
by rewrite mxtrace_mulC !mulmxA (orthogonal_left o) mul1mx.
Qed.

Lemma minus_square f L : symmetric L ->
  coordinate_pairing (momentum_before f L) (momentum_before f L) =
  - (2%:R^-1 * \tr (momentum_before f L *m momentum_before f L)).
Proof.
move=> L_sym; rewrite /coordinate_pairing /pairing (momentum_before_skew f L_sym).
by rewrite mulNmx trace_opposite mulrN.
Qed.

(** ** The Casimir function on the group, (5.10)

For every orthogonal \f$f\f$ and symmetric \f$\Lambda\f$, in any dimension: the square of the length,
\f$\|y\|^2\f$, of the momentum that a Legendre map gives, either of the two, is
\f$\mathrm{Tr}\Lambda^2 - \mathrm{Tr}(f\Lambda f\Lambda)\f$. Up to a constant and the sign that is (5.10). *)
Theorem eq_5_10 f L (before := f^T *m L - L *m f) (printed := f *m L - L *m f^T) :
  (2%:R : R) \is a GRing.unit -> symmetric L -> orthogonal f ->
  coordinate_pairing before before = \tr (L *m L) - trace_casimir L f /\
  coordinate_pairing printed printed = \tr (L *m L) - trace_casimir L f.
Proof.
move=> two L_sym o.
have square : coordinate_pairing before before = \tr (L *m L) - trace_casimir L f.
  by rewrite minus_square // trace_of_square // mulKr // opprB.
split=> //; rewrite -square /coordinate_pairing; congr (_ * _).
have is_after : printed = - momentum_after f L by rewrite opprB.
have turned : momentum_after f L = f *m before *m f^T.
  by rewrite -claim_5_2_update_by_conjugation_within_a_step.
rewrite is_after /pairing transpose_opposite mulNmx mulmxN opprK turned !trmx_mul !trmxK !mulmxA.
by rewrite (turn_forth _ o) mxtrace_mulC !mulmxA (orthogonal_left o) mul1mx.
Qed.

(** ** The value of the pull-back

Of \f$\|y\|^2\f$ it is as above. Of \f$\mathrm{Tr}(\mu^2)\f$, the other form in which section 5.3 gives the
Casimir function, it is \f$2\,C(f) - 2\,\mathrm{Tr}\Lambda^2\f$, over every ring: a factor 2, and no change
of sign. *)
Theorem claim_5_3_pullback_value f L (mu := f *m L - L *m f^T) :
  symmetric L -> orthogonal f -> \tr (mu *m mu) = 2%:R * trace_casimir L f - 2%:R * \tr (L *m L).
Proof.
move=> L_sym o; have -> : mu = - momentum_after f L by rewrite opprB.
by rewrite mulNmx mulmxN opprK trace_of_square_after // trace_of_square // mulrBr.
Qed.

(** ** A motion stays on a level set

The function (5.10) is constant along the relative motions of a body. *)
Theorem claim_5_3_invariant_manifolds_conserved L omegas k :
  (2%:R : R) \is a GRing.unit -> symmetric L -> (forall j, orthogonal (omegas j)) ->
  (forall j, discrete_euler_poincare L (omegas j) (omegas j.+1)) ->
  trace_casimir L (omegas k) = trace_casimir L (omegas 0%N).
Proof.
move=> two L_sym o motion; elim: k => // k <-.
have : \tr (momentum_before (omegas k.+1) L *m momentum_before (omegas k.+1) L) =
       \tr (momentum_before (omegas k) L *m momentum_before (omegas k) L).
  by rewrite [momentum_before (omegas k.+1) L](motion k) trace_of_square_after.
by rewrite !trace_of_square // => /(mulrI two) /addIr.
Qed.

Lemma pairing_of_sums x y v w (t : R) :
  pairing (x + t *: y) (v + t *: w) = pairing x v + t * (pairing x w + pairing y v) + t ^+ 2 * pairing y w.
Proof.
rewrite /pairing transpose_add transpose_scale !(mulmxDl, mulmxDr) -?scalemxAl -?scalemxAr -?scalemxAl.
by rewrite !mxtraceD !mxtraceZ; calculate_in R.
Qed.

(** ** The Legendre map on the algebra

Section 5.3 gives \f$\mu = \partial l/\partial\xi = \mathcal J(\xi)\f$ for the Lagrangian (5.1). With the
pairing of (5.1), \f$\mathrm{Tr}(A^TB)\f$, the derivative is half of that, \f$\tfrac12\mathcal J(\xi)\f$;
with the pairing of coordinates it is \f$\mathcal J(\xi)\f$, but then the factor of (5.1) is \f$\tfrac12\f$.
The matrices \f$\xi\f$ and \f$\eta\f$ need not be skew. *)
Theorem claim_5_3_algebra_legendre L xi eta :
  (2%:R : R) \is a GRing.unit -> symmetric L ->
  slope (fun t => kinetic_energy L (xi + t *: eta)) (pairing (2%:R^-1 *: inertia_operator L xi) eta).
Proof.
move=> two L_sym; exists (kinetic_energy L eta) => t; rewrite scale0r addr0 /kinetic_energy.
have linear : inertia_operator L (xi + t *: eta) = inertia_operator L xi + t *: inertia_operator L eta.
  by rewrite /inertia_operator mulmxDl mulmxDr -scalemxAl -scalemxAr scalerDr; exact: addrACA.
have halves : pairing (2%:R^-1 *: inertia_operator L xi) eta =
    4%:R^-1 * (2%:R * pairing (inertia_operator L xi) eta).
  rewrite /pairing transpose_scale -scalemxAl mxtraceZ (natrM _ 2 2) invrM //.
  by rewrite -mulrA [_^-1 * (2%:R * _)]mulKr.
rewrite halves linear pairing_of_sums (claim_5_0_inertia_operator_symmetric xi eta L_sym).
by rewrite [pairing eta (inertia_operator L xi)]pairing_symmetric /pairing; calculate_in R.
Qed.

Theorem claim_5_3_algebra_legendre_in_coordinates L xi eta :
  (2%:R : R) \is a GRing.unit -> symmetric L ->
  slope (fun t => kinetic_energy L (xi + t *: eta)) (coordinate_pairing (inertia_operator L xi) eta).
Proof.
move=> two L_sym; have := claim_5_3_algebra_legendre xi eta two L_sym.
by rewrite /coordinate_pairing {1}/pairing transpose_scale -scalemxAl mxtraceZ.
Qed.

End Casimirs.

(** ** Not the whole inertia operator

The printed \f$\partial l/\partial\xi = \mathcal J(\xi)\f$, with the pairing \f$\mathrm{Tr}(A^TB)\f$ for
which the factor of (5.1) is right. It already fails at a turning about one axis. *)
Theorem claim_5_3_algebra_legendre_printed_fails :
  ~ (forall L xi eta : 'M[Qc]_3, generalized_body L -> skew xi -> skew eta ->
       slope (fun t => kinetic_energy L (xi + t *: eta)) (pairing (inertia_operator L xi) eta)).
Proof.
pose spin := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 0]].
have two : (2%:R : Qc) \is a GRing.unit by [].
have spin_skew : skew (matrix_of 3 spin) by decide_by_computation.
move/(_ _ _ _ the_body_is_one spin_skew spin_skew); set c := fun t => _ => printed.
have L_sym := generalized_body_symmetric the_body_is_one.
have right : slope c _ := claim_5_3_algebra_legendre (matrix_of 3 spin) (matrix_of 3 spin) two L_sym.
move: (slope_unique two printed right); rewrite /inertia_operator.
by decide_by_computation.
Qed.

(** ** The printed Legendre map on the group

The print has \f$L_f^*\,d\ell(f) = f\Lambda - \Lambda f^T\f$. At a rotation about no principal axis of the
body no factor makes it right, so the pairing does not matter. *)
Theorem claim_5_3_group_legendre_printed_fails :
  ~ (forall L f : 'M[Qc]_3, generalized_body L -> special_orthogonal f ->
       exists c, forall theta, skew theta ->
         reduced_differential L (left_translation f theta) = c * pairing (f *m L - L *m f^T) theta).
Proof.
move/(_ _ _ the_body_is_one turn_0_is_one) => [c printed].
pose about_3 := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 0]].
pose about_2 := integers [:: [:: 0; 0; 1]; [:: 0; 0; 0]; [:: -1; 0; 0]].
have skew_3 : skew (matrix_of 3 about_3) by decide_by_computation.
have skew_2 : skew (matrix_of 3 about_2) by decide_by_computation.
have two_factors (l3 p3 l2 p2 : Qc) : l3 = c * p3 -> l2 = c * p2 -> l3 * p2 = l2 * p3.
  by move=> -> ->; rewrite mulrAC.
move: (two_factors _ _ _ _ (printed _ skew_3) (printed _ skew_2)).
by rewrite /reduced_differential; decide_by_computation.
Qed.

(** ** From the other form of the Casimir function

Section 5.3 gives the Casimir function as \f$\mathrm{Tr}(\mu^2)\f$, and says that its pull-back is
\f$\mathrm{Tr}(f\Lambda f\Lambda)\f$ up to a constant term and a sign. From \f$\mathrm{Tr}(\mu^2)\f$ it is
not: with either sign, no constant will do. The identity and a quarter turn show it. *)
Theorem claim_5_3_pullback_value_not_from_the_trace :
  ~ (forall L : 'M[Qc]_3, generalized_body L ->
       exists sign c : Qc, (sign = 1 \/ sign = -1) /\
         forall f, special_orthogonal f ->
           \tr ((f *m L - L *m f^T) *m (f *m L - L *m f^T)) = sign * trace_casimir L f + c).
Proof.
move/(_ _ the_body_is_one) => [sign [c [either value]]].
have constant (t0 t1 x0 x1 : Qc) :
    t0 = sign * x0 + c -> t1 = sign * x1 + c -> t1 - t0 = sign * x1 - sign * x0.
  by move=> -> ->; rewrite opprD addrACA subrr addr0.
move: (constant _ _ _ _ (value _ no_turn_is_one) (value _ quarter_turn_is_one)); rewrite /trace_casimir.
by case: either => ->; rewrite ?mulN1r ?mul1r; decide_by_computation.
Qed.
