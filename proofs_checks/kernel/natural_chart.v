(** * Discretization in the natural chart

The algebra of section 3.3: the chart \f$\psi_g = \exp^{-1}\circ R_{g^{-1}}\f$, average and difference of two
configurations in it, the discrete Lagrangian made of them and its invariance, and the derivative of the
exponential map, power by power. Exponential and logarithm are any two functions of matrices; what is used of
them stands among the hypotheses of each theorem. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices dual_numbers computed groups.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope nat_scope.
Local Open Scope ring_scope.

Section Charts.

Variables (R : comUnitRingType) (n : nat) (log : 'M[R]_n -> 'M[R]_n).
Implicit Types (f g k q r v x y eta zeta : 'M[R]_n) (half s : R).

(** The chart at \f$g\f$ by right translation, \f$\psi_g(k) = \log(kg^{-1})\f$. C++:
`actio::natural_chart_right`, `reduction/natural_chart.hpp`. *)
Definition natural_chart_right g k := log (k *m invmx g).

(** \f$\eta = \tfrac12(\psi_g(g_1) + \psi_g(g_2))\f$ and \f$\zeta = s\,(\psi_g(g_2) - \psi_g(g_1))\f$, \f$s\f$
standing for \f$1/\Delta t\f$. C++: `actio::chart_midpoint_right`, `reduction/natural_chart.hpp`. *)
Definition chart_average half g g1 g2 := half *: (natural_chart_right g g1 + natural_chart_right g g2).
Definition chart_difference s g g1 g2 := s *: (natural_chart_right g g2 - natural_chart_right g g1).

(** ** The chart at a group element

(3.19): where exponential and logarithm are inverse to each other, \f$\psi_g\f$ has the inverse
\f$\psi_g^{-1}(x) = \exp(x)\,g\f$. *)

Theorem eq_3_19_of_matrices (exp : 'M[R]_n -> 'M[R]_n) g k x : g \in unitmx ->
  exp (log (k *m invmx g)) = k *m invmx g -> log (exp x) = x ->
  exp (natural_chart_right g k) *m g = k /\ natural_chart_right g (exp x *m g) = x.
Proof.
move=> u exp_log log_exp; rewrite /natural_chart_right exp_log -mulmxA mulVmx // mulmx1.
by rewrite -mulmxA mulmxV // mulmx1.
Qed.

(** ** Charts and right translation

The charts (3.19) go over into each other by right translation: \f$\psi_{gk}(qk) = \psi_g(q)\f$. This is all
that lemma 3.3.1 needs of them. *)
Theorem eq_3_19_equivariance g q k : g \in unitmx -> k \in unitmx ->
  natural_chart_right (g *m k) (q *m k) = natural_chart_right g q.
Proof.
move=> ug uk; rewrite /natural_chart_right inverse_product // mulmxA -[q *m k *m _]mulmxA mulmxV //.
by rewrite mulmx1.
Qed.

Lemma bracket_scale a b x y : bracket (a *: x) (b *: y) = (a * b) *: bracket x y.
Proof. by rewrite /bracket -!scalemxAl -!scalemxAr !scalerA [b * a]mulrC -scalerBr. Qed.

Lemma bracket_addl x y z : bracket (x + y) z = bracket x z + bracket y z.
Proof. by rewrite /bracket mulmxDl mulmxDr opprD addrACA. Qed.
Lemma bracket_addr x y z : bracket z (x + y) = bracket z x + bracket z y.
Proof. by rewrite /bracket mulmxDl mulmxDr opprD addrACA. Qed.
Lemma bracket_oppl x y : bracket (- x) y = - bracket x y.
Proof. by rewrite /bracket mulNmx mulmxN opprK opprB addrC. Qed.
Lemma bracket_self x : bracket x x = 0.
Proof. by rewrite /bracket subrr. Qed.

(** ** When average and difference commute

The bracket of difference and average in the chart at any \f$g\f$ is that of the two chart values:
\f$[\zeta, \eta] = \tfrac1{\Delta t}[\psi_g(g_2), \psi_g(g_1)]\f$. *)

Theorem bracket_of_average_and_difference half s g g1 g2 : half + half = 1 ->
  bracket (chart_difference s g g1 g2) (chart_average half g g1 g2)
  = s *: bracket (natural_chart_right g g2) (natural_chart_right g g1).
Proof.
move=> halves; rewrite bracket_scale; set x := natural_chart_right g g2; set y := natural_chart_right g g1.
rewrite bracket_addr !bracket_addl !bracket_oppl !bracket_self oppr0 addr0 add0r -bracket_skew.
by rewrite scalerDr -scalerDl -mulrDr halves mulr1.
Qed.

(** ** A chart centred at one of the two configurations

Section 3.3, above (3.24): there one of the chart values is \f$\log 1 = 0\f$, and \f$[\zeta, \eta] = 0\f$. *)
Theorem claim_3_3_fibre_element_commutes_of_matrices half s g1 g2 : g1 \in unitmx -> g2 \in unitmx ->
  half + half = 1 -> log 1%:M = 0 ->
  bracket (chart_difference s g1 g1 g2) (chart_average half g1 g1 g2) = 0
  /\ bracket (chart_difference s g2 g1 g2) (chart_average half g2 g1 g2) = 0.
Proof.
move=> u1 u2 halves log_1; rewrite !bracket_of_average_and_difference // /natural_chart_right.
by rewrite !mulmxV // log_1 /bracket !mulmx0 !mul0mx subrr scaler0.
Qed.

(** ** The series of the fibre element

Section 3.3, above (3.24): where \f$[\zeta, \eta] = 0\f$, of every power series of \f$-\mathrm{ad}_\eta\f$ on
\f$\zeta\f$ the constant term alone is left, \f$\sum_{k\le N}c_k(-\mathrm{ad}_\eta)^k\zeta = c_0\,\zeta\f$ for
every \f$N\f$ and all coefficients. For \f$\mathrm{iex}\f$, \f$c_k = 1/(k+1)!\f$, this is
\f$\mathrm{iex}(-\mathrm{ad}_\eta)\zeta = \zeta\f$. *)
Theorem claim_3_3_fibre_element_commutes_series eta zeta (c : nat -> R) N : bracket zeta eta = 0 ->
  \sum_(k < N.+1) c k *: iter k (fun y => - bracket eta y) zeta = c 0%N *: zeta.
Proof.
rewrite bracket_skew => /eqP; rewrite oppr_eq0 => /eqP commutes.
have vanishes (k : nat) : iter k.+1 (fun y => - bracket eta y) zeta = 0.
  elim: k => [|k IH]; first by rewrite /= commutes oppr0.
  by rewrite iterS IH /bracket mulmx0 mul0mx subrr oppr0.
by rewrite big_ord_recl big1 ?addr0 // => k _; rewrite lift0 vanishes scaler0.
Qed.

(** ** The average in the chart at the later configuration

Above (3.25): \f$\eta = \tfrac12\log(g_kg_{k+1}^{-1})\f$. *)

Theorem claim_3_3_midpoint_eta_of_matrices half g1 g2 : g2 \in unitmx -> log 1%:M = 0 ->
  chart_average half g2 g1 g2 = half *: log (relative_motion_right g1 g2).
Proof. by move=> u log_1; rewrite /chart_average /natural_chart_right mulmxV // log_1 addr0. Qed.

(** ** The difference in the chart at the later configuration

Above (3.25), with its minus: \f$\zeta = -\tfrac1{\Delta t}\log(g_kg_{k+1}^{-1})\f$. The later configuration
is the origin of the chart. *)

Theorem claim_3_3_midpoint_zeta_of_matrices s g1 g2 : g2 \in unitmx -> log 1%:M = 0 ->
  chart_difference s g2 g1 g2 = - (s *: log (relative_motion_right g1 g2)).
Proof. by move=> u log_1; rewrite /chart_difference /natural_chart_right mulmxV // log_1 sub0r scalerN. Qed.

(** ** The difference as a logarithm that looks forwards

Above (3.25): \f$\zeta = \tfrac1{\Delta t}\log(g_{k+1}g_k^{-1})\f$, where the logarithm of an inverse is minus
the logarithm. *)
Theorem claim_3_3_midpoint_zeta_forwards s g1 g2 : g1 \in unitmx -> g2 \in unitmx -> log 1%:M = 0 ->
  log (invmx (relative_motion_right g1 g2)) = - log (relative_motion_right g1 g2) ->
  chart_difference s g2 g1 g2 = s *: log (relative_motion_right g2 g1).
Proof.
move=> u1 u2 log_1; rewrite claim_3_3_midpoint_zeta_of_matrices // -scalerN => <-.
by rewrite /relative_motion_right inverse_product ?unitmx_inv // invmxK.
Qed.

End Charts.

(** ** The difference as printed

Printed is \f$\zeta = \tfrac1{\Delta t}\log(g_kg_{k+1}^{-1})\f$, without the minus. On upper triangular 2 by 2
matrices with ones on the diagonal the logarithm is \f$\log g = g - 1\f$; take \f$g_{k+1} = 1\f$ and
\f$\Delta t = 1\f$. *)
Theorem claim_3_3_midpoint_zeta_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (log : 'M[R]_n -> 'M[R]_n) (s : R) (g1 g2 : 'M[R]_n),
     g1 \in unitmx -> g2 \in unitmx -> log 1%:M = 0 ->
     chart_difference log s g2 g1 g2 = s *: log (relative_motion_right g1 g2)).
Proof.
move=> printed; pose log n (g : 'M[Qc]_n) := g - 1%:M.
pose g := integers [:: [:: 1; 1]; [:: 0; 1]].
have unit_g : matrix_of 2 g \in unitmx by decide_by_computation.
have := printed _ _ (log 2%N) 1 (matrix_of 2 g) 1%:M unit_g (unitmx1 _ _) (subrr _).
rewrite claim_3_3_midpoint_zeta_of_matrices ?unitmx1 // ?/log ?subrr // /relative_motion_right inverse_one.
by rewrite mulmx1 !scale1r; decide_by_computation.
Qed.

Section Midpoints.

Variables (R : comUnitRingType) (n : nat).

(** ** The configuration half-way

Above (3.25): with \f$\eta = \tfrac12\log(g_kg_{k+1}^{-1})\f$ the chart at \f$g_{k+1}\f$ takes
\f$q = \psi_{g_{k+1}}^{-1}(\eta) = e^\eta g_{k+1} = (g_kg_{k+1}^{-1})^{1/2}g_{k+1}\f$ to \f$\eta\f$. It is
half-way from \f$g_{k+1}\f$ to \f$g_k\f$: \f$qg_{k+1}^{-1}\f$ is \f$g_kq^{-1}\f$, and its square is
\f$g_kg_{k+1}^{-1}\f$. Of the exponential it is used that \f$e^{\eta+\eta} = e^\eta e^\eta\f$. *)
Theorem claim_3_3_midpoint_q_of_matrices (exp log : 'M[R]_n -> 'M[R]_n) (g1 g2 eta : 'M[R]_n) :
  g1 \in unitmx -> g2 \in unitmx -> let f := relative_motion_right g1 g2 in
  exp (log f) = f -> eta + eta = log f -> exp (eta + eta) = exp eta *m exp eta ->
  let q := exp eta *m g2 in
  [/\ relative_motion_right q g2 *m relative_motion_right q g2 = f,
      relative_motion_right g1 q = relative_motion_right q g2
    & log (exp eta) = eta -> natural_chart_right log g2 q = eta].
Proof.
move=> u1 u2 /= exp_log halves doubles; set f := relative_motion_right g1 g2.
have root : exp eta *m exp eta = f by rewrite -doubles halves.
have uf : f \in unitmx by apply: relative_motion_right_unit.
have u : exp eta \in unitmx by move: uf; rewrite -root unitmx_mul andbb.
have here : relative_motion_right (exp eta *m g2) g2 = exp eta.
  by rewrite /relative_motion_right -mulmxA mulmxV // mulmx1.
rewrite here; split=> //; last by rewrite /natural_chart_right -/(relative_motion_right _ g2) here.
rewrite /relative_motion_right inverse_product // mulmxA -/(relative_motion_right g1 g2) -/f -root.
by rewrite -mulmxA mulmxV // mulmx1.
Qed.

End Midpoints.

(** ** The configuration half-way as printed

Printed is \f$q = \psi_{g_{k+1}}(\eta) = (g_kg_{k+1})^{1/2}\f$, the root of another product. It differs
wherever \f$e^\eta\f$ and \f$g_{k+1}\f$ do not commute: take \f$\eta = E_{12}\f$, for which
\f$e^\eta = 1 + E_{12}\f$, and \f$g_{k+1} = 1 + E_{21}\f$. The square of \f$q\f$ is not \f$g_kg_{k+1}\f$, so
that \f$q\f$ is none of its roots. *)
Theorem claim_3_3_midpoint_q_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (exp log : 'M[R]_n -> 'M[R]_n) (g1 g2 eta : 'M[R]_n),
     g1 \in unitmx -> g2 \in unitmx -> let f := relative_motion_right g1 g2 in
     exp (log f) = f -> eta + eta = log f -> exp (eta + eta) = exp eta *m exp eta ->
     let q := exp eta *m g2 in q *m q = g1 *m g2).
Proof.
move=> printed.
have on_roots (R : comUnitRingType) (n : nat) (eta g2 : 'M[R]_n) : 1%:M + eta \in unitmx -> g2 \in unitmx ->
    eta *m eta = 0 -> (1%:M + eta) *m g2 *m ((1%:M + eta) *m g2) = (1%:M + eta) *m (1%:M + eta) *m g2 *m g2.
  move=> u u2 nilpotent; set r := 1%:M + eta.
  have square : r *m r = 1%:M + (eta + eta).
    by rewrite /r mulmxDl mul1mx mulmxDr mulmx1 nilpotent addr0 -addrA.
  have back : relative_motion_right (r *m r *m g2) g2 = r *m r.
    by rewrite /relative_motion_right -mulmxA mulmxV // mulmx1.
  apply: (printed R n (fun x => 1%:M + x) (fun g => g - 1%:M)) => //; rewrite ?back ?square //.
  - by rewrite -square !product_unit.
  - by rewrite addrC subrK.
  by rewrite [RHS]addrC addKr.
pose eta := integers [:: [:: 0; 1]; [:: 0; 0]]; pose g2 := integers [:: [:: 1; 0]; [:: 1; 1]].
have unit_r : 1%:M + matrix_of 2 eta \in unitmx by decide_by_computation.
have unit_g2 : matrix_of 2 g2 \in unitmx by decide_by_computation.
have nilpotent : matrix_of 2 eta *m matrix_of 2 eta = 0 by decide_by_computation.
by have := on_roots _ _ _ _ unit_r unit_g2 nilpotent; decide_by_computation.
Qed.

(** (3.20): \f$\mathbb L(g_1, g_2) = L\bigl(\psi_g^{-1}(\eta), (\psi_g^{-1})_*\zeta\bigr)\f$ with average
\f$\eta\f$ and difference \f$\zeta\f$ in the chart at \f$g\f$, which depends on \f$g_1\f$ and \f$g_2\f$. Since
\f$\psi_g^{-1}(x) = e^xg\f$, the push-forward of \f$\zeta\f$ at \f$\eta\f$ is the derivative of
\f$e^{\eta+\varepsilon\zeta}g\f$: the exponential is given on dual numbers. The values of \f$L\f$ may be of
any type. C++: `actio::discretize_right`, `reduction/natural_chart.hpp`. *)

Section Lagrangians.

Variables (R : comUnitRingType) (n : nat) (T : Type) (L : 'M[R]_n -> 'M[R]_n -> T).
Variables (exp : 'M[dual R]_n -> 'M[dual R]_n) (log : 'M[R]_n -> 'M[R]_n) (half s : R).
Implicit Types (g k q r v xi : 'M[R]_n) (base : 'M[R]_n -> 'M[R]_n -> 'M[R]_n).

Definition discretize_right base g1 g2 :=
  let g := base g1 g2 in
  let moving := exp (varied (chart_average log half g g1 g2) (chart_difference log s g g1 g2)) in
  L (value_of moving *m g) (rate_of moving *m g).

(** \f$L\f$ is right-invariant: \f$L(qk, vk) = L(q, v)\f$. *)
Definition right_invariant :=
  forall q v k, q \in unitmx -> k \in unitmx -> L (q *m k) (v *m k) = L q v.

(** ** Invariance is inherited

Lemma 3.3.1: where \f$L\f$ is right-invariant, \f$\mathbb L(g_1k, g_2k) = \mathbb L(g_1, g_2)\f$, provided
that the base point of the chart goes along, as the proof in the thesis has it:
\f$g(g_1k, g_2k) = g(g_1, g_2)\,k\f$. Of exponential and logarithm it is used only that the values of the
exponential are invertible. *)

Theorem lem_3_3_1_of_matrices base g1 g2 k : right_invariant -> (forall x, value_of (exp x) \in unitmx) ->
  k \in unitmx -> base g1 g2 \in unitmx ->
  base (g1 *m k) (g2 *m k) = base g1 g2 *m k ->
  discretize_right base (g1 *m k) (g2 *m k) = discretize_right base g1 g2.
Proof.
move=> invariant u uk ug along; rewrite /discretize_right along /chart_average /chart_difference.
by rewrite !eq_3_19_equivariance // !mulmxA invariant // product_unit.
Qed.

(** The chart by left translation, \f$\phi_g(k) = \log(g^{-1}k)\f$, and the discrete Lagrangian made with it.
C++: `actio::discretize_left`, `reduction/natural_chart.hpp`. *)
Definition natural_chart_left g k := log (invmx g *m k).

Definition discretize_left base g1 g2 :=
  let g := base g1 g2 in
  let first := natural_chart_left g g1 in
  let second := natural_chart_left g g2 in
  let moving := exp (varied (half *: (first + second)) (s *: (second - first))) in
  L (g *m value_of moving) (g *m rate_of moving).

Definition left_invariant :=
  forall q v k, q \in unitmx -> k \in unitmx -> L (k *m q) (k *m v) = L q v.

(** ** Invariance is inherited, left-invariant case

Lemma 3.3.1 for left-invariant \f$L\f$, with the charts \f$\phi_g(k) = \log(g^{-1}k)\f$. *)
Theorem lem_3_3_1_left base g1 g2 k : left_invariant -> (forall x, value_of (exp x) \in unitmx) ->
  k \in unitmx -> base g1 g2 \in unitmx -> base (k *m g1) (k *m g2) = k *m base g1 g2 ->
  discretize_left base (k *m g1) (k *m g2) = discretize_left base g1 g2.
Proof.
move=> invariant u uk ug along.
have same q : natural_chart_left (k *m base g1 g2) (k *m q) = natural_chart_left (base g1 g2) q.
  by rewrite /natural_chart_left inverse_product // mulmxA -[_ *m invmx k *m k]mulmxA mulVmx // mulmx1.
by rewrite /discretize_left along !same -!mulmxA invariant // product_unit.
Qed.

(** Base points at the earlier and at the later configuration go along. *)
Definition at_first g1 g2 : 'M[R]_n := g1.
Definition at_second g1 g2 : 'M[R]_n := g2.

(** ** The discrete Lagrangian in the chart at the later configuration

(3.24) with the corrected entries: \f$\mathbb L(g_k, g_{k+1}) = L(q, T_eR_q\zeta)\f$ with \f$q = rg_{k+1}\f$,
\f$r = e^\eta = (g_kg_{k+1}^{-1})^{1/2}\f$, and \f$\zeta = -\tfrac1{\Delta t}\log(g_kg_{k+1}^{-1})\f$. Of the
exponential it is used that \f$\frac{d}{d\varepsilon}e^{\eta+\varepsilon\zeta} = \zeta e^\eta\f$ for this
\f$\zeta\f$, which commutes with \f$\eta\f$. *)

Theorem eq_3_24_of_matrices r g1 g2 : g2 \in unitmx -> log 1%:M = 0 ->
  let eta := half *: log (relative_motion_right g1 g2) in
  let zeta := - (s *: log (relative_motion_right g1 g2)) in
  exp (varied eta zeta) = varied r (zeta *m r) ->
  let q := r *m g2 in
  discretize_right at_second g1 g2 = L q (right_translation q zeta).
Proof.
move=> u log_1 eta zeta commute; rewrite /discretize_right /at_second claim_3_3_midpoint_eta_of_matrices //.
by rewrite claim_3_3_midpoint_zeta_of_matrices // commute value_varied rate_varied /right_translation mulmxA.
Qed.

(** ** The reduced discrete Lagrangian

(3.25) with the corrected sign: for a right-invariant \f$L\f$ with \f$l(\xi) = L(1, \xi)\f$,
\f$\ell(f_{k,k+1}) = l(-\log(f_{k,k+1})/\Delta t)\f$. *)

Theorem eq_3_25_of_matrices r g1 g2 : right_invariant -> g2 \in unitmx -> r \in unitmx -> log 1%:M = 0 ->
  let f := relative_motion_right g1 g2 in
  let zeta := - (s *: log f) in
  exp (varied (half *: log f) zeta) = varied r (zeta *m r) ->
  discretize_right at_second g1 g2 = L 1%:M (- (s *: log f)).
Proof.
move=> invariant u ur log_1 /= commute; rewrite (eq_3_24_of_matrices u log_1 commute) /right_translation.
by rewrite -[X in L X _]mul1mx invariant ?unitmx1 // product_unit.
Qed.

End Lagrangians.

(** ** The reduced discrete Lagrangian as printed

Printed is \f$\ell(f_{k,k+1}) = l(\log(f_{k,k+1})/\Delta t)\f$. The relative motion looks back, and with a
Lagrangian that is not even the two differ. Take upper triangular 2 by 2 matrices with ones on the diagonal,
where \f$e^x = 1 + x\f$, and \f$L(q, v) = (vq^{-1})_{12}\f$. *)
Theorem eq_3_25_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (T : Type) (L : 'M[R]_n -> 'M[R]_n -> T)
     (exp : 'M[dual R]_n -> 'M[dual R]_n) (log : 'M[R]_n -> 'M[R]_n) (half s : R) (r g1 g2 : 'M[R]_n),
     right_invariant L -> half + half = 1 -> g1 \in unitmx -> g2 \in unitmx -> r \in unitmx -> log 1%:M = 0 ->
     let f := relative_motion_right g1 g2 in
     let zeta := - (s *: log f) in
     exp (varied (half *: log f) zeta) = varied r (zeta *m r) ->
     discretize_right L exp log half s (@at_second R n) g1 g2 = L 1%:M (s *: log f)).
Proof.
move=> printed.
have on_nilpotent (R : comUnitRingType) (n : nat) (half : R) (x : 'M[R]_n) i j : half + half = 1 ->
    1%:M + x \in unitmx -> 1%:M + half *: x \in unitmx -> x *m x = 0 -> (- x) i j = x i j.
  move=> halves u_f u_r nilpotent.
  pose L q v : R := (v *m invmx q) i j; pose log (g : 'M[R]_n) := g - 1%:M.
  have invariant : right_invariant L.
    by move=> q v k uq uk; rewrite /L inverse_product // mulmxA -[v *m k *m _]mulmxA mulmxV // mulmx1.
  have f_is : log (relative_motion_right (1%:M + x) 1%:M) = x.
    by rewrite /log /relative_motion_right inverse_one mulmx1 addrC addKr.
  have log_1 : log 1%:M = 0 by rewrite /log subrr.
  have along : 1%:M + varied (half *: x) (- (1 *: x))
      = varied (1%:M + half *: x) (- (1 *: x) *m (1%:M + half *: x)).
    rewrite -varied_one varied_add add0r mulmxDr mulmx1 -scalemxAr mulNmx scale1r nilpotent.
    by rewrite oppr0 scaler0 addr0.
  have := printed R n R L (fun X => 1%:M + X) log half 1 (1%:M + half *: x) (1%:M + x) 1%:M.
  move=> /(_ invariant halves u_f).
  rewrite /= f_is => /(_ (unitmx1 _ _) u_r log_1 along).
  rewrite (@eq_3_25_of_matrices _ _ _ _ _ _ _ _ (1%:M + half *: x)) ?unitmx1 // ?f_is //.
  by rewrite /L inverse_one !mulmx1 !scale1r.
pose x := integers [:: [:: 0; 1]; [:: 0; 0]].
have halves : rational 1 2 + rational 1 2 = 1 by apply/eqP; vm_compute.
have unit_f : 1%:M + matrix_of 2 x \in unitmx by decide_by_computation.
have unit_r : 1%:M + rational 1 2 *: matrix_of 2 x \in unitmx by decide_by_computation.
have nilpotent : matrix_of 2 x *m matrix_of 2 x = 0 by decide_by_computation.
have := on_nilpotent _ _ _ _ 0 1 halves unit_f unit_r nilpotent; rewrite !mxE => /eqP.
by vm_compute.
Qed.

Section Exponential.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (x y eta zeta : 'M[R]_n).

Definition power (S : ringType) (x : 'M[S]_n) m := iter m (mulmx x) 1%:M.

(** \f$\mathrm{ad}_\eta^k\zeta\f$. *)
Definition ad_power eta zeta k := iter k (ad eta) zeta.

Lemma power_varied eta zeta m : value_of (power (varied eta zeta) m) = power eta m.
Proof.
elim: m => [|m IH]; first by rewrite -[X in value_of X]varied_one value_varied.
by rewrite [power _ _]iterS [iter m _ _]variedE varied_mul value_varied IH.
Qed.

(** ** The derivative of a power

\f$\sum_{i+j=m-1}\eta^i\zeta\,\eta^j = \sum_{k<m}\binom{m}{k+1}\,\mathrm{ad}_\eta^k\zeta\;\eta^{m-1-k}\f$: the
left side is the derivative of \f$x\mapsto x^m\f$ at \f$\eta\f$ along \f$\zeta\f$. *)
Theorem derivative_of_power eta zeta m : rate_of (power (varied eta zeta) m)
  = \sum_(k < m) (ad_power eta zeta k *m power eta (m - k.+1)%N) *+ 'C(m, k.+1).
Proof.
elim: m => [|m IH].
  by rewrite big_ord0 -[X in rate_of X]varied_one rate_varied.
rewrite [power _ _]iterS [iter m _ _]variedE varied_mul rate_varied.
rewrite -/(power _ m) power_varied IH.
(* Eta goes to the right through every bracket, and leaves one more bracket behind. *)
have through k j : eta *m (ad_power eta zeta k *m power eta j)
    = ad_power eta zeta k *m power eta j.+1 + ad_power eta zeta k.+1 *m power eta j.
  rewrite /= /ad /bracket mulmxBl -!mulmxA addrC subrK //.
pose term k := ad_power eta zeta k *m power eta (m - k)%N.
have -> : eta *m (\sum_(k < m) (ad_power eta zeta k *m power eta (m - k.+1)%N) *+ 'C(m, k.+1))
    = \sum_(k < m) (term k *+ 'C(m, k.+1) + term k.+1 *+ 'C(m, k.+1)).
  rewrite mulmx_sumr; apply: eq_bigr => k _; rewrite -!scaler_nat -scalemxAr through scalerDr /term.
  by rewrite -subSn // subSS.
rewrite big_split /= -addrA.
have -> : \sum_(k < m) term k *+ 'C(m, k.+1) = \sum_(k < m.+1) term k *+ 'C(m, k.+1).
  by rewrite big_ord_recr /= bin_small // mulr0n addr0.
have -> : (\sum_(k < m) term k.+1 *+ 'C(m, k.+1)) + zeta *m power eta m = \sum_(k < m.+1) term k *+ 'C(m, k).
  by rewrite big_ord_recl /= bin0 mulr1n /term subn0 addrC.
by rewrite -big_split; apply: eq_bigr => k _; rewrite /= -mulrnDr -binS /term subSS.
Qed.

(** ** The derivative of the exponential map, power by power

Section 3.3, above (3.21), with the corrected sign:
\f$T_\eta\exp = T_eR_{g'}\cdot\mathrm{iex}(\mathrm{ad}_\eta)\f$ with \f$g' = e^\eta\f$ and
\f$\mathrm{iex}(w) = \sum_kw^k/(k+1)!\f$. Both sides are sums of terms with one factor \f$\zeta\f$ and
\f$m - 1\f$ factors \f$\eta\f$, \f$m = 1, 2, \dots\f$; on the left these are the derivative of \f$x^m/m!\f$,
on the right the \f$\frac{\mathrm{ad}^k_\eta\zeta}{(k+1)!}\,\frac{\eta^{m-1-k}}{(m-1-k)!}\f$. They agree for
each \f$m\f$. Nothing is said of convergence. *)
Theorem claim_3_3_derivative_of_exponential_power_by_power (c : nat -> R) eta zeta m :
  (forall k, c k * k`!%:R = 1) ->
  c m *: rate_of (power (varied eta zeta) m)
  = \sum_(k < m) (c k.+1 *: ad_power eta zeta k) *m (c (m - k.+1)%N *: power eta (m - k.+1)%N).
Proof.
move=> factorials; rewrite derivative_of_power scaler_sumr; apply: eq_bigr => k _.
rewrite -scalemxAl -scalemxAr scalerA -scaler_nat scalerA; congr (_ *: _).
have := bin_fact (ltn_ord k) => fact.
have expand (x C A B u v : R) : u * A = 1 -> v * B = 1 -> x * C = x * (C * (A * B)) * (u * v).
  move=> uA vB; rewrite -[RHS]mulrA -[C * _ * _]mulrA [A * B * _]mulrACA [A * u]mulrC uA [B * v]mulrC vB.
  by rewrite !mulr1.
rewrite (expand _ _ _ _ _ _ (factorials k.+1) (factorials (m - k.+1)%N)) -!natrM fact.
by rewrite factorials mul1r.
Qed.

End Exponential.

(** ** The derivative of the exponential map as printed

Printed is \f$T_\eta\exp = T_eR_{g'}\cdot\mathrm{iex}(-\mathrm{ad}_\eta)\f$, with
\f$\mathrm{ad}_\eta\zeta = [\eta, \zeta] = \eta\zeta - \zeta\eta\f$. The terms with \f$m = 2\f$ differ
wherever \f$\eta\f$ and \f$\zeta\f$ do not commute: \f$\tfrac12(\eta\zeta + \zeta\eta)\f$ is not
\f$\zeta\eta - \tfrac12[\eta, \zeta]\f$, with \f$\eta = E_{12}\f$ and \f$\zeta = E_{21}\f$. *)
Theorem claim_3_3_derivative_of_exponential_printed_fails_power_by_power :
  ~ (forall (R : comUnitRingType) (n : nat) (c : nat -> R) (eta zeta : 'M[R]_n) (m : nat),
     (forall k, c k * k`!%:R = 1) ->
     c m *: rate_of (power (varied eta zeta) m)
     = \sum_(k < m)
         (c k.+1 *: iter k (fun y => - ad eta y) zeta) *m (c (m - k.+1)%N *: power eta (m - k.+1)%N)).
Proof.
move=> printed; pose c k : rat := (k`!%:R)^-1.
have factorials k : c k * k`!%:R = 1 by rewrite /c mulVf // Num.Theory.pnatr_eq0 -lt0n fact_gt0.
pose eta : 'M[rat]_2 := delta_mx 0 1; pose zeta : 'M[rat]_2 := delta_mx 1 0.
have := printed _ _ c eta zeta 2%N factorials; rewrite claim_3_3_derivative_of_exponential_power_by_power //.
rewrite !big_ord_recl !big_ord0 !addr0 /= => /addrI.
rewrite -!scalemxAr !mulmx1 !scalerA /ad /bracket !mul_delta_mx => /matrixP /(_ 0 0).
by rewrite !mxE /= => /eqP; vm_compute.
Qed.
