(** * Variations of curves

Chapter 2 and the proof of theorem 3.2.1 as far as they are algebra. A family of curves of matrices that
depends on a time \f$t\f$ and on a parameter \f$\epsilon\f$ is an element of a ring, noncommutative, on
which \f$\frac{d}{dt}\f$ and \f$\frac{d}{d\epsilon}\f$ are derivations that commute; its invertible elements
are families of curves in the group. The theorems hold in every ring with such derivations. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Derivations *)

(** Additive maps with Leibniz' rule. *)
Definition derivation (A : ringType) (d : A -> A) :=
  (forall x y, d (x + y) = d x + d y) /\ (forall x y, d (x * y) = d x * y + x * d y).

Section Derivations.

Variables (A : ringType) (d : A -> A).
Hypothesis der : derivation d.

Lemma der0 : d 0 = 0.
Proof. by apply: (addrI (d 0)); rewrite -(proj1 der) !addr0. Qed.

Lemma derN x : d (- x) = - d x.
Proof. by apply/eqP; rewrite -addr_eq0 -(proj1 der) addNr der0. Qed.

Lemma derB x y : d (x - y) = d x - d y.
Proof. by rewrite (proj1 der) derN. Qed.

Lemma der1 : d 1 = 0.
Proof. by apply: (addrI (d 1)); rewrite addr0 -[RHS](congr1 d (mulr1 1)) (proj2 der) mulr1 mul1r. Qed.

Lemma der_sum I (r : seq I) (P : pred I) (F : I -> A) :
  d (\sum_(i <- r | P i) F i) = \sum_(i <- r | P i) d (F i).
Proof. by apply: (big_morph d (proj1 der) der0). Qed.

(** The derivative of an inverse. *)
Lemma der_inverse g h : h * g = 1 -> g * h = 1 -> d h = - (h * d g * h).
Proof.
move=> hg gh; have := congr1 (fun x => h * d x) gh; rewrite der1 mulr0 (proj2 der) mulrDr !mulrA hg mul1r.
by move/addr0_eq.
Qed.

End Derivations.

Section Curves.

Variable A : unitRingType.
Implicit Types (d delta dot : A -> A) (f g xi eta : A).

Lemma derV d g : derivation d -> g \is a GRing.unit -> d g^-1 = - (g^-1 * d g * g^-1).
Proof. by move=> der unit; apply: der_inverse => //; rewrite ?mulVr ?mulrV. Qed.

(** The commutator, and \f$\mathrm{ad}_\xi\eta = [\xi, \eta]\f$ (theorem 2.2.3).
C++: `actio::ad`, `groups/group.hpp`. *)
Definition commutator xi eta := xi * eta - eta * xi.
Definition algebra_ad xi eta := commutator xi eta.

(** \f$(dg)g^{-1}\f$ and \f$g^{-1}dg\f$: a velocity or a variation, translated to the identity. *)
Definition from_right d g := d g / g.
Definition from_left d g := g^-1 * d g.

(** ** Variation of the reduced velocity, with ad

Section 2.2, condition iv of theorem 2.2.1: for \f$\xi = \dot g\,g^{-1}\f$ and \f$\eta = \delta g\,g^{-1}\f$,
\f[ \delta\xi = \dot\eta - \mathrm{ad}_\xi\eta . \f] *)
Theorem claim_2_2_reduced_variation_ad_of_curves delta dot g :
  derivation delta -> derivation dot -> (forall x, delta (dot x) = dot (delta x)) -> g \is a GRing.unit ->
  let xi := from_right dot g in let eta := from_right delta g in
  delta xi = dot eta - algebra_ad xi eta.
Proof.
move=> vary move_ commute unit xi eta; rewrite /xi /eta /from_right !(proj2 vary) !(proj2 move_).
rewrite (derV vary unit) (derV move_ unit).
(* The second derivatives of g cancel, since the derivations commute. *)
by rewrite commute /algebra_ad /commutator !mulrN !mulrA opprB addrA subrK.
Qed.

(** ** Variation of the reduced velocity, with the bracket

Section 2.2, corrected: \f$\delta\xi = \dot\eta - [\xi, \eta]\f$ for \f$\xi = \dot g\,g^{-1}\f$, \f$\eta =
\delta g\,g^{-1}\f$. The plus sign belongs to \f$\xi = g^{-1}\dot g\f$ and \f$\eta = g^{-1}\delta g\f$, the
left-invariant case: \f$\delta\xi = \dot\eta + [\xi, \eta]\f$. *)
Theorem claim_2_2_reduced_variation_bracket_in_a_ring delta dot g :
  derivation delta -> derivation dot -> (forall x, delta (dot x) = dot (delta x)) -> g \is a GRing.unit ->
  delta (from_right dot g) = dot (from_right delta g) - commutator (from_right dot g) (from_right delta g)
  /\ delta (from_left dot g) = dot (from_left delta g) + commutator (from_left dot g) (from_left delta g).
Proof.
move=> vary move_ commute unit; split; first exact: claim_2_2_reduced_variation_ad_of_curves.
rewrite /from_left !(proj2 vary) !(proj2 move_) (derV vary unit) (derV move_ unit) commute /commutator.
rewrite !mulNr !mulrA.
by rewrite [LHS]addrC [X in _ = X + _]addrC addrA subrK.
Qed.

(** ** How the relative motion varies with its configurations

Theorem 3.2.1, condition (3): for \f$f = g_0g_1^{-1}\f$,
\f[ \delta f = TR_f\bigl(\delta g_0\,g_0^{-1} - \mathrm{Ad}_f\cdot\delta g_1\,g_1^{-1}\bigr), \f]
where \f$TR_f\f$ is the product with \f$f\f$ on the right and \f$\mathrm{Ad}_fx = fxf^{-1}\f$. *)
Theorem claim_3_2_variation_of_f_of_curves delta g0 g1 :
  derivation delta -> g0 \is a GRing.unit -> g1 \is a GRing.unit ->
  let f := g0 / g1 in
  delta f = (delta g0 / g0 - f * (delta g1 / g1) * f^-1) * f.
Proof.
move=> vary unit0 unit1 f; have unit : f \is a GRing.unit by rewrite unitrMl ?unitrV.
rewrite mulrBl (mulrVK unit) /f (proj2 vary) (derV vary unit1) mulrN !mulrA.
by rewrite (mulrVK unit0).
Qed.

(** The pull-backs of a form on matrices by the translations: \f$R_f^*p = p\circ TR_f\f$, \f$L_f^*p = p\circ
TL_f\f$. *)
Definition R_pull (W : Type) f (p : A -> W) theta := p (theta * f).
Definition L_pull (W : Type) f (p : A -> W) theta := p (f * theta).

(** ** The derivative of the reduced action sum, line by line

The proof of theorem 3.2.1, (3) and (4), as printed: with \f$f_{kk+1} = g_kg_{k+1}^{-1}\f$,
\f$\vartheta_k = \delta g_k\,g_k^{-1}\f$ and \f$\delta g_0 = \delta g_N = 0\f$,
\f[ \frac{d}{d\epsilon}s
  = \sum_{k=0}^{N-1}\ell'(f_{kk+1})
    \bigl[\delta g_kg_{k+1}^{-1} - g_kg_{k+1}^{-1}\delta g_{k+1}g_{k+1}^{-1}\bigr] \f]
\f[ = \sum_{k=1}^{N-1}\ell'(f_{kk+1})\delta g_kg_k^{-1}g_kg_{k+1}^{-1}
  - \sum_{r=1}^{N-1}\ell'(f_{r-1r})g_{r-1}g_r^{-1}\delta g_rg_r^{-1} \f]
\f[ = \sum_{k=1}^{N-1}
    \bigl(\ell'(f_{kk+1})TR_{f_{kk+1}} - \ell'(f_{k-1k})TL_{f_{k-1k}}\bigr)\delta g_kg_k^{-1}
  = \sum_{k=1}^{N-1}\bigl(R_{f_{kk+1}}^*\ell'(f_{kk+1}) - L_{f_{k-1k}}^*\ell'(f_{k-1k})\bigr)\vartheta_k . \f]
The start is the chain rule, \f$\frac{d}{d\epsilon}\ell(f) = \ell'(f)\cdot\delta f\f$. Any \f$N\f$ will
do, and \f$\ell'(f)\f$ is any additive map. *)
Theorem claim_3_2_proof_computation_in_a_ring (W : zmodType) delta (g : nat -> A) (ell' : A ->
  {additive A -> W}) N :
  derivation delta -> (forall k, g k \is a GRing.unit) -> delta (g 0%N) = 0 -> delta (g N) = 0 ->
  let f k := g k / g k.+1 in
  [/\ \sum_(0 <= k < N) ell' (f k) (delta (f k))
      = \sum_(0 <= k < N) ell' (f k) (delta (g k) / g k.+1 - g k / g k.+1 * delta (g k.+1) / g k.+1),
      \sum_(0 <= k < N) ell' (f k) (delta (g k) / g k.+1 - g k / g k.+1 * delta (g k.+1) / g k.+1)
      = \sum_(1 <= k < N) ell' (f k) (delta (g k) / g k * g k / g k.+1)
        - \sum_(1 <= r < N) ell' (f r.-1) (g r.-1 / g r * delta (g r) / g r),
      \sum_(1 <= k < N) ell' (f k) (delta (g k) / g k * g k / g k.+1)
        - \sum_(1 <= r < N) ell' (f r.-1) (g r.-1 / g r * delta (g r) / g r)
      = \sum_(1 <= k < N) (ell' (f k) (delta (g k) / g k * f k)
                           - ell' (f k.-1) (f k.-1 * (delta (g k) / g k)))
    & \sum_(1 <= k < N) (ell' (f k) (delta (g k) / g k * f k)
                         - ell' (f k.-1) (f k.-1 * (delta (g k) / g k)))
      = \sum_(1 <= k < N) (R_pull (f k) (ell' (f k)) (from_right delta (g k))
                           - L_pull (f k.-1) (ell' (f k.-1)) (from_right delta (g k)))].
Proof.
move=> vary unit at_start at_end f; split=> //.
- apply: eq_bigr => k _; rewrite {2}/f (proj2 vary) (derV vary (unit _)) mulrN !mulrA //.
- under eq_bigr do rewrite raddfB.
  case: N at_end => [|n] at_end; first by rewrite !big_geq // subr0.
  (* Discrete integration by parts: the ends do not vary. *)
  rewrite sumrB big_nat_recl // at_start mul0r raddf0 add0r [X in _ - X]big_nat_recr //=.
  rewrite at_end mulr0 mul0r raddf0 addr0 !(big_add1 _ _ 0) /=.
  by congr (_ - _); apply: eq_bigr => k _; rewrite (mulrVK (unit _)).
- rewrite sumrB; congr (_ - _); apply: eq_big_nat => -[//|k] _; rewrite ?mulrA //.
Qed.

End Curves.

(** ** Euler-Poincare reduction *)

Section EulerPoincare.

(** Velocities are elements of a ring, momenta of an abelian group, paired with values in another; a dot is
the derivative by time of each. *)
Variables (A : unitRingType) (M W : zmodType) (pair : M -> A -> W).
Variables (dot : A -> A) (dotM : M -> M) (dotW : W -> W) (algebra_ad_star : A -> M -> M).
Hypothesis pairDr : forall mu x y, pair mu (x + y) = pair mu x + pair mu y.
Hypothesis pairDl : forall mu nu x, pair (mu + nu) x = pair mu x + pair nu x.
Hypothesis leibniz : forall mu x, dotW (pair mu x) = pair (dotM mu) x + pair mu (dot x).
Hypothesis dual : forall xi mu x, pair (algebra_ad_star xi mu) x = pair mu (algebra_ad xi x).

Lemma pair0r mu : pair mu 0 = 0.
Proof. by apply: (addrI (pair mu 0)); rewrite -pairDr !addr0. Qed.
Lemma pairNr mu x : pair mu (- x) = - pair mu x.
Proof. by apply/eqP; rewrite -addr_eq0 -pairDr addNr pair0r. Qed.

(** The left sides of the Euler-Poincare equations, \f$\dot\mu + \mathrm{ad}_\xi^*\mu\f$ for right-invariant
and \f$\dot\mu - \mathrm{ad}_\xi^*\mu\f$ for left-invariant systems, where \f$\mu = \frac{\delta
l}{\delta\xi}\f$. C++: `actio::euler_poincare_right`, `variational/euler_poincare.hpp`. *)
Definition euler_poincare_equation xi mu := dotM mu + algebra_ad_star xi mu.
(** C++: `actio::euler_poincare_left`, `variational/euler_poincare.hpp`. *)
Definition euler_poincare_equation_left xi mu := dotM mu - algebra_ad_star xi mu.

(** ** Conditions ii and iv of Euler-Poincare reduction

Theorem 2.2.1: let the integrand vary by the chain rule, \f$\delta l = \langle\mu, \delta\xi\rangle\f$. Every
variation of \f$g\f$ varies it by \f$\langle\mu, \dot\eta - \mathrm{ad}_\xi\eta\rangle\f$,
\f$\eta = \delta g\,g^{-1}\f$, so that the two variational principles are one. *)
Theorem thm_2_2_1_two_four (delta : A -> A) g mu (delta_l : W) :
  derivation delta -> derivation dot -> (forall x, delta (dot x) = dot (delta x)) -> g \is a GRing.unit ->
  delta_l = pair mu (delta (from_right dot g)) ->
  let xi := from_right dot g in let eta := from_right delta g in
  delta_l = pair mu (dot eta - algebra_ad xi eta).
Proof.
by move=> vary move_ commute unit -> xi eta; rewrite (claim_2_2_reduced_variation_ad_of_curves vary).
Qed.

(** ** Integration by parts in the algebra

Theorem 2.2.1, iii and iv, off shell: \f$\langle\mu, \dot\eta - \mathrm{ad}_\xi\eta\rangle =
\frac{d}{dt}\langle\mu, \eta\rangle - \langle\dot\mu + \mathrm{ad}_\xi^*\mu, \eta\rangle\f$. *)
Theorem thm_2_2_1_by_parts xi eta mu :
  pair mu (dot eta - algebra_ad xi eta) = dotW (pair mu eta) - pair (euler_poincare_equation xi mu) eta.
Proof. by rewrite pairDr pairNr leibniz pairDl dual opprD addrA [pair (dotM _) _ + _]addrC addrK. Qed.

(** ** The variation with the plus sign

The printed member of condition iv, \f$\dot\eta + [\xi, \eta]\f$, belongs to the left-invariant case: with
it the same integration by parts gives \f$\dot\mu = +\mathrm{ad}_\xi^*\mu\f$. *)
Theorem claim_2_2_left_reduction_by_parts xi eta mu :
  pair mu (dot eta + commutator xi eta)
  = dotW (pair mu eta) - pair (euler_poincare_equation_left xi mu) eta.
Proof.
have pairNl nu x : pair (- nu) x = - pair nu x.
  by apply/eqP; rewrite -addr_eq0 -pairDl addNr; apply/eqP/(addrI (pair 0 x)); rewrite -pairDl !addr0.
by rewrite pairDr leibniz pairDl pairNl dual opprB addrCA addrA addrAC addrA subrK addrC.
Qed.

Section Integral.

(** The integral over time, an additive map; \f$\eta\f$ vanishes at the ends, so that
\f$\int\frac{d}{dt}\langle\mu, \eta\rangle\,dt = 0\f$. *)
Variables (K : zmodType) (integral : {additive W -> K}) (held : A -> Prop).
Hypothesis newton : forall mu eta, held eta -> integral (dotW (pair mu eta)) = 0.
(** The fundamental lemma of the calculus of variations, for the right sides that occur. *)
Hypothesis fundamental : forall mu, (forall eta, held eta -> integral (pair mu eta) = 0) -> mu = 0.

(** ** Conditions iii and iv of Euler-Poincare reduction

Theorem 2.2.1, corrected: the Euler-Poincare equation \f$\dot\mu = -\mathrm{ad}_\xi^*\mu\f$ holds if and
only if \f$\int\langle\mu, \dot\eta - [\xi, \eta]\rangle\,dt = 0\f$ for all \f$\eta\f$ that vanish at the
ends. Of the integral it is used that it is additive, that total derivatives integrate to zero, and the
fundamental lemma of the calculus of variations. *)
Theorem thm_2_2_1_three_four xi mu :
  dotM mu = - algebra_ad_star xi mu
  <-> forall eta, held eta -> integral (pair mu (dot eta - commutator xi eta)) = 0.
Proof.
have by_parts eta := thm_2_2_1_by_parts xi eta mu; rewrite /algebra_ad in by_parts.
split=> [equation eta ends | still].
  rewrite by_parts raddfB /= newton // /euler_poincare_equation equation addNr sub0r.
  suff -> : pair 0 eta = 0 by rewrite raddf0 oppr0.
  by apply: (addrI (pair 0 eta)); rewrite -pairDl !addr0.
apply/eqP; rewrite -addr_eq0; apply/eqP/fundamental => eta ends.
by apply: oppr_inj; rewrite oppr0 -(still eta ends) by_parts raddfB /= newton // sub0r.
Qed.

End Integral.

End EulerPoincare.

(** ** Momenta that are carried along *)

Section Momenta.

Variables (R : comUnitRingType) (d : R -> R) (n : nat).
Hypothesis der : derivation d.
Implicit Types (a b g mu : 'M[R]_n).

(** The derivative of a matrix, entry by entry. *)
Definition rate a := map_mx d a.

Lemma rateM a b : rate (a *m b) = rate a *m b + a *m rate b.
Proof.
apply/matrixP => i j; rewrite !mxE (der_sum der) -big_split.
by apply: eq_bigr => k _; rewrite /= !mxE (proj2 der).
Qed.

Lemma rate_tr a : rate a^T = (rate a)^T.
Proof. by rewrite /rate map_trmx. Qed.

Lemma rate1 : rate 1%:M = 0.
Proof. by apply/matrixP => i j; rewrite !mxE; case: eqP; rewrite ?(der1 der) ?(der0 der). Qed.

Lemma rate_inverse g : g \in unitmx -> rate (invmx g) = - (invmx g *m rate g *m invmx g).
Proof.
move=> unit; have := congr1 (fun a => invmx g *m rate a) (mulmxV unit).
by rewrite rate1 mulmx0 rateM mulmxDr !mulmxA mulVmx // mul1mx => /addr0_eq.
Qed.

(** ** Reduced motion along the coadjoint orbit

Section 2.2: let \f$\mu(t) = \mathrm{Ad}_{g(t)^{-1}}^*\mu_0(t)\f$ and \f$\xi = \dot g\,g^{-1}\f$. Then
\f[ \dot\mu = -\mathrm{ad}_\xi^*\mu + \mathrm{Ad}_{g^{-1}}^*\dot\mu_0 , \f]
so that \f$\mu\f$ satisfies the Lie-Poisson equation \f$\dot\mu = -\mathrm{ad}_\xi^*\mu\f$ where
\f$\mu_0\f$ is constant. *)
Theorem claim_2_2_reduced_motion_rate g mu0 : g \in unitmx ->
  let mu := Ad_star (invmx g) mu0 in let xi := rate g *m invmx g in
  rate mu = - ad_star xi mu + Ad_star (invmx g) (rate mu0).
Proof.
move=> unit mu xi; have tr : g^T *m (invmx g)^T = 1%:M by rewrite -trmx_mul mulVmx // trmx1.
rewrite /mu /xi /Ad_star /ad_star invmxK !rateM !rate_tr rate_inverse // !linearN /= !trmx_mul !mulmxDl.
by rewrite !mulmxA -[_ *m g^T *m (invmx g)^T]mulmxA tr mulmx1 opprB !mulNmx addrAC [X in X + _]addrC.
Qed.

(** ** A right-invariant system conserves its body momentum

Section 3.2, the first Euler theorem, with (3.16): a spatial momentum \f$\mu\f$ satisfies
\f$\dot\mu = -\mathrm{ad}_\xi^*\mu\f$ with \f$\xi = \dot g\,g^{-1}\f$ if and only if the body momentum
\f$m_c = \mathrm{Ad}_g^*\mu\f$ is constant. *)
Theorem claim_3_2_body_momentum_constant_of_matrices g mu : g \in unitmx ->
  rate mu = - ad_star (rate g *m invmx g) mu <-> rate (Ad_star g mu) = 0.
Proof.
move=> unit; have tr : g^T *m (invmx g)^T = 1%:M by rewrite -trmx_mul mulVmx // trmx1.
have back m : Ad_star (invmx g) (Ad_star g m) = m.
  rewrite /Ad_star invmxK -!mulmxA -trmx_mul mulmxV // trmx1 mulmx1.
  by rewrite mulmxA -trmx_mul mulmxV // trmx1 mul1mx.
have [forth0 back0] : Ad_star g 0 = 0 /\ Ad_star (invmx g) 0 = 0 by rewrite /Ad_star !mulmx0 !mul0mx.
have := claim_2_2_reduced_motion_rate (Ad_star g mu) unit; rewrite back /= => motion.
split=> [equation | constant]; last by rewrite motion constant back0 addr0.
have carried : Ad_star (invmx g) (rate (Ad_star g mu)) = 0.
  by apply: (addrI (- ad_star (rate g *m invmx g) mu)); rewrite -motion addr0.
have forth m : Ad_star g (Ad_star (invmx g) m) = m.
  by rewrite /Ad_star invmxK -!mulmxA -trmx_mul mulVmx // trmx1 mulmx1 mulmxA tr mul1mx.
by rewrite -[LHS]forth carried.
Qed.

(** ** The momentum of a left-invariant system

Section 2.2, reduction on the left: \f$\Pi = \mathrm{Ad}_g^*\pi_0\f$ with \f$\xi = g^{-1}\dot g\f$ satisfies
\f$\dot\Pi = \mathrm{ad}_\xi^*\Pi + \mathrm{Ad}_g^*\dot\pi_0\f$, so that the Lie-Poisson equation has the
other sign. *)
Theorem claim_2_2_left_reduction_momentum g pi0 : g \in unitmx ->
  let Pi := Ad_star g pi0 in let xi := invmx g *m rate g in
  rate Pi = ad_star xi Pi + Ad_star g (rate pi0).
Proof.
move=> unit Pi xi; have tr : (invmx g)^T *m g^T = 1%:M by rewrite -trmx_mul mulmxV // trmx1.
rewrite /Pi /xi /Ad_star /ad_star !rateM !rate_tr rate_inverse // linearN /= !trmx_mul !mulmxDl !mulmxN.
by rewrite !mulmxA -[_ *m (invmx g)^T *m g^T]mulmxA tr mulmx1 addrAC.
Qed.

End Momenta.
(** ** The first variation of the action *)

Section FirstVariation.

(** Functions of time and of \f$\epsilon\f$ form a commutative ring with two commuting derivations. *)
Variables (F : comRingType) (delta dot : F -> F) (n : nat).
Hypotheses (vary : derivation delta) (move_ : derivation dot).
Hypothesis commute : forall x, delta (dot x) = dot (delta x).

(** Coordinates of a curve, the Lagrangian along it and its partial derivatives along it, with the chain
rule. *)
Variables (q : 'I_n -> F) (L : F) (L_q L_v : 'I_n -> F).
Hypothesis chain_rule : delta L = \sum_i (L_q i * delta (q i) + L_v i * delta (dot (q i))).

(** ** The variation of the integrand

(2.3) before it is integrated: \f$\delta L = \delta g^i\bigl(\frac{\partial L}{\partial g^i} -
\frac{d}{dt}\frac{\partial L}{\partial\dot g^i}\bigr) + \frac{d}{dt}\bigl(\frac{\partial L}{\partial\dot g^i}
\delta g^i\bigr)\f$. *)
Theorem eq_2_3_integrand :
  delta L = \sum_i delta (q i) * (L_q i - dot (L_v i)) + dot (\sum_i L_v i * delta (q i)).
Proof.
rewrite chain_rule (der_sum move_) -big_split; apply: eq_bigr => i _.
by rewrite /= (proj2 move_) commute mulrBr ![delta (q i) * _]mulrC addrA subrK.
Qed.

(** The integral from \f$a\f$ to \f$b\f$, and the difference of the values at \f$b\f$ and \f$a\f$. *)
Variables (K : zmodType) (integral : {additive F -> K}) (at_ends : {additive F -> K}).
Hypothesis newton : forall x, integral (dot x) = at_ends x.

(** ** The first variation with free ends

(2.5): \f$dS\cdot\delta g = \int_a^b\delta g^i\bigl(\frac{\partial L}{\partial g^i} -
\frac{d}{dt}\frac{\partial L}{\partial\dot g^i}\bigr)dt + \frac{\partial L}{\partial\dot g^i}\delta
g^i\big|_a^b\f$. Of the integral it is used that it is additive and that \f$\int_a^b\dot x\,dt = x|_a^b\f$.
*)
Theorem eq_2_5 :
  integral (delta L)
  = integral (\sum_i delta (q i) * (L_q i - dot (L_v i))) + at_ends (\sum_i L_v i * delta (q i)).
Proof. by rewrite eq_2_3_integrand raddfD /= newton. Qed.

(** ** The first variation with fixed ends

(2.3) and (2.2): where the variation vanishes at the ends the last term is absent, and the action is
stationary for this variation where the Euler-Lagrange equations (2.4) hold. *)
Theorem eq_2_3 : (forall x i, at_ends (x * delta (q i)) = 0) ->
  integral (delta L) = integral (\sum_i delta (q i) * (L_q i - dot (L_v i)))
  /\ ((forall i, L_q i - dot (L_v i) = 0) -> integral (delta L) = 0).
Proof.
move=> fixed; have first : integral (delta L) = integral (\sum_i delta (q i) * (L_q i - dot (L_v i))).
  by rewrite eq_2_5 (raddf_sum at_ends) [X in _ + X]big1 ?addr0.
by split=> // equation; rewrite first big1 ?raddf0 // => i _; rewrite equation mulr0.
Qed.

End FirstVariation.

(** ** What follows from the differential of the action on solutions *)

Section OnSolutions.

(** Functions, one-forms and two-forms with their exterior derivatives, and the pull-backs by a flow, which
commute with them. *)
Variables functions one_forms two_forms : zmodType.
Variables (d0 : {additive functions -> one_forms}) (d1 : {additive one_forms -> two_forms}).
Variables (F0 : functions -> functions) (F1 : one_forms -> one_forms).
Variable F2 : {additive two_forms -> two_forms}.
Hypotheses (dd : forall x, d1 (d0 x) = 0) (natural : forall alpha, d1 (F1 alpha) = F2 (d1 alpha)).

Variables (S : functions) (theta : one_forms).
(** (2.8). *)
Hypothesis on_solutions : d0 S = F1 theta - theta.

(** ** The flow is symplectic because the second differential of the action vanishes

Section 2.1: (2.8), \f$dS_t = F_t^*\theta_L - \theta_L\f$, implies \f$F_t^*\omega_L = \omega_L\f$ for
\f$\omega_L = -d\theta_L\f$. What is used is \f$ddS_t = 0\f$ and that pull-backs commute with \f$d\f$. *)
Theorem claim_2_1_symplecticity_from_action : F2 (- d1 theta) = - d1 theta.
Proof.
have := dd S; rewrite on_solutions raddfB /= natural => /eqP; rewrite subr_eq0 => /eqP same.
by rewrite raddfN /= same.
Qed.

(** The contraction of one-forms with the generator \f$\xi_{TG}\f$ of a symmetry. *)
Variable contract : {additive one_forms -> functions}.
Hypothesis equivariant : contract (F1 theta) = F0 (contract theta).
Hypothesis unchanged : contract (d0 S) = 0.

(** ** The momentum of a symmetry is conserved

(2.9): where the action does not change along the symmetry, and the flow commutes with it, \f$0 =
\xi_{TG}\lrcorner dS_t = F_t^*(\xi_{TG}\lrcorner\theta_L) - \xi_{TG}\lrcorner\theta_L\f$: the function
\f$J_\xi = \xi_{TG}\lrcorner\theta_L\f$ is an integral of the flow. *)
Theorem eq_2_9 : F0 (contract theta) - contract theta = 0 /\ F0 (contract theta) = contract theta.
Proof.
have zero : F0 (contract theta) - contract theta = 0 by rewrite -equivariant -raddfB -on_solutions unchanged.
by split=> //; apply: subr0_eq.
Qed.

End OnSolutions.

(** ** What fails as printed *)

(** Matrices of two rows, of integers or of polynomials in \f$t\f$: \f$E\f$ has its one entry above, \f$F\f$
below the diagonal. *)
Section SmallMatrices.

Variable R : comUnitRingType.

Definition upper : 'M[R]_2 := delta_mx 0 1.
Definition lower : 'M[R]_2 := delta_mx 1 0.

Lemma lower_lower : lower * lower = 0.
Proof. by rewrite /lower [LHS]mul_delta_mx_cond. Qed.

Lemma lower_upper_lower : lower * upper * lower = lower.
Proof. by rewrite /lower /upper -[_ * _ * _]/(_ *m _ *m _) !mul_delta_mx. Qed.

Lemma commutator_lower_upper : commutator lower upper = delta_mx 1 1 - delta_mx 0 0.
Proof. by congr (_ - _); rewrite /lower /upper -[_ * _]/(_ *m _) mul_delta_mx. Qed.

End SmallMatrices.

(** ** The two printed members of condition iv differ

Theorem 2.2.1 prints \f$\dot\eta - \mathrm{ad}_\xi\eta = \dot\eta + [\xi, \eta]\f$, where
\f$\mathrm{ad}_\xi\eta = [\xi, \eta]\f$ (theorem 2.2.3). Matrices of two rows refute it, \f$\xi = F\f$ and
\f$\eta = E\f$. *)
Theorem thm_2_2_1_printed_fails :
  ~ (forall (A : unitRingType) (xi eta eta_rate : A),
      eta_rate - algebra_ad xi eta = eta_rate + commutator xi eta).
Proof.
move/(_ [unitRingType of 'M[int]_2] (lower _) (upper _) 0)/matrixP/(_ 0 0).
by rewrite /algebra_ad commutator_lower_upper !mxE.
Qed.

(** Derivatives of matrices of polynomials by \f$t\f$, entry by entry, and by \f$\epsilon\f$ along
\f$a_\epsilon = e^{\epsilon E}ae^{-\epsilon E}\f$. *)
Definition by_time (a : 'M[{poly int}]_2) : 'M[{poly int}]_2 := map_mx (@deriv _) a.
Definition by_parameter (a : 'M[{poly int}]_2) : 'M[{poly int}]_2 := commutator (upper _) a.

Lemma by_time_derivation : derivation by_time.
Proof.
have der : derivation (@deriv [ringType of int]) by split; [exact: derivD | exact: derivM].
by split=> x y; [apply/matrixP => i j; rewrite !mxE derivD | exact: (rateM der)].
Qed.

Lemma by_parameter_derivation : derivation by_parameter.
Proof.
rewrite /by_parameter /commutator; split=> x y; first by rewrite mulrDr mulrDl opprD addrACA.
by rewrite mulrBl mulrBr !mulrA addrA subrK.
Qed.

Lemma by_time_constant i j : by_time (delta_mx i j) = 0.
Proof. by apply/matrixP => k m; rewrite !mxE; case: andP; rewrite ?derivC. Qed.

Lemma by_parameter_by_time a : by_parameter (by_time a) = by_time (by_parameter a).
Proof.
rewrite /by_parameter /commutator (derB by_time_derivation) !(proj2 by_time_derivation) by_time_constant.
by rewrite mul0r mulr0 add0r addr0.
Qed.

(** ** The plus sign in the variation of the reduced velocity

Section 2.2 as printed, \f$\delta\xi = \dot\eta + [\xi, \eta]\f$ for \f$\xi = \dot g\,g^{-1}\f$ and
\f$\eta = \delta g\,g^{-1}\f$, fails for \f$g = e^{\epsilon E}(1 + tF)e^{-\epsilon E}\f$ at
\f$\epsilon = 0\f$: there \f$\xi = F\f$ and \f$[\xi, \eta] = 2tF\f$. *)
Theorem claim_2_2_reduced_variation_bracket_printed_fails_of_curves :
  ~ (forall (A : unitRingType) (delta dot : A -> A) (g : A),
      derivation delta -> derivation dot -> (forall x, delta (dot x) = dot (delta x)) ->
      g \is a GRing.unit ->
      delta (from_right dot g)
      = dot (from_right delta g) + commutator (from_right dot g) (from_right delta g)).
Proof.
pose F := lower [comUnitRingType of {poly int}]; pose E := upper [comUnitRingType of {poly int}].
pose g : 'M[{poly int}]_2 := 1 + 'X *: F; pose h : 'M[{poly int}]_2 := 1 - 'X *: F.
have FF : F * F = 0 by apply: lower_lower.
have FEF : F * E * F = F by apply: lower_upper_lower.
have Fh : F * h = F by rewrite mulrBr mulr1 -scalerAr FF scaler0 subr0.
have hF : h * F = F by rewrite mulrBl mul1r -scalerAl FF scaler0 subr0.
have gh : g * h = 1 by rewrite mulrDl mul1r -scalerAl Fh subrK.
have hg : h * g = 1 by rewrite mulrDr mulr1 -scalerAr hF subrK.
have unit : g \is a GRing.unit by apply/unitrP; exists h.
have inverse : g^-1 = h by rewrite -[LHS]mulr1 -gh mulKr.
move/(_ _ _ _ g by_parameter_derivation by_time_derivation by_parameter_by_time unit).
have [-> _] := claim_2_2_reduced_variation_bracket_in_a_ring by_parameter_derivation by_time_derivation
  by_parameter_by_time unit.
have -> : from_right by_time g = F.
  rewrite /from_right inverse; suff -> : by_time g = F by [].
  apply/matrixP => i j; rewrite !mxE derivD derivM derivX.
  by case: (i == j); case: (_ && _); rewrite ?derivC ?mulr0 ?mulr1 ?addr0 ?add0r.
have eta : from_right by_parameter g = 'X *: ((E * F - F * E) * h).
  rewrite /from_right inverse scalerAl; congr (_ * h).
  rewrite /by_parameter /commutator /g mulrDr mulrDl mulr1 mul1r opprD addrACA addrN add0r.
  by rewrite -scalerAr -scalerAl scalerBr.
have -> : commutator F (from_right by_parameter g) = ('X + 'X) *: F.
  rewrite eta /commutator -scalerAr -scalerAl -scalerBr scalerDl -scalerDr; congr (_ *: _).
  have FC : F * (E * F - F * E) = F by rewrite mulrBr !mulrA FF mul0r subr0 FEF.
  have CF : (E * F - F * E) * F = - F by rewrite mulrBl FEF -mulrA FF mulr0 sub0r.
  by rewrite mulrA FC Fh -mulrA hF CF opprK.
move/addrI/matrixP/(_ 1 0)/(congr1 (horner^~ 1)).
by rewrite !mxE /= mulr1 hornerN hornerD hornerX.
Qed.
