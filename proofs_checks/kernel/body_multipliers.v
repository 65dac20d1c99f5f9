(** * The rigid body with multipliers

Chapter 5 of the thesis, where the configurations are held on the group by multipliers, with the conventions
of the file on the body. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed slopes rigid_body.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.
(** ** Configurations held on the group by multipliers

Section 5.2, second part. The configurations are any matrices now; a matrix \f$\lambda_k\f$ of multipliers
for each of them holds them on the group. *)

Section Multipliers.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g v x L theta lam : 'M[R]_n.
Implicit Types gs lams vs : nat -> 'M[R]_n.
Implicit Type N : nat.

(** The constraint \f$\Phi(g) = gg^T - 1\f$.
C++: `actio::orthogonality`, `rigid_body/multiplier.hpp`. *)
Definition orthogonality g := g *m g^T - 1%:M.

(** The constrained action sum (5.6) of the configurations \f$g_0, \dots, g_N\f$,
\f$S = \sum_k\mathrm{Tr}(g_k\Lambda g_{k+1}^T) - \tfrac12\sum_k\mathrm{Tr}(\lambda_k(g_kg_k^T-1))\f$.
C++: `actio::constrained_action`, `rigid_body/multiplier.hpp`. *)
Definition constrained_action L lams gs N :=
  \sum_(0 <= k < N) discrete_lagrangian L (gs k) (gs k.+1)
  - 2%:R^-1 * \sum_(0 <= k < N.+1) \tr (lams k *m orthogonality (gs k)).

Definition symmetric_part lam := 2%:R^-1 *: (lam + lam^T).

Lemma symmetric_part_symmetric lam : symmetric (symmetric_part lam).
Proof. by rewrite /symmetric /symmetric_part transpose_scale transpose_add trmxK addrC. Qed.

Lemma orthogonality_symmetric g : (orthogonality g)^T = orthogonality g.
Proof. by rewrite /orthogonality transpose_sub trmx1 trmx_mul trmxK. Qed.

(** ** The skew part of a multiplier

It does not contribute: multipliers and their symmetric parts give the same action, on the group or off it.
Nothing is asked of \f$\Lambda\f$ or of the configurations. *)
Theorem claim_5_2_skew_multiplier L lams gs N :
  (2%:R : R) \is a GRing.unit ->
  constrained_action L lams gs N = constrained_action L (fun k => symmetric_part (lams k)) gs N.
Proof.
move=> two; congr (_ - _ * _); apply: eq_bigr => k _.
rewrite /symmetric_part -scalemxAl mulmxDl mxtraceZ mxtraceD.
have -> : \tr ((lams k)^T *m orthogonality (gs k)) = \tr (lams k *m orthogonality (gs k)).
  by rewrite trace_product_transpose trmxK orthogonality_symmetric mxtrace_mulC.
by rewrite half_twice.
Qed.

(** The terms of (5.6) that contain the configuration \f$g_k\f$ between its neighbours. *)
Definition terms_at L lam g0 g2 g :=
  discrete_lagrangian L g0 g + discrete_lagrangian L g g2 - 2%:R^-1 * \tr (lam *m orthogonality g).

Lemma slope_of_lagrangian L g0 g1 v0 v1 :
  slope (fun t => discrete_lagrangian L (g0 + t *: v0) (g1 + t *: v1))
        (\tr (v0 *m L *m g1^T) + \tr (g0 *m L *m v1^T)).
Proof.
have := slope_trace 1%:M L g0 v0 g1 v1; rewrite !mul1mx; apply: slope_eq => t.
by rewrite mul1mx.
Qed.

Lemma slope_of_constraint lam g v :
  (2%:R : R) \is a GRing.unit -> symmetric lam ->
  slope (fun t => 2%:R^-1 * \tr (lam *m orthogonality (g + t *: v))) (pairing v (lam *m g)).
Proof.
move=> two lam_sym.
have := slope_scale 2%:R^-1 (slope_add (slope_trace lam 1%:M g v g v) (slope_constant (- \tr lam))).
have -> : \tr (lam *m v *m 1%:M *m g^T) = \tr (lam *m g *m 1%:M *m v^T).
  by rewrite !mulmx1 trace_product_transpose trmx_mul trmxK lam_sym mulmxA mxtrace_mulC mulmxA.
rewrite addr0 half_twice // mulmx1 mxtrace_mulC => at_; apply: slope_eq at_ => t.
by rewrite mulmx1 /orthogonality mulmxBr mulmx1 trace_sub mulmxA.
Qed.

Lemma slope_of_terms L lam g0 g1 g2 v :
  symmetric L ->
  \tr (v *m L *m g2^T) + \tr (g0 *m L *m v^T) - pairing v (lam *m g1) =
  pairing v ((g2 + g0) *m L - lam *m g1).
Proof.
move=> L_sym; rewrite /pairing mulmxBr trace_sub mulmxDl mulmxDr mxtraceD; congr (_ + _ - _).
  by rewrite -mxtrace_tr !trmx_mul trmxK L_sym mulmxA mxtrace_mulC.
by rewrite mxtrace_mulC.
Qed.

(** ** Stationary sequences of the constrained action, (5.6)

Vary the configurations by any matrices \f$v_k\f$, with \f$v_0 = v_N = 0\f$. The slope of the action is
\f$\sum_k\langle v_k, (g_{k+1}+g_{k-1})\Lambda - \lambda_kg_k\rangle\f$. So a sequence is stationary exactly
where \f$(g_{k+1}+g_{k-1})\Lambda = \lambda_kg_k\f$ at all \f$0<k<N\f$. The matrices \f$\Lambda\f$ and
\f$\lambda_k\f$ must be symmetric; the configurations need not lie on the group. *)
Theorem eq_5_6_slope L lams gs vs N :
  (2%:R : R) \is a GRing.unit -> symmetric L -> (forall k, symmetric (lams k)) -> vs 0%N = 0 -> vs N = 0 ->
  slope (fun t => constrained_action L lams (fun k => gs k + t *: vs k) N)
        (\sum_(1 <= k < N) pairing (vs k) ((gs k.+1 + gs k.-1) *m L - lams k *m gs k)).
Proof.
move=> two L_sym lams_sym first last.
have slopes := slope_add
  (slope_sum (index_iota 0 N) (fun k => slope_of_lagrangian L (gs k) (gs k.+1) (vs k) (vs k.+1)))
  (slope_opp (slope_sum (index_iota 0 N.+1) (fun k => slope_of_constraint (gs k) (vs k) two (lams_sym k)))).
set d := \sum_(1 <= k < N) _; move: slopes; set d' := (X in slope _ X).
have -> : d' = d; last by apply: slope_eq => t; rewrite /constrained_action mulr_sumr.
rewrite /d' /d => {d d'}; case: N last => [|N] last.
  by rewrite !big_nil big_nat1 first /pairing trmx0 mul0mx mxtrace0 subr0.
(* Summation by parts: what stands with one variation is collected. *)
rewrite big_split /= big_ltn // first !mul0mx mxtrace0 add0r.
rewrite [X in _ + X - _]big_nat_recr //= last trmx0 mulmx0 mxtrace0 addr0.
rewrite [X in _ - X]big_ltn // [X in _ - (_ + X)]big_nat_recr //= first last /pairing trmx0.
rewrite !mul0mx mxtrace0 add0r addr0.
have -> : \sum_(0 <= k < N) \tr (gs k *m L *m (vs k.+1)^T) =
  \sum_(1 <= k < N.+1) \tr (gs k.-1 *m L *m (vs k)^T) by rewrite big_add1.
by rewrite -big_split -sumrB; apply: eq_bigr => k _; apply: slope_of_terms.
Qed.

Theorem eq_5_6 L lams gs N :
  (2%:R : R) \is a GRing.unit -> symmetric L -> (forall k, symmetric (lams k)) ->
  (forall vs, vs 0%N = 0 -> vs N = 0 ->
     slope (fun t => constrained_action L lams (fun k => gs k + t *: vs k) N) 0)
  <-> (forall k, (0 < k < N)%N -> (gs k.+1 + gs k.-1) *m L = lams k *m gs k).
Proof.
move=> two L_sym lams_sym; split=> [stationary k /andP[k_first k_last]|equations vs first last]; last first.
  have := eq_5_6_slope gs two L_sym lams_sym first last; rewrite big_nat big1 // => k between.
  by rewrite equations // subrr /pairing mulmx0 mxtrace0.
(* Vary one configuration alone. *)
apply/eqP; rewrite -subr_eq0; apply/eqP/pairing_nondegenerate => v; rewrite pairing_symmetric.
pose vs j := if j == k then v else 0.
have first : vs 0%N = 0 by rewrite /vs eq_sym (gtn_eqF k_first).
have last : vs N = 0 by rewrite /vs (gtn_eqF k_last).
rewrite -(slope_unique two (eq_5_6_slope gs two L_sym lams_sym first last) (stationary vs first last)).
rewrite (bigD1_seq k) ?mem_index_iota ?k_first ?iota_uniq //= {1}/vs eqxx big1 ?addr0 // => j ne.
by rewrite /vs (negbTE ne) /pairing trmx0 mul0mx mxtrace0.
Qed.

(** On the group the multiplier is determined, \f$\lambda_k = (g_{k+1}+g_{k-1})\Lambda g_k^T\f$. *)
Theorem eq_5_6_multiplier L lam g0 g1 g2 :
  orthogonal g1 -> (g2 + g0) *m L = lam *m g1 <-> lam = (g2 + g0) *m L *m g1^T.
Proof. by move=> o; split=> [->|->]; rewrite ?(turn_back _ o) ?(turn_forth _ o). Qed.

(** The relative motion \f$f_{k+1k} = g_{k+1}^{-1}g_k\f$.
C++: `actio::relative_motion_left`, `reduction/relative_motion.hpp`. *)
Definition relative_motion g0 g1 := invmx g1 *m g0.

(** The reduced Lagrangian \f$\ell(f) = \mathrm{Tr}(f\Lambda)\f$, and its derivative
\f$\ell'(f)\cdot v = \mathrm{Tr}(v\Lambda)\f$, the same at all \f$f\f$. *)
Definition reduced_lagrangian L f := \tr (f *m L).
Definition reduced_differential L v := \tr (v *m L).

Lemma relative_motionE g0 g1 : orthogonal g1 -> relative_motion g0 g1 = g1^T *m g0.
Proof. by move=> o; rewrite /relative_motion orthogonal_inverse. Qed.

Lemma reduced_differential_slope L f v :
  slope (fun t => reduced_lagrangian L (f + t *: v)) (reduced_differential L v).
Proof.
exists 0 => t; rewrite /reduced_lagrangian scale0r addr0 mulmxDl mxtraceD.
by rewrite -scalemxAl mxtraceZ mulr0 addr0.
Qed.

(** ** The reduced Lagrangian

The discrete Lagrangian is left-invariant and a function of the relative motion alone,
\f$\mathrm{Tr}(f_{k+1k}\Lambda)\f$, for any \f$\Lambda\f$. For a symmetric one it is the same for \f$f\f$
and \f$f^{-1}\f$. *)
Theorem claim_5_2_reduced_trace_lagrangian L (k : 'M_n) g0 g1 :
  orthogonal k -> orthogonal g1 ->
  discrete_lagrangian L (k *m g0) (k *m g1) = discrete_lagrangian L g0 g1 /\
  discrete_lagrangian L g0 g1 = reduced_lagrangian L (relative_motion g0 g1).
Proof.
move=> ok o1; rewrite relative_motionE // /discrete_lagrangian /reduced_lagrangian; split.
  by rewrite trmx_mul mxtrace_mulC !mulmxA (turn_forth _ ok) -mulmxA mxtrace_mulC.
by rewrite mxtrace_mulC !mulmxA.
Qed.

Theorem claim_5_2_reduced_trace_lagrangian_inverse L f :
  symmetric L -> orthogonal f -> reduced_lagrangian L (invmx f) = reduced_lagrangian L f.
Proof.
move=> L_sym o; rewrite /reduced_lagrangian orthogonal_inverse // trace_product_transpose trmxK L_sym.
by rewrite mxtrace_mulC.
Qed.

(** The multiplier in the body frame, \f$\bar\lambda_k = g_k^T\lambda_kg_k\f$.
C++: `actio::body_multiplier`, `rigid_body/multiplier.hpp`. *)
Definition body_multiplier g lam := g^T *m lam *m g.

Lemma body_multiplier_symmetric g lam : symmetric lam -> symmetric (body_multiplier g lam).
Proof. by rewrite /symmetric /body_multiplier !trmx_mul trmxK => ->; rewrite mulmxA. Qed.

(** ** The multiplier seen from the body

With \f$\bar\lambda_k = g_k^T\lambda_kg_k\f$, conjugated by the configuration itself, the equation
\f$(g_{k+1}+g_{k-1})\Lambda = \lambda_kg_k\f$ is \f$f_{k+1k}^T\Lambda + f_{kk-1}\Lambda = \bar\lambda_k\f$.
Only \f$g_k\f$ must be orthogonal. *)
Theorem claim_5_2_conjugate_multiplier L lam g0 g1 g2 (f10 := g1^T *m g0) (f21 := g2^T *m g1) :
  orthogonal g1 ->
  (g2 + g0) *m L = lam *m g1 <-> f21^T *m L + f10 *m L = body_multiplier g1 lam.
Proof.
move=> o; rewrite /body_multiplier trmx_mul trmxK -mulmxDl -mulmxDr -!mulmxA; split=> [->//|same].
by rewrite -[LHS]mul1mx -o -mulmxA same !mulmxA o mul1mx.
Qed.

(** Left multiplication of all configurations by \f$k\f$ takes \f$\lambda_k\f$ to \f$k\lambda_kk^T\f$ and
leaves \f$\bar\lambda_k\f$ as it is. *)
Theorem claim_5_2_conjugate_multiplier_invariant L lam g0 g1 g2 (k : 'M_n) :
  orthogonal k -> (g2 + g0) *m L = lam *m g1 ->
  (k *m g2 + k *m g0) *m L = (k *m lam *m k^T) *m (k *m g1) /\
  body_multiplier (k *m g1) (k *m lam *m k^T) = body_multiplier g1 lam.
Proof.
move=> o same; split; first by rewrite -mulmxDr -mulmxA same !mulmxA (turn_forth _ o).
by rewrite /body_multiplier trmx_mul !mulmxA !(turn_forth _ o).
Qed.

(** The operator on the variations \f$\vartheta_k = g_k^T\delta g_k\f$ that belongs to (5.6), and the
printed one. They differ in one place: \f$\vartheta_k^T\f$ stands for \f$-\vartheta_k\f$. *)
Definition operator_of_the_equation L f10 f21 theta :=
  reduced_differential L (right_translation f10 theta^T) +
  reduced_differential L (right_translation f21 (Ad f21 theta)).
Definition operator_as_printed L f10 f21 theta :=
  - reduced_differential L (right_translation f10 theta) +
  reduced_differential L (Ad f21 (right_translation f21 theta)).

Lemma operator_of_the_equationE L f10 f21 theta :
  f21 \in unitmx ->
  operator_of_the_equation L f10 f21 theta = \tr (theta^T *m f10 *m L) + \tr (f21 *m theta *m L).
Proof.
move=> unit; rewrite /operator_of_the_equation /reduced_differential /right_translation /Ad.
by rewrite -[f21 *m theta *m _ *m f21]mulmxA mulVmx // mulmx1.
Qed.

Lemma operator_as_printedE L f10 f21 theta :
  f21 \in unitmx ->
  operator_as_printed L f10 f21 theta = - \tr (theta *m f10 *m L) + \tr (f21 *m theta *m L).
Proof.
move=> unit; rewrite /operator_as_printed /reduced_differential /right_translation /Ad.
by rewrite !mulmxA -[f21 *m theta *m f21 *m _]mulmxA mulmxV // mulmx1.
Qed.

Lemma slope_at_a_configuration L lam g0 g1 g2 theta (f10 := g1^T *m g0) (f21 := g2^T *m g1) :
  (2%:R : R) \is a GRing.unit -> symmetric lam ->
  slope (fun t => terms_at L lam g0 g2 (g1 + t *: (g1 *m theta)))
        (\tr (theta^T *m f10 *m L) + \tr (f21 *m theta *m L) - \tr (body_multiplier g1 lam *m theta)).
Proof.
move=> two lam_sym.
have before := slope_of_lagrangian L g0 g1 0 (g1 *m theta).
have after := slope_of_lagrangian L g1 g2 (g1 *m theta) 0.
have held := slope_of_constraint g1 (g1 *m theta) two lam_sym.
have := slope_add (slope_add before after) (slope_opp held).
rewrite trmx0 !mul0mx mulmx0 !mxtrace0 add0r addr0.
have -> : pairing (g1 *m theta) (lam *m g1) = \tr (body_multiplier g1 lam *m theta).
  by rewrite /pairing -mxtrace_tr !trmx_mul !trmxK lam_sym /body_multiplier !mulmxA.
have <- : \tr (g0 *m L *m (g1 *m theta)^T) = \tr (theta^T *m f10 *m L).
  by rewrite trmx_mul mxtrace_mulC !mulmxA.
have <- : \tr (g1 *m theta *m L *m g2^T) = \tr (f21 *m theta *m L).
  by rewrite mxtrace_mulC !mulmxA.
by apply: slope_eq => t; rewrite /terms_at !scaler0 !addr0.
Qed.

Lemma trace_residual L lam f10 f21 theta :
  symmetric L -> symmetric lam ->
  \tr (theta^T *m f10 *m L) + \tr (f21 *m theta *m L) - \tr (lam *m theta) =
  pairing theta (f21^T *m L + f10 *m L - lam).
Proof.
move=> L_sym lam_sym.
rewrite /pairing mulmxBr mulmxDr trace_sub mxtraceD !mulmxA [\tr (_ *m lam)]mxtrace_mulC.
have -> : \tr (lam *m theta^T) = \tr (lam *m theta).
  by rewrite trace_product_transpose trmxK lam_sym mxtrace_mulC.
have -> : \tr (f21 *m theta *m L) = \tr (theta^T *m f21^T *m L).
  by rewrite trace_product_transpose L_sym trmx_mul mxtrace_mulC.
by rewrite [\tr _ + \tr _]addrC.
Qed.

(** ** The operator equation

The derivative of (5.6) along \f$\delta g_k = g_k\vartheta\f$, for any matrix \f$\vartheta\f$, is
\f[ \ell'(f_{kk-1})TR_{f_{kk-1}}\vartheta^T + \ell'(f_{k+1k})TR_{f_{k+1k}}\mathrm{Ad}_{f_{k+1k}}\vartheta
   - \mathrm{Tr}(\bar\lambda_k\vartheta) , \f]
and it vanishes for all \f$\vartheta\f$ exactly where the next equation of the thesis holds,
\f$f_{k+1k}^T\Lambda + f_{kk-1}\Lambda = \bar\lambda_k\f$. *)
Theorem claim_5_2_operator_equation_slope L lam g0 g1 g2 theta (f10 := g1^T *m g0) (f21 := g2^T *m g1) :
  (2%:R : R) \is a GRing.unit -> symmetric lam -> f21 \in unitmx ->
  slope (fun t => terms_at L lam g0 g2 (g1 + t *: (g1 *m theta)))
        (operator_of_the_equation L f10 f21 theta - \tr (body_multiplier g1 lam *m theta)).
Proof.
by move=> two lam_sym unit; rewrite operator_of_the_equationE //; apply: slope_at_a_configuration.
Qed.

Theorem claim_5_2_operator_equation L lam f10 f21 :
  symmetric L -> symmetric lam -> f21 \in unitmx ->
  (forall theta, operator_of_the_equation L f10 f21 theta = \tr (lam *m theta))
  <-> f21^T *m L + f10 *m L = lam.
Proof.
move=> L_sym lam_sym unit; split=> [same|same theta].
  apply/eqP; rewrite -subr_eq0; apply/eqP/pairing_nondegenerate => theta.
  by rewrite pairing_symmetric -trace_residual // -operator_of_the_equationE // same subrr.
apply/eqP; rewrite -subr_eq0 operator_of_the_equationE // trace_residual // same subrr.
by rewrite /pairing mulmx0 mxtrace0.
Qed.

(** For skew \f$\vartheta\f$ the printed operator is the same, and the multiplier drops out. *)
Theorem claim_5_2_operator_equation_skew L lam f10 f21 theta :
  (2%:R : R) \is a GRing.unit -> symmetric lam -> f21 \in unitmx -> skew theta ->
  operator_as_printed L f10 f21 theta = operator_of_the_equation L f10 f21 theta /\
  \tr (lam *m theta) = 0.
Proof.
move=> two lam_sym unit theta_skew; split; last exact: (proj2 (symmetric_test lam two)).
by rewrite operator_as_printedE // operator_of_the_equationE // theta_skew !mulNmx trace_opposite.
Qed.

(** ** The reduced equation with the multiplier

The slope of (5.6) along \f$g_k\vartheta\f$ is the pairing of \f$\vartheta\f$ with
\f$f_{k+1k}^T\Lambda + f_{kk-1}\Lambda - \bar\lambda_k\f$, so it vanishes for all matrices \f$\vartheta\f$
exactly where \f$f_{k+1k}^T\Lambda + f_{kk-1}\Lambda = \bar\lambda_k\f$. No configuration has to be
orthogonal.
C++: `actio::euler_poincare_with_multiplier`, `rigid_body/multiplier.hpp`. *)
Theorem claim_5_2_dep_with_multiplier_slope L lam g0 g1 g2 theta (f10 := g1^T *m g0) (f21 := g2^T *m g1) :
  (2%:R : R) \is a GRing.unit -> symmetric L -> symmetric lam ->
  slope (fun t => terms_at L lam g0 g2 (g1 + t *: (g1 *m theta)))
        (pairing theta (f21^T *m L + f10 *m L - body_multiplier g1 lam)).
Proof.
move=> two L_sym lam_sym; rewrite -trace_residual //; first exact: slope_at_a_configuration.
exact: body_multiplier_symmetric.
Qed.

Theorem claim_5_2_dep_with_multiplier L lam g0 g1 g2 (f10 := g1^T *m g0) (f21 := g2^T *m g1) :
  (2%:R : R) \is a GRing.unit -> symmetric L -> symmetric lam ->
  (forall theta, slope (fun t => terms_at L lam g0 g2 (g1 + t *: (g1 *m theta))) 0)
  <-> f21^T *m L + f10 *m L = body_multiplier g1 lam.
Proof.
move=> two L_sym lam_sym; split=> [stationary|equation theta].
  apply/eqP; rewrite -subr_eq0; apply/eqP/pairing_nondegenerate => theta; rewrite pairing_symmetric.
  have along := claim_5_2_dep_with_multiplier_slope g0 g1 g2 theta two L_sym lam_sym.
  exact: slope_unique two along (stationary theta).
have := claim_5_2_dep_with_multiplier_slope g0 g1 g2 theta two L_sym lam_sym.
by rewrite equation subrr /pairing mulmx0 mxtrace0.
Qed.

(** The equation of motion (5.7),
\f$f_{k+1k}^T\Lambda - \Lambda f_{k+1k} = \Lambda f_{kk-1}^T - f_{kk-1}\Lambda\f$.
C++: `actio::euler_poincare_without_multiplier`, `rigid_body/multiplier.hpp`. *)
Definition discrete_euler_poincare L f10 f21 := f21^T *m L - L *m f21 = L *m f10^T - f10 *m L.

Lemma discrete_euler_poincareE L f10 f21 :
  discrete_euler_poincare L f10 f21 <-> f21^T *m L + f10 *m L = L *m f10^T + L *m f21.
Proof. exact: four_terms. Qed.

(** The printed operator is not wrong for every multiplier: with \f$f\f$ defined by inverses in place of
transposes it belongs to another one, \f$\Lambda f_{k+1k} - f_{kk-1}\Lambda\f$, which is symmetric exactly
where (5.7) holds. *)
Theorem claim_5_2_operator_equation_other_multiplier L f10 f21 (lam := L *m f21 - f10 *m L) :
  symmetric L -> f21 \in unitmx ->
  (forall theta, operator_as_printed L f10 f21 theta = \tr (lam *m theta)) /\
  (symmetric lam <-> discrete_euler_poincare L f10 f21).
Proof.
move=> L_sym unit; split=> [theta|].
  rewrite operator_as_printedE // /lam mulmxBl trace_sub [LHS]addrC; congr (_ - _).
    by rewrite mxtrace_mulC mulmxA.
  by rewrite -!mulmxA mxtrace_mulC mulmxA.
rewrite discrete_euler_poincareE [X in _ = X]addrC /symmetric /lam transpose_sub !trmx_mul L_sym.
exact: four_terms.
Qed.

(** ** The algorithm without a multiplier, (5.7)

There is a symmetric \f$\bar\lambda_k\f$ with \f$f_{k+1k}^T\Lambda + f_{kk-1}\Lambda = \bar\lambda_k\f$
exactly where (5.7) holds. The matrices \f$f\f$ need not be orthogonal. *)
Theorem eq_5_7 L f10 f21 :
  symmetric L ->
  (exists2 lam, symmetric lam & f21^T *m L + f10 *m L = lam) <-> discrete_euler_poincare L f10 f21.
Proof.
move=> L_sym; rewrite discrete_euler_poincareE.
have <- : (f21^T *m L + f10 *m L)^T = L *m f10^T + L *m f21.
  by rewrite transpose_add !trmx_mul trmxK L_sym addrC.
split=> [[lam lam_sym ->]|same]; first by rewrite lam_sym.
by exists (f21^T *m L + f10 *m L).
Qed.

(** It is the discrete Euler-Poincaré equation (3.11),
\f$L^*_{f_{k+1k}}\ell'(f_{k+1k}) = R^*_{f_{kk-1}}\ell'(f_{kk-1})\f$ on \f$so(n)\f$, for
\f$\ell(f) = \mathrm{Tr}(f\Lambda)\f$, of which the differential is the covector \f$\Lambda\f$. *)
Theorem eq_5_7_from_3_11 L f10 f21 :
  (2%:R : R) \is a GRing.unit -> symmetric L ->
  (forall theta, skew theta -> pairing (L_star f21 L) theta = pairing (R_star f10 L) theta)
  <-> discrete_euler_poincare L f10 f21.
Proof.
move=> two L_sym; rewrite discrete_euler_poincareE.
transitivity (symmetric (L *m f21 - f10 *m L)).
  rewrite -symmetric_test //; split=> same theta theta_skew; move: (same theta theta_skew);
    rewrite /pairing /L_star /R_star !trmx_mul !trmxK L_sym mulmxBl trace_sub.
    by move->; rewrite subrr.
  by move/eqP; rewrite subr_eq0 => /eqP.
rewrite /symmetric transpose_sub !trmx_mul L_sym [X in _ <-> _ = X]addrC; exact: four_terms.
Qed.

(** Back in time: the inverse motions, exchanged, satisfy the same equation. *)
Theorem eq_5_7_back_in_time L f10 f21 :
  discrete_euler_poincare L f10 f21 <-> discrete_euler_poincare L f21^T f10^T.
Proof.
rewrite /discrete_euler_poincare !trmxK; split=> same; apply: oppr_inj; rewrite !opprB; exact: esym.
Qed.

(** Three configurations that satisfy the discrete Euler-Lagrange equation: the equation of (5.6) with a
symmetric multiplier. *)
Definition discrete_euler_lagrange L g0 g1 g2 :=
  exists2 lam, symmetric lam & (g2 + g0) *m L = lam *m g1.

(** ** The constrained action and the action on the group

The configurations satisfy the equation of (5.6) with some symmetric multiplier exactly where their relative
motions satisfy (5.7), and exactly where the sum without multipliers is stationary along the group, that is
for \f$\delta g_k = g_k\vartheta\f$ with skew \f$\vartheta\f$. *)
Theorem eq_5_6_motion L g0 g1 g2 :
  symmetric L -> orthogonal g1 ->
  discrete_euler_lagrange L g0 g1 g2 <-> discrete_euler_poincare L (g1^T *m g0) (g2^T *m g1).
Proof.
move=> L_sym o; rewrite -eq_5_7 //; split=> [[lam lam_sym]|[lam lam_sym]].
  move/(claim_5_2_conjugate_multiplier _ _ _ _ o) => same.
  by exists (body_multiplier g1 lam) => //; apply: body_multiplier_symmetric.
move=> same; exists (body_multiplier g1^T lam); first exact: body_multiplier_symmetric.
apply/(claim_5_2_conjugate_multiplier _ _ _ _ o); rewrite same /body_multiplier trmxK !mulmxA.
by rewrite (orthogonal_left o) mul1mx (turn_forth _ o).
Qed.

Theorem eq_5_6_on_the_group L g0 g1 g2 :
  (2%:R : R) \is a GRing.unit -> symmetric L -> orthogonal g1 ->
  (forall theta, skew theta ->
     slope (fun t => discrete_lagrangian L g0 (g1 + t *: (g1 *m theta)) +
                     discrete_lagrangian L (g1 + t *: (g1 *m theta)) g2) 0)
  <-> discrete_euler_lagrange L g0 g1 g2.
Proof.
move=> two L_sym o; rewrite eq_5_6_motion // -eq_5_7_from_3_11 //.
have slopes theta : skew theta ->
   slope (fun t => discrete_lagrangian L g0 (g1 + t *: (g1 *m theta)) +
                   discrete_lagrangian L (g1 + t *: (g1 *m theta)) g2)
   (pairing (L_star (g2^T *m g1) L) theta - pairing (R_star (g1^T *m g0) L) theta).
  move=> theta_skew; have zero_sym : symmetric (0 : 'M[R]_n) by rewrite /symmetric trmx0.
  have := slope_at_a_configuration L g0 g1 g2 theta two zero_sym.
  have -> : \tr (theta^T *m (g1^T *m g0) *m L) = - pairing (R_star (g1^T *m g0) L) theta.
    rewrite /pairing /R_star !trmx_mul !trmxK L_sym theta_skew !mulNmx trace_opposite; congr (- _).
    by rewrite -mulmxA mxtrace_mulC.
  have -> : \tr (g2^T *m g1 *m theta *m L) = pairing (L_star (g2^T *m g1) L) theta.
    by rewrite /pairing /L_star !trmx_mul !trmxK L_sym mxtrace_mulC !mulmxA.
  rewrite /body_multiplier mulmx0 !mul0mx mxtrace0 subr0 addrC; apply: slope_eq => t.
  by rewrite /terms_at mul0mx mxtrace0 mulr0 subr0.
split=> same theta theta_skew.
  by apply/eqP; rewrite -subr_eq0; apply/eqP/(slope_unique two (slopes theta theta_skew))/same.
by have := slopes theta theta_skew; rewrite same // subrr.
Qed.

End Multipliers.

(** ** The multiplier conjugated by other group elements

The printed \f$\bar\lambda_k = g^T\lambda_kg\f$ _for all_ \f$g\f$: with a quarter turn for \f$g\f$ it is not
the multiplier of the reduced equation, not even where the body stands still. *)
Theorem claim_5_2_conjugate_multiplier_printed_fails :
  ~ (forall L lam g0 g1 g2 g : 'M[Qc]_3, generalized_body L -> symmetric lam ->
       special_orthogonal g0 -> special_orthogonal g1 -> special_orthogonal g2 -> special_orthogonal g ->
       (g2 + g0) *m L = lam *m g1 ->
       (g2^T *m g1)^T *m L + (g1^T *m g0) *m L = body_multiplier g lam).
Proof.
pose lam := integers [:: [:: 2; 0; 0]; [:: 0; 6; 0]; [:: 0; 0; 4]].
have lam_sym : symmetric (matrix_of 3 lam) by decide_by_computation.
move/(_ _ _ _ _ _ _ the_body_is_one lam_sym no_turn_is_one no_turn_is_one no_turn_is_one quarter_turn_is_one).
rewrite /body_multiplier => printed.
have spatial : (matrix_of 3 no_turn + matrix_of 3 no_turn) *m matrix_of 3 the_body =
  matrix_of 3 lam *m matrix_of 3 no_turn by decide_by_computation.
by move: (printed spatial); decide_by_computation.
Qed.

(** ** The operator equation as it is printed

The printed operator with the multiplier of the equation that follows it in the thesis, for all matrices
\f$\vartheta\f$, as a multiplier is there to allow. It fails for a body at rest. *)
Theorem claim_5_2_operator_equation_printed_fails :
  ~ (forall L lam f10 f21 : 'M[Qc]_3, generalized_body L -> symmetric lam ->
       special_orthogonal f10 -> special_orthogonal f21 ->
       f21^T *m L + f10 *m L = lam ->
       forall theta, operator_as_printed L f10 f21 theta = \tr (lam *m theta)).
Proof.
pose lam := integers [:: [:: 2; 0; 0]; [:: 0; 6; 0]; [:: 0; 0; 4]].
have lam_sym : symmetric (matrix_of 3 lam) by decide_by_computation.
move/(_ _ _ _ _ the_body_is_one lam_sym no_turn_is_one no_turn_is_one) => printed.
pose one := matrix_of 3 no_turn; pose L := matrix_of 3 the_body.
have equation : one^T *m L + one *m L = matrix_of 3 lam by rewrite /one /L; decide_by_computation.
move: (printed equation one); rewrite /one /operator_as_printed /reduced_differential.
by decide_by_computation.
Qed.
