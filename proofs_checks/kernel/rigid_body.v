(** * The generalized rigid body

Chapter 5 of the thesis: the body on \f$SO(n)\f$, its discretization by Moser and Veselov, and what that
conserves. A configuration is an orthogonal matrix \f$g\f$ of any size \f$n\f$ over any commutative ring
\f$R\f$, `orthogonal g`; a body velocity \f$\xi = g^{-1}\dot g\f$ and a body momentum are skew matrices. The
matrix \f$\Lambda\f$ of the body is `L`. It need not be diagonal; where it has to be symmetric, the theorem
says so. Two configurations \f$g_k, g_{k+1}\f$ have the relative motion \f$f_{k+1k} = g_{k+1}^{-1}g_k\f$;
for three configurations in a row these are called `f10` and `f21`. Where a formula of the thesis has the
factor \f$\tfrac12\f$ or \f$\tfrac14\f$, the number 2 must have an inverse in \f$R\f$,
`2%:R \is a GRing.unit`.

Determinants are asked for nowhere: the theorems hold for reflections too. The counterexamples to printed
formulas are matrices of \f$SO(3)\f$ with rational entries. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

(** ** Calculations

This section and the next hold what the proofs calculate with; who reads the statements can begin at the
section on the body. An identity between polynomials in elements of a commutative ring is decided by
multiplying out. *)

Definition ring_zero (R : comRingType) : R := 0.
Definition ring_one (R : comRingType) : R := 1.
Definition ring_plus (R : comRingType) (x y : R) : R := x + y.
Definition ring_times (R : comRingType) (x y : R) : R := x * y.
Definition ring_minus (R : comRingType) (x y : R) : R := x - y.
Definition ring_opposite (R : comRingType) (x : R) : R := - x.

Lemma laws_of_a_ring (R : comRingType) :
  ring_theory (ring_zero R) (ring_one R) (@ring_plus R) (@ring_times R) (@ring_minus R) (@ring_opposite R) eq.
Proof.
by split=> //; [exact: add0r | exact: addrC | exact: addrA | exact: mul1r | exact: mulrC | exact: mulrA |
  exact: mulrDl | exact: subrr].
Qed.

(* Traces and entries of matrices count as unknowns. *)
Ltac calculate_in R :=
  repeat match goal with |- context [@mxtrace ?S ?m ?A] => move: (@mxtrace S m A) => ? end;
  repeat match goal with |- context [@fun_of_matrix ?S ?m ?p ?A ?i ?j] =>
    move: (@fun_of_matrix S m p A i j) => ? end;
  rewrite -[LHS]add0r ?(exprS, expr0, mulrS, mulr0n);
  rewrite -?[@GRing.add _]/(@ring_plus R) -?[@GRing.opp _]/(@ring_opposite R)
    -?[@GRing.mul _]/(@ring_times R) -?[@GRing.zero _]/(@ring_zero R) -?[@GRing.one _]/(@ring_one R);
  match goal with |- @eq _ ?x ?y => change (@eq (GRing.ComRing.sort R) x y) end; ring.

(* An identity between sums of matrices, in which products of matrices count as unknowns. *)
Ltac compare_entries_in R :=
  repeat match goal with |- context [@mulmx ?S ?m ?p ?q ?A ?B] => move: (@mulmx S m p q A B) => ? end;
  apply/matrixP => ? ?; rewrite !mxE; calculate_in R.

Section Tools.

Variables (R : comUnitRingType) (n : nat).
Implicit Types a f g x : 'M[R]_n.
Implicit Type t : R.

Lemma turn_back m (a : 'M_(m, n)) f : orthogonal f -> a *m f *m f^T = a.
Proof. by move=> o; rewrite -mulmxA o mulmx1. Qed.

Lemma turn_forth m (a : 'M_(m, n)) f : orthogonal f -> a *m f^T *m f = a.
Proof. by move=> /orthogonal_left o; rewrite -mulmxA o mulmx1. Qed.

Lemma orthogonal_transpose f : orthogonal f -> orthogonal f^T.
Proof. by move=> /orthogonal_left; rewrite /orthogonal trmxK. Qed.

Lemma orthogonal_product f g : orthogonal f -> orthogonal g -> orthogonal (f *m g).
Proof. by move=> of_ og; rewrite /orthogonal trmx_mul mulmxA (turn_back _ og). Qed.

Lemma orthogonal_relative f g : orthogonal f -> orthogonal g -> orthogonal (g^T *m f).
Proof. by move=> of_ og; apply: orthogonal_product => //; apply: orthogonal_transpose. Qed.

Lemma inverse_transpose f : orthogonal f -> (invmx f)^T = f.
Proof. by move=> o; rewrite orthogonal_inverse // trmxK. Qed.

Lemma transpose_add a x : (a + x)^T = a^T + x^T. Proof. exact: linearD. Qed.
Lemma transpose_sub a x : (a - x)^T = a^T - x^T. Proof. exact: linearB. Qed.
Lemma transpose_opposite a : (- a)^T = - a^T. Proof. exact: linearN. Qed.
Lemma transpose_scale t a : (t *: a)^T = t *: a^T. Proof. exact: linearZ. Qed.
Lemma trace_opposite m (a : 'M[R]_m) : \tr (- a) = - \tr a. Proof. exact: raddfN. Qed.
Lemma trace_sub a x : \tr (a - x) = \tr a - \tr x. Proof. exact: raddfB. Qed.

Lemma trace_product_transpose a x : \tr (a *m x) = \tr (x^T *m a^T).
Proof. by rewrite -trmx_mul mxtrace_tr. Qed.

Lemma pairing_symmetric a x : pairing a x = pairing x a.
Proof.
rewrite /pairing trace_product_transpose trmxK mxtrace_mulC -mxtrace_tr trmx_mul trmxK.
by rewrite mxtrace_mulC.
Qed.

Lemma half_twice (z : R) : (2%:R : R) \is a GRing.unit -> 2%:R^-1 * (z + z) = z.
Proof. by move=> two; rewrite -mulr2n -[z *+ 2]mulr_natl mulKr. Qed.

Lemma zero_of_opposite (z : R) : (2%:R : R) \is a GRing.unit -> z = - z -> z = 0.
Proof. by move=> two opp; rewrite -(half_twice z two) {2}opp subrr mulr0. Qed.

Lemma skew_of_skew_part a : skew (skew_part a).
Proof. by rewrite /skew /skew_part transpose_sub trmxK opprB. Qed.

Lemma four_terms (a x y z : 'M[R]_n) : a - x = y - z <-> a + z = y + x.
Proof.
split=> same; first by rewrite -[a](subrK x) same [RHS]addrC -addrA [x + z]addrC addrA subrK addrC.
by rewrite -[a](addrK z) same addrAC addrK.
Qed.

(* A matrix is symmetric exactly where it gives zero on all skew ones. *)
Lemma symmetric_test a :
  (2%:R : R) \is a GRing.unit -> (forall x, skew x -> \tr (a *m x) = 0) <-> symmetric a.
Proof.
move=> two; split=> [vanishes|a_sym x x_skew]; last first.
  apply: zero_of_opposite => //.
  by rewrite {1}trace_product_transpose x_skew a_sym mulNmx trace_opposite mxtrace_mulC.
apply/eqP; rewrite -subr_eq0; apply/eqP/pairing_nondegenerate => v.
rewrite /pairing transpose_sub trmxK mulmxBl trace_sub.
have <- : \tr (a *m v^T) = \tr (a^T *m v) by rewrite trace_product_transpose trmxK mxtrace_mulC.
by rewrite -trace_sub -mulmxBr vanishes //; apply: skew_of_skew_part.
Qed.

End Tools.

(** ** Slopes

A derivative without limits. Each function of this chapter is a polynomial of the second degree along every
line: \f$c(t) = c(0) + t\,d + t^2q\f$ with \f$d\f$ and \f$q\f$ that do not depend on \f$t\f$. Then \f$d\f$
is its _slope_, and where 2 has an inverse there is only one. *)

Section Slopes.

Variable R : comUnitRingType.

Add Ring laws_for_slopes : (laws_of_a_ring R).

Definition slope (c : R -> R) (d : R) := exists q, forall t, c t = c 0 + t * d + t ^+ 2 * q.

Lemma slope_unique c d d' : (2%:R : R) \is a GRing.unit -> slope c d -> slope c d' -> d = d'.
Proof.
move=> two [q at_t] [q' at_t']; apply: (mulIr two).
have twice e r : (forall t, c t = c 0 + t * e + t ^+ 2 * r) -> e * 2%:R = c 1 - c (-1).
  by move=> at_s; rewrite (at_s 1) (at_s (-1)); calculate_in R.
by rewrite (twice _ _ at_t) (twice _ _ at_t').
Qed.

Lemma slope_eq c c' d : (forall t, c t = c' t) -> slope c d -> slope c' d.
Proof. by move=> same [q at_t]; exists q => t; rewrite -!same. Qed.

Lemma slope_constant a : slope (fun=> a) 0.
Proof. by exists 0 => t; rewrite !mulr0 !addr0. Qed.

Lemma slope_add c c' d d' : slope c d -> slope c' d' -> slope (fun t => c t + c' t) (d + d').
Proof. by move=> [q at_t] [q' at_t']; exists (q + q') => t; rewrite at_t at_t'; calculate_in R. Qed.

Lemma slope_scale a c d : slope c d -> slope (fun t => a * c t) (a * d).
Proof. by move=> [q at_t]; exists (a * q) => t; rewrite at_t; calculate_in R. Qed.

Lemma slope_opp c d : slope c d -> slope (fun t => - c t) (- d).
Proof. by move=> [q at_t]; exists (- q) => t; rewrite at_t; calculate_in R. Qed.

Lemma slope_sum (I : Type) (r : seq I) (c : I -> R -> R) d :
  (forall i, slope (c i) (d i)) -> slope (fun t => \sum_(i <- r) c i t) (\sum_(i <- r) d i).
Proof.
move=> each; elim: r => [|i r IH].
  by rewrite big_nil; apply: slope_eq (slope_constant 0) => t; rewrite big_nil.
by rewrite big_cons; apply: slope_eq (slope_add (each i) IH) => t; rewrite big_cons.
Qed.

(* The rule of products. *)
Lemma slope_trace n (l m a b a' b' : 'M[R]_n) :
  slope (fun t => \tr (l *m (a + t *: b) *m m *m (a' + t *: b')^T))
        (\tr (l *m b *m m *m a'^T) + \tr (l *m a *m m *m b'^T)).
Proof.
exists (\tr (l *m b *m m *m b'^T)) => t; rewrite !scale0r !addr0 transpose_add transpose_scale.
rewrite !(mulmxDl, mulmxDr) -?scalemxAr -?scalemxAl -?scalemxAr -?scalemxAl.
by rewrite !mxtraceD !mxtraceZ; calculate_in R.
Qed.

End Slopes.

(** ** The body: inertia and kinetic energy *)

Section Inertia.

Variables (R : comUnitRingType) (n : nat).
Implicit Types g k v x y L M xi eta zeta : 'M[R]_n.

Add Ring laws_for_inertia : (laws_of_a_ring R).

(** The operator of inertia, \f$J(\xi) = \Lambda\xi + \xi\Lambda\f$.
C++: `actio::body_momentum`, `rigid_body/inertia.hpp`. *)
Definition inertia_operator L xi := L *m xi + xi *m L.

(** ** The operator of inertia

Section 5.0 says that \f$J\f$ is an operator on \f$so(n)\f$, and symmetric. It takes skew matrices to skew
ones and is symmetric for the trace pairing, for every symmetric \f$\Lambda\f$; for the second property the
arguments may be any matrices. That it is positive follows below, over ordered numbers. *)
Theorem claim_5_0_inertia_operator_skew L xi : symmetric L -> skew xi -> skew (inertia_operator L xi).
Proof.
move=> L_sym xi_skew; rewrite /skew /inertia_operator transpose_add !trmx_mul L_sym xi_skew.
by rewrite mulNmx mulmxN -opprD addrC.
Qed.

Theorem claim_5_0_inertia_operator_symmetric L x y :
  symmetric L -> pairing x (inertia_operator L y) = pairing (inertia_operator L x) y.
Proof.
move=> L_sym; rewrite /pairing /inertia_operator transpose_add !trmx_mul L_sym mulmxDr mulmxDl !mxtraceD.
by rewrite !mulmxA; congr (_ + _); rewrite mxtrace_mulC !mulmxA.
Qed.

(** The trace is a sum of squares with weights: for \f$\Lambda = \mathrm{diag}(d)\f$ and any matrix \f$x\f$,
\f$\mathrm{Tr}(x^TJ(x)) = \sum_{i,j}(d_i+d_j)\,x_{ij}^2\f$. *)
Theorem claim_5_0_inertia_operator_by_planes (d : 'rV[R]_n) x :
  pairing x (inertia_operator (diag_mx d) x) = \sum_i \sum_j (d 0 i + d 0 j) * x i j ^+ 2.
Proof.
rewrite exchange_big; apply: eq_bigr => j _; rewrite mxE; apply: eq_bigr => i _.
by rewrite /inertia_operator mul_diag_mx mul_mx_diag !mxE; calculate_in R.
Qed.

(** The metric, four times: the form \f$\mathrm{Tr}(\xi^TJ(\xi))\f$ of \f$\xi = g^{-1}v\f$, where \f$v\f$ is
a tangent vector at \f$g\f$. It is left-invariant. *)
Definition metric L g v := pairing (g^T *m v) (inertia_operator L (g^T *m v)).

Theorem claim_5_0_inertia_operator_left_invariant L k g v :
  orthogonal k -> metric L (k *m g) (k *m v) = metric L g v.
Proof. by move=> o; rewrite /metric trmx_mul !mulmxA (turn_forth _ o). Qed.

(** The kinetic energy of a body velocity, (5.1): \f$l(\xi) = \tfrac14\mathrm{Tr}(\xi^TJ(\xi))\f$.
C++: `actio::kinetic_energy`, `rigid_body/inertia.hpp`. *)
Definition kinetic_energy L xi := 4%:R^-1 * pairing xi (inertia_operator L xi).

Lemma one_trace L xi :
  (2%:R : R) \is a GRing.unit -> skew xi -> kinetic_energy L xi = 2%:R^-1 * \tr (xi^T *m L *m xi).
Proof.
move=> two xi_skew; rewrite /kinetic_energy /pairing /inertia_operator mulmxDr mxtraceD !mulmxA.
have -> : \tr (xi^T *m xi *m L) = \tr (xi^T *m L *m xi).
  by rewrite xi_skew !mulNmx !trace_opposite -mulmxA mxtrace_mulC.
by rewrite (natrM _ 2 2) invrM // -mulrA half_twice.
Qed.

(** A body of \f$N\f$ point masses \f$m_a\f$ at the places \f$x_a\f$: its matrix
\f$\Lambda = \sum_am_ax_ax_a^T\f$, and its energy where the masses move at the velocities \f$vx_a\f$. *)
Definition second_moments (N : nat) (m : 'I_N -> R) (x : 'I_N -> 'cV[R]_n) : 'M[R]_n :=
  \sum_a m a *: (x a *m (x a)^T).

Definition energy_of_masses (N : nat) (m : 'I_N -> R) (x : 'I_N -> 'cV[R]_n) v :=
  2%:R^-1 * \sum_a m a * \tr ((v *m x a)^T *m (v *m x a)).

(** ** The Lagrangian is the kinetic energy, (5.1)

A body at the attitude \f$g\f$ with the body velocity \f$\xi\f$ moves its masses at \f$g\xi x_a\f$. Their
kinetic energy is \f$\tfrac14\langle\xi, J\xi\rangle\f$ with the pairing \f$\mathrm{Tr}(A^TB)\f$, whatever
the attitude. *)
Theorem eq_5_1 N (m : 'I_N -> R) (x : 'I_N -> 'cV[R]_n) g xi :
  (2%:R : R) \is a GRing.unit -> orthogonal g -> skew xi ->
  energy_of_masses m x (g *m xi) = kinetic_energy (second_moments m x) xi.
Proof.
move=> two o xi_skew; rewrite one_trace //; congr (_ * _).
rewrite /second_moments mulmx_sumr mulmx_suml raddf_sum; apply: eq_bigr => a _ /=.
rewrite -scalemxAr -scalemxAl mxtraceZ; congr (_ * _).
rewrite !trmx_mul !mulmxA (turn_forth _ o) xi_skew !(mulmxN, mulNmx) !trace_opposite; congr (- _).
by rewrite -!mulmxA mxtrace_mulC -!mulmxA [LHS]mxtrace_mulC !mulmxA.
Qed.

(** The Lagrangian of a motion through \f$g\f$ with the velocity \f$\dot g = v\f$. *)
Definition lagrangian L g v := kinetic_energy L (g^T *m v).

(** ** The factor of the discrete Lagrangian, (5.2)

Section 5.1 evaluates the Lagrangian (5.1) at the configuration \f$q\f$, here `g`, and the velocity
\f$q\zeta\f$. Whatever \f$q\f$ and \f$\zeta\f$ are, that is
\f$\tfrac14\langle\zeta,\mathcal J(\zeta)\rangle\f$, with the factor and the pairing of (5.1); and it is the
same for \f$-\zeta\f$. *)
Theorem eq_5_2_factor L g zeta :
  orthogonal g ->
  lagrangian L g (left_translation g zeta) = 4%:R^-1 * pairing zeta (inertia_operator L zeta) /\
  lagrangian L g (left_translation g (- zeta)) = lagrangian L g (left_translation g zeta).
Proof.
move=> o; rewrite /lagrangian /left_translation !mulmxA (orthogonal_left o) !mul1mx; split=> //.
rewrite /kinetic_energy /pairing /inertia_operator transpose_opposite mulNmx mulmxN mulNmx.
by rewrite -opprD mulmxN opprK.
Qed.

(** ** On which space the pairing lives

Section 5.0 calls the brackets of (5.1) the pairing between the Lie group and its dual. It is the pairing of
the Lie _algebra_ with its dual: on skew matrices the trace is a pairing, that is, nothing but zero pairs to
zero with all of them. Between elements of the group the same trace is a constant,
\f$\mathrm{Tr}(g^TJ(g)) = 2\,\mathrm{Tr}\Lambda\f$, and knows nothing of the motion. *)
Theorem claim_5_0_pairing_on_the_algebra M :
  (2%:R : R) \is a GRing.unit -> skew M -> (forall xi, skew xi -> pairing M xi = 0) -> M = 0.
Proof.
move=> two M_skew vanishes; apply: pairing_nondegenerate => v.
have : pairing M (skew_part v) = 0 by apply: vanishes; apply: skew_of_skew_part.
rewrite /skew_part /pairing mulmxBr trace_sub.
have -> : \tr (M^T *m v^T) = - \tr (M^T *m v).
  by rewrite trace_product_transpose !trmxK mxtrace_mulC M_skew mulNmx trace_opposite opprK.
by rewrite opprK => double; rewrite -(half_twice (\tr _) two) double mulr0.
Qed.

Theorem claim_5_0_pairing_on_the_group L g :
  orthogonal g -> pairing g (inertia_operator L g) = 2%:R * \tr L.
Proof.
move=> o; rewrite /pairing mulmxDr mxtraceD !mulmxA (orthogonal_left o) mul1mx mxtrace_mulC mulmxA o mul1mx.
by calculate_in R.
Qed.

End Inertia.

(** ** The bodies and motions of the counterexamples

A generalized body as in section 5.0: \f$\Lambda\f$ is diagonal, \f$\Lambda_i+\Lambda_j > 0\f$ for
\f$i\ne j\f$. All counterexamples have the body \f$\Lambda = \mathrm{diag}(1, 3, 2)\f$, of which the
principal moments are 5, 3 and 4, and relative motions with determinant 1. *)

Definition special_orthogonal (R : comUnitRingType) n (f : 'M[R]_n) := orthogonal f /\ \det f = 1.

Definition generalized_body n (L : 'M[Qc]_n) :=
  is_diag_mx L /\ forall i j, i != j -> Qclt 0 (L i i + L j j).

Lemma generalized_body_symmetric n (L : 'M[Qc]_n) : generalized_body L -> symmetric L.
Proof.
move=> [/is_diag_mxP diagonal _]; apply/matrixP => i j; rewrite mxE.
by case: (eqVneq i j) => [->//|ne]; rewrite !diagonal // eq_sym.
Qed.

Definition the_body : rows := integers [:: [:: 1; 0; 0]; [:: 0; 3; 0]; [:: 0; 0; 2]].
Definition no_turn : rows := integers [:: [:: 1; 0; 0]; [:: 0; 1; 0]; [:: 0; 0; 1]].
Definition quarter_turn : rows := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 1]].

(** Four relative motions that follow one another for ever: each pair of neighbours in the circle solves the
equation of motion (5.7) for the body above. The step is a quarter of a period. *)
Definition turn_0 : rows := over 35 [:: [:: -15; 30; -10]; [:: 30; 17; 6]; [:: 10; -6; -33]].
Definition turn_1 : rows := over 7 [:: [:: -6; 3; -2]; [:: -3; -2; 6]; [:: 2; 6; 3]].
Definition turn_2 : rows := over 35 [:: [:: -15; -30; -10]; [:: -30; 17; -6]; [:: 10; 6; -33]].
Definition turn_3 : rows := over 7 [:: [:: -6; -3; -2]; [:: 3; -2; -6]; [:: 2; -6; 3]].

Lemma the_body_is_one : generalized_body (matrix_of 3 the_body).
Proof.
split; first by apply/is_diag_mxP => -[[|[|[|//]]] ?] [[|[|[|//]]] ?] // _; rewrite -!computedE.
by move=> -[[|[|[|//]]] ?] [[|[|[|//]]] ?] // _; rewrite -!computedE.
Qed.

Ltac decide_rotation := split; [decide_by_computation | decide_by_computation].

Lemma no_turn_is_one : special_orthogonal (matrix_of 3 no_turn). Proof. by decide_rotation. Qed.
Lemma quarter_turn_is_one : special_orthogonal (matrix_of 3 quarter_turn). Proof. by decide_rotation. Qed.
Lemma turn_0_is_one : special_orthogonal (matrix_of 3 turn_0). Proof. by decide_rotation. Qed.
Lemma turn_1_is_one : special_orthogonal (matrix_of 3 turn_1). Proof. by decide_rotation. Qed.
Lemma turn_2_is_one : special_orthogonal (matrix_of 3 turn_2). Proof. by decide_rotation. Qed.
Lemma turn_3_is_one : special_orthogonal (matrix_of 3 turn_3). Proof. by decide_rotation. Qed.

(** ** The printed factor

The print has \f$\tfrac12\langle\zeta,\mathcal J(\zeta)\rangle\f$ in (5.2). With the factor and the pairing
of (5.1) that is twice the energy. *)
Theorem eq_5_2_printed_fails :
  ~ (forall L g zeta : 'M[Qc]_3, generalized_body L -> special_orthogonal g -> skew zeta ->
       lagrangian L g (left_translation g zeta) = 2%:R^-1 * pairing zeta (inertia_operator L zeta)).
Proof.
pose spin := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 0]].
have spin_skew : skew (matrix_of 3 spin) by decide_by_computation.
move/(_ _ _ _ the_body_is_one quarter_turn_is_one spin_skew).
by rewrite /lagrangian /kinetic_energy /inertia_operator; decide_by_computation.
Qed.

(** ** The operator of inertia is positive

Over ordered numbers: \f$J\f$ takes skew matrices to skew ones, is symmetric, and
\f$\mathrm{Tr}(\xi^TJ(\xi)) > 0\f$ for all skew \f$\xi\ne0\f$ _exactly_ where \f$\Lambda_i+\Lambda_j>0\f$
for all \f$i\ne j\f$. So the condition of section 5.0 is not only enough, and one \f$\Lambda_i\f$ may be
negative. *)

Section Positivity.

Import Order.TTheory Num.Theory.

Variables (F : realFieldType) (n : nat).

Theorem claim_5_0_inertia_operator_positive (d : 'rV[F]_n) :
  (forall i j, i != j -> 0 < d 0 i + d 0 j) <->
  (forall xi : 'M[F]_n, skew xi -> xi != 0 -> 0 < pairing xi (inertia_operator (diag_mx d) xi)).
Proof.
split=> [sums xi xi_skew nonzero|positive i j ne].
  have diagonal i : xi i i = 0.
    by move/matrixP/(_ i i)/eqP: xi_skew; rewrite !mxE -addr_eq0 -mulr2n mulrn_eq0 => /eqP.
  rewrite claim_5_0_inertia_operator_by_planes pair_bigA /=.
  have term (p : 'I_n * 'I_n) : true -> 0 <= (d 0 p.1 + d 0 p.2) * xi p.1 p.2 ^+ 2.
    move=> _; case: (eqVneq p.1 p.2) => [->|ne]; first by rewrite diagonal expr0n mulr0.
    by rewrite mulr_ge0 ?sqr_ge0 // ltW // sums.
  rewrite lt0r sumr_ge0 // andbT; apply: contra nonzero => /eqP/(psumr_eq0P term) zero.
  apply/eqP/matrixP => i j; rewrite mxE; case: (eqVneq i j) => [->|ne]; first exact: diagonal.
  have /eqP := zero (i, j) isT.
  by rewrite mulf_eq0 (gt_eqF (sums i j ne)) sqrf_eq0 => /eqP.
(* The other way: turn in the plane of the axes i and j alone. *)
pose xi : 'M[F]_n := delta_mx i j - delta_mx j i.
have xi_skew : skew xi by rewrite /skew /xi linearB /= !trmx_delta opprB.
have xi_ij : xi i j = 1 by rewrite !mxE !eqxx (negbTE ne) subr0.
have xi_ji : xi j i = -1 by rewrite !mxE !eqxx eq_sym (negbTE ne) sub0r.
have : 0 < pairing xi (inertia_operator (diag_mx d) xi).
  by apply: positive => //; apply/eqP => zero; move: xi_ij; rewrite zero mxE => /eqP; rewrite eq_sym oner_eq0.
rewrite claim_5_0_inertia_operator_by_planes pair_bigA /= (bigD1 (i, j)) //= (bigD1 (j, i)) /=; last first.
  by rewrite xpair_eqE negb_and eq_sym ne.
rewrite big1 => [|[a b] /= /andP[ne1 ne2]]; last first.
  have -> : xi a b = 0; last by rewrite expr0n mulr0.
  by move: ne1 ne2; rewrite !xpair_eqE !mxE => /negbTE-> /negbTE->; rewrite subrr.
by rewrite xi_ij xi_ji sqrrN expr1n !mulr1 addr0 [d 0 j + _]addrC -mulr2n pmulrn_lgt0.
Qed.

Theorem claim_5_0_inertia_operator (d : 'rV[F]_n) (L := diag_mx d) :
  (forall xi : 'M[F]_n, skew xi -> skew (inertia_operator L xi)) /\
  (forall x y, pairing x (inertia_operator L y) = pairing (inertia_operator L x) y) /\
  ((forall i j, i != j -> 0 < d 0 i + d 0 j) <->
   (forall xi : 'M[F]_n, skew xi -> xi != 0 -> 0 < pairing xi (inertia_operator L xi))).
Proof.
have L_sym : symmetric L by rewrite /symmetric tr_diag_mx.
split; first by move=> xi; apply: claim_5_0_inertia_operator_skew.
split; first by move=> x y; apply: claim_5_0_inertia_operator_symmetric.
exact: claim_5_0_inertia_operator_positive.
Qed.

End Positivity.

(** ** The trace Lagrangian and its discretization

Section 5.2, first part. *)

Section Discretization.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g k L xi : 'M[R]_n.
Implicit Types h e : R.

Add Ring laws_for_discretization : (laws_of_a_ring R).

(** ** The Lagrangian with one trace

Section 5.2: \f$\tfrac14\mathrm{Tr}(\xi^TJ(\xi)) = \tfrac12\mathrm{Tr}(\xi^T\Lambda\xi)\f$. The matrix
\f$\xi\f$ must be skew, but \f$\Lambda\f$ may be any matrix, also one that is not symmetric. *)
Theorem claim_5_2_trace_lagrangian L xi :
  (2%:R : R) \is a GRing.unit -> skew xi -> kinetic_energy L xi = 2%:R^-1 * \tr (xi^T *m L *m xi).
Proof. exact: one_trace. Qed.

(** The velocity as a difference, (5.5): \f$D = \tfrac1hg_{k+1}^T(g_{k+1}-g_k)\f$; and the one at the other
end, \f$D' = \tfrac1hg_k^T(g_{k+1}-g_k)\f$. *)
Definition velocity_at_end h g0 g1 := h^-1 *: (g1^T *m (g1 - g0)).
Definition velocity_at_start h g0 g1 := h^-1 *: (g0^T *m (g1 - g0)).

Lemma velocity_at_endE h g0 g1 : orthogonal g1 -> velocity_at_end h g0 g1 = h^-1 *: (1%:M - g1^T *m g0).
Proof. by move=> o; rewrite /velocity_at_end mulmxBr (orthogonal_left o). Qed.

Lemma velocity_at_startE h g0 g1 : orthogonal g0 -> velocity_at_start h g0 g1 = h^-1 *: (g0^T *m g1 - 1%:M).
Proof. by move=> o; rewrite /velocity_at_start mulmxBr (orthogonal_left o). Qed.

(** ** The difference that stands for the velocity, (5.5)

To first order in the step it is the velocity: let \f$\varepsilon^2=0\f$, let the motion begin at \f$g\f$
with the body velocity \f$\xi\f$, and let the step be so short that \f$g_{k+1} = g(1+\varepsilon\xi)\f$;
then \f$hD = \varepsilon\xi\f$. Here \f$\xi\f$ may be any matrix. But \f$D\f$ is no element of the algebra:
exactly, \f$D + D^T = h\,D^TD\f$. And it is seen from the body: \f$D\f$ is the same for
\f$kg_k, kg_{k+1}\f$. *)
Theorem eq_5_5_first_order h e g xi :
  h \is a GRing.unit -> e ^+ 2 = 0 -> orthogonal g ->
  h *: velocity_at_end h g (g *m (1%:M + e *: xi)) = e *: xi.
Proof.
move=> unit small o; rewrite /velocity_at_end scalerA mulrV // scale1r.
have -> : g *m (1%:M + e *: xi) - g = e *: (g *m xi).
  by rewrite mulmxDr mulmx1 -scalemxAr addrAC subrr add0r.
rewrite trmx_mul transpose_add trmx1 transpose_scale -scalemxAr -mulmxA [g^T *m _]mulmxA (orthogonal_left o).
by rewrite mul1mx mulmxDl mul1mx -scalemxAl scalerDr scalerA -expr2 small scale0r addr0.
Qed.

Theorem eq_5_5_not_skew h g0 g1 (D := velocity_at_end h g0 g1) :
  h \is a GRing.unit -> orthogonal g0 -> orthogonal g1 -> D + D^T = h *: (D^T *m D).
Proof.
move=> unit o0 o1; rewrite /D velocity_at_endE //; have := orthogonal_relative o0 o1.
move: (g1^T *m g0) => f of_; rewrite transpose_scale -scalemxAl -scalemxAr -scalerDr !scalerA mulrV // mul1r.
congr (_ *: _); rewrite transpose_sub trmx1.
rewrite !(mulmxBl, mulmxBr) !(mul1mx, mulmx1) (orthogonal_left of_).
by compare_entries_in R.
Qed.

Theorem eq_5_5_left_invariant h k g0 g1 :
  orthogonal k -> velocity_at_end h (k *m g0) (k *m g1) = velocity_at_end h g0 g1.
Proof. by move=> o; rewrite /velocity_at_end -mulmxBr trmx_mul !mulmxA (turn_forth _ o). Qed.

(** The discrete Lagrangian of section 5.2, scaled: \f$\mathrm{Tr}(g_k\Lambda g_{k+1}^T)\f$, without the
factor \f$-1/h^2\f$. *)
Definition discrete_lagrangian L g0 g1 := \tr (g0 *m L *m g1^T).

Lemma trace_of_difference L f :
  orthogonal f -> symmetric L -> \tr ((1%:M - f)^T *m L *m (1%:M - f)) = 2%:R * (\tr L - \tr (f *m L)).
Proof.
move=> of_ L_sym; rewrite transpose_sub trmx1 !(mulmxBl, mulmxBr) !(mul1mx, mulmx1) !trace_sub.
have -> : \tr (f^T *m L *m f) = \tr L by rewrite mxtrace_mulC mulmxA of_ mul1mx.
have -> : \tr (f^T *m L) = \tr (f *m L) by rewrite trace_product_transpose trmxK L_sym mxtrace_mulC.
by rewrite [\tr (L *m f)]mxtrace_mulC; calculate_in R.
Qed.

(** ** The discrete Lagrangian

The difference (5.5) in the Lagrangian gives
\f[ \tfrac12\mathrm{Tr}(D^T\Lambda D) = -\frac1{h^2}\mathrm{Tr}(g_k\Lambda g_{k+1}^T) +
\frac1{h^2}\mathrm{Tr}\Lambda . \f]
The last term is what the thesis leaves out, _modulo_ \f$\mathbb R\f$. Here \f$\Lambda\f$ must be symmetric;
the step \f$h\f$ may be any number, for \f$h^{-1}\f$ is only a factor. *)
Theorem claim_5_2_discrete_trace_lagrangian h L g0 g1 (D := velocity_at_end h g0 g1) :
  (2%:R : R) \is a GRing.unit -> symmetric L -> orthogonal g0 -> orthogonal g1 ->
  2%:R^-1 * \tr (D^T *m L *m D) = - h^-2 * discrete_lagrangian L g0 g1 + h^-2 * \tr L.
Proof.
move=> two L_sym o0 o1; rewrite /D velocity_at_endE // transpose_scale -!scalemxAl -scalemxAr !mxtraceZ.
rewrite trace_of_difference //; last exact: orthogonal_relative.
rewrite -[g1^T *m g0 *m L]mulmxA [\tr (g1^T *m _)]mxtrace_mulC -/(discrete_lagrangian L g0 g1) -exprVn.
set s := 2%:R^-1; have once : s * 2%:R = 1 by apply: mulVr.
by rewrite -[RHS]mul1r -[X in _ = X * _]once; calculate_in R.
Qed.

(** ** The difference at the other end

With \f$D'\f$ in place of \f$D\f$ the value is the same, although \f$D' = g_k^Tg_{k+1}D\f$ is another
matrix. Nothing is asked of \f$\Lambda\f$. *)
Theorem claim_5_2_other_difference h L g0 g1
    (D := velocity_at_end h g0 g1) (D' := velocity_at_start h g0 g1) :
  orthogonal g0 -> orthogonal g1 ->
  \tr (D'^T *m L *m D') = \tr (D^T *m L *m D) /\ D' = g0^T *m g1 *m D.
Proof.
move=> o0 o1; split; last first.
  by rewrite /D /D' /velocity_at_end /velocity_at_start -scalemxAr !mulmxA (turn_back _ o1).
rewrite /D /D' velocity_at_endE // velocity_at_startE //.
have -> : g0^T *m g1 = (g1^T *m g0)^T by rewrite trmx_mul trmxK.
have := orthogonal_relative o0 o1; move: (g1^T *m g0) => f of_.
rewrite !transpose_scale -!scalemxAl -!scalemxAr !mxtraceZ !transpose_sub trmx1 trmxK.
congr (_ * (_ * _)); rewrite !(mulmxBl, mulmxBr) !(mul1mx, mulmx1) !trace_sub.
rewrite [\tr (f *m L *m f^T)]mxtrace_mulC [\tr (f^T *m L *m f)]mxtrace_mulC !mulmxA of_ (orthogonal_left of_).
by rewrite mul1mx [\tr (f *m L)]mxtrace_mulC [\tr (f^T *m L)]mxtrace_mulC; calculate_in R.
Qed.


(** ** The Lagrangian of Moser and Veselov

Up to the factor \f$-1/h^2\f$ it is theirs, \f$\mathrm{Tr}(X\Lambda Y^T) = \sum_{i,j}d_j\,X_{ij}Y_{ij}\f$
for \f$\Lambda = \mathrm{diag}(d)\f$. The constant that was left out drops out between two pairs of
configurations. *)
Theorem claim_5_2_moser_veselov_multiple h (d : 'rV[R]_n) g0 g1 g2 g3
    (ours := fun x y (D := velocity_at_end h x y) => 2%:R^-1 * \tr (D^T *m diag_mx d *m D))
    (theirs := fun x y : 'M[R]_n => \sum_i \sum_j d 0 j * x i j * y i j) :
  (2%:R : R) \is a GRing.unit -> orthogonal g0 -> orthogonal g1 -> orthogonal g2 -> orthogonal g3 ->
  ours g0 g1 - ours g2 g3 = - h^-2 * (theirs g0 g1 - theirs g2 g3).
Proof.
move=> two o0 o1 o2 o3; have d_sym : symmetric (diag_mx d) by rewrite /symmetric tr_diag_mx.
have entries x y : discrete_lagrangian (diag_mx d) x y = theirs x y.
  apply: eq_bigr => i _; rewrite mxE; apply: eq_bigr => j _.
  by rewrite mul_mx_diag !mxE [d 0 j * _]mulrC.
by rewrite /ours !claim_5_2_discrete_trace_lagrangian // !entries; calculate_in R.
Qed.

End Discretization.

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

(** ** The momenta of a step and their update

Section 5.2, third part. Momenta are those of the scaled Lagrangian \f$\mathrm{Tr}(f\Lambda)\f$, \f$h\f$
times the physical ones. *)

Section Momenta.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g L Pi theta xi : 'M[R]_n.
Implicit Types h : R.

Add Ring laws_for_momenta : (laws_of_a_ring R).

(** The body momentum before a step with the relative motion \f$f\f$, multiplied by the step \f$h\f$:
\f$f^T\Lambda - \Lambda f\f$.
C++: `actio::MoserVeselov::momentum_before`, `rigid_body/moser_veselov.hpp`. *)
Definition momentum_before f L := f^T *m L - L *m f.

(** The body momentum after it, multiplied by \f$h\f$: \f$\Lambda f^T - f\Lambda\f$.
C++: `actio::MoserVeselov::momentum_after`, `rigid_body/moser_veselov.hpp`. *)
Definition momentum_after f L := L *m f^T - f *m L.

Lemma momentum_before_skew f L : symmetric L -> skew (momentum_before f L).
Proof. by move=> L_sym; rewrite /skew /momentum_before transpose_sub !trmx_mul trmxK L_sym opprB. Qed.

(** ** The update by conjugation

Within one step, for every orthogonal \f$f\f$ and every \f$\Lambda\f$, symmetric or not,
\f$f\,(f^T\Lambda-\Lambda f)\,f^T = \Lambda f^T - f\Lambda\f$. So (5.7) _is_ the update
\f$\Pi_{k+1} = f_{k+1k}\Pi_kf_{k+1k}^T\f$ of the momenta
\f$\Pi_k = f_{k+1k}^T\Lambda - \Lambda f_{k+1k}\f$. *)
Theorem claim_5_2_update_by_conjugation_within_a_step f L :
  orthogonal f -> f *m momentum_before f L *m f^T = momentum_after f L.
Proof. by move=> o; rewrite /momentum_before mulmxBr mulmxBl !mulmxA o mul1mx (turn_back _ o). Qed.

Theorem claim_5_2_update_by_conjugation f10 f21 L :
  orthogonal f10 ->
  discrete_euler_poincare L f10 f21 <-> momentum_before f21 L = f10 *m momentum_before f10 L *m f10^T.
Proof. by move=> o; rewrite claim_5_2_update_by_conjugation_within_a_step. Qed.

(** ** The update by an adjoint operator

For every matrix \f$\Pi\f$ the product \f$f\Pi f^T\f$ is \f$\mathrm{Ad}^*_{f^{-1}}\Pi\f$, and on the
rotation group also \f$\mathrm{Ad}_f\Pi\f$. *)
Theorem claim_5_2_update_by_adjoint f Pi :
  orthogonal f -> Ad_star (invmx f) Pi = f *m Pi *m f^T /\ Ad_star (invmx f) Pi = Ad f Pi.
Proof.
by move=> o; rewrite /Ad_star /Ad !orthogonal_inverse // ?trmxK //; apply: orthogonal_transpose.
Qed.

(** ** The algorithm on the dual, (5.8)

The solution \f$f_{k+1k}\f$ of (5.7) carries the momentum on:
\f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\Pi_k = f_{k+1k}\Pi_kf_{k+1k}^T\f$, with a star that the print
lacks. *)
Theorem eq_5_8 f10 f21 L (Pi := fun f => momentum_before f L) :
  orthogonal f10 -> discrete_euler_poincare L f10 f21 ->
  Pi f21 = Ad_star (invmx f10) (Pi f10) /\ Ad_star (invmx f10) (Pi f10) = f10 *m Pi f10 *m f10^T.
Proof.
move=> o motion; have [-> _] := claim_5_2_update_by_adjoint (Pi f10) o; split=> //.
exact/claim_5_2_update_by_conjugation.
Qed.

(** The update keeps the momentum in space, whatever \f$\Pi\f$ and the orthogonal \f$f\f$ are: the momentum
\f$f\Pi f^T\f$ at the attitude \f$gf^{-1}\f$ is in space what \f$\Pi\f$ is at \f$g\f$. *)
Theorem claim_5_2_manifest_preservation_in_space g f Pi (g1 := g *m invmx f) :
  orthogonal f -> g1 *m (f *m Pi *m f^T) *m g1^T = g *m Pi *m g^T.
Proof.
by move=> o; rewrite /g1 trmx_mul inverse_transpose // orthogonal_inverse // !mulmxA !(turn_forth _ o).
Qed.

(** ** The momentum of a short step

To first order in the step the momentum is \f$\mathcal J\xi\f$ times the step: let
\f$g_{k+1} = g(1+\varepsilon\xi)\f$ with a skew \f$\xi\f$, which is orthogonal where
\f$\varepsilon^2 = 0\f$; then \f$M = \varepsilon\mathcal J(\xi)\f$. Any \f$\Lambda\f$. *)
Theorem claim_5_2_momentum_limit_first_order (e : R) g L xi (g1 := g *m (1%:M + e *: xi)) :
  orthogonal g -> skew xi ->
  momentum_before (g1^T *m g) L = e *: inertia_operator L xi /\ (e ^+ 2 = 0 -> orthogonal g1).
Proof.
move=> o xi_skew; have transposed : (1%:M + e *: xi)^T = 1%:M - e *: xi.
  by rewrite transpose_add trmx1 transpose_scale xi_skew scalerN.
split=> [|small].
  have -> : g1^T *m g = 1%:M - e *: xi by rewrite /g1 trmx_mul transposed (turn_forth _ o).
  rewrite /momentum_before -{1}transposed trmxK.
  rewrite !(mulmxBr, mulmxDl) mul1mx mulmx1 -scalemxAl -scalemxAr /inertia_operator.
  by compare_entries_in R.
rewrite /orthogonal /g1 trmx_mul transposed mulmxA -[g *m _ *m _]mulmxA.
have -> : (1%:M + e *: xi) *m (1%:M - e *: xi) = 1%:M; last by rewrite mulmx1.
rewrite mulmxDl mul1mx mulmxBr mulmx1 -scalemxAl -scalemxAr scalerA -expr2 small scale0r subr0.
by rewrite subrK.
Qed.

(** ** Reconstruction

The configuration \f$g_{k+1} = g_kf^{-1}\f$ has the relative motion \f$f\f$ to \f$g_k\f$; and the three
configurations \f$g_{k-1}, g_k, g_kf^{-1}\f$ satisfy the discrete Euler-Lagrange equation exactly where
\f$f\f$ solves (5.7). *)
Theorem claim_5_2_reconstruction L g0 g1 f (g2 := g1 *m invmx f) :
  symmetric L -> orthogonal g0 -> orthogonal g1 -> orthogonal f ->
  relative_motion g1 g2 = f /\
  (discrete_euler_lagrange L g0 g1 g2 <-> discrete_euler_poincare L (relative_motion g0 g1) f).
Proof.
move=> L_sym o0 o1 of_.
have o2 : orthogonal g2.
  by rewrite /g2 orthogonal_inverse //; apply: orthogonal_product => //; apply: orthogonal_transpose.
have is_f : g2^T *m g1 = f.
  by rewrite /g2 trmx_mul inverse_transpose // -mulmxA (orthogonal_left o1) mulmx1.
by rewrite !relative_motionE // is_f eq_5_6_motion // is_f.
Qed.

End Momenta.

(** ** The update without a star

The two expressions that (5.8) prints as equal, \f$\mathrm{Ad}_{f^{-1}}\Pi\f$ and \f$f\Pi f^T\f$, are not;
and along a motion of the body the first of them, without a star, is not the next momentum. The momenta that
refute it are those of a body in a solution of (5.7). *)

Lemma the_turns_follow :
  [/\ discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_0) (matrix_of 3 turn_1),
      discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_1) (matrix_of 3 turn_2),
      discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_2) (matrix_of 3 turn_3) &
      discrete_euler_poincare (matrix_of 3 the_body) (matrix_of 3 turn_3) (matrix_of 3 turn_0)].
Proof. by rewrite /discrete_euler_poincare; split; decide_by_computation. Qed.

Theorem eq_5_8_printed_fails :
  ~ (forall L f10 f21 : 'M[Qc]_3, generalized_body L -> special_orthogonal f10 -> special_orthogonal f21 ->
       discrete_euler_poincare L f10 f21 ->
       Ad (invmx f10) (momentum_before f10 L) = f10 *m momentum_before f10 L *m f10^T).
Proof.
case: the_turns_follow => follow _ _ _.
move/(_ _ _ _ the_body_is_one turn_0_is_one turn_1_is_one follow); rewrite /momentum_before.
by decide_by_computation.
Qed.

Theorem claim_5_2_update_by_adjoint_printed_fails :
  ~ (forall L f10 f21 : 'M[Qc]_3, generalized_body L -> special_orthogonal f10 -> special_orthogonal f21 ->
       discrete_euler_poincare L f10 f21 ->
       momentum_before f21 L = Ad (invmx f10) (momentum_before f10 L)).
Proof.
case: the_turns_follow => follow _ _ _.
move/(_ _ _ _ the_body_is_one turn_0_is_one turn_1_is_one follow); rewrite /momentum_before.
by decide_by_computation.
Qed.

(** ** The equations of Moser and Veselov *)

Section MoserVeselovEquations.

Variables (R : comUnitRingType) (n : nat).
Implicit Types f g L m theta : 'M[R]_n.
Implicit Types gs omegas Ms Pis : nat -> 'M[R]_n.

Add Ring laws_for_moser_veselov : (laws_of_a_ring R).

(** A sequence \f$\omega_k\f$ and momenta \f$M_k\f$ that satisfy (5.9), with \f$\omega_k\f$ in the first
line: \f$M_{k+1} = \omega_kM_k\omega_k^{-1}\f$ and \f$M_k = \omega_k^T\Lambda - \Lambda\omega_k\f$. *)
Definition moser_veselov L omegas Ms :=
  (forall k, Ms k.+1 = omegas k *m Ms k *m invmx (omegas k)) /\
  (forall k, Ms k = (omegas k)^T *m L - L *m omegas k).

(** The same as printed, with \f$\omega_{k-1}\f$ in the first line. *)
Definition moser_veselov_as_printed L omegas Ms :=
  (forall k, (0 < k)%N -> Ms k.+1 = omegas k.-1 *m Ms k *m invmx (omegas k.-1)) /\
  (forall k, Ms k = (omegas k)^T *m L - L *m omegas k).

(** Momenta that satisfy (5.8) along a sequence of relative motions, each the momentum of its step. *)
Definition discrete_lie_poisson L fs Pis :=
  (forall k, Pis k.+1 = Ad_star (invmx (fs k)) (Pis k)) /\
  (forall k, Pis k = momentum_before (fs k) L).

(** ** Theorem 5.2.1

A sequence of orthogonal matrices \f$\omega_k = f_{kk-1}\f$ satisfies (5.7) at every step exactly where
there are momenta with which it satisfies the equations of Moser and Veselov; and these are the equations
(5.8) with the same momenta. Any \f$\Lambda\f$, any size. *)
Theorem thm_5_2_1 L omegas :
  (forall k, orthogonal (omegas k)) ->
  ((forall k, discrete_euler_poincare L (omegas k) (omegas k.+1)) <-> exists Ms, moser_veselov L omegas Ms) /\
  (forall Ms, discrete_lie_poisson L omegas Ms <-> moser_veselov L omegas Ms).
Proof.
move=> o; split.
  split=> [motion|[Ms [first second]] k].
    exists (fun k => momentum_before (omegas k) L); split=> // k.
    by rewrite orthogonal_inverse //; apply/claim_5_2_update_by_conjugation.
  apply/claim_5_2_update_by_conjugation => //; rewrite /momentum_before -!second first.
  by rewrite orthogonal_inverse.
move=> Ms; rewrite /discrete_lie_poisson /moser_veselov; split=> -[first second]; split=> // k.
  by rewrite first (proj1 (claim_5_2_update_by_adjoint _ (o k))) orthogonal_inverse.
by rewrite first (proj1 (claim_5_2_update_by_adjoint _ (o k))) orthogonal_inverse.
Qed.

(** For attitudes \f$g_0, g_1, \dots\f$ and \f$k\ge1\f$: the discrete angular velocity
\f$\omega_k = g_k^Tg_{k-1}\f$, the momentum in space
\f$m_k = g_k\Lambda g_{k-1}^T - g_{k-1}\Lambda g_k^T\f$, and the body momentum
\f$M_k = g_{k-1}^Tm_kg_{k-1}\f$. *)
Definition angular_velocity gs k := (gs k)^T *m gs k.-1.
Definition spatial_momentum L gs k := gs k *m L *m (gs k.-1)^T - gs k.-1 *m L *m (gs k)^T.
Definition body_momentum L gs k := (gs k.-1)^T *m spatial_momentum L gs k *m gs k.-1.

(** Attitudes of which the relative motions satisfy (5.7). *)
Definition motion L gs :=
  forall k, (0 < k)%N -> discrete_euler_poincare L (angular_velocity gs k) (angular_velocity gs k.+1).

Lemma angular_velocity_orthogonal gs k : (forall j, orthogonal (gs j)) -> orthogonal (angular_velocity gs k).
Proof. by move=> o; apply: orthogonal_relative. Qed.

(** ** The second line of (5.9)

The body momentum is \f$M_k = g_{k-1}^Tm_kg_{k-1} = \omega_k^T\Lambda - \Lambda\omega_k\f$, where only
\f$g_{k-1}\f$ must be orthogonal; it is skew for a symmetric \f$\Lambda\f$. And it is a momentum: the slope
of the scaled Lagrangian \f$\mathrm{Tr}(g_{k-1}\Lambda g_k^T)\f$ along \f$g_{k-1}\vartheta\f$, with skew
\f$\vartheta\f$, is \f$\tfrac12\mathrm{Tr}(M_k^T\vartheta)\f$. *)
Theorem claim_5_2_mv_second_line L gs k (omega := angular_velocity gs k) :
  orthogonal (gs k.-1) ->
  body_momentum L gs k = omega^T *m L - L *m omega /\ (symmetric L -> skew (body_momentum L gs k)).
Proof.
move=> o; have second : body_momentum L gs k = momentum_before omega L.
  rewrite /body_momentum /spatial_momentum /momentum_before /omega /angular_velocity mulmxBr mulmxBl.
  by rewrite trmx_mul trmxK !mulmxA (turn_forth _ o) (orthogonal_left o) mul1mx.
by split=> [|L_sym]; rewrite second //; apply: momentum_before_skew.
Qed.

Lemma body_momentumE L gs k :
  orthogonal (gs k.-1) -> body_momentum L gs k = momentum_before (angular_velocity gs k) L.
Proof. by move/(claim_5_2_mv_second_line L) => []. Qed.

Lemma pairing_before f L theta :
  symmetric L -> skew theta -> pairing (momentum_before f L) theta = 2%:R * \tr (f *m theta *m L).
Proof.
move=> L_sym theta_skew.
rewrite /pairing /momentum_before transpose_sub !trmx_mul trmxK L_sym mulmxBl trace_sub.
have -> : \tr (f^T *m L *m theta) = - \tr (f *m theta *m L).
  rewrite trace_product_transpose trmx_mul trmxK theta_skew L_sym mulNmx trace_opposite.
  by rewrite mxtrace_mulC -mulmxA mxtrace_mulC.
by rewrite -[L *m f *m theta]mulmxA [\tr (L *m _)]mxtrace_mulC; calculate_in R.
Qed.

Lemma pairing_after f L theta :
  symmetric L -> skew theta -> pairing (momentum_after f L) theta = 2%:R * \tr (theta *m f *m L).
Proof.
move=> L_sym theta_skew.
have -> : momentum_after f L = - momentum_before f^T L by rewrite /momentum_before trmxK opprB.
have -> : pairing (- momentum_before f^T L) theta = - pairing (momentum_before f^T L) theta.
  by rewrite /pairing -trace_opposite -mulNmx; congr (\tr (_ *m _)); exact: linearN.
rewrite pairing_before // -mulrN -trace_opposite; congr (_ * _).
by rewrite [RHS]trace_product_transpose L_sym trmx_mul theta_skew [RHS]mxtrace_mulC mulmxN mulNmx.
Qed.

Theorem claim_5_2_mv_second_line_slope L g0 g1 theta :
  (2%:R : R) \is a GRing.unit -> symmetric L -> skew theta ->
  slope (fun t => discrete_lagrangian L (g0 + t *: (g0 *m theta)) g1)
        (2%:R^-1 * pairing (momentum_before (g1^T *m g0) L) theta).
Proof.
move=> two L_sym theta_skew; rewrite pairing_before // mulKr //.
have := slope_of_lagrangian L g0 g1 (g0 *m theta) 0.
rewrite trmx0 mulmx0 mxtrace0 addr0 mxtrace_mulC !mulmxA; apply: slope_eq => t.
by rewrite scaler0 addr0.
Qed.

(** ** The first line of (5.9)

It is the left Lie-Poisson equation of a momentum that is constant in space: for _any_ attitudes and any
constant matrix \f$m\f$, the matrices \f$M_k = g_{k-1}^Tmg_{k-1}\f$ obey
\f$M_{k+1} = \omega_kM_k\omega_k^{-1}\f$. *)
Theorem claim_5_2_mv_first_line gs m k (omega := angular_velocity gs)
    (M := fun j => (gs j.-1)^T *m m *m gs j.-1) :
  (forall j, orthogonal (gs j)) -> M k.+1 = omega k *m M k *m invmx (omega k).
Proof.
move=> o; rewrite orthogonal_inverse; last exact: angular_velocity_orthogonal.
by rewrite /M /omega /angular_velocity trmx_mul trmxK !mulmxA !(turn_back _ (o _)).
Qed.

(** ** The equations of Moser and Veselov, (5.9)

Along a motion, \f$M_{k+1} = \omega_kM_k\omega_k^{-1}\f$ and
\f$M_k = \omega_k^T\Lambda - \Lambda\omega_k\f$. *)
Theorem eq_5_9 L gs k (omega := angular_velocity gs) (M := body_momentum L gs) :
  (forall j, orthogonal (gs j)) -> motion L gs -> (0 < k)%N ->
  M k.+1 = omega k *m M k *m invmx (omega k) /\ M k = (omega k)^T *m L - L *m omega k.
Proof.
move=> o along k_first; rewrite /M !body_momentumE //; split=> //.
have o_k := angular_velocity_orthogonal k o; rewrite orthogonal_inverse //.
exact/claim_5_2_update_by_conjugation/along.
Qed.

Lemma spatial_momentum_after L gs k :
  orthogonal (gs k) -> (gs k)^T *m spatial_momentum L gs k *m gs k = momentum_after (angular_velocity gs k) L.
Proof.
move=> o; rewrite /spatial_momentum /momentum_after /angular_velocity mulmxBr mulmxBl trmx_mul trmxK.
by rewrite !mulmxA (turn_forth _ o) (orthogonal_left o) mul1mx.
Qed.

(** ** The momentum in space

Attitudes are a motion exactly where the discrete momentum in space is constant, \f$m_k = m_1\f$. Any
\f$\Lambda\f$. *)
Theorem claim_5_2_spatial_momentum L gs :
  (forall j, orthogonal (gs j)) ->
  motion L gs <-> (forall k, (0 < k)%N -> spatial_momentum L gs k = spatial_momentum L gs 1).
Proof.
move=> o; suff step k : discrete_euler_poincare L (angular_velocity gs k) (angular_velocity gs k.+1) <->
    spatial_momentum L gs k.+1 = spatial_momentum L gs k.
  split=> [along|constant] k k_first; last by apply/step; rewrite !constant.
  by elim: k k_first => // -[|k] IH _ //; rewrite -(IH isT); apply/step/along.
have := body_momentumE L (o k.+1.-1); rewrite /body_momentum /= => second.
rewrite /discrete_euler_poincare -/(momentum_before _ L) -second -/(momentum_after _ L).
rewrite -[RHS]spatial_momentum_after //.
split=> [same|->//]; rewrite -[LHS]mul1mx -(o k) -[RHS]mul1mx -[X in X *m spatial_momentum L gs k](o k).
by rewrite -[LHS](turn_back _ (o k)) -[RHS](turn_back _ (o k)) -!mulmxA; congr (_ *m _); rewrite !mulmxA same.
Qed.

(** ** The two formulations

In the proof of theorem 5.2.1 the variables of the two formulations are identified. Along a motion
\f$f_{kk-1} = \omega_k\f$, and with \f$\pi_0\f$ the constant momentum in space, the momentum
\f$\Pi_{k-1} = \mathrm{Ad}^*_{g_{k-1}}\pi_0\f$ is \f$M_k\f$. *)
Theorem claim_5_2_mv_identifications L gs k (pi0 := spatial_momentum L gs 1) :
  (forall j, orthogonal (gs j)) -> motion L gs -> (0 < k)%N ->
  relative_motion (gs k.-1) (gs k) = angular_velocity gs k /\
  Ad_star (gs k.-1) pi0 = body_momentum L gs k.
Proof.
move=> o along k_first; split; first by rewrite relative_motionE.
rewrite /Ad_star inverse_transpose // /body_momentum.
by move/claim_5_2_spatial_momentum: along => ->.
Qed.

End MoserVeselovEquations.

(** ** The printed index of the first line

The thesis prints \f$M_{k+1} = \omega_{k-1}M_k\omega_{k-1}^{-1}\f$. Three readings of it are refuted: as
what a constant momentum in space obeys, along the attitudes of a motion of the body, and as equivalent to
(5.7). The motion is that of the four turns, for ever. *)

Definition the_turns (k : nat) : 'M[Qc]_3 :=
  matrix_of 3 (nth [::] [:: turn_0; turn_1; turn_2; turn_3] (k %% 4)).

Lemma next_of_four k : (k.+1 %% 4 = (k %% 4).+1 %% 4)%N.
Proof. by rewrite -addn1 -modnDml addn1. Qed.

Lemma the_turns_rotate k : special_orthogonal (the_turns k).
Proof.
rewrite /the_turns; have : (k %% 4 < 4)%N by rewrite ltn_mod.
case: (k %% 4)%N => [|[|[|[|//]]]] _; [exact: turn_0_is_one | exact: turn_1_is_one | exact: turn_2_is_one |].
exact: turn_3_is_one.
Qed.

Lemma the_turns_solve k : discrete_euler_poincare (matrix_of 3 the_body) (the_turns k) (the_turns k.+1).
Proof.
rewrite /the_turns next_of_four; case: the_turns_follow => follow0 follow1 follow2 follow3.
have : (k %% 4 < 4)%N by rewrite ltn_mod.
by case: (k %% 4)%N => [|[|[|[|//]]]].
Qed.

(** The attitudes with these relative motions. *)
Fixpoint the_attitudes (k : nat) : 'M[Qc]_3 :=
  if k is k'.+1 then the_attitudes k' *m (the_turns k')^T else 1%:M.

Lemma the_attitudes_rotate k : special_orthogonal (the_attitudes k).
Proof.
elim: k => [|k [o det_1]]; first by split; rewrite ?det1 // /orthogonal trmx1 mulmx1.
have [turn_o turn_1] := the_turns_rotate k; split.
  by apply: orthogonal_product => //; apply: orthogonal_transpose.
by rewrite det_mulmx det_tr det_1 turn_1 mulr1.
Qed.

Lemma the_attitudes_turn k : angular_velocity the_attitudes k.+1 = the_turns k.
Proof.
have [o _] := the_attitudes_rotate k.
by rewrite /angular_velocity /= trmx_mul trmxK -mulmxA (orthogonal_left o) mulmx1.
Qed.

Lemma the_attitudes_move : motion (matrix_of 3 the_body) the_attitudes.
Proof. by case=> // k _; rewrite !the_attitudes_turn; apply: the_turns_solve. Qed.

Lemma the_turns_refute :
  momentum_before (the_turns 2) (matrix_of 3 the_body) <>
  the_turns 0 *m momentum_before (the_turns 1) (matrix_of 3 the_body) *m invmx (the_turns 0).
Proof. by rewrite /the_turns /momentum_before; decide_by_computation. Qed.

Theorem claim_5_2_mv_first_line_printed_fails :
  ~ (forall (gs : nat -> 'M[Qc]_3) (m : 'M[Qc]_3) k (omega := angular_velocity gs)
       (M := fun j => (gs j.-1)^T *m m *m gs j.-1),
       (forall j, special_orthogonal (gs j)) -> skew m -> (1 < k)%N ->
       M k.+1 = omega k.-1 *m M k *m invmx (omega k.-1)).
Proof.
pose m := integers [:: [:: 0; 0; 1]; [:: 0; 0; 0]; [:: -1; 0; 0]].
have m_skew : skew (matrix_of 3 m) by decide_by_computation.
pose gs k := matrix_of 3 (if k == 2%N then quarter_turn else no_turn).
have rotate j : special_orthogonal (gs j).
  by rewrite /gs; case: eqP => _; [exact: quarter_turn_is_one | exact: no_turn_is_one].
move/(_ gs (matrix_of 3 m) 2%N rotate m_skew isT); rewrite /angular_velocity /gs /=.
by decide_by_computation.
Qed.

Theorem eq_5_9_printed_fails :
  ~ (forall (L : 'M[Qc]_3) gs k (omega := angular_velocity gs) (M := body_momentum L gs),
       generalized_body L -> (forall j, special_orthogonal (gs j)) -> motion L gs -> (1 < k)%N ->
       M k.+1 = omega k.-1 *m M k *m invmx (omega k.-1)).
Proof.
move/(_ _ _ 2%N the_body_is_one the_attitudes_rotate the_attitudes_move isT).
have o j : orthogonal (the_attitudes j) by case: (the_attitudes_rotate j).
by rewrite !body_momentumE // !the_attitudes_turn; apply: the_turns_refute.
Qed.

Theorem thm_5_2_1_printed_fails :
  ~ (forall (L : 'M[Qc]_3) omegas, generalized_body L -> (forall k, special_orthogonal (omegas k)) ->
       (forall k, discrete_euler_poincare L (omegas k) (omegas k.+1)) <->
       exists Ms, moser_veselov_as_printed L omegas Ms).
Proof.
move/(_ _ _ the_body_is_one the_turns_rotate) => [printed _].
have [Ms [first second]] := printed the_turns_solve.
by have := first 1%N isT; rewrite !second; apply: the_turns_refute.
Qed.

(** ** The momentum from the velocity by substitution *)

Section Substitution.

Variables (R : comUnitRingType) (n : nat).
Implicit Types g L xi : 'M[R]_n.

Add Ring laws_for_substitution : (laws_of_a_ring R).

(** ** What to substitute in

Section 5.2 says that (5.5), put into \f$M = J(\xi) = \Lambda\xi + \xi\Lambda\f$, gives the second line of
(5.9). It does so when \f$J\f$ is written as \f$J(\xi) = \Lambda\xi - \xi^T\Lambda\f$, which for skew
\f$\xi\f$ is the same: the result is \f$h^{-1}M_k\f$, the momentum before the step; the difference at the
other end gives the momentum after it. Any \f$\Lambda\f$, and any factor \f$h^{-1}\f$. *)
Theorem claim_5_2_momentum_by_substitution h L g0 g1 (omega := g1^T *m g0)
    (D := velocity_at_end h g0 g1) (D' := velocity_at_start h g0 g1) :
  orthogonal g0 -> orthogonal g1 ->
  L *m D - D^T *m L = h^-1 *: momentum_before omega L /\
  L *m D' - D'^T *m L = h^-1 *: momentum_after omega L.
Proof.
move=> o0 o1; rewrite /D /D' velocity_at_endE // velocity_at_startE //.
have -> : g0^T *m g1 = omega^T by rewrite /omega trmx_mul trmxK.
rewrite -/omega /momentum_before /momentum_after !transpose_scale -!scalemxAr -!scalemxAl -!scalerBr.
rewrite !transpose_sub trmx1 trmxK !(mulmxBl, mulmxBr) !(mul1mx, mulmx1).
by split; congr (_ *: _); compare_entries_in R.
Qed.

Theorem claim_5_2_momentum_by_substitution_skew L xi :
  skew xi -> inertia_operator L xi = L *m xi - xi^T *m L.
Proof. by move=> ->; rewrite mulNmx opprK. Qed.

(** In \f$\Lambda\xi + \xi\Lambda\f$ the difference gives no skew matrix; twice its skew part is the sum of
the momenta at both ends of the step, over \f$h\f$. *)
Theorem claim_5_2_momentum_by_substitution_mean h L g0 g1 (omega := g1^T *m g0)
    (D := velocity_at_end h g0 g1) :
  symmetric L -> orthogonal g0 -> orthogonal g1 ->
  skew_part (inertia_operator L D) = h^-1 *: (momentum_before omega L + momentum_after omega L).
Proof.
move=> L_sym o0 o1; rewrite /skew_part /inertia_operator transpose_add !trmx_mul L_sym /D velocity_at_endE //.
rewrite -/omega /momentum_before /momentum_after !transpose_scale.
rewrite -!scalemxAr -!scalemxAl -!scalerDr -!scalerBr.
rewrite !transpose_sub trmx1 !(mulmxBl, mulmxBr) !(mul1mx, mulmx1).
by congr (_ *: _); compare_entries_in R.
Qed.

End Substitution.

(** The printed substitution, refuted by a quarter turn in one step of length 1. *)
Theorem claim_5_2_momentum_by_substitution_printed_fails :
  ~ (forall (h : Qc) (L g0 g1 : 'M[Qc]_3), h != 0 -> generalized_body L ->
       special_orthogonal g0 -> special_orthogonal g1 ->
       inertia_operator L (velocity_at_end h g0 g1) = h^-1 *: momentum_before (g1^T *m g0) L).
Proof.
move/(_ 1 _ _ _ isT the_body_is_one no_turn_is_one quarter_turn_is_one).
rewrite /inertia_operator /velocity_at_end /momentum_before invr1 !scale1r.
by decide_by_computation.
Qed.

(** ** What the scheme conserves

Chapter 1 calls the scheme of Moser and Veselov completely integrable. The integrals are proved here, for
bodies of any size: the matrices \f$1 - sM - s^2\Lambda^2\f$ before and after a step have two factors in
common, in one order and in the other. That the integrals are in involution, how many of them are
independent, and that the step is a Poisson map is not proved here. *)

Section Spectra.

Variables (R : comRingType) (n : nat).

Add Ring laws_for_spectra : (laws_of_a_ring R).

Implicit Types (A B f L M : 'M[R]_n) (z s : R).

(* Over a field this is a well-known exercise; over a ring, two factorizations of one matrix of blocks. *)
Lemma characteristic_polynomial_exchanged A B : char_poly (A *m B) = char_poly (B *m A).
Proof.
pose a := map_mx polyC A; pose b := map_mx polyC B; pose x : 'M[{poly R}]_n := 'X%:M.
pose whole := block_mx x a b 1%:M.
have from_the_right : \det whole = char_poly (A *m B).
  pose factor := block_mx 1%:M 0 (- b) 1%:M.
  have -> : \det whole = \det (whole *m factor) by rewrite det_mulmx det_lblock !det1 !mulr1.
  rewrite mulmx_block !(mulmx0, mulmx1, mul1mx, add0r) mulmxN subrr det_ublock det1 mulr1.
  by rewrite /char_poly /char_poly_mx map_mxM.
have from_the_left : 'X ^+ n * \det whole = 'X ^+ n * char_poly (B *m A).
  pose factor := block_mx 1%:M 0 (- b) x.
  have -> : 'X ^+ n * \det whole = \det (factor *m whole).
    by rewrite det_mulmx det_lblock det1 mul1r det_scalar.
  rewrite mulmx_block !(mul0mx, mul1mx, mulmx1, addr0) mulNmx {1}/x scalar_mxC addNr det_ublock det_scalar.
  by rewrite mulNmx addrC /char_poly /char_poly_mx map_mxM.
have /monic_lreg cancel_power : 'X ^+ n \is @monic R by apply: monicXn.
by rewrite -from_the_right; apply: cancel_power.
Qed.

Lemma characteristic_polynomial_at A z : (char_poly A).[z] = \det (z%:M - A).
Proof.
rewrite -horner_evalE -det_map_mx; congr (\det _); apply/matrixP => i j.
by rewrite !mxE /= horner_evalE hornerD hornerN hornerMn hornerX hornerC.
Qed.

Lemma determinant_exchanged A B z : \det (z%:M - A *m B) = \det (z%:M - B *m A).
Proof. by rewrite -!characteristic_polynomial_at characteristic_polynomial_exchanged. Qed.

(** The matrix \f$1 - sM - s^2\Lambda^2\f$.
C++: `actio::lax_matrix`, `rigid_body/isospectral.hpp`. *)
Definition lax_matrix s L M := 1%:M - s *: M - s ^+ 2 *: (L *m L).

(** All integrals together: the polynomial \f$\det(z - M - s\Lambda^2)\f$ in \f$z\f$ and \f$s\f$, of which
the coefficients are the integrals.
C++: `actio::isospectral_integrals`, `rigid_body/isospectral.hpp`. *)
Definition isospectral_integrals L M : {poly {poly R}} :=
  char_poly (map_mx polyC M + 'X *: map_mx polyC (L *m L)).

Lemma lax_factors f L s (M0 := f^T *m L - L *m f) (M1 := L *m f^T - f *m L) :
  f *m f^T = 1%:M ->
  lax_matrix s L M0 = (f^T + s *: L) *m (f - s *: L) /\ lax_matrix s L M1 = (f - s *: L) *m (f^T + s *: L).
Proof.
move=> o; have o' : f^T *m f = 1%:M by apply: mulmx1C.
rewrite /lax_matrix !(mulmxDl, mulmxDr, mulNmx, mulmxN) -?scalemxAl -?scalemxAr o o' scalerA -expr2 /M0 /M1.
by split; compare_entries_in R.
Qed.

Lemma similar_determinants f L z s (M0 := f^T *m L - L *m f) (M1 := L *m f^T - f *m L) :
  GRing.lreg s -> f *m f^T = 1%:M ->
  \det (z%:M - (M0 + s *: (L *m L))) = \det (z%:M - (M1 + s *: (L *m L))).
Proof.
move=> s_regular o; have [first second] := lax_factors L s o.
have s_power : GRing.lreg (s ^+ n) by apply: lregX.
apply: s_power; rewrite -!detZ.
have expand M : s *: (z%:M - (M + s *: (L *m L))) = (s * z - 1)%:M + lax_matrix s L M.
  rewrite scalerBr scale_scalar_mx scalerDr scalerA -expr2 /lax_matrix raddfB /=.
  by compare_entries_in R.
rewrite !expand first second; set A := f^T + _; set B := f - _.
by rewrite -[A *m B]opprK -mulNmx determinant_exchanged mulmxN opprK.
Qed.

End Spectra.

Lemma integrals_kept (R : comRingType) n (f L : 'M[R]_n) :
  f *m f^T = 1%:M ->
  isospectral_integrals L (f^T *m L - L *m f) = isospectral_integrals L (L *m f^T - f *m L).
Proof.
move=> o; rewrite /isospectral_integrals /char_poly /char_poly_mx.
pose raised (a : 'M[R]_n) := map_mx polyC (map_mx polyC a).
have s_regular : GRing.lreg ('X%:P : {poly {poly R}}).
  move=> p q same; apply/polyP => i; apply: (monic_lreg (monicX R)).
  by have := congr1 (fun r : {poly {poly R}} => r`_i) same; rewrite !coefCM.
have raise M : map_mx polyC (map_mx polyC M + 'X *: map_mx polyC (L *m L)) =
    raised M + 'X%:P *: (raised L *m raised L).
  by rewrite /raised map_mxD map_mxZ !map_mxM.
rewrite !raise /raised !(map_mxB, map_mxM) -!map_trmx.
apply: similar_determinants => //.
by rewrite !map_trmx -!map_mxM o !map_mx1.
Qed.

Section Integrals.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f L M : 'M[R]_n) (d e : 'rV[R]_n) (s : R).

Add Ring laws_for_integrals : (laws_of_a_ring R).

(** ** The two factors

For every orthogonal \f$f\f$, every \f$\Lambda\f$ and every number \f$s\f$,
\f$1 - sM_0 - s^2\Lambda^2 = (f^T + s\Lambda)(f - s\Lambda)\f$ with the momentum before the step, and the
same two factors, exchanged, with the momentum after it. No symmetry of \f$\Lambda\f$ is needed. *)
Theorem claim_1_0_moser_veselov_integrable_factors f L s :
  orthogonal f ->
  lax_matrix s L (momentum_before f L) = (f^T + s *: L) *m (f - s *: L) /\
  lax_matrix s L (momentum_after f L) = (f - s *: L) *m (f^T + s *: L).
Proof. exact: lax_factors. Qed.

(** ** The integrals

Along a motion \f$\det(1 - sM - s^2\Lambda^2)\f$ is conserved for every \f$s\f$, and so is the whole
polynomial \f$\det(z - M - s\Lambda^2)\f$ in the two variables: each of its coefficients is an integral. The
matrix \f$\Lambda\f$ may be any. *)
Theorem claim_1_0_moser_veselov_integrable_determinant f10 f21 L s :
  orthogonal f10 -> discrete_euler_poincare L f10 f21 ->
  \det (lax_matrix s L (momentum_before f21 L)) = \det (lax_matrix s L (momentum_before f10 L)).
Proof.
move=> o motion; rewrite [momentum_before f21 L]motion.
have [before after] := claim_1_0_moser_veselov_integrable_factors L s o.
by rewrite -/(momentum_after f10 L) before after !det_mulmx mulrC.
Qed.

Theorem claim_1_0_moser_veselov_integrable_integrals f10 f21 L :
  orthogonal f10 -> discrete_euler_poincare L f10 f21 ->
  isospectral_integrals L (momentum_before f21 L) = isospectral_integrals L (momentum_before f10 L).
Proof. by move=> o motion; rewrite [momentum_before f21 L]motion [RHS]integrals_kept. Qed.

(** The integrals without \f$\Lambda\f$, the coefficients of \f$\det(z - M)\f$, are kept by every update
\f$f\Pi f^T\f$, whatever the orthogonal \f$f\f$ and the matrix \f$\Pi\f$ are. *)
Theorem claim_5_2_manifest_preservation_casimirs f M :
  orthogonal f -> char_poly (f *m M *m f^T) = char_poly M.
Proof. by move=> o; rewrite characteristic_polynomial_exchanged mulmxA (orthogonal_left o) mul1mx. Qed.

(** The body velocity of a momentum, \f$(J^{-1}M)_{ij} = M_{ij}/(\Lambda_i+\Lambda_j)\f$ for
\f$\Lambda = \mathrm{diag}(d)\f$, and its energy, \f$\tfrac14\mathrm{Tr}(M^TJ^{-1}M)\f$.
C++: `actio::body_velocity`, `actio::kinetic_energy`, `rigid_body/inertia.hpp`. *)
Definition body_velocity d M := \matrix_(i, j) (M i j / (d 0 i + d 0 j)).
Definition energy_of_momentum d M := 4%:R^-1 * pairing M (body_velocity d M).

Lemma body_velocity_inverts d M :
  (forall i j, i != j -> d 0 i + d 0 j \is a GRing.unit) -> (forall i, M i i = 0) ->
  inertia_operator (diag_mx d) (body_velocity d M) = M.
Proof.
move=> sums zero; apply/matrixP => i j; rewrite /inertia_operator mul_diag_mx mul_mx_diag !mxE.
case: (eqVneq i j) => [<-|ne]; first by rewrite zero !mul0r mulr0 addr0.
by rewrite [_ * d 0 j]mulrC -mulrDl mulrC divrK // sums.
Qed.

Lemma sum_of_squares_in_a_row f i : orthogonal f -> \sum_j f i j ^+ 2 = 1.
Proof.
by move/matrixP/(_ i i); rewrite !mxE eqxx mulr1n => <-; apply: eq_bigr => j _; rewrite mxE expr2.
Qed.

Lemma squares_weighted f d : orthogonal f -> \sum_i \sum_j d 0 i * f i j ^+ 2 = \sum_i d 0 i.
Proof. by move=> o; apply: eq_bigr => i _; rewrite -mulr_sumr sum_of_squares_in_a_row // mulr1. Qed.

Lemma squares_weighted_by_column f d : orthogonal f -> \sum_i \sum_j d 0 j * f i j ^+ 2 = \sum_i d 0 i.
Proof.
move=> o; rewrite exchange_big -(squares_weighted d (orthogonal_transpose o)).
by apply: eq_bigr => j _; apply: eq_bigr => i _; rewrite mxE.
Qed.

(** ** The energy

The kinetic energy of the body momentum, the true one and not a discrete one, is the same before and after a
step, in any dimension and for every orthogonal \f$f\f$; so a motion conserves it. The sums
\f$\Lambda_i+\Lambda_j\f$ must have inverses. In the proof,
\f$M_{ij}^2 - M_{ij}'^2 = (\Lambda_j^2-\Lambda_i^2)(f_{ji}^2-f_{ij}^2)\f$ is divided by
\f$\Lambda_i+\Lambda_j\f$, and the rows and columns of \f$f\f$ have length 1. *)
Theorem claim_1_0_moser_veselov_integrable_energy f d (L := diag_mx d) :
  (forall i j, i != j -> d 0 i + d 0 j \is a GRing.unit) -> orthogonal f ->
  energy_of_momentum d (momentum_after f L) = energy_of_momentum d (momentum_before f L).
Proof.
move=> sums o; congr (_ * _).
have entries M V : pairing M V = \sum_i \sum_j M j i * V j i.
  by apply: eq_bigr => i _; rewrite mxE; apply: eq_bigr => j _; rewrite mxE.
have term i j : momentum_after f L j i * body_velocity d (momentum_after f L) j i -
    momentum_before f L j i * body_velocity d (momentum_before f L) j i =
    d 0 j * f i j ^+ 2 - d 0 i * f i j ^+ 2 - (d 0 j * f j i ^+ 2 - d 0 i * f j i ^+ 2).
  rewrite /body_velocity /momentum_after /momentum_before /L !mul_diag_mx !mul_mx_diag !mxE.
  case: (eqVneq i j) => [<-|ne]; first by rewrite [f i i * _]mulrC !subrr.
  have unit : d 0 j + d 0 i \is a GRing.unit by rewrite sums // eq_sym.
  have divide (x y : R) : x * (y / (d 0 j + d 0 i)) * (d 0 j + d 0 i) = x * y by rewrite -mulrA divrK.
  by apply: (mulIr unit); rewrite [LHS]mulrBl !divide; calculate_in R.
apply/eqP; rewrite -subr_eq0 !entries -sumrB; apply/eqP.
under eq_bigr => i _ do (rewrite -sumrB; under eq_bigr => j _ do rewrite term; rewrite !sumrB).
rewrite !sumrB squares_weighted_by_column // squares_weighted //.
rewrite [X in _ - (X - _)]exchange_big [X in _ - (_ - X)]exchange_big /=.
by rewrite squares_weighted // squares_weighted_by_column // !subrr.
Qed.

(** ** One momentum of many relative motions

A momentum does not determine the relative motion: every diagonal matrix of signs is orthogonal and has the
momentum zero, as \f$f=1\f$ has. In the scheme \f$M_k\mapsto\omega_k\f$ of section 5.2 a branch must be
chosen. *)
Theorem claim_5_2_dep_on_group_signs d e :
  (forall i, e 0 i ^+ 2 = 1) ->
  orthogonal (diag_mx e) /\ momentum_before (diag_mx e) (diag_mx d) = 0.
Proof.
move=> signs; split.
  rewrite /orthogonal tr_diag_mx mulmx_diag; apply/matrixP => i j; rewrite !mxE.
  by case: eqP => [->|]; rewrite ?mulr0n // -expr2 signs.
by rewrite /momentum_before tr_diag_mx !mulmx_diag; apply/matrixP => i j; rewrite !mxE mulrC subrr.
Qed.

(** ** The equation of a step as an equation for a square root

For an invertible symmetric \f$\Lambda\f$, to find an orthogonal \f$f\f$ with
\f$f^T\Lambda - \Lambda f = P\f$ is to find a matrix \f$X\f$ with the skew part \f$X - X^T = P\f$ and
\f$X^TX = \Lambda^2\f$: they are related by \f$X = f^T\Lambda\f$. *)
Theorem claim_5_2_solvability_square_root L P :
  L \in unitmx -> symmetric L ->
  (exists2 f, orthogonal f & momentum_before f L = P) <->
  (exists2 X : 'M[R]_n, X - X^T = P & X^T *m X = L *m L).
Proof.
move=> unit L_sym; split=> [[f o <-]|[X <- square]].
  exists (f^T *m L); first by rewrite trmx_mul trmxK L_sym.
  by rewrite trmx_mul trmxK L_sym mulmxA (turn_back _ o).
have inverse_sym : (invmx L)^T = invmx L by rewrite trmx_inv L_sym.
exists (invmx L *m X^T); last by rewrite /momentum_before trmx_mul trmxK inverse_sym mulmxKV // mulKVmx.
by rewrite /orthogonal trmx_mul trmxK inverse_sym -!mulmxA [X^T *m _]mulmxA square -mulmxA mulKmx // mulmxV.
Qed.

(** The inner product of columns, \f$u^Tw\f$. *)
Definition inner_product (u w : 'cV[R]_n) : R := \tr (u^T *m w).

(** ** A square that limits the step

With \f$X = f^T\Lambda\f$ and \f$P = f^T\Lambda - \Lambda f\f$, for all columns \f$u, w\f$ and numbers
\f$s\f$,
\f[ |su + Xw|^2 + |sw - Xu|^2 = s^2(|u|^2+|w|^2) + |\Lambda u|^2 + |\Lambda w|^2 + 2s\,u^TPw . \f]
In complex numbers the right side is the Hermitian form of \f$s^2 + \Lambda^2 - isP\f$ at \f$u + iw\f$, and
the left side is \f$|(s - iX)(u + iw)|^2\f$. *)
Theorem claim_5_2_solvability_square f L (u w : 'cV[R]_n) s (X := f^T *m L) :
  symmetric L -> orthogonal f ->
  inner_product (s *: u + X *m w) (s *: u + X *m w) + inner_product (s *: w - X *m u) (s *: w - X *m u) =
  s ^+ 2 * (inner_product u u + inner_product w w)
  + (inner_product (L *m u) (L *m u) + inner_product (L *m w) (L *m w))
  + 2%:R * s * inner_product u (momentum_before f L *m w).
Proof.
move=> L_sym o.
have square v w' : inner_product (X *m v) (X *m w') = inner_product (L *m v) (L *m w').
  by rewrite /inner_product /X !trmx_mul trmxK L_sym !mulmxA (turn_back _ o).
have expand v w' t : inner_product (s *: v + t *: (X *m w')) (s *: v + t *: (X *m w')) =
    s ^+ 2 * inner_product v v + t ^+ 2 * inner_product (L *m w') (L *m w') +
    2%:R * s * t * inner_product v (X *m w').
  have sym : inner_product (X *m w') v = inner_product v (X *m w').
    by rewrite /inner_product -[LHS]mxtrace_tr [in LHS]trmx_mul trmxK.
  rewrite -square {1}/inner_product [(_ + _)^T]linearD /= [(s *: _)^T]linearZ [(t *: _)^T]linearZ /=.
  rewrite mulmxDl !mulmxDr -?scalemxAl -?scalemxAr -?scalemxAl !mxtraceD !mxtraceZ.
  by rewrite -!/(inner_product _ _) sym; calculate_in R.
rewrite -[X *m w]scale1r expand -[- (X *m u)]scaleN1r expand.
have -> : inner_product w (X *m u) = inner_product u (X^T *m w).
  by rewrite /inner_product -[LHS]mxtrace_tr trmx_mul [(X *m u)^T]trmx_mul trmxK mulmxA.
have -> : inner_product u (momentum_before f L *m w) = inner_product u (X *m w) - inner_product u (X^T *m w).
  by rewrite /momentum_before /inner_product mulmxBl mulmxBr [LHS]linearB /= /X trmx_mul trmxK L_sym.
by calculate_in R.
Qed.

End Integrals.

(** ** Steps that are too long

Over ordered numbers a square is not negative. So where (5.7) has a solution with \f$h\f$ times the momentum
\f$M\f$, \f$f^T\Lambda - \Lambda f = hM\f$, the form
\f$s^2(|u|^2+|w|^2) + |\Lambda u|^2 + |\Lambda w|^2 + 2sh\,u^TMw\f$ is nowhere negative: for longer steps,
where it is, there is _no_ solution. This is one half of the formula for the largest step,
\f$1/h_{\max} = \max_{s>0}s\,\rho\big((s^2+\Lambda^2)^{-1/2}\,iM\,(s^2+\Lambda^2)^{-1/2}\big)\f$, and it
needs no sign of \f$\Lambda\f$.
C++: `actio::largest_step`, `rigid_body/largest_step.hpp`. *)

Section LongestStep.

Import Order.TTheory Num.Theory.

Variables (F : realFieldType) (n : nat).

Theorem claim_5_2_solvability_bound h (f L M : 'M[F]_n) :
  symmetric L -> orthogonal f -> momentum_before f L = h *: M ->
  forall (u w : 'cV[F]_n) (s : F),
  0 <= s ^+ 2 * (inner_product u u + inner_product w w)
       + (inner_product (L *m u) (L *m u) + inner_product (L *m w) (L *m w))
       + 2%:R * s * h * inner_product u (M *m w).
Proof.
move=> L_sym o is_hM u w s.
have positive (v : 'cV[F]_n) : 0 <= inner_product v v.
  by apply: sumr_ge0 => i _; rewrite mxE; apply: sumr_ge0 => j _; rewrite mxE -expr2 sqr_ge0.
have -> : 2%:R * s * h * inner_product u (M *m w) = 2%:R * s * inner_product u (momentum_before f L *m w).
  by rewrite is_hM /inner_product -scalemxAl -scalemxAr mxtraceZ mulrA.
by rewrite -(claim_5_2_solvability_square u w s L_sym o) addr_ge0.
Qed.

End LongestStep.

(** ** Legendre maps and Casimir functions

Section 5.3. *)

Section Casimirs.

Variables (R : comUnitRingType) (n : nat).
Implicit Types (f L M x y v w xi eta theta : 'M[R]_n).
Implicit Types omegas : nat -> 'M[R]_n.

Add Ring laws_for_casimirs : (laws_of_a_ring R).

(** The pairing of coordinates is half of the trace, \f$\tfrac12\mathrm{Tr}(A^TB)\f$: for skew matrices the
sum over the planes, each counted once. It is the pairing of the library.
C++: `actio::pair`, `groups/group.hpp`. *)
Definition coordinate_pairing M x := 2%:R^-1 * pairing M x.

(** ** The Legendre map on the group

For \f$\ell(f) = \mathrm{Tr}(f\Lambda)\f$ and the pairing of coordinates,
\f$L_f^*\,d\ell(f) = f^T\Lambda - \Lambda f\f$ on skew matrices: the momentum before the step. The printed
matrix \f$f\Lambda - \Lambda f^T\f$ is the other translation, \f$-R_f^*\,d\ell(f)\f$. *)
Theorem claim_5_3_group_legendre f L theta :
  (2%:R : R) \is a GRing.unit -> symmetric L -> skew theta ->
  reduced_differential L (left_translation f theta) = coordinate_pairing (f^T *m L - L *m f) theta /\
  reduced_differential L (right_translation f theta) = coordinate_pairing (- (f *m L - L *m f^T)) theta.
Proof.
move=> two L_sym theta_skew; rewrite /coordinate_pairing opprB.
by rewrite pairing_before // pairing_after // !mulKr.
Qed.

(** The function (5.10) on the group, \f$C(f) = \mathrm{Tr}(f\Lambda f\Lambda)\f$.
C++: `actio::trace_casimir`, `rigid_body/casimirs.hpp`. *)
Definition trace_casimir L f := \tr (f *m L *m f *m L).

Lemma trace_of_square f L :
  symmetric L -> orthogonal f ->
  \tr (momentum_before f L *m momentum_before f L) = 2%:R * (trace_casimir L f - \tr (L *m L)).
Proof.
move=> L_sym o; rewrite /momentum_before mulmxBl !mulmxBr !trace_sub !mulmxA.
have -> : \tr (f^T *m L *m f^T *m L) = trace_casimir L f.
  rewrite trace_product_transpose !trmx_mul trmxK L_sym /trace_casimir mxtrace_mulC !mulmxA.
  by rewrite -!mulmxA.
have -> : \tr (f^T *m L *m L *m f) = \tr (L *m L) by rewrite mxtrace_mulC !mulmxA o mul1mx.
have -> : \tr (L *m f *m f^T *m L) = \tr (L *m L) by rewrite (turn_back _ o).
have -> : \tr (L *m f *m L *m f) = trace_casimir L f.
  by rewrite /trace_casimir -!mulmxA mxtrace_mulC !mulmxA.
by calculate_in R.
Qed.

Lemma trace_of_square_after f L :
  orthogonal f ->
  \tr (momentum_after f L *m momentum_after f L) = \tr (momentum_before f L *m momentum_before f L).
Proof.
move=> o; rewrite -!claim_5_2_update_by_conjugation_within_a_step // !mulmxA (turn_forth _ o).
by rewrite mxtrace_mulC !mulmxA (orthogonal_left o) mul1mx.
Qed.

Lemma minus_square f L : symmetric L ->
  coordinate_pairing (momentum_before f L) (momentum_before f L) =
  - (2%:R^-1 * \tr (momentum_before f L *m momentum_before f L)).
Proof.
move=> L_sym; rewrite /coordinate_pairing /pairing (momentum_before_skew f L_sym).
by rewrite mulNmx trace_opposite mulrN.
Qed.

(** ** The Casimir function on the group, (5.10)

For every orthogonal \f$f\f$ and symmetric \f$\Lambda\f$, in any dimension: the square of the length,
\f$\|y\|^2\f$, of the momentum that a Legendre map gives, either of the two, is
\f$\mathrm{Tr}\Lambda^2 - \mathrm{Tr}(f\Lambda f\Lambda)\f$. Up to a constant and the sign that is (5.10). *)
Theorem eq_5_10 f L (before := f^T *m L - L *m f) (printed := f *m L - L *m f^T) :
  (2%:R : R) \is a GRing.unit -> symmetric L -> orthogonal f ->
  coordinate_pairing before before = \tr (L *m L) - trace_casimir L f /\
  coordinate_pairing printed printed = \tr (L *m L) - trace_casimir L f.
Proof.
move=> two L_sym o.
have square : coordinate_pairing before before = \tr (L *m L) - trace_casimir L f.
  by rewrite minus_square // trace_of_square // mulKr // opprB.
split=> //; rewrite -square /coordinate_pairing; congr (_ * _).
have is_after : printed = - momentum_after f L by rewrite opprB.
have turned : momentum_after f L = f *m before *m f^T.
  by rewrite -claim_5_2_update_by_conjugation_within_a_step.
rewrite is_after /pairing transpose_opposite mulNmx mulmxN opprK turned !trmx_mul !trmxK !mulmxA.
by rewrite (turn_forth _ o) mxtrace_mulC !mulmxA (orthogonal_left o) mul1mx.
Qed.

(** ** The value of the pull-back

Of \f$\|y\|^2\f$ it is as above. Of \f$\mathrm{Tr}(\mu^2)\f$, the other form in which section 5.3 gives the
Casimir function, it is \f$2\,C(f) - 2\,\mathrm{Tr}\Lambda^2\f$, over every ring: a factor 2, and no change
of sign. *)
Theorem claim_5_3_pullback_value f L (mu := f *m L - L *m f^T) :
  symmetric L -> orthogonal f -> \tr (mu *m mu) = 2%:R * trace_casimir L f - 2%:R * \tr (L *m L).
Proof.
move=> L_sym o; have -> : mu = - momentum_after f L by rewrite opprB.
by rewrite mulNmx mulmxN opprK trace_of_square_after // trace_of_square // mulrBr.
Qed.

(** ** A motion stays on a level set

The function (5.10) is constant along the relative motions of a body. *)
Theorem claim_5_3_invariant_manifolds_conserved L omegas k :
  (2%:R : R) \is a GRing.unit -> symmetric L -> (forall j, orthogonal (omegas j)) ->
  (forall j, discrete_euler_poincare L (omegas j) (omegas j.+1)) ->
  trace_casimir L (omegas k) = trace_casimir L (omegas 0%N).
Proof.
move=> two L_sym o motion; elim: k => // k <-.
have : \tr (momentum_before (omegas k.+1) L *m momentum_before (omegas k.+1) L) =
       \tr (momentum_before (omegas k) L *m momentum_before (omegas k) L).
  by rewrite [momentum_before (omegas k.+1) L](motion k) trace_of_square_after.
by rewrite !trace_of_square // => /(mulrI two) /addIr.
Qed.

Lemma pairing_of_sums x y v w (t : R) :
  pairing (x + t *: y) (v + t *: w) = pairing x v + t * (pairing x w + pairing y v) + t ^+ 2 * pairing y w.
Proof.
rewrite /pairing transpose_add transpose_scale !(mulmxDl, mulmxDr) -?scalemxAl -?scalemxAr -?scalemxAl.
by rewrite !mxtraceD !mxtraceZ; calculate_in R.
Qed.

(** ** The Legendre map on the algebra

Section 5.3 gives \f$\mu = \partial l/\partial\xi = \mathcal J(\xi)\f$ for the Lagrangian (5.1). With the
pairing of (5.1), \f$\mathrm{Tr}(A^TB)\f$, the derivative is half of that, \f$\tfrac12\mathcal J(\xi)\f$;
with the pairing of coordinates it is \f$\mathcal J(\xi)\f$, but then the factor of (5.1) is \f$\tfrac12\f$.
The matrices \f$\xi\f$ and \f$\eta\f$ need not be skew. *)
Theorem claim_5_3_algebra_legendre L xi eta :
  (2%:R : R) \is a GRing.unit -> symmetric L ->
  slope (fun t => kinetic_energy L (xi + t *: eta)) (pairing (2%:R^-1 *: inertia_operator L xi) eta).
Proof.
move=> two L_sym; exists (kinetic_energy L eta) => t; rewrite scale0r addr0 /kinetic_energy.
have linear : inertia_operator L (xi + t *: eta) = inertia_operator L xi + t *: inertia_operator L eta.
  by rewrite /inertia_operator mulmxDl mulmxDr -scalemxAl -scalemxAr scalerDr; exact: addrACA.
have halves : pairing (2%:R^-1 *: inertia_operator L xi) eta =
    4%:R^-1 * (2%:R * pairing (inertia_operator L xi) eta).
  rewrite /pairing transpose_scale -scalemxAl mxtraceZ (natrM _ 2 2) invrM //.
  by rewrite -mulrA [_^-1 * (2%:R * _)]mulKr.
rewrite halves linear pairing_of_sums (claim_5_0_inertia_operator_symmetric xi eta L_sym).
by rewrite [pairing eta (inertia_operator L xi)]pairing_symmetric /pairing; calculate_in R.
Qed.

Theorem claim_5_3_algebra_legendre_in_coordinates L xi eta :
  (2%:R : R) \is a GRing.unit -> symmetric L ->
  slope (fun t => kinetic_energy L (xi + t *: eta)) (coordinate_pairing (inertia_operator L xi) eta).
Proof.
move=> two L_sym; have := claim_5_3_algebra_legendre xi eta two L_sym.
by rewrite /coordinate_pairing {1}/pairing transpose_scale -scalemxAl mxtraceZ.
Qed.

End Casimirs.

(** ** Not the whole inertia operator

The printed \f$\partial l/\partial\xi = \mathcal J(\xi)\f$, with the pairing \f$\mathrm{Tr}(A^TB)\f$ for
which the factor of (5.1) is right. It already fails at a turning about one axis. *)
Theorem claim_5_3_algebra_legendre_printed_fails :
  ~ (forall L xi eta : 'M[Qc]_3, generalized_body L -> skew xi -> skew eta ->
       slope (fun t => kinetic_energy L (xi + t *: eta)) (pairing (inertia_operator L xi) eta)).
Proof.
pose spin := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 0]].
have two : (2%:R : Qc) \is a GRing.unit by [].
have spin_skew : skew (matrix_of 3 spin) by decide_by_computation.
move/(_ _ _ _ the_body_is_one spin_skew spin_skew); set c := fun t => _ => printed.
have L_sym := generalized_body_symmetric the_body_is_one.
have right : slope c _ := claim_5_3_algebra_legendre (matrix_of 3 spin) (matrix_of 3 spin) two L_sym.
move: (slope_unique two printed right); rewrite /inertia_operator.
by decide_by_computation.
Qed.

(** ** The printed Legendre map on the group

The print has \f$L_f^*\,d\ell(f) = f\Lambda - \Lambda f^T\f$. At a rotation about no principal axis of the
body no factor makes it right, so the pairing does not matter. *)
Theorem claim_5_3_group_legendre_printed_fails :
  ~ (forall L f : 'M[Qc]_3, generalized_body L -> special_orthogonal f ->
       exists c, forall theta, skew theta ->
         reduced_differential L (left_translation f theta) = c * pairing (f *m L - L *m f^T) theta).
Proof.
move/(_ _ _ the_body_is_one turn_0_is_one) => [c printed].
pose about_3 := integers [:: [:: 0; -1; 0]; [:: 1; 0; 0]; [:: 0; 0; 0]].
pose about_2 := integers [:: [:: 0; 0; 1]; [:: 0; 0; 0]; [:: -1; 0; 0]].
have skew_3 : skew (matrix_of 3 about_3) by decide_by_computation.
have skew_2 : skew (matrix_of 3 about_2) by decide_by_computation.
have two_factors (l3 p3 l2 p2 : Qc) : l3 = c * p3 -> l2 = c * p2 -> l3 * p2 = l2 * p3.
  by move=> -> ->; rewrite mulrAC.
move: (two_factors _ _ _ _ (printed _ skew_3) (printed _ skew_2)).
by rewrite /reduced_differential; decide_by_computation.
Qed.

(** ** From the other form of the Casimir function

Section 5.3 gives the Casimir function as \f$\mathrm{Tr}(\mu^2)\f$, and says that its pull-back is
\f$\mathrm{Tr}(f\Lambda f\Lambda)\f$ up to a constant term and a sign. From \f$\mathrm{Tr}(\mu^2)\f$ it is
not: with either sign, no constant will do. The identity and a quarter turn show it. *)
Theorem claim_5_3_pullback_value_not_from_the_trace :
  ~ (forall L : 'M[Qc]_3, generalized_body L ->
       exists sign c : Qc, (sign = 1 \/ sign = -1) /\
         forall f, special_orthogonal f ->
           \tr ((f *m L - L *m f^T) *m (f *m L - L *m f^T)) = sign * trace_casimir L f + c).
Proof.
move/(_ _ the_body_is_one) => [sign [c [either value]]].
have constant (t0 t1 x0 x1 : Qc) :
    t0 = sign * x0 + c -> t1 = sign * x1 + c -> t1 - t0 = sign * x1 - sign * x0.
  by move=> -> ->; rewrite opprD addrACA subrr addr0.
move: (constant _ _ _ _ (value _ no_turn_is_one) (value _ quarter_turn_is_one)); rewrite /trace_casimir.
by case: either => ->; rewrite ?mulN1r ?mul1r; decide_by_computation.
Qed.
