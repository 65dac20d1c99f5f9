(** * What the proofs of chapter 5 calculate with

An identity between polynomials in elements of a commutative ring is decided by multiplying out. A derivative
of a function that is of the second degree along every line needs no limit. Nothing of this file is read in
the statements but the _slope_, at its end. *)

From Coq Require Import Ring Qcanon.
From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices computed.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

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
