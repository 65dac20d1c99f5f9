(** * Matrices, groups of matrices and their duals

The words in which the other pages of this folder speak. A group element is an invertible square matrix of
any size over any commutative ring; an element of the Lie algebra is a matrix; a covector at \f$g\f$ is a
matrix as well, paired with a tangent vector by the trace, \f$\langle p, v\rangle = \mathrm{Tr}(p^Tv)\f$. *)

From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Matrices.

Variables (R : comUnitRingType) (n : nat).
Implicit Types a b f g p v x y L M : 'M[R]_n.

(** ** Rotations and symmetric matrices *)

(** A matrix is _orthogonal_ where \f$ff^T = 1\f$; then \f$f^Tf = 1\f$ as well. *)
Definition orthogonal f := f *m f^T = 1%:M.

Definition symmetric L := L^T = L.

Definition skew M := M^T = - M.

(** The _skew part_, without its one half: \f$a - a^T\f$. *)
Definition skew_part a := a - a^T.

(** The bracket of matrices: \f$[x, y] = xy - yx\f$. *)
Definition bracket x y := x *m y - y *m x.

(** ** Translations and their duals *)

(** The pairing of a covector with a vector: \f$\langle p, v\rangle = \mathrm{Tr}(p^Tv)\f$. *)
Definition pairing p v := \tr (p^T *m v).

(** The derivatives of \f$f\mapsto gf\f$ and of \f$f\mapsto fg\f$ are products with \f$g\f$. *)
Definition left_translation g v := g *m v.
Definition right_translation g v := v *m g.

(** Their duals, which take a covector at \f$gf\f$ or \f$fg\f$ to one at \f$f\f$:
\f$L_g^*p = g^Tp\f$ and \f$R_g^*p = p\,g^T\f$. *)
Definition L_star g p := g^T *m p.
Definition R_star g p := p *m g^T.

(** ** The adjoint action and its dual *)

(** \f$\mathrm{Ad}_g x = gxg^{-1}\f$. *)
Definition Ad g x := g *m x *m invmx g.

(** The dual map of \f$\mathrm{Ad}_g\f$: \f$\mathrm{Ad}_g^*p = g^Tp\,g^{-T}\f$. *)
Definition Ad_star g p := g^T *m p *m (invmx g)^T.

Definition ad x y := bracket x y.

(** The dual map of \f$\mathrm{ad}_x\f$: \f$\mathrm{ad}_x^*p = x^Tp - p\,x^T\f$. *)
Definition ad_star x p := x^T *m p - p *m x^T.

(** ** That these are the duals *)

Lemma L_star_dual g p v : pairing (L_star g p) v = pairing p (left_translation g v).
Proof. by rewrite /pairing /L_star trmx_mul trmxK mulmxA. Qed.

Lemma R_star_dual g p v : pairing (R_star g p) v = pairing p (right_translation g v).
Proof. by rewrite /pairing /R_star trmx_mul trmxK -mulmxA mxtrace_mulC -mulmxA. Qed.

Lemma Ad_star_dual g p x : pairing (Ad_star g p) x = pairing p (Ad g x).
Proof.
by rewrite /pairing /Ad_star /Ad !trmx_mul !trmxK -!mulmxA mxtrace_mulC -!mulmxA.
Qed.

Lemma ad_star_dual x p y : pairing (ad_star x p) y = pairing p (ad x y).
Proof.
rewrite /pairing /ad_star /ad /bracket raddfB /= !trmx_mul !trmxK mulmxBl mulmxBr !raddfB /= mulmxA.
by congr (_ - _); rewrite -mulmxA mxtrace_mulC mulmxA.
Qed.

(** A covector is known by its values: the pairing is nondegenerate, over every ring. *)
Lemma pairing_nondegenerate p : (forall v, pairing p v = 0) -> p = 0.
Proof.
move=> vanishes; apply/matrixP => i j; rewrite mxE.
have := vanishes (delta_mx i j); rewrite /pairing /mxtrace (bigD1 j) //= mxE (bigD1 i) //= !mxE !eqxx mulr1.
rewrite big1 ?addr0; last by move=> k ne; rewrite !mxE (negbTE ne) mulr0.
rewrite big1 ?addr0 // => k ne; rewrite mxE big1 // => l _.
by rewrite !mxE (negbTE ne) andbF mulr0.
Qed.

Lemma orthogonal_left f : orthogonal f -> f^T *m f = 1%:M.
Proof. by move=> ?; apply: mulmx1C. Qed.

(** A rotation is invertible, and its inverse is its transpose. *)
Lemma orthogonal_unit f : orthogonal f -> f \in unitmx.
Proof. by case/mulmx1_unit. Qed.

Lemma orthogonal_inverse f : orthogonal f -> invmx f = f^T.
Proof. by move=> o; rewrite -[RHS]mul1mx -(mulVmx (orthogonal_unit o)) -mulmxA o mulmx1. Qed.

End Matrices.
