(** * Groupoids and Legendre maps

The algebra of chapter 4: groupoids and their examples, the Lagrange equations on a groupoid, the maps between a group
and the dual of its algebra, the system (4.4) that a discrete Lagrangian makes of them, the commuting square of section
4.3, and the lifts of coadjoint orbits to the cotangent bundle. Group elements are invertible matrices and derivatives
are taken with dual numbers, as in `groups`. A momentum has its physical sign where a theorem says so: for an action
\f$\mathbb L(g_0, g_1)\f$ it is \f$-\partial\mathbb L/\partial g_0\f$ at the start and
\f$\partial\mathbb L/\partial g_1\f$ at the end of the step, as section 4.2 has it for generating functions,
\f$p_0 = -\partial S/\partial q_0\f$ and \f$p = \partial S/\partial q\f$. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices dual_numbers computed groups.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope nat_scope.
Local Open Scope ring_scope.

(** ** What a groupoid is

An arrow leads from its source to its target; \f$gh\f$ is defined where the target of \f$g\f$ is the source of \f$h\f$.
C++: `actio::Groupoid`, `groupoid/groupoid.hpp`. *)
Record groupoid := Groupoid {
  arrow : Type;
  point : Type;
  source : arrow -> point;
  target : arrow -> point;
  compose : arrow -> arrow -> arrow;
  unit_at : point -> arrow;
  inverse : arrow -> arrow
}.

Arguments source {_} _.
Arguments target {_} _.
Arguments compose {_} _ _.
Arguments unit_at {_} _.
Arguments inverse {_} _.

(** \f$gh\f$ is defined. *)
Definition composable (Gamma : groupoid) (g h : arrow Gamma) := target g = source h.

(** The laws: sources and targets of products, units and inverses; products are associative; units do nothing; an arrow
and its inverse make units. *)
Record is_groupoid (Gamma : groupoid) : Prop := IsGroupoid {
  source_compose : forall g h : arrow Gamma, composable g h -> source (compose g h) = source g;
  target_compose : forall g h : arrow Gamma, composable g h -> target (compose g h) = target h;
  compose_assoc : forall g h k : arrow Gamma, composable g h -> composable h k ->
    compose (compose g h) k = compose g (compose h k);
  source_unit : forall x : point Gamma, source (unit_at x) = x;
  target_unit : forall x : point Gamma, target (unit_at x) = x;
  unit_compose : forall g : arrow Gamma, compose (unit_at (source g)) g = g;
  compose_unit : forall g : arrow Gamma, compose g (unit_at (target g)) = g;
  source_inverse : forall g : arrow Gamma, source (inverse g) = target g;
  target_inverse : forall g : arrow Gamma, target (inverse g) = source g;
  compose_inverse : forall g : arrow Gamma, compose g (inverse g) = unit_at (source g);
  inverse_compose : forall g : arrow Gamma, compose (inverse g) g = unit_at (target g)
}.

(** A group, for the examples: its elements may be of any type. *)
Record group := Group {
  element : Type;
  times : element -> element -> element;
  one : element;
  back : element -> element;
  times_assoc : forall a b c, times (times a b) c = times a (times b c);
  one_times : forall a, times one a = a;
  times_one : forall a, times a one = a;
  times_back : forall a, times a (back a) = one;
  back_times : forall a, times (back a) a = one
}.

Lemma back_product (G : group) (a b : element G) : back (times a b) = times (back b) (back a).
Proof.
have makes_one : times (times a b) (times (back b) (back a)) = one G.
  by rewrite times_assoc -[times b _]times_assoc times_back one_times times_back.
by rewrite -[RHS]one_times -(back_times (times a b)) times_assoc makes_one times_one.
Qed.

(** ** Pairs and groups are groupoids

Section 4.1: the pairs \f$(x_0, x_1)\f$ of points of any set, with \f$(g, h)(h, k) = (g, k)\f$; and a group, over one
point. *)

(** C++: `actio::PairGroupoid`, `groupoid/pair_groupoid.hpp`. *)
Definition pair_groupoid (M : Type) := {|
  arrow := M * M; point := M; source g := g.1; target g := g.2; compose g h := (g.1, h.2);
  unit_at x := (x, x); inverse g := (g.2, g.1) |}.

Theorem claim_4_1_groupoids_pairs M : is_groupoid (pair_groupoid M).
Proof. by split=> //= - []. Qed.

(** C++: `actio::GroupAsGroupoid`, `groupoid/group_as_groupoid.hpp`. *)
Definition group_as_groupoid (G : group) := {|
  arrow := element G; point := unit; source _ := tt; target _ := tt; compose := @times G;
  unit_at _ := one G; inverse := @back G |}.

Theorem claim_4_1_groupoids_group G : is_groupoid (group_as_groupoid G).
Proof.
split=> //=; [by move=> *; apply: times_assoc|by case|by case|exact: one_times|exact: times_one| | ].
- exact: times_back.
exact: back_times.
Qed.

(** ** Three more groupoids

The opposite of a groupoid, in which arrows are read backwards: left-invariant systems live on the opposite of the group.
C++: `actio::Opposite`, `groupoid/opposite_groupoid.hpp`. *)
Definition opposite (Gamma : groupoid) := {|
  arrow := arrow Gamma; point := point Gamma; source := @target Gamma; target := @source Gamma;
  compose g h := compose h g; unit_at := @unit_at Gamma; inverse := @inverse Gamma |}.

Theorem opposite_is_groupoid Gamma : is_groupoid Gamma -> is_groupoid (opposite Gamma).
Proof.
case=> s_c t_c assoc s_u t_u u_c c_u s_i t_i c_i i_c; split=> //=.
- by move=> g h gh; apply: t_c.
- by move=> g h gh; apply: s_c.
by move=> g h k gh hk; rewrite assoc.
Qed.

(** The gauge groupoid of a trivial bundle \f$M\times K\f$: arrows \f$(x_0, x_1, k)\f$, which stand for the pairs
\f$((x_0, k_0), (x_1, k_1))\f$ with \f$k = k_0^{-1}k_1\f$, modulo multiplication of both on the left.
C++: `actio::GaugeGroupoid`, `groupoid/gauge_groupoid.hpp`. *)
Definition gauge_groupoid (M : Type) (K : group) := {|
  arrow := M * M * element K; point := M; source g := g.1.1; target g := g.1.2;
  compose g h := (g.1.1, h.1.2, times g.2 h.2); unit_at x := (x, x, one K);
  inverse g := (g.1.2, g.1.1, back g.2) |}.

Theorem gauge_is_groupoid M K : is_groupoid (gauge_groupoid M K).
Proof.
split=> //=.
- by move=> [[x0 x1] a] [[x2 x3] b] [[x4 x5] c] _ _ /=; rewrite times_assoc.
- by move=> [[x0 x1] a] /=; rewrite one_times.
- by move=> [[x0 x1] a] /=; rewrite times_one.
- by move=> [[x0 x1] a] /=; rewrite times_back.
by move=> [[x0 x1] a] /=; rewrite back_times.
Qed.

(** The quotient map from pairs takes products to products, and its fibres are the orbits of the group. *)
Definition gauge_class (M : Type) (K : group) (g : arrow (pair_groupoid (M * element K))) : arrow (gauge_groupoid M K) :=
  (g.1.1, g.2.1, times (back g.1.2) g.2.2).

Theorem gauge_class_of_product M K (g h : arrow (pair_groupoid (M * element K))) : composable g h ->
  gauge_class (compose g h) = compose (gauge_class g) (gauge_class h).
Proof.
case: g h => [[x0 k0] [x1 k1]] [[y0 l0] [y1 l1]] [-> ->]; rewrite /gauge_class /=; congr (_, _).
by rewrite times_assoc -[times l0 _]times_assoc times_back one_times.
Qed.

Theorem gauge_class_fibres M K (g h : arrow (pair_groupoid (M * element K))) :
  gauge_class g = gauge_class h
  <-> exists k, h = ((g.1.1, times k g.1.2), (g.2.1, times k g.2.2)).
Proof.
case: g h => [[x0 k0] [x1 k1]] [[y0 l0] [y1 l1]]; rewrite /gauge_class /=; split.
  move=> [-> -> same]; exists (times l0 (back k0)).
  by rewrite !times_assoc back_times times_one same -times_assoc times_back one_times.
case=> k [-> -> -> ->]; congr (_, _).
by rewrite back_product times_assoc -[times (back k) _]times_assoc back_times one_times.
Qed.

(** ** The fibres of the multiplication

In every groupoid: the composable pairs with the same product as \f$(g, h)\f$ are the
\f$(gx, x^{-1}h)\f$ with \f$x\f$ an arrow from the point where \f$g\f$ and \f$h\f$ meet. These are the pairs among
which definition 4.1.1 asks for stationary points. *)

Theorem fibres_of_multiplication Gamma (g h g' h' : arrow Gamma) : is_groupoid Gamma -> composable g h ->
  (composable g' h' /\ compose g' h' = compose g h)
  <-> exists2 x, source x = target g & g' = compose g x /\ h' = compose (inverse x) h.
Proof.
move=> laws gh; split=> [[gh' same]|[x x_g [-> ->]]]; last first.
  have xh : composable (inverse x) h by rewrite /composable target_inverse // x_g.
  have gx : composable g x by rewrite /composable.
  have joint : composable (compose g x) (compose (inverse x) h).
    by rewrite /composable target_compose // source_compose // source_inverse.
  have turn : composable x (inverse x) by rewrite /composable source_inverse.
  have gx_back : composable (compose g x) (inverse x) by rewrite /composable target_compose // source_inverse.
  split=> //; rewrite -(compose_assoc laws gx_back xh) (compose_assoc laws gx turn).
  by rewrite compose_inverse // x_g compose_unit.
have from : source g' = source g by rewrite -(source_compose laws gh') same source_compose.
have back_g : composable (inverse g) g' by rewrite /composable target_inverse.
exists (compose (inverse g) g'); first by rewrite source_compose // source_inverse.
split; first by rewrite -compose_assoc ?/composable ?source_inverse // compose_inverse // -from unit_compose.
have x_h' : composable (compose (inverse g) g') h' by rewrite /composable target_compose.
have onward : compose (compose (inverse g) g') h' = h.
  rewrite compose_assoc // same -compose_assoc ?/composable ?target_inverse //.
  by rewrite inverse_compose // gh unit_compose.
by rewrite -onward -compose_assoc ?/composable ?target_inverse // inverse_compose // x_h' unit_compose.
Qed.


(** ** The Lagrange equations on a group of matrices

Definition 4.1.1: \f$(g, h)\f$ is critical where \f$\mathcal L(g) + \mathcal L(h)\f$ is stationary among the composable
pairs with the product \f$gh\f$. Varied pairs are \f$(g+\varepsilon a, h+\varepsilon b)\f$ with
\f$(g+\varepsilon a)(h+\varepsilon b) = gh\f$, and with \f$g^{-1}a\f$ in the algebra of the group. *)

Section GroupOfMatrices.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (a b f g h k p q v w mu nu : 'M[R]_n) (l : 'M[dual R]_n -> dual R).
Implicit Types (algebra : 'M[R]_n -> Prop) (L : 'M[dual R]_n -> 'M[dual R]_n -> dual R).

Definition critical algebra l g h := forall a b, algebra (invmx g *m a) ->
  varied g a *m varied h b = still (g *m h) -> rate (l (varied g a) + l (varied h b)) = 0.

(** \f$\tilde\beta\circ d\ell\f$, the momentum at the end of an arrow:
\f$v\mapsto\frac{d}{d\varepsilon}\ell(g(1+\varepsilon v))\f$.
C++: `actio::legendre_at_target`, `groupoid/lagrange_equations.hpp`. *)
Definition legendre_at_target l g v := rate (l (still g *m varied 1%:M v)).

(** \f$\tilde\alpha\circ d\ell\f$, the momentum at the start of an arrow:
\f$v\mapsto-\frac{d}{d\varepsilon}\ell((1+\varepsilon v)^{-1}h)\f$.
C++: `actio::legendre_at_source`, `groupoid/lagrange_equations.hpp`. *)
Definition legendre_at_source l h v := - rate (l (invmx (varied 1%:M v) *m still h)).

(** On a group of matrices these are \f$L_g^*\ell'(g)\f$ and \f$R_h^*\ell'(h)\f$. *)

Theorem legendre_at_target_of_group l g v : differentiable l g ->
  legendre_at_target l g v = pairing (left_differential l g) v.
Proof.
by move=> dl; rewrite /legendre_at_target varied_mul mulmx1 mul0mx addr0 dl L_star_dual.
Qed.

Theorem legendre_at_source_of_group l h v : differentiable l h ->
  legendre_at_source l h v = pairing (right_differential l h) v.
Proof.
move=> dl; rewrite /legendre_at_source varied_inverse ?unitmx1 // varied_mul inverse_one !mul1mx mulmx1.
by rewrite add0r mulNmx dl pairing_oppr opprK R_star_dual.
Qed.

(** Variations with a fixed product: \f$a = gv\f$ and \f$b = -vh\f$ with one \f$v\f$. *)
Lemma fixed_product g h a b : g \in unitmx ->
  varied g a *m varied h b = still (g *m h) <-> b = - (invmx g *m a *m h).
Proof.
move=> u; rewrite varied_mul; split=> [/(congr1 (@rate_of _ _ _))|->].
  rewrite !rate_varied => /eqP; rewrite addr_eq0 => /eqP gb.
  by rewrite -[b]mul1mx -(mulVmx u) -[_ *m b]mulmxA gb mulmxN !mulmxA.
by rewrite mulmxN !mulmxA mulmxV // mul1mx addNr.
Qed.

(** A pair is critical exactly where the momentum at the end of \f$g\f$ is the momentum at the start of \f$h\f$. *)

Theorem def_4_1_1 algebra l g h : g \in unitmx -> differentiable l g -> differentiable l h ->
  critical algebra l g h <-> agree algebra (left_differential l g) (right_differential l h).
Proof.
move=> u dg dh.
have rate_is v : rate (l (varied g (g *m v)) + l (varied h (- (v *m h))))
    = pairing (left_differential l g) v - pairing (right_differential l h) v.
  by rewrite raddfD /= dg dh pairing_oppr L_star_dual R_star_dual.
split=> [stationary v in_v|same a b in_a].
  apply/eqP; rewrite -subr_eq0 -rate_is; apply/eqP; apply: stationary.
    by rewrite mulmxA mulVmx // mul1mx.
  by apply/(fixed_product _ _ _ u); rewrite mulmxA mulVmx // mul1mx.
move/(fixed_product _ _ _ u) => ->; rewrite -[a in varied g a](mul1mx a) -(mulmxV u) -mulmxA rate_is same //.
by rewrite subrr.
Qed.

(** These are the discrete Euler-Poincare equations (3.10) with \f$g = f_{01}\f$ and \f$h = f_{12}\f$, \f$f =
g_kg_{k+1}^{-1}\f$; and on the opposite of the group, where the product of \f$g\f$ and \f$h\f$ is \f$hg\f$, the equations
(3.11) with \f$g = f_{10}\f$ and \f$h = f_{21}\f$, \f$f = g_{k+1}^{-1}g_k\f$. *)

Theorem def_4_1_1_right algebra l f01 f12 : f01 \in unitmx -> differentiable l f01 -> differentiable l f12 ->
  critical algebra l f01 f12 <-> agree algebra (euler_poincare_right l f01 f12) 0.
Proof.
move=> u d0 d1; apply: (iff_trans (def_4_1_1 algebra u d0 d1)).
split=> same x in_x; move: (same x in_x); rewrite pairing_0l pairing_addl pairing_oppl.
  by move=> ->; rewrite subrr.
by move/eqP; rewrite subr_eq0 => /eqP.
Qed.

Theorem def_4_1_1_left algebra l f10 f21 : f21 \in unitmx -> differentiable l f10 -> differentiable l f21 ->
  critical algebra l f21 f10 <-> agree algebra (euler_poincare_left l f10 f21) 0.
Proof.
move=> u d0 d1; apply: (iff_trans (def_4_1_1 algebra u d1 d0)).
split=> same x in_x; move: (same x in_x); rewrite pairing_0l pairing_addl pairing_oppl.
  by move=> ->; rewrite subrr.
by move/eqP; rewrite subr_eq0 => /eqP.
Qed.

(** ** The Lagrange equations on pairs

In the groupoid of pairs the composable pairs of arrows with one product are
\f$((g_0, x), (x, g_2))\f$: the configuration between moves. They are stationary where
\f$D_2\mathbb L(g_0, g_1) + D_1\mathbb L(g_1, g_2) = 0\f$, the discrete Euler-Lagrange equations (3.2). Covectors at a
configuration are translated to the identity on the right. *)

(** \f$\partial\mathbb L/\partial g_0\f$ and \f$\partial\mathbb L/\partial g_1\f$ at a pair. *)
Definition first_differential L g0 g1 :=
  differential (fun x => L x (still g1)) g0.
Definition second_differential L g0 g1 :=
  differential (fun x => L (still g0) x) g1.

(** C++: `actio::D1`, `reduction/discrete_euler_lagrange.hpp`. *)
Definition D1 L g0 g1 := R_star g0 (first_differential L g0 g1).

(** C++: `actio::D2`, `reduction/discrete_euler_lagrange.hpp`. *)
Definition D2 L g0 g1 := R_star g1 (second_differential L g0 g1).

(** C++: `actio::discrete_euler_lagrange`, `reduction/discrete_euler_lagrange.hpp`. *)
Definition discrete_euler_lagrange L g0 g1 g2 := D2 L g0 g1 + D1 L g1 g2.

Theorem def_4_1_1_pairs algebra L g0 g1 g2 : g1 \in unitmx ->
  differentiable (fun x => L (still g0) x) g1 -> differentiable (fun x => L x (still g2)) g1 ->
  (forall g h : arrow (pair_groupoid 'M[dual R]_n),
     value_of (target g) = g1 -> algebra (rate_of (target g) *m invmx g1) ->
     composable g h -> compose g h = (still g0, still g2) -> rate (L g.1 g.2 + L h.1 h.2) = 0)
  <-> agree algebra (discrete_euler_lagrange L g0 g1 g2) 0.
Proof.
move=> u d2 d1.
have rate_is v : rate (L (still g0) (varied g1 (v *m g1)) + L (varied g1 (v *m g1)) (still g2))
    = pairing (discrete_euler_lagrange L g0 g1 g2) v.
  by rewrite raddfD /= (d1 (v *m g1)) (d2 (v *m g1)) /discrete_euler_lagrange pairing_addl !R_star_dual.
split=> [stationary v in_v|same [g g'] [h h'] /= value_g in_g].
  rewrite pairing_0l -rate_is.
  apply: (stationary (still g0, varied g1 (v *m g1)) (varied g1 (v *m g1), still g2)) => //=.
    by rewrite value_varied.
  by rewrite rate_varied -mulmxA mulmxV // mulmx1.
rewrite /composable /= => <- [-> ->]; set v := rate_of g' *m invmx g1.
have -> : g' = varied g1 (v *m g1) by rewrite {1}[g']variedE value_g /v -mulmxA mulVmx // mulmx1.
by have := rate_is v; rewrite same ?pairing_0l.
Qed.

End GroupOfMatrices.
