(** * The rotation algebra in coordinates

Skew matrices of size three as vectors of space: the Lie-Poisson bracket of \f$\mathfrak{so}(3)^*\f$, the
Casimir functions of section 5.3 and the orbits of the free rigid body; and the moments of inertia of chapter
5, for bodies of point masses in a space of any dimension. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations slopes rigid_body.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(** ** Vectors of space and skew matrices *)

Section Rotations.

Variable R : comUnitRingType.
Implicit Types x y z u w : 'I_3 -> R.

(** The axis after \f$i\f$, in the cyclic order 1, 2, 3. *)
Definition next (i : 'I_3) : 'I_3 := i + 1.

Lemma sum_over_axes (f : 'I_3 -> R) : \sum_i f i = f 0 + f (next 0) + f (next (next 0)).
Proof. by rewrite !big_ord_recl big_ord0 addr0 addrA; congr (f _ + f _ + f _); apply: val_inj. Qed.

Lemma axes (P : 'I_3 -> Prop) : P 0 -> P (next 0) -> P (next (next 0)) -> forall i, P i.
Proof.
move=> P0 P1 P2 [[|[|[|//]]] lt]; [move: P0 | move: P1 | move: P2]; congr P; exact: val_inj.
Qed.

Lemma next3 i : next (next (next i)) = i.
Proof. by apply: (axes (P := fun i => next (next (next i)) = i)); apply: val_inj. Qed.

(** The vector product and the scalar product. *)
Definition cross x y : 'I_3 -> R := fun i => x (next i) * y (next (next i)) - x (next (next i)) * y (next i).
Definition dot x y : R := \sum_i x i * y i.

(** The skew matrix \f$\hat x\f$ of a vector, \f$\hat xy = x\times y\f$. C++: `actio::SO::hat`,
`groups/rotations.hpp`. *)
Definition hat x : 'M[R]_3 :=
  \matrix_(i, j) (if j == next i then - x (next j) else if i == next j then x (next i) else 0).

Lemma hatE x i : [/\ hat x i i = 0, hat x i (next i) = - x (next (next i))
                   & hat x (next i) i = x (next (next i))].
Proof. by split; rewrite mxE; move: i; apply: axes. Qed.

Lemma hat_bracket x y : bracket (hat x) (hat y) = hat (cross x y).
Proof.
apply/matrixP; apply: axes; apply: axes; rewrite !mxE !sum_over_axes !mxE /= /cross ?next3; ring_identity.
Qed.

Lemma hat_skew x : (hat x)^T = - hat x.
Proof.
by apply/matrixP; apply: axes; apply: axes; rewrite !mxE /= ?next3 ?opprK ?oppr0.
Qed.

Lemma hat_pairing x y : pairing (hat x) (hat y) = 2%:R * dot x y.
Proof.
rewrite /pairing hat_skew mulNmx /mxtrace /dot !sum_over_axes !mxE !sum_over_axes !mxE /= ?next3.
ring_identity.
Qed.

Lemma dot_cross x y z : dot x (cross y z) = dot y (cross z x).
Proof. rewrite /dot !sum_over_axes /cross !next3; ring_identity. Qed.

(** ** Casimir functions of the rotation algebra

Section 5.3 takes \f$\mathrm{Tr}(\mu^2)\f$ as the Casimir function of \f$\mathfrak{so}(3)^*\f$ and says that
in coordinates \f$y\f$ of space it is \f$\|y\|^2\f$. With \f$\mu = \hat y\f$ it is
\f[ \mathrm{Tr}(\mu^2) = -2\,\|y\|^2 . \f] *)
Theorem claim_5_3_dual_casimir y : \tr (hat y *m hat y) = - (2%:R * dot y y).
Proof. by rewrite -hat_pairing /pairing hat_skew mulNmx raddfN opprK. Qed.

(** In these coordinates the Lie-Poisson bracket is \f$\{F, H\} = y\cdot(\nabla F\times\nabla H)\f$; matrices
are paired by \f$\frac12\mathrm{Tr}(A^TB)\f$, the product of coordinates. *)
Theorem claim_5_3_dual_casimir_bracket y a b :
  pairing (hat y) (bracket (hat a) (hat b)) = 2%:R * dot y (cross a b).
Proof. by rewrite hat_bracket hat_pairing. Qed.

(** Both functions are Casimir functions: the bracket of \f$\|y\|^2\f$ with every function vanishes. The ring
may be any ring of functions with coordinates \f$y_i\f$ and derivations \f$\partial_i\f$,
\f$\partial_iy_j = \delta_{ij}\f$. *)
Theorem claim_5_3_dual_casimir_is_casimir (d : 'I_3 -> derivation R) y f :
    (forall i j, d i (y j) = (i == j)%:R) ->
  dot y (cross (fun i => d i (dot y y)) (fun i => d i f)) = 0.
Proof.
move=> coordinates.
have slope i : d i (dot y y) = 2%:R * y i.
  rewrite /dot raddf_sum (bigD1 i) //= big1 => [|j ne]; rewrite leibniz coordinates.
    by rewrite eqxx /=; ring_identity.
  by rewrite eq_sym (negbTE ne) mul0r mulr0 addr0.
rewrite /dot sum_over_axes /cross !slope !next3; ring_identity.
Qed.

(** ** The form of Kirillov and Kostant is the area over the radius

Section 5.3 says that on the spheres \f$\|y\| = r\f$ the form \f$\omega(\mathrm{ad}^*_a y, \mathrm{ad}^*_b y)
= \langle y, [a, b]\rangle\f$ is proportional to the form of area. It is \f$r^{-2}\,y\cdot(u\times w)\f$ on
the tangent vectors \f$u = a\times y\f$, \f$w = b\times y\f$, and \f$r^{-1}\,y\cdot(u\times w)\f$ is their
area. *)
Theorem claim_5_3_dual_casimir_area y a b :
  dot y y * dot y (cross a b) = dot y (cross (cross a y) (cross b y)).
Proof. rewrite /dot !sum_over_axes /cross !next3; ring_identity. Qed.

(** ** The operator of inertia in coordinates

In space the operator \f$J(\xi) = \Lambda\xi + \xi\Lambda\f$ with \f$\Lambda = \mathrm{diag}(\Lambda_1,
\Lambda_2, \Lambda_3)\f$ has the components \f$I_ix_i\f$ at \f$\xi = \hat x\f$, with the moments of inertia
\f$I_1 = \Lambda_2 + \Lambda_3\f$ and so on. *)
Definition second_moments (lambda : 'I_3 -> R) : 'M[R]_3 := diag_mx (\row_i lambda i).

(** The moment of inertia about an axis. *)
Definition axis_moment (lambda : 'I_3 -> R) i := lambda (next i) + lambda (next (next i)).

Lemma inertia_in_space lambda x :
  inertia_operator (second_moments lambda) (hat x) = hat (fun i => axis_moment lambda i * x i).
Proof.
apply/matrixP; apply: axes; apply: axes; rewrite !mxE !sum_over_axes !mxE /= /axis_moment ?next3 /=;
  ring_identity.
Qed.

(** ** The Casimir function on the algebra, in coordinates

It is \f$C(x) = \|J(x)\|^2 = \sum_i I_i^2x_i^2\f$, which as a trace is
\f$-\frac12\mathrm{Tr}\bigl((J\xi)^2\bigr)\f$. *)
Theorem claim_5_3_algebra_casimir_coordinates lambda x :
  let J := inertia_operator (second_moments lambda) (hat x) in
  - \tr (J *m J) = 2%:R * \sum_i (axis_moment lambda i * x i) ^+ 2.
Proof. by rewrite /= inertia_in_space claim_5_3_dual_casimir opprK. Qed.

End Rotations.

(** There is no identification of space with the skew matrices for which the printed \f$\mathrm{Tr}(\mu^2) =
\|y\|^2\f$ holds, linear or not, over any ordered field: the square of a skew matrix has no positive trace. *)
Theorem claim_5_3_dual_casimir_printed_fails (R : realFieldType) :
  ~ exists skew_matrix_of : ('I_3 -> R) -> 'M[R]_3,
      (forall y, skew (skew_matrix_of y)) /\
      forall y, \tr (skew_matrix_of y *m skew_matrix_of y) = dot y y.
Proof.
case=> mu [skew_mu same]; have := same (fun i => (i == 0)%:R).
have -> : dot (R := R) (fun i => (i == 0)%:R) (fun i => (i == 0)%:R) = 1.
  by rewrite /dot sum_over_axes !mulr0 !addr0 mulr1.
set M := mu _ => one.
have positive : 0 <= \tr (M^T *m M).
  by apply: sumr_ge0 => i _; rewrite mxE; apply: sumr_ge0 => j _; rewrite mxE -expr2 sqr_ge0.
by move: positive; rewrite skew_mu mulNmx raddfN /= one oppr_ge0 ler10.
Qed.

(** ** The Casimir function on the algebra

With a Poisson structure on \f$\mathfrak{so}(3)\f$ for which \f$\mu = J(\xi)\f$ preserves brackets, the
Casimir function pulled back is \f$\|J(\xi)\|^2\f$ in the metric on the dual that \f$\mathrm{Ad}^*\f$ keeps:
its bracket with every function vanishes. Here \f$\mu_i = I_ix_i\f$, and \f$\partial_i\f$ is the derivative in
\f$\mu_i\f$. *)
Definition is_casimir (R : comUnitRingType) (d : 'I_3 -> derivation R) (mu : 'I_3 -> R) C :=
  forall f, dot mu (cross (fun i => d i C) (fun i => d i f)) = 0.

Theorem claim_5_3_algebra_casimir (R : comUnitRingType) (d : 'I_3 -> derivation R) (mu I x : 'I_3 -> R) :
    (forall i j, d i (mu j) = (i == j)%:R) -> (forall i, mu i = I i * x i) ->
  is_casimir d mu (\sum_i (I i * x i) ^+ 2).
Proof.
move=> coordinates moved f; rewrite -[RHS](claim_5_3_dual_casimir_is_casimir f coordinates).
by have -> : \sum_i (I i * x i) ^+ 2 = dot mu mu by apply: eq_bigr => i _; rewrite moved.
Qed.

(** The printed metric on the dual is the one that \f$J\f$ induces there, \f$(\mu, \nu) = \langle\mu,
J^{-1}\nu\rangle\f$. In it \f$\langle J\xi, J\xi\rangle = \sum_iI_ix_i^2\f$, which is twice the energy and no
Casimir function: for the moments \f$1, \frac12, 1\f$ its bracket with \f$\mu_3\f$ is \f$2\mu_1\mu_2\f$. *)
Theorem claim_5_3_algebra_casimir_printed_fails :
  ~ (forall (R : comUnitRingType) (d : 'I_3 -> derivation R) (mu I x : 'I_3 -> R),
      (forall i j, d i (mu j) = (i == j)%:R) -> (forall i j, d i (I j) = 0) ->
      (forall i, mu i = I i * x i) ->
      is_casimir d mu (\sum_i I i * x i ^+ 2)).
Proof.
have [R [c]] := polynomials 3.
pose mu := coordinate c; pose half := constant c (2%:R^-1).
pose K (i : 'I_3) : R := if i == next 0 then 2%:R else 1.
pose I (i : 'I_3) : R := if i == next 0 then half else 1.
have half2 : half * 2%:R = 1 by rewrite -(rmorph_nat (constant c)) -rmorphM mulVf ?rmorph1.
have inverse i : I i * K i = 1 by rewrite /I /K; case: eqP => _; rewrite ?half2 ?mulr1.
have constant_I i j : partial c i (I j) = 0.
  by rewrite /I; case: eqP => _; rewrite ?partial_constant ?derivative_of_one.
have constant_K i j : partial c i (K j) = 0.
  by rewrite /K; case: eqP => _; rewrite ?derivative_of_nat ?derivative_of_one.
have moved i : mu i = I i * (K i * mu i) by rewrite mulrA inverse mul1r.
move=> /(_ _ (partial c) mu I (fun i => K i * mu i) (partial_coordinate c) constant_I moved (mu (next (next
  0)))).
have slope i : partial c i (\sum_j I j * (K j * mu j) ^+ 2) = 2%:R * (K i * mu i).
  rewrite (eq_bigr (fun j => K j * (mu j * mu j))) => [|j _]; last first.
    by rewrite expr2 mulrA -moved; ring_identity.
  rewrite raddf_sum (bigD1 i) //= big1 => [|j ne]; rewrite !leibniz constant_K !partial_coordinate.
    by rewrite eqxx /=; ring_identity.
  by rewrite eq_sym (negbTE ne) !(mul0r, mulr0, addr0).
rewrite /dot sum_over_axes /cross !slope !partial_coordinate !next3 /K /= => vanishes.
have : 2%:R * (mu 0 * mu (next 0)) = 0 by rewrite -[RHS]vanishes; ring_identity.
move/(congr1 (fun f => at_origin c (partial c 0 (partial c (next 0) f)))).
rewrite !(leibniz, derivative_of_nat, partial_coordinate, raddfD) /= !(mulr0, mul0r, addr0, add0r, mulr1,
  raddf0).
by rewrite rmorph_nat => /eqP; rewrite pnatr_eq0.
Qed.



(** ** Both families of surfaces are kept by the motion

The dynamic orbits are intersections of the ellipsoids of \f$\mathcal J^2\f$ with those of \f$\mathcal J\f$
(section 5.3): along Euler's equations \f$\frac{d}{dt}(I_ix_i) = (Ix\times x)_i\f$ neither
\f$\sum_iI_i^2x_i^2\f$ nor \f$\sum_iI_ix_i^2\f$ changes. *)
Theorem claim_5_3_dynamic_orbits_conserved (R : comUnitRingType) (rate : derivation R) (I x : 'I_3 -> R) :
    (forall i, rate (I i) = 0) ->
    (forall i, rate (I i * x i) = cross (fun j => I j * x j) x i) ->
  rate (\sum_i (I i * x i) ^+ 2) = 0 /\ rate (\sum_i I i * x i ^+ 2) = 0.
Proof.
move=> constant_I euler.
have pull i : I i * rate (x i) = cross (fun j => I j * x j) x i.
  by rewrite -euler leibniz constant_I mul0r add0r.
split.
  have -> : rate (\sum_i (I i * x i) ^+ 2) = \sum_i 2%:R * (I i * x i) * rate (I i * x i).
    by rewrite raddf_sum; apply: eq_bigr => i _; rewrite expr2 leibniz; ring_identity.
  rewrite (eq_bigr _ (fun i _ => congr1 (fun r => 2%:R * (I i * x i) * r) (euler i))).
  rewrite sum_over_axes /cross !next3; ring_identity.
have -> : rate (\sum_i I i * x i ^+ 2) = \sum_i 2%:R * x i * (I i * rate (x i)).
  by rewrite raddf_sum; apply: eq_bigr => i _; rewrite expr2 !leibniz constant_I; ring_identity.
rewrite (eq_bigr _ (fun i _ => congr1 (fun r => 2%:R * x i * r) (pull i))).
rewrite sum_over_axes /cross !next3; ring_identity.
Qed.

(** ** Masses and moments of inertia *)

Section Masses.

Variables (R : comUnitRingType) (n : nat) (points : finType) (mass : points -> R) (place : points ->
  'cV[R]_n).
Implicit Types xi : 'M[R]_n.

(** The second moments of a body of point masses, \f$\Lambda = \sum_p m_p\,x_px_p^T\f$. *)
Definition second_moments_of_masses : 'M[R]_n := \sum_p mass p *: (place p *m (place p)^T).

(** Twice the kinetic energy of the body that turns with the velocity \f$\xi\f$:
\f$\sum_pm_p|\xi x_p|^2\f$; and its angular momentum, \f$\sum_pm_p(\dot xx^T - x\dot x^T)\f$ with
\f$\dot x = \xi x\f$. *)
Definition twice_kinetic_energy xi : R := \sum_p mass p * ((xi *m place p)^T *m (xi *m place p)) 0 0.
Definition angular_momentum xi : 'M[R]_n :=
  \sum_p mass p *: (xi *m place p *m (place p)^T - place p *m (xi *m place p)^T).

(** Turning in the plane of two axes with the rate one, and the moment of inertia of that plane: twice the
energy. *)
Definition turning i j : 'M[R]_n := delta_mx i j - delta_mx j i.
Definition moment_of_inertia i j := twice_kinetic_energy (turning i j).

(** ** The kinetic energy of a body of masses

(5.1) with matrices paired by \f$\mathrm{Tr}(A^TB)\f$: a body of masses that turns with the skew matrix
\f$\xi\f$ has the kinetic energy \f$\frac14\langle\xi, J\xi\rangle\f$, here times 4. Its angular momentum is
\f$J\xi = \Lambda\xi + \xi\Lambda\f$. *)
Theorem eq_5_1_of_masses xi : skew xi ->
  2%:R * twice_kinetic_energy xi = pairing xi (inertia_operator second_moments_of_masses xi).
Proof.
move=> skew_xi.
have energyE : twice_kinetic_energy xi = \tr (xi^T *m xi *m second_moments_of_masses).
  rewrite /second_moments_of_masses mulmx_sumr raddf_sum; apply: eq_bigr => p _ /=.
  rewrite -scalemxAr mxtraceZ -trace_mx11 trmx_mul; congr (_ * _).
  by rewrite [X in _ = \tr X]mulmxA [in RHS]mxtrace_mulC !mulmxA.
rewrite energyE /pairing /inertia_operator mulmxDr raddfD /= mulr_natl mulr2n; congr (_ + _); last first.
  by rewrite mulmxA.
by rewrite skew_xi !mulNmx !raddfN /= [in RHS]mxtrace_mulC [in LHS]mxtrace_mulC mulmxA.
Qed.

Theorem claim_5_0_principal_moments_angular xi : skew xi ->
  angular_momentum xi = inertia_operator second_moments_of_masses xi.
Proof.
move=> skew_xi; rewrite /inertia_operator /second_moments_of_masses mulmx_suml mulmx_sumr -big_split.
apply: eq_bigr => p _ /=; rewrite trmx_mul skew_xi mulmxN mulmxN opprK -scalemxAl -scalemxAr -scalerDr.
by rewrite addrC !mulmxA.
Qed.

(** ** Second moments and moments of inertia

The moments of inertia are sums of the \f$\Lambda_i\f$: for the plane of two different axes
\f[ I_{ij} = \Lambda_i + \Lambda_j, \qquad 2\,\Lambda_i = I_{ij} + I_{ik} - I_{jk} . \f]
In space \f$I_{23}\f$ is the moment about the first axis. *)
Theorem claim_5_0_principal_moments i j : i != j ->
  moment_of_inertia i j = second_moments_of_masses i i + second_moments_of_masses j j.
Proof.
move=> ij; rewrite /moment_of_inertia /twice_kinetic_energy /second_moments_of_masses !summxE -big_split.
apply: eq_bigr => p _ /=; rewrite 2!mxE !mxE !big_ord1 !mxE -mulrDr; congr (_ * _).
have turned k : (turning i j *m place p) k 0 = (k == i)%:R * place p j 0 - (k == j)%:R * place p i 0.
  rewrite /turning mulmxBl !mxE; congr (_ - _).
    rewrite (bigD1 j) //= big1 => [|l ne]; first by rewrite mxE eqxx andbT addr0.
    by rewrite mxE (negbTE ne) andbF mul0r.
  rewrite (bigD1 i) //= big1 => [|l ne]; first by rewrite mxE eqxx andbT addr0.
  by rewrite mxE (negbTE ne) andbF mul0r.
rewrite (bigD1 i) //= (bigD1 j) 1?eq_sym //= big1 => [|k /andP [ki kj]].
  rewrite !(mxE trmx_key) !turned !eqxx [j == i]eq_sym (negbTE ij) /=; ring_identity.
by rewrite (mxE trmx_key) !turned (negbTE ki) (negbTE kj) !mul0r subr0 mulr0.
Qed.

Theorem claim_5_0_principal_moments_inverse i j k : i != j -> i != k -> j != k ->
  2%:R * second_moments_of_masses i i
  = moment_of_inertia i j + moment_of_inertia i k - moment_of_inertia j k.
Proof. by move=> ij ik jk; rewrite !claim_5_0_principal_moments //; ring_identity. Qed.

End Masses.

(** The thesis says that the \f$\Lambda_i\f$ correspond to sums of certain principal moments of inertia. No
sum does: whichever moments are taken, and however often each, there is a body of one mass whose
\f$\Lambda_i\f$ is not their sum, in every dimension from 2 on. *)
Theorem claim_5_0_principal_moments_printed_fails n (i : 'I_n) (times : 'I_n -> 'I_n -> nat) : (1 < n)%N ->
  ~ (forall (points : finType) (mass : points -> rat) (place : points -> 'cV[rat]_n),
      second_moments_of_masses mass place i i
      = \sum_a \sum_(b | a != b) moment_of_inertia mass place a b *+ times a b).
Proof.
move=> many claim.
pose on_axis (j : 'I_n) (_ : unit) : 'cV[rat]_n := delta_mx j 0.
have lambdaE j k : second_moments_of_masses (fun _ => 1) (on_axis j) k k = (k == j)%:R.
  rewrite /second_moments_of_masses (big_pred1 tt) => [|[] //]; rewrite scale1r mxE big_ord1 !mxE eqxx andbT.
  by case: (k == j); rewrite ?mulr1 ?mulr0.
have momentE j a b : a != b ->
    moment_of_inertia (fun _ => 1) (on_axis j) a b = (a == j)%:R + (b == j)%:R.
  by move=> ab; rewrite claim_5_0_principal_moments // !lambdaE.
have unused j a b : j != i -> a != b -> (a == j) || (b == j) -> times a b = 0%N.
  move=> ji ab at_j; have := claim _ (fun _ => 1) (on_axis j); rewrite lambdaE eq_sym (negbTE ji) =>
    /esym/eqP.
  have positive a' b' : a' != b' -> 0 <= moment_of_inertia (fun _ => 1) (on_axis j) a' b' *+ times a' b'.
    by move=> ne; rewrite momentE // mulrn_wge0 // addr_ge0 ?ler0n.
  rewrite psumr_eq0 => [/allP /(_ a (mem_index_enum _))|a' _]; last by apply: sumr_ge0 => b' /positive.
  rewrite implyTb psumr_eq0 => [/allP /(_ b (mem_index_enum _))|b' /positive //].
  rewrite ab implyTb momentE //; case: (times a b) => // m; rewrite mulrn_eq0 /= paddr_eq0 ?ler0n //.
  by rewrite !pnatr_eq0 !eqb0; case/orP: at_j => ->; rewrite ?andbF.
have none a b : a != b -> times a b = 0%N.
  move=> ab; case: (eqVneq a i) => ai; last by apply: (unused a) => //; rewrite eqxx.
  by apply: (unused b) => //; [rewrite -ai eq_sym | rewrite eqxx orbT].
have := claim _ (fun _ => 1) (on_axis i); rewrite lambdaE eqxx big1 => [/eqP|a _].
  by rewrite oner_eq0.
by rewrite big1 // => b ab; rewrite none.
Qed.

(** ** The Legendre transformation on the algebra

The derivative of the energy \f$l(\xi) = \frac14\langle\xi, J\xi\rangle\f$ of (5.1), by the same pairing
\f$\mathrm{Tr}(A^TB)\f$, is \f$\partial l/\partial\xi = \frac12J(\xi)\f$: for a symmetric \f$\Lambda\f$ that
is constant, any matrix \f$\xi\f$ of functions and any way \f$d\f$ to differentiate them. *)
Theorem claim_5_3_algebra_legendre_along_a_curve (R : comUnitRingType) n (d : derivation R) (Lambda xi :
  'M[R]_n) :
    (2%:R : R) \is a GRing.unit -> symmetric Lambda -> derivative_of d Lambda = 0 ->
  d (kinetic_energy Lambda xi) = pairing (2%:R^-1 *: inertia_operator Lambda xi) (derivative_of d xi).
Proof.
move=> unit2 symL constant.
have unit4 : (4%:R : R) \is a GRing.unit by rewrite (natrM _ 2 2) unitrM unit2.
have trE (A : 'M[R]_n) : d (\tr A) = \tr (derivative_of d A).
  by rewrite /mxtrace raddf_sum; apply: eq_bigr => k _; rewrite mxE.
have twice : d (pairing xi (inertia_operator Lambda xi))
             = 2%:R * pairing (inertia_operator Lambda xi) (derivative_of d xi).
  rewrite /pairing trE derivative_of_matrix_product derivative_of_transpose.
  have -> : derivative_of d (inertia_operator Lambda xi) = inertia_operator Lambda (derivative_of d xi).
    rewrite /inertia_operator derivative_of_matrix_sum !derivative_of_matrix_product constant.
    by rewrite mul0mx mulmx0 add0r addr0.
  rewrite mxtraceD mulr_natl mulr2n; congr (_ + _).
    by rewrite -mxtrace_tr trmx_mul trmxK.
  rewrite /inertia_operator mulmxDr [(_ + _)^T]linearD /= mulmxDl !mxtraceD !trmx_mul symL; congr (_ + _).
    by rewrite mulmxA.
  by rewrite mulmxA mxtrace_mulC mulmxA.
have constant4 : d 4%:R^-1 = 0 by rewrite derivative_of_inverse // derivative_of_nat !mul0r oppr0.
rewrite /kinetic_energy [4%:R^-1 * _]mulrC leibniz constant4 mulr0 addr0 twice /pairing linearZ /=
  -scalemxAl mxtraceZ.
have -> : 4%:R^-1 = 2%:R^-1 * 2%:R^-1 :> R by rewrite (natrM _ 2 2) invrM.
by rewrite [2%:R * _]mulrC -mulrA [2%:R * _]mulrA mulrV // mul1r mulrC.
Qed.

(** With the pairing of (5.1) the printed \f$\partial l/\partial\xi = \mathcal J(\xi)\f$ is twice the
derivative, already for a disc that turns at a rate which changes. *)
Theorem claim_5_3_algebra_legendre_printed_fails_along_a_curve :
  ~ (forall (R : comUnitRingType) n (d : derivation R) (Lambda xi : 'M[R]_n),
      (2%:R : R) \is a GRing.unit -> symmetric Lambda -> derivative_of d Lambda = 0 -> skew xi ->
      d (kinetic_energy Lambda xi) = pairing (inertia_operator Lambda xi) (derivative_of d xi)).
Proof.
have [R [c]] := polynomials 1.
have unit2 : (2%:R : R) \is a GRing.unit.
  by rewrite -(rmorph_nat (constant c)); apply: rmorph_unit; rewrite unitfE pnatr_eq0.
pose z := coordinate c 0; pose E : 'M[R]_2 := turning R 0 1; pose d := partial c 0.
have skewE : E^T = - E by rewrite linearB /= !trmx_delta opprB.
have constant1 : derivative_of d (1%:M : 'M[R]_2) = 0.
  by apply/matrixP => a b; rewrite !mxE derivative_of_nat.
have dE : derivative_of d (z *: E) = E.
  apply/matrixP => a b; rewrite !mxE leibniz partial_coordinate mul1r raddfB /= !derivative_of_nat.
  by rewrite subrr mulr0 addr0.
have symmetric1 : symmetric (1%:M : 'M[R]_2) by rewrite /symmetric trmx1.
have skewzE : skew (z *: E) by rewrite /skew linearZ /= skewE scalerN.
move=> claim; have := claim _ _ d 1%:M (z *: E) unit2 symmetric1 constant1 skewzE.
rewrite claim_5_3_algebra_legendre_along_a_curve // dE /inertia_operator mul1mx mulmx1 -scalerDl /pairing.
have trE : \tr (E^T *m E) = 2%:R.
  rewrite skewE mulNmx raddfN /= /mxtrace !big_ord_recl big_ord0 !mxE !big_ord_recl !big_ord0 !mxE /=.
  ring_identity.
rewrite !linearZ /= -!scalemxAl !mxtraceZ trE mulrCA mulrA => equal.
have : 2%:R * z = 0.
  have -> : 2%:R * z = (z + z) * 2%:R - (z + z) by ring_identity.
  by rewrite -equal divrK // subrr.
move/(congr1 (fun f => at_origin c (d f))); rewrite leibniz derivative_of_nat partial_coordinate.
by rewrite mul0r add0r mulr1 !raddf0 rmorph_nat => /eqP; rewrite pnatr_eq0.
Qed.
