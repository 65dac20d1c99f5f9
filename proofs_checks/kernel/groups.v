(** * Groups of matrices, momenta and the discrete Lie-Poisson algorithm

The algebra of sections 2.2 and 3.2: variations of velocities, the coadjoint action with its orbits and
brackets, body and spatial momenta, the quotient of pairs of configurations by the symmetry, and the discrete
Lie-Poisson algorithm. A group element is an invertible matrix of any size over any commutative ring. Where a
theorem is about a group of matrices smaller than all of them, its _algebra_ is a set of matrices and two
covectors are the same where they have the same values on the algebra; the set of all matrices is the algebra
of the general linear group. Derivatives are taken with dual numbers. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices dual_numbers computed.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope nat_scope.
Local Open Scope ring_scope.

Section Groups.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (a b f g h k p q v w x y z mu nu eta zeta : 'M[R]_n) (algebra group : 'M[R]_n -> Prop).

(** ** Inverses *)

Lemma inverse_unique a b : a *m b = 1%:M -> invmx a = b.
Proof.
move=> ab1; have [unit_a _] := mulmx1_unit ab1.
by rewrite -[LHS]mulmx1 -ab1 mulmxA mulVmx // mul1mx.
Qed.

Lemma inverse_product f g : f \in unitmx -> g \in unitmx -> invmx (f *m g) = invmx g *m invmx f.
Proof.
by move=> uf ug; apply: inverse_unique; rewrite mulmxA -[f *m g *m _]mulmxA mulmxV // mulmx1 mulmxV.
Qed.

Lemma product_unit f g : f \in unitmx -> g \in unitmx -> f *m g \in unitmx.
Proof. by rewrite unitmx_mul => -> ->. Qed.

Lemma inverse_one : invmx (1%:M : 'M[R]_n) = 1%:M.
Proof. by apply: inverse_unique; rewrite mulmx1. Qed.

Lemma transpose_inverse g : g \in unitmx -> g^T *m (invmx g)^T = 1%:M.
Proof. by move=> u; rewrite -trmx_mul mulVmx // trmx1. Qed.

Lemma inverse_transpose g : g \in unitmx -> (invmx g)^T *m g^T = 1%:M.
Proof. by move=> u; rewrite -trmx_mul mulmxV // trmx1. Qed.

(** ** The adjoint and the coadjoint action *)

Lemma Ad_product f g x : f \in unitmx -> g \in unitmx -> Ad f (Ad g x) = Ad (f *m g) x.
Proof. by move=> uf ug; rewrite /Ad inverse_product // !mulmxA. Qed.

Lemma AdK g x : g \in unitmx -> Ad (invmx g) (Ad g x) = x.
Proof.
by move=> u; rewrite Ad_product ?unitmx_inv // mulVmx // /Ad inverse_one mul1mx mulmx1.
Qed.

Lemma AdVK g x : g \in unitmx -> Ad g (Ad (invmx g) x) = x.
Proof. by move=> u; rewrite -{1}[g]invmxK AdK // unitmx_inv. Qed.

Lemma Ad_bracket g x y : g \in unitmx -> Ad g (bracket x y) = bracket (Ad g x) (Ad g y).
Proof.
move=> u; have middle a b : Ad g a *m Ad g b = Ad g (a *m b).
  by rewrite /Ad -!mulmxA; congr (_ *m (_ *m _)); rewrite !mulmxA mulVmx // mul1mx.
by rewrite /bracket !middle /Ad mulmxBr mulmxBl.
Qed.

Lemma Ad_star_product f g p : f \in unitmx -> g \in unitmx -> Ad_star f (Ad_star g p) = Ad_star (g *m f) p.
Proof. by move=> uf ug; rewrite /Ad_star inverse_product // !trmx_mul !mulmxA. Qed.

Lemma Ad_star_one p : Ad_star 1%:M p = p.
Proof. by rewrite /Ad_star inverse_one trmx1 mul1mx mulmx1. Qed.

Lemma Ad_starK g p : g \in unitmx -> Ad_star (invmx g) (Ad_star g p) = p.
Proof. by move=> u; rewrite Ad_star_product ?unitmx_inv // mulmxV // Ad_star_one. Qed.

Lemma Ad_starVK g p : g \in unitmx -> Ad_star g (Ad_star (invmx g) p) = p.
Proof. by move=> u; rewrite -{1}[g]invmxK Ad_starK // unitmx_inv. Qed.

Lemma Ad_star_opp g p : Ad_star g (- p) = - Ad_star g p.
Proof. by rewrite /Ad_star mulmxN mulNmx. Qed.

(** Between the two translations of a covector at \f$g\f$ to the identity lies the coadjoint action. *)
Lemma Ad_star_right g p : g \in unitmx -> Ad_star g (R_star g p) = L_star g p.
Proof. by move=> u; rewrite /Ad_star /R_star /L_star -!mulmxA transpose_inverse // mulmx1. Qed.

Lemma Ad_star_left g p : g \in unitmx -> Ad_star (invmx g) (L_star g p) = R_star g p.
Proof.
by move=> u; rewrite /Ad_star /R_star /L_star invmxK !mulmxA inverse_transpose // mul1mx.
Qed.

(** ** Groups smaller than all matrices *)

(** Two covectors are the same for a group with this algebra. *)
Definition agree algebra p q := forall x, algebra x -> pairing p x = pairing q x.

(** All matrices: the algebra of the general linear group. *)
Definition all_matrices : 'M[R]_n -> Prop := fun=> True.

(** \f$\mathrm{Ad}_g\f$ takes the algebra into itself, as it does for every element of the group. *)
Definition Ad_keeps algebra g := forall x, algebra x -> algebra (Ad g x).

Lemma agree_all p q : agree all_matrices p q <-> p = q.
Proof.
split=> [same|-> //]; apply/eqP; rewrite -subr_eq0; apply/eqP/pairing_nondegenerate => v.
by rewrite pairing_addl pairing_oppl same ?subrr.
Qed.

Lemma agree_Ad_star algebra g p q : Ad_keeps algebra g -> agree algebra p q ->
  agree algebra (Ad_star g p) (Ad_star g q).
Proof. by move=> keeps same x in_algebra; rewrite !Ad_star_dual same //; apply: keeps. Qed.

(** ** Variations of the reduced velocity, right-invariant case

Section 2.2, below theorem 2.2.1. Let \f$g(t,\epsilon)\f$ be a family of curves, \f$\xi = \dot g\,g^{-1}\f$
its velocity and \f$\eta = \delta g\,g^{-1}\f$ its variation. Then
\f[ \delta\xi = \dot\eta - \mathrm{ad}_\xi\,\eta, \qquad \mathrm{ad}_\xi\,\eta = [\xi, \eta] = \xi\eta -
\eta\xi. \f]
At one point of the family only \f$g\f$, \f$\dot g\f$, \f$\delta g\f$ and the mixed derivative
\f$\delta\dot g\f$ enter, and these are any four matrices, the first of them invertible: \f$\xi\f$ varies with
\f$\epsilon\f$ as \f$(\dot g + \epsilon\,\delta\dot g)(g + \epsilon\,\delta g)^{-1}\f$, and \f$\eta\f$ with
the time as \f$(\delta g + t\,\delta\dot g)(g + t\,\dot g)^{-1}\f$. *)

Theorem claim_2_2_reduced_variation_ad_of_matrices g g_dot g_varied g_dot_varied : g \in unitmx ->
  let xi := varied g_dot g_dot_varied *m invmx (varied g g_varied) in
  let eta := varied g_varied g_dot_varied *m invmx (varied g g_dot) in
  rate_of xi = rate_of eta - ad (value_of xi) (value_of eta).
Proof.
move=> u /=; rewrite !varied_inverse // !varied_mul !value_varied !rate_varied /ad /bracket.
(* Both mixed derivatives are the same; what is left are the two products of velocity and variation. *)
by rewrite !mulmxN !mulmxA opprB addrACA addNr add0r addrC.
Qed.

(** ** Variations of the reduced velocity, left-invariant case

Section 2.2, where left-invariant systems are said to be analogous: for \f$\xi = g^{-1}\dot g\f$ and
\f$\eta = g^{-1}\delta g\f$ the bracket has the other sign, \f$\delta\xi = \dot\eta + [\xi, \eta]\f$. *)

Theorem claim_2_2_left_reduction_variation g g_dot g_varied g_dot_varied : g \in unitmx ->
  let xi := invmx (varied g g_varied) *m varied g_dot g_dot_varied in
  let eta := invmx (varied g g_dot) *m varied g_varied g_dot_varied in
  rate_of xi = rate_of eta + bracket (value_of xi) (value_of eta).
Proof.
move=> u /=; rewrite !varied_inverse // !varied_mul !value_varied !rate_varied /bracket.
by rewrite !mulNmx !mulmxA addrA subrK.
Qed.

End Groups.

(** ** Variations of the reduced velocity: the sign as printed

Condition iv of theorem 2.2.1 is printed
\f$\delta\xi = \dot\eta - \mathrm{ad}_\xi\,\eta = \dot\eta + [\xi, \eta]\f$ for \f$\xi = \dot g\,g^{-1}\f$,
with \f$\mathrm{ad}_\xi\,\eta = [\xi,\eta]\f$ as in theorem 2.2.3. The second of the two expressions fails
wherever velocity and variation do not commute: at \f$g = 1\f$ already, with \f$\dot g\f$ and \f$\delta g\f$
the two 2 by 2 matrices that have a single 1 beside the diagonal. The first expression is
`claim_2_2_reduced_variation_ad_of_matrices`. *)

Theorem claim_2_2_reduced_variation_bracket_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (g g_dot g_varied g_dot_varied : 'M[R]_n), g \in unitmx ->
     let xi := varied g_dot g_dot_varied *m invmx (varied g g_varied) in
     let eta := varied g_varied g_dot_varied *m invmx (varied g g_dot) in
     rate_of xi = rate_of eta + bracket (value_of xi) (value_of eta)).
Proof.
move=> printed.
have at_one (R : comUnitRingType) (n : nat) (v w : 'M[R]_n) : - (v *m w) = - (w *m v) + bracket v w.
  have := printed R n 1%:M v w 0 (unitmx1 _ _); rewrite /= !varied_inverse ?unitmx1 // !varied_mul.
  by rewrite !value_varied !rate_varied inverse_one !mulmx1 !mul1mx !mulmxN !addr0.
pose up := integers [:: [:: 0; 1]; [:: 0; 0]]; pose down := integers [:: [:: 0; 0]; [:: 1; 0]].
by have := at_one Qc_comUnitRingType 2%N (matrix_of 2 up) (matrix_of 2 down); decide_by_computation.
Qed.

(** ** Coadjoint orbits

The coadjoint orbit of \f$\mu\f$ is the set of all \f$\mathrm{Ad}^*_{g^{-1}}\mu\f$ with \f$g\f$ in the group.
*)

Section Orbits.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g h p v w x y z mu nu : 'M[R]_n) (algebra group : 'M[R]_n -> Prop).

(** A set of invertible matrices with 1, all products and all inverses. *)
Definition is_group group :=
  [/\ group 1%:M, forall f g, group f -> group g -> group (f *m g),
      forall g, group g -> g \in unitmx & forall g, group g -> group (invmx g)].

Definition on_orbit group mu nu := exists2 g, group g & nu = Ad_star (invmx g) mu.

(** ** The symplectic forms of coadjoint orbits

Section 2.2. The tangent vectors of the orbit at \f$\mu\f$ are the \f$\mathrm{ad}^*_x\mu\f$ with \f$x\f$ in
the algebra, and the form of Kirillov and Kostant is
\f$\omega_+(\mathrm{ad}^*_x\mu, \mathrm{ad}^*_y\mu) = \langle\mu, [x,y]\rangle\f$. It is written here as a
relation between two tangent vectors and a number: the number is the value on these vectors, found by means of
some generators \f$x\f$ and \f$y\f$. \f$\omega_-\f$ is its negative. C++: `actio::kirillov_kostant_plus`,
`variational/coadjoint_orbit.hpp`. *)
Definition kirillov_kostant_plus algebra mu v w (c : R) := exists x y,
  [/\ algebra x, algebra y, agree algebra v (ad_star x mu), agree algebra w (ad_star y mu)
    & c = pairing mu (bracket x y)].

Lemma pairing_bracket mu x y : pairing mu (bracket x y) = pairing (ad_star x mu) y.
Proof. by rewrite ad_star_dual. Qed.

Lemma bracket_skew x y : bracket x y = - bracket y x.
Proof. by rewrite /bracket opprB. Qed.

(** ** The form of an orbit is well defined

Section 2.2: the value of the form of Kirillov and Kostant on two tangent vectors does not depend on the
generators by which it is found. No property of the set of matrices that is called the algebra is used. *)
Theorem claim_2_2_coadjoint_orbits_form algebra mu v w c d :
  kirillov_kostant_plus algebra mu v w c -> kirillov_kostant_plus algebra mu v w d -> c = d.
Proof.
move=> [x [y [in_x in_y v_x w_y ->]]] [x' [y' [in_x' in_y' v_x' w_y' ->]]].
(* Each side depends on one generator through the tangent vector only; exchange them one after the other. *)
rewrite pairing_bracket -v_x // v_x' // -pairing_bracket bracket_skew pairing_oppr.
by rewrite pairing_bracket -w_y // w_y' // -pairing_bracket -pairing_oppr -bracket_skew.
Qed.

(** ** The form of an orbit is not degenerate

Section 2.2: coadjoint orbits are symplectic. A tangent vector \f$\mathrm{ad}^*_x\mu\f$ on which all values of
the form vanish is zero as a covector of the algebra. *)
Theorem claim_2_2_coadjoint_orbits_nondegenerate algebra mu x :
  (forall y, algebra y -> pairing mu (bracket x y) = 0) -> agree algebra (ad_star x mu) 0.
Proof. by move=> vanishes y in_y; rewrite -pairing_bracket vanishes // pairing_0l. Qed.

(** \f$\mathrm{Ad}^*\f$ carries generators:
\f$\mathrm{Ad}^*_{g^{-1}}\mathrm{ad}^*_x\mu = \mathrm{ad}^*_{\mathrm{Ad}_gx}\mathrm{Ad}^*_{g^{-1}}\mu\f$. *)
Lemma Ad_star_ad_star g x mu : g \in unitmx ->
  Ad_star (invmx g) (ad_star x mu) = ad_star (Ad g x) (Ad_star (invmx g) mu).
Proof.
move=> u; apply/(agree_all _ _) => z _.
by rewrite Ad_star_dual !ad_star_dual Ad_star_dual /ad -[in RHS](AdVK z u) -Ad_bracket // AdK.
Qed.

(** ** The coadjoint action preserves the symplectic forms

Section 2.2, lemma 14.4.2 of Marsden and Ratiu: \f$\mathrm{Ad}^*_{g^{-1}}\f$ preserves \f$\omega_\pm\f$. The
map is linear and so carries tangent vectors as it carries momenta; tangent vectors \f$v\f$, \f$w\f$ at
\f$\mu\f$ on which the form has the value \f$c\f$ go to tangent vectors at \f$\mathrm{Ad}^*_{g^{-1}}\mu\f$ on
which it has the same value. All that is used of \f$g\f$ is that \f$\mathrm{Ad}_g\f$ and
\f$\mathrm{Ad}_{g^{-1}}\f$ keep the algebra; that this is closed under brackets is not needed. *)

Theorem claim_2_2_coadjoint_action_kk_of_matrices algebra g mu v w c : g \in unitmx ->
  Ad_keeps algebra g -> Ad_keeps algebra (invmx g) ->
  kirillov_kostant_plus algebra mu v w c ->
  kirillov_kostant_plus algebra (Ad_star (invmx g) mu) (Ad_star (invmx g) v) (Ad_star (invmx g) w) c.
Proof.
move=> u keeps keeps_back [x [y [in_x in_y v_x w_y ->]]]; exists (Ad g x), (Ad g y).
split; [exact: keeps|exact: keeps| | |].
- by rewrite -Ad_star_ad_star //; apply: agree_Ad_star.
- by rewrite -Ad_star_ad_star //; apply: agree_Ad_star.
by rewrite -Ad_bracket // Ad_star_dual AdK.
Qed.

(** ** The coadjoint action preserves orbits

Section 3.2, before (3.17): \f$\mathrm{Ad}^*_{g^{-1}}\f$ takes each orbit into itself. *)

Theorem claim_3_2_coadjoint_lie_poisson_orbits group g mu nu : is_group group -> group g ->
  on_orbit group mu nu -> on_orbit group mu (Ad_star (invmx g) nu).
Proof.
case=> [_ products units _] in_g [h in_h ->]; exists (g *m h); first exact: products.
by rewrite inverse_product ?units // Ad_star_product // unitmx_inv units.
Qed.

(** ** Brackets of functions on the dual

The plus bracket of Lie and Poisson, theorem 2.2.2, is
\f$\{F, H\}_+(\mu) = \langle\mu, [\frac{\delta F}{\delta\mu}, \frac{\delta H}{\delta\mu}]\rangle\f$. The
derivative of a function of covectors is a matrix \f$a\f$ of the algebra, with
\f$\frac{d}{d\varepsilon}F(\mu+\varepsilon\nu) = \langle\nu, a\rangle\f$; since the pairing
\f$\mathrm{Tr}(\nu^Ta)\f$ is symmetric, it is the differential of \f$F\f$ as above. C++:
`actio::lie_poisson_bracket_plus`, `variational/lie_poisson.hpp`. *)
Definition lie_poisson_bracket_plus (F H : 'M[dual R]_n -> dual R) mu :=
  pairing mu (bracket (differential F mu) (differential H mu)).

Lemma inverse_still g : g \in unitmx -> invmx (still g) = still (invmx g).
Proof. by move=> u; rewrite varied_inverse // mulmx0 mul0mx oppr0. Qed.

Lemma Ad_star_still g mu nu : g \in unitmx ->
  Ad_star (still g) (varied mu nu) = varied (Ad_star g mu) (Ad_star g nu).
Proof.
move=> u; rewrite /Ad_star inverse_still // !varied_transpose !varied_mul !trmx0.
by rewrite !mulmx0 !mul0mx !addr0 add0r.
Qed.

(** ** The coadjoint action preserves the brackets

Section 3.2, before (3.17): for \f$\Phi(\mu) = \mathrm{Ad}^*_g\,\mu\f$ and all functions that are
differentiable at \f$\Phi(\mu)\f$, \f$\{F\circ\Phi, H\circ\Phi\}_+ = \{F, H\}_+\circ\Phi\f$. The minus bracket
is the negative of the plus bracket and is preserved with it. With \f$g^{-1}\f$ for \f$g\f$ this is the
coadjoint action of \f$g\f$. *)

Theorem claim_3_2_coadjoint_lie_poisson_brackets F H g mu : g \in unitmx ->
  differentiable F (Ad_star g mu) -> differentiable H (Ad_star g mu) ->
  lie_poisson_bracket_plus (F \o Ad_star (still g)) (H \o Ad_star (still g)) mu
  = lie_poisson_bracket_plus F H (Ad_star g mu).
Proof.
move=> u dF dH.
(* The derivative of a function after the map is its derivative, carried by Ad. *)
have carried K : differentiable K (Ad_star g mu) ->
    differential (K \o Ad_star (still g)) mu = Ad g (differential K (Ad_star g mu)).
  move=> dK; apply: differential_is => nu /=.
  by rewrite Ad_star_still // dK pairing_sym Ad_star_dual pairing_sym.
by rewrite /lie_poisson_bracket_plus !carried // -Ad_bracket // -Ad_star_dual.
Qed.

(** ** The bracket induces the form of the orbit

Section 3.2, before (3.17): the vector fields of functions \f$F\f$ and \f$H\f$ for the plus bracket are
\f$-\mathrm{ad}^*_{dF}\mu\f$ and \f$-\mathrm{ad}^*_{dH}\mu\f$ at \f$\mu\f$. They are tangent to the orbit, and
its form has the value \f$\{F, H\}_+(\mu)\f$ on them. *)
Theorem claim_3_2_coadjoint_lie_poisson_leaf_form algebra F H mu : (forall z, algebra z -> algebra (- z)) ->
  algebra (differential F mu) -> algebra (differential H mu) ->
  kirillov_kostant_plus algebra mu (- ad_star (differential F mu) mu) (- ad_star (differential H mu) mu)
    (lie_poisson_bracket_plus F H mu).
Proof.
move=> opposite in_F in_H; exists (- differential F mu), (- differential H mu).
have ad_star_opp z : ad_star (- z) mu = - ad_star z mu.
  by rewrite /ad_star [trmx _]raddfN mulNmx mulmxN opprB opprK addrC.
split; [exact: opposite|exact: opposite| | |]; rewrite ?ad_star_opp //.
by rewrite /lie_poisson_bracket_plus /bracket !mulmxN !mulNmx !opprK.
Qed.

(** ** What the coadjoint action preserves

Section 3.2, before (3.17): \f$\mathrm{Ad}^*_{g^{-1}}\f$ with \f$g\f$ in the group takes each coadjoint orbit
into itself, its symplectic form to itself, and the brackets of Lie and Poisson to themselves; the orbits are
sets of covectors. *)
Theorem claim_3_2_coadjoint_lie_poisson_of_matrices algebra group g mu : is_group group ->
  (forall h, group h -> Ad_keeps algebra h) -> group g ->
  [/\ forall nu, on_orbit group mu nu -> on_orbit group mu (Ad_star (invmx g) nu),
      forall v w c, kirillov_kostant_plus algebra mu v w c ->
        kirillov_kostant_plus algebra (Ad_star (invmx g) mu) (Ad_star (invmx g) v) (Ad_star (invmx g) w) c
    & forall F H, differentiable F (Ad_star (invmx g) mu) -> differentiable H (Ad_star (invmx g) mu) ->
        lie_poisson_bracket_plus (F \o Ad_star (still (invmx g))) (H \o Ad_star (still (invmx g))) mu
        = lie_poisson_bracket_plus F H (Ad_star (invmx g) mu)].
Proof.
move=> is_g keeps in_g; have [_ _ units inverses] := is_g; split.
- by move=> nu; apply: claim_3_2_coadjoint_lie_poisson_orbits.
- move=> v w c; apply: claim_2_2_coadjoint_action_kk_of_matrices; first exact: units.
    by apply: keeps.
  by apply: keeps; apply: inverses.
by move=> F H; apply: claim_3_2_coadjoint_lie_poisson_brackets; rewrite unitmx_inv units.
Qed.

End Orbits.

(** ** Pairs of configurations modulo the symmetry *)

Section RelativeMotions.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g h v w : 'M[R]_n).

(** \f$f_{01} = g_0g_1^{-1}\f$, right-invariant. C++: `actio::relative_motion_right`,
`reduction/relative_motion.hpp`. *)
Definition relative_motion_right g0 g1 : 'M[R]_n := g0 *m invmx g1.

(** \f$f_{10} = g_1^{-1}g_0\f$, left-invariant. C++: `actio::relative_motion_left`,
`reduction/relative_motion.hpp`. *)
Definition relative_motion_left g0 g1 : 'M[R]_n := invmx g1 *m g0.

(** The configuration after \f$g_k\f$, from \f$f_{k,k+1} = g_kg_{k+1}^{-1}\f$. C++:
`actio::reconstruct_right`, `reduction/relative_motion.hpp`. *)
Definition reconstruct_right gk f : 'M[R]_n := invmx f *m gk.

(** The configuration after \f$g_k\f$, from \f$f_{k+1,k} = g_{k+1}^{-1}g_k\f$. C++: `actio::reconstruct_left`,
`reduction/relative_motion.hpp`. *)
Definition reconstruct_left gk f : 'M[R]_n := gk *m invmx f.

Lemma relative_motion_right_unit g0 g1 : g0 \in unitmx -> g1 \in unitmx ->
  relative_motion_right g0 g1 \in unitmx.
Proof. by move=> u0 u1; rewrite product_unit ?unitmx_inv. Qed.

Lemma relative_motion_left_unit g0 g1 : g0 \in unitmx -> g1 \in unitmx ->
  relative_motion_left g0 g1 \in unitmx.
Proof. by move=> u0 u1; rewrite product_unit ?unitmx_inv. Qed.

(** ** The quotient map

(3.9): \f$\pi_d(g_k, g_{k+1}) = g_kg_{k+1}^{-1}\f$ is the quotient by the action
\f$(g_k, g_{k+1})\mapsto(g_k\bar g, g_{k+1}\bar g)\f$. Two pairs have the same image exactly where one is the
other, multiplied on the right by one \f$\bar g\f$. *)

Theorem eq_3_9 g0 g1 h0 h1 : g1 \in unitmx -> h1 \in unitmx ->
  relative_motion_right g0 g1 = relative_motion_right h0 h1
  <-> exists2 k, k \in unitmx & h0 = g0 *m k /\ h1 = g1 *m k.
Proof.
rewrite /relative_motion_right => u1 w1; split=> [same|[k uk [-> ->]]]; last first.
  by rewrite inverse_product // mulmxA -[g0 *m k *m _]mulmxA mulmxV // mulmx1.
exists (invmx g1 *m h1); first by rewrite product_unit ?unitmx_inv.
split; first by rewrite mulmxA same -mulmxA mulVmx // mulmx1.
by rewrite mulmxA mulmxV // mul1mx.
Qed.

(** ** Every group element is a relative motion

(3.9): \f$f\f$ is the image of the pair \f$(f, 1)\f$. *)
Theorem eq_3_9_onto f : relative_motion_right f 1%:M = f.
Proof. by rewrite /relative_motion_right inverse_one mulmx1. Qed.

(** ** The reduced Lagrangian

Section 3.2, below (3.9): for a function \f$\mathbb L\f$ of pairs that is invariant under multiplication of
both on the right there is one and only one \f$\ell\f$ with
\f$\ell(g_kg_{k+1}^{-1}) = \mathbb L(g_k, g_{k+1})\f$, namely \f$\ell(f) = \mathbb L(f, 1)\f$. Its values may
be of any type. *)

Theorem claim_3_2_reduced_lagrangian T (L : 'M[R]_n -> 'M[R]_n -> T) :
  (forall g0 g1 k, g0 \in unitmx -> g1 \in unitmx -> k \in unitmx -> L (g0 *m k) (g1 *m k) = L g0 g1) ->
  let l f := L f 1%:M in
  (forall g0 g1, g0 \in unitmx -> g1 \in unitmx -> l (relative_motion_right g0 g1) = L g0 g1)
  /\ (forall l', (forall g0 g1, g0 \in unitmx -> g1 \in unitmx ->
        l' (relative_motion_right g0 g1) = L g0 g1) -> forall f, f \in unitmx -> l' f = l f).
Proof.
move=> invariant /=; split=> [g0 g1 u0 u1|l' is_l f u].
  by rewrite -[in RHS](invariant _ _ (invmx g1)) ?unitmx_inv // mulmxV.
by rewrite -[f in LHS]eq_3_9_onto is_l // unitmx1.
Qed.

(** ** The reduced action sum

Section 3.2, below (3.9): \f$\sum_{k=0}^{N-1}\mathbb L(g_k, g_{k+1}) = \sum_{k=0}^{N-1}\ell(f_{k,k+1})\f$. *)
Theorem claim_3_2_reduced_lagrangian_sum (A : zmodType) (L : 'M[R]_n -> 'M[R]_n -> A) (l : 'M[R]_n -> A)
  (g : nat -> 'M[R]_n) N :
  (forall g0 g1, L g0 g1 = l (relative_motion_right g0 g1)) ->
  \sum_(0 <= k < N) L (g k) (g k.+1) = \sum_(0 <= k < N) l (relative_motion_right (g k) (g k.+1)).
Proof. by move=> reduced; apply: eq_bigr => k _. Qed.

(** ** How the relative motion varies

In condition (3) of theorem 3.2.1:
\f[ \delta f_{k,k+1} = TR_{f_{k,k+1}}\bigl(\delta g_kg_k^{-1} - \mathrm{Ad}_{f_{k,k+1}}\,\delta
g_{k+1}g_{k+1}^{-1}\bigr). \f] *)

Theorem claim_3_2_variation_of_f g0 g1 v0 v1 : g0 \in unitmx -> g1 \in unitmx ->
  let f := relative_motion_right g0 g1 in
  varied g0 v0 *m invmx (varied g1 v1)
  = varied f (right_translation f (v0 *m invmx g0 - Ad f (v1 *m invmx g1))).
Proof.
move=> u0 u1 /=; rewrite varied_inverse // varied_mul -/(relative_motion_right g0 g1).
have uf := relative_motion_right_unit u0 u1.
have back_f : invmx g0 *m relative_motion_right g0 g1 = invmx g1.
  by rewrite /relative_motion_right mulmxA mulVmx // mul1mx.
congr (varied _ _); rewrite /right_translation /Ad mulmxBl -!mulmxA back_f mulVmx // mulmx1.
by rewrite mulmxN addrC /relative_motion_right -?mulmxA.
Qed.

(** ** How the relative motion varies, left-invariant case

For \f$f_{10} = g_1^{-1}g_0\f$ of remark 3.2.1:
\f$\delta f = TL_f\bigl(g_0^{-1}\delta g_0 - \mathrm{Ad}_{f^{-1}}\,g_1^{-1}\delta g_1\bigr)\f$. *)
Theorem variation_of_relative_motion_left g0 g1 v0 v1 : g0 \in unitmx -> g1 \in unitmx ->
  let f := relative_motion_left g0 g1 in
  invmx (varied g1 v1) *m varied g0 v0
  = varied f (left_translation f (invmx g0 *m v0 - Ad (invmx f) (invmx g1 *m v1))).
Proof.
move=> u0 u1 /=; rewrite varied_inverse // varied_mul -/(relative_motion_left g0 g1).
have uf := relative_motion_left_unit u0 u1.
have f_back : relative_motion_left g0 g1 *m invmx g0 = invmx g1.
  by rewrite /relative_motion_left -mulmxA mulmxV // mulmx1.
congr (varied _ _); rewrite /left_translation /Ad invmxK mulmxBr !mulmxA f_back mulmxV // mul1mx.
by rewrite !mulNmx /relative_motion_left -?mulmxA.
Qed.

End RelativeMotions.

Section Momenta.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g m p mu : 'M[R]_n) (l : 'M[dual R]_n -> dual R) (algebra group : 'M[R]_n -> Prop).

(** A covector \f$m\f$ at \f$g\f$ has the body momentum \f$m_c = L_g^*m\f$ and the spatial momentum
\f$m_s = R_g^*m\f$. *)
Definition body_momentum g m := L_star g m.
Definition spatial_momentum g m := R_star g m.

(** ** Body and spatial momentum

Section 3.2, before (3.16): \f$m_s = \mathrm{Ad}^*_{g^{-1}}m_c\f$ for every covector at every group element.
*)
Theorem claim_3_2_body_spatial_momenta_of_matrices g m : g \in unitmx ->
  spatial_momentum g m = Ad_star (invmx g) (body_momentum g m).
Proof. by move=> u; rewrite [RHS]Ad_star_left. Qed.

(** ** The spatial momentum in time

(3.16): while the body momentum is the constant \f$\mu_0\f$, the spatial momentum is
\f$\mu(t) = \mathrm{Ad}^*_{g(t)^{-1}}\mu_0\f$. The times may be of any kind, steps as well as an interval. *)

Theorem eq_3_16_of_matrices Time (g m : Time -> 'M[R]_n) mu0 : (forall t, g t \in unitmx) ->
  (forall t, body_momentum (g t) (m t) = mu0) ->
  forall t, spatial_momentum (g t) (m t) = Ad_star (invmx (g t)) mu0.
Proof. by move=> u constant t; rewrite claim_3_2_body_spatial_momenta_of_matrices // constant. Qed.

(** ** The constant in (3.16)

\f$\mu_0 = \mathrm{Ad}^*_{g(t)}\mu(t)\f$ at every time; in particular \f$\mu_0\f$ is
\f$\mathrm{Ad}^*_{g(0)}\mu(0)\f$, which is \f$\mu(0)\f$ where the motion begins at the identity. *)
Theorem eq_3_16_constant Time (g m : Time -> 'M[R]_n) mu0 t : g t \in unitmx ->
  body_momentum (g t) (m t) = mu0 -> mu0 = Ad_star (g t) (spatial_momentum (g t) (m t)).
Proof. by move=> u <-; rewrite claim_3_2_body_spatial_momenta_of_matrices // Ad_starVK. Qed.

(** ** Reduced motion along the coadjoint orbit

Section 2.2, last formula: \f$\mu(t) = \mathrm{Ad}^*_{g^{-1}(t)}\mu_0\f$. Here \f$\mu_0\f$ is the value of the
momentum map \f$J(p) = L_g^*p\f$ of multiplication from the right, taken at \f$p(t)\f$, a covector at
\f$g(t)\f$. The two sides of the formula determine each other: it holds at all times exactly where
\f$J(p(t)) = \mu_0\f$ at all times. *)

Theorem claim_2_2_reduced_motion_of_matrices Time (g p : Time -> 'M[R]_n) mu0 : (forall t, g t \in unitmx) ->
  (forall t, body_momentum (g t) (p t) = mu0)
  <-> (forall t, spatial_momentum (g t) (p t) = Ad_star (invmx (g t)) mu0).
Proof.
move=> u; split=> [constant|moves t]; first exact: eq_3_16_of_matrices.
by rewrite -[mu0](Ad_starVK _ (u t)) -moves [RHS]Ad_star_right.
Qed.

(** \f$R_f^*\,\ell'(f)\f$. C++: `actio::right_differential`, `groups/differential.hpp`. *)
Definition right_differential l f := R_star f (differential l f).

(** \f$L_f^*\,\ell'(f)\f$. C++: `actio::left_differential`, `groups/differential.hpp`. *)
Definition left_differential l f := L_star f (differential l f).

(** The residual of the discrete Euler-Poincare equations (3.10), right-invariant:
\f$R^*_{f_{12}}\ell'(f_{12}) - L^*_{f_{01}}\ell'(f_{01})\f$. C++: `actio::euler_poincare_right`,
`reduction/discrete_euler_poincare.hpp`. *)
Definition euler_poincare_right l f01 f12 := right_differential l f12 - left_differential l f01.

(** That of (3.11), left-invariant: \f$L^*_{f_{21}}\ell'(f_{21}) - R^*_{f_{10}}\ell'(f_{10})\f$. C++:
`actio::euler_poincare_left`, `reduction/discrete_euler_poincare.hpp`. *)
Definition euler_poincare_left l f10 f21 := left_differential l f21 - right_differential l f10.

(** The spatial momentum at the start of a right-invariant step, \f$\mu_0 = -R_f^*\ell'(f)\f$. C++:
`actio::momentum_before_right`, `reduction/discrete_lie_poisson.hpp`. *)
Definition momentum_before_right l f := - right_differential l f.

(** The body momentum at the start of a left-invariant step, \f$\Pi_0 = -L_f^*\ell'(f)\f$. C++:
`actio::momentum_before_left`, `reduction/discrete_lie_poisson.hpp`. *)
Definition momentum_before_left l f := - left_differential l f.

(** C++: `actio::lie_poisson_update_right`, `reduction/discrete_lie_poisson.hpp`. *)
Definition lie_poisson_update_right f mu := Ad_star f mu.

(** C++: `actio::lie_poisson_update_left`, `reduction/discrete_lie_poisson.hpp`. *)
Definition lie_poisson_update_left f mu := Ad_star (invmx f) mu.

Lemma differential_of_inverse l f : f \in unitmx -> differentiable l f ->
  differential (fun x => l (invmx x)) (invmx f) = - (f^T *m differential l f *m f^T).
Proof.
move=> u dl; apply: differential_is => v; rewrite varied_inverse ?unitmx_inv // invmxK dl.
rewrite pairing_oppr pairing_oppl -[_ *m f^T]/(R_star f (L_star f _)) R_star_dual L_star_dual.
by rewrite /left_translation /right_translation mulmxA.
Qed.

(** ** The other representative of a pair

Section 3.2, below (3.9): one may use \f$g_{k+1}g_k^{-1}\f$ instead of \f$g_kg_{k+1}^{-1}\f$. The reduced
Lagrangian is then \f$\tilde\ell(h) = \ell(h^{-1})\f$, and the equations (3.10) exchange their sides:
\f$L^*\tilde\ell'\f$ at \f$h_{21} = f_{12}^{-1}\f$ equals \f$R^*\tilde\ell'\f$ at \f$h_{10} = f_{01}^{-1}\f$,
which has the form of (3.11). *)
Theorem claim_3_2_alternative_quotient l f01 f12 : f01 \in unitmx -> f12 \in unitmx ->
  differentiable l f01 -> differentiable l f12 ->
  euler_poincare_right l f01 f12 = - euler_poincare_left (fun x => l (invmx x)) (invmx f01) (invmx f12).
Proof.
move=> u0 u1 d0 d1; rewrite /euler_poincare_right /euler_poincare_left opprB /right_differential.
rewrite /left_differential !differential_of_inverse // /R_star /L_star mulNmx mulmxN opprK [RHS]addrC.
by congr (_ - _); rewrite -!mulmxA ?transpose_inverse // ?mulmx1 // !mulmxA inverse_transpose // mul1mx.
Qed.

Lemma agree_difference algebra (p q : 'M[R]_n) : agree algebra (p - q) 0 <-> agree algebra (- p) (- q).
Proof.
split=> equal x in_x; move: (equal x in_x); rewrite pairing_0l pairing_addl !pairing_oppl.
  by move/eqP; rewrite subr_eq0 => /eqP ->.
by move/oppr_inj ->; rewrite subrr.
Qed.

(** ** The discrete Lie-Poisson algorithm, right-invariant

(3.17): \f$\mu_{k+1} = \mathrm{Ad}^*_{f_{k,k+1}}\mu_k\f$ with \f$\mu_k = -R^*_{f_{k,k+1}}\ell'(f_{k,k+1})\f$.
The update and the discrete Euler-Poincare equations (3.10) say the same, in every group; neither the sign of
the momentum nor any property of \f$\ell\f$ enters. *)

Theorem eq_3_17 algebra l f01 f12 : f01 \in unitmx ->
  agree algebra (euler_poincare_right l f01 f12) 0
  <-> agree algebra (momentum_before_right l f12)
        (lie_poisson_update_right f01 (momentum_before_right l f01)).
Proof.
rewrite /lie_poisson_update_right Ad_star_opp => u; rewrite Ad_star_right //.
exact: agree_difference.
Qed.

(** ** The momentum at the end of a step

The update (3.17) takes \f$-R_f^*\ell'(f)\f$ to \f$-L_f^*\ell'(f)\f$, whether or not a motion goes on from
there. *)
Theorem eq_3_17_end_of_step l f : f \in unitmx ->
  lie_poisson_update_right f (momentum_before_right l f) = - left_differential l f.
Proof. by move=> u; rewrite /lie_poisson_update_right Ad_star_opp Ad_star_right. Qed.

(** ** The discrete Lie-Poisson algorithm, left-invariant

(3.18) with its inverse: \f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}^{-1}}\Pi_k\f$ with
\f$\Pi_k = -L^*_{f_{k+1,k}}\ell'(f_{k+1,k})\f$. The update and the equations (3.11) say the same. *)

Theorem eq_3_18 algebra l f10 f21 : f10 \in unitmx ->
  agree algebra (euler_poincare_left l f10 f21) 0
  <-> agree algebra (momentum_before_left l f21)
        (lie_poisson_update_left f10 (momentum_before_left l f10)).
Proof.
rewrite /lie_poisson_update_left Ad_star_opp => u; rewrite Ad_star_left //.
exact: agree_difference.
Qed.

End Momenta.

(** ** The left-invariant update as printed

(3.18) is printed without the inverse, \f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}}\Pi_k\f$. This fails for a
motion of \f$\ell(f) = \mathrm{Tr}(W^Tf)\f$ with \f$W = \mathrm{diag}(1, -1)\f$: the two relative motions
below satisfy (3.11), and the update without the inverse does not take the momentum before the first step to
the momentum before the second. *)

Theorem eq_3_18_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (l : 'M[dual R]_n -> dual R) (f10 f21 : 'M[R]_n),
     f10 \in unitmx -> f21 \in unitmx -> differentiable l f10 -> differentiable l f21 ->
     euler_poincare_left l f10 f21 = 0 ->
     momentum_before_left l f21 = Ad_star f10 (momentum_before_left l f10)).
Proof.
move=> printed.
have for_linear (R : comUnitRingType) (n : nat) (W f10 f21 : 'M[R]_n) : f10 \in unitmx -> f21 \in unitmx ->
    L_star f21 W - R_star f10 W = 0 -> - L_star f21 W = Ad_star f10 (- L_star f10 W).
  move=> u0 u1 motion; have := printed R n (linear_function W) f10 f21 u0 u1.
  rewrite /momentum_before_left /euler_poincare_left /left_differential /right_differential.
  by rewrite !linear_differential; apply; do ?exact: linear_differentiable.
pose W := integers [:: [:: 1; 0]; [:: 0; -1]]; pose f10 := integers [:: [:: 1; 0]; [:: 1; 1]].
pose f21 := integers [:: [:: 1; 0]; [:: -1; 1]].
have unit0 : matrix_of 2 f10 \in unitmx by decide_by_computation.
have unit1 : matrix_of 2 f21 \in unitmx by decide_by_computation.
have motion : L_star (matrix_of 2 f21) (matrix_of 2 W) - R_star (matrix_of 2 f10) (matrix_of 2 W) = 0.
  by decide_by_computation.
by have := for_linear _ _ _ _ _ unit0 unit1 motion; decide_by_computation.
Qed.

Section Chains.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f g mu pi : 'M[R]_n) (l : 'M[dual R]_n -> dual R) (group : 'M[R]_n -> Prop).

(** ** The momentum that the left-invariant algorithm carries

Remark 3.2.2: with \f$\Pi_k := \mathrm{Ad}^*_{g_k}\pi_0\f$ and \f$f_{k+1,k} = g_{k+1}^{-1}g_k\f$ the update is
\f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}^{-1}}\Pi_k\f$, whatever \f$\pi_0\f$. *)
Theorem rem_3_2_2_of_matrices gk gk1 pi0 : gk \in unitmx -> gk1 \in unitmx ->
  Ad_star gk1 pi0 = lie_poisson_update_left (relative_motion_left gk gk1) (Ad_star gk pi0).
Proof.
move=> u0 u1; have uf := relative_motion_left_unit u0 u1.
rewrite /lie_poisson_update_left Ad_star_product ?unitmx_inv //; congr Ad_star.
by rewrite /relative_motion_left inverse_product ?unitmx_inv // invmxK mulmxA mulmxV // mul1mx.
Qed.

(** ** The constant of the left-invariant algorithm

Remark 3.2.2: along a motion of (3.11), with configurations reconstructed by (3.15), \f$\pi_0\f$ is the
spatial momentum \f$\mathrm{Ad}^*_{g_k^{-1}}\Pi_k\f$, the same before every step. *)
Theorem rem_3_2_2_constant l g0 f10 f21 : g0 \in unitmx -> f10 \in unitmx ->
  euler_poincare_left l f10 f21 = 0 ->
  Ad_star (invmx (reconstruct_left g0 f10)) (momentum_before_left l f21)
  = Ad_star (invmx g0) (momentum_before_left l f10).
Proof.
move=> u0 u1 motion.
have update : agree (@all_matrices R n) (euler_poincare_left l f10 f21) 0 by rewrite motion.
move/(eq_3_18 _ _ _ u1)/agree_all: update => ->; rewrite /lie_poisson_update_left.
rewrite Ad_star_product ?unitmx_inv ?product_unit ?unitmx_inv //; congr Ad_star.
by rewrite /reconstruct_left inverse_product ?unitmx_inv // invmxK mulmxA mulVmx // mul1mx.
Qed.

(** ** The chain of equalities that leads to (3.17)

Section 3.2, before proposition 3.2.1, with \f$\mu_k = \mathrm{Ad}^*_{g_k^{-1}}\mu_0\f$ and
\f$\mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}^{-1}}\mu_0\f$ by (3.16) and \f$f_{k,k+1} = g_kg_{k+1}^{-1}\f$:
\f[ \mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}^{-1}}\mu_0 = \mathrm{Ad}^*_{(f_{k,k+1}^{-1}g_k)^{-1}}\mu_0 =
\mathrm{Ad}^*_{f_{k,k+1}}\mathrm{Ad}^*_{g_k^{-1}}\mu_0 = \mathrm{Ad}^*_{f_{k,k+1}}\mu_k. \f] *)
Theorem claim_3_2_dlp_chain_of_matrices gk gk1 mu0 muk muk1 : gk \in unitmx -> gk1 \in unitmx ->
  muk = Ad_star (invmx gk) mu0 -> muk1 = Ad_star (invmx gk1) mu0 ->
  let f := relative_motion_right gk gk1 in
  [/\ muk1 = Ad_star (invmx (invmx f *m gk)) mu0, muk1 = Ad_star f (Ad_star (invmx gk) mu0)
    & muk1 = lie_poisson_update_right f muk].
Proof.
move=> u0 u1 -> -> /=; set f := relative_motion_right gk gk1.
have uf : f \in unitmx by apply: relative_motion_right_unit.
have back : invmx f *m gk = gk1.
  rewrite /f /relative_motion_right inverse_product ?unitmx_inv // invmxK.
  by rewrite -mulmxA mulVmx // mulmx1.
have last : Ad_star (invmx gk1) mu0 = Ad_star f (Ad_star (invmx gk) mu0).
  by rewrite Ad_star_product ?unitmx_inv // /f /relative_motion_right mulmxA mulVmx // mul1mx.
by split; rewrite ?back.
Qed.

End Chains.

(** ** The chain of equalities: the first expression as printed

Printed is \f$\mu_{k+1} = \mathrm{Ad}^*_{g_{k+1}}\mu_0\f$, without the inverse that (3.16) has. It fails
already where \f$g_k = 1\f$, for a triangular \f$g_{k+1}\f$ of size 2. *)
Theorem claim_3_2_dlp_chain_printed_fails_first :
  ~ (forall (R : comUnitRingType) (n : nat) (gk gk1 mu0 muk1 : 'M[R]_n), gk \in unitmx -> gk1 \in unitmx ->
     muk1 = Ad_star (invmx gk1) mu0 -> muk1 = Ad_star gk1 mu0).
Proof.
move=> printed; pose g := integers [:: [:: 1; 1]; [:: 0; 1]]; pose mu := integers [:: [:: 0; 0]; [:: 0; 1]].
have unit_g : matrix_of 2 g \in unitmx by decide_by_computation.
have := printed _ _ 1%:M (matrix_of 2 g) (matrix_of 2 mu) _ (unitmx1 _ _) unit_g erefl.
by decide_by_computation.
Qed.

(** ** The chain of equalities: the third expression as printed

Printed is \f$\mu_{k+1} = \mathrm{Ad}^*_{f_{k,k+1}}\mathrm{Ad}^*_{g_k}\mu_0\f$, without the inverse at
\f$g_k\f$. It fails already where \f$g_{k+1} = 1\f$. *)
Theorem claim_3_2_dlp_chain_printed_fails_third :
  ~ (forall (R : comUnitRingType) (n : nat) (gk gk1 mu0 muk1 : 'M[R]_n), gk \in unitmx -> gk1 \in unitmx ->
     muk1 = Ad_star (invmx gk1) mu0 -> muk1 = Ad_star (relative_motion_right gk gk1) (Ad_star gk mu0)).
Proof.
move=> printed; pose g := integers [:: [:: 1; 1]; [:: 0; 1]]; pose mu := integers [:: [:: 0; 0]; [:: 0; 1]].
have unit_g : matrix_of 2 g \in unitmx by decide_by_computation.
have := printed _ _ (matrix_of 2 g) 1%:M (matrix_of 2 mu) _ unit_g (unitmx1 _ _) erefl.
by rewrite /relative_motion_right inverse_one Ad_star_one mulmx1; decide_by_computation.
Qed.

(** ** Remark 3.2.2 as printed

The remark prints \f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}}\Pi_k\f$, without its inverse, beside the definition
\f$\Pi_k := \mathrm{Ad}^*_{g_k}\pi_0\f$, and the two contradict each other. *)
Theorem rem_3_2_2_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (gk gk1 pi0 : 'M[R]_n), gk \in unitmx -> gk1 \in unitmx ->
     Ad_star gk1 pi0 = Ad_star (relative_motion_left gk gk1) (Ad_star gk pi0)).
Proof.
move=> printed; pose g := integers [:: [:: 1; 1]; [:: 0; 1]]; pose pi0 := integers [:: [:: 0; 0]; [:: 0; 1]].
have unit_g : matrix_of 2 g \in unitmx by decide_by_computation.
have := printed _ _ (matrix_of 2 g) 1%:M (matrix_of 2 pi0) unit_g (unitmx1 _ _).
by rewrite /relative_motion_left inverse_one mul1mx Ad_star_one; decide_by_computation.
Qed.

Section DlpOrbits.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f mu : nat -> 'M[R]_n) (group : 'M[R]_n -> Prop).

(** \f$f_0f_1\cdots f_{N-1}\f$. *)
Fixpoint composed_right f N : 'M[R]_n := if N is k.+1 then composed_right f k *m f k else 1%:M.

Lemma composed_right_in group f N : is_group group -> (forall k, group (f k)) -> group (composed_right f N).
Proof. by case=> [one products _ _] in_f; elim: N => [|N IH] //=; apply: products. Qed.

(** ** Several steps of the algorithm

Section 3.2: after \f$N\f$ steps of (3.17) the momentum is \f$\mathrm{Ad}^*\f$ of the product of all relative
motions, the earlier factors first: \f$\mu_N = \mathrm{Ad}^*_{f_{01}f_{12}\cdots f_{N-1,N}}\mu_0\f$. *)
Theorem claim_3_2_dlp_orbits_composed f mu N : (forall k, f k \in unitmx) ->
  (forall k, mu k.+1 = lie_poisson_update_right (f k) (mu k)) -> mu N = Ad_star (composed_right f N) (mu 0%N).
Proof.
move=> u update; have unit_composed k : composed_right f k \in unitmx.
  by elim: k => [|k IH] /=; rewrite ?unitmx1 // product_unit.
elim: N => [|N IH] /=; first by rewrite Ad_star_one.
by rewrite update /lie_poisson_update_right IH Ad_star_product.
Qed.

(** ** The momentum stays on its coadjoint orbit

Section 3.2, below (3.18): the algorithm preserves the coadjoint orbits. One element of the group joins the
first momentum with the last, whatever the relative motions are. *)
Theorem claim_3_2_dlp_orbits_of_matrices group f mu N : is_group group -> (forall k, group (f k)) ->
  (forall k, mu k.+1 = lie_poisson_update_right (f k) (mu k)) -> on_orbit group (mu 0%N) (mu N).
Proof.
move=> is_g in_f update; have [_ _ units inverses] := is_g.
exists (invmx (composed_right f N)); first by apply: inverses; apply: composed_right_in.
by rewrite invmxK; apply: claim_3_2_dlp_orbits_composed => // k; apply: units.
Qed.

(** ** Functions that are constant on orbits

Section 3.2, below (3.18): such a function keeps its value along the algorithm. *)
Theorem claim_3_2_dlp_orbits_casimirs group (T : Type) (C : 'M[R]_n -> T) f mu N : is_group group ->
  (forall k, group (f k)) -> (forall k, mu k.+1 = lie_poisson_update_right (f k) (mu k)) ->
  (forall p q, on_orbit group p q -> C q = C p) -> C (mu N) = C (mu 0%N).
Proof. by move=> is_g in_f update constant; apply: constant; apply: claim_3_2_dlp_orbits_of_matrices. Qed.

(** ** The characteristic polynomial is constant on orbits

On the dual of all matrices the coadjoint action keeps the characteristic polynomial of the covector, and with
it the trace of every power and the determinant. *)
Theorem characteristic_polynomial_on_orbits (g p : 'M[R]_n) : g \in unitmx ->
  char_poly (Ad_star g p) = char_poly p.
Proof.
move=> u; rewrite /char_poly /char_poly_mx.
have conjugates : map_mx (@polyC R) g^T *m map_mx (@polyC R) (invmx g)^T = 1%:M.
  by rewrite -map_mxM transpose_inverse // map_mx1.
have -> : 'X%:M - map_mx (@polyC R) (Ad_star g p)
    = map_mx (@polyC R) g^T *m ('X%:M - map_mx (@polyC R) p) *m map_mx (@polyC R) (invmx g)^T.
  by rewrite !map_mxM mulmxBr mulmxBl mul_mx_scalar -scalemxAl conjugates scalemx1.
by rewrite !det_mulmx mulrAC -det_mulmx conjugates det1 mul1r.
Qed.

End DlpOrbits.

Section PoissonMap.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (a b f p v w mu theta eta : 'M[R]_n) (algebra : 'M[R]_n -> Prop).

(** A field of covectors, given on dual numbers: it stands for \f$\ell'\f$. At \f$f\f$ it has the value
\f$p_0\f$, and it is _closed_ there: its derivative is a symmetric bilinear form, as the second derivative of
a function is. *)
Definition covector_at (p : 'M[dual R]_n -> 'M[dual R]_n) f p0 := forall v, value_of (p (varied f v)) = p0.
Definition closed_at (p : 'M[dual R]_n -> 'M[dual R]_n) f :=
  forall v w, pairing (rate_of (p (varied f v))) w = pairing (rate_of (p (varied f w))) v.

(** The spatial momenta at the start and at the end of a right-invariant step, \f$-R_f^*\ell'(f)\f$ and
\f$-L_f^*\ell'(f)\f$, for group elements that vary. *)
Definition varied_momentum_before (p : 'M[dual R]_n -> 'M[dual R]_n) x := - R_star x (p x).
Definition varied_momentum_after (p : 'M[dual R]_n -> 'M[dual R]_n) x := - L_star x (p x).

Section Rates.

Variables (p : 'M[dual R]_n -> 'M[dual R]_n) (f p0 : 'M[R]_n).
Hypotheses (unit_f : f \in unitmx) (at_f : covector_at p f p0) (closed : closed_at p f).

Let mu0 := - R_star f p0.

(** The second derivative, on \f$\theta f\f$ and \f$\eta f\f$. *)
Let second theta eta := pairing (rate_of (p (varied f (theta *m f)))) (eta *m f).

Lemma second_symmetric theta eta : second theta eta = second eta theta.
Proof. exact: closed. Qed.

Lemma value_before v : value_of (varied_momentum_before p (varied f v)) = mu0.
Proof.
rewrite /varied_momentum_before /R_star [p _]variedE at_f varied_transpose varied_mul varied_opp.
by rewrite value_varied.
Qed.

Lemma value_after v : value_of (varied_momentum_after p (varied f v)) = - L_star f p0.
Proof.
rewrite /varied_momentum_after /L_star [p _]variedE at_f varied_transpose varied_mul varied_opp.
by rewrite value_varied.
Qed.

Lemma rate_before theta eta :
  pairing (rate_of (varied_momentum_before p (varied f (theta *m f)))) eta
  = pairing mu0 (eta *m theta) - second theta eta.
Proof.
rewrite /varied_momentum_before /R_star [p _]variedE at_f varied_transpose varied_mul varied_opp rate_varied.
rewrite pairing_oppl pairing_addl opprD /mu0 pairing_oppl /second; congr (- _ - _).
  by rewrite trmx_mul mulmxA -/(R_star f p0) -/(R_star theta _) R_star_dual.
by rewrite -/(R_star f _) R_star_dual.
Qed.

Lemma rate_after theta eta :
  pairing (rate_of (varied_momentum_after p (varied f (theta *m f)))) eta
  = pairing mu0 (theta *m Ad f eta) - second theta (Ad f eta).
Proof.
have Ad_f : Ad f eta *m f = f *m eta by rewrite /Ad -mulmxA mulVmx // mulmx1.
rewrite /varied_momentum_after /L_star [p _]variedE at_f varied_transpose varied_mul varied_opp rate_varied.
rewrite pairing_oppl pairing_addl opprD addrC /mu0 pairing_oppl /second Ad_f; congr (- _ - _).
  rewrite -/(L_star (theta *m f) p0) L_star_dual R_star_dual /left_translation /right_translation.
  by rewrite -mulmxA -Ad_f mulmxA.
by rewrite -/(L_star f _) L_star_dual.
Qed.

End Rates.

Lemma regroup (A : zmodType) (P Q S T U V : A) :
  P - U - (V - T) = P - Q - (S - T) - (U - S - (Q - V)).
Proof.
rewrite !opprB.
have -> : P - Q + (T - S) + (Q - V + (S - U)) = P - Q + (Q - V) + (T - S + (S - U)) by rewrite addrACA.
rewrite ![_ + (Q - V)]addrA ![_ + (S - U)]addrA !subrK.
by rewrite addrACA [RHS]addrACA [- U - V]addrC.
Qed.

(** ** The discrete Lie-Poisson algorithm is a Poisson map

Proposition 3.2.1, with \f$f\f$ solved from \f$\mu\f$. The map \f$\Phi\f$ takes the momentum
\f$\mu_0 = -R_f^*\ell'(f)\f$ at the start of a step to \f$\mu_1 = -L_f^*\ell'(f) = \mathrm{Ad}_f^*\mu_0\f$ at
its end, and the functions \f$F\f$ and \f$H\f$ have the derivatives \f$a\f$ and \f$b\f$ at \f$\mu_1\f$. Let
\f$F\circ\Phi\f$ and \f$H\circ\Phi\f$ have the derivatives \f$a'\f$ and \f$b'\f$ at \f$\mu_0\f$: this means
that as \f$f\f$ varies along \f$\theta f\f$,
\f$\langle\delta\mu_0, a'\rangle = \langle\delta\mu_1, a\rangle\f$, and so for \f$b'\f$ and \f$b\f$. Then
\f[ \{F\circ\Phi, H\circ\Phi\}_+(\mu_0) = \langle\mu_0, [a', b']\rangle = \langle\mu_1, [a, b]\rangle = \{F,
H\}_+(\Phi(\mu_0)). \f]
The group may be smaller than that of all matrices: its algebra contains the differences of its elements, and
\f$\mathrm{Ad}_f\f$ keeps it. Of \f$\ell\f$ only the symmetry of its second derivative is used; it need not be
regular. *)
Theorem prop_3_2_1_of_matrices algebra (p : 'M[dual R]_n -> 'M[dual R]_n) f p0 a b a' b' : f \in unitmx ->
  covector_at p f p0 -> closed_at p f ->
  (forall x y, algebra x -> algebra y -> algebra (x - y)) -> Ad_keeps algebra f ->
  algebra a -> algebra b -> algebra a' -> algebra b' ->
  let before theta := rate_of (varied_momentum_before p (varied f (theta *m f))) in
  let after theta := rate_of (varied_momentum_after p (varied f (theta *m f))) in
  (forall theta, algebra theta -> pairing (before theta) a' = pairing (after theta) a) ->
  (forall theta, algebra theta -> pairing (before theta) b' = pairing (after theta) b) ->
  pairing (- R_star f p0) (bracket a' b') = pairing (- L_star f p0) (bracket a b).
Proof.
move=> uf at_f closed differences keeps in_a in_b in_a' in_b' /=.
set mu0 := - R_star f p0; set second := fun theta eta =>
  pairing (rate_of (p (varied f (theta *m f)))) (eta *m f).
have exchange (x y z t : R) : x - y = z - t -> y - t = x - z.
  move=> same; apply/eqP; rewrite -subr_eq0 opprB addrACA [y + z]addrC -addrACA -[y - x]opprB same.
  by rewrite subrr.
(* What the difference of a' and Ad_f a does to the second derivative. *)
have gap c c' theta : pairing (rate_of (varied_momentum_before p (varied f (theta *m f)))) c'
      = pairing (rate_of (varied_momentum_after p (varied f (theta *m f)))) c ->
    second theta (c' - Ad f c) = pairing mu0 (c' *m theta - theta *m Ad f c).
  rewrite (rate_before at_f) (rate_after uf at_f) => /exchange.
  by rewrite {1}/second mulmxBl !pairing_addr !pairing_oppr => ->.
move=> of_a of_b.
set alpha := Ad f a; set beta := Ad f b; set u := a' - alpha; set w := b' - beta.
have in_u : algebra u by apply: differences => //; apply: keeps.
have in_w : algebra w by apply: differences => //; apply: keeps.
have along_w := gap a a' w (of_a w in_w); have along_u := gap b b' u (of_b u in_u).
have vanishes : pairing mu0 (a' *m w - w *m alpha - (b' *m u - u *m beta)) = 0.
  rewrite pairing_addr pairing_oppr -along_w -along_u -/alpha -/beta -/u -/w.
  by rewrite (_ : second u w = second w u) ?subrr //; apply: closed.
have -> : pairing (- L_star f p0) (bracket a b) = pairing mu0 (bracket alpha beta).
  rewrite -Ad_bracket // -Ad_star_dual /mu0 Ad_star_opp Ad_star_right //.
apply/eqP; rewrite -subr_eq0 -pairing_oppr -pairing_addr -vanishes; apply/eqP; congr pairing.
(* Both sides are a'b' - b'a' - alpha beta + beta alpha. *)
by rewrite /u /w /bracket !mulmxBr !mulmxBl; apply: regroup.
Qed.

(** ** The same for functions

Proposition 3.2.1 on the dual of all matrices: if \f$\Phi\f$ is the discrete Lie-Poisson map near \f$\mu_0\f$,
with \f$f\f$ solved from \f$\mu\f$, then
\f$\{F\circ\Phi, H\circ\Phi\}_+(\mu_0) = \{F, H\}_+(\mathrm{Ad}^*_f\mu_0)\f$ for all differentiable functions.
*)
Theorem prop_3_2_1_functions (F H : 'M[dual R]_n -> dual R) Phi (p : 'M[dual R]_n -> 'M[dual R]_n) f p0 :
  f \in unitmx -> covector_at p f p0 -> closed_at p f ->
  (forall v, Phi (varied_momentum_before p (varied f v)) = varied_momentum_after p (varied f v)) ->
  let mu0 := - R_star f p0 in
  let mu1 := lie_poisson_update_right f mu0 in
  differentiable F mu1 -> differentiable H mu1 ->
  differentiable (F \o Phi) mu0 -> differentiable (H \o Phi) mu0 ->
  lie_poisson_bracket_plus (F \o Phi) (H \o Phi) mu0 = lie_poisson_bracket_plus F H mu1.
Proof.
move=> uf at_f closed is_step /=; rewrite /lie_poisson_update_right Ad_star_opp Ad_star_right //.
move=> dF dH dFPhi dHPhi.
have chain K : differentiable K (- L_star f p0) -> differentiable (K \o Phi) (- R_star f p0) -> forall v,
    pairing (rate_of (varied_momentum_before p (varied f v))) (differential (K \o Phi) (- R_star f p0))
    = pairing (rate_of (varied_momentum_after p (varied f v))) (differential K (- L_star f p0)).
  move=> dK dKPhi v; rewrite ![pairing (rate_of _) _]pairing_sym -dK -dKPhi /=; congr (rate (K _)).
  by rewrite -(value_after at_f v) -(value_before at_f v) -!variedE is_step.
by apply: (@prop_3_2_1_of_matrices (@all_matrices R n) p) => // theta _; apply: chain.
Qed.

(** ** The algorithm along a given sequence

Proposition 3.2.1 in its first reading, along a given sequence of \f$f\f$: the map
\f$\mu\mapsto\mathrm{Ad}^*_f\mu\f$ with \f$f\f$ fixed preserves the bracket. *)
Theorem prop_3_2_1_fixed_sequence (F H : 'M[dual R]_n -> dual R) f mu : f \in unitmx ->
  differentiable F (lie_poisson_update_right f mu) -> differentiable H (lie_poisson_update_right f mu) ->
  lie_poisson_bracket_plus (F \o Ad_star (still f)) (H \o Ad_star (still f)) mu
  = lie_poisson_bracket_plus F H (lie_poisson_update_right f mu).
Proof. exact: claim_3_2_coadjoint_lie_poisson_brackets. Qed.

End PoissonMap.

(** \f$1 + cE_{12}\f$. *)
Definition shear (S : comUnitRingType) (c : S) : 'M[S]_2 := 1%:M + c *: delta_mx 0 1.

Lemma shear_inverse (S : comUnitRingType) (c : S) : shear c *m shear (- c) = 1%:M.
Proof.
rewrite /shear mulmxDl mul1mx mulmxDr mulmx1 -scalemxAl -scalemxAr mul_delta_mx_0 // !scaler0 addr0.
by rewrite -addrA scaleNr addNr addr0.
Qed.

Lemma shear_entries (S : comUnitRingType) (c : S) :
  [/\ shear c 0 0 = 1, shear c 0 1 = c, shear c 1 0 = 0 & shear c 1 1 = 1].
Proof. by split; rewrite !mxE /= ?mulr0 ?addr0 ?add0r ?mulr1. Qed.

Lemma sum_of_two (S : comUnitRingType) (E : 'I_2 -> S) : \sum_j E j = E 0 + E 1.
Proof.
by rewrite !big_ord_recl big_ord0 addr0; congr (_ + E _); apply: val_inj.
Qed.

Lemma shear_first_row (S : comUnitRingType) (c : S) (M : 'M[S]_2) :
  Ad_star (shear c) M 0 0 = M 0 0 - c * M 0 1 /\ Ad_star (shear c) M 0 1 = M 0 1.
Proof.
have [d00 d01 d10 d11] := shear_entries (- c); have [c00 c01 c10 c11] := shear_entries c.
have top j : ((shear c)^T *m M) 0 j = M 0 j.
  by rewrite mxE sum_of_two [_^T 0 0]mxE [_^T 0 1]mxE c00 c10 mul1r mul0r addr0.
rewrite /Ad_star (inverse_unique (shear_inverse c)); split; rewrite mxE sum_of_two !top.
  by rewrite [_^T 0 0]mxE [_^T 1 0]mxE d00 d01 mulr1 mulrN mulrC.
by rewrite [_^T 0 1]mxE [_^T 1 1]mxE d10 d11 mulr0 add0r mulr1.
Qed.

(** ** Preserving the orbits is not enough

Section 3.2, below (3.18), infers from the orbits, which the algorithm preserves, that it preserves the
Poisson structure on \f$\mathfrak g^*\f$. That a map takes every \f$\mu\f$ to a point
\f$\mathrm{Ad}^*_{f(\mu)}\mu\f$ of its orbit does not imply that it preserves the bracket, not even for
polynomial maps. Take \f$f(\mu) = 1 + \mu_{11}E_{12}\f$ on 2 by 2 matrices: \f$\mu_{11}\f$ goes to \f$\mu_{11}
- \mu_{11}\mu_{12}\f$, and \f$\mu_{12}\f$ stays. At \f$\mu = E_{12}\f$, which is fixed, \f$\{\mu_{11},
\mu_{12}\}_+ = \mu_{12} = 1\f$, and after the map the bracket of the two functions is \f$\mu_{12}(1-\mu_{12})
= 0\f$. That the conclusion holds all the same, since \f$\mu_k = -R^*_{f_{k,k+1}}\ell'(f_{k,k+1})\f$, is
`prop_3_2_1_of_matrices`. *)
Theorem claim_3_2_orbits_and_bracket_printed_fails :
  ~ (forall (R : comUnitRingType) (n : nat) (Phi : 'M[dual R]_n -> 'M[dual R]_n),
     (forall mu, exists2 h, h \in unitmx & Phi mu = Ad_star h mu) ->
     forall (F H : 'M[dual R]_n -> dual R) (mu : 'M[R]_n), let image := value_of (Phi (still mu)) in
     differentiable F image -> differentiable H image ->
     differentiable (F \o Phi) mu -> differentiable (H \o Phi) mu ->
     lie_poisson_bracket_plus (F \o Phi) (H \o Phi) mu = lie_poisson_bracket_plus F H image).
Proof.
move=> printed.
pose Phi (M : 'M[dual Qc]_2) := Ad_star (shear (M 0 0)) M.
pose F (M : 'M[dual Qc]_2) := M 0 0; pose H (M : 'M[dual Qc]_2) := M 0 1.
pose mu : 'M[Qc]_2 := delta_mx 0 1.
have on_orbits M : exists2 h, h \in unitmx & Phi M = Ad_star h M.
  by exists (shear (M 0 0)) => //; have [] := mulmx1_unit (shear_inverse (M 0 0)).
have F_still v : rate ((F \o Phi) (varied mu v)) = pairing 0 v.
  by rewrite /= /F /Phi (shear_first_row _ _).1 pairing_0l !mxE /= mul0r mulr1 add0r subrr.
have H_moves v : rate ((H \o Phi) (varied mu v)) = pairing mu v.
  by rewrite /= /H /Phi (shear_first_row _ _).2 !mxE /= pairing_sym pairing_unit_matrix.
have fixed : value_of (Phi (still mu)) = mu.
  have no_shear : still mu 0 0 = 0 by rewrite mxE; apply: dual_equal; rewrite /= mxE.
  by rewrite /Phi no_shear /shear scale0r addr0 Ad_star_one value_varied.
have := printed _ _ Phi on_orbits F H mu; rewrite /= fixed => /(_ (differentiable_entry _ _ _)).
move=> /(_ (differentiable_entry _ _ _) (differentiable_is F_still) (differentiable_is H_moves)).
have entry_differential i j (f : 'M[Qc]_2) : differential (fun x => x i j) f = delta_mx i j.
  by apply: differential_is => v; rewrite mxE pairing_sym pairing_unit_matrix.
rewrite /lie_poisson_bracket_plus (differential_is F_still) !entry_differential.
rewrite /bracket mul0mx mulmx0 subrr pairing_0r mul_delta_mx mul_delta_mx_0 // subr0 pairing_unit_matrix.
by rewrite mxE.
Qed.
