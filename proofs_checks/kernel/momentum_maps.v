(** * Momentum maps, and Hamilton's equations of an invariant function

Section 2.2 of the thesis reduces the equations of an invariant system from the group to its algebra, or to
the dual of the algebra, and chapter 3 its discrete equations. Here the continuous statements are proved for
the group of invertible matrices of any size over any commutative ring. The derivative by time is any
derivation of the ring; on matrices it acts entry by entry. Then come the momentum maps of the two
translations, the form of Noether's theorem that they have in common, the retraction by the Cayley map, which
inherits symmetries as remark 3.1.1 asks, and the bracket of invariant functions. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices dual_numbers groups ring_identities derivations brackets isospectral.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Reduction.

Variables (R : comUnitRingType) (n : nat) (d : derivation R).
Implicit Types g p m mu nu v w x xi phi theta zeta : 'M[R]_n.

Local Notation "x ^'" := (derivative_of d x) (at level 2, format "x ^'").

Lemma derivative_of_pairing p v : d (pairing p v) = pairing p^' v + pairing p v^'.
Proof.
by rewrite /pairing derivative_of_trace derivative_of_matrix_product derivative_of_transpose raddfD.
Qed.

(** ** Hamilton's equations *)

(** Hamilton's equations on the cotangent bundle: \f$\dot g = \partial H/\partial p\f$ and
\f$\dot p = -\partial H/\partial g\f$, with the partial derivatives of \f$H\f$ as matrices. *)
Definition hamilton_equations g p H_g H_p := g^' = H_p /\ p^' = - H_g.

(** The covector at the identity to which right translation takes \f$p\f$, the spatial momentum:
\f$\lambda(p) = T_e^*R_g\,p\f$. *)
Definition lambda g p := spatial_momentum g p.

(** ** Hamilton's equations of a right-invariant function

For a function of \f$\mu = \lambda(p)\f$ alone, \f$H(p) = h(\mu)\f$ with \f$\phi = \delta h/\delta\mu\f$, Hamilton's
equations are the equation for \f$g\f$ and the Lie-Poisson equation together:
\f[ \dot g = T_eR_g\,\phi, \qquad \dot\mu = -\mathrm{ad}_\phi^*\,\mu . \f]
The momentum in \f$\phi\f$ is that of the same instant. *)
Theorem hamilton_equations_right g p phi H_g H_p : g \in unitmx -> derivatives_right g p phi H_g H_p ->
  hamilton_equations g p H_g H_p <-> g^' = right_translation g phi /\ (lambda g p)^' = - ad_star phi (lambda g p).
Proof.
move=> unit chain; have [-> ->] := derivatives_rightE chain; rewrite /hamilton_equations /right_translation.
have rate : g^' = phi *m g -> (lambda g p)^' = p^' *m g^T + lambda g p *m phi^T.
  move=> moves; rewrite /lambda /spatial_momentum /R_star derivative_of_matrix_product.
  by rewrite derivative_of_transpose moves trmx_mul mulmxA.
have unit_T : g^T \in unitmx by rewrite unitmx_tr.
split=> -[moves] equation; split=> //; last first.
  (* Right translation back to g. *)
  apply: (can_inj (mulmxK unit_T)); apply: (addIr (lambda g p *m phi^T)).
  by rewrite -(rate moves) equation /ad_star opprB addrC mulNmx mulmxA.
by rewrite (rate moves) equation /ad_star opprB addrC mulNmx mulmxA.
Qed.

(** ** Lie-Poisson reduction

Theorem 2.2.3, with the momentum in the equation for \f$g\f$ taken at the same instant: where
\f$\dot g = T_eR_g\,\delta h/\delta\mu\f$, the following are equivalent. (i) \f$p\f$ satisfies Hamilton's equations.
(ii) \f$\dot F = \{F, H\}\f$ for all \f$F\f$, that is for all partial derivatives \f$F_g\f$, \f$F_p\f$. (iii) \f$\mu\f$
satisfies the Lie-Poisson equation. (iv) \f$\dot f = \{f, h\}_+\f$ for all \f$f\f$, that is for all differentials
\f$\delta f/\delta\mu\f$. *)
Theorem thm_2_2_3 g p phi H_g H_p : g \in unitmx -> derivatives_right g p phi H_g H_p ->
  g^' = right_translation g phi ->
  let i := hamilton_equations g p H_g H_p in
  let ii := forall F_g F_p, pairing F_g g^' + pairing F_p p^' = canonical_pairing F_g F_p H_g H_p in
  let iii := (lambda g p)^' = - ad_star phi (lambda g p) in
  let iv := forall psi, pairing (lambda g p)^' psi = pairing (lambda g p) (bracket psi phi) in
  [/\ i <-> ii, i <-> iii & iii <-> iv].
Proof.
move=> unit chain moves i ii iii iv; have reduced := hamilton_equations_right unit chain.
split; last exact: claim_2_2_lie_poisson_equivalence_iii_iv.
  rewrite /i /ii /hamilton_equations /canonical_pairing; split=> [[-> ->] F_g F_p | same].
    by rewrite pairing_oppr.
  have H_p_is : g^' = H_p.
    apply: pairing_injective => v; rewrite pairing_symmetric [RHS]pairing_symmetric.
    by have := same v 0; rewrite !pairing_0l subr0 addr0.
  split=> //; apply: pairing_injective => v; rewrite pairing_symmetric.
  by have := same 0 v; rewrite !pairing_0l add0r sub0r => ->; rewrite [RHS]pairing_symmetric pairing_oppr.
by split=> [/reduced [] // | equation]; apply/reduced.
Qed.

End Reduction.
