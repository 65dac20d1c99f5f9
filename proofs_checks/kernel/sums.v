(** * Action sums, discrete motions and their reduction

Sections 3.1 and 3.2 of the thesis as far as they are algebra. Configurations are points of any set
\f$Q\f$ whose tangent vectors are elements of one abelian group \f$V\f$: for a Lie group \f$G\f$ they are
\f$\vartheta = \delta g\,g^{-1}\f$, elements of its algebra. Values of Lagrangians lie in any abelian group
\f$W\f$; a derivative is an additive map \f$V\to W\f$. Nothing is asked to be smooth, of finite dimension or
regular: what the theorems use of derivatives is that they are additive and obey the chain rule. *)

From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Discrete integration by parts *)

Section Parts.

Variables V W : zmodType.
Implicit Types (a b : nat -> V -> W) (theta : nat -> V) (v : V) (N : nat).

(** Each place but the ends belongs to two neighbouring terms; the second sum is shifted by one. *)
Lemma sum_by_parts a b theta N : (0 < N)%N ->
  \sum_(0 <= k < N) (a k (theta k) + b k (theta k.+1))
  = \sum_(1 <= k < N) (b k.-1 (theta k) + a k (theta k)) + a 0%N (theta 0%N) + b N.-1 (theta N).
Proof.
case: N => // n _; rewrite big_split /= big_nat_recl // [X in _ + X]big_nat_recr //=.
rewrite (big_add1 _ _ 0) /= big_split /=.
by rewrite addrA; congr (_ + _); rewrite -addrA addrC [X in X + _]addrC.
Qed.

(** The variation that is \f$v\f$ at the place \f$j\f$ and zero at all others. *)
Definition bump j v (k : nat) := if k == j then v else 0.

(** What a bump picks out of a sum. *)
Lemma sum_over_bump (c : nat -> V -> W) j v m n : (forall k, c k 0 = 0) -> (m <= j < n)%N ->
  \sum_(m <= k < n) c k (bump j v k) = c j v.
Proof.
move=> c0 range; rewrite (bigD1_seq j) ?iota_uniq ?mem_index_iota //= big1 /bump => [|k /negbTE -> //].
by rewrite eqxx addr0.
Qed.

Lemma sum_by_parts_bump a b j v N : (forall k, a k 0 = 0) -> (forall k, b k 0 = 0) -> (0 < j < N)%N ->
  \sum_(0 <= k < N) (a k (bump j v k) + b k (bump j v k.+1)) = b j.-1 v + a j v.
Proof.
move=> a0 b0 /andP[j_gt0 j_ltN]; rewrite sum_by_parts ?(ltn_trans j_gt0) //.
have [-> ->] : bump j v 0%N = 0 /\ bump j v N = 0 by rewrite /bump (ltn_eqF j_gt0) (gtn_eqF j_ltN).
rewrite a0 b0 !addr0 (@sum_over_bump (fun k w => b k.-1 w + a k w)) ?j_gt0 // => k.
by rewrite a0 b0 addr0.
Qed.

(** A sum is stationary with its ends held where the two terms of each place in between cancel. *)
Lemma stationary_sum a b N : (forall k, a k 0 = 0) -> (forall k, b k 0 = 0) ->
  (forall theta, theta 0%N = 0 -> theta N = 0 ->
    \sum_(0 <= k < N) (a k (theta k) + b k (theta k.+1)) = 0)
  <-> (forall k, (0 < k < N)%N -> forall v, b k.-1 v + a k v = 0).
Proof.
move=> a0 b0; split=> [still j between v | cancel theta at_start at_end].
  rewrite -(sum_by_parts_bump _ a0 b0 between) still // /bump.
    by case/andP: between => /ltn_eqF ->.
  by case/andP: between => _ /gtn_eqF ->.
case: N => [|n] in at_end cancel *; first by rewrite big_geq.
rewrite sum_by_parts // at_start at_end a0 b0 !addr0 big_nat_cond big1 // => k /andP[between _].
exact: cancel.
Qed.

End Parts.

(** ** Discrete Lagrangians *)

Section Sequences.

Variables (Q : Type) (V W : zmodType).

(** A discrete Lagrangian with its derivatives in either slot, read on variations of the configuration in
that slot. The theorems hold for any three such maps, and hence for a function and its true derivatives;
those of the counterexamples are the true ones. C++: `actio::D1`, `reduction/discrete_euler_lagrange.hpp`.
*)
Record discrete_lagrangian := DiscreteLagrangian {
  at_pair :> Q -> Q -> W;
  D1 : Q -> Q -> {additive V -> W};
  D2 : Q -> Q -> {additive V -> W} }.

Implicit Types (L : discrete_lagrangian) (g h : nat -> Q) (theta eta : nat -> V) (N : nat).

(** A configuration that moves is a pair \f$(g, \vartheta)\f$. A Lagrangian at two configurations that move
has a value and a rate. C++: `actio::Dual`, `numbers/dual.hpp`. *)
Definition along L (x y : Q * V) : W * W := (L x.1 y.1, D1 L x.1 y.1 x.2 + D2 L x.1 y.1 y.2).

(** The action of \f$g_0, \dots, g_N\f$: \f$\sum_{k=0}^{N-1}\mathbb L(g_k, g_{k+1})\f$.
C++: `actio::discrete_action`, `reduction/discrete_euler_lagrange.hpp`. *)
Definition discrete_action L g N := \sum_(0 <= k < N) L (g k) (g k.+1).

(** The differential of the action on a variation: the rate of each of its terms. *)
Definition action_differential L g theta N :=
  \sum_(0 <= k < N) (along L (g k, theta k) (g k.+1, theta k.+1)).2.

(** The left side of (3.2), a form on variations of the configuration in the middle.
C++: `actio::discrete_euler_lagrange`, `reduction/discrete_euler_lagrange.hpp`. *)
Definition discrete_euler_lagrange L (g0 g1 g2 : Q) (v : V) := D2 L g0 g1 v + D1 L g1 g2 v.

(** The configurations \f$g_0, \dots, g_N\f$ satisfy (3.2) at each one between the ends. *)
Definition discrete_motion L g N :=
  forall k, (0 < k < N)%N -> forall v, discrete_euler_lagrange L (g k.-1) (g k) (g k.+1) v = 0.

(** The action does not change along variations that hold \f$g_0\f$ and \f$g_N\f$. *)
Definition stationary L g N :=
  forall theta, theta 0%N = 0 -> theta N = 0 -> action_differential L g theta N = 0.

(** ** The action sums over the pairs from the first to the last configuration

(3.1) with the range \f$k = 0, \dots, N-1\f$: the action depends on the configurations
\f$g_0, \dots, g_N\f$ and on no other. *)
Theorem eq_3_1 L g h N : (forall k, (k <= N)%N -> g k = h k) -> discrete_action L g N = discrete_action L h N.
Proof. by move=> same; apply: eq_big_nat => k /andP[_ below]; rewrite !same // ltnW. Qed.

(** ** The differential of the action at one configuration

(3.1) with the range \f$k = 0, \dots, N-1\f$: the differential at a configuration between the ends is the left
side of (3.2). *)
Theorem eq_3_1_differential L g N j v : (0 < j < N)%N ->
  action_differential L g (bump j v) N = discrete_euler_lagrange L (g j.-1) (g j) (g j.+1) v.
Proof.
case: j => // j between; apply: (sum_by_parts_bump (a := fun k => D1 L (g k) (g k.+1))
  (b := fun k => D2 L (g k) (g k.+1)) v _ _ between) => k; exact: raddf0.
Qed.

(** ** The discrete Euler-Lagrange equations are the stationarity of the action

(3.2): the action \f$\sum_{k=0}^{N-1}\mathbb L(g_k, g_{k+1})\f$ is stationary for variations that hold
\f$g_0\f$ and \f$g_N\f$ if and only if \f$D_2\mathbb L(g_{k-1}, g_k) + D_1\mathbb L(g_k, g_{k+1}) = 0\f$ for
\f$k = 1, \dots, N-1\f$. This holds for every \f$N\f$, and no regularity is needed. *)
Theorem eq_3_2 L g N : stationary L g N <-> discrete_motion L g N.
Proof.
have := stationary_sum (a := fun k => D1 L (g k) (g k.+1)) (b := fun k => D2 L (g k) (g k.+1)) N
  (fun k => raddf0 _) (fun k => raddf0 _).
case=> there back; split=> [/there zero [|k] // | motion]; first exact: zero.
by apply: back => -[|k] //; apply: motion.
Qed.

(** ** First slots and second slots of the action, each with its own range

The first line of (3.3), corrected: let the first configurations of the pairs vary by \f$\vartheta\f$ and,
independently, the second ones by \f$\eta\f$. The first slots contribute
\f$\sum_{k=0}^{N-1}D_1\mathbb L(g_k, g_{k+1})\vartheta_k\f$ and the second slots
\f$\sum_{k=1}^{N}D_2\mathbb L(g_{k-1}, g_k)\eta_k\f$. *)
Theorem claim_3_1_action_differential_split L g theta eta N :
  \sum_(0 <= k < N) (along L (g k, theta k) (g k.+1, eta k.+1)).2
  = \sum_(1 <= k < N.+1) D2 L (g k.-1) (g k) (eta k) + \sum_(0 <= k < N) D1 L (g k) (g k.+1) (theta k).
Proof. by rewrite big_split /= addrC big_add1. Qed.

(** ** Interior terms are the equations, the ends leave one term each

The second line of (3.3): for \f$N\ge 1\f$ the differential of the action, its ends free, is
\f[ \sum_{k=1}^{N-1}\bigl[D_1\mathbb L(g_k, g_{k+1}) + D_2\mathbb L(g_{k-1}, g_k)\bigr]\delta g_k
  + D_1\mathbb L(g_0, g_1)\,\delta g_0 + D_2\mathbb L(g_{N-1}, g_N)\,\delta g_N. \f]
It is right as printed, with the action summed over \f$k = 0, \dots, N-1\f$. *)
Theorem claim_3_1_action_differential_regrouped L g theta N : (0 < N)%N ->
  action_differential L g theta N
  = \sum_(1 <= k < N) discrete_euler_lagrange L (g k.-1) (g k) (g k.+1) (theta k)
    + D1 L (g 0%N) (g 1%N) (theta 0%N) + D2 L (g N.-1) (g N) (theta N).
Proof.
move=> N_gt0; rewrite /action_differential /= (sum_by_parts (fun k => D1 L (g k) (g k.+1))
  (fun k => D2 L (g k) (g k.+1))) // prednK //; congr (_ + _ + _).
by apply: eq_big_nat => -[].
Qed.

(** ** The differential of the discrete action, ends free

(3.3) with the arguments in the first line exchanged back: the differential of the action is the sum over
first and second slots, and this is the sum over the configurations, equations inside and one-forms at the
ends. *)
Theorem eq_3_3 L g theta N : (0 < N)%N ->
  action_differential L g theta N
  = \sum_(1 <= k < N.+1) D2 L (g k.-1) (g k) (theta k) + \sum_(0 <= k < N) D1 L (g k) (g k.+1) (theta k)
  /\
  \sum_(1 <= k < N.+1) D2 L (g k.-1) (g k) (theta k) + \sum_(0 <= k < N) D1 L (g k) (g k.+1) (theta k)
  = \sum_(1 <= k < N) (D1 L (g k) (g k.+1) (theta k) + D2 L (g k.-1) (g k) (theta k))
    + D1 L (g 0%N) (g 1%N) (theta 0%N) + D2 L (g N.-1) (g N) (theta N).
Proof.
move=> N_gt0; rewrite -claim_3_1_action_differential_split; split=> //.
rewrite -/(action_differential L g theta N) claim_3_1_action_differential_regrouped //.
by congr (_ + _ + _); apply: eq_bigr => k _; rewrite addrC.
Qed.

End Sequences.

(** ** A free particle on a line

The Lagrangian \f$(b - a)^2\f$ on the integers: the smallest example, for what fails as printed. *)

Definition times (c : int) : {additive int -> int} := Additive (mulrBr c).

Definition free_particle : discrete_lagrangian int [zmodType of int] [zmodType of int] :=
  DiscreteLagrangian (fun a b => (b - a) ^+ 2) (fun a b => times (- (2%:Z * (b - a))))
    (fun a b => times (2%:Z * (b - a))).

(** Its derivatives are right: what they leave of a difference is of second order. *)
Lemma free_particle_derivatives (a b u w : int) :
  free_particle (a + u) (b + w)
  = free_particle a b + (D1 free_particle a b u + D2 free_particle a b w) + (w - u) ^+ 2.
Proof.
have -> : free_particle (a + u) (b + w) = ((b - a) + (w - u)) ^+ 2.
  by rewrite /= opprD addrACA.
by rewrite sqrrD /=; congr (_ + _ + _); rewrite mulNr [RHS]addrC -mulrBr -mulrA -natz mulr_natl.
Qed.

(** Uniform motion, one unit in each step. *)
Lemma uniform_motion N : discrete_motion free_particle Posz N.
Proof.
case=> // k _ v; rewrite /discrete_euler_lagrange /=.
have step i : Posz i.+1 - Posz i = 1 by rewrite intS addrK.
by rewrite !step mulNr addrN.
Qed.

(** ** The printed range of the action needs one more configuration

(3.1) as printed, \f$\sum_{k=1}^N\mathbb L(g_k, g_{k+1})\f$, is not a function of the configurations
\f$g_0, \dots, g_N\f$: a free particle, \f$N = 3\f$, where \f$g_4\f$ alone is moved. *)
Theorem eq_3_1_printed_fails_configurations :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (g h : nat -> Q) (N : nat),
      (3 <= N)%N -> (forall k, (k <= N)%N -> g k = h k) ->
      \sum_(1 <= k < N.+1) L (g k) (g k.+1) = \sum_(1 <= k < N.+1) L (h k) (h k.+1)).
Proof.
move/(_ _ _ _ free_particle (fun=> 0) (fun k => if k == 4%N then 1 else 0) 3%N isT) => fails.
have /fails : forall k, (k <= 3)%N -> 0 = (if k == 4%N then 1 else 0) :> int by do 4![case=> //].
by rewrite unlock.
Qed.

(** ** Motions do not make the printed sum stationary

(3.1) as printed: the configurations \f$g_k = k\f$ of a free particle satisfy (3.2), and the printed sum is
not stationary at them, even if \f$g_{N+1}\f$ is held as well as \f$g_0\f$ and \f$g_N\f$. *)
Theorem eq_3_1_printed_fails :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (g : nat -> Q) (N : nat),
      (3 <= N)%N -> discrete_motion L g N ->
      forall theta, theta 0%N = 0 -> theta N = 0 -> theta N.+1 = 0 ->
      \sum_(1 <= k < N.+1) (along L (g k, theta k) (g k.+1, theta k.+1)).2 = 0).
Proof.
move/(_ _ _ _ free_particle Posz 3%N isT) => fails.
have := fails (@uniform_motion 3) (bump 1%N 1) erefl erefl erefl.
by rewrite unlock.
Qed.

(** ** The first line of the differential of the action, as printed

(3.3) as printed, where \f$D_2\mathbb L\f$ stands at \f$(g_k, g_{k+1})\f$ and \f$D_1\mathbb L\f$ at
\f$(g_{k-1}, g_k)\f$; the sequence runs over all integers, so that \f$g_{-1}\f$ and \f$g_{N+1}\f$ exist. The
differential of the action is another form: a free particle at \f$g_k = k^2\f$, \f$N = 3\f$, its last
configuration varied. *)
Theorem eq_3_3_printed_fails :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (g : int -> Q) (theta : int -> V)
       (N : nat), (3 <= N)%N ->
      action_differential L (fun k => g k%:Z) (fun k => theta k%:Z) N
      = \sum_(1 <= k < N.+1) D2 L (g k%:Z) (g (k%:Z + 1)) (theta k%:Z)
        + \sum_(0 <= k < N) D1 L (g (k%:Z - 1)) (g k%:Z) (theta k%:Z)).
Proof.
move/(_ _ _ _ free_particle (fun k => k ^+ 2) (fun k => if k == 3%:Z then 1 else 0) 3%N isT).
by rewrite /action_differential unlock.
Qed.

(** ** Discrete integration by parts, as printed

The step from the first to the second line of (3.3), "which simply shifts the sequence", fails as printed,
too: the same configurations, the second one varied. *)
Theorem eq_3_3_printed_fails_by_parts :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (g : int -> Q) (theta : int -> V)
       (N : nat), (3 <= N)%N ->
      \sum_(1 <= k < N.+1) D2 L (g k%:Z) (g (k%:Z + 1)) (theta k%:Z)
        + \sum_(0 <= k < N) D1 L (g (k%:Z - 1)) (g k%:Z) (theta k%:Z)
      = \sum_(1 <= k < N) (D1 L (g k%:Z) (g (k%:Z + 1)) (theta k%:Z)
                           + D2 L (g (k%:Z - 1)) (g k%:Z) (theta k%:Z))
        + D1 L (g 0) (g 1) (theta 0) + D2 L (g (N%:Z - 1)) (g N%:Z) (theta N%:Z)).
Proof.
move/(_ _ _ _ free_particle (fun k => k ^+ 2) (fun k => if k == 1%:Z then 1 else 0) 3%N isT).
by rewrite unlock.
Qed.

(** ** First slots and second slots, as printed

The two sums of the first line of (3.3) as printed are not what second and first slots contribute: the same
configurations, with the second slot of the last pair varied alone. *)
Theorem claim_3_1_action_differential_split_printed_fails :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (g : int -> Q) (theta eta : int -> V)
       (N : nat), (3 <= N)%N ->
      \sum_(0 <= k < N) (along L (g k%:Z, theta k%:Z) (g (k%:Z + 1), eta (k%:Z + 1))).2
      = \sum_(1 <= k < N.+1) D2 L (g k%:Z) (g (k%:Z + 1)) (eta k%:Z)
        + \sum_(0 <= k < N) D1 L (g (k%:Z - 1)) (g k%:Z) (theta k%:Z)).
Proof.
move/(_ _ _ _ free_particle (fun k => k ^+ 2) (fun=> 0) (fun k => if k == 3%:Z then 1 else 0) 3%N isT).
by rewrite unlock.
Qed.

(** ** The discrete flow and the one-forms at the ends *)

Section Flow.

Variables (Q : Type) (V W : zmodType).
Implicit Types (L : discrete_lagrangian Q V W) (p : Q * Q) (x : (Q * Q) * (V * V)).

(** A pair of configurations that move: a tangent vector of \f$G\times G\f$ with its base point. The one-forms
\f$\theta^-_{\mathbb L}\f$ and \f$\theta^+_{\mathbb L}\f$ on it.
C++: `actio::discrete_one_form_minus`, `reduction/discrete_forms.hpp`. *)
Definition discrete_one_form_minus L x : W := D1 L x.1.1 x.1.2 x.2.1.
(** C++: `actio::discrete_one_form_plus`, `reduction/discrete_forms.hpp`. *)
Definition discrete_one_form_plus L x : W := D2 L x.1.1 x.1.2 x.2.2.

(** The differential of the Lagrangian on a tangent vector of \f$G\times G\f$. *)
Definition lagrangian_differential L x : W := (along L (x.1.1, x.2.1) (x.1.2, x.2.2)).2.

(** ** The two one-forms add up to the differential of the Lagrangian

(3.4): \f$\theta^-_{\mathbb L} + \theta^+_{\mathbb L} = d\mathbb L\f$. Each of the two is \f$d\mathbb L\f$
with the other configuration at rest. *)
Theorem eq_3_4 L x :
  [/\ discrete_one_form_minus L x + discrete_one_form_plus L x = lagrangian_differential L x,
      discrete_one_form_minus L x = lagrangian_differential L (x.1, (x.2.1, 0))
    & discrete_one_form_plus L x = lagrangian_differential L (x.1, (0, x.2.2))].
Proof. by rewrite /lagrangian_differential /= !raddf0 addr0 add0r. Qed.

(** A discrete flow \f$\mathbb F\f$ of \f$\mathbb L\f$ with its tangent: \f$\mathbb F(g_0, g_1) = (g_1,
g_2)\f$, where the three satisfy (3.2), and the new first configuration moves as the old second one did. *)
Definition discrete_flow L (F : Q * Q -> Q * Q) (TF : Q * Q -> V * V -> V * V) :=
  forall p w, [/\ (F p).1 = p.2, (TF p w).1 = w.2
    & forall v, discrete_euler_lagrange L p.1 p.2 (F p).2 v = 0].

Variables (L : discrete_lagrangian Q V W) (F : Q * Q -> Q * Q) (TF : Q * Q -> V * V -> V * V).

(** A tangent vector carried along by the flow, and the pull-back of a one-form by \f$n\f$ steps of it. *)
Definition carry x := (F x.1, TF x.1 x.2).
Definition pull_back n (alpha : (Q * Q) * (V * V) -> W) x := alpha (iter n carry x).

(** The differential of the action of \f$N\f$ pairs along motions, as a function of the first pair:
\f$\sum_{k=0}^{N-1}(\mathbb F^k)^*d\mathbb L\f$. *)
Definition differential_along_motions N x := \sum_(0 <= k < N) pull_back k (lagrangian_differential L) x.

Hypothesis flow : discrete_flow L F TF.

(** ** The differential of the action along motions

(3.6), corrected: for \f$N\ge 1\f$ pairs it is
\f$\theta^-_{\mathbb L} + (\mathbb F^{N-1})^*\theta^+_{\mathbb L}\f$, since the last pair is \f$N - 1\f$ steps
from the first. Of the flow it is used that it satisfies (3.2) and joins pairs; no regularity is needed. *)
Theorem eq_3_6 N x : (0 < N)%N ->
  differential_along_motions N x
  = discrete_one_form_minus L x + pull_back N.-1 (discrete_one_form_plus L) x.
Proof.
case: N => // n _; elim: n => [|n IH]; first by rewrite /differential_along_motions big_nat1.
rewrite /differential_along_motions big_nat_recr //= -/(differential_along_motions n.+1 x) IH -addrA.
congr (_ + _); rewrite /pull_back iterS; set y := iter n carry x.
(* The end of one step and the start of the next cancel: this is (3.2). *)
case: (flow y.1 y.2) => next vary equation.
have := equation y.2.2; rewrite /discrete_euler_lagrange /discrete_one_form_plus /lagrangian_differential /=.
by rewrite next vary addrA => ->; rewrite add0r.
Qed.

(** ** Two pairs

(3.6) as printed, \f$\theta^-_{\mathbb L} + \mathbb F^*\theta^+_{\mathbb L}\f$, is right for \f$N = 2\f$. *)
Theorem eq_3_6_two_pairs x :
  differential_along_motions 2 x = discrete_one_form_minus L x + discrete_one_form_plus L (carry x).
Proof. exact: eq_3_6. Qed.

(** ** Noether's theorem *)

Variable xi : Q -> V.

(** The Lagrangian does not change along the symmetry whose generator is \f$\xi\f$. *)
Definition invariant_along := forall g0 g1, D1 L g0 g1 (xi g0) + D2 L g0 g1 (xi g1) = 0.

(** The contraction of a one-form with the generator on pairs, \f$\xi_{G\times G}\lrcorner\alpha\f$. *)
Definition contraction (alpha : (Q * Q) * (V * V) -> W) p := alpha (p, (xi p.1, xi p.2)).

(** \f$\mathbb J_\xi = \xi_{G\times G}\lrcorner\theta^+_{\mathbb L}\f$.
C++: `actio::discrete_momentum`, `reduction/discrete_momentum.hpp`. *)
Definition discrete_momentum (g0 g1 : Q) : W := D2 L g0 g1 (xi g1).

(** ** At one pair the contractions are opposite

Section 3.1: \f$\xi_{G\times G}\lrcorner\theta^-_{\mathbb L} = -\xi_{G\times G}\lrcorner\theta^+_{\mathbb
L}\f$ at every pair if and only if the Lagrangian does not change along the symmetry. No equation of motion
is needed. *)
Theorem claim_3_1_momentum_forms :
  invariant_along
  <-> forall p, contraction (discrete_one_form_minus L) p = - contraction (discrete_one_form_plus L) p.
Proof.
split=> [still p | opposite g0 g1]; first by apply/eqP; rewrite -addr_eq0; apply/eqP; apply: still.
by apply/eqP; rewrite addr_eq0; apply/eqP; apply: (opposite (g0, g1)).
Qed.

Hypothesis still : invariant_along.

(** ** A symmetry contracted with the one-forms at either end of a motion

(3.7): \f$\xi_{G\times G}\lrcorner\theta^-_{\mathbb L} = -\mathbb F^*(\xi_{G\times G}\lrcorner
\theta^+_{\mathbb L})\f$. That the flow is equivariant is not needed: the invariance of \f$\mathbb L\f$ at
both pairs and (3.2) between them are enough. *)
Theorem eq_3_7 p :
  contraction (discrete_one_form_minus L) p = - contraction (discrete_one_form_plus L) (F p).
Proof.
have /claim_3_1_momentum_forms opposite := still; rewrite opposite -[RHS]opposite.
have [next _ /(_ (xi p.2)) equation] := flow p (0, 0).
by rewrite /contraction /discrete_one_form_plus /discrete_one_form_minus /= next; apply: addr0_eq.
Qed.

(** ** The discrete momentum is conserved by the flow

(3.8): \f$\mathbb J_\xi = \mathbb F^*\mathbb J_\xi\f$. *)
Theorem eq_3_8 p : discrete_momentum p.1 p.2 = discrete_momentum (F p).1 (F p).2.
Proof.
by have /claim_3_1_momentum_forms opposite := still; apply: oppr_inj; rewrite -[LHS]opposite eq_3_7.
Qed.

End Flow.

(** ** The discrete momentum is the same along a motion

(3.8) without a flow: along configurations \f$g_0, \dots, g_N\f$ that satisfy (3.2) the momentum of every pair
is that of the first, whether or not the equations determine the next configuration. *)
Theorem eq_3_8_along_a_motion (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (xi : Q -> V)
    (g : nat -> Q) N k :
  invariant_along L xi -> discrete_motion L g N -> (k < N)%N ->
  discrete_momentum L xi (g k) (g k.+1) = discrete_momentum L xi (g 0%N) (g 1%N).
Proof.
move=> still motion; elim: k => // k IH below; rewrite -IH ?(ltn_trans _ below) //.
have := motion k.+1 below (xi (g k.+1)); rewrite /discrete_euler_lagrange /= => /eqP.
rewrite addr_eq0 => /eqP; rewrite /discrete_momentum => ->.
by apply/eqP; rewrite -addr_eq0 addrC still.
Qed.

(** A particle in the plane that a potential moves along the second coordinate alone:
\f$\mathbb L = (b - a)^2 + (y - x)^2 - x^2\f$ at \f$(a, x)\f$ and \f$(b, y)\f$. *)
Section InThePlane.

Notation plane := [zmodType of int * int].

Definition two_times (c d : int) (v : plane) := times c v.1 + times d v.2.
Lemma two_times_additive c d : additive (two_times c d).
Proof. by move=> v w; rewrite /two_times !raddfB opprD addrACA. Qed.

Definition plane_particle : discrete_lagrangian plane plane [zmodType of int] :=
  DiscreteLagrangian (fun p q => (q.1 - p.1) ^+ 2 + (q.2 - p.2) ^+ 2 - p.2 ^+ 2)
    (fun p q => Additive (two_times_additive (- (2%:Z * (q.1 - p.1))) (- (2%:Z * q.2))))
    (fun p q => Additive (two_times_additive (2%:Z * (q.1 - p.1)) (2%:Z * (q.2 - p.2)))).

End InThePlane.

(** ** A symmetry conserves its own momentum and no other

Remark 3.1.3: the momentum of a smaller group of symmetries is conserved by (3.8). Another momentum need not
be: the translations along the first coordinate are a symmetry of a particle in the plane with the potential
\f$x^2\f$ in the second one, and along the motion \f$0, 1, 1\f$ of the second coordinate its momentum
changes. *)
Theorem rem_3_1_3_no_other :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) (xi eta : Q -> V) (g : nat -> Q) N k,
      (exists q, xi q <> 0) -> invariant_along L xi -> discrete_motion L g N -> (k < N)%N ->
      discrete_momentum L eta (g k) (g k.+1) = discrete_momentum L eta (g 0%N) (g 1%N)).
Proof.
move/(_ _ _ _ plane_particle (fun=> (1, 0)) (fun=> (0, 1)) (fun k => (0, (0 < k)%N%:Z)) 2%N 1%N) => fails.
suff : discrete_momentum plane_particle (fun=> (0, 1)) (0, 1) (0, 1)
       = discrete_momentum plane_particle (fun=> (0, 1)) (0, 0) (0, 1) by [].
apply: fails => // [|p q|].
- by exists (0, 0).
- by rewrite /= /two_times /= !mulr1 !mulr0 !addr0 addNr.
- move=> [|[|//]] // _ v.
  have cancel (c d : int) : c * v.1 + d * v.2 + (- c * v.1 + - d * v.2) = 0 by rewrite !mulNr -opprD addrN.
  exact: (cancel 0 2%:Z).
Qed.

(** ** One step of the flow at the far end, as printed

(3.6) as printed for every \f$N\f$: along the uniform motions of a free particle it fails for \f$N = 3\f$. *)
Theorem eq_3_6_printed_fails :
  ~ (forall (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W) F TF, discrete_flow L F TF ->
      forall N x, (2 <= N)%N ->
      differential_along_motions L F TF N x
      = discrete_one_form_minus L x + discrete_one_form_plus L (carry F TF x)).
Proof.
pose F (p : int * int) := (p.2, p.2 + (p.2 - p.1)).
move/(_ _ _ _ free_particle F (fun=> F)) => fails.
have /fails : discrete_flow free_particle F (fun=> F).
  by move=> p w; split=> // v; rewrite /discrete_euler_lagrange /= [p.2 + _]addrC addrK mulNr addrN.
by move/(_ 3%N ((0, 1), (0, 1)) isT); rewrite /differential_along_motions unlock.
Qed.

(** ** A symmetry takes discrete motions to discrete motions

Section 3.1: let a map \f$\varphi\f$ of configurations, whose tangent map is onto, leave the derivatives of
the Lagrangian as they are. Then (3.2) at a moved sequence, read on a moved variation, is (3.2) at the
sequence itself, so that motions go to motions, and no other sequences do. *)
Theorem claim_3_1_symmetry_of_discrete_flow (Q : Type) (V W : zmodType) (L : discrete_lagrangian Q V W)
    (phi : Q -> Q) (Tphi : Q -> V -> V) :
  (forall x y, along L (phi x.1, Tphi x.1 x.2) (phi y.1, Tphi y.1 y.2) = along L x y) ->
  (forall q, Tphi q 0 = 0) ->
  (forall g0 g1 g2 v, discrete_euler_lagrange L (phi g0) (phi g1) (phi g2) (Tphi g1 v)
                      = discrete_euler_lagrange L g0 g1 g2 v)
  /\ ((forall q v, exists w, Tphi q w = v) ->
      forall g N, discrete_motion L (phi \o g) N <-> discrete_motion L g N).
Proof.
move=> invariant rest.
have first g0 g1 v : D1 L (phi g0) (phi g1) (Tphi g0 v) = D1 L g0 g1 v.
  by have [_] := invariant (g0, v) (g1, 0); rewrite /= rest !raddf0 !addr0.
have second g0 g1 v : D2 L (phi g0) (phi g1) (Tphi g1 v) = D2 L g0 g1 v.
  by have [_] := invariant (g0, 0) (g1, v); rewrite /= rest !raddf0 !add0r.
have moved g0 g1 g2 v : discrete_euler_lagrange L (phi g0) (phi g1) (phi g2) (Tphi g1 v)
                        = discrete_euler_lagrange L g0 g1 g2 v.
  by rewrite /discrete_euler_lagrange first second.
split=> // onto g N; split=> motion k between v; first by rewrite -moved; apply: motion.
by have [w <-] := onto (g k) v; rewrite /= moved; apply: motion.
Qed.

(** ** Second derivatives and the two-form *)

Section TwoForms.

Variables V W : zmodType.

(** The second derivatives of a discrete Lagrangian at a pair, in coordinates: \f$D_{12}(x, y) =
\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j}x^iy^j\f$, and those in one slot alone, which
are symmetric. C++: `actio::mixed_derivative`, `reduction/discrete_forms.hpp`. *)
Record second_derivatives := SecondDerivatives {
  D11 : V -> V -> W;
  D12 : V -> V -> W;
  D22 : V -> V -> W;
  D11_symmetric : forall x y, D11 x y = D11 y x;
  D22_symmetric : forall x y, D22 x y = D22 y x }.

Implicit Types (J : second_derivatives) (u w : V * V).

(** How \f$\theta^\mp_{\mathbb L}(w)\f$ changes along \f$u\f$, for a constant \f$w\f$, and the exterior
derivatives, \f$d\theta(u, w) = u(\theta w) - w(\theta u)\f$. *)
Definition rate_of_minus J u w := D11 J u.1 w.1 + D12 J w.1 u.2.
Definition rate_of_plus J u w := D12 J u.1 w.2 + D22 J u.2 w.2.
Definition d_theta_minus J u w := rate_of_minus J u w - rate_of_minus J w u.
Definition d_theta_plus J u w := rate_of_plus J u w - rate_of_plus J w u.

(** \f$\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j}\,dg_{k+1}^j\wedge dg_k^i\f$ and
\f$\frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j}\,dg_k^i\wedge dg_{k+1}^j\f$. *)
Definition wedge_later_first J u w := D12 J w.1 u.2 - D12 J u.1 w.2.
Definition wedge_earlier_first J u w := D12 J u.1 w.2 - D12 J w.1 u.2.

(** \f$\omega_{\mathbb L} = d\theta^-_{\mathbb L}\f$, as the thesis and the library define it.
C++: `actio::discrete_two_form`, `reduction/discrete_forms.hpp`. *)
Definition discrete_two_form := d_theta_minus.

(** ** The discrete two-form in coordinates

(3.5), corrected: \f$d\theta^-_{\mathbb L} = \frac{\partial^2\mathbb L}{\partial g_k^i\,\partial g_{k+1}^j}\,
dg_{k+1}^j\wedge dg_k^i\f$; the printed right side, with the earlier configuration first, is
\f$d\theta^+_{\mathbb L}\f$. *)
Theorem eq_3_5 J u w :
  d_theta_minus J u w = wedge_later_first J u w /\ d_theta_plus J u w = wedge_earlier_first J u w.
Proof.
rewrite /d_theta_minus /rate_of_minus /d_theta_plus /rate_of_plus; split.
  by rewrite D11_symmetric opprD addrACA addrN add0r.
by rewrite D22_symmetric opprD addrACA addrN addr0.
Qed.

(** ** The exterior derivatives of the two one-forms cancel

Section 3.1, below (3.4): \f$d\theta^-_{\mathbb L} + d\theta^+_{\mathbb L} = 0\f$. What is used is that second
derivatives in one slot are symmetric. *)
Theorem claim_3_1_exterior_derivative_sum J u w : d_theta_minus J u w + d_theta_plus J u w = 0.
Proof. by have [-> ->] := eq_3_5 J u w; rewrite /wedge_later_first addrA subrK addrN. Qed.

(** Two-forms change their sign with their arguments. *)
Lemma discrete_two_form_antisymmetric J u w : discrete_two_form J u w = - discrete_two_form J w u.
Proof. by rewrite /discrete_two_form /d_theta_minus opprB. Qed.

(** Variations \f$\delta g_0, \delta g_1, \delta g_2\f$ of three configurations along which (3.2) stays
true, to first order: the tangent of the discrete flow takes \f$(\delta g_0, \delta g_1)\f$ to \f$(\delta
g_1, \delta g_2)\f$. *)
Definition linearized_equation J01 J12 (u0 u1 u2 : V) :=
  forall v, D12 J01 u0 v + D22 J01 u1 v + (D11 J12 u1 v + D12 J12 v u2) = 0.

(** ** The discrete flow preserves the two-form

Section 3.1: \f$\mathbb F^*\omega_{\mathbb L} = \omega_{\mathbb L}\f$. The Lagrangian need not be regular: for
any two variations along which (3.2) stays true the form at the second pair is that at the first. *)
Theorem claim_3_1_flow_symplectic J01 J12 (u0 u1 u2 w0 w1 w2 : V) :
  linearized_equation J01 J12 u0 u1 u2 -> linearized_equation J01 J12 w0 w1 w2 ->
  discrete_two_form J12 (u1, u2) (w1, w2) = discrete_two_form J01 (u0, u1) (w0, w1).
Proof.
move=> /(_ w1) along_u /(_ u1) along_w; rewrite /discrete_two_form !(proj1 (eq_3_5 _ _ _)).
rewrite /wedge_later_first /=.
(* The second derivatives in the middle slot are the same for both: what remains of (3.2) are mixed ones. *)
have middle a b c d : a + b + (c + d) = b + c + (a + d) :> W by rewrite [a + b]addrC addrACA.
rewrite middle in along_u; rewrite middle (D22_symmetric J01) (D11_symmetric J12) -along_u in along_w.
by apply: (addIr (D12 J12 u1 w2)); rewrite subrK addrAC (addrI _ along_w) [RHS]addrAC addrN add0r.
Qed.

(** ** Symplecticity from the vanishing second differential of the action

Section 3.1, the chain below (3.6) with its signs corrected: for \f$\omega_{\mathbb L} = d\theta^-_{\mathbb
L}\f$ it is \f$\mathbb F^*\omega_{\mathbb L} = -\mathbb F^*(d\theta^+_{\mathbb L}) = d\theta^-_{\mathbb L} =
\omega_{\mathbb L}\f$. *)
Theorem claim_3_1_symplecticity_chain J01 J12 (u0 u1 u2 w0 w1 w2 : V) :
  linearized_equation J01 J12 u0 u1 u2 -> linearized_equation J01 J12 w0 w1 w2 ->
  [/\ discrete_two_form J12 (u1, u2) (w1, w2) = - d_theta_plus J12 (u1, u2) (w1, w2),
      - d_theta_plus J12 (u1, u2) (w1, w2) = d_theta_minus J01 (u0, u1) (w0, w1)
    & d_theta_minus J01 (u0, u1) (w0, w1) = discrete_two_form J01 (u0, u1) (w0, w1)].
Proof.
move=> along_u along_w.
have opposite : discrete_two_form J12 (u1, u2) (w1, w2) = - d_theta_plus J12 (u1, u2) (w1, w2).
  by apply/eqP; rewrite -addr_eq0 claim_3_1_exterior_derivative_sum.
by split=> //; rewrite -opposite; apply: claim_3_1_flow_symplectic along_u along_w.
Qed.

(** The canonical two-form of \f$T^*G\f$ in coordinates, \f$-d\theta_0 = dq^i\wedge dp_i\f$, on two tangent
vectors; covectors are maps \f$V\to W\f$. *)
Definition canonical_two_form (x y : V * (V -> W)) := y.2 x.1 - x.2 y.1.

(** The tangent map of the discrete Legendre transformation \f$(g_k, D_1\mathbb L)\f$, and of the one with the
physical sign, \f$(g_k, -D_1\mathbb L)\f$. *)
Definition legendre_tangent J u : V * (V -> W) := (u.1, fun v => D11 J u.1 v + D12 J v u.2).
Definition physical_legendre_tangent J u : V * (V -> W) := (u.1, fun v => - (D11 J u.1 v + D12 J v u.2)).

(** ** The two-form is the pull-back of the canonical one

Section 3.1: \f$\omega_{\mathbb L}\f$ is the pull-back of chapter 2's \f$-d\theta_0\f$ by
\f$(g_k, -D_1\mathbb L)\f$, and of \f$+d\theta_0\f$ by the Legendre transformation as printed,
\f$(g_k, D_1\mathbb L)\f$. *)
Theorem claim_3_1_pullback_canonical J u w :
  discrete_two_form J u w = canonical_two_form (physical_legendre_tangent J u) (physical_legendre_tangent J w)
  /\ discrete_two_form J u w = - canonical_two_form (legendre_tangent J u) (legendre_tangent J w).
Proof.
by rewrite /canonical_two_form /= opprB; split=> //; rewrite opprK addrC.
Qed.

(** The Hamiltonian vector of a function whose differential is \f$dF\f$: \f$X_F\lrcorner\omega_{\mathbb L} =
dF\f$. The bracket (3.12) of two functions is \f$\omega_{\mathbb L}(X_F, X_H)\f$. *)
Definition hamiltonian_vector J (X : V * V) (dF : V * V -> W) := forall w, discrete_two_form J X w = dF w.

(** ** Functions of one configuration commute

(3.13) as printed lifts functions by the projection \f$\pi\f$ of a pair on a configuration, not by the
quotient map \f$\pi_d\f$. Where \f$\mathbb L\f$ is regular in its first slot the bracket of any two
functions of the first configuration is zero, so that the printed formula would make all functions on
\f$G\f$ commute. *)
Theorem bracket_of_the_first_projection_vanishes J (X Y : V * V) (dF dH : V * V -> W) :
  (forall y, D12 J 0 y = 0) -> (forall x, (forall y, D12 J x y = 0) -> x = 0) ->
  (forall v, dF (0, v) = 0) -> (forall v, dH (0, v) = 0) ->
  hamiltonian_vector J X dF -> hamiltonian_vector J Y dH -> discrete_two_form J X Y = 0.
Proof.
move=> zero regular first_F first_H along_F along_H.
have first Z dK : (forall v, dK (0, v) = 0) -> hamiltonian_vector J Z dK -> Z.1 = 0.
  move=> first_K along_K; apply: regular => y; apply: oppr_inj; rewrite oppr0 -(first_K y) -along_K.
  by rewrite /discrete_two_form (proj1 (eq_3_5 _ _ _)) /wedge_later_first zero sub0r.
rewrite /discrete_two_form (proj1 (eq_3_5 _ _ _)) /wedge_later_first (first _ _ first_F along_F).
by rewrite (first _ _ first_H along_H) !zero subrr.
Qed.

End TwoForms.

(** The second derivatives of \f$\mathbb L(x, y) = xy\f$ on the integers. *)
Definition of_the_product : second_derivatives [zmodType of int] [zmodType of int] :=
  @SecondDerivatives [zmodType of int] [zmodType of int] (fun _ _ => 0) *%R (fun _ _ => 0)
    (fun _ _ => erefl) (fun _ _ => erefl).

(** They are what the Lagrangian leaves of second order. *)
Lemma of_the_product_second_order (x y u w : int) :
  (x + u) * (y + w) = x * y + (y * u + x * w) + D12 of_the_product u w.
Proof. by rewrite mulrDl !mulrDr /= [u * y]mulrC -!addrA; congr (_ + _); rewrite addrCA. Qed.

(** ** The wedge as printed

(3.5) as printed, with \f$dg_k^i\wedge dg_{k+1}^j\f$, fails for \f$\mathbb L(x, y) = xy\f$. *)
Theorem eq_3_5_printed_fails :
  ~ (forall (V W : zmodType) (J : second_derivatives V W) u w,
      d_theta_minus J u w = wedge_earlier_first J u w).
Proof. by move/(_ _ _ of_the_product (1, 0) (0, 1)). Qed.

(** ** The first equality of the chain, as printed

\f$\mathbb F^*\omega_{\mathbb L} = \mathbb F^*(d\theta^+_{\mathbb L})\f$ fails for
\f$\mathbb L(x, y) = xy\f$, whose motions are \f$g_{k+1} = -g_{k-1}\f$. *)
Theorem claim_3_1_symplecticity_chain_printed_fails_first :
  ~ (forall (V W : zmodType) (J01 J12 : second_derivatives V W) u0 u1 u2 w0 w1 w2,
      linearized_equation J01 J12 u0 u1 u2 -> linearized_equation J01 J12 w0 w1 w2 ->
      discrete_two_form J12 (u1, u2) (w1, w2) = d_theta_plus J12 (u1, u2) (w1, w2)).
Proof.
move/(_ _ _ of_the_product of_the_product 1 0 (-1) 0 1 0) => fails.
suff : discrete_two_form of_the_product (0, -1) (1, 0) = d_theta_plus of_the_product (0, -1) (1, 0) by [].
by apply: fails => v; rewrite /= ?mul1r ?mulrN1 ?mul0r ?mulr0 ?add0r ?addr0 ?addrN.
Qed.

(** ** The last equality of the chain, as printed

\f$-d\theta^-_{\mathbb L} = \omega_{\mathbb L}\f$ fails for the same Lagrangian. *)
Theorem claim_3_1_symplecticity_chain_printed_fails_last :
  ~ (forall (V W : zmodType) (J : second_derivatives V W) u w,
      - d_theta_minus J u w = discrete_two_form J u w).
Proof. by move/(_ _ _ of_the_product (1, 0) (0, 1)). Qed.

(** ** Groups and their tangent groups *)

(** A group, of any kind. *)
Record group := Group {
  element :> Type;
  one : element;
  mul : element -> element -> element;
  inv : element -> element;
  mulA : associative mul;
  one_mul : left_id one mul;
  inv_mul : left_inverse one inv mul }.

Declare Scope motion_scope.
Delimit Scope motion_scope with M.
Notation "g * h" := (mul g h) : motion_scope.
Notation "g ^-1" := (inv g) : motion_scope.
Notation "1" := (one _) : motion_scope.

Section GroupLaws.

Variable G : group.
Implicit Types f g h : G.

Lemma mul_inv g : (g * g^-1 = 1)%M.
Proof.
by rewrite -[LHS]one_mul -{1}(inv_mul (g^-1)%M) -mulA [(_ * (g * _))%M]mulA inv_mul one_mul inv_mul.
Qed.

Lemma mul_one g : (g * 1 = g)%M.
Proof. by rewrite -(inv_mul g) mulA mul_inv one_mul. Qed.

Lemma mulK g h : (g * h * h^-1 = g)%M.
Proof. by rewrite -mulA mul_inv mul_one. Qed.

Lemma mulVK g h : (g * h^-1 * h = g)%M.
Proof. by rewrite -mulA inv_mul mul_one. Qed.

Lemma Kmul g h : (g^-1 * (g * h) = h)%M.
Proof. by rewrite mulA inv_mul one_mul. Qed.

Lemma VKmul g h : (g * (g^-1 * h) = h)%M.
Proof. by rewrite mulA mul_inv one_mul. Qed.

Lemma inv_unique g h : (g * h = 1)%M -> h = (g^-1)%M.
Proof. by move=> E; rewrite -[h](Kmul g) E mul_one. Qed.

Lemma invK g : (g^-1^-1 = g)%M.
Proof. by rewrite -(inv_unique (inv_mul g)). Qed.

Lemma inv_product g h : ((g * h)^-1 = h^-1 * g^-1)%M.
Proof. by symmetry; apply: inv_unique; rewrite -mulA VKmul mul_inv. Qed.

(** \f$f_{01} = g_0g_1^{-1}\f$, the image of a pair under the quotient map (3.9).
C++: `actio::relative_motion_right`, `reduction/relative_motion.hpp`. *)
Definition relative_motion_right g h := (g * h^-1)%M.

(** \f$f_{10} = g_1^{-1}g_0\f$.
C++: `actio::relative_motion_left`, `reduction/relative_motion.hpp`. *)
Definition relative_motion_left g h := (h^-1 * g)%M.

(** The next configuration from a relative motion, (3.14) and (3.15).
C++: `actio::reconstruct_right`, `reduction/relative_motion.hpp`. *)
Definition reconstruct_right g f := (f^-1 * g)%M.
(** C++: `actio::reconstruct_left`, `reduction/relative_motion.hpp`. *)
Definition reconstruct_left g f := (g * f^-1)%M.

Lemma relative_motion_rightK g h : reconstruct_right g (relative_motion_right g h) = h.
Proof. by rewrite /reconstruct_right inv_product invK mulVK. Qed.

Lemma relative_motion_leftK g h : reconstruct_left g (relative_motion_left g h) = h.
Proof. by rewrite /reconstruct_left inv_product invK VKmul. Qed.

End GroupLaws.

(** A group with its algebra and the adjoint action, \f$\mathrm{Ad}_{gh} = \mathrm{Ad}_g\mathrm{Ad}_h\f$: of
a Lie group these theorems use nothing else. An element of the algebra is called a velocity, as in the
library. *)
Record lie_group := LieGroup {
  elements :> group;
  velocity : zmodType;
  Ad : elements -> {additive velocity -> velocity};
  Ad_one : forall v, Ad (one elements) v = v;
  Ad_mul : forall g h v, Ad (mul g h) v = Ad g (Ad h v) }.

Section TangentGroup.

Variable G : lie_group.

Lemma AdK (g : G) v : Ad (g^-1)%M (Ad g v) = v.
Proof. by rewrite -Ad_mul inv_mul Ad_one. Qed.

Lemma AdVK (g : G) v : Ad g (Ad (g^-1)%M v) = v.
Proof. by rewrite -Ad_mul mul_inv Ad_one. Qed.

(** Elements that move, \f$(g, \vartheta)\f$ with \f$\vartheta = \delta g\,g^{-1}\f$: the first-order part of
curves through \f$g\f$. They multiply as curves do, \f$\delta(gh)(gh)^{-1} = \delta g\,g^{-1} +
\mathrm{Ad}_g(\delta h\,h^{-1})\f$, and form the tangent group of \f$G\f$. *)
Definition moving := (G * velocity G)%type.
Definition moving_mul (x y : moving) : moving := (mul x.1 y.1, x.2 + Ad x.1 y.2).
Definition moving_inv (x : moving) : moving := (inv x.1, - Ad (inv x.1) x.2).

Lemma moving_mulA : associative moving_mul.
Proof. by move=> x y z; rewrite /moving_mul /= mulA raddfD Ad_mul addrA. Qed.
Lemma one_moving : left_id (one G, 0) moving_mul.
Proof. by case=> g v; rewrite /moving_mul /= one_mul Ad_one add0r. Qed.
Lemma inv_moving : left_inverse (one G, 0) moving_inv moving_mul.
Proof. by case=> g v; rewrite /moving_mul /= inv_mul addNr. Qed.

Definition tangent : group := Group moving_mulA one_moving inv_moving.

(** \f$\delta f\,f^{-1}\f$ of \f$f = g_0g_1^{-1}\f$.
C++: `actio::relative_variation_right`, `reduction/relative_motion.hpp`. *)
Definition relative_variation_right (f : G) (v0 v1 : velocity G) := v0 - Ad f v1.

(** \f$f^{-1}\delta f\f$ of \f$f = g_1^{-1}g_0\f$, from \f$g^{-1}\delta g\f$.
C++: `actio::relative_variation_left`, `reduction/relative_motion.hpp`. *)
Definition relative_variation_left (f : G) (v0 v1 : velocity G) := v0 - Ad (inv f) v1.

(** ** How the relative motion varies with its configurations

Theorem 3.2.1, condition (3), in any Lie group: \f$\delta f_{kk+1}\,f_{kk+1}^{-1} = \delta g_k\,g_k^{-1} -
\mathrm{Ad}_{f_{kk+1}}\,\delta g_{k+1}g_{k+1}^{-1}\f$. For the left quotient, with \f$\vartheta =
g^{-1}\delta g\f$, it is \f$f^{-1}\delta f = \vartheta_0 - \mathrm{Ad}_{f^{-1}}\vartheta_1\f$. *)
Theorem claim_3_2_variation_of_f_any_group (g0 g1 : G) (v0 v1 : velocity G) :
  @relative_motion_right tangent (g0, v0) (g1, v1)
  = (relative_motion_right g0 g1, relative_variation_right (relative_motion_right g0 g1) v0 v1)
  /\
  @relative_motion_left tangent (g0, Ad g0 v0) (g1, Ad g1 v1)
  = (relative_motion_left g0 g1,
     Ad (relative_motion_left g0 g1) (relative_variation_left (relative_motion_left g0 g1) v0 v1)).
Proof.
rewrite /relative_motion_right /relative_motion_left /=; split; congr (_, _).
  by rewrite /relative_variation_right /= raddfN Ad_mul.
by rewrite /relative_variation_left /= raddfB AdVK AdK -Ad_mul addrC.
Qed.

End TangentGroup.

(** ** Reduction *)

Section Reduction.

Variables (G : lie_group) (W : zmodType).

Notation lagrangian := (discrete_lagrangian G (velocity G) W).

(** A function on the group with its differential, read on \f$\vartheta\mapsto TR_f\vartheta\f$: the reduced
discrete Lagrangian \f$\ell\f$ with \f$R_f^*\ell'(f)\f$.
C++: `actio::right_differential`, `groups/differential.hpp`. *)
Record reduced_lagrangian := ReducedLagrangian {
  at_motion :> G -> W;
  right_differential : G -> {additive velocity G -> W} }.

Implicit Types (L : lagrangian) (l : reduced_lagrangian) (f g h : nat -> G) (theta : nat -> velocity G)
  (N k : nat).

(** \f$L_f^*\ell'(f)\f$, read on \f$\vartheta\mapsto TL_f\vartheta = TR_f\mathrm{Ad}_f\vartheta\f$.
C++: `actio::left_differential`, `groups/differential.hpp`. *)
Definition left_differential l (f : G) v := right_differential l f (Ad f v).

(** The value and the rate of \f$\ell\f$ at an element that moves. *)
Definition along_motion l (x : tangent G) : W * W := (l x.1, right_differential l x.1 x.2).

(** \f$\mathbb L = \ell\circ\pi_d\f$ together with the derivative of this equation, by the chain rule: for
elements that move. The second one is the same for the left quotient, \f$\ell(g_1^{-1}g_0)\f$. *)
Definition descends_right L l :=
  forall x y : tangent G, along L x y = along_motion l (relative_motion_right x y).
Definition descends_left L l :=
  forall x y : tangent G, along L x y = along_motion l (relative_motion_left x y).

(** \f$\mathbb L(g_0\bar g, g_1\bar g) = \mathbb L(g_0, g_1)\f$ together with the derivative of this
equation. *)
Definition right_invariant L := forall x y z : tangent G, along L (x * z)%M (y * z)%M = along L x y.

(** The relative motions of a sequence, and a sequence with given ones. *)
Definition relative_motions_right g k := relative_motion_right (g k) (g k.+1).
Definition relative_motions_left g k := relative_motion_left (g k) (g k.+1).
Fixpoint configurations_right (start : G) f k : G :=
  if k is j.+1 then reconstruct_right (configurations_right start f j) (f j) else start.
Fixpoint configurations_left (start : G) f k : G :=
  if k is j.+1 then reconstruct_left (configurations_left start f j) (f j) else start.

(** The reduced action sum \f$s = \sum_{k=0}^{N-1}\ell(f_{kk+1})\f$, its differential along the variations of
\f$f\f$ that variations of configurations induce, and its being stationary. *)
Definition reduced_action l f N := \sum_(0 <= k < N) l (f k).
Definition reduced_differential l f theta N :=
  \sum_(0 <= k < N) right_differential l (f k) (relative_variation_right (f k) (theta k) (theta k.+1)).
Definition reduced_stationary l f N :=
  forall theta, theta 0%N = 0 -> theta N = 0 -> reduced_differential l f theta N = 0.

(** The left side of (3.10), \f$R_{f_{12}}^*\ell'(f_{12}) - L_{f_{01}}^*\ell'(f_{01})\f$.
C++: `actio::euler_poincare_right`, `reduction/discrete_euler_poincare.hpp`. *)
Definition euler_poincare_right l (f01 f12 : G) v := right_differential l f12 v - left_differential l f01 v.

(** The left side of (3.11), \f$L_{f_{21}}^*\ell'(f_{21}) - R_{f_{10}}^*\ell'(f_{10})\f$.
C++: `actio::euler_poincare_left`, `reduction/discrete_euler_poincare.hpp`. *)
Definition euler_poincare_left l (f10 f21 : G) v := left_differential l f21 v - right_differential l f10 v.

(** The relative motions \f$f_0, \dots, f_{N-1}\f$ satisfy (3.10), or (3.11), at \f$k = 1, \dots, N-1\f$. *)
Definition reduced_motion_right l f N :=
  forall k, (0 < k < N)%N -> forall v, euler_poincare_right l (f k.-1) (f k) v = 0.
Definition reduced_motion_left l f N :=
  forall k, (0 < k < N)%N -> forall v, euler_poincare_left l (f k.-1) (f k) v = 0.

(** ** The quotient of pairs by right multiplication

(3.9): \f$g_0g_1^{-1}\f$ does not change when both configurations are multiplied by one element on the
right; two pairs over the same \f$f\f$ differ by the multiplication by exactly one element; over every
\f$f\f$ there is a pair. *)
Theorem eq_3_9_any_group :
  [/\ forall g0 g1 c : G, relative_motion_right (g0 * c)%M (g1 * c)%M = relative_motion_right g0 g1,
      forall g0 g1 h0 h1 : G, relative_motion_right g0 g1 = relative_motion_right h0 h1 ->
        exists! c, h0 = (g0 * c)%M /\ h1 = (g1 * c)%M
    & forall f : G, exists g0 g1 : G, relative_motion_right g0 g1 = f].
Proof.
rewrite /relative_motion_right; split=> [g0 g1 c | g0 g1 h0 h1 same | f].
- by rewrite inv_product mulA mulK.
- exists (g1^-1 * h1)%M; split=> [|c [_ ->]]; last by rewrite Kmul.
  by rewrite VKmul; split=> //; rewrite mulA same mulVK.
- by exists f, (one G); rewrite -{1}[f]mul_one mulK.
Qed.

(** ** An invariant discrete Lagrangian is a function of the relative motion

Section 3.2: a discrete Lagrangian is right-invariant if and only if it is \f$\ell(g_kg_{k+1}^{-1})\f$ for
some \f$\ell\f$, its derivatives included. *)
Theorem claim_3_2_reduced_lagrangian_any_group L : right_invariant L <-> exists l, descends_right L l.
Proof.
split=> [invariant | [l down] x y z].
  pose l := ReducedLagrangian (fun f : G => L f (one G)) (fun f : G => D1 L f (one G)).
  exists l => x y; rewrite -(invariant x y (y^-1)%M) [(y * _)%M]mul_inv.
  by rewrite /along /along_motion /= raddf0 addr0.
by rewrite !down; congr (along_motion l _); rewrite /relative_motion_right inv_product mulA mulK.
Qed.

(** ** The action of an invariant discrete Lagrangian is a sum over relative motions

Section 3.2: \f$\mathbb S = s\f$, and \f$d\mathbb S\cdot\delta g = ds\cdot\delta f\f$ with the induced
variation of \f$f\f$; the ends are free. This is the step from (1) to (3) in the proof of theorem 3.2.1. *)
Theorem claim_3_2_reduced_lagrangian_action L l g theta N : descends_right L l ->
  discrete_action L g N = reduced_action l (relative_motions_right g) N
  /\ action_differential L g theta N = reduced_differential l (relative_motions_right g) theta N.
Proof.
move=> down; split; apply: eq_bigr => k _.
  by have [-> _] := down (g k, 0) (g k.+1, 0).
by rewrite down (proj1 (claim_3_2_variation_of_f_any_group _ _ _ _)).
Qed.

(** What the chain rule gives for the derivatives in each slot. *)
Lemma D1_right L l (g0 g1 : G) v : descends_right L l ->
  D1 L g0 g1 v = right_differential l (relative_motion_right g0 g1) v.
Proof.
move=> /(_ (g0, v) (g1, 0)) [_]; rewrite /= raddf0 addr0 => ->.
by rewrite raddf0 oppr0 raddf0 addr0.
Qed.

Lemma D2_right L l (g0 g1 : G) v : descends_right L l ->
  D2 L g0 g1 v = - left_differential l (relative_motion_right g0 g1) v.
Proof.
move=> /(_ (g0, 0) (g1, v)) [_]; rewrite /= raddf0 add0r => ->.
by rewrite add0r !raddfN /left_differential /relative_motion_right /= Ad_mul.
Qed.

Lemma D1_left L l (g0 g1 : G) v : descends_left L l ->
  D1 L g0 g1 (Ad g0 v) = left_differential l (relative_motion_left g0 g1) v.
Proof.
move=> /(_ (g0, Ad g0 v) (g1, 0)) [_]; rewrite /= raddf0 addr0 => ->.
by rewrite raddf0 oppr0 add0r -Ad_mul.
Qed.

Lemma D2_left L l (g0 g1 : G) v : descends_left L l ->
  D2 L g0 g1 (Ad g1 v) = - right_differential l (relative_motion_left g0 g1) v.
Proof.
move=> /(_ (g0, 0) (g1, Ad g1 v)) [_]; rewrite /= raddf0 add0r => ->.
by rewrite raddf0 addr0 AdK raddfN.
Qed.

(** ** The discrete Euler-Poincare equations, right-invariant case

(3.10) is (3.2) of the invariant Lagrangian, off shell: whatever the three configurations, the two left sides
are the same form. *)
Theorem eq_3_10 L l (g0 g1 g2 : G) v : descends_right L l ->
  discrete_euler_lagrange L g0 g1 g2 v
  = euler_poincare_right l (relative_motion_right g0 g1) (relative_motion_right g1 g2) v.
Proof.
by move=> down; rewrite /discrete_euler_lagrange (D1_right _ _ _ down) (D2_right _ _ _ down) addrC.
Qed.

(** ** The discrete Euler-Poincare equations, left-invariant case

(3.11) with \f$f_{k+1k} = g_{k+1}^{-1}g_k\f$ is (3.2) of a left-invariant Lagrangian, read on variations
\f$\delta g = g\vartheta\f$, off shell. *)
Theorem eq_3_11 L l (g0 g1 g2 : G) v : descends_left L l ->
  discrete_euler_lagrange L g0 g1 g2 (Ad g1 v)
  = euler_poincare_left l (relative_motion_left g0 g1) (relative_motion_left g1 g2) v.
Proof.
by move=> down; rewrite /discrete_euler_lagrange (D1_left _ _ _ down) (D2_left _ _ _ down) addrC.
Qed.

(** ** The other representative of the quotient

Section 3.2: \f$g_{k+1}g_k^{-1}\f$ serves as well. It is the inverse of \f$f_{kk+1}\f$, and the equations
exchange their sides: (3.2) is \f$R^*\tilde\ell'(\tilde f_{01}) - L^*\tilde\ell'(\tilde f_{12}) = 0\f$. *)
Theorem claim_3_2_alternative_quotient_any_group L l (g0 g1 g2 : G) v :
  (forall x y : tangent G, along L x y = along_motion l (y * x^-1)%M) ->
  (g1 * g0^-1 = (relative_motion_right g0 g1)^-1)%M
  /\ discrete_euler_lagrange L g0 g1 g2 v
     = right_differential l (g1 * g0^-1)%M v - left_differential l (g2 * g1^-1)%M v.
Proof.
move=> down; split; first by rewrite /relative_motion_right inv_product invK.
have [_] := down (g0, 0) (g1, v); have [_] := down (g1, v) (g2, 0).
rewrite /discrete_euler_lagrange /left_differential /= !raddf0 addr0 !add0r => -> ->.
by rewrite addr0 !raddfN Ad_mul.
Qed.

(** ** The derivative of the reduced action sum

The sum over \f$k\f$ in the proof of theorem 3.2.1: with the ends held,
\f[ ds\cdot\delta f = \sum_{k=1}^{N-1}\bigl(R_{f_{kk+1}}^*\ell'(f_{kk+1}) -
  L_{f_{k-1k}}^*\ell'(f_{k-1k})\bigr)\vartheta_k , \f]
for any sequence of elements \f$f\f$. *)
Lemma reduced_by_parts l f theta N : theta 0%N = 0 -> theta N = 0 ->
  reduced_differential l f theta N
  = \sum_(1 <= k < N) euler_poincare_right l (f k.-1) (f k) (theta k).
Proof.
move=> at_start at_end; rewrite /reduced_differential.
under eq_bigr do rewrite /relative_variation_right raddfB.
case: N at_end => [|n] at_end; first by rewrite !big_geq.
rewrite (sum_by_parts (fun k => right_differential l (f k)) (fun k v => - left_differential l (f k) v)) //.
rewrite at_start at_end /left_differential /= !raddf0 ?oppr0 !addr0.
by apply: eq_bigr => k _; rewrite addrC.
Qed.

(** ** The four conditions are one linear form of the variations

Theorem 3.2.1: with the ends held, whatever the configurations, the derivative of the action (1), the sum of
the left sides of (3.2) (2), the derivative of the reduced action (3) and the sum of the left sides of
(3.10) (4) are the same number for every variation. *)
Theorem claim_3_2_dep_equivalence L l g theta N : descends_right L l -> theta 0%N = 0 -> theta N = 0 ->
  let f := relative_motions_right g in
  [/\ action_differential L g theta N
      = \sum_(1 <= k < N) discrete_euler_lagrange L (g k.-1) (g k) (g k.+1) (theta k),
      action_differential L g theta N = reduced_differential l f theta N
    & reduced_differential l f theta N
      = \sum_(1 <= k < N) euler_poincare_right l (f k.-1) (f k) (theta k)].
Proof.
move=> down at_start at_end f; have [_ sums] := claim_3_2_reduced_lagrangian_action g theta N down.
split=> //; last exact: reduced_by_parts.
rewrite sums reduced_by_parts //; apply: eq_big_nat => -[//|k] _.
by rewrite (eq_3_10 _ _ _ _ down).
Qed.

(** (3.10) is what stationarity of the reduced action asks, for any sequence of elements. *)
Lemma reduced_stationary_motion l f N : reduced_stationary l f N <-> reduced_motion_right l f N.
Proof.
have := @stationary_sum _ _ (fun k => right_differential l (f k))
  (fun k v => - left_differential l (f k) v) N.
case=> [k | k |there back]; rewrite /left_differential ?raddf0 ?oppr0 //.
split=> [still k between v | motion].
  rewrite /euler_poincare_right addrC; apply: there => // theta at_start at_end.
  by rewrite -[RHS](still theta at_start at_end); apply: eq_bigr => i _; rewrite raddfB.
move=> theta at_start at_end; rewrite /reduced_differential.
under eq_bigr do rewrite /relative_variation_right raddfB.
by apply: back => // k between v; rewrite addrC; apply: motion.
Qed.

(** ** Four ways to say that a sequence is a discrete motion

Theorem 3.2.1, with the reduced action on \f$N\f$ relative motions: the action is stationary with its ends
held (1), the configurations satisfy (3.2) (2), the reduced action is stationary for the induced variations
(3), the relative motions satisfy (3.10) (4). It holds for every \f$N\f$, and \f$N\ge 3\f$ is not needed. *)
Theorem thm_3_2_1 L l g N : descends_right L l ->
  let f := relative_motions_right g in
  [/\ stationary L g N <-> discrete_motion L g N,
      stationary L g N <-> reduced_stationary l f N
    & reduced_stationary l f N <-> reduced_motion_right l f N].
Proof.
move=> down f; split; [exact: eq_3_2 | | exact: reduced_stationary_motion].
by split=> still theta at_start at_end; have := still theta at_start at_end;
  have [_ ->] := claim_3_2_reduced_lagrangian_action g theta N down.
Qed.

(** ** Left-invariant Lagrangians

Remark 3.2.1: for a Lagrangian \f$\ell(g_{k+1}^{-1}g_k)\f$ the action is stationary with its ends held, the
configurations satisfy (3.2), if and only if \f$f_{k+1k} = g_{k+1}^{-1}g_k\f$ satisfy (3.11). For the
variations \f$\delta g_k = g_k\vartheta_k\f$ the derivative of the action is
\f$\sum_{k=1}^{N-1}\bigl(L^*_{f_{k+1k}}\ell'(f_{k+1k}) - R^*_{f_{kk-1}}\ell'(f_{kk-1})\bigr)\vartheta_k\f$.
*)
Theorem rem_3_2_1 L l g N : descends_left L l ->
  let f := relative_motions_left g in
  [/\ stationary L g N <-> discrete_motion L g N,
      discrete_motion L g N <-> reduced_motion_left l f N
    & forall theta, theta 0%N = 0 -> theta N = 0 ->
      action_differential L g (fun k => Ad (g k) (theta k)) N
      = \sum_(1 <= k < N) euler_poincare_left l (f k.-1) (f k) (theta k)].
Proof.
move=> down f; split; first exact: eq_3_2.
  split=> motion [//|k] between v.
    by rewrite -(eq_3_11 _ _ _ _ down) /=; apply: (motion k.+1).
  by rewrite /= -(AdVK (g k.+1) v) (eq_3_11 _ _ _ _ down); apply: (motion k.+1).
move=> theta at_start at_end; case: N at_end => [|n] at_end; first by rewrite /action_differential !big_geq.
rewrite claim_3_1_action_differential_regrouped // at_start at_end !raddf0 !addr0.
by apply: eq_big_nat => -[//|k] _; apply: eq_3_11.
Qed.

(** What (3.14) and (3.15) say holds wherever the relative motion of two configurations and the next
configuration undo each other. *)
Lemma reconstruction (relative rebuild : G -> G -> G) (configurations : G -> (nat -> G) -> nat -> G) :
  (forall g h : G, rebuild g (relative g h) = h) -> (forall g f : G, relative g (rebuild g f) = f) ->
  (forall start f, configurations start f 0%N = start) ->
  (forall start f k, configurations start f k.+1 = rebuild (configurations start f k) (f k)) ->
  forall g : nat -> G,
  [/\ forall k, (rebuild (g k) (relative (g k) (g k.+1)), rebuild (g k.+1) (relative (g k.+1) (g k.+2)))
                 = (g k.+1, g k.+2),
      forall k, configurations (g 0%N) (fun k => relative (g k) (g k.+1)) k = g k
    & forall start f k, relative (configurations start f k) (configurations start f k.+1) = f k].
Proof.
move=> back forth begins steps g; split=> [k | k | start f k]; first by rewrite !back.
  by elim: k => [|k same]; rewrite ?begins // steps same back.
by rewrite steps forth.
Qed.

(** ** The reconstruction map, right-invariant case

(3.14): \f$(f_{k-1k}^{-1}g_{k-1}, f_{kk+1}^{-1}g_k) = (g_k, g_{k+1})\f$ for \f$f_{kk+1} =
g_kg_{k+1}^{-1}\f$. A sequence is reconstructed from its first configuration and its relative motions, and
any sequence of elements is that of the relative motions of what it reconstructs. *)
Theorem eq_3_14 g :
  [/\ forall k, (reconstruct_right (g k) (relative_motions_right g k),
                 reconstruct_right (g k.+1) (relative_motions_right g k.+1)) = (g k.+1, g k.+2),
      forall k, configurations_right (g 0%N) (relative_motions_right g) k = g k
    & forall start f k, relative_motions_right (configurations_right start f) k = f k].
Proof.
apply: (reconstruction (configurations := configurations_right)) => //; first exact: relative_motion_rightK.
by move=> h f; rewrite /relative_motion_right inv_product invK VKmul.
Qed.

(** ** The reconstruction map, left-invariant case

(3.15): \f$(g_{k-1}f_{kk-1}^{-1}, g_kf_{k+1k}^{-1}) = (g_k, g_{k+1})\f$ for \f$f_{k+1k} =
g_{k+1}^{-1}g_k\f$, and again sequences are reconstructed from their first configuration and their relative
motions. *)
Theorem eq_3_15 g :
  [/\ forall k, (reconstruct_left (g k) (relative_motions_left g k),
                 reconstruct_left (g k.+1) (relative_motions_left g k.+1)) = (g k.+1, g k.+2),
      forall k, configurations_left (g 0%N) (relative_motions_left g) k = g k
    & forall start f k, relative_motions_left (configurations_left start f) k = f k].
Proof.
apply: (reconstruction (configurations := configurations_left)) => //; first exact: relative_motion_leftK.
by move=> h f; rewrite /relative_motion_left inv_product invK mulVK.
Qed.

(** ** A motion of the full equations projects to one of the reduced equations

The first half of theorem 3.2.3, for the invariant Lagrangians that the section is about. *)
Theorem claim_3_2_projection_of_del L l g N : descends_right L l ->
  discrete_motion L g N -> reduced_motion_right l (relative_motions_right g) N.
Proof. by move=> down; case: (thm_3_2_1 g N down) => -[_ back] [there _] [ahead _] /back/there/ahead. Qed.

(** ** A motion of the reduced equations lifts to motions of the full ones

The second half of theorem 3.2.3: through every first configuration there is one sequence with the given
relative motions, and it satisfies (3.2). *)
Theorem claim_3_2_reconstruction_of_dep L l f N : descends_right L l -> reduced_motion_right l f N ->
  forall start,
    discrete_motion L (configurations_right start f) N
    /\ (forall g, g 0%N = start -> (forall k, relative_motions_right g k = f k) ->
        forall k, g k = configurations_right start f k).
Proof.
move=> down motion start; have [_ _ same] := eq_3_14 (configurations_right start f).
split=> [[//|k] between v | g <- lifts k].
  have := eq_3_10 _ _ _ v down => ->.
  by rewrite -!/(relative_motions_right (configurations_right start f) _) !same; apply: (motion k.+1).
have [_ <- _] := eq_3_14 g.
by elim: k => //= k ->; rewrite lifts.
Qed.

(** ** Projection and reconstruction carry motions to motions

Theorem 3.2.3: a sequence of configurations satisfies (3.2) if and only if its relative motions satisfy
(3.10), and every solution of (3.10) is that of the relative motions of a solution of (3.2). *)
Theorem thm_3_2_3 L l N : descends_right L l ->
  (forall g, discrete_motion L g N <-> reduced_motion_right l (relative_motions_right g) N)
  /\ (forall start f, reduced_motion_right l f N ->
       discrete_motion L (configurations_right start f) N
       /\ forall k, relative_motions_right (configurations_right start f) k = f k).
Proof.
move=> down; split=> [g | start f motion].
  by case: (thm_3_2_1 g N down) => full mixed reduced; rewrite -full mixed reduced.
split; first by case: (claim_3_2_reconstruction_of_dep down motion start).
by have [_ _ same] := eq_3_14 (configurations_right start f).
Qed.

(** ** Projection and reconstruction, left-invariant case

Theorem 3.2.3 for a Lagrangian \f$\ell(g_{k+1}^{-1}g_k)\f$, with (3.11) and (3.15). *)
Theorem thm_3_2_3_left L l N : descends_left L l ->
  (forall g, discrete_motion L g N <-> reduced_motion_left l (relative_motions_left g) N)
  /\ (forall start f, reduced_motion_left l f N ->
       discrete_motion L (configurations_left start f) N
       /\ forall k, relative_motions_left (configurations_left start f) k = f k).
Proof.
move=> down; have both g : discrete_motion L g N <-> reduced_motion_left l (relative_motions_left g) N.
  by case: (rem_3_2_1 g N down).
split=> // start f motion; have [_ _ same] := eq_3_15 (configurations_left start f).
by split=> //; apply/both => -[//|k] between v; rewrite !same; apply: (motion k.+1).
Qed.

(** ** The reduced action sum is a function of N relative motions

Theorem 3.2.1, condition (3), corrected: \f$N+1\f$ configurations have \f$N\f$ relative motions. Any \f$N\f$
elements are relative motions of configurations; configurations with the same ones differ by the
multiplication by one element on the right; the action is a function of the \f$N\f$ relative motions. So
\f$s : G^N\to\mathbb R\f$. *)
Theorem claim_3_2_reduced_action_domain N :
  [/\ forall f, exists g, forall k, (k < N)%N -> relative_motions_right g k = f k,
      forall g h, (forall k, (k < N)%N -> relative_motions_right g k = relative_motions_right h k)
        <-> exists c, forall k, (k <= N)%N -> h k = (g k * c)%M
    & forall L l g f, descends_right L l -> (forall k, (k < N)%N -> relative_motions_right g k = f k) ->
      discrete_action L g N = reduced_action l f N].
Proof.
split=> [f | g h | L l g f down same].
- exists (configurations_right (one G) f) => k _.
  by have [_ _ same] := eq_3_14 (configurations_right (one G) f).
- split=> [same | [c carried] k below]; last first.
    rewrite /relative_motions_right !carried ?(ltnW below) //.
    by case: eq_3_9_any_group => invariant _ _; rewrite invariant.
  exists ((g 0%N)^-1 * h 0%N)%M; elim=> [|k IH] below; first by rewrite VKmul.
  rewrite -[LHS](relative_motion_rightK (h k)) -/(relative_motions_right h k) -same // IH ?(ltnW below) //.
  by rewrite /reconstruct_right mulA; congr (_ * _)%M; apply: relative_motion_rightK.
- have [-> _] := claim_3_2_reduced_lagrangian_action g (fun=> 0) N down.
  by apply: eq_big_nat => k /andP[_ below]; rewrite same.
Qed.

(** ** Every variation of N relative motions is induced

With the first configuration held and the last one free, every variation of the \f$N\f$ relative motions comes
from one variation of the configurations, since \f$\vartheta_{k+1} = \mathrm{Ad}_{f_{kk+1}}^{-1}(\vartheta_k -
\delta f\,f^{-1})\f$. With both ends held it does not: then \f$\vartheta_N = 0\f$ is a condition. *)
Theorem claim_3_2_reduced_action_domain_variations f (eta : nat -> velocity G) :
  exists2 theta, theta 0%N = 0 & forall k, relative_variation_right (f k) (theta k) (theta k.+1) = eta k.
Proof.
pose theta := fix theta k := if k is j.+1 then Ad (inv (f j)) (theta j - eta j) else 0.
by exists theta => // k; rewrite /relative_variation_right /= AdVK opprB addrC subrK.
Qed.

(** ** Free variations of the relative motions

Theorem 3.2.1, condition (3): that the variations of \f$f\f$ are the induced ones is essential. For free
variations the reduced action is stationary only where \f$\ell'\f$ vanishes. *)
Theorem claim_3_2_dep_equivalence_free_variations l f N :
  (forall eta, \sum_(0 <= k < N) right_differential l (f k) (eta k) = 0)
  <-> (forall k, (k < N)%N -> forall v, right_differential l (f k) v = 0).
Proof.
split=> [still k below v | vanish eta]; last first.
  by rewrite big_nat_cond big1 // => k /andP[/andP[_ below] _]; apply: vanish.
rewrite -(still (bump k v)) (sum_over_bump (c := fun i => right_differential l (f i))) //.
by move=> i; rewrite raddf0.
Qed.

(** ** The discrete Lie-Poisson update in any group *)

(** The dual of \f$\mathrm{Ad}_g\f$ on forms of velocities: \f$\langle\mathrm{Ad}_g^*\mu, \vartheta\rangle =
\langle\mu, \mathrm{Ad}_g\vartheta\rangle\f$. *)
Definition coadjoint (g : G) (mu : velocity G -> W) v := mu (Ad g v).

(** The momentum at the start of a step, \f$\mu = -R_f^*\ell'(f)\f$ and \f$\Pi = -L_f^*\ell'(f)\f$.
C++: `actio::momentum_before_right`, `reduction/discrete_lie_poisson.hpp`. *)
Definition momentum_before_right l (f : G) v := - right_differential l f v.
(** C++: `actio::momentum_before_left`, `reduction/discrete_lie_poisson.hpp`. *)
Definition momentum_before_left l (f : G) v := - left_differential l f v.

(** ** The discrete Lie-Poisson update is the discrete Euler-Poincare equation

(3.17), right-invariant, in any Lie group: \f$f_{12}\f$ satisfies (3.10) after \f$f_{01}\f$ if and only if
\f$\mu_1 = \mathrm{Ad}_{f_{01}}^*\mu_0\f$ for the momenta at the start of the two steps. *)
Theorem eq_3_17_any_group l (f01 f12 : G) :
  (forall v, euler_poincare_right l f01 f12 v = 0)
  <-> momentum_before_right l f12 =1 coadjoint f01 (momentum_before_right l f01).
Proof.
rewrite /euler_poincare_right /momentum_before_right /coadjoint -/(left_differential l f01 _).
split=> [zero v | same v]; first by congr (- _); apply/eqP; rewrite -subr_eq0 zero.
by apply/eqP; rewrite subr_eq0; apply/eqP/oppr_inj/same.
Qed.

(** ** The discrete Lie-Poisson update, left-invariant case

(3.18), corrected, in any Lie group: \f$f_{21}\f$ satisfies (3.11) after \f$f_{10}\f$ if and only if
\f$\Pi_1 = \mathrm{Ad}_{f_{10}^{-1}}^*\Pi_0\f$. *)
Theorem eq_3_18_any_group l (f10 f21 : G) :
  (forall v, euler_poincare_left l f10 f21 v = 0)
  <-> momentum_before_left l f21 =1 coadjoint f10^-1%M (momentum_before_left l f10).
Proof.
rewrite /euler_poincare_left /momentum_before_left /coadjoint /left_differential.
split=> [zero v | same v]; first by congr (- _); rewrite AdVK; apply/eqP; rewrite -subr_eq0 zero.
by have := same v; rewrite AdVK => /oppr_inj ->; rewrite addrN.
Qed.

(** ** The body momentum of a right-invariant discrete system is constant

Section 3.2, the discrete counterpart of (3.16): along a motion \f$\mathrm{Ad}_{g_k}^*\mu_k\f$ is the same for
all steps, so that \f$\mu_k = \mathrm{Ad}_{g_k^{-1}}^*\f$ of a constant. *)
Theorem eq_3_16_discrete L l g N k : descends_right L l -> discrete_motion L g N -> (k < N)%N ->
  coadjoint (g k) (momentum_before_right l (relative_motions_right g k))
  =1 coadjoint (g 0%N) (momentum_before_right l (relative_motions_right g 0%N)).
Proof.
move=> down motion below v.
have still : invariant_along L (fun q => Ad q v).
  move=> g0 g1; rewrite (D1_right _ _ _ down) (D2_right _ _ _ down) /left_differential -Ad_mul.
  by rewrite /relative_motion_right mulVK addrN.
have body i : coadjoint (g i) (momentum_before_right l (relative_motions_right g i)) v
              = discrete_momentum L (fun q => Ad q v) (g i) (g i.+1).
  rewrite /coadjoint /momentum_before_right -(D1_right _ _ _ down).
  by apply: addr0_eq; apply: still.
by rewrite !body; apply: eq_3_8_along_a_motion still motion below.
Qed.

End Reduction.

(** ** Examples of groups *)

(** The translations of an abelian group. *)
Section Translations.

Variable V : zmodType.

Definition translations_group : group := @Group V 0 +%R -%R (@addrA V) (@add0r V) (@addNr V).

Definition translations : lie_group :=
  @LieGroup translations_group V (fun=> [additive of idfun]) (fun _ => erefl) (fun _ _ _ => erefl).

End Translations.

(** The invertible elements of a ring, matrices for example, with \f$\mathrm{Ad}_gx = gxg^{-1}\f$. *)
Section Units.

Variable A : unitRingType.

Definition unit_of := {g : A | g \is a GRing.unit}.
Implicit Types g h : unit_of.

Lemma unit_mul_proof g h : val g * val h \is a GRing.unit.
Proof. by rewrite unitrMl ?(valP g) ?(valP h). Qed.
Lemma unit_inv_proof g : (val g)^-1 \is a GRing.unit.
Proof. by rewrite unitrV (valP g). Qed.

Definition unit_one : unit_of := exist _ 1 (unitr1 A).
Definition unit_mul g h : unit_of := exist _ (val g * val h) (unit_mul_proof g h).
Definition unit_inv g : unit_of := exist _ (val g)^-1 (unit_inv_proof g).

Lemma unit_mulA : associative unit_mul.
Proof. by move=> f g h; apply: val_inj; rewrite /= mulrA. Qed.
Lemma unit_one_mul : left_id unit_one unit_mul.
Proof. by move=> g; apply: val_inj; rewrite /= mul1r. Qed.
Lemma unit_inv_mul : left_inverse unit_one unit_inv unit_mul.
Proof. by move=> g; apply: val_inj; rewrite /= mulVr ?(valP g). Qed.

Definition conjugation g (x : A) := val g * x / val g.
Lemma conjugation_additive g : additive (conjugation g).
Proof. by move=> x y; rewrite /conjugation mulrBr mulrBl. Qed.

Lemma conjugation_one v : conjugation unit_one v = v.
Proof. by rewrite /conjugation /= mul1r divr1. Qed.
Lemma conjugation_mul g h v : conjugation (unit_mul g h) v = conjugation g (conjugation h v).
Proof. by rewrite /conjugation /= invrM ?(valP g) ?(valP h) // !mulrA. Qed.

Definition units : lie_group :=
  @LieGroup (Group unit_mulA unit_one_mul unit_inv_mul) A (fun g => Additive (conjugation_additive g))
    conjugation_one conjugation_mul.

(** In it the tangent group is what it should be: \f$\vartheta g\f$ is the velocity of a matrix, and
velocities of products obey Leibniz' rule. *)
Lemma leibniz_rule_of_units (x y : tangent units) :
  (x * y)%M.2 * val (x * y)%M.1 = (x.2 * val x.1) * val y.1 + val x.1 * (y.2 * val y.1).
Proof.
case: x y => g v [h w] /=; rewrite mulrDl /conjugation !mulrA; congr (_ + _).
by congr (_ * _); apply: mulrVK; apply: (valP g).
Qed.

End Units.

(** ** What fails for N+1 relative motions *)

(** The reduced Lagrangian \f$f^2\f$ of a free particle. *)
Definition reduced_free_particle : reduced_lagrangian (translations [zmodType of int]) [zmodType of int] :=
  @ReducedLagrangian (translations [zmodType of int]) [zmodType of int]
    (fun f : int => f ^+ 2) (fun f : int => times (2%:Z * f)).

(** It is that of the free particle. *)
Lemma free_particle_descends : @descends_right (translations _) _ free_particle reduced_free_particle.
Proof.
case=> a u [b w]; rewrite /along /along_motion /relative_motion_right /=; congr (_, _).
  by rewrite -sqrrN opprB.
have flip (x y p q : int) : 2%:Z * (y - x) * (q - p) = 2%:Z * (x - y) * (p - q).
  by rewrite -[x - y]opprB -[p - q]opprB [2%:Z * - _]mulrN mulrNN.
by rewrite mulNr [LHS]addrC -mulrBr; apply: flip.
Qed.

(** ** N+1 relative motions of N+1 configurations

Theorem 3.2.1 prints \f$s : G^{N+1}\to\mathbb R\f$. The \f$N+1\f$ relative motions that \f$N+1\f$
configurations have, the last one from \f$g_N\f$ back to \f$g_0\f$, are not free: integers that are all 1
are not such differences. *)
Theorem claim_3_2_reduced_action_domain_printed_fails :
  ~ (forall (G : group) (N : nat) (f : nat -> G), (3 <= N)%N ->
      exists g, (forall k, (k < N)%N -> relative_motion_right (g k) (g k.+1) = f k)
                /\ relative_motion_right (g N) (g 0%N) = f N).
Proof.
move/(_ (translations_group [zmodType of int]) 3%N (fun=> 1) isT) => [g [steps last]].
have := congr1 (+%R^~ (g 0%N)) last; rewrite /relative_motion_right /= subrK.
have {}steps k (le : (k < 3)%N) : g k = 1 + g k.+1 by rewrite -(steps k le) /= subrK.
rewrite (steps 0%N) // (steps 1%N) // (steps 2%N) // !addrA => /(congr1 (+%R^~ (- g 3%N))).
by rewrite addrN addrK.
Qed.

(** ** No other function of the configurations serves

The quotient of \f$G^{N+1}\f$ by right multiplication is not \f$G^{N+1}\f$, whatever the map: for the group
of two elements no map that is constant along right multiplication takes every value in \f$G^{N+1}\f$. *)
Theorem claim_3_2_reduced_action_domain_printed_fails_any_map :
  ~ (forall (G : group) (N : nat), (3 <= N)%N ->
      exists q : N.+1.-tuple G -> N.+1.-tuple G,
        (forall g c, q (map_tuple (fun x => (x * c)%M) g) = q g) /\ (forall f, exists g, q g = f)).
Proof.
have addNb : left_inverse false id addb by case.
move/(_ (Group addbA addFb addNb) 3%N isT) => [/= q [invariant onto]].
have [s section] := fin_all_exists onto.
have q_injective : injective q.
  have [t st ts] := injF_bij (can_inj section).
  by move=> x y; rewrite -(ts x) -(ts y) !section => ->.
by have /q_injective/(congr1 val) := invariant [tuple of nseq 4 false] true.
Qed.

(** ** Condition (3) with N+1 terms

Theorem 3.2.1 as printed: with \f$N+1\f$ relative motions the sum has one term more, and one more
configuration \f$g_{N+1}\f$, which is not held. Along the motion \f$g_k = k\f$ of a free particle, which
satisfies (4), that sum is not stationary. *)
Theorem thm_3_2_1_printed_fails :
  ~ (forall (G : lie_group) (W : zmodType) (l : reduced_lagrangian G W) (g : nat -> G) (N : nat),
      (3 <= N)%N -> reduced_motion_right l (relative_motions_right g) N ->
      forall theta, theta 0%N = 0 -> theta N = 0 ->
      reduced_differential l (relative_motions_right g) theta N.+1 = 0).
Proof.
move/(_ _ _ reduced_free_particle Posz 3%N isT) => fails.
have motion :
    reduced_motion_right reduced_free_particle (relative_motions_right (G := translations _) Posz) 3.
  move=> [//|k] _ v; rewrite /euler_poincare_right /left_differential /relative_motions_right.
  have step i : relative_motion_right (Posz i : translations _) (Posz i.+1) = -1.
    by rewrite /relative_motion_right /= intS opprD addrCA addrN addr0.
  by rewrite !step addrN.
have := fails motion (bump 4%N 1) erefl erefl.
by rewrite /reduced_differential unlock.
Qed.

(** ** Noether's theorem for discrete fields *)

Section DiscreteFields.

Variables (cell node : finType) (V W : zmodType).

(** Cells with their corners among the nodes, and the derivatives of the Lagrangian of each cell by the
values of the field at the nodes. *)
Variables (corner : cell -> node -> bool) (force : cell -> node -> V -> W).
Hypothesis corners_alone : forall c p v, ~~ corner c p -> force c p v = 0.

(** The discrete field equation at a node: the forces of all cells around it cancel. *)
Definition field_equation p := forall v, \sum_c force c p v = 0.

(** A node that has no corner of the patch, or lies inside it, surrounded by its cells. *)
Definition outside (patch : {set cell}) p := forall c, c \in patch -> ~~ corner c p.
Definition inside (patch : {set cell}) p := forall c, corner c p -> c \in patch.

(** ** The sum of discrete momenta over the boundary of a set of cells

Chapter 10: let a field of generators \f$\xi\f$ be a symmetry of the Lagrangian of each cell of a patch, and
let the nodes that are not in a set \f$B\f$ lie outside the patch, or inside it where the field solves its
equations. Then the values of the discrete momentum map of the cells of the patch, summed over the nodes of
\f$B\f$, give zero. *)
Theorem claim_10_0_discrete_noether_sum (patch : {set cell}) (B : {set node}) (xi : node -> V) :
  (forall c, c \in patch -> \sum_p force c p (xi p) = 0) ->
  (forall p, p \notin B -> outside patch p \/ inside patch p /\ field_equation p) ->
  \sum_(p in B) \sum_(c in patch) force c p (xi p) = 0.
Proof.
move=> symmetric others.
(* All nodes together give zero, cell by cell. *)
have whole : \sum_p \sum_(c in patch) force c p (xi p) = 0.
  by rewrite exchange_big big1.
rewrite -[LHS]addr0 -[RHS]whole [RHS](bigID (mem B)) /=; congr (_ + _); rewrite big1 // => p off.
case: (others p off) => [away | [around solved]]; first by rewrite big1 // => c /away/corners_alone.
rewrite -[RHS](solved (xi p)) [RHS](bigID (mem patch)) /= [X in _ = _ + X]big1 ?addr0 // => c missing.
by apply: corners_alone; apply: contra missing => /around.
Qed.

End DiscreteFields.
