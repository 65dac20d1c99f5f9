(** * The generalized rigid body

Chapter 5 of the thesis: the body on \f$SO(n)\f$, its discretization by Moser and Veselov, and what that
conserves. A configuration is an orthogonal matrix \f$g\f$ of any size \f$n\f$ over any commutative ring
\f$R\f$, `orthogonal g`; a body velocity \f$\xi = g^{-1}\dot g\f$ and a body momentum are skew matrices. The
matrix \f$\Lambda\f$ of the body is `L`. It need not be diagonal; where it has to be symmetric, the theorem
says so. Two configurations \f$g_k, g_{k+1}\f$ have the relative motion \f$f_{k+1k} = g_{k+1}^{-1}g_k\f$;
for three configurations in a row these are called `f10` and `f21`. Where a formula of the thesis has the
factor \f$\tfrac12\f$ or \f$\tfrac14\f$, the number 2 must have an inverse in \f$R\f$,
`2%:R \is a GRing.unit`.

Determinants are asked for nowhere: the theorems hold for reflections too. The counterexamples to printed
formulas are matrices of \f$SO(3)\f$ with rational entries. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed slopes.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.
(** ** The body: inertia and kinetic energy *)

Section Inertia.

Variables (R : comUnitRingType) (n : nat).
Implicit Types g k v x y L M xi eta zeta : 'M[R]_n.

Add Ring laws_for_inertia : (laws_of_a_ring R).

(** The operator of inertia, \f$J(\xi) = \Lambda\xi + \xi\Lambda\f$.
C++: `actio::body_momentum`, `rigid_body/inertia.hpp`. *)
Definition inertia_operator L xi := L *m xi + xi *m L.

(** ** The operator of inertia

Section 5.0 says that \f$J\f$ is an operator on \f$so(n)\f$, and symmetric. It takes skew matrices to skew
ones and is symmetric for the trace pairing, for every symmetric \f$\Lambda\f$; for the second property the
arguments may be any matrices. That it is positive follows below, over ordered numbers. *)
Theorem claim_5_0_inertia_operator_skew L xi : symmetric L -> skew xi -> skew (inertia_operator L xi).
Proof.
move=> L_sym xi_skew; rewrite /skew /inertia_operator transpose_add !trmx_mul L_sym xi_skew.
by rewrite mulNmx mulmxN -opprD addrC.
Qed.

Theorem claim_5_0_inertia_operator_symmetric L x y :
  symmetric L -> pairing x (inertia_operator L y) = pairing (inertia_operator L x) y.
Proof.
move=> L_sym; rewrite /pairing /inertia_operator transpose_add !trmx_mul L_sym mulmxDr mulmxDl !mxtraceD.
by rewrite !mulmxA; congr (_ + _); rewrite mxtrace_mulC !mulmxA.
Qed.

(** The trace is a sum of squares with weights: for \f$\Lambda = \mathrm{diag}(d)\f$ and any matrix \f$x\f$,
\f$\mathrm{Tr}(x^TJ(x)) = \sum_{i,j}(d_i+d_j)\,x_{ij}^2\f$. *)
Theorem claim_5_0_inertia_operator_by_planes (d : 'rV[R]_n) x :
  pairing x (inertia_operator (diag_mx d) x) = \sum_i \sum_j (d 0 i + d 0 j) * x i j ^+ 2.
Proof.
rewrite exchange_big; apply: eq_bigr => j _; rewrite mxE; apply: eq_bigr => i _.
by rewrite /inertia_operator mul_diag_mx mul_mx_diag !mxE; calculate_in R.
Qed.

(** The metric, four times: the form \f$\mathrm{Tr}(\xi^TJ(\xi))\f$ of \f$\xi = g^{-1}v\f$, where \f$v\f$ is
a tangent vector at \f$g\f$. It is left-invariant. *)
Definition metric L g v := pairing (g^T *m v) (inertia_operator L (g^T *m v)).

Theorem claim_5_0_inertia_operator_left_invariant L k g v :
  orthogonal k -> metric L (k *m g) (k *m v) = metric L g v.
Proof. by move=> o; rewrite /metric trmx_mul !mulmxA (turn_forth _ o). Qed.

(** The kinetic energy of a body velocity, (5.1): \f$l(\xi) = \tfrac14\mathrm{Tr}(\xi^TJ(\xi))\f$.
C++: `actio::kinetic_energy`, `rigid_body/inertia.hpp`. *)
Definition kinetic_energy L xi := 4%:R^-1 * pairing xi (inertia_operator L xi).

Lemma one_trace L xi :
  (2%:R : R) \is a GRing.unit -> skew xi -> kinetic_energy L xi = 2%:R^-1 * \tr (xi^T *m L *m xi).
Proof.
move=> two xi_skew; rewrite /kinetic_energy /pairing /inertia_operator mulmxDr mxtraceD !mulmxA.
have -> : \tr (xi^T *m xi *m L) = \tr (xi^T *m L *m xi).
  by rewrite xi_skew !mulNmx !trace_opposite -mulmxA mxtrace_mulC.
by rewrite (natrM _ 2 2) invrM // -mulrA half_twice.
Qed.

(** A body of \f$N\f$ point masses \f$m_a\f$ at the places \f$x_a\f$: its matrix
\f$\Lambda = \sum_am_ax_ax_a^T\f$, and its energy where the masses move at the velocities \f$vx_a\f$. *)
Definition second_moments (N : nat) (m : 'I_N -> R) (x : 'I_N -> 'cV[R]_n) : 'M[R]_n :=
  \sum_a m a *: (x a *m (x a)^T).

Definition energy_of_masses (N : nat) (m : 'I_N -> R) (x : 'I_N -> 'cV[R]_n) v :=
  2%:R^-1 * \sum_a m a * \tr ((v *m x a)^T *m (v *m x a)).

(** ** The Lagrangian is the kinetic energy, (5.1)

A body at the attitude \f$g\f$ with the body velocity \f$\xi\f$ moves its masses at \f$g\xi x_a\f$. Their
kinetic energy is \f$\tfrac14\langle\xi, J\xi\rangle\f$ with the pairing \f$\mathrm{Tr}(A^TB)\f$, whatever
the attitude. *)
Theorem eq_5_1 N (m : 'I_N -> R) (x : 'I_N -> 'cV[R]_n) g xi :
  (2%:R : R) \is a GRing.unit -> orthogonal g -> skew xi ->
  energy_of_masses m x (g *m xi) = kinetic_energy (second_moments m x) xi.
Proof.
move=> two o xi_skew; rewrite one_trace //; congr (_ * _).
rewrite /second_moments mulmx_sumr mulmx_suml raddf_sum; apply: eq_bigr => a _ /=.
rewrite -scalemxAr -scalemxAl mxtraceZ; congr (_ * _).
rewrite !trmx_mul !mulmxA (turn_forth _ o) xi_skew !(mulmxN, mulNmx) !trace_opposite; congr (- _).
by rewrite -!mulmxA mxtrace_mulC -!mulmxA [LHS]mxtrace_mulC !mulmxA.
Qed.

(** The Lagrangian of a motion through \f$g\f$ with the velocity \f$\dot g = v\f$. *)
Definition lagrangian L g v := kinetic_energy L (g^T *m v).

(** ** The factor of the discrete Lagrangian, (5.2)

Section 5.1 evaluates the Lagrangian (5.1) at the configuration \f$q\f$, here `g`, and the velocity
\f$q\zeta\f$. Whatever \f$q\f$ and \f$\zeta\f$ are, that is
\f$\tfrac14\langle\zeta,\mathcal J(\zeta)\rangle\f$, with the factor and the pairing of (5.1); and it is the
same for \f$-\zeta\f$. *)
Theorem eq_5_2_factor L g zeta :
  orthogonal g ->
  lagrangian L g (left_translation g zeta) = 4%:R^-1 * pairing zeta (inertia_operator L zeta) /\
  lagrangian L g (left_translation g (- zeta)) = lagrangian L g (left_translation g zeta).
Proof.
move=> o; rewrite /lagrangian /left_translation !mulmxA (orthogonal_left o) !mul1mx; split=> //.
rewrite /kinetic_energy /pairing /inertia_operator transpose_opposite mulNmx mulmxN mulNmx.
by rewrite -opprD mulmxN opprK.
Qed.

(** ** On which space the pairing lives

Section 5.0 calls the brackets of (5.1) the pairing between the Lie group and its dual. It is the pairing of
the Lie _algebra_ with its dual: on skew matrices the trace is a pairing, that is, nothing but zero pairs to
zero with all of them. Between elements of the group the same trace is a constant,
\f$\mathrm{Tr}(g^TJ(g)) = 2\,\mathrm{Tr}\Lambda\f$, and knows nothing of the motion. *)
Theorem claim_5_0_pairing_on_the_algebra M :
  (2%:R : R) \is a GRing.unit -> skew M -> (forall xi, skew xi -> pairing M xi = 0) -> M = 0.
Proof.
move=> two M_skew vanishes; apply: pairing_nondegenerate => v.
have : pairing M (skew_part v) = 0 by apply: vanishes; apply: skew_of_skew_part.
rewrite /skew_part /pairing mulmxBr trace_sub.
have -> : \tr (M^T *m v^T) = - \tr (M^T *m v).
  by rewrite trace_product_transpose !trmxK mxtrace_mulC M_skew mulNmx trace_opposite opprK.
by rewrite opprK => double; rewrite -(half_twice (\tr _) two) double mulr0.
Qed.

Theorem claim_5_0_pairing_on_the_group L g :
  orthogonal g -> pairing g (inertia_operator L g) = 2%:R * \tr L.
Proof.
move=> o; rewrite /pairing mulmxDr mxtraceD !mulmxA (orthogonal_left o) mul1mx mxtrace_mulC mulmxA o mul1mx.
by calculate_in R.
Qed.

End Inertia.

(** ** The bodies and motions of the counterexamples

A generalized body as in section 5.0: \f$\Lambda\f$ is diagonal, \f$\Lambda_i+\Lambda_j > 0\f$ for
\f$i\ne j\f$. All counterexamples have the body \f$\Lambda = \mathrm{diag}(1, 3, 2)\f$, of which the
principal moments are 5, 3 and 4, and relative motions with determinant 1. *)

Definition special_orthogonal (R : comUnitRingType) n (f : 'M[R]_n) := orthogonal f /\ \det f = 1.

Definition generalized_body n (L : 'M[Qc]_n) :=
  is_diag_mx L /\ forall i j, i != j -> Qclt 0 (L i i + L j j).

Lemma generalized_body_symmetric n (L : 'M[Qc]_n) : generalized_body L -> symmetric L.
Proof.
move=> [/is_diag_mxP diagonal _]; apply/matrixP => i j; rewrite mxE.
by case: (eqVneq i j) => [->//|ne]; rewrite !diagonal // eq_sym.
Qed.

Definition the_body : rows := integers [:: [:: 1; 0; 0]; [:: 0; 3; 0]; [:: 0; 0; 2]].
Definition no_turn : rows := integers [:: [:: 1; 0; 0]; [:: 0; 1; 0]; [:: 0; 0; 1]].
Definition quarter_turn : rows := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 1]].

(** Four relative motions that follow one another for ever: each pair of neighbours in the circle solves the
equation of motion (5.7) for the body above. The step is a quarter of a period. *)
Definition turn_0 : rows := over 35 [:: [:: -15; 30; -10]; [:: 30; 17; 6]; [:: 10; -6; -33]].
Definition turn_1 : rows := over 7 [:: [:: -6; 3; -2]; [:: -3; -2; 6]; [:: 2; 6; 3]].
Definition turn_2 : rows := over 35 [:: [:: -15; -30; -10]; [:: -30; 17; -6]; [:: 10; 6; -33]].
Definition turn_3 : rows := over 7 [:: [:: -6; -3; -2]; [:: 3; -2; -6]; [:: 2; -6; 3]].

Lemma the_body_is_one : generalized_body (matrix_of 3 the_body).
Proof.
split; first by apply/is_diag_mxP => -[[|[|[|//]]] ?] [[|[|[|//]]] ?] // _; rewrite -!computedE.
by move=> -[[|[|[|//]]] ?] [[|[|[|//]]] ?] // _; rewrite -!computedE.
Qed.

Ltac decide_rotation := split; [decide_by_computation | decide_by_computation].

Lemma no_turn_is_one : special_orthogonal (matrix_of 3 no_turn). Proof. by decide_rotation. Qed.
Lemma quarter_turn_is_one : special_orthogonal (matrix_of 3 quarter_turn). Proof. by decide_rotation. Qed.
Lemma turn_0_is_one : special_orthogonal (matrix_of 3 turn_0). Proof. by decide_rotation. Qed.
Lemma turn_1_is_one : special_orthogonal (matrix_of 3 turn_1). Proof. by decide_rotation. Qed.
Lemma turn_2_is_one : special_orthogonal (matrix_of 3 turn_2). Proof. by decide_rotation. Qed.
Lemma turn_3_is_one : special_orthogonal (matrix_of 3 turn_3). Proof. by decide_rotation. Qed.

(** ** The printed factor

The print has \f$\tfrac12\langle\zeta,\mathcal J(\zeta)\rangle\f$ in (5.2). With the factor and the pairing
of (5.1) that is twice the energy. *)
Theorem eq_5_2_printed_fails :
  ~ (forall L g zeta : 'M[Qc]_3, generalized_body L -> special_orthogonal g -> skew zeta ->
       lagrangian L g (left_translation g zeta) = 2%:R^-1 * pairing zeta (inertia_operator L zeta)).
Proof.
pose spin := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 0]].
have spin_skew : skew (matrix_of 3 spin) by decide_by_computation.
move/(_ _ _ _ the_body_is_one quarter_turn_is_one spin_skew).
by rewrite /lagrangian /kinetic_energy /inertia_operator; decide_by_computation.
Qed.

(** ** The operator of inertia is positive

Over ordered numbers: \f$J\f$ takes skew matrices to skew ones, is symmetric, and
\f$\mathrm{Tr}(\xi^TJ(\xi)) > 0\f$ for all skew \f$\xi\ne0\f$ _exactly_ where \f$\Lambda_i+\Lambda_j>0\f$
for all \f$i\ne j\f$. So the condition of section 5.0 is not only enough, and one \f$\Lambda_i\f$ may be
negative. *)

Section Positivity.

Import Order.TTheory Num.Theory.

Variables (F : realFieldType) (n : nat).

Theorem claim_5_0_inertia_operator_positive (d : 'rV[F]_n) :
  (forall i j, i != j -> 0 < d 0 i + d 0 j) <->
  (forall xi : 'M[F]_n, skew xi -> xi != 0 -> 0 < pairing xi (inertia_operator (diag_mx d) xi)).
Proof.
split=> [sums xi xi_skew nonzero|positive i j ne].
  have diagonal i : xi i i = 0.
    by move/matrixP/(_ i i)/eqP: xi_skew; rewrite !mxE -addr_eq0 -mulr2n mulrn_eq0 => /eqP.
  rewrite claim_5_0_inertia_operator_by_planes pair_bigA /=.
  have term (p : 'I_n * 'I_n) : true -> 0 <= (d 0 p.1 + d 0 p.2) * xi p.1 p.2 ^+ 2.
    move=> _; case: (eqVneq p.1 p.2) => [->|ne]; first by rewrite diagonal expr0n mulr0.
    by rewrite mulr_ge0 ?sqr_ge0 // ltW // sums.
  rewrite lt0r sumr_ge0 // andbT; apply: contra nonzero => /eqP/(psumr_eq0P term) zero.
  apply/eqP/matrixP => i j; rewrite mxE; case: (eqVneq i j) => [->|ne]; first exact: diagonal.
  have /eqP := zero (i, j) isT.
  by rewrite mulf_eq0 (gt_eqF (sums i j ne)) sqrf_eq0 => /eqP.
(* The other way: turn in the plane of the axes i and j alone. *)
pose xi : 'M[F]_n := delta_mx i j - delta_mx j i.
have xi_skew : skew xi by rewrite /skew /xi linearB /= !trmx_delta opprB.
have xi_ij : xi i j = 1 by rewrite !mxE !eqxx (negbTE ne) subr0.
have xi_ji : xi j i = -1 by rewrite !mxE !eqxx eq_sym (negbTE ne) sub0r.
have : 0 < pairing xi (inertia_operator (diag_mx d) xi).
  by apply: positive => //; apply/eqP => zero; move: xi_ij; rewrite zero mxE => /eqP; rewrite eq_sym oner_eq0.
rewrite claim_5_0_inertia_operator_by_planes pair_bigA /= (bigD1 (i, j)) //= (bigD1 (j, i)) /=; last first.
  by rewrite xpair_eqE negb_and eq_sym ne.
rewrite big1 => [|[a b] /= /andP[ne1 ne2]]; last first.
  have -> : xi a b = 0; last by rewrite expr0n mulr0.
  by move: ne1 ne2; rewrite !xpair_eqE !mxE => /negbTE-> /negbTE->; rewrite subrr.
by rewrite xi_ij xi_ji sqrrN expr1n !mulr1 addr0 [d 0 j + _]addrC -mulr2n pmulrn_lgt0.
Qed.

Theorem claim_5_0_inertia_operator (d : 'rV[F]_n) (L := diag_mx d) :
  (forall xi : 'M[F]_n, skew xi -> skew (inertia_operator L xi)) /\
  (forall x y, pairing x (inertia_operator L y) = pairing (inertia_operator L x) y) /\
  ((forall i j, i != j -> 0 < d 0 i + d 0 j) <->
   (forall xi : 'M[F]_n, skew xi -> xi != 0 -> 0 < pairing xi (inertia_operator L xi))).
Proof.
have L_sym : symmetric L by rewrite /symmetric tr_diag_mx.
split; first by move=> xi; apply: claim_5_0_inertia_operator_skew.
split; first by move=> x y; apply: claim_5_0_inertia_operator_symmetric.
exact: claim_5_0_inertia_operator_positive.
Qed.

End Positivity.

(** ** The trace Lagrangian and its discretization

Section 5.2, first part. *)

Section Discretization.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g k L xi : 'M[R]_n.
Implicit Types h e : R.

Add Ring laws_for_discretization : (laws_of_a_ring R).

(** ** The Lagrangian with one trace

Section 5.2: \f$\tfrac14\mathrm{Tr}(\xi^TJ(\xi)) = \tfrac12\mathrm{Tr}(\xi^T\Lambda\xi)\f$. The matrix
\f$\xi\f$ must be skew, but \f$\Lambda\f$ may be any matrix, also one that is not symmetric. *)
Theorem claim_5_2_trace_lagrangian L xi :
  (2%:R : R) \is a GRing.unit -> skew xi -> kinetic_energy L xi = 2%:R^-1 * \tr (xi^T *m L *m xi).
Proof. exact: one_trace. Qed.

(** The velocity as a difference, (5.5): \f$D = \tfrac1hg_{k+1}^T(g_{k+1}-g_k)\f$; and the one at the other
end, \f$D' = \tfrac1hg_k^T(g_{k+1}-g_k)\f$. *)
Definition velocity_at_end h g0 g1 := h^-1 *: (g1^T *m (g1 - g0)).
Definition velocity_at_start h g0 g1 := h^-1 *: (g0^T *m (g1 - g0)).

Lemma velocity_at_endE h g0 g1 : orthogonal g1 -> velocity_at_end h g0 g1 = h^-1 *: (1%:M - g1^T *m g0).
Proof. by move=> o; rewrite /velocity_at_end mulmxBr (orthogonal_left o). Qed.

Lemma velocity_at_startE h g0 g1 : orthogonal g0 -> velocity_at_start h g0 g1 = h^-1 *: (g0^T *m g1 - 1%:M).
Proof. by move=> o; rewrite /velocity_at_start mulmxBr (orthogonal_left o). Qed.

(** ** The difference that stands for the velocity, (5.5)

To first order in the step it is the velocity: let \f$\varepsilon^2=0\f$, let the motion begin at \f$g\f$
with the body velocity \f$\xi\f$, and let the step be so short that \f$g_{k+1} = g(1+\varepsilon\xi)\f$;
then \f$hD = \varepsilon\xi\f$. Here \f$\xi\f$ may be any matrix. But \f$D\f$ is no element of the algebra:
exactly, \f$D + D^T = h\,D^TD\f$. And it is seen from the body: \f$D\f$ is the same for
\f$kg_k, kg_{k+1}\f$. *)
Theorem eq_5_5_first_order h e g xi :
  h \is a GRing.unit -> e ^+ 2 = 0 -> orthogonal g ->
  h *: velocity_at_end h g (g *m (1%:M + e *: xi)) = e *: xi.
Proof.
move=> unit small o; rewrite /velocity_at_end scalerA mulrV // scale1r.
have -> : g *m (1%:M + e *: xi) - g = e *: (g *m xi).
  by rewrite mulmxDr mulmx1 -scalemxAr addrAC subrr add0r.
rewrite trmx_mul transpose_add trmx1 transpose_scale -scalemxAr -mulmxA [g^T *m _]mulmxA (orthogonal_left o).
by rewrite mul1mx mulmxDl mul1mx -scalemxAl scalerDr scalerA -expr2 small scale0r addr0.
Qed.

Theorem eq_5_5_not_skew h g0 g1 (D := velocity_at_end h g0 g1) :
  h \is a GRing.unit -> orthogonal g0 -> orthogonal g1 -> D + D^T = h *: (D^T *m D).
Proof.
move=> unit o0 o1; rewrite /D velocity_at_endE //; have := orthogonal_relative o0 o1.
move: (g1^T *m g0) => f of_; rewrite transpose_scale -scalemxAl -scalemxAr -scalerDr !scalerA mulrV // mul1r.
congr (_ *: _); rewrite transpose_sub trmx1.
rewrite !(mulmxBl, mulmxBr) !(mul1mx, mulmx1) (orthogonal_left of_).
by compare_entries_in R.
Qed.

Theorem eq_5_5_left_invariant h k g0 g1 :
  orthogonal k -> velocity_at_end h (k *m g0) (k *m g1) = velocity_at_end h g0 g1.
Proof. by move=> o; rewrite /velocity_at_end -mulmxBr trmx_mul !mulmxA (turn_forth _ o). Qed.

(** The discrete Lagrangian of section 5.2, scaled: \f$\mathrm{Tr}(g_k\Lambda g_{k+1}^T)\f$, without the
factor \f$-1/h^2\f$. *)
Definition discrete_lagrangian L g0 g1 := \tr (g0 *m L *m g1^T).

Lemma trace_of_difference L f :
  orthogonal f -> symmetric L -> \tr ((1%:M - f)^T *m L *m (1%:M - f)) = 2%:R * (\tr L - \tr (f *m L)).
Proof.
move=> of_ L_sym; rewrite transpose_sub trmx1 !(mulmxBl, mulmxBr) !(mul1mx, mulmx1) !trace_sub.
have -> : \tr (f^T *m L *m f) = \tr L by rewrite mxtrace_mulC mulmxA of_ mul1mx.
have -> : \tr (f^T *m L) = \tr (f *m L) by rewrite trace_product_transpose trmxK L_sym mxtrace_mulC.
by rewrite [\tr (L *m f)]mxtrace_mulC; calculate_in R.
Qed.

(** ** The discrete Lagrangian

The difference (5.5) in the Lagrangian gives
\f[ \tfrac12\mathrm{Tr}(D^T\Lambda D) = -\frac1{h^2}\mathrm{Tr}(g_k\Lambda g_{k+1}^T) +
\frac1{h^2}\mathrm{Tr}\Lambda . \f]
The last term is what the thesis leaves out, _modulo_ \f$\mathbb R\f$. Here \f$\Lambda\f$ must be symmetric;
the step \f$h\f$ may be any number, for \f$h^{-1}\f$ is only a factor. *)
Theorem claim_5_2_discrete_trace_lagrangian h L g0 g1 (D := velocity_at_end h g0 g1) :
  (2%:R : R) \is a GRing.unit -> symmetric L -> orthogonal g0 -> orthogonal g1 ->
  2%:R^-1 * \tr (D^T *m L *m D) = - h^-2 * discrete_lagrangian L g0 g1 + h^-2 * \tr L.
Proof.
move=> two L_sym o0 o1; rewrite /D velocity_at_endE // transpose_scale -!scalemxAl -scalemxAr !mxtraceZ.
rewrite trace_of_difference //; last exact: orthogonal_relative.
rewrite -[g1^T *m g0 *m L]mulmxA [\tr (g1^T *m _)]mxtrace_mulC -/(discrete_lagrangian L g0 g1) -exprVn.
set s := 2%:R^-1; have once : s * 2%:R = 1 by apply: mulVr.
by rewrite -[RHS]mul1r -[X in _ = X * _]once; calculate_in R.
Qed.

(** ** The difference at the other end

With \f$D'\f$ in place of \f$D\f$ the value is the same, although \f$D' = g_k^Tg_{k+1}D\f$ is another
matrix. Nothing is asked of \f$\Lambda\f$. *)
Theorem claim_5_2_other_difference h L g0 g1
    (D := velocity_at_end h g0 g1) (D' := velocity_at_start h g0 g1) :
  orthogonal g0 -> orthogonal g1 ->
  \tr (D'^T *m L *m D') = \tr (D^T *m L *m D) /\ D' = g0^T *m g1 *m D.
Proof.
move=> o0 o1; split; last first.
  by rewrite /D /D' /velocity_at_end /velocity_at_start -scalemxAr !mulmxA (turn_back _ o1).
rewrite /D /D' velocity_at_endE // velocity_at_startE //.
have -> : g0^T *m g1 = (g1^T *m g0)^T by rewrite trmx_mul trmxK.
have := orthogonal_relative o0 o1; move: (g1^T *m g0) => f of_.
rewrite !transpose_scale -!scalemxAl -!scalemxAr !mxtraceZ !transpose_sub trmx1 trmxK.
congr (_ * (_ * _)); rewrite !(mulmxBl, mulmxBr) !(mul1mx, mulmx1) !trace_sub.
rewrite [\tr (f *m L *m f^T)]mxtrace_mulC [\tr (f^T *m L *m f)]mxtrace_mulC !mulmxA of_ (orthogonal_left of_).
by rewrite mul1mx [\tr (f *m L)]mxtrace_mulC [\tr (f^T *m L)]mxtrace_mulC; calculate_in R.
Qed.


(** ** The Lagrangian of Moser and Veselov

Up to the factor \f$-1/h^2\f$ it is theirs, \f$\mathrm{Tr}(X\Lambda Y^T) = \sum_{i,j}d_j\,X_{ij}Y_{ij}\f$
for \f$\Lambda = \mathrm{diag}(d)\f$. The constant that was left out drops out between two pairs of
configurations. *)
Theorem claim_5_2_moser_veselov_multiple h (d : 'rV[R]_n) g0 g1 g2 g3
    (ours := fun x y (D := velocity_at_end h x y) => 2%:R^-1 * \tr (D^T *m diag_mx d *m D))
    (theirs := fun x y : 'M[R]_n => \sum_i \sum_j d 0 j * x i j * y i j) :
  (2%:R : R) \is a GRing.unit -> orthogonal g0 -> orthogonal g1 -> orthogonal g2 -> orthogonal g3 ->
  ours g0 g1 - ours g2 g3 = - h^-2 * (theirs g0 g1 - theirs g2 g3).
Proof.
move=> two o0 o1 o2 o3; have d_sym : symmetric (diag_mx d) by rewrite /symmetric tr_diag_mx.
have entries x y : discrete_lagrangian (diag_mx d) x y = theirs x y.
  apply: eq_bigr => i _; rewrite mxE; apply: eq_bigr => j _.
  by rewrite mul_mx_diag !mxE [d 0 j * _]mulrC.
by rewrite /ours !claim_5_2_discrete_trace_lagrangian // !entries; calculate_in R.
Qed.

End Discretization.
