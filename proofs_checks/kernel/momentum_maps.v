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

(* Hamilton's equations of a function of the spatial momentum alone. *)
Lemma hamilton_equations_right g p phi H_g H_p : g \in unitmx -> derivatives_right g p phi H_g H_p ->
  hamilton_equations g p H_g H_p <->
  g^' = right_translation g phi /\ (lambda g p)^' = - ad_star phi (lambda g p).
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

(* The partial derivatives of a right-invariant function are what the chain rule makes them. *)
Lemma derivatives_of_right_function g p phi : derivatives_right g p phi (phi^T *m p) (phi *m g).
Proof.
move=> dg dp; rewrite pairing_addl R_star_dual R_star_dual addrC -/(L_star phi p) L_star_dual.
by rewrite /right_translation /left_translation pairing_sym.
Qed.

(** ** Hamilton's equations, Lie-Poisson equations and brackets

For a right-invariant Hamiltonian, \f$H(p) = h(\mu)\f$ with \f$\mu = \lambda(p)\f$ and
\f$\phi = \delta h/\delta\mu\f$ at the same instant. Hamilton's equations say the same as
\f$\dot F = \{F, H\}\f$ for all \f$F\f$, that is for all partial derivatives \f$F_g\f$, \f$F_p\f$. They also
say the same as the equation for \f$g\f$ and the Lie-Poisson equation together,
\f[ \dot g = T_eR_g\,\phi, \qquad \dot\mu = -\mathrm{ad}_\phi^*\,\mu , \f]
and the second of these the same as \f$\dot f = \{f, h\}_+\f$ for all \f$f\f$, that is for all differentials
\f$\psi = \delta f/\delta\mu\f$. *)
Theorem claim_2_2_lie_poisson_equivalence_of_matrices g p phi H_g H_p :
  g \in unitmx -> derivatives_right g p phi H_g H_p ->
  let hamilton := hamilton_equations g p H_g H_p in
  let lie_poisson := (lambda g p)^' = - ad_star phi (lambda g p) in
  [/\ hamilton <-> forall F_g F_p, pairing F_g g^' + pairing F_p p^' = canonical_pairing F_g F_p H_g H_p,
      hamilton <-> g^' = right_translation g phi /\ lie_poisson
    & lie_poisson <-> forall psi, pairing (lambda g p)^' psi = pairing (lambda g p) (bracket psi phi)].
Proof.
move=> unit chain hamilton lie_poisson.
split; [| exact: hamilton_equations_right | exact: claim_2_2_lie_poisson_equivalence_iii_iv].
rewrite /hamilton /hamilton_equations /canonical_pairing; split=> [[-> ->] F_g F_p | same].
  by rewrite pairing_oppr.
have H_p_is : g^' = H_p.
  apply: pairing_injective => v; rewrite pairing_symmetric [RHS]pairing_symmetric.
  by have := same v 0; rewrite !pairing_0l subr0 addr0.
split=> //; apply: pairing_injective => v; rewrite pairing_symmetric.
by have := same 0 v; rewrite !pairing_0l add0r sub0r => ->; rewrite [RHS]pairing_symmetric pairing_oppr.
Qed.

(** ** Lie-Poisson reduction

Theorem 2.2.3, with the momentum in the equation for \f$g\f$ taken at the same instant: where
\f$\dot g = T_eR_g\,\delta h/\delta\mu\f$, the following are equivalent. (i) \f$p\f$ satisfies Hamilton's
equations. (ii) \f$\dot F = \{F, H\}\f$ for all \f$F\f$. (iii) \f$\mu\f$ satisfies the Lie-Poisson equation.
(iv) \f$\dot f = \{f, h\}_+\f$ for all \f$f\f$. *)
Theorem thm_2_2_3_of_matrices g p phi H_g H_p : g \in unitmx -> derivatives_right g p phi H_g H_p ->
  g^' = right_translation g phi ->
  let i := hamilton_equations g p H_g H_p in
  let ii := forall F_g F_p, pairing F_g g^' + pairing F_p p^' = canonical_pairing F_g F_p H_g H_p in
  let iii := (lambda g p)^' = - ad_star phi (lambda g p) in
  let iv := forall psi, pairing (lambda g p)^' psi = pairing (lambda g p) (bracket psi phi) in
  [/\ i <-> ii, i <-> iii & iii <-> iv].
Proof.
move=> unit chain moves i ii iii iv.
have [one two three] := claim_2_2_lie_poisson_equivalence_of_matrices unit chain.
by split=> //; split=> [/two [] // | equation]; apply/two.
Qed.

(** ** Which momentum moves the group element

Along Hamilton's equations of a right-invariant function \f$\dot g = T_eR_g\,\delta h/\delta\mu\f$ with
\f$\mu = \lambda(p)\f$ at the same instant. *)
Theorem claim_2_2_reconstruction_velocity_of_matrices g p phi H_g H_p : g \in unitmx ->
  derivatives_right g p phi H_g H_p -> hamilton_equations g p H_g H_p -> g^' = right_translation g phi.
Proof. by move=> unit chain /(hamilton_equations_right unit chain) []. Qed.

(** ** The Euler-Lagrange equations of an invariant Lagrangian *)

(** The partial derivatives of \f$L(g, \dot g) = l(\dot gg^{-1})\f$, where \f$m = \delta l/\delta\xi\f$ at
\f$\xi = \dot gg^{-1}\f$: the chain rule, with
\f$\delta(\dot gg^{-1}) = (\delta\dot g - \xi\,\delta g)g^{-1}\f$. *)
Definition derivatives_of_right_lagrangian g xi m L_g L_v :=
  forall dg dv, pairing L_g dg + pairing L_v dv = pairing m ((dv - xi *m dg) *m invmx g).

(** The same for \f$L(g, \dot g) = l(g^{-1}\dot g)\f$ at \f$\xi = g^{-1}\dot g\f$. *)
Definition derivatives_of_left_lagrangian g xi m L_g L_v :=
  forall dg dv, pairing L_g dg + pairing L_v dv = pairing m (invmx g *m (dv - dg *m xi)).

Lemma derivatives_of_right_lagrangianE g xi m L_g L_v :
  derivatives_of_right_lagrangian g xi m L_g L_v ->
  L_v = R_star (invmx g) m /\ L_g = - (xi^T *m R_star (invmx g) m).
Proof.
move=> chain; split; apply: pairing_injective => v.
  by have := chain 0 v; rewrite pairing_0r add0r mulmx0 subr0 R_star_dual => ->.
have := chain v 0; rewrite pairing_0r addr0 sub0r mulNmx pairing_oppr => ->.
by rewrite pairing_oppl -/(L_star xi _) L_star_dual R_star_dual.
Qed.

Lemma derivatives_of_left_lagrangianE g xi m L_g L_v :
  derivatives_of_left_lagrangian g xi m L_g L_v ->
  L_v = L_star (invmx g) m /\ L_g = - (L_star (invmx g) m *m xi^T).
Proof.
move=> chain; split; apply: pairing_injective => v.
  by have := chain 0 v; rewrite pairing_0r add0r mul0mx subr0 L_star_dual => ->.
have := chain v 0; rewrite pairing_0r addr0 sub0r mulmxN pairing_oppr => ->.
by rewrite pairing_oppl -/(R_star xi _) R_star_dual L_star_dual.
Qed.

Lemma derivative_of_transposed_inverse g : g \in unitmx ->
  (invmx g)^T^' = - ((invmx g)^T *m (g^')^T *m (invmx g)^T).
Proof.
move=> unit; rewrite derivative_of_transpose derivative_of_inverse_matrix // raddfN /=.
by rewrite !trmx_mul mulmxA.
Qed.

(** ** The Euler-Poincare equations are the Euler-Lagrange equations

Theorem 2.2.1, i and iii: with \f$\dot g = \xi g\f$ and \f$m = \delta l/\delta\xi\f$,
\f[ \frac{d}{dt}\frac{\partial L}{\partial\dot g} = \frac{\partial L}{\partial g}
\quad\Longleftrightarrow\quad \frac{dm}{dt} = -\mathrm{ad}_\xi^*\,m . \f]
The Lagrangian need not be regular. *)
Theorem claim_2_2_euler_poincare_equations_of_matrices g xi m L_g L_v : g \in unitmx ->
  g^' = right_translation g xi ->
  derivatives_of_right_lagrangian g xi m L_g L_v -> L_v^' = L_g <-> m^' = - ad_star xi m.
Proof.
move=> unit moves /derivatives_of_right_lagrangianE [-> ->].
have back : (invmx g)^T \in unitmx by rewrite unitmx_tr unitmx_inv.
(* The momentum m g^{-T} has the derivative (m' - m xi^T) g^{-T}. *)
have rate : (R_star (invmx g) m)^' = (m^' - m *m xi^T) *m (invmx g)^T.
  rewrite /R_star derivative_of_matrix_product derivative_of_transposed_inverse // moves /right_translation.
  rewrite trmx_mul mulmxN mulmxBl !mulmxA -[m *m _ *m g^T]mulmxA -trmx_mul mulmxV //.
  by rewrite trmx1 mulmx1.
have cancel (X Y : 'M[R]_n) : X *m (invmx g)^T = Y *m (invmx g)^T -> X = Y.
  by move=> same; apply: (can_inj (mulmxK back)).
rewrite rate /R_star mulmxA -[- (_ *m (invmx g)^T)]mulNmx /ad_star opprB; split=> [/cancel /eqP | ->].
  by rewrite subr_eq addrC => /eqP.
by rewrite addrAC subrr add0r.
Qed.

(** ** The Euler-Poincare equations on the left

For \f$L(g, \dot g) = l(g^{-1}\dot g)\f$ and \f$\dot g = g\xi\f$ the sign is the other:
\f$\dot m = \mathrm{ad}_\xi^*\,m\f$. *)
Theorem claim_2_2_left_reduction_euler_poincare g xi m L_g L_v : g \in unitmx ->
  g^' = left_translation g xi -> derivatives_of_left_lagrangian g xi m L_g L_v ->
  L_v^' = L_g <-> m^' = ad_star xi m.
Proof.
move=> unit moves /derivatives_of_left_lagrangianE [-> ->].
have back : (invmx g)^T \in unitmx by rewrite unitmx_tr unitmx_inv.
have rate : (L_star (invmx g) m)^' = (invmx g)^T *m (m^' - xi^T *m m).
  rewrite /L_star derivative_of_matrix_product derivative_of_transposed_inverse // moves /left_translation.
  rewrite trmx_mul mulNmx mulmxBr !mulmxA addrC; congr (_ - _).
  have one : g^T *m (invmx g)^T = 1%:M by rewrite -trmx_mul mulVmx // trmx1.
  by rewrite -[_ *m g^T *m (invmx g)^T]mulmxA one mulmx1.
have cancel (X Y : 'M[R]_n) : (invmx g)^T *m X = (invmx g)^T *m Y -> X = Y.
  by move=> same; apply: (can_inj (mulKmx back)).
rewrite rate /L_star -mulmxA -[- (_ *m (m *m _))]mulmxN /ad_star; split=> [/cancel /eqP | ->].
  by rewrite subr_eq addrC => /eqP.
by rewrite addrAC subrr add0r.
Qed.

(** ** Euler-Poincare and Lie-Poisson equations

Let \f$h + l = \langle\mu, \xi\rangle\f$. Then \f$\mu = \delta l/\delta\xi\f$ if and only if
\f$\xi = \delta h/\delta\mu\f$, each read as the chain rule for every derivation of the ring. So the
Euler-Poincare equation of \f$l\f$ is the Lie-Poisson equation of \f$h\f$, with either sign, and Legendre's
transformation goes both ways. *)
Definition is_velocity_derivative (l : R) xi mu :=
  forall c : derivation R, c l = pairing mu (derivative_of c xi).
Definition is_momentum_derivative (h : R) mu xi :=
  forall c : derivation R, c h = pairing (derivative_of c mu) xi.

Theorem claim_2_2_euler_poincare_lie_poisson (l h : R) xi mu : h + l = pairing mu xi ->
  let euler_poincare := is_velocity_derivative l xi mu in
  let lie_poisson := is_momentum_derivative h mu xi in
  [/\ euler_poincare <-> lie_poisson,
      euler_poincare /\ mu^' = - ad_star xi mu <-> lie_poisson /\ mu^' = - ad_star xi mu
    & euler_poincare /\ mu^' = ad_star xi mu <-> lie_poisson /\ mu^' = ad_star xi mu].
Proof.
move=> legendre euler_poincare lie_poisson.
have same : euler_poincare <-> lie_poisson.
  split=> chain c; have := congr1 c legendre; rewrite raddfD /pairing derivative_of_trace.
    rewrite derivative_of_matrix_product derivative_of_transpose raddfD /= chain -/(pairing _ _).
    by move/addIr.
  rewrite derivative_of_matrix_product derivative_of_transpose raddfD /= chain -/(pairing _ _).
  by move/addrI.
by split=> //; split=> -[chain equation]; split=> //; apply/same.
Qed.

End Reduction.

(** ** A motion in which the velocity changes *)

Section Example.

Variables (R : comUnitRingType) (d : derivation R) (t : R).
Hypothesis time : d t = 1.

(* The matrix with three given rows; what is not given is zero. *)
Let rows (r : seq (seq R)) : 'M[R]_3 := \matrix_(i, j) nth 0 (nth [::] r i) j.

Ltac entries := apply/matrixP; case=> [] [|[|[|?]]] // ?; case=> [] [|[|[|?]]] // ?.

(** The function \f$h = 3\mu_{12}^2 + \mu_{23}\f$ of matrices with three rows, and its derivative. *)
Definition example_hamiltonian (mu : 'M[R]_3) := 3%:R * (mu 0 1 * mu 0 1) + mu 1 2%:R.
Definition example_velocity (mu : 'M[R]_3) : 'M[R]_3 := (6%:R * mu 0 1) *: delta_mx 0 1 + delta_mx 1 2%:R.

Lemma example_velocity_entry mu : example_velocity mu 0 1 = 6%:R * mu 0 1.
Proof. by rewrite !mxE /= mulr1 addr0. Qed.

(** A motion in the time \f$t\f$ that begins at the identity. *)
Definition example_g := rows [:: [:: 1; 3%:R * (t * t); 2%:R * (t * t * t)]; [:: 0; 1; t]; [:: 0; 0; 1]].
Definition example_p := rows [:: [:: 0; 0; 1]; [:: 0; 0; - (3%:R * (t * t))]; [:: 0; 0; t * t * t]].

Lemma delta_left (i j : 'I_3) (M : 'M[R]_3) : delta_mx i j *m M = \matrix_(k, l) (M j l *+ (k == i)).
Proof.
apply/matrixP => k l; rewrite !mxE (bigD1 j) //= mxE eqxx andbT mulr_natl big1 ?addr0 // => m ne.
by rewrite mxE (negbTE ne) andbF mul0r.
Qed.

Lemma example_derivative mu : is_momentum_derivative (example_hamiltonian mu) mu (example_velocity mu).
Proof.
move=> c; rewrite /example_hamiltonian /example_velocity pairing_addr pairing_sym pairing_scalel pairing_sym.
by rewrite !pairing_unit_matrix !mxE raddfD /= !leibniz derivative_of_nat; ring_identity.
Qed.

Lemma example_unit : example_g \in unitmx.
Proof.
have: example_g *m rows [:: [:: 1; - (3%:R * (t * t)); t * t * t]; [:: 0; 1; - t]; [:: 0; 0; 1]] = 1%:M.
  by entries; rewrite !(mxE, big_ord_recl, big_ord0) /=; ring_identity.
by case/mulmx1_unit.
Qed.

Lemma example_motion : let phi := example_velocity (lambda example_g example_p) in
  hamilton_equations d example_g example_p (phi^T *m example_p) (phi *m example_g).
Proof.
move=> phi; have -> : phi = (6%:R * t) *: delta_mx 0 1 + delta_mx 1 2%:R.
  rewrite /phi /example_velocity /lambda /spatial_momentum /R_star; congr ((_ * _) *: _ + _).
  by rewrite !(mxE, big_ord_recl, big_ord0) /=; ring_identity.
rewrite [(_ + _)^T]raddfD /= linearZ /= !trmx_delta !mulmxDl -!scalemxAl !delta_left.
by split; entries; rewrite !mxE /= ?raddfN /= ?leibniz ?derivative_of_nat ?derivative_of_one ?raddf0 ?time;
  ring_identity.
Qed.

Lemma example_equation : let mu := lambda example_g example_p in
  derivative_of d mu = - ad_star (example_velocity mu) mu.
Proof.
move=> mu; have chain := derivatives_of_right_function example_g example_p (example_velocity mu).
exact: ((hamilton_equations_right d example_unit chain).1 example_motion).2.
Qed.

(* The momentum of that motion, and another motion of the group element: that of the momentum at time 0. *)
Lemma example_momentum : lambda example_g example_p 0 1 = t /\ lambda example_g example_p 0 2%:R = 1.
Proof.
by rewrite /lambda /spatial_momentum /R_star !(mxE, big_ord_recl, big_ord0) /=; split; ring_identity.
Qed.

Definition frozen_g : 'M[R]_3 := 1%:M + t *: delta_mx 1 2%:R.
Definition frozen_p := lambda example_g example_p *m (1%:M - t *: delta_mx 2%:R 1).

Lemma frozen_product : frozen_g *m (1%:M - t *: delta_mx 1 2%:R) = 1%:M.
Proof.
have square : delta_mx 1 2%:R *m (delta_mx 1 2%:R : 'M[R]_3) = 0 :> 'M[R]_3 by rewrite mul_delta_mx_0.
rewrite /frozen_g mulmxDl mul1mx mulmxBr mulmx1 -scalemxAl -scalemxAr square !scaler0 subr0.
by rewrite subrK.
Qed.

Lemma frozen_momentum : lambda frozen_g frozen_p = lambda example_g example_p.
Proof.
rewrite {1}/lambda /spatial_momentum /R_star /frozen_p -mulmxA.
have -> : 1%:M - t *: delta_mx 2%:R 1 = (1%:M - t *: delta_mx 1 2%:R)^T :> 'M[R]_3.
  by rewrite raddfB /= trmx1 [(t *: _)^T]linearZ /= trmx_delta.
by rewrite -trmx_mul frozen_product trmx1 mulmx1.
Qed.

(* The momentum at time 0 is that of the motion above. *)
Lemma frozen_start : frozen_p 0 1 = 0.
Proof.
have [] := example_momentum; rewrite /frozen_p; move: (lambda _ _) => mu entry_t entry_1.
rewrite mulmxBr mulmx1 -scalemxAr !mxE entry_t (bigD1 2%:R) //= !mxE entry_1.
by rewrite big1 ?addr0 ?mulr1 ?subrr // => k ne; rewrite !mxE (negbTE ne) mulr0.
Qed.

Lemma frozen_velocity : derivative_of d frozen_g = delta_mx 1 2%:R *m frozen_g.
Proof.
rewrite /frozen_g mulmxDr mulmx1 -scalemxAr mul_delta_mx_cond mulr0n scaler0 addr0.
apply/matrixP => i j; rewrite !mxE raddfD /= leibniz time mul1r.
by case: (i == j); case: (_ && _); rewrite ?derivative_of_one ?raddf0 ?mulr0 ?addr0 ?add0r.
Qed.

End Example.

(** ** The momentum at the start does not move the group element

Theorem 2.2.3 prints \f$\dot g = T_eR_g\frac{\delta h}{\delta\mu}\f$ with \f$\mu = p(0)\f$. The ring of the
counterexample is that of polynomials in the time \f$t\f$ with integer coefficients, and \f$p(0)\f$ has the
values of the polynomials at 0. The Hamiltonian is \f$h = 3\mu_{12}^2 + \mu_{23}\f$ on matrices with three
rows, the motion begins at the identity,
\f[ g = \begin{pmatrix} 1 & 3t^2 & 2t^3 \\ 0 & 1 & t \\ 0 & 0 & 1 \end{pmatrix} , \f]
and \f$\dot g_{12} = 6t\f$, which at \f$\mu = p(0)\f$ would be zero. *)

Local Notation polynomials := [comUnitRingType of {poly int}].

Definition at_time_zero n (p : 'M[polynomials]_n) : 'M[polynomials]_n :=
  map_mx (fun q : {poly int} => q.[0]%:P) p.

Definition time_derivative : derivation polynomials := polynomial_derivative [comRingType of int].

Theorem claim_2_2_reconstruction_velocity_printed_fails :
  ~ (forall n (h : 'M[polynomials]_n -> polynomials) (dh : 'M[polynomials]_n -> 'M[polynomials]_n)
            g p H_g H_p,
      (forall mu, is_momentum_derivative (h mu) mu (dh mu)) ->
      g \in unitmx -> derivatives_right g p (dh (lambda g p)) H_g H_p ->
      hamilton_equations time_derivative g p H_g H_p ->
      derivative_of time_derivative g = right_translation g (dh (at_time_zero p))).
Proof.
move=> printed; pose t : polynomials := 'X; have time : time_derivative t = 1 by apply: derivX.
have := printed _ _ _ _ _ _ _ (@example_derivative polynomials) (example_unit t)
  (derivatives_of_right_function _ _ _) (example_motion time).
rewrite /right_translation /example_velocity mulmxDl -scalemxAl !delta_left => /matrixP/(_ 0 1).
rewrite !mxE /= hornerC mulr0 mul0r add0r mulr0n => /(congr1 (fun q : {poly int} => q.[1])).
by rewrite /t !derivE !hornerE.
Qed.

(** ** The equivalence as printed

Where the group element moves by the momentum at time 0, as Theorem 2.2.3 prints it, the Lie-Poisson equation
(iii) does not bring Hamilton's equations (i) with it. With the momentum \f$\mu(t)\f$ of the motion above and
\f[ g = \begin{pmatrix} 1 & 0 & 0 \\ 0 & 1 & t \\ 0 & 0 & 1 \end{pmatrix}, \qquad p = \mu\,g^{-T}, \f]
the printed hypothesis and (iii) hold, and (i) does not. *)
Theorem thm_2_2_3_printed_fails :
  ~ (forall n (h : 'M[polynomials]_n -> polynomials) (dh : 'M[polynomials]_n -> 'M[polynomials]_n)
            g p H_g H_p,
      (forall mu, is_momentum_derivative (h mu) mu (dh mu)) ->
      g \in unitmx -> derivatives_right g p (dh (lambda g p)) H_g H_p ->
      derivative_of time_derivative g = right_translation g (dh (at_time_zero p)) ->
      hamilton_equations time_derivative g p H_g H_p <->
      derivative_of time_derivative (lambda g p) = - ad_star (dh (lambda g p)) (lambda g p)).
Proof.
move=> printed; pose t : polynomials := 'X; have time : time_derivative t = 1 by apply: derivX.
have unit := (mulmx1_unit (frozen_product t)).1.
have chain := derivatives_of_right_function (frozen_g t) (frozen_p t)
  (example_velocity (lambda (frozen_g t) (frozen_p t))).
have frozen : derivative_of time_derivative (frozen_g t) =
    right_translation (frozen_g t) (example_velocity (at_time_zero (frozen_p t))).
  rewrite (frozen_velocity time) /right_translation; congr (_ *m _).
  by rewrite /example_velocity mxE frozen_start horner0 mulr0 scale0r add0r.
have [_ back] := printed _ _ _ _ _ _ _ (@example_derivative polynomials) unit chain frozen.
have equation : derivative_of time_derivative (lambda (frozen_g t) (frozen_p t)) =
    - ad_star (example_velocity (lambda (frozen_g t) (frozen_p t))) (lambda (frozen_g t) (frozen_p t)).
  by rewrite !frozen_momentum; apply: example_equation.
have [moves _] := back equation.
have same : delta_mx 1 2%:R = example_velocity (lambda (example_g t) (example_p t)).
  by apply: (can_inj (mulmxK unit)); rewrite -(frozen_velocity time) moves frozen_momentum.
move/matrixP/(_ 0 1): same; rewrite example_velocity_entry (example_momentum t).1 mxE /=.
by move/(congr1 (fun q : {poly int} => q.[1])); rewrite /t !hornerE.
Qed.

(** ** Momentum maps of the two translations *)

Section Translations.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g h k m p mu theta zeta xi eta x y z A : 'M[R]_n.

(** ** The momentum maps

The generator of \f$g\mapsto e^{t\zeta}g\f$ at \f$g\f$ is \f$\zeta g\f$, that of \f$g\mapsto ge^{t\zeta}\f$ is
\f$g\zeta\f$. So the momentum map of multiplication from the left is the spatial momentum, that of
multiplication from the right the body momentum:
\f[ \langle R_g^*p, \zeta\rangle = \langle p, \zeta g\rangle, \qquad
\langle L_g^*p, \zeta\rangle = \langle p, g\zeta\rangle . \f] *)
Theorem momentum_maps_of_translations g p zeta :
  pairing (spatial_momentum g p) zeta = pairing p (right_translation g zeta) /\
  pairing (body_momentum g p) zeta = pairing p (left_translation g zeta).
Proof. by rewrite R_star_dual L_star_dual. Qed.

(** ** Equivariance of the momentum maps

Multiplication from the left by \f$h\f$ takes a covector \f$p\f$ at \f$g\f$ to \f$L_{h^{-1}}^*p\f$ at
\f$hg\f$. It leaves the body momentum as it is and turns the spatial momentum by \f$\mathrm{Ad}_{h^{-1}}^*\f$.
Multiplication from the right by \f$k\f$ leaves the spatial momentum as it is and turns the body momentum by
\f$\mathrm{Ad}_k^*\f$. *)
Theorem momentum_maps_equivariant g p h k : h \in unitmx -> k \in unitmx ->
  [/\ body_momentum (h *m g) (L_star (invmx h) p) = body_momentum g p,
      spatial_momentum (h *m g) (L_star (invmx h) p) = Ad_star (invmx h) (spatial_momentum g p),
      spatial_momentum (g *m k) (R_star (invmx k) p) = spatial_momentum g p
    & body_momentum (g *m k) (R_star (invmx k) p) = Ad_star k (body_momentum g p)].
Proof.
move=> unit_h unit_k.
have one : h^T *m (invmx h)^T = 1%:M by rewrite -trmx_mul mulVmx // trmx1.
have two : (invmx k)^T *m k^T = 1%:M by rewrite -trmx_mul mulmxV // trmx1.
split; rewrite /body_momentum /spatial_momentum /Ad_star /L_star /R_star ?invmxK !trmx_mul.
- by rewrite mulmxA -[_ *m h^T *m _]mulmxA one mulmx1.
- by rewrite !mulmxA.
- by rewrite -mulmxA [X in p *m X]mulmxA two mul1mx.
by rewrite !mulmxA.
Qed.

(** ** Spatial and body momenta commute

The canonical bracket of a function of the spatial momentum with a function of the body momentum vanishes. So
each is conserved by every Hamiltonian of the other, and the plus bracket and the minus bracket live side by
side on the cotangent bundle. *)
Theorem spatial_and_body_momenta_commute g p phi psi F_g F_p H_g H_p :
  derivatives_right g p phi F_g F_p -> derivatives_left g p psi H_g H_p ->
  canonical_pairing F_g F_p H_g H_p = 0.
Proof.
case/derivatives_rightE => -> ->; case/derivatives_leftE => -> ->.
(* Both terms are the trace of phi g psi p^T. *)
rewrite /canonical_pairing /pairing [X in X - _]mxtrace_mulC -[X in _ - X]mxtrace_tr !trmx_mul !trmxK.
by rewrite [X in X - _]mxtrace_mulC [X in _ - X]mxtrace_mulC -!mulmxA [X in X - _]mxtrace_mulC -!mulmxA subrr.
Qed.

(** ** Noether's theorem along a curve

Let \f$p = \partial L/\partial\dot g\f$ and \f$q = \partial L/\partial g\f$ along a curve, and let
\f$\vartheta\f$ be the generator of a symmetry along it. Off shell
\f[ \frac{d}{dt}\langle p, \vartheta\rangle = \langle\dot p - q, \vartheta\rangle
+ \bigl(\langle q, \vartheta\rangle + \langle p, \dot\vartheta\rangle\bigr) , \f]
where the last bracket is the change of \f$L\f$ under the symmetry. Where it vanishes and the Euler-Lagrange
equation holds, the momentum \f$J = \langle p, \vartheta\rangle\f$ is constant.
C++: `actio::noether_momentum`, `variational/momentum_map.hpp`. *)
Definition noether_momentum p theta := pairing p theta.

Theorem claim_2_1_noether_momentum_of_matrices (d : derivation R) p q theta :
  d (noether_momentum p theta) =
    pairing (derivative_of d p - q) theta + (pairing q theta + pairing p (derivative_of d theta)) /\
  (pairing q theta + pairing p (derivative_of d theta) = 0 -> derivative_of d p = q ->
   d (noether_momentum p theta) = 0).
Proof.
rewrite /noether_momentum derivative_of_pairing pairing_addl pairing_oppl; split=> [|invariance equation].
  by rewrite addrA subrK.
by rewrite equation.
Qed.

(** Where a translation \f$T\f$ of velocities, whose dual has the inverse \f$P\f$, takes one differential to
another, both partial derivatives go along by \f$P\f$, and with them the two sides of an equation
\f$\frac{d}{dt}L_v = L_g\f$. *)
Lemma equations_go_along (d : derivation R) (T P : 'M[R]_n -> 'M[R]_n) L_g L_v M_g M_v :
  T 0 = 0 -> (forall p q, (forall v, pairing p (T v) = pairing q v) -> p = P q) ->
  (forall p q, P (p - q) = P p - P q) -> injective P ->
  (forall p, derivative_of d (P p) = P (derivative_of d p)) ->
  (forall dg dv, pairing M_g (T dg) + pairing M_v (T dv) = pairing L_g dg + pairing L_v dv) ->
  derivative_of d M_v - M_g = P (derivative_of d L_v - L_g) /\
  (derivative_of d M_v = M_g <-> derivative_of d L_v = L_g).
Proof.
move=> T_0 moved difference injective constant same.
have -> : M_g = P L_g by apply: moved => v; have := same v 0; rewrite T_0 !pairing_0r !addr0.
have -> : M_v = P L_v by apply: moved => v; have := same 0 v; rewrite T_0 !pairing_0r !add0r.
by rewrite constant difference; split=> //; split=> [/injective | ->].
Qed.

(** ** A symmetry takes solutions to solutions

Let multiplication from the right by a constant \f$k\f$ leave the Lagrangian as it is,
\f$L(gk, \dot gk) = L(g, \dot g)\f$, so that its partial derivatives \f$M_g\f$, \f$M_v\f$ at
\f$(gk, \dot gk)\f$ and \f$L_g\f$, \f$L_v\f$ at \f$(g, \dot g)\f$ belong to one differential. Then the
Euler-Lagrange map goes along: its value along \f$gk\f$ is that along \f$g\f$, translated by
\f$R_{k^{-1}}^*\f$. So \f$gk\f$ is a solution exactly where \f$g\f$ is. The same holds on the left. *)
Theorem claim_2_1_symmetry_of_solutions_equations (d : derivation R) k L_g L_v M_g M_v :
  k \in unitmx -> derivative_of d k = 0 ->
  ((forall dg dv, pairing M_g (right_translation k dg) + pairing M_v (right_translation k dv) =
                  pairing L_g dg + pairing L_v dv) ->
   derivative_of d M_v - M_g = R_star (invmx k) (derivative_of d L_v - L_g) /\
   (derivative_of d M_v = M_g <-> derivative_of d L_v = L_g)) /\
  ((forall dg dv, pairing M_g (left_translation k dg) + pairing M_v (left_translation k dv) =
                  pairing L_g dg + pairing L_v dv) ->
   derivative_of d M_v - M_g = L_star (invmx k) (derivative_of d L_v - L_g) /\
   (derivative_of d M_v = M_g <-> derivative_of d L_v = L_g)).
Proof.
move=> unit constant.
have still : derivative_of d (invmx k) = 0.
  by rewrite derivative_of_inverse_matrix // constant mulmx0 mul0mx oppr0.
have still_T : derivative_of d (invmx k)^T = 0 by rewrite derivative_of_transpose still trmx0.
have unit_T : (invmx k)^T \in unitmx by rewrite unitmx_tr unitmx_inv.
split=> same.
  apply: (equations_go_along (T := right_translation k) (P := R_star (invmx k)) _ _ _ _ _ same)
    => [|p q pairs|p q||p].
  - by rewrite /right_translation mul0mx.
  - by apply: pairing_injective => v; rewrite R_star_dual -pairs /right_translation mulmxKV.
  - by rewrite /R_star mulmxBl.
  - exact: can_inj (mulmxK unit_T).
  by rewrite /R_star derivative_of_matrix_product still_T mulmx0 addr0.
apply: (equations_go_along (T := left_translation k) (P := L_star (invmx k)) _ _ _ _ _ same)
  => [|p q pairs|p q||p].
- by rewrite /left_translation mulmx0.
- by apply: pairing_injective => v; rewrite L_star_dual -pairs /left_translation mulKVmx.
- by rewrite /L_star mulmxBr.
- exact: can_inj (mulKmx unit_T).
by rewrite /L_star derivative_of_matrix_product still_T mul0mx add0r.
Qed.

(** ** The diagonal action is free

Section 3.2. The element that takes one pair of configurations to another is known from the first two
configurations, \f$k = g_0^{-1}h_0\f$; so it depends on them as smoothly as the group allows, which is why the
action is proper, and only the identity leaves a pair as it is. *)
Theorem claim_3_2_proper_action_free g0 g1 h0 h1 k : g0 \in unitmx ->
  (g0 *m k = h0 /\ g1 *m k = h1 -> k = invmx g0 *m h0) /\ (g0 *m k = g0 /\ g1 *m k = g1 -> k = 1%:M).
Proof. by move=> unit; split=> -[first _]; rewrite -[k](mulKmx unit) first ?mulKmx ?mulVmx. Qed.

(** ** The forms of Kirillov and Kostant are closed

On the orbits of the dual algebra the fields \f$\mu\mapsto\mathrm{ad}_x^*\mu\f$ have the bracket
\f$\mathrm{ad}_y^*\mathrm{ad}_x^* - \mathrm{ad}_x^*\mathrm{ad}_y^* = \mathrm{ad}_{[x,y]}^*\f$, and the
derivative of \f$\omega(y, z) = \langle\mu, [y, z]\rangle\f$ along \f$\mathrm{ad}_x^*\mu\f$ is
\f$\langle\mathrm{ad}_x^*\mu, [y, z]\rangle\f$. With these the exterior derivative of the form on three
fields,
\f[ \sum\bigl(\langle\mathrm{ad}_x^*\mu, [y, z]\rangle - \langle\mu, [[x, y], z]\rangle\bigr) , \f]
the sum over the cyclic exchanges of \f$x\f$, \f$y\f$, \f$z\f$, vanishes by the identity of Jacobi. *)
Theorem claim_2_2_coadjoint_orbits_closed mu x y z :
  ad_star y (ad_star x mu) - ad_star x (ad_star y mu) = ad_star (bracket x y) mu /\
  (pairing (ad_star x mu) (bracket y z) - pairing mu (bracket (bracket x y) z)) +
  (pairing (ad_star y mu) (bracket z x) - pairing mu (bracket (bracket y z) x)) +
  (pairing (ad_star z mu) (bracket x y) - pairing mu (bracket (bracket z x) y)) = 0.
Proof.
have fields : ad_star y (ad_star x mu) - ad_star x (ad_star y mu) = ad_star (bracket x y) mu.
  apply: pairing_injective => v; rewrite pairing_addl pairing_oppl !ad_star_dual -pairing_oppr -pairing_addr.
  by congr pairing; rewrite /ad (isospectral.jacobi x y v) addrK.
split=> //; rewrite !ad_star_dual -!pairing_oppr -!pairing_addr -[RHS](pairing_0r mu); congr pairing.
by rewrite /ad /bracket; by_expansion.
Qed.

End Translations.

(** ** The Cayley map as a retraction *)

Section Retraction.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g h k v A B Q : 'M[R]_n.

(** Its inverse, \f$(Q - 1)(Q + 1)^{-1}\f$; the library's is twice as large.
C++: `actio::inverse_cayley`, `groups/matrix_group.hpp`. *)
Definition inverse_cayley Q := (Q - 1%:M) *m invmx (Q + 1%:M).

(** ** The Cayley map and its inverse

Where 2 has an inverse: \f$\mathrm{cay}(A) + 1 = 2(1 - A)^{-1}\f$ is invertible where \f$1 - A\f$ is, and
\f$\mathrm{cay}^{-1}(\mathrm{cay}(A)) = A\f$; and \f$\mathrm{cay}(\mathrm{cay}^{-1}(Q)) = Q\f$ where
\f$Q + 1\f$ is invertible. *)
Theorem cayley_and_its_inverse A Q : (2%:R : R) \is a GRing.unit ->
  (1%:M - A \in unitmx -> cayley A + 1%:M \in unitmx /\ inverse_cayley (cayley A) = A) /\
  (Q + 1%:M \in unitmx -> 1%:M - inverse_cayley Q \in unitmx /\ cayley (inverse_cayley Q) = Q).
Proof.
move=> two; have halves X : (2%:R)^-1 *: (X *+ 2) = X :> 'M[R]_n.
  by rewrite -scaler_nat scalerA mulVr ?scale1r.
split=> [minus | plus].
  have sum : (cayley A + 1%:M) *m (1%:M - A) = 1%:M *+ 2.
    by rewrite mulmxDl cayley_right //; by_expansion.
  have inverse : (cayley A + 1%:M) *m ((2%:R)^-1 *: (1%:M - A)) = 1%:M by rewrite -scalemxAr sum halves.
  have unit := (mulmx1_unit inverse).1.
  split=> //; apply: (can_inj (mulmxK unit)); rewrite mulmxKV //.
  apply: (can_inj (mulmxK minus)); rewrite -!mulmxA sum mulmxBl cayley_right // mul1mx.
  by by_expansion.
set A' := inverse_cayley Q.
have product : A' *m (Q + 1%:M) = Q - 1%:M by rewrite mulmxKV.
have difference : (1%:M - A') *m (Q + 1%:M) = 1%:M *+ 2.
  by rewrite mulmxBl product; by_expansion.
have inverse : (1%:M - A') *m ((2%:R)^-1 *: (Q + 1%:M)) = 1%:M by rewrite -scalemxAr difference halves.
have unit := (mulmx1_unit inverse).1.
split=> //; apply: (can_inj (mulKmx unit)); rewrite cayley_left //.
apply: (can_inj (mulmxK plus)); rewrite mulmxDl product mul1mx.
have -> : (1%:M - A') *m Q *m (Q + 1%:M) = (1%:M - A') *m (Q + 1%:M) *m Q by by_expansion.
by rewrite difference mulmxDl; by_expansion.
Qed.

(** ** What makes it a retraction

\f$\mathrm{cay}(0) = 1\f$; to first order \f$\mathrm{cay}(B) = 1 + 2B\f$, which is exact where \f$B^2 = 0\f$;
\f$\mathrm{cay}(-A) = \mathrm{cay}(A)^{-1}\f$;
\f$\mathrm{cay}(\mathrm{Ad}_gA) = \mathrm{Ad}_g\,\mathrm{cay}(A)\f$; and the exact remainder of the second
order,
\f[ \mathrm{cay}(A) = 1 + 2A + 2A^2 + 2A^3(1 - A)^{-1} . \f]
Up to the last term this is \f$\exp(2A)\f$. *)
Theorem cayley_is_a_retraction g A : g \in unitmx -> 1%:M - A \in unitmx ->
  [/\ cayley (0 : 'M[R]_n) = 1%:M,
      forall B, B *m B = 0 -> cayley B = 1%:M + B *+ 2,
      1%:M + A \in unitmx -> cayley (- A) = invmx (cayley A),
      cayley (Ad g A) = Ad g (cayley A)
    & cayley A = 1%:M + A *+ 2 + (A *m A) *+ 2 + (A *m A *m A *m invmx (1%:M - A)) *+ 2].
Proof.
move=> unit_g minus; split.
- by rewrite /cayley subr0 addr0 invmx1 mulmx1.
- move=> B square; have inverse : (1%:M - B) *m (1%:M + B) = 1%:M.
    by expanded; rewrite square; by_expansion.
  apply: (can_inj (mulKmx (mulmx1_unit inverse).1)); rewrite cayley_left ?(mulmx1_unit inverse).1 //.
  by expanded; rewrite square; by_expansion.
- by move=> plus; rewrite cayley_inv.
- have one_minus : 1%:M - Ad g A = Ad g (1%:M - A).
    by rewrite /Ad mulmxBr mulmx1 mulmxBl mulmxV.
  have one_plus : 1%:M + Ad g A = Ad g (1%:M + A) by rewrite /Ad mulmxDr mulmx1 mulmxDl mulmxV.
  have unit : Ad g (1%:M - A) \in unitmx by rewrite /Ad !unitmx_mul unitmx_inv unit_g minus.
  have together X Y : Ad g X *m Ad g Y = Ad g (X *m Y) by rewrite /Ad !mulmxA mulmxKV.
  apply: (can_inj (mulKmx unit)); rewrite together cayley_left // -one_plus -{1}one_minus cayley_left //.
  by rewrite one_minus.
apply: (can_inj (mulmxK minus)); rewrite cayley_right // !mulr2n !mulmxDl mulmxKV //.
by by_expansion.
Qed.

(** ** Rotations from skew matrices and back

For an invertible \f$Q + 1\f$, where \f$Q\f$ is orthogonal the matrix \f$\mathrm{cay}^{-1}(Q)\f$ is skew. The
converse is the unitarity of the Cayley map of a skew matrix. *)
Theorem inverse_cayley_skew Q : Q + 1%:M \in unitmx -> orthogonal Q -> skew (inverse_cayley Q).
Proof.
move=> plus o; rewrite /skew; have left := orthogonal_left o.
have plus_T : Q^T + 1%:M \in unitmx by rewrite -[1%:M]trmx1 -raddfD unitmx_tr.
have product : inverse_cayley Q *m (Q + 1%:M) = Q - 1%:M by rewrite mulmxKV.
(* Both sides between Q^T + 1 and Q + 1. *)
apply: (can_inj (mulKmx plus_T)); apply: (can_inj (mulmxK plus)).
have transposed : (Q^T + 1%:M) *m (inverse_cayley Q)^T = Q^T - 1%:M.
  by rewrite -[1%:M]trmx1 -raddfD -raddfB -trmx_mul product.
rewrite transposed mulmxN mulNmx -mulmxA product; expanded; rewrite left.
by by_expansion.
Qed.

(** ** A discretization without origin inherits the symmetry

Remark 3.1.1. A discrete Lagrangian is the Lagrangian at an approximate configuration and velocity. Let these
be \f$q = u(f)\,g_0\f$ and \f$\dot q = w(f)\,q\f$ with any two functions \f$u\f$ and \f$w\f$ of the relative
motion \f$f = g_0g_1^{-1}\f$; in the chart by the Cayley map at \f$g_0\f$ they are half-way in the chart, and
a multiple of \f$\mathrm{cay}^{-1}(f)\f$. Then the diagonal action on pairs is the lifted action on states,
and the discrete Lagrangian is right-invariant where the Lagrangian is. *)
Definition configuration_right (u : 'M[R]_n -> 'M[R]_n) g0 g1 := u (relative_motion_right g0 g1) *m g0.
Definition velocity_right (u w : 'M[R]_n -> 'M[R]_n) g0 g1 :=
  w (relative_motion_right g0 g1) *m configuration_right u g0 g1.

Theorem rem_3_1_1_of_matrices T (L : 'M[R]_n -> 'M[R]_n -> T) (u w : 'M[R]_n -> 'M[R]_n) :
  let discrete g0 g1 := L (configuration_right u g0 g1) (velocity_right u w g0 g1) in
  forall g0 g1 k, g1 \in unitmx -> k \in unitmx ->
  [/\ configuration_right u (g0 *m k) (g1 *m k) = configuration_right u g0 g1 *m k,
      velocity_right u w (g0 *m k) (g1 *m k) = velocity_right u w g0 g1 *m k
    & (forall g v, L (g *m k) (v *m k) = L g v) -> discrete (g0 *m k) (g1 *m k) = discrete g0 g1].
Proof.
move=> discrete g0 g1 k unit_1 unit_k.
have same : relative_motion_right (g0 *m k) (g1 *m k) = relative_motion_right g0 g1.
  rewrite /relative_motion_right; apply: (can_inj (mulmxK unit_1)); apply: (can_inj (mulmxK unit_k)).
  by rewrite -!mulmxA [invmx (g1 *m k) *m _]mulVmx ?unitmx_mul ?unit_1 // mulmx1 mulKmx.
have place : configuration_right u (g0 *m k) (g1 *m k) = configuration_right u g0 g1 *m k.
  by rewrite /configuration_right same mulmxA.
have rate : velocity_right u w (g0 *m k) (g1 *m k) = velocity_right u w g0 g1 *m k.
  by rewrite /velocity_right same place mulmxA.
by split=> // invariance; rewrite /discrete place rate invariance.
Qed.

End Retraction.

(** ** Reduction of a bracket *)

Section BracketReduction.

(** The functions on a Poisson manifold are a ring with a bracket, and a group moves them. The functions on
the quotient are another ring; the pull-back by the quotient map takes each of them to a function on the
manifold, and a function that the group leaves as it is comes from the quotient: it can be lowered. For pairs
in a group the quotient map is \f$\pi_d(g_0, g_1) = g_0g_1^{-1}\f$, and \f$F\f$ is lowered to \f$F(f, 1)\f$.
That the action is proper is not needed for this. *)
Variables (functions quotient_functions : comRingType) (b : functions -> functions -> functions).
Hypothesis poisson : is_poisson_bracket b.
Variables (G : Type) (act : G -> functions -> functions).
Variables (pull_back : {rmorphism quotient_functions -> functions}) (lower : functions -> quotient_functions).

Definition is_invariant f := forall k, act k f = f.

Hypothesis act_bracket : forall k f h, act k (b f h) = b (act k f) (act k h).
Hypothesis lower_pull_back : forall s, lower (pull_back s) = s.
Hypothesis invariant_from_quotient : forall f, is_invariant f <-> pull_back (lower f) = f.

(** The bracket on the quotient. *)
Definition reduced_bracket s t := lower (b (pull_back s) (pull_back t)).

Lemma pull_back_invariant s : is_invariant (pull_back s).
Proof. by apply/invariant_from_quotient; rewrite lower_pull_back. Qed.

Lemma pull_back_injective s t : pull_back s = pull_back t -> s = t.
Proof. by move=> same; rewrite -[s]lower_pull_back same lower_pull_back. Qed.

(** ** Brackets of invariant functions are invariant

Chapter 10, on a configuration space larger than its symmetry group: where the group preserves the bracket,
the bracket of two invariant functions is invariant. Where the group is generated by brackets with its
momentum \f$J\f$, all invariant functions commute with \f$J\f$. So the quotient of pairs inherits a bracket,
whatever the configuration space. *)
Theorem claim_10_0_reduced_pair_space_bracket :
  (forall f h, is_invariant f -> is_invariant h -> is_invariant (b f h)) /\
  (forall (J : functions) (generator : functions -> functions), (forall f, b f J = generator f) ->
    (forall f, is_invariant f -> generator f = 0) -> forall f, is_invariant f -> b f J = 0).
Proof.
split=> [f h f_stays h_stays k | J generator generates vanishes f stays].
  by rewrite act_bracket f_stays h_stays.
by rewrite generates vanishes.
Qed.

(** ** The bracket on the quotient

(3.13), with the functions lifted by the quotient map:
\f$\{f, h\}_G\circ\pi_d = \{f\circ\pi_d, h\circ\pi_d\}\f$. There is one bracket with this property. *)
Theorem eq_3_13 :
  (forall s t, pull_back (reduced_bracket s t) = b (pull_back s) (pull_back t)) /\
  (forall c : quotient_functions -> quotient_functions -> quotient_functions,
    (forall s t, pull_back (c s t) = b (pull_back s) (pull_back t)) ->
    forall s t, c s t = reduced_bracket s t).
Proof.
have lifts s t : pull_back (reduced_bracket s t) = b (pull_back s) (pull_back t).
  apply/invariant_from_quotient; apply: claim_10_0_reduced_pair_space_bracket.1; exact: pull_back_invariant.
by split=> // c same s t; apply: pull_back_injective; rewrite same lifts.
Qed.

(** ** A step that the symmetry commutes with preserves the bracket on the quotient

Let a map of functions, composition with the discrete Euler-Lagrange flow, preserve the bracket and commute
with the group. It goes down to the functions on the quotient, where it is composition with the discrete
Euler-Poincare algorithm, and there it preserves the reduced bracket. *)
Theorem claim_3_2_dep_preserves_bracket_of_steps_that_descend (flow : functions -> functions) :
  (forall f h, flow (b f h) = b (flow f) (flow h)) -> (forall k f, act k (flow f) = flow (act k f)) ->
  let reduced_flow s := lower (flow (pull_back s)) in
  (forall s, pull_back (reduced_flow s) = flow (pull_back s)) /\
  (forall s t, reduced_flow (reduced_bracket s t) = reduced_bracket (reduced_flow s) (reduced_flow t)).
Proof.
move=> preserves commutes reduced_flow.
have goes_down s : pull_back (reduced_flow s) = flow (pull_back s).
  by apply/invariant_from_quotient => k; rewrite commutes pull_back_invariant.
split=> // s t; apply: pull_back_injective.
by rewrite goes_down !eq_3_13.1 preserves !goes_down.
Qed.

(** ** The discrete Euler-Poincare algorithm is a Poisson map

Theorem 3.2.2, corrected: the bracket of (3.13) is a Poisson bracket, and it is preserved by every step that
comes from one on pairs which preserves the bracket there and commutes with the symmetry. That the discrete
Euler-Lagrange flow is such a step is `claim_3_1_flow_symplectic` and `claim_3_1_symmetry_of_discrete_flow`.
*)
Theorem thm_3_2_2_of_steps_that_descend :
  is_poisson_bracket reduced_bracket /\
  (forall flow : functions -> functions,
    (forall f h, flow (b f h) = b (flow f) (flow h)) -> (forall k f, act k (flow f) = flow (act k f)) ->
    let reduced_flow s := lower (flow (pull_back s)) in
    forall s t, reduced_flow (reduced_bracket s t) = reduced_bracket (reduced_flow s) (reduced_flow t)).
Proof.
have lifts := eq_3_13.1; case: poisson => skew_b sum_b leibniz_b jacobi_b.
split; last by move=> flow preserves commutes reduced_flow;
  apply: (claim_3_2_dep_preserves_bracket_of_steps_that_descend _ _).2.
split=> [s t | s t u | s t u | s t u]; apply: pull_back_injective.
- by rewrite rmorphN !lifts skew_b.
- by rewrite rmorphD !lifts rmorphD sum_b.
- by rewrite rmorphD !rmorphM !lifts rmorphM leibniz_b.
by rewrite !rmorphD rmorph0 !lifts jacobi_b.
Qed.

End BracketReduction.
