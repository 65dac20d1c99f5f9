(** * The equations of Moser and Veselov

Chapter 5 of the thesis: the momenta of a step, their update, and the two lines of the scheme, with the
conventions of the file on the body. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed slopes rigid_body body_multipliers.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.
(** ** The momenta of a step and their update

Section 5.2, third part. Momenta are those of the scaled Lagrangian \f$\mathrm{Tr}(f\Lambda)\f$, \f$h\f$
times the physical ones. *)

Section Momenta.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g L Pi theta xi : 'M[R]_n.
Implicit Types h : R.

Add Ring laws_for_momenta : (laws_of_a_ring R).

(** The body momentum before a step with the relative motion \f$f\f$, multiplied by the step \f$h\f$:
\f$f^T\Lambda - \Lambda f\f$.
C++: `actio::MoserVeselov::momentum_before`, `rigid_body/moser_veselov.hpp`. *)
Definition momentum_before f L := f^T *m L - L *m f.

(** The body momentum after it, multiplied by \f$h\f$: \f$\Lambda f^T - f\Lambda\f$.
C++: `actio::MoserVeselov::momentum_after`, `rigid_body/moser_veselov.hpp`. *)
Definition momentum_after f L := L *m f^T - f *m L.

Lemma momentum_before_skew f L : symmetric L -> skew (momentum_before f L).
Proof. by move=> L_sym; rewrite /skew /momentum_before transpose_sub !trmx_mul trmxK L_sym opprB. Qed.

(** ** The update by conjugation

Within one step, for every orthogonal \f$f\f$ and every \f$\Lambda\f$, symmetric or not,
\f$f\,(f^T\Lambda-\Lambda f)\,f^T = \Lambda f^T - f\Lambda\f$. So (5.7) _is_ the update
\f$\Pi_{k+1} = f_{k+1k}\Pi_kf_{k+1k}^T\f$ of the momenta
\f$\Pi_k = f_{k+1k}^T\Lambda - \Lambda f_{k+1k}\f$. *)
Theorem claim_5_2_update_by_conjugation_within_a_step f L :
  orthogonal f -> f *m momentum_before f L *m f^T = momentum_after f L.
Proof. by move=> o; rewrite /momentum_before mulmxBr mulmxBl !mulmxA o mul1mx (turn_back _ o). Qed.

Theorem claim_5_2_update_by_conjugation f10 f21 L :
  orthogonal f10 ->
  discrete_euler_poincare L f10 f21 <-> momentum_before f21 L = f10 *m momentum_before f10 L *m f10^T.
Proof. by move=> o; rewrite claim_5_2_update_by_conjugation_within_a_step. Qed.

(** ** The update by an adjoint operator

For every matrix \f$\Pi\f$ the product \f$f\Pi f^T\f$ is \f$\mathrm{Ad}^*_{f^{-1}}\Pi\f$, and on the
rotation group also \f$\mathrm{Ad}_f\Pi\f$. *)
Theorem claim_5_2_update_by_adjoint f Pi :
  orthogonal f -> Ad_star (invmx f) Pi = f *m Pi *m f^T /\ Ad_star (invmx f) Pi = Ad f Pi.
Proof.
by move=> o; rewrite /Ad_star /Ad !orthogonal_inverse // ?trmxK //; apply: orthogonal_transpose.
Qed.

(** ** The algorithm on the dual, (5.8)

The solution \f$f_{k+1k}\f$ of (5.7) carries the momentum on:
\f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\Pi_k = f_{k+1k}\Pi_kf_{k+1k}^T\f$, with a star that the print
lacks. *)
Theorem eq_5_8 f10 f21 L (Pi := fun f => momentum_before f L) :
  orthogonal f10 -> discrete_euler_poincare L f10 f21 ->
  Pi f21 = Ad_star (invmx f10) (Pi f10) /\ Ad_star (invmx f10) (Pi f10) = f10 *m Pi f10 *m f10^T.
Proof.
move=> o motion; have [-> _] := claim_5_2_update_by_adjoint (Pi f10) o; split=> //.
exact/claim_5_2_update_by_conjugation.
Qed.

(** The update keeps the momentum in space, whatever \f$\Pi\f$ and the orthogonal \f$f\f$ are: the momentum
\f$f\Pi f^T\f$ at the attitude \f$gf^{-1}\f$ is in space what \f$\Pi\f$ is at \f$g\f$. *)
Theorem claim_5_2_manifest_preservation_in_space g f Pi (g1 := g *m invmx f) :
  orthogonal f -> g1 *m (f *m Pi *m f^T) *m g1^T = g *m Pi *m g^T.
Proof.
by move=> o; rewrite /g1 trmx_mul inverse_transpose // orthogonal_inverse // !mulmxA !(turn_forth _ o).
Qed.

(** ** The momentum of a short step

To first order in the step the momentum is \f$\mathcal J\xi\f$ times the step: let
\f$g_{k+1} = g(1+\varepsilon\xi)\f$ with a skew \f$\xi\f$, which is orthogonal where
\f$\varepsilon^2 = 0\f$; then \f$M = \varepsilon\mathcal J(\xi)\f$. Any \f$\Lambda\f$. *)
Theorem claim_5_2_momentum_limit_first_order (e : R) g L xi (g1 := g *m (1%:M + e *: xi)) :
  orthogonal g -> skew xi ->
  momentum_before (g1^T *m g) L = e *: inertia_operator L xi /\ (e ^+ 2 = 0 -> orthogonal g1).
Proof.
move=> o xi_skew; have transposed : (1%:M + e *: xi)^T = 1%:M - e *: xi.
  by rewrite transpose_add trmx1 transpose_scale xi_skew scalerN.
split=> [|small].
  have -> : g1^T *m g = 1%:M - e *: xi by rewrite /g1 trmx_mul transposed (turn_forth _ o).
  rewrite /momentum_before -{1}transposed trmxK.
  rewrite !(mulmxBr, mulmxDl) mul1mx mulmx1 -scalemxAl -scalemxAr /inertia_operator.
  by compare_entries_in R.
rewrite /orthogonal /g1 trmx_mul transposed mulmxA -[g *m _ *m _]mulmxA.
have -> : (1%:M + e *: xi) *m (1%:M - e *: xi) = 1%:M; last by rewrite mulmx1.
rewrite mulmxDl mul1mx mulmxBr mulmx1 -scalemxAl -scalemxAr scalerA -expr2 small scale0r subr0.
by rewrite subrK.
Qed.

(** ** Reconstruction

The configuration \f$g_{k+1} = g_kf^{-1}\f$ has the relative motion \f$f\f$ to \f$g_k\f$; and the three
configurations \f$g_{k-1}, g_k, g_kf^{-1}\f$ satisfy the discrete Euler-Lagrange equation exactly where
\f$f\f$ solves (5.7). *)
Theorem claim_5_2_reconstruction L g0 g1 f (g2 := g1 *m invmx f) :
  symmetric L -> orthogonal g0 -> orthogonal g1 -> orthogonal f ->
  relative_motion g1 g2 = f /\
  (discrete_euler_lagrange L g0 g1 g2 <-> discrete_euler_poincare L (relative_motion g0 g1) f).
Proof.
move=> L_sym o0 o1 of_.
have o2 : orthogonal g2.
  by rewrite /g2 orthogonal_inverse //; apply: orthogonal_product => //; apply: orthogonal_transpose.
have is_f : g2^T *m g1 = f.
  by rewrite /g2 trmx_mul inverse_transpose // -mulmxA (orthogonal_left o1) mulmx1.
by rewrite !relative_motionE // is_f eq_5_6_motion // is_f.
Qed.

End Momenta.

(** ** The update without a star

The two expressions that (5.8) prints as equal, \f$\mathrm{Ad}_{f^{-1}}\Pi\f$ and \f$f\Pi f^T\f$, are not;
and along a motion of the body the first of them, without a star, is not the next momentum. The momenta that
refute it are those of a body in a solution of (5.7). *)

Lemma the_turns_follow :
  [/\ discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_0) (matrix_of 3 turn_1),
      discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_1) (matrix_of 3 turn_2),
      discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_2) (matrix_of 3 turn_3) &
      discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_3) (matrix_of 3 turn_0)].
Proof. by rewrite /discrete_euler_poincare; split; decide_by_computation. Qed.

Theorem eq_5_8_printed_fails :
  ~ (forall L f10 f21 : 'M[Qc]_3, generalized_body L -> special_orthogonal f10 -> special_orthogonal f21 ->
       discrete_euler_poincare L f10 f21 ->
       Ad (invmx f10) (momentum_before f10 L) = f10 *m momentum_before f10 L *m f10^T).
Proof.
case: the_turns_follow => follow _ _ _.
move/(_ _ _ _ the_body_is_one turn_0_is_one turn_1_is_one follow); rewrite /momentum_before.
by decide_by_computation.
Qed.

Theorem claim_5_2_update_by_adjoint_printed_fails :
  ~ (forall L f10 f21 : 'M[Qc]_3, generalized_body L -> special_orthogonal f10 -> special_orthogonal f21 ->
       discrete_euler_poincare L f10 f21 ->
       momentum_before f21 L = Ad (invmx f10) (momentum_before f10 L)).
Proof.
case: the_turns_follow => follow _ _ _.
move/(_ _ _ _ the_body_is_one turn_0_is_one turn_1_is_one follow); rewrite /momentum_before.
by decide_by_computation.
Qed.

(** ** The equations of Moser and Veselov *)

Section MoserVeselovEquations.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g L m theta : 'M[R]_n.
Implicit Types gs omegas Ms Pis : nat -> 'M[R]_n.

Add Ring laws_for_moser_veselov : (laws_of_a_ring R).

(** A sequence \f$\omega_k\f$ and momenta \f$M_k\f$ that satisfy (5.9), with \f$\omega_k\f$ in the first
line: \f$M_{k+1} = \omega_kM_k\omega_k^{-1}\f$ and \f$M_k = \omega_k^T\Lambda - \Lambda\omega_k\f$. *)
Definition moser_veselov L omegas Ms :=
  (forall k, Ms k.+1 = omegas k *m Ms k *m invmx (omegas k)) /\
  (forall k, Ms k = (omegas k)^T *m L - L *m omegas k).

(** The same as printed, with \f$\omega_{k-1}\f$ in the first line. *)
Definition moser_veselov_as_printed L omegas Ms :=
  (forall k, (0 < k)%N -> Ms k.+1 = omegas k.-1 *m Ms k *m invmx (omegas k.-1)) /\
  (forall k, Ms k = (omegas k)^T *m L - L *m omegas k).

(** Momenta that satisfy (5.8) along a sequence of relative motions, each the momentum of its step. *)
Definition discrete_lie_poisson L fs Pis :=
  (forall k, Pis k.+1 = Ad_star (invmx (fs k)) (Pis k)) /\
  (forall k, Pis k = momentum_before (fs k) L).

(** ** Theorem 5.2.1

A sequence of orthogonal matrices \f$\omega_k = f_{kk-1}\f$ satisfies (5.7) at every step exactly where
there are momenta with which it satisfies the equations of Moser and Veselov; and these are the equations
(5.8) with the same momenta. Any \f$\Lambda\f$, any size. *)
Theorem thm_5_2_1 L omegas :
  (forall k, orthogonal (omegas k)) ->
  ((forall k, discrete_euler_poincare L (omegas k) (omegas k.+1)) <-> exists Ms, moser_veselov L omegas Ms) /\
  (forall Ms, discrete_lie_poisson L omegas Ms <-> moser_veselov L omegas Ms).
Proof.
move=> o; split.
  split=> [motion|[Ms [first second]] k].
    exists (fun k => momentum_before (omegas k) L); split=> // k.
    by rewrite orthogonal_inverse //; apply/claim_5_2_update_by_conjugation.
  apply/claim_5_2_update_by_conjugation => //; rewrite /momentum_before -!second first.
  by rewrite orthogonal_inverse.
move=> Ms; rewrite /discrete_lie_poisson /moser_veselov; split=> -[first second]; split=> // k.
  by rewrite first (proj1 (claim_5_2_update_by_adjoint _ (o k))) orthogonal_inverse.
by rewrite first (proj1 (claim_5_2_update_by_adjoint _ (o k))) orthogonal_inverse.
Qed.

(** For attitudes \f$g_0, g_1, \dots\f$ and \f$k\ge1\f$: the discrete angular velocity
\f$\omega_k = g_k^Tg_{k-1}\f$, the momentum in space
\f$m_k = g_k\Lambda g_{k-1}^T - g_{k-1}\Lambda g_k^T\f$, and the body momentum
\f$M_k = g_{k-1}^Tm_kg_{k-1}\f$. *)
Definition angular_velocity gs k := (gs k)^T *m gs k.-1.
Definition spatial_momentum L gs k := gs k *m L *m (gs k.-1)^T - gs k.-1 *m L *m (gs k)^T.
Definition body_momentum L gs k := (gs k.-1)^T *m spatial_momentum L gs k *m gs k.-1.

(** Attitudes of which the relative motions satisfy (5.7). *)
Definition motion L gs :=
  forall k, (0 < k)%N -> discrete_euler_poincare L (angular_velocity gs k) (angular_velocity gs k.+1).

Lemma angular_velocity_orthogonal gs k : (forall j, orthogonal (gs j)) -> orthogonal (angular_velocity gs k).
Proof. by move=> o; apply: orthogonal_relative. Qed.

(** ** The second line of (5.9)

The body momentum is \f$M_k = g_{k-1}^Tm_kg_{k-1} = \omega_k^T\Lambda - \Lambda\omega_k\f$, where only
\f$g_{k-1}\f$ must be orthogonal; it is skew for a symmetric \f$\Lambda\f$. And it is a momentum: the slope
of the scaled Lagrangian \f$\mathrm{Tr}(g_{k-1}\Lambda g_k^T)\f$ along \f$g_{k-1}\vartheta\f$, with skew
\f$\vartheta\f$, is \f$\tfrac12\mathrm{Tr}(M_k^T\vartheta)\f$. *)
Theorem claim_5_2_mv_second_line L gs k (omega := angular_velocity gs k) :
  orthogonal (gs k.-1) ->
  body_momentum L gs k = omega^T *m L - L *m omega /\ (symmetric L -> skew (body_momentum L gs k)).
Proof.
move=> o; have second : body_momentum L gs k = momentum_before omega L.
  rewrite /body_momentum /spatial_momentum /momentum_before /omega /angular_velocity mulmxBr mulmxBl.
  by rewrite trmx_mul trmxK !mulmxA (turn_forth _ o) (orthogonal_left o) mul1mx.
by split=> [|L_sym]; rewrite second //; apply: momentum_before_skew.
Qed.

Lemma body_momentumE L gs k :
  orthogonal (gs k.-1) -> body_momentum L gs k = momentum_before (angular_velocity gs k) L.
Proof. by move/(claim_5_2_mv_second_line L) => []. Qed.

Lemma pairing_before f L theta :
  symmetric L -> skew theta -> pairing (momentum_before f L) theta = 2%:R * \tr (f *m theta *m L).
Proof.
move=> L_sym theta_skew.
rewrite /pairing /momentum_before transpose_sub !trmx_mul trmxK L_sym mulmxBl trace_sub.
have -> : \tr (f^T *m L *m theta) = - \tr (f *m theta *m L).
  rewrite trace_product_transpose trmx_mul trmxK theta_skew L_sym mulNmx trace_opposite.
  by rewrite mxtrace_mulC -mulmxA mxtrace_mulC.
by rewrite -[L *m f *m theta]mulmxA [\tr (L *m _)]mxtrace_mulC; calculate_in R.
Qed.

Lemma pairing_after f L theta :
  symmetric L -> skew theta -> pairing (momentum_after f L) theta = 2%:R * \tr (theta *m f *m L).
Proof.
move=> L_sym theta_skew.
have -> : momentum_after f L = - momentum_before f^T L by rewrite /momentum_before trmxK opprB.
have -> : pairing (- momentum_before f^T L) theta = - pairing (momentum_before f^T L) theta.
  by rewrite /pairing -trace_opposite -mulNmx; congr (\tr (_ *m _)); exact: linearN.
rewrite pairing_before // -mulrN -trace_opposite; congr (_ * _).
by rewrite [RHS]trace_product_transpose L_sym trmx_mul theta_skew [RHS]mxtrace_mulC mulmxN mulNmx.
Qed.

Theorem claim_5_2_mv_second_line_slope L g0 g1 theta :
  (2%:R : R) \is a GRing.unit -> symmetric L -> skew theta ->
  slope (fun t => discrete_lagrangian L (g0 + t *: (g0 *m theta)) g1)
        (2%:R^-1 * pairing (momentum_before (g1^T *m g0) L) theta).
Proof.
move=> two L_sym theta_skew; rewrite pairing_before // mulKr //.
have := slope_of_lagrangian L g0 g1 (g0 *m theta) 0.
rewrite trmx0 mulmx0 mxtrace0 addr0 mxtrace_mulC !mulmxA; apply: slope_eq => t.
by rewrite scaler0 addr0.
Qed.

(** ** The first line of (5.9)

It is the left Lie-Poisson equation of a momentum that is constant in space: for _any_ attitudes and any
constant matrix \f$m\f$, the matrices \f$M_k = g_{k-1}^Tmg_{k-1}\f$ obey
\f$M_{k+1} = \omega_kM_k\omega_k^{-1}\f$. *)
Theorem claim_5_2_mv_first_line gs m k (omega := angular_velocity gs)
    (M := fun j => (gs j.-1)^T *m m *m gs j.-1) :
  (forall j, orthogonal (gs j)) -> M k.+1 = omega k *m M k *m invmx (omega k).
Proof.
move=> o; rewrite orthogonal_inverse; last exact: angular_velocity_orthogonal.
by rewrite /M /omega /angular_velocity trmx_mul trmxK !mulmxA !(turn_back _ (o _)).
Qed.

(** ** The equations of Moser and Veselov, (5.9)

Along a motion, \f$M_{k+1} = \omega_kM_k\omega_k^{-1}\f$ and
\f$M_k = \omega_k^T\Lambda - \Lambda\omega_k\f$. *)
Theorem eq_5_9 L gs k (omega := angular_velocity gs) (M := body_momentum L gs) :
  (forall j, orthogonal (gs j)) -> motion L gs -> (0 < k)%N ->
  M k.+1 = omega k *m M k *m invmx (omega k) /\ M k = (omega k)^T *m L - L *m omega k.
Proof.
move=> o along k_first; rewrite /M !body_momentumE //; split=> //.
have o_k := angular_velocity_orthogonal k o; rewrite orthogonal_inverse //.
exact/claim_5_2_update_by_conjugation/along.
Qed.

Lemma spatial_momentum_after L gs k :
  orthogonal (gs k) -> (gs k)^T *m spatial_momentum L gs k *m gs k = momentum_after (angular_velocity gs k) L.
Proof.
move=> o; rewrite /spatial_momentum /momentum_after /angular_velocity mulmxBr mulmxBl trmx_mul trmxK.
by rewrite !mulmxA (turn_forth _ o) (orthogonal_left o) mul1mx.
Qed.

(** ** The momentum in space

Attitudes are a motion exactly where the discrete momentum in space is constant, \f$m_k = m_1\f$. Any
\f$\Lambda\f$. *)
Theorem claim_5_2_spatial_momentum L gs :
  (forall j, orthogonal (gs j)) ->
  motion L gs <-> (forall k, (0 < k)%N -> spatial_momentum L gs k = spatial_momentum L gs 1).
Proof.
move=> o; suff step k : discrete_euler_poincare L (angular_velocity gs k) (angular_velocity gs k.+1) <->
    spatial_momentum L gs k.+1 = spatial_momentum L gs k.
  split=> [along|constant] k k_first; last by apply/step; rewrite !constant.
  by elim: k k_first => // -[|k] IH _ //; rewrite -(IH isT); apply/step/along.
have := body_momentumE L (o k.+1.-1); rewrite /body_momentum /= => second.
rewrite /discrete_euler_poincare -/(momentum_before _ L) -second -/(momentum_after _ L).
rewrite -[RHS]spatial_momentum_after //.
split=> [same|->//]; rewrite -[LHS]mul1mx -(o k) -[RHS]mul1mx -[X in X *m spatial_momentum L gs k](o k).
by rewrite -[LHS](turn_back _ (o k)) -[RHS](turn_back _ (o k)) -!mulmxA; congr (_ *m _); rewrite !mulmxA same.
Qed.

(** ** The two formulations

In the proof of theorem 5.2.1 the variables of the two formulations are identified. Along a motion
\f$f_{kk-1} = \omega_k\f$, and with \f$\pi_0\f$ the constant momentum in space, the momentum
\f$\Pi_{k-1} = \mathrm{Ad}^*_{g_{k-1}}\pi_0\f$ is \f$M_k\f$. *)
Theorem claim_5_2_mv_identifications L gs k (pi0 := spatial_momentum L gs 1) :
  (forall j, orthogonal (gs j)) -> motion L gs -> (0 < k)%N ->
  relative_motion (gs k.-1) (gs k) = angular_velocity gs k /\
  Ad_star (gs k.-1) pi0 = body_momentum L gs k.
Proof.
move=> o along k_first; split; first by rewrite relative_motionE.
rewrite /Ad_star inverse_transpose // /body_momentum.
by move/claim_5_2_spatial_momentum: along => ->.
Qed.

End MoserVeselovEquations.

(** ** The printed index of the first line

The thesis prints \f$M_{k+1} = \omega_{k-1}M_k\omega_{k-1}^{-1}\f$. Three readings of it are refuted: as
what a constant momentum in space obeys, along the attitudes of a motion of the body, and as equivalent to
(5.7). The motion is that of the four turns, for ever. *)

Definition the_turns (k : nat) : 'M[Qc]_3 :=
  matrix_of 3 (nth [::] [:: turn_0; turn_1; turn_2; turn_3] (k %% 4)).

Lemma next_of_four k : (k.+1 %% 4 = (k %% 4).+1 %% 4)%N.
Proof. by rewrite -addn1 -modnDml addn1. Qed.

Lemma the_turns_rotate k : special_orthogonal (the_turns k).
Proof.
rewrite /the_turns; have : (k %% 4 < 4)%N by rewrite ltn_mod.
case: (k %% 4)%N => [|[|[|[|//]]]] _; [exact: turn_0_is_one | exact: turn_1_is_one | exact: turn_2_is_one |].
exact: turn_3_is_one.
Qed.

Lemma the_turns_solve k : discrete_euler_poincare (matrix_of 3 the_body) (the_turns k) (the_turns k.+1).
Proof.
rewrite /the_turns next_of_four; case: the_turns_follow => follow0 follow1 follow2 follow3.
have : (k %% 4 < 4)%N by rewrite ltn_mod.
by case: (k %% 4)%N => [|[|[|[|//]]]].
Qed.

(** The attitudes with these relative motions. *)
Fixpoint the_attitudes (k : nat) : 'M[Qc]_3 :=
  if k is k'.+1 then the_attitudes k' *m (the_turns k')^T else 1%:M.

Lemma the_attitudes_rotate k : special_orthogonal (the_attitudes k).
Proof.
elim: k => [|k [o det_1]]; first by split; rewrite ?det1 // /orthogonal trmx1 mulmx1.
have [turn_o turn_1] := the_turns_rotate k; split.
  by apply: orthogonal_product => //; apply: orthogonal_transpose.
by rewrite det_mulmx det_tr det_1 turn_1 mulr1.
Qed.

Lemma the_attitudes_turn k : angular_velocity the_attitudes k.+1 = the_turns k.
Proof.
have [o _] := the_attitudes_rotate k.
by rewrite /angular_velocity /= trmx_mul trmxK -mulmxA (orthogonal_left o) mulmx1.
Qed.

Lemma the_attitudes_move : motion (matrix_of 3 the_body) the_attitudes.
Proof. by case=> // k _; rewrite !the_attitudes_turn; apply: the_turns_solve. Qed.

Lemma the_turns_refute :
  momentum_before (the_turns 2) (matrix_of 3 the_body) <>
  the_turns 0 *m momentum_before (the_turns 1) (matrix_of 3 the_body) *m invmx (the_turns 0).
Proof. by rewrite /the_turns /momentum_before; decide_by_computation. Qed.

Theorem claim_5_2_mv_first_line_printed_fails :
  ~ (forall (gs : nat -> 'M[Qc]_3) (m : 'M[Qc]_3) k (omega := angular_velocity gs)
       (M := fun j => (gs j.-1)^T *m m *m gs j.-1),
       (forall j, special_orthogonal (gs j)) -> skew m -> (1 < k)%N ->
       M k.+1 = omega k.-1 *m M k *m invmx (omega k.-1)).
Proof.
pose m := integers [:: [:: 0; 0; 1]; [:: 0; 0; 0]; [:: -1; 0; 0]].
have m_skew : skew (matrix_of 3 m) by decide_by_computation.
pose gs k := matrix_of 3 (if k == 2%N then quarter_turn else no_turn).
have rotate j : special_orthogonal (gs j).
  by rewrite /gs; case: eqP => _; [exact: quarter_turn_is_one | exact: no_turn_is_one].
move/(_ gs (matrix_of 3 m) 2%N rotate m_skew isT); rewrite /angular_velocity /gs /=.
by decide_by_computation.
Qed.

Theorem eq_5_9_printed_fails :
  ~ (forall (L : 'M[Qc]_3) gs k (omega := angular_velocity gs) (M := body_momentum L gs),
       generalized_body L -> (forall j, special_orthogonal (gs j)) -> motion L gs -> (1 < k)%N ->
       M k.+1 = omega k.-1 *m M k *m invmx (omega k.-1)).
Proof.
move/(_ _ _ 2%N the_body_is_one the_attitudes_rotate the_attitudes_move isT).
have o j : orthogonal (the_attitudes j) by case: (the_attitudes_rotate j).
by rewrite !body_momentumE // !the_attitudes_turn; apply: the_turns_refute.
Qed.

Theorem thm_5_2_1_printed_fails :
  ~ (forall (L : 'M[Qc]_3) omegas, generalized_body L -> (forall k, special_orthogonal (omegas k)) ->
       (forall k, discrete_euler_poincare L (omegas k) (omegas k.+1)) <->
       exists Ms, moser_veselov_as_printed L omegas Ms).
Proof.
move/(_ _ _ the_body_is_one the_turns_rotate) => [printed _].
have [Ms [first second]] := printed the_turns_solve.
by have := first 1%N isT; rewrite !second; apply: the_turns_refute.
Qed.

(** ** The momentum from the velocity by substitution *)

Section Substitution.

Variables (R : comUnitRingType) (n : nat).
Implicit Types g L xi : 'M[R]_n.

Add Ring laws_for_substitution : (laws_of_a_ring R).

(** ** What to substitute in

Section 5.2 says that (5.5), put into \f$M = J(\xi) = \Lambda\xi + \xi\Lambda\f$, gives the second line of
(5.9). It does so when \f$J\f$ is written as \f$J(\xi) = \Lambda\xi - \xi^T\Lambda\f$, which for skew
\f$\xi\f$ is the same: the result is \f$h^{-1}M_k\f$, the momentum before the step; the difference at the
other end gives the momentum after it. Any \f$\Lambda\f$, and any factor \f$h^{-1}\f$. *)
Theorem claim_5_2_momentum_by_substitution h L g0 g1 (omega := g1^T *m g0)
    (D := velocity_at_end h g0 g1) (D' := velocity_at_start h g0 g1) :
  orthogonal g0 -> orthogonal g1 ->
  L *m D - D^T *m L = h^-1 *: momentum_before omega L /\
  L *m D' - D'^T *m L = h^-1 *: momentum_after omega L.
Proof.
move=> o0 o1; rewrite /D /D' velocity_at_endE // velocity_at_startE //.
have -> : g0^T *m g1 = omega^T by rewrite /omega trmx_mul trmxK.
rewrite -/omega /momentum_before /momentum_after !transpose_scale -!scalemxAr -!scalemxAl -!scalerBr.
rewrite !transpose_sub trmx1 trmxK !(mulmxBl, mulmxBr) !(mul1mx, mulmx1).
by split; congr (_ *: _); compare_entries_in R.
Qed.

Theorem claim_5_2_momentum_by_substitution_skew L xi :
  skew xi -> inertia_operator L xi = L *m xi - xi^T *m L.
Proof. by move=> ->; rewrite mulNmx opprK. Qed.

(** In \f$\Lambda\xi + \xi\Lambda\f$ the difference gives no skew matrix; twice its skew part is the sum of
the momenta at both ends of the step, over \f$h\f$. *)
Theorem claim_5_2_momentum_by_substitution_mean h L g0 g1 (omega := g1^T *m g0)
    (D := velocity_at_end h g0 g1) :
  symmetric L -> orthogonal g0 -> orthogonal g1 ->
  skew_part (inertia_operator L D) = h^-1 *: (momentum_before omega L + momentum_after omega L).
Proof.
move=> L_sym o0 o1; rewrite /skew_part /inertia_operator transpose_add !trmx_mul L_sym /D velocity_at_endE //.
rewrite -/omega /momentum_before /momentum_after !transpose_scale.
rewrite -!scalemxAr -!scalemxAl -!scalerDr -!scalerBr.
rewrite !transpose_sub trmx1 !(mulmxBl, mulmxBr) !(mul1mx, mulmx1).
by congr (_ *: _); compare_entries_in R.
Qed.

End Substitution.

(** The printed substitution, refuted by a quarter turn in one step of length 1. *)
Theorem claim_5_2_momentum_by_substitution_printed_fails :
  ~ (forall (h : Qc) (L g0 g1 : 'M[Qc]_3), h != 0 -> generalized_body L ->
       special_orthogonal g0 -> special_orthogonal g1 ->
       inertia_operator L (velocity_at_end h g0 g1) = h^-1 *: momentum_before (g1^T *m g0) L).
Proof.
move/(_ 1 _ _ _ isT the_body_is_one no_turn_is_one quarter_turn_is_one).
rewrite /inertia_operator /velocity_at_end /momentum_before invr1 !scale1r.
by decide_by_computation.
Qed.
