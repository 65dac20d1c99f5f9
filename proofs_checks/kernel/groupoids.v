(** * Groupoids and Legendre maps

The algebra of chapter 4: groupoids and their examples, the Lagrange equations on a groupoid, the maps between
a group and the dual of its algebra, the system (4.4) that a discrete Lagrangian makes of them, the commuting
square of section 4.3, and the lifts of coadjoint orbits to the cotangent bundle. Group elements are
invertible matrices and derivatives are taken with dual numbers, as in `groups`. A momentum has its physical
sign where a theorem says so: for an action \f$\mathbb L(g_0, g_1)\f$ it is
\f$-\partial\mathbb L/\partial g_0\f$ at the start and \f$\partial\mathbb L/\partial g_1\f$ at the end of the
step, as section 4.2 has it for generating functions, \f$p_0 = -\partial S/\partial q_0\f$ and
\f$p = \partial S/\partial q\f$. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices dual_numbers computed groups.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope nat_scope.
Local Open Scope ring_scope.

(** ** What a groupoid is

An arrow leads from its source to its target; \f$gh\f$ is defined where the target of \f$g\f$ is the source of
\f$h\f$. C++: `actio::Groupoid`, `groupoid/groupoid.hpp`. *)
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

(** The laws: sources and targets of products, units and inverses; products are associative; units do nothing;
an arrow and its inverse make units. *)
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

(** The pairs \f$(x_0, x_1)\f$ of points of any set. C++: `actio::PairGroupoid`, `groupoid/pair_groupoid.hpp`.
*)
Definition pair_groupoid (M : Type) := {|
  arrow := M * M; point := M; source g := g.1; target g := g.2; compose g h := (g.1, h.2);
  unit_at x := (x, x); inverse g := (g.2, g.1) |}.

(** ** Pairs are a groupoid

Section 4.1: the pairs of points of any set, with \f$(g, h)(h, k) = (g, k)\f$. *)
Theorem claim_4_1_groupoids_pairs M : is_groupoid (pair_groupoid M).
Proof. by split=> //= - []. Qed.

(** A group over one point. C++: `actio::GroupAsGroupoid`, `groupoid/group_as_groupoid.hpp`. *)
Definition group_as_groupoid (G : group) := {|
  arrow := element G; point := unit; source _ := tt; target _ := tt; compose := @times G;
  unit_at _ := one G; inverse := @back G |}.

(** ** A group is a groupoid

Section 4.1: its elements are arrows from a single point to itself. *)
Theorem claim_4_1_groupoids_group G : is_groupoid (group_as_groupoid G).
Proof.
split=> //=; [by move=> *; apply: times_assoc|by case|by case|exact: one_times|exact: times_one| | ].
- exact: times_back.
exact: back_times.
Qed.

(** The opposite of a groupoid, in which arrows are read backwards: left-invariant systems live on the
opposite of the group. C++: `actio::Opposite`, `groupoid/opposite_groupoid.hpp`. *)
Definition opposite (Gamma : groupoid) := {|
  arrow := arrow Gamma; point := point Gamma; source := @target Gamma; target := @source Gamma;
  compose g h := compose h g; unit_at := @unit_at Gamma; inverse := @inverse Gamma |}.

(** ** The opposite of a groupoid is one

Left-invariant systems live on the opposite of the group, in which the product of \f$g\f$ and \f$h\f$ is
\f$hg\f$. *)
Theorem opposite_is_groupoid Gamma : is_groupoid Gamma -> is_groupoid (opposite Gamma).
Proof.
case=> s_c t_c assoc s_u t_u u_c c_u s_i t_i c_i i_c; split=> //=.
- by move=> g h gh; apply: t_c.
- by move=> g h gh; apply: s_c.
by move=> g h k gh hk; rewrite assoc.
Qed.

(** The gauge groupoid of a trivial bundle \f$M\times K\f$: arrows \f$(x_0, x_1, k)\f$, which stand for the
pairs \f$((x_0, k_0), (x_1, k_1))\f$ with \f$k = k_0^{-1}k_1\f$, modulo multiplication of both on the left.
C++: `actio::GaugeGroupoid`, `groupoid/gauge_groupoid.hpp`. *)
Definition gauge_groupoid (M : Type) (K : group) := {|
  arrow := M * M * element K; point := M; source g := g.1.1; target g := g.1.2;
  compose g h := (g.1.1, h.1.2, times g.2 h.2); unit_at x := (x, x, one K);
  inverse g := (g.1.2, g.1.1, back g.2) |}.

(** ** The gauge groupoid of a trivial bundle

\f$(x_0, x_1, k)(x_1, x_2, l) = (x_0, x_2, kl)\f$ obeys the laws of a groupoid, for any set of points and any
group. *)
Theorem gauge_is_groupoid M K : is_groupoid (gauge_groupoid M K).
Proof.
split=> //=.
- by move=> [[x0 x1] a] [[x2 x3] b] [[x4 x5] c] _ _ /=; rewrite times_assoc.
- by move=> [[x0 x1] a] /=; rewrite one_times.
- by move=> [[x0 x1] a] /=; rewrite times_one.
- by move=> [[x0 x1] a] /=; rewrite times_back.
by move=> [[x0 x1] a] /=; rewrite back_times.
Qed.

(** The quotient map from pairs of points of \f$M\times K\f$. *)
Definition gauge_class (M : Type) (K : group) (g : arrow (pair_groupoid (M * element K))) :
  arrow (gauge_groupoid M K) :=
  (g.1.1, g.2.1, times (back g.1.2) g.2.2).

(** ** The quotient map takes products to products

From pairs of points of \f$M\times K\f$ to the gauge groupoid. *)
Theorem gauge_class_of_product M K (g h : arrow (pair_groupoid (M * element K))) : composable g h ->
  gauge_class (compose g h) = compose (gauge_class g) (gauge_class h).
Proof.
case: g h => [[x0 k0] [x1 k1]] [[y0 l0] [y1 l1]] [-> ->]; rewrite /gauge_class /=; congr (_, _).
by rewrite times_assoc -[times l0 _]times_assoc times_back one_times.
Qed.

(** ** The fibres of the quotient map

Two pairs have one class exactly where one is the other, multiplied on the left by one group element. *)
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

In every groupoid: the composable pairs with the same product as \f$(g, h)\f$ are the \f$(gx, x^{-1}h)\f$ with
\f$x\f$ an arrow from the point where \f$g\f$ and \f$h\f$ meet. These are the pairs among which definition
4.1.1 asks for stationary points. *)

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

Section GroupOfMatrices.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (a b f g h k p q v w mu nu : 'M[R]_n) (l : 'M[dual R]_n -> dual R).
Implicit Types (algebra : 'M[R]_n -> Prop) (L : 'M[dual R]_n -> 'M[dual R]_n -> dual R).

(** Definition 4.1.1 on a group of matrices: \f$(g, h)\f$ is critical where
\f$\mathcal L(g) + \mathcal L(h)\f$ is stationary among the composable pairs with the product \f$gh\f$. Varied
pairs are \f$(g+\varepsilon a, h+\varepsilon b)\f$ with \f$(g+\varepsilon a)(h+\varepsilon b) = gh\f$, and
with \f$g^{-1}a\f$ in the algebra of the group. *)
Definition critical algebra l g h := forall a b, algebra (invmx g *m a) ->
  varied g a *m varied h b = still (g *m h) -> rate (l (varied g a) + l (varied h b)) = 0.

(** \f$\tilde\beta\circ d\ell\f$, the momentum at the end of an arrow:
\f$v\mapsto\frac{d}{d\varepsilon}\ell(g(1+\varepsilon v))\f$. C++: `actio::legendre_at_target`,
`groupoid/lagrange_equations.hpp`. *)
Definition legendre_at_target l g v := rate (l (still g *m varied 1%:M v)).

(** \f$\tilde\alpha\circ d\ell\f$, the momentum at the start of an arrow:
\f$v\mapsto-\frac{d}{d\varepsilon}\ell((1+\varepsilon v)^{-1}h)\f$. C++: `actio::legendre_at_source`,
`groupoid/lagrange_equations.hpp`. *)
Definition legendre_at_source l h v := - rate (l (invmx (varied 1%:M v) *m still h)).

(** ** The Legendre map at the target of an arrow

On a group of matrices it is \f$L_g^*\ell'(g)\f$. *)
Theorem legendre_at_target_of_group l g v : differentiable l g ->
  legendre_at_target l g v = pairing (left_differential l g) v.
Proof.
by move=> dl; rewrite /legendre_at_target varied_mul mulmx1 mul0mx addr0 dl L_star_dual.
Qed.

(** ** The Legendre map at the source of an arrow

On a group of matrices it is \f$R_h^*\ell'(h)\f$. *)
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

(** ** The Lagrange equations on a group of matrices

Definition 4.1.1: the pair \f$(g, h)\f$ is critical exactly where the momentum at the end of \f$g\f$ is the
momentum at the start of \f$h\f$, \f$L_g^*\ell'(g) = R_h^*\ell'(h)\f$ on the algebra. *)
Theorem def_4_1_1_group algebra l g h : g \in unitmx -> differentiable l g -> differentiable l h ->
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

(** ** They are the discrete Euler-Poincare equations (3.10)

Definition 4.1.1 with \f$g = f_{01}\f$ and \f$h = f_{12}\f$, \f$f_{k,k+1} = g_kg_{k+1}^{-1}\f$. *)
Theorem def_4_1_1_right algebra l f01 f12 : f01 \in unitmx -> differentiable l f01 -> differentiable l f12 ->
  critical algebra l f01 f12 <-> agree algebra (euler_poincare_right l f01 f12) 0.
Proof.
move=> u d0 d1; apply: (iff_trans (def_4_1_1_group algebra u d0 d1)).
split=> same x in_x; move: (same x in_x); rewrite pairing_0l pairing_addl pairing_oppl.
  by move=> ->; rewrite subrr.
by move/eqP; rewrite subr_eq0 => /eqP.
Qed.

(** ** On the opposite of the group they are (3.11)

Definition 4.1.1 with \f$g = f_{10}\f$ and \f$h = f_{21}\f$, \f$f_{k+1,k} = g_{k+1}^{-1}g_k\f$: the product of
the two in the opposite of the group is \f$f_{21}f_{10}\f$, so that the later relative motion is the first
factor. *)
Theorem def_4_1_1_left algebra l f10 f21 : f21 \in unitmx -> differentiable l f10 -> differentiable l f21 ->
  critical algebra l f21 f10 <-> agree algebra (euler_poincare_left l f10 f21) 0.
Proof.
move=> u d0 d1; apply: (iff_trans (def_4_1_1_group algebra u d1 d0)).
split=> same x in_x; move: (same x in_x); rewrite pairing_0l pairing_addl pairing_oppl.
  by move=> ->; rewrite subrr.
by move/eqP; rewrite subr_eq0 => /eqP.
Qed.

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

(** ** The Lagrange equations on pairs

Definition 4.1.1 in the groupoid of pairs: the composable pairs of arrows with the product \f$(g_0, g_2)\f$
are \f$((g_0, x), (x, g_2))\f$, so that the configuration between moves. They are stationary where
\f$D_2\mathbb L(g_0, g_1) + D_1\mathbb L(g_1, g_2) = 0\f$, the discrete Euler-Lagrange equations (3.2).
Covectors at a configuration are translated to the identity on the right. *)
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

Section Sequences.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (g v : nat -> 'M[R]_n) (l : 'M[dual R]_n -> dual R) (algebra : 'M[R]_n -> Prop).

(** The arrows \f$g_0, \dots, g_N\f$ are varied at their joints: \f$g_k\f$ becomes \f$x_k^{-1}g_kx_{k+1}\f$
with \f$x_k = 1+\varepsilon v_k\f$. *)
Definition joint v k : 'M[dual R]_n := varied 1%:M (v k).
Definition moved_arrow g v k := invmx (joint v k) *m still (g k) *m joint v k.+1.

Lemma moved_arrowE g v k : moved_arrow g v k = varied (g k) (g k *m v k.+1 - v k *m g k).
Proof.
rewrite /moved_arrow /joint varied_inverse ?unitmx1 // !varied_mul inverse_one !mul1mx !mulmx1 add0r.
by rewrite mulNmx.
Qed.

(** ** Arrows varied at their joints keep their product

Section 4.1, below definition 4.1.1. Nothing moves at the two ends of the sequence, and the product of all
arrows is held. *)
Theorem claim_4_1_solution_sequence_product g v N : v 0%N = 0 -> v N = 0 ->
  composed_right (moved_arrow g v) N = still (composed_right g N).
Proof.
move=> start stop.
suff telescopes k : composed_right (moved_arrow g v) k = still (composed_right g k) *m joint v k.
  by rewrite telescopes /joint stop varied_one mulmx1.
elim: k => [|k IH] /=; first by rewrite /joint start /still varied_one mulmx1.
have unit_joint : joint v k \in unitmx by rewrite varied_unit unitmx1.
rewrite IH /moved_arrow !mulmxA -[_ *m joint v k *m _]mulmxA mulmxV // mulmx1.
by rewrite /still [varied _ 0 *m varied _ 0]varied_mul mulmx0 mul0mx addr0.
Qed.

(** ** How the sum along a sequence changes

Section 4.1, below definition 4.1.1: with \f$v_0 = v_{N+1} = 0\f$,
\f[ \frac{d}{d\varepsilon}\sum_{k=0}^N\ell(x_k^{-1}g_kx_{k+1}) = \sum_{k=0}^{N-1}\langle L^*_{g_k}\ell'(g_k) -
R^*_{g_{k+1}}\ell'(g_{k+1}), v_{k+1}\rangle. \f] *)
Theorem claim_4_1_solution_sequence_sum l g v N : (forall k, differentiable l (g k)) ->
  v 0%N = 0 -> v N.+1 = 0 ->
  rate (\sum_(k < N.+1) l (moved_arrow g v k))
  = \sum_(k < N) pairing (left_differential l (g k) - right_differential l (g k.+1)) (v k.+1).
Proof.
move=> dl start stop; rewrite raddf_sum.
have each k : rate (l (moved_arrow g v k))
    = pairing (left_differential l (g k)) (v k.+1) - pairing (right_differential l (g k)) (v k).
  by rewrite moved_arrowE dl pairing_addr pairing_oppr L_star_dual R_star_dual.
rewrite (eq_bigr _ (fun (k : 'I_N.+1) _ => each k)) sumrB big_ord_recr big_ord_recl /= start stop.
rewrite !pairing_0r addr0 add0r.
by rewrite -sumrB; apply: eq_bigr => k _; rewrite pairing_addl pairing_oppl.
Qed.

(** ** Sequences that solve the Lagrange equations

Section 4.1, below definition 4.1.1: each neighbouring pair is critical exactly where the sum of \f$\ell\f$
along the sequence is stationary, its product held. *)
Theorem claim_4_1_solution_sequence_group algebra l g N : algebra 0 -> (forall k, differentiable l (g k)) ->
  (forall k, k < N -> agree algebra (left_differential l (g k)) (right_differential l (g k.+1)))%N
  <-> (forall v, (forall k, algebra (v k)) -> v 0%N = 0 -> v N.+1 = 0 ->
       rate (\sum_(k < N.+1) l (moved_arrow g v k)) = 0).
Proof.
move=> zero_in dl; split=> [critical v in_v start stop|stationary k k_N x in_x].
  rewrite claim_4_1_solution_sequence_sum // big1 // => k _.
  by rewrite pairing_addl pairing_oppl critical // subrr.
pose v j := if j == k.+1 then x else 0.
have in_v j : algebra (v j) by rewrite /v; case: eqP.
have stop : v N.+1 = 0 by rewrite /v eqSS gtn_eqF.
have := stationary v in_v erefl stop; rewrite claim_4_1_solution_sequence_sum // (bigD1 (Ordinal k_N)) //=.
rewrite big1 ?addr0 => [|j ne_k]; last first.
  by rewrite /v eqSS -val_eqE /= in ne_k *; rewrite (negbTE ne_k) pairing_0r.
by rewrite /v eqxx pairing_addl pairing_oppl => /eqP; rewrite subr_eq0 => /eqP.
Qed.

(** \f$\Lambda\f$ takes the covector at the start of an arrow to the covector at its end; on a group it takes
\f$R_h^*\ell'(h)\f$ to \f$L_h^*\ell'(h)\f$. It is written as a relation, since \f$\ell\f$ need not be regular.
*)
Definition generated_map l (mu nu : 'M[R]_n) :=
  exists h, [/\ h \in unitmx, mu = right_differential l h & nu = left_differential l h].

(** ** The Legendre maps take the one dynamics to the other

Section 4.1, below definition 4.1.2: for a critical pair \f$(g, h)\f$, \f$F(g)\f$ goes to \f$F(h)\f$ under
\f$\Lambda\f$, with the Legendre map at the sources of arrows for \f$F\f$ as well as with that at their
targets. *)
Theorem claim_4_1_legendre_intertwines_group l (g h : 'M[R]_n) : g \in unitmx -> h \in unitmx ->
  left_differential l g = right_differential l h ->
  generated_map l (right_differential l g) (right_differential l h)
  /\ generated_map l (left_differential l g) (left_differential l h).
Proof. by move=> ug uh critical; split; [exists g|exists h]; rewrite ?critical. Qed.

Lemma rate_of_opp (x : 'M[dual R]_n) : rate_of (- x) = - rate_of x.
Proof. by apply/matrixP => i j; rewrite !mxE. Qed.

(** ** The map generated by a function is a Poisson map

Definition 4.1.2, on a group. Let \f$p\f$ stand for \f$d\ell\f$, and let \f$a'\f$ and \f$b'\f$ be the
derivatives at \f$R_f^*d\ell(f)\f$ of functions that have the derivatives \f$a\f$ and \f$b\f$ at the image
\f$L_f^*d\ell(f)\f$ and are taken after the map: as \f$f\f$ varies along \f$\theta f\f$,
\f$\langle\delta(R_f^*p), a'\rangle = \langle\delta(L_f^*p), a\rangle\f$. Then the two brackets agree,
\f$\langle R_f^*p, [a', b']\rangle = \langle L_f^*p, [a, b]\rangle\f$. What is used of \f$d\ell\f$ is that its
derivative is symmetric. Nondegeneracy is not needed, except for there to be a map. *)
Theorem def_4_1_2_group algebra (p : 'M[dual R]_n -> 'M[dual R]_n) (f p0 a b a' b' : 'M[R]_n) :
  f \in unitmx -> covector_at p f p0 -> closed_at p f ->
  (forall x y, algebra x -> algebra y -> algebra (x - y)) -> Ad_keeps algebra f ->
  algebra a -> algebra b -> algebra a' -> algebra b' ->
  let start theta := let x := varied f (theta *m f) in rate_of (R_star x (p x)) in
  let stop theta := let x := varied f (theta *m f) in rate_of (L_star x (p x)) in
  (forall theta, algebra theta -> pairing (start theta) a' = pairing (stop theta) a) ->
  (forall theta, algebra theta -> pairing (start theta) b' = pairing (stop theta) b) ->
  pairing (R_star f p0) (bracket a' b') = pairing (L_star f p0) (bracket a b).
Proof.
move=> uf at_f closed differences keeps in_a in_b in_a' in_b' /= of_a of_b.
apply: oppr_inj; rewrite -!pairing_oppl.
apply: (prop_3_2_1_of_matrices uf at_f closed differences keeps) => // theta in_theta.
  by rewrite /varied_momentum_before /varied_momentum_after !rate_of_opp !pairing_oppl of_a.
by rewrite /varied_momentum_before /varied_momentum_after !rate_of_opp !pairing_oppl of_b.
Qed.

(** ** The generated map moves along coadjoint orbits

Section 4.3: on a group \f$\Lambda\f$ takes \f$R_h^*\ell'(h)\f$ to \f$\mathrm{Ad}_h^*\f$ of it. *)
Theorem generated_map_coadjoint l (mu nu : 'M[R]_n) : generated_map l mu nu ->
  exists2 h, h \in unitmx & nu = Ad_star h mu.
Proof. by case=> h [u -> ->]; exists h => //; rewrite Ad_star_right. Qed.

End Sequences.

(** ** Invariant generating functions

Section 4.2: for a generating function \f$S(g, g_0)\f$ that is invariant under multiplication of both
configurations on the left there is one and only one \f$S_L\f$ with \f$S_L(g^{-1}g_0) = S(g, g_0)\f$, namely
\f$S_L(f) = S(1, f)\f$. Its values may be of any type. *)

Theorem claim_4_2_invariant_generating_function_of_matrices (R : comUnitRingType) (n : nat) T
  (S : 'M[R]_n -> 'M[R]_n -> T) :
  (forall g g0 k, g \in unitmx -> g0 \in unitmx -> k \in unitmx -> S (k *m g) (k *m g0) = S g g0) ->
  let S_L f := S 1%:M f in
  (forall g g0, g \in unitmx -> g0 \in unitmx -> S_L (invmx g *m g0) = S g g0)
  /\ (forall S', (forall g g0, g \in unitmx -> g0 \in unitmx -> S' (invmx g *m g0) = S g g0) ->
      forall f, f \in unitmx -> S' f = S_L f).
Proof.
move=> invariant /=; split=> [g g0 u u0|S' is_S f u].
  by rewrite -[in RHS](invariant _ _ (invmx g)) ?unitmx_inv // mulVmx.
by rewrite -[f in LHS]mul1mx -[1%:M in LHS]inverse_one is_S ?unitmx1.
Qed.

Section LeftInvariant.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g p mu Pi : 'M[R]_n) (l : 'M[dual R]_n -> dual R).

(** (4.2): \f$\Pi_0 = -L_g^*\,dS_L(g)\f$. C++: `actio::initial_momentum_left`, `groupoid/hamilton_jacobi.hpp`.
*)
Definition initial_momentum_left l g := - left_differential l g.

(** (4.3): \f$\Pi = \mathrm{Ad}^*_{g^{-1}}\Pi_0\f$. C++: `actio::final_momentum_left`,
`groupoid/hamilton_jacobi.hpp`. *)
Definition final_momentum_left g Pi := Ad_star (invmx g) Pi.

(** ** The final momentum of a generating function

The momentum that (4.3) makes of (4.2) is \f$\Pi = -R_g^*\,dS_L(g)\f$, the one in the Hamilton-Jacobi equation
(4.1). *)
Theorem eq_4_3_by_right_translation l g : g \in unitmx ->
  final_momentum_left g (initial_momentum_left l g) = - right_differential l g.
Proof. by move=> u; rewrite /final_momentum_left /initial_momentum_left Ad_star_opp Ad_star_left. Qed.

(** Let \f$\mathbb L(g_0, g_1) = \ell(f)\f$ with \f$f = g_1^{-1}g_0\f$ be an action. Then
\f$p_0 = -\partial\mathbb L/\partial g_0\f$ and \f$p_1 = \partial\mathbb L/\partial g_1\f$ are the momenta at
the start and at the end of the step. C++: `actio::lift_left`, `reduction/relative_motion.hpp`. *)
Definition lift_left l (x0 x1 : 'M[dual R]_n) := l (relative_motion_left x0 x1).
Definition start_momentum (L : 'M[dual R]_n -> 'M[dual R]_n -> dual R) g0 g1 := - first_differential L g0 g1.
Definition end_momentum (L : 'M[dual R]_n -> 'M[dual R]_n -> dual R) g0 g1 := second_differential L g0 g1.

Lemma first_differential_left l g0 g1 : g1 \in unitmx -> differentiable l (relative_motion_left g0 g1) ->
  first_differential (lift_left l) g0 g1 = L_star (invmx g1) (differential l (relative_motion_left g0 g1)).
Proof.
move=> u dl; apply: differential_is => v.
by rewrite /lift_left /relative_motion_left inverse_still // varied_mul mul0mx addr0 dl -L_star_dual.
Qed.

Lemma second_differential_left l g0 g1 : g1 \in unitmx -> differentiable l (relative_motion_left g0 g1) ->
  let f := relative_motion_left g0 g1 in
  second_differential (lift_left l) g0 g1 = - L_star (invmx g1) (R_star f (differential l f)).
Proof.
move=> u dl /=; apply: differential_is => v.
rewrite /lift_left /relative_motion_left varied_inverse // varied_mul mulmx0 add0r mulNmx dl.
rewrite pairing_oppr pairing_oppl L_star_dual R_star_dual /left_translation /right_translation.
by rewrite /relative_motion_left !mulmxA.
Qed.

(** ** The Legendre map of a left-invariant system

Section 4.2: \f$\Pi_{k-1} = -L^*_{f_{k,k-1}}d\ell(f_{k,k-1})\f$ is the body momentum at \f$g_{k-1}\f$ with
which the step to \f$g_k\f$ begins. *)

Theorem claim_4_2_left_legendre_map_of_matrices l g0 g1 : g1 \in unitmx ->
  differentiable l (relative_motion_left g0 g1) ->
  body_momentum g0 (start_momentum (lift_left l) g0 g1) = momentum_before_left l (relative_motion_left g0 g1).
Proof.
move=> u1 dl; rewrite /start_momentum first_differential_left // /body_momentum /momentum_before_left.
by rewrite /left_differential /L_star mulmxN mulmxA -trmx_mul.
Qed.

(** ** The two lines of a step on the dual of the algebra

(4.4) with its minus signs: \f$\Pi_k = -L_f^*\,d\ell(f)\f$ and \f$\Pi_{k+1} = -R_f^*\,d\ell(f)\f$ with
\f$f = f_{k+1,k} = g_{k+1}^{-1}g_k\f$ are the body momenta at the start and at the end of the step. No
equation of motion is needed. *)

Theorem eq_4_4_of_matrices l gk gk1 : gk1 \in unitmx -> let f := relative_motion_left gk gk1 in
  differentiable l f ->
  body_momentum gk (start_momentum (lift_left l) gk gk1) = - left_differential l f
  /\ body_momentum gk1 (end_momentum (lift_left l) gk gk1) = - right_differential l f.
Proof.
move=> u1 f dl; split; first exact: claim_4_2_left_legendre_map_of_matrices.
rewrite /end_momentum second_differential_left // /body_momentum /L_star mulmxN mulmxA.
by rewrite transpose_inverse // mul1mx.
Qed.

(** ** From one step to the next

(4.4): along a motion of (3.11) the momentum at the end of one step is the momentum at the start of the next.
*)
Theorem eq_4_4_next_step l f10 f21 : euler_poincare_left l f10 f21 = 0 ->
  - right_differential l f10 = momentum_before_left l f21.
Proof. by move/eqP; rewrite subr_eq0 => /eqP; rewrite /momentum_before_left => ->. Qed.

(** ** A discrete Lagrangian in the role of the generating function

Section 4.2: the two lines of (4.4), with their minus signs, are (4.2) and (4.3) with \f$S_L = \ell\f$. *)

Theorem claim_4_2_hamilton_jacobi_identification_of_matrices l Pi Pi' :
  (exists f, [/\ f \in unitmx, Pi = - left_differential l f & Pi' = - right_differential l f])
  <-> (exists g, [/\ g \in unitmx, Pi = initial_momentum_left l g & Pi' = final_momentum_left g Pi]).
Proof.
split=> [[f [u -> ->]]|[g [u -> ->]]]; first by exists f; rewrite -eq_4_3_by_right_translation.
by exists g; rewrite eq_4_3_by_right_translation.
Qed.

(** ** The system and the discrete Euler-Poincare equation

Section 4.2: the equation (3.11) joins two of the systems (4.4), the second line of one step and the first
line of the next, with \f$\Pi_k\f$ eliminated. *)

Theorem claim_4_2_system_and_dep_of_matrices l f10 f21 :
  euler_poincare_left l f10 f21 = 0
  <-> exists Pi, Pi = right_differential l f10 /\ Pi = left_differential l f21.
Proof.
split=> [/eqP|[Pi [-> same]]]; last by rewrite /euler_poincare_left -same subrr.
by rewrite subr_eq0 => /eqP same; exists (right_differential l f10).
Qed.

(** ** The discrete Euler-Lagrange equations in the body frame

Section 4.2: the residual of (3.2) at \f$g_1\f$, translated to the identity on the left, is that of (3.11), on
a motion or not. *)
Theorem claim_4_2_system_and_dep_configurations l g0 g1 g2 :
  g1 \in unitmx -> g2 \in unitmx ->
  let f10 := relative_motion_left g0 g1 in
  let f21 := relative_motion_left g1 g2 in
  differentiable l f10 -> differentiable l f21 ->
  Ad_star g1 (discrete_euler_lagrange (lift_left l) g0 g1 g2) = euler_poincare_left l f10 f21.
Proof.
move=> u1 u2 f10 f21 d10 d21; rewrite /discrete_euler_lagrange /D1 /D2 -/(R_star _ _).
have [_ last] := eq_4_4_of_matrices u1 d10; have [first _] := eq_4_4_of_matrices u2 d21.
have linear p q : Ad_star g1 (p + q) = Ad_star g1 p + Ad_star g1 q by rewrite /Ad_star mulmxDr mulmxDl.
rewrite linear !Ad_star_right // /euler_poincare_left addrC; congr (_ + _); last exact: last.
by apply: oppr_inj; rewrite -first /body_momentum /start_momentum /L_star mulmxN.
Qed.

(** ** The momentum update that follows from the two lines

Section 4.2: \f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}^{-1}}\Pi_k\f$, for the two lines of (4.4) as they are
printed and with minus signs as well. *)

Theorem claim_4_2_dlp_consequence_of_matrices l f Pi Pi' : f \in unitmx ->
  Pi = left_differential l f /\ Pi' = right_differential l f
  \/ Pi = - left_differential l f /\ Pi' = - right_differential l f ->
  Pi' = lie_poisson_update_left f Pi.
Proof.
by move=> u [] [-> ->]; rewrite /lie_poisson_update_left ?Ad_star_opp Ad_star_left.
Qed.

(** \f$\Sigma_\ell\f$ takes \f$f_{k,k-1}\f$ to \f$f_{k+1,k}\f$ where the two satisfy (3.11).
\f$\Lambda_\ell\f$ takes \f$\Pi_{k-1}\f$ to \f$\Pi_k = \mathrm{Ad}^*_{f^{-1}}\Pi_{k-1}\f$, where \f$f\f$
solves \f$F\ell(f) = \Pi_{k-1}\f$. Both are written as relations. *)
Definition sigma_left l f10 f21 := euler_poincare_left l f10 f21 = 0.
Definition legendre_left (c : R) l f := c *: left_differential l f.
Definition lambda_left (c : R) l Pi Pi' :=
  exists f, [/\ f \in unitmx, Pi = legendre_left c l f & Pi' = lie_poisson_update_left f Pi].

Lemma Ad_star_scale c g p : Ad_star g (c *: p) = c *: Ad_star g p.
Proof. by rewrite /Ad_star -scalemxAr -scalemxAl. Qed.

(** ** The square of group and dual-algebra dynamics

(4.5): with \f$F\ell = c\,L^*d\ell\f$ the square commutes,
\f$F\ell\circ\Sigma_\ell = \Lambda_\ell\circ F\ell\f$, for every number \f$c\f$; \f$-1\f$ gives the physical
momentum, and 1 is printed. *)
Theorem eq_4_5_of_matrices c l f10 f21 : f10 \in unitmx -> sigma_left l f10 f21 ->
  lambda_left c l (legendre_left c l f10) (legendre_left c l f21).
Proof.
move=> u /eqP; rewrite subr_eq0 => /eqP motion; exists f10; split=> //.
rewrite /legendre_left motion /lie_poisson_update_left.
by rewrite Ad_star_scale Ad_star_left.
Qed.

End LeftInvariant.

Definition quarter_turn := integers [:: [:: 0; -1]; [:: 1; 0]].

Lemma quarter_turn_orthogonal : orthogonal (matrix_of 2 quarter_turn).
Proof. by decide_by_computation. Qed.
Lemma quarter_turn_skew : skew (matrix_of 2 quarter_turn).
Proof. by rewrite /skew; decide_by_computation. Qed.
Lemma one_orthogonal (R : comUnitRingType) (n : nat) : orthogonal (1%:M : 'M[R]_n).
Proof. by rewrite /orthogonal trmx1 mulmx1. Qed.
Lemma relative_to_one (R : comUnitRingType) (n : nat) (f : 'M[R]_n) : relative_motion_left f 1%:M = f.
Proof. by rewrite /relative_motion_left inverse_one mul1mx. Qed.

(** Momenta that are said to be equal and that are, for \f$\ell(f) = \mathrm{Tr}(f)\f$ and \f$g_{k+1} = 1\f$,
\f$-f^T\f$ and \f$f^T\f$: on the skew matrices, which are not zero, a quarter turn of the plane tells them
apart. *)
Lemma opposite_momenta_differ
    (actual printed : forall (R : comUnitRingType) (n : nat),
       ('M[dual R]_n -> dual R) -> 'M[R]_n -> 'M[R]_n -> 'M[R]_n) :
  (forall (R : comUnitRingType) (n : nat) (f : 'M[R]_n), let trace := linear_function (1%:M : 'M[R]_n) in
     actual R n trace f 1%:M = - printed R n trace f 1%:M /\ printed R n trace f 1%:M = f^T) ->
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (g0 g1 : 'M[R]_n),
     orthogonal g0 -> orthogonal g1 -> differentiable l (relative_motion_left g0 g1) ->
     agree (@skew R n) (actual R n l g0 g1) (printed R n l g0 g1)).
Proof.
move=> opposite claim.
have for_trace (R : comUnitRingType) (n : nat) (f x : 'M[R]_n) : orthogonal f -> skew x ->
    pairing (- f^T) x = pairing f^T x.
  move=> o sk; have := claim R n _ f 1%:M o (one_orthogonal _ _) (linear_differentiable 1%:M _) x sk.
  by have [-> ->] := opposite R n f.
by have := for_trace _ _ _ _ quarter_turn_orthogonal quarter_turn_skew; decide_by_computation.
Qed.

(** ** The Legendre map of a left-invariant system as printed

Printed is \f$\Pi_{k-1} = L^*_{f_{k,k-1}}d\ell(f_{k,k-1})\f$, without the minus of (4.2), of which the thesis
says that \f$\ell\f$ plays the role of its generating function. For an action it gives minus the body momentum
with which the step begins. The rotations of the plane are enough: with \f$\ell(f) = \mathrm{Tr}(f)\f$,
\f$g_{k-1}\f$ a quarter turn and \f$g_k = 1\f$ the two sides have opposite values on the skew matrices, which
are not zero. *)
Theorem claim_4_2_left_legendre_map_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (g0 g1 : 'M[R]_n),
     orthogonal g0 -> orthogonal g1 -> differentiable l (relative_motion_left g0 g1) ->
     agree (@skew R n) (body_momentum g0 (start_momentum (lift_left l) g0 g1))
       (left_differential l (relative_motion_left g0 g1))).
Proof.
apply: (opposite_momenta_differ
  (actual := fun R n l g0 g1 => body_momentum g0 (start_momentum (lift_left l) g0 g1))
  (printed := fun R n l g0 g1 => left_differential l (relative_motion_left g0 g1))) => R n f /=.
split; first exact: claim_4_2_left_legendre_map_of_matrices (unitmx1 _ _) (linear_differentiable _ _).
by rewrite relative_to_one /left_differential linear_differential /L_star mulmx1.
Qed.

(** ** The first line of (4.4) as printed

\f$\Pi_k = L_f^*\,d\ell(f)\f$ fails in the same way. *)
Theorem eq_4_4_printed_fails_first :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (gk gk1 : 'M[R]_n),
     orthogonal gk -> orthogonal gk1 -> differentiable l (relative_motion_left gk gk1) ->
     agree (@skew R n) (body_momentum gk (start_momentum (lift_left l) gk gk1))
       (left_differential l (relative_motion_left gk gk1))).
Proof. exact: claim_4_2_left_legendre_map_printed_fails. Qed.

(** ** The second line of (4.4) as printed

\f$\Pi_{k+1} = R_f^*\,d\ell(f)\f$ gives minus the body momentum
\f$L_{g_{k+1}}^*\,\partial\mathbb L/\partial g_{k+1}\f$ with which the step ends. *)
Theorem eq_4_4_printed_fails_second :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (gk gk1 : 'M[R]_n),
     orthogonal gk -> orthogonal gk1 -> differentiable l (relative_motion_left gk gk1) ->
     agree (@skew R n) (body_momentum gk1 (end_momentum (lift_left l) gk gk1))
       (right_differential l (relative_motion_left gk gk1))).
Proof.
apply: (opposite_momenta_differ
  (actual := fun R n l g0 g1 => body_momentum g1 (end_momentum (lift_left l) g0 g1))
  (printed := fun R n l g0 g1 => right_differential l (relative_motion_left g0 g1))) => R n f /=.
split.
  have dl := linear_differentiable 1%:M (relative_motion_left f 1%:M).
  by have [_ ->] := eq_4_4_of_matrices (unitmx1 _ _) dl.
by rewrite relative_to_one /right_differential linear_differential /R_star mul1mx.
Qed.

(** ** The printed system is not that of Hamilton and Jacobi

Section 4.2: that the printed system (4.4) is the Lie-Poisson Hamilton-Jacobi system with the reduced discrete
Lagrangian \f$\ell\f$ as its generating function fails not only in the signs of momenta: the two systems do
not relate the same momenta. On 1 by 1 matrices with \f$\ell(f) = f^2\f$ the printed one takes the momentum 2
to itself, by \f$f = 1\f$; (4.2) asks for \f$-2g^2 = 2\f$, which no rational \f$g\f$ satisfies. *)
Theorem claim_4_2_hamilton_jacobi_identification_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (Pi Pi' : 'M[R]_n),
     (forall f, f \in unitmx -> differentiable l f) ->
     (exists f, [/\ f \in unitmx, Pi = left_differential l f & Pi' = right_differential l f])
     <-> (exists g, [/\ g \in unitmx, Pi = initial_momentum_left l g & Pi' = final_momentum_left g Pi])).
Proof.
move=> printed; pose l (x : 'M[dual rat]_1) := x 0 0 * x 0 0.
have rate_is (f v : 'M[rat]_1) : rate (l (varied f v)) = pairing (f 0 0 *+ 2)%:M v.
  rewrite /l !mxE /= [v 0 0 * _]mulrC -mulr2n pairing_sym /pairing mul_mx_scalar mxtraceZ mxtrace_tr.
  by rewrite /mxtrace big_ord1 mulrnAl.
have slope f : differential l f = (f 0 0 *+ 2)%:M by apply: differential_is.
have [from_printed _] := printed _ _ l 2%:R%:M 2%:R%:M (fun f _ => differentiable_is (rate_is f)).
case: from_printed => [|g [_ Pi_g _]].
  exists 1%:M; rewrite unitmx1 /left_differential /right_differential !slope /L_star /R_star trmx1.
  by rewrite mul1mx mulmx1 mxE.
move/matrixP/(_ 0 0): Pi_g; rewrite /initial_momentum_left /left_differential slope /L_star mul_mx_scalar.
rewrite !mxE eqxx mulr1n => two_is; have : (2%:R : rat) <= 0.
  by rewrite two_is Num.Theory.oppr_le0 mulrnAl Num.Theory.mulrn_wge0 // -expr2 Num.Theory.sqr_ge0.
by [].
Qed.

(** ** The update that follows from the two lines, as printed

Below (4.4) the update is printed as "a direct consequence", \f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}}\Pi_k\f$.
The inverse is missing, as in (3.18): with \f$\ell(f) = \mathrm{Tr}(W^Tf)\f$, \f$W = \mathrm{diag}(1, -1)\f$,
and \f$f\f$ a triangular matrix the two lines do not satisfy it. *)

Theorem claim_4_2_dlp_consequence_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (f Pi Pi' : 'M[R]_n),
     f \in unitmx -> differentiable l f -> Pi = left_differential l f -> Pi' = right_differential l f ->
     Pi' = Ad_star f Pi).
Proof.
move=> printed.
have for_linear (R : comUnitRingType) (n : nat) (W f : 'M[R]_n) : f \in unitmx ->
    R_star f W = Ad_star f (L_star f W).
  move=> u; have := printed R n _ f _ _ u (@linear_differentiable R n W f) erefl erefl.
  by rewrite /left_differential /right_differential linear_differential.
pose W := integers [:: [:: 1; 0]; [:: 0; -1]]; pose f := integers [:: [:: 1; 0]; [:: 1; 1]].
have unit_f : matrix_of 2 f \in unitmx by decide_by_computation.
by have := for_linear _ _ (matrix_of 2 W) _ unit_f; decide_by_computation.
Qed.

Section Iterated.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g v Pi : nat -> 'M[R]_n) (l : 'M[dual R]_n -> dual R).

(** \f$f_{N-1}\cdots f_1f_0\f$. *)
Fixpoint composed_left (S : comUnitRingType) (f : nat -> 'M[S]_n) N : 'M[S]_n :=
  if N is k.+1 then f k *m composed_left f k else 1%:M.

Lemma composed_left_unit f N : (forall k, f k \in unitmx) -> composed_left f N \in unitmx.
Proof. by move=> u; elim: N => [|N IH] /=; rewrite ?unitmx1 // product_unit. Qed.

(** ** The algorithm iterated: momenta

Section 4.2: \f$N\f$ steps of the discrete Lie-Poisson algorithm are (4.3),
\f$\Pi_N = \mathrm{Ad}^*_{g^{-1}}\Pi_0\f$, with the composed relative motion
\f$g = f_{N,N-1}\cdots f_{1,0}\f$, the later factors first. *)
Theorem claim_4_2_iterated_lie_poisson_momentum f Pi N : (forall k, f k \in unitmx) ->
  (forall k, Pi k.+1 = lie_poisson_update_left (f k) (Pi k)) ->
  Pi N = final_momentum_left (composed_left f N) (Pi 0%N).
Proof.
move=> u update; elim: N => [|N IH] /=; first by rewrite /final_momentum_left inverse_one Ad_star_one.
rewrite update IH /lie_poisson_update_left /final_momentum_left.
by rewrite Ad_star_product ?unitmx_inv ?composed_left_unit // inverse_product ?composed_left_unit.
Qed.

(** ** The algorithm iterated: configurations

Section 4.2: with configurations reconstructed by (3.15) the composed motion is \f$g = g_N^{-1}g_0\f$. For a
motion that starts at the identity it is the inverse of the position \f$g_N\f$. *)
Theorem claim_4_2_iterated_lie_poisson_configurations f g N :
  (forall k, f k \in unitmx) -> (forall k, g k \in unitmx) ->
  (forall k, g k.+1 = reconstruct_left (g k) (f k)) ->
  composed_left f N = relative_motion_left (g 0%N) (g N).
Proof.
move=> uf ug step; elim: N => [|N IH] /=; first by rewrite /relative_motion_left mulVmx.
rewrite IH step /relative_motion_left /reconstruct_left inverse_product ?unitmx_inv // invmxK.
by rewrite mulmxA.
Qed.

(** ** The algorithm iterated: the generating function

Section 4.2: the generating function of \f$N\f$ steps is the sum of \f$\ell\f$ along the motion, as a function
of the composed motion. However the relative motions vary along a solution of (3.11), the sum changes by
\f$-\langle\Pi_0, g^{-1}\delta g\rangle\f$, which depends on the variation of the product alone and is (4.2)
for it. *)
Theorem claim_4_2_iterated_lie_poisson_generating_function l f v N : (forall k, f k \in unitmx) ->
  (forall k, differentiable l (f k)) -> (forall k, euler_poincare_left l (f k) (f k.+1) = 0) ->
  let g := composed_left f N in
  let delta_g := rate_of (composed_left (fun k => varied (f k) (v k)) N) in
  rate (\sum_(k < N) l (varied (f k) (v k)))
  = - pairing (momentum_before_left l (f 0%N)) (invmx g *m delta_g).
Proof.
move=> u dl motion; pose c k := composed_left (fun k => varied (f k) (v k)) k.
have value_c k : value_of (c k) = composed_left f k.
  elim: k => [|k IH]; first by rewrite /c /= -[X in value_of X]varied_one value_varied.
  by rewrite /c /= [composed_left _ k]variedE varied_mul value_varied -/(c k) IH.
(* The first momentum is carried along by the update, and each step adds its own variation. *)
have carried k : momentum_before_left l (f k)
    = final_momentum_left (composed_left f k) (momentum_before_left l (f 0%N)).
  apply: (@claim_4_2_iterated_lie_poisson_momentum f (fun k => momentum_before_left l (f k))) => // j.
  by apply/(agree_all _ _)/(eq_3_18 _ _ _ (u j)) => x _; rewrite motion.
elim: N => [|N IH] /=.
  by rewrite big_ord0 -[X in rate_of X]varied_one rate_varied mulmx0 pairing_0r oppr0.
rewrite big_ord_recr raddfD /= IH dl -/(c N) [c N]variedE varied_mul rate_varied value_c.
have uc := composed_left_unit N u.
rewrite rate_varied inverse_product // mulmxDr pairing_addr opprD; congr (_ + _).
  by rewrite mulmxA -[_ *m invmx (f N) *m f N]mulmxA mulVmx // mulmx1.
have -> : invmx (composed_left f N) *m invmx (f N) *m (v N *m composed_left f N)
    = Ad (invmx (composed_left f N)) (invmx (f N) *m v N) by rewrite /Ad invmxK !mulmxA.
rewrite -Ad_star_dual -[Ad_star _ _]carried /momentum_before_left pairing_oppl opprK L_star_dual.
by rewrite /left_translation mulmxA mulmxV // mul1mx.
Qed.

End Iterated.

Section Square.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g p mu Pi : 'M[R]_n) (l : 'M[dual R]_n -> dual R).

(** C++: `actio::lift_right`, `reduction/relative_motion.hpp`. *)
Definition lift_right l (x0 x1 : 'M[dual R]_n) := l (relative_motion_right x0 x1).

(** The chain rule: since \f$f = g_kg_{k+1}^{-1}\f$,
\f$\partial\mathbb L/\partial g_k = R^*_{g_{k+1}^{-1}}\,\partial\ell/\partial f\f$. *)
Lemma first_differential_right l gk gk1 : gk1 \in unitmx -> differentiable l (relative_motion_right gk gk1) ->
  first_differential (lift_right l) gk gk1
  = R_star (invmx gk1) (differential l (relative_motion_right gk gk1)).
Proof.
move=> u dl; apply: differential_is => v.
rewrite /lift_right /relative_motion_right inverse_still // varied_mul mulmx0 add0r dl.
by rewrite -/(right_translation _ _) -R_star_dual.
Qed.

(** ** The spatial momentum along the square

(4.8) with its inverse:
\f[ \mu = R_{g_k}^*p_k = R_{g_k}^*\frac{\partial(\ell\circ\pi_d)}{\partial g_k} =
R_{g_k}^*\Bigl(R_{g_{k+1}^{-1}}^*\frac{\partial\ell}{\partial f}\Bigr) = R_f^*\,\frac{\partial\ell}{\partial
f} = R_f^*\,\ell'(f). \f] *)

Theorem eq_4_8_of_matrices l gk gk1 : gk1 \in unitmx -> let f := relative_motion_right gk gk1 in
  differentiable l f ->
  R_star gk (first_differential (lift_right l) gk gk1) = R_star gk (R_star (invmx gk1) (differential l f))
  /\ R_star gk (R_star (invmx gk1) (differential l f)) = R_star f (differential l f).
Proof.
move=> u f dl; split; first by rewrite first_differential_right.
by rewrite /R_star -mulmxA -trmx_mul.
Qed.

(** The corners and sides of the square of section 4.3. Above: \f$F\mathbb L(g_k, g_{k+1}) = (g_k, p_k)\f$
with \f$p_k = \partial\mathbb L/\partial g_k\f$. Below: \f$F\ell(f) = R_f^*\ell'(f)\f$. Down:
\f$\pi_d(g_k, g_{k+1}) = g_kg_{k+1}^{-1}\f$ and \f$\pi(g, p) = R_g^*p\f$. *)
Definition legendre_of_pairs (c : R) l gk gk1 := (gk, c *: first_differential (lift_right l) gk gk1).
Definition quotient_of_covectors (gp : 'M[R]_n * 'M[R]_n) : 'M[R]_n := R_star gp.1 gp.2.
Definition legendre_of_group (c : R) l f : 'M[R]_n := c *: right_differential l f.

(** ** The Legendre maps commute with the quotient maps

In theorem 4.3.1: from a pair the two ways around the square (4.6) lead to one momentum, with any factor
\f$c\f$ in both Legendre maps; 1 is printed, and \f$-1\f$ gives physical momenta. That \f$\mathbb L\f$ is
regular is not needed. *)
Theorem thm_4_3_1_of_matrices c l gk gk1 : gk1 \in unitmx ->
  differentiable l (relative_motion_right gk gk1) ->
  quotient_of_covectors (legendre_of_pairs c l gk gk1) = legendre_of_group c l (relative_motion_right gk gk1).
Proof.
move=> u dl; have [first last] := eq_4_8_of_matrices u dl.
by rewrite /quotient_of_covectors /= {1}/R_star -scalemxAl -/(R_star _ _) first last.
Qed.

(** ** The square in coordinates

(4.7): \f$p_k = \partial\mathbb L/\partial g_k\f$ and \f$\mu = R_{g_k}^*p_k = R_f^*\ell'(f)\f$, over \f$f\f$
with \f$fg_{k+1} = g_k\f$. *)
Theorem eq_4_7_of_matrices l gk gk1 : gk1 \in unitmx -> let f := relative_motion_right gk gk1 in
  differentiable l f -> f *m gk1 = gk /\ D1 (lift_right l) gk gk1 = right_differential l f.
Proof.
move=> u f dl; split; first by rewrite /f /relative_motion_right -mulmxA mulVmx // mulmx1.
by rewrite /D1; have [-> ->] := eq_4_8_of_matrices u dl.
Qed.

Lemma second_differential_right l gk gk1 : gk1 \in unitmx -> let f := relative_motion_right gk gk1 in
  differentiable l f ->
  second_differential (lift_right l) gk gk1 = - R_star (invmx gk1) (L_star f (differential l f)).
Proof.
move=> u f dl; apply: differential_is => v.
rewrite /lift_right /relative_motion_right varied_inverse // varied_mul mul0mx addr0 mulmxN dl.
rewrite pairing_oppr pairing_oppl R_star_dual L_star_dual /left_translation /right_translation.
by rewrite /f /relative_motion_right !mulmxA.
Qed.

(** ** The square for both Legendre maps

(4.6): before the step \f$D_1\mathbb L\f$ above and \f$R_f^*\ell'(f)\f$ below, after the step
\f$D_2\mathbb L\f$ above and \f$-L_f^*\ell'(f)\f$ below. *)
Theorem eq_4_6_of_matrices l gk gk1 : gk1 \in unitmx -> let f := relative_motion_right gk gk1 in
  differentiable l f ->
  D1 (lift_right l) gk gk1 = right_differential l f /\ D2 (lift_right l) gk gk1 = - left_differential l f.
Proof.
move=> u f dl; split; first by have [_ ->] := eq_4_7_of_matrices u dl.
rewrite /D2 /left_differential second_differential_right // /R_star mulNmx -mulmxA.
by rewrite inverse_transpose // mulmx1.
Qed.

(** ** The value of the Legendre map

Last line of the proof of theorem 4.3.1, as printed: \f$\mu = R_{g_k}^*p_k = F\ell(f) = R_f^*\ell'(f)\f$ with
\f$p_k = \partial\mathbb L/\partial g_k\f$. *)
Theorem claim_4_3_legendre_map_value_of_matrices l gk gk1 : gk1 \in unitmx -> let f :=
  relative_motion_right gk gk1 in
  differentiable l f -> R_star gk (first_differential (lift_right l) gk gk1) = right_differential l f.
Proof. by move=> u f dl; have [-> ->] := eq_4_8_of_matrices u dl. Qed.

(** The spatial momentum with which the step from \f$g_k\f$ begins, \f$\mathbb L\f$ being an action, is minus
this value: \f$-R_f^*\ell'(f)\f$. *)
Theorem physical_momentum_at_the_start l gk gk1 : gk1 \in unitmx -> let f := relative_motion_right gk gk1 in
  differentiable l f ->
  spatial_momentum gk (start_momentum (lift_right l) gk gk1) = momentum_before_right l f.
Proof.
move=> u f dl; rewrite /spatial_momentum /start_momentum /R_star mulNmx -/(R_star _ _).
by rewrite claim_4_3_legendre_map_value_of_matrices.
Qed.

(** ** The reconstructed algorithm is the image of the discrete motion

Corollary 4.3.1: let the momenta be carried by the discrete Lie-Poisson algorithm along a solution of (3.10),
and the configurations by (3.14). Then \f$(g_k, R^*_{g_k^{-1}}\mu_k)\f$ is the image of the pair
\f$(g_k, g_{k+1})\f$ under the Legendre map \f$-D_1\mathbb L\f$. *)

Theorem cor_4_3_1_image l (f g mu : nat -> 'M[R]_n) k : (forall j, f j \in unitmx) -> g 0%N \in unitmx ->
  (forall j, differentiable l (f j)) -> (forall j, euler_poincare_right l (f j) (f j.+1) = 0) ->
  (forall j, g j.+1 = reconstruct_right (g j) (f j)) ->
  mu 0%N = momentum_before_right l (f 0%N) ->
  (forall j, mu j.+1 = lie_poisson_update_right (f j) (mu j)) ->
  R_star (invmx (g k)) (mu k) = start_momentum (lift_right l) (g k) (g k.+1).
Proof.
move=> u u0 dl motion step first update.
have ug j : g j \in unitmx by elim: j => [//|j IH]; rewrite step /reconstruct_right product_unit ?unitmx_inv.
have mu_is j : mu j = momentum_before_right l (f j).
  elim: j => [//|j IH]; rewrite update IH; apply/esym.
  by apply/(agree_all _ _)/(eq_3_17 _ _ _ (u j)) => x _; rewrite motion.
have f_is : relative_motion_right (g k) (g k.+1) = f k.
  rewrite step /relative_motion_right /reconstruct_right inverse_product ?unitmx_inv // invmxK.
  by rewrite mulmxA mulmxV // mul1mx.
have dl_k : differentiable l (relative_motion_right (g k) (g k.+1)) by rewrite f_is.
have := physical_momentum_at_the_start (ug k.+1) dl_k; rewrite f_is -mu_is => <-.
by rewrite /spatial_momentum /R_star -mulmxA transpose_inverse // mulmx1.
Qed.

(** ** The lift of a discrete Lie-Poisson motion

Section 4.3: lifted to the covectors \f$R^*_{g_k^{-1}}\mu_k\f$ at configurations reconstructed by (3.14), a
motion of the discrete Lie-Poisson algorithm has one body momentum, that of the symmetry, at all steps. No
equation for the relative motions is needed. *)
Theorem claim_4_3_reconstruction_image_body_momentum (f g mu : nat -> 'M[R]_n) k :
  (forall j, f j \in unitmx) ->
  (forall j, g j \in unitmx) -> (forall j, g j.+1 = reconstruct_right (g j) (f j)) ->
  (forall j, mu j.+1 = lie_poisson_update_right (f j) (mu j)) ->
  body_momentum (g k) (R_star (invmx (g k)) (mu k)) = body_momentum (g 0%N) (R_star (invmx (g 0%N)) (mu 0%N)).
Proof.
move=> uf ug step update.
have body j : body_momentum (g j) (R_star (invmx (g j)) (mu j)) = Ad_star (g j) (mu j).
  by rewrite /body_momentum /L_star /R_star /Ad_star mulmxA.
rewrite !body; elim: k => [//|k <-]; rewrite step update /lie_poisson_update_right /reconstruct_right.
by rewrite Ad_star_product ?product_unit ?unitmx_inv // mulmxA mulmxV // mul1mx.
Qed.

End Square.

(** ** The tangent maps of the square commute

Section 4.3, above (4.10): \f$TF\ell\circ T\pi_d = T\pi\circ TF\mathbb L\f$. Theorem 4.3.1 holds over every
commutative ring; over that of dual numbers, with functions given on dual numbers of dual numbers, it says
that the two ways around the square lead to one momentum and to one rate of it. *)

Theorem claim_4_3_tangent_square_of_matrices (R : comUnitRingType) (n : nat) (c : dual R)
  (l : 'M[dual (dual R)]_n -> dual (dual R)) (gk gk1 v v1 : 'M[R]_n) : gk1 \in unitmx ->
  differentiable l (relative_motion_right (varied gk v) (varied gk1 v1)) ->
  rate_of (quotient_of_covectors (legendre_of_pairs c l (varied gk v) (varied gk1 v1)))
  = rate_of (legendre_of_group c l (relative_motion_right (varied gk v) (varied gk1 v1))).
Proof. by move=> u dl; rewrite thm_4_3_1_of_matrices // varied_unit. Qed.

(** ** The middle of (4.8) as printed

(4.8) is printed with \f$R_{g_k}^*\bigl(R_{g_{k+1}}^*\,\partial\ell/\partial f\bigr)\f$ in the middle, without
the inverse that the sentence after it has. With \f$g_k = 1\f$ and the covector 1 the two differ wherever
\f$g_{k+1}\f$ is not its own inverse. *)

Theorem eq_4_8_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (gk gk1 : 'M[R]_n),
     gk \in unitmx -> gk1 \in unitmx -> let f := relative_motion_right gk gk1 in differentiable l f ->
     R_star gk (R_star gk1 (differential l f)) = R_star f (differential l f)).
Proof.
move=> printed.
have for_trace (R : comUnitRingType) (n : nat) (g : 'M[R]_n) : g \in unitmx ->
    R_star g 1%:M = R_star (invmx g) 1%:M.
  move=> u; have := printed R n _ 1%:M g (unitmx1 _ _) u (@linear_differentiable R n 1%:M _).
  by rewrite /= linear_differential /relative_motion_right mul1mx {1}/R_star trmx1 mulmx1.
have unit_g : matrix_of 2 quarter_turn \in unitmx by decide_by_computation.
by have := for_trace _ _ _ unit_g; decide_by_computation.
Qed.

(** A free particle on a line: \f$q\f$ is the matrix \f$1 + qE_{12}\f$, of which products are sums of
positions, and \f$\ell(f) = f_{12}^2/2h\f$ is the exact action of a step \f$h\f$. Its Hamiltonian is
\f$p^2/2\f$, with the flow \f$q(T) = q + Tp\f$. The momentum is the value of the covector on \f$E_{12}\f$. *)
Definition free_action (h : rat) (x : 'M[dual rat]_2) : dual rat := Dual (h *+ 2)^-1 0 * (x 0 1 * x 0 1).

Lemma shear_product (S : comUnitRingType) (a b : S) : shear a *m shear b = shear (a + b).
Proof.
rewrite /shear mulmxDl mul1mx mulmxDr mulmx1 -scalemxAl -scalemxAr mul_delta_mx_0 // !scaler0 addr0.
by rewrite -addrA scalerDl [b *: _ + _]addrC.
Qed.

Lemma relative_shear (S : comUnitRingType) (a b : S) :
  relative_motion_right (shear a) (shear b) = shear (a - b).
Proof.
by rewrite /relative_motion_right (inverse_unique (shear_inverse b)) shear_product.
Qed.

Lemma free_differential h f : h != 0 -> differential (free_action h) f = (h^-1 * f 0 1) *: delta_mx 0 1.
Proof.
move=> nonzero; apply: differential_is => v; rewrite /free_action !mxE /= mul0r addr0.
rewrite pairing_scalel pairing_sym pairing_unit_matrix [v 0 1 * _]mulrC -mulr2n.
by rewrite -[h *+ 2]mulr_natr -(mulr_natr (f 0 1 * _)) invfM mulrACA mulVf // mulr1 mulrA.
Qed.

(** The Legendre map as printed, \f$D_1\mathbb L\f$, which on the quotient is \f$R_f^*\ell'(f)\f$. *)
Lemma printed_momentum h a b : h != 0 ->
  pairing (right_differential (free_action h) (relative_motion_right (shear a) (shear b))) (delta_mx 0 1)
  = h^-1 * (a - b).
Proof.
move=> nonzero; rewrite /right_differential free_differential // relative_shear pairing_unit_matrix.
have [_ e01 _ e11] := shear_entries (a - b).
rewrite e01 /R_star -scalemxAl mxE [X in _ * X]mxE sum_of_two [_^T 0 1]mxE [_^T 1 1]mxE e11.
by rewrite [delta_mx _ _ _ _]mxE [delta_mx _ _ _ _]mxE /= mul0r add0r !mulr1.
Qed.

(** ** The composed motion does not approximate the position

Section 4.2: the thesis has the solution \f$g\f$ of (4.2) approximate the configuration \f$g(t)\f$. Take
the motion \f$g(t) = 1 + tpE_{12}\f$ of a free particle, which begins at the identity, at the times
\f$kT/N\f$: the composed relative motion is \f$1 - TpE_{12}\f$ for every number \f$N\f$ of steps, the inverse
of the position \f$1 + TpE_{12}\f$. *)
Theorem claim_4_2_iterated_lie_poisson_printed_fails :
  ~ (forall T p eps : rat, 0 < eps -> exists2 N, (0 < N)%N &
       let g k := shear (k%:R * (T / N%:R) * p) in
       `|composed_left (fun k => relative_motion_left (g k) (g k.+1)) N 0 1 - shear (T * p) 0 1| < eps).
Proof.
move=> /(_ 1 1 1 isT) [N positive]; set g := fun k => shear (k%:R * (1 / N%:R) * 1).
have unit_g k : g k \in unitmx by have [] := mulmx1_unit (shear_inverse (k%:R * (1 / N%:R) * 1 : rat)).
have nonzero : N%:R != 0 :> rat by rewrite Num.Theory.pnatr_eq0 -lt0n.
rewrite /= (@claim_4_2_iterated_lie_poisson_configurations _ _ _ g) => [|k|k|k] //.
- rewrite /relative_motion_left (inverse_unique (shear_inverse _)) shear_product.
  have entry (a : rat) : shear a 0 1 = a by have [] := shear_entries a.
  by rewrite !entry !mul0r !mulr1 mul1r mulfV.
- exact: relative_motion_left_unit.
rewrite /reconstruct_left /relative_motion_left inverse_product ?unitmx_inv // invmxK.
by rewrite mulmxA mulmxV // mul1mx.
Qed.

(** ** The algorithm of a free particle, with the minus

Corollary 4.3.1 for a free particle on a line, with \f$p_k = -D_1\mathbb L(g_k, g_{k+1})\f$: \f$N\f$ steps
\f$h\f$ lead to the position \f$q + Nhp\f$, which is that of the flow after the time \f$Nh\f$. *)
Theorem cor_4_3_1_free_particle (h q p : rat) (x : nat -> rat) N : h != 0 -> x 0%N = q ->
  (forall k, pairing (momentum_before_right (free_action h)
                (relative_motion_right (shear (x k)) (shear (x k.+1)))) (delta_mx 0 1) = p) ->
  x N = q + N%:R * h * p.
Proof.
move=> nonzero start keeps; elim: N => [|N IH]; first by rewrite !mul0r addr0.
have := keeps N; rewrite /momentum_before_right pairing_oppl printed_momentum //.
move/(congr1 (fun y => h * y)).
rewrite -mulrN opprB mulrA mulfV // mul1r => /eqP; rewrite subr_eq => /eqP ->.
by rewrite IH -addn1 natrD !mulrDl mul1r addrCA [h * p + _]addrC.
Qed.

(** ** The algorithm of a free particle, as printed

Corollary 4.3.1 with \f$p_k = D_1\mathbb L(g_k, g_{k+1})\f$, as it is printed, does not approximate the flow:
with \f$q = 0\f$, \f$p = 1\f$ and \f$T = 1\f$ the algorithm runs backwards and ends at \f$-1\f$ however many
steps it takes, in place of 1. *)
Theorem cor_4_3_1_printed_fails :
  ~ (forall T q p eps : rat, 0 < T -> 0 < eps -> exists2 N, (0 < N)%N & forall x : nat -> rat, x 0%N = q ->
       (forall k, pairing (right_differential (free_action (T / N%:R))
                     (relative_motion_right (shear (x k)) (shear (x k.+1)))) (delta_mx 0 1) = p) ->
       `|x N - (q + T * p)| < eps).
Proof.
move=> /(_ 1 0 1 1 isT isT) [N positive approximates].
have nonzero : N%:R != 0 :> rat by rewrite Num.Theory.pnatr_eq0 -lt0n.
have := approximates (fun k => - (k%:R / N%:R)); rewrite mul0r oppr0 => /(_ erefl) at_end.
have steps k : pairing (right_differential (free_action (1 / N%:R))
    (relative_motion_right (shear (- (k%:R / N%:R))) (shear (- (k.+1%:R / N%:R))))) (delta_mx 0 1) = 1.
  rewrite printed_momentum ?mul1r ?invr_eq0 // invrK opprK addrC -mulrBl -natrB // subSnn mul1r.
  by rewrite mulfV.
by have := at_end steps; rewrite mulfV.
Qed.

Section Lifts.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (g p v w x y mu m_c : 'M[R]_n) (algebra : 'M[R]_n -> Prop).

(** Points of the cotangent bundle are pairs \f$(g, p)\f$ of a configuration and a covector, and the canonical
form is \f$\omega_{\mathrm{can}}((v, \pi), (w, \rho)) = \langle\rho, v\rangle - \langle\pi, w\rangle\f$. *)
Definition canonical_form v p w q : R := pairing (q : 'M[R]_n) v - pairing p w.

(** The covector with body momentum \f$m_c\f$ at \f$g + \varepsilon xg\f$. *)
Definition lift_with_body_momentum g m_c x : 'M[dual R]_n := L_star (invmx (varied g (x *m g))) (still m_c).

Lemma lift_with_body_momentumE g m_c x : g \in unitmx ->
  let p := L_star (invmx g) m_c in lift_with_body_momentum g m_c x = varied p (- (x^T *m p)).
Proof.
move=> u /=; rewrite /lift_with_body_momentum varied_inverse // /L_star varied_transpose varied_mul.
rewrite mulmx0 add0r.
have -> : invmx g *m (x *m g) *m invmx g = invmx g *m x by rewrite !mulmxA -mulmxA mulmxV // mulmx1.
by rewrite [trmx (- _)]raddfN mulNmx /= trmx_mul mulmxA.
Qed.

(** ** The lift that keeps the body momentum

(4.9), on the right. This lift of the orbit takes \f$\mu'\f$ to \f$(g', p')\f$ with
\f$p' = L^*_{g'^{-1}}m_c\f$ and \f$\mu' = R^*_{g'}p'\f$. As \f$g'\f$ moves from \f$g\f$ along \f$xg\f$,
\f$\mu'\f$ moves along the orbit, by \f$-\mathrm{ad}^*_x\mu\f$. *)
Theorem eq_4_9_tangent g m_c x : g \in unitmx ->
  let mu := spatial_momentum g (L_star (invmx g) m_c) in
  rate_of (R_star (varied g (x *m g)) (lift_with_body_momentum g m_c x)) = - ad_star x mu.
Proof.
move=> u /=; rewrite lift_with_body_momentumE // /R_star varied_transpose varied_mul rate_varied.
by rewrite /ad_star /spatial_momentum /R_star trmx_mul opprB mulNmx !mulmxA.
Qed.

(** ** The canonical form, pulled back to a coadjoint orbit

(4.9), on the right: with the lift \f$\sigma\f$ that keeps the body momentum,
\f$\omega_\mu = \sigma^*\omega_{\mathrm{can}}\f$. On two lifted vectors the canonical form has the value of
the form \f$\omega_+\f$ of the orbit. *)
Theorem eq_4_9_orbit_form algebra g m_c x y : g \in unitmx -> (forall z, algebra z -> algebra (- z)) ->
  algebra x -> algebra y ->
  let mu := spatial_momentum g (L_star (invmx g) m_c) in
  kirillov_kostant_plus algebra mu (- ad_star x mu) (- ad_star y mu)
    (canonical_form (x *m g) (rate_of (lift_with_body_momentum g m_c x))
                    (y *m g) (rate_of (lift_with_body_momentum g m_c y))).
Proof.
move=> u opposite in_x in_y /=; exists (- x), (- y).
have ad_star_opp z p : ad_star (- z) p = - ad_star z p.
  by rewrite /ad_star [trmx _]raddfN mulNmx mulmxN opprB opprK addrC.
split; [exact: opposite|exact: opposite| | |]; rewrite ?ad_star_opp //.
rewrite !lift_with_body_momentumE // !rate_varied /canonical_form !pairing_oppl opprK addrC.
set p := L_star (invmx g) m_c; rewrite -/(L_star x p) -/(L_star y p).
rewrite (L_star_dual x p) (L_star_dual y p) /left_translation.
rewrite [RHS]R_star_dual /right_translation /bracket !mulmxN !mulNmx !opprK mulmxBl !mulmxA.
by rewrite pairing_addr pairing_oppr.
Qed.

End Lifts.

(** ** The lift into a fibre, as printed

In (4.9) the lift is printed as \f$R^*_{g^{-1}}\f$ into the fibre over one \f$g\f$, by which
\f$\omega_{\mathrm{can}}\f$ is to be pulled back to the form of the orbit. Within a fibre the canonical form
is zero, and that of the orbit is not. *)
Theorem eq_4_9_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (g mu w1 w2 : 'M[R]_n) (c : R), g \in unitmx ->
     kirillov_kostant_plus (@all_matrices R n) mu w1 w2 c ->
     canonical_form 0 (R_star (invmx g) w1) 0 (R_star (invmx g) w2) = c).
Proof.
move=> printed.
have zero (R : comUnitRingType) (n : nat) (mu x y : 'M[R]_n) : pairing mu (bracket x y) = 0.
  have in_orbit : kirillov_kostant_plus (@all_matrices R n) mu (ad_star x mu) (ad_star y mu)
      (pairing mu (bracket x y)).
    by exists x, y.
  by rewrite -(printed R n 1%:M mu _ _ _ (unitmx1 _ _) in_orbit) /canonical_form !pairing_0r subrr.
pose mu := integers [:: [:: 1; 0]; [:: 0; 0]].
pose x := integers [:: [:: 0; 1]; [:: 0; 0]]; pose y := integers [:: [:: 0; 0]; [:: 1; 0]].
by have := zero _ _ (matrix_of 2 mu) (matrix_of 2 x) (matrix_of 2 y); decide_by_computation.
Qed.

(** ** A Lagrangian that is not an action

Section 4.3, remark below corollary 4.3.1: where the discrete Lagrangian is an action divided by the step, the
Legendre map is \f$(g_k, g_{k+1})\mapsto(g_k, -\Delta t\,D_1\mathbb L(g_k, g_{k+1}))\f$, the momentum of the
action \f$\Delta t\,\mathbb L\f$. *)

Theorem claim_4_3_time_step_legendre_of_matrices (R : comUnitRingType) (n : nat)
  (L : 'M[dual R]_n -> 'M[dual R]_n -> dual R) (step : R) (gk gk1 : 'M[R]_n) :
  differentiable (fun x => L x (still gk1)) gk ->
  start_momentum (fun x y => Dual step 0 * L x y) gk gk1 = - (step *: first_differential L gk gk1).
Proof.
move=> dL; rewrite /start_momentum; congr (- _); apply: differential_is => v.
by rewrite /= mul0r addr0 dL pairing_scalel.
Qed.

(** ** The Legendre map with the step, as printed

Printed is \f$\Delta t\cdot D_1\mathbb L\f$, without the minus. *)
Theorem claim_4_3_time_step_legendre_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (L : 'M[dual R]_n -> 'M[dual R]_n -> dual R) (step : R)
     (gk gk1 : 'M[R]_n),
     differentiable (fun x => L x (still gk1)) gk ->
     start_momentum (fun x y => Dual step 0 * L x y) gk gk1 = step *: first_differential L gk gk1).
Proof.
move=> printed.
have opposite (R : comUnitRingType) (n : nat) (W : 'M[R]_n) : - W = W.
  have := printed R n (fun x _ => linear_function W x) 1 1%:M 1%:M (@linear_differentiable R n W _).
  rewrite claim_4_3_time_step_legendre_of_matrices ?scale1r; last exact: linear_differentiable.
  by rewrite /first_differential linear_differential.
by have := opposite _ _ (matrix_of 2 quarter_turn); decide_by_computation.
Qed.
