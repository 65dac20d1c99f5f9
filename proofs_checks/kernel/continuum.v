(** * Continuous media

Section 6.2 for the density (6.3) of a continuous medium: momenta and energy, the equation of motion (6.13),
the pressure of a fluid, and the stresses of a solid. Functions on jets and on space-time form a commutative
ring, in which 2 and the roots of the determinants of the metrics have inverses; a derivative is a derivation
of it. What is proved holds in all dimensions \f$n\f$ of the body and \f$N\f$ of space, in all metrics.
Space-time has the coordinates \f$x^0 = t\f$ and \f$x^k\f$, \f$k = 1, \dots, n\f$; \f$F^a{}_k = v^a{}_k\f$ is
the deformation gradient. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations fields.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(** ** The density and its energy, at a jet *)

Section Energy.

Variables (R : comUnitRingType) (n N : nat).

(** Mass density, \f$\sqrt{\det G}\f$, the metric of space, velocity and deformation gradient at a jet, the
stored energy there and its derivatives \f$\partial W/\partial v^a{}_j\f$. *)
Variables (rho vol : R) (g : 'M[R]_N) (velocity : 'I_N -> R) (F : 'I_N -> 'I_n -> R) (W : R)
          (W_F : 'I_N -> 'I_n -> R).

(** \f$g_{ab}\dot\phi^a\dot\phi^b\f$. *)
Definition speed_squared := \sum_a \sum_b g a b * velocity a * velocity b.

(** \f$\mathbb K\f$ and \f$\mathbb P\f$ of (6.3), without their \f$d^{n+1}x\f$, and the density
\f$L = \mathbb K - \mathbb P\f$. C++: `actio::Continuum`, `continuum/continuum.hpp`. *)
Definition kinetic := 2%:R^-1 * vol * rho * speed_squared.
Definition potential := vol * rho * W.
Definition density := kinetic - potential.

(** The momenta as (6.4) gives them. *)
Definition time_momentum a := rho * (\sum_b g a b * velocity b) * vol.
Definition space_momentum a j := - (rho * W_F a j * vol).

(** \f$\Pi = L - p_a{}^\mu v^a{}_\mu\f$. *)
Definition affine_momentum_of_medium :=
  density - \sum_a time_momentum a * velocity a - \sum_a \sum_j space_momentum a j * F a j.

(** (6.5): \f$e = p_a{}^0v^a{}_0 - L\f$. *)
Definition energy := \sum_a time_momentum a * velocity a - density.

Hypothesis unit2 : (2%:R : R) \is a GRing.unit.

Lemma power_of_momentum : \sum_a time_momentum a * velocity a = 2%:R * kinetic.
Proof.
rewrite /kinetic !mulrA divrr // mul1r /time_momentum /speed_squared mulr_sumr.
apply: eq_bigr => a _; rewrite mulr_sumr mulr_suml mulr_suml mulr_sumr; apply: eq_bigr => b _.
ring_identity.
Qed.

(** ** The affine momentum of a medium

It is, with the momenta (6.4),
\f$\Pi = \bigl[-\frac12g_{ab}v^a{}_0v^b{}_0 - W + \frac{\partial W}{\partial v^a{}_j}v^a{}_j\bigr]\rho
\sqrt{\det G}\f$. *)
Theorem claim_6_2_affine_momentum :
  affine_momentum_of_medium
  = (- (2%:R^-1 * speed_squared) - W + \sum_a \sum_j W_F a j * F a j) * (rho * vol).
Proof.
rewrite /affine_momentum_of_medium power_of_momentum.
have -> : \sum_a \sum_j space_momentum a j * F a j = - (\sum_a \sum_j W_F a j * F a j) * (rho * vol).
  rewrite -sumrN mulr_suml; apply: eq_bigr => a _; rewrite -sumrN mulr_suml; apply: eq_bigr => j _.
  rewrite /space_momentum; ring_identity.
rewrite /density /kinetic /potential; ring_identity.
Qed.

(** ** The two expressions of the energy

\f$p_a{}^0v^a{}_0 - L\f$ and \f$\mathbb K + \mathbb P\f$ are the same, because \f$\mathbb K\f$ is quadratic in
the velocity; the metric need not be symmetric for that. *)
Theorem claim_6_2_energy_two_expressions : energy = kinetic + potential.
Proof. rewrite /energy power_of_momentum /density; ring_identity. Qed.

(** ** The affine momentum and the energy

\f$\Pi = -p_a{}^jv^a{}_j - e\f$: the energy density of (6.5) has \f$\sqrt{\det G}\f$ in it. *)
Theorem claim_6_2_affine_momentum_energy :
  affine_momentum_of_medium = - (\sum_a \sum_j space_momentum a j * F a j) - energy.
Proof. rewrite /affine_momentum_of_medium /energy; ring_identity. Qed.

End Energy.

(** The printed \f$\Pi = -p_a{}^jv^a{}_j - \sqrt{\det G}\,e\f$ has the factor once more. It fails for a
particle of dust with \f$\sqrt{\det G} = 2\f$. *)
Theorem claim_6_2_affine_momentum_energy_printed_fails :
  ~ (forall (n N : nat) (rho vol : rat) (g : 'M[rat]_N) velocity (F : 'I_N -> 'I_n -> rat) W W_F,
      0 < rho -> 0 < vol -> g^T = g ->
      affine_momentum_of_medium rho vol g velocity F W W_F
      = - (\sum_a \sum_j space_momentum rho vol W_F a j * F a j) - vol * energy rho vol g velocity W).
Proof.
move=> claim; have := claim 1%N 1%N 1 2%:R 1%:M (fun _ => 1) (fun _ _ => 0) 0 (fun _ _ =>
  0) isT isT (trmx1 _ _).
rewrite claim_6_2_affine_momentum_energy claim_6_2_energy_two_expressions // /kinetic /potential
  /speed_squared.
rewrite !big_ord1 !mxE => /eqP; by vm_compute.
Qed.

(** ** Metrics and accelerations *)

Section Metric.

Variables (R : comUnitRingType) (N : nat) (g : 'M[R]_N) (d_y : 'I_N -> derivation R).
Hypothesis unit2 : (2%:R : R) \is a GRing.unit.
Hypothesis symmetric_metric : g^T = g.
Hypothesis regular_metric : g \in unitmx.

(** The Christoffel symbols \f$\gamma^c_{ab} = \frac12g^{cd}\bigl(\frac{\partial g_{ad}}{\partial y^b} +
\frac{\partial g_{bd}}{\partial y^a} - \frac{\partial g_{ab}}{\partial y^d}\bigr)\f$.
C++: `actio::christoffel`, `forms/metric.hpp`. *)
Definition first_kind c a b := d_y b (g a c) + d_y a (g b c) - d_y c (g a b).
Definition christoffel c a b := 2%:R^-1 * \sum_d invmx g c d * first_kind d a b.

Lemma half_of (x y : R) : 2%:R * x = y -> x = 2%:R^-1 * y.
Proof. by move=> <-; rewrite mulrA mulVr // mul1r. Qed.

Lemma metric_entry a b : g a b = g b a.
Proof. by have /matrixP /(_ b a) := symmetric_metric; rewrite mxE. Qed.

(** With the upper index lowered. *)
Lemma lowered_christoffel c a b : \sum_e g c e * christoffel e a b = 2%:R^-1 * first_kind c a b.
Proof.
have -> : \sum_e g c e * christoffel e a b
          = 2%:R^-1 * \sum_d (\sum_e g c e * invmx g e d) * first_kind d a b.
  rewrite mulr_sumr; under [RHS]eq_bigr do rewrite mulr_suml mulr_sumr.
  rewrite [RHS]exchange_big; apply: eq_bigr => e _; rewrite /christoffel mulr_sumr mulr_sumr.
  by apply: eq_bigr => d _; ring_identity.
have delta d : \sum_e g c e * invmx g e d = (c == d)%:R.
  by have := mulmxV regular_metric => /matrixP /(_ c d); rewrite [LHS]mxE [RHS]mxE.
congr (_ * _); rewrite (bigD1 c) //= delta eqxx mul1r big1 ?addr0 // => d ne.
by rewrite delta eq_sym (negbTE ne) mul0r.
Qed.

(** ** The Christoffel symbols

They are the symmetric symbols under which the metric is parallel, \f$\frac{\partial g_{ab}}{\partial y^c} =
g_{db}\,\gamma^d_{ac} + g_{ad}\,\gamma^d_{bc}\f$, and the only ones, in every dimension. *)
Theorem claim_6_2_christoffel (gamma : 'I_N -> 'I_N -> 'I_N -> R) :
  (forall d a b, gamma d a b = gamma d b a)
    /\ (forall a b c, d_y c (g a b) = \sum_d g d b * gamma d a c + \sum_d g a d * gamma d b c)
  <-> (forall d a b, gamma d a b = christoffel d a b).
Proof.
have symmetric_first c a b : first_kind c a b = first_kind c b a.
  by rewrite /first_kind (metric_entry a b) [d_y b _ + _]addrC.
have flip b (s : 'I_N -> R) : \sum_d g d b * s d = \sum_d g b d * s d.
  by apply: eq_bigr => d _; rewrite metric_entry.
split=> [[symmetric_gamma parallel] d a b|same].
  have lowered c : \sum_e g c e * gamma e a b = \sum_e g c e * christoffel e a b.
    rewrite lowered_christoffel /first_kind !parallel !flip.
    have -> : \sum_e g c e * gamma e b a = \sum_e g c e * gamma e a b.
      by apply: eq_bigr => e _; rewrite symmetric_gamma.
    have -> : \sum_e g b e * gamma e a c = \sum_e g b e * gamma e c a.
      by apply: eq_bigr => e _; rewrite symmetric_gamma.
    have -> : \sum_e g a e * gamma e b c = \sum_e g a e * gamma e c b.
      by apply: eq_bigr => e _; rewrite symmetric_gamma.
    apply: half_of; ring_identity.
  have /(congr1 (mulmx (invmx g))) :
      g *m (\col_e gamma e a b) = g *m (\col_e christoffel e a b).
    by apply/matrixP => c z; rewrite !mxE; under eq_bigr do rewrite mxE; rewrite lowered;
       apply: eq_bigr => e _; rewrite mxE.
  by rewrite !mulmxA mulVmx // !mul1mx => /matrixP /(_ d 0); rewrite !mxE.
split=> [d a b|a b c].
  by rewrite !same /christoffel; congr (_ * _); apply: eq_bigr => e _; rewrite symmetric_first.
rewrite flip.
have lowered e f h : \sum_d g e d * gamma d f h = 2%:R^-1 * first_kind e f h.
  by rewrite -lowered_christoffel; apply: eq_bigr => d _; rewrite same.
rewrite !lowered -mulrDr /first_kind (metric_entry b a) (metric_entry c a) (metric_entry c b).
apply: half_of; ring_identity.
Qed.

(** *** The trace of the Christoffel symbols

\f$\gamma^k_{jk} = \frac1r\frac{\partial r}{\partial y^j}\f$ for a root \f$r\f$ of \f$\det g\f$. Two of the
three terms of a symbol cancel in the sum, and the third is Jacobi's formula for the derivative of a
determinant. *)
Theorem trace_of_christoffel (root : R) j : root ^+ 2 = \det g -> root \is a GRing.unit ->
  \sum_k christoffel k j k = root^-1 * d_y j root.
Proof.
move=> is_root unit_root.
have symmetric_inverse k d : invmx g k d = invmx g d k.
  have same : (invmx g)^T = invmx g by rewrite trmx_inv symmetric_metric.
  by rewrite -[in RHS]same [RHS]mxE.
have -> : \sum_k christoffel k j k = 2%:R^-1 * \sum_k \sum_d invmx g k d * d_y j (g k d).
  rewrite -mulr_sumr; congr (_ * _).
  have -> : \sum_k \sum_d invmx g k d * first_kind d j k
      = \sum_k \sum_d invmx g k d * d_y k (g j d) + \sum_k \sum_d invmx g k d * d_y j (g k d)
        - \sum_k \sum_d invmx g k d * d_y d (g j k).
    rewrite -big_split -sumrB; apply: eq_bigr => k _ /=; rewrite -big_split -sumrB; apply: eq_bigr => d _ /=.
    by rewrite /first_kind; ring_identity.
  have -> : \sum_k \sum_d invmx g k d * d_y d (g j k) = \sum_k \sum_d invmx g k d * d_y k (g j d).
    by rewrite exchange_big; apply: eq_bigr => d _; apply: eq_bigr => k _; rewrite symmetric_inverse.
  by rewrite addrAC subrr add0r.
have := derivative_of_root (d_y j) is_root unit_root.
have -> : \tr (invmx g *m derivative_of (d_y j) g) = \sum_k \sum_d invmx g k d * d_y j (g k d).
  rewrite /mxtrace; apply: eq_bigr => k _; rewrite mxE; apply: eq_bigr => d _.
  by rewrite (mxE map_mx_key) metric_entry.
set s := \sum_k _ => twice.
have -> : s = 2%:R * (root^-1 * d_y j root) by rewrite mulrCA twice mulKr.
by rewrite mulKr.
Qed.

(** The covariant derivative of the velocity along the motion of a particle,
\f$\bigl(\frac{D_g\dot\phi}{Dt}\bigr)^b = \frac{\partial\dot\phi^b}{\partial t} +
\gamma^b_{ac}\,\dot\phi^a\dot\phi^c\f$. C++: `actio::material_acceleration`, `continuum/continuum.hpp`. *)
Variables (rate : derivation R) (velocity : 'I_N -> R).
Definition material_acceleration b :=
  rate (velocity b) + \sum_a \sum_c christoffel b a c * velocity a * velocity c.

(** The metric is a function of the point of space, which moves with the velocity. *)
Hypothesis along_motion : forall a b, rate (g a b) = \sum_c velocity c * d_y c (g a b).

(** ** The material acceleration

The acceleration that the field equations of the kinetic energy hold, with its index lowered:
\f[ g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = \frac{\partial}{\partial t}\bigl(g_{ab}\dot\phi^b\bigr) -
\frac12\frac{\partial g_{bc}}{\partial y^a}\,\dot\phi^b\dot\phi^c , \f]
with \f$\gamma^b_{ac}\,\dot\phi^a\dot\phi^c\f$ in the acceleration: its free index is \f$b\f$. *)
Theorem claim_6_2_material_acceleration a :
  \sum_b g a b * material_acceleration b
  = rate (\sum_b g a b * velocity b) - 2%:R^-1 * \sum_b \sum_c d_y a (g b c) * velocity b * velocity c.
Proof.
pose T := \sum_b \sum_c d_y c (g a b) * velocity b * velocity c.
pose S := \sum_b \sum_c d_y a (g b c) * velocity b * velocity c.
have rateE : rate (\sum_b g a b * velocity b) = \sum_b g a b * rate (velocity b) + T.
  rewrite raddf_sum -big_split; apply: eq_bigr => b _; rewrite leibniz along_motion addrC; congr (_ + _).
  by rewrite mulr_suml; apply: eq_bigr => c _; ring_identity.
have firstE : \sum_c \sum_e first_kind a c e * velocity c * velocity e = 2%:R * T - S.
  have -> : 2%:R * T = T + \sum_c \sum_e d_y c (g e a) * velocity c * velocity e.
    rewrite mulr_natl mulr2n; congr (_ + _); rewrite /T exchange_big.
    by apply: eq_bigr => c _; apply: eq_bigr => e _; rewrite (metric_entry e a); ring_identity.
  rewrite /T /S -big_split -sumrB; apply: eq_bigr => c _ /=; rewrite -big_split -sumrB.
  by apply: eq_bigr => e _; rewrite /first_kind (metric_entry c a) /=; ring_identity.
have -> : \sum_b g a b * material_acceleration b = \sum_b g a b * rate (velocity b) + 2%:R^-1 * (2%:R * T -
  S).
  rewrite -firstE /material_acceleration mulr_sumr.
  have -> : \sum_b g a b * (rate (velocity b) + \sum_c \sum_e christoffel b c e * velocity c * velocity e)
    = \sum_b g a b * rate (velocity b)
      + \sum_b g a b * (\sum_c \sum_e christoffel b c e * velocity c * velocity e).
    by rewrite -big_split; apply: eq_bigr => b _; rewrite mulrDr.
  congr (_ + _); under eq_bigr do rewrite mulr_sumr.
  rewrite exchange_big; apply: eq_bigr => c _; under eq_bigr do rewrite mulr_sumr.
  rewrite exchange_big mulr_sumr; apply: eq_bigr => e _ /=.
  rewrite !mulrA -lowered_christoffel !mulr_suml; apply: eq_bigr => b _; ring_identity.
have halve : 2%:R^-1 * (2%:R * T) = T by rewrite mulrA mulVr // mul1r.
by rewrite rateE mulrBr halve addrA.
Qed.

End Metric.

(** The printed acceleration has \f$\gamma^a_{bc}\dot\phi^b\dot\phi^c\f$ in its component \f$b\f$, with an
index \f$a\f$ that belongs to nothing. Whatever value \f$e\f$ that index is given, the formula fails in the
plane, in the two ways in which it can be read: with a sum over \f$b\f$ and \f$c\f$,
\f$\gamma^e_{bc}\dot\phi^b\dot\phi^c\f$, or with a sum over \f$c\f$ alone. *)
Definition printed_acceleration_summed (R : comUnitRingType) N (g : 'M[R]_N) (d_y : 'I_N -> derivation R)
    (rate : derivation R) (velocity : 'I_N -> R) e b :=
  rate (velocity b) + \sum_a \sum_c christoffel g d_y e a c * velocity a * velocity c.

Definition printed_acceleration_at (R : comUnitRingType) N (g : 'M[R]_N) (d_y : 'I_N -> derivation R)
    (rate : derivation R) (velocity : 'I_N -> R) e b :=
  rate (velocity b) + \sum_c christoffel g d_y e b c * velocity b * velocity c.

(** A metric of the plane for the counterexample, \f$(dy^1)^2 + (dy^2 + y^1dy^1)^2\f$ at \f$y^1 = z\f$: its
only symbol is \f$\gamma^2_{11} = 1\f$. *)
Section Shear.

Variables (R : comUnitRingType) (c : coordinate_ring 1 R).

Let z := coordinate c 0.
Definition shear_metric : 'M[R]_2 :=
  \matrix_(a, b) (if (a == 0) && (b == 0) then 1 + z * z else if (a == 1) && (b == 1) then 1 else z).
Definition shear_derivative (a : 'I_2) : derivation R :=
  if a == 0 then partial c 0 else zero_derivation [comRingType of R].

Lemma plane (P : 'I_2 -> Prop) : P 0 -> P 1 -> forall a, P a.
Proof.
by move=> P0 P1 [[|[|//]] lt]; [move: P0 | move: P1]; congr P; apply: val_inj.
Qed.

Lemma sum_in_plane (S : comRingType) (f : 'I_2 -> S) : \sum_i f i = f 0 + f 1.
Proof. by rewrite !big_ord_recl big_ord0 addr0; congr (f _ + f _); apply: val_inj. Qed.

Lemma shear_symmetric : shear_metric^T = shear_metric.
Proof. by apply/matrixP; apply: plane; apply: plane; rewrite !mxE. Qed.

Lemma shear_regular : shear_metric \in unitmx.
Proof.
rewrite unitmxE (determinant_of_two shear_metric) !mxE /=.
have -> : (1 + z * z) * 1 - z * z = 1 :> R by ring_identity.
exact: unitr1.
Qed.

Lemma shear_derivative_of_metric a b c' :
  shear_derivative c' (shear_metric a b)
  = if c' == 0 then (if (a == 0) && (b == 0) then z + z else if (a == 1) && (b == 1) then 0 else 1) else 0.
Proof.
move: a b c'; apply: plane; apply: plane; apply: plane; rewrite /shear_derivative /shear_metric !mxE //=;
  rewrite ?raddfD /= ?leibniz ?derivative_of_one ?partial_coordinate ?mul1r ?mulr1 ?add0r //.
Qed.

Hypothesis unit2 : (2%:R : R) \is a GRing.unit.

Lemma shear_christoffel e a b :
  christoffel shear_metric shear_derivative e a b = ((e == 1) && (a == 0) && (b == 0))%:R.
Proof.
pose gamma (e a b : 'I_2) : R := ((e == 1) && (a == 0) && (b == 0))%:R.
have [known _] := claim_6_2_christoffel shear_derivative unit2 shear_symmetric shear_regular gamma.
apply/esym; apply: known; split=> [{}e {}a {}b|{}a {}b {}e]; first by rewrite /gamma andbAC.
rewrite shear_derivative_of_metric !big_ord_recl !big_ord0 !mxE /gamma; move: a b e.
apply: plane; apply: plane; apply: plane => /=; ring_identity.
Qed.

End Shear.

Section ShearMotion.

Variables (R : comUnitRingType) (c : coordinate_ring 1 R).
Hypothesis unit2 : (2%:R : R) \is a GRing.unit.

(** A motion with the velocity \f$(1, 0)\f$: along it \f$y^1\f$ is the time. *)
Definition shear_velocity (a : 'I_2) : R := (a == 0)%:R.
Let rate := shear_derivative c 0.

Lemma shear_along_motion a b :
  rate (shear_metric c a b) = \sum_e shear_velocity e * shear_derivative c e (shear_metric c a b).
Proof. by rewrite !big_ord_recl big_ord0 /shear_velocity /= mul1r mul0r !addr0. Qed.

Lemma shear_acceleration b :
  material_acceleration (shear_metric c) (shear_derivative c) rate shear_velocity b = (b == 1)%:R.
Proof.
rewrite /material_acceleration /shear_velocity derivative_of_nat !big_ord_recl !big_ord0 !shear_christoffel
  //.
move: b; apply: plane => /=; ring_identity.
Qed.

(** Whatever has the right lowered components is the acceleration. *)
Lemma shear_only_acceleration (printed : 'I_2 -> R) :
    (forall a, \sum_b shear_metric c a b * printed b
      = rate (\sum_b shear_metric c a b * shear_velocity b)
        - 2%:R^-1 * \sum_b \sum_e shear_derivative c a (shear_metric c b e) * shear_velocity b *
          shear_velocity e) ->
  forall b, printed b = (b == 1)%:R.
Proof.
move=> same b; rewrite -shear_acceleration.
have /(congr1 (mulmx (invmx (shear_metric c)))) : shear_metric c *m (\col_b printed b)
    = shear_metric c *m (\col_b material_acceleration (shear_metric c) (shear_derivative c) rate
      shear_velocity b).
  apply/matrixP => a z; rewrite !(mxE mulmx_key).
  have := same a.
  rewrite -(claim_6_2_material_acceleration unit2 (shear_symmetric c) (shear_regular c) shear_along_motion)
    => equal.
  transitivity (\sum_b shear_metric c a b * printed b).
    by apply: eq_bigr => b' _; rewrite [X in _ * X = _]mxE.
  by rewrite equal; apply: eq_bigr => b' _; rewrite [X in _ = _ * X]mxE.
by rewrite !mulmxA mulVmx ?shear_regular // !mul1mx => /matrixP /(_ b 0); rewrite !mxE.
Qed.

End ShearMotion.

Lemma unit2_of_coordinates n R (c : coordinate_ring n R) : (2%:R : R) \is a GRing.unit.
Proof. by rewrite -(rmorph_nat (constant c)); apply: rmorph_unit; rewrite unitfE pnatr_eq0. Qed.

Lemma one_is_not_zero n R (c : coordinate_ring n R) : (0 : R) = 1 -> False.
Proof. by move/(congr1 (at_origin c)); rewrite rmorph0 rmorph1 => /eqP; rewrite eq_sym oner_eq0. Qed.

Lemma two_values (e : 'I_2) : e = 0 \/ e = 1.
Proof. by apply: (plane (P := fun e => e = 0 \/ e = 1)); [left | right]. Qed.

(** A printed acceleration gives the shear motion another one than it has: by \f$1\f$ in one of the two
components, whichever the index \f$e\f$ is. *)
Ltac refuted_by_shear e :=
  have [R [c]] := polynomials 1; have unit2 := unit2_of_coordinates c => claim;
  have := claim _ _ _ _ _ unit2 (shear_symmetric c) (shear_regular c) (shear_along_motion c);
  move/(shear_only_acceleration unit2) => value; have := value 0; have := value 1;
  rewrite /printed_acceleration_summed /printed_acceleration_at /shear_velocity !derivative_of_nat
    !big_ord_recl !big_ord0 !shear_christoffel //=;
  case: (two_values e) => -> /=; rewrite !(mulr0, mul0r, mulr1, addr0, add0r);
  [move/(one_is_not_zero c) | move=> _ /esym /(one_is_not_zero c)].

Theorem claim_6_2_material_acceleration_printed_fails (e : 'I_2) :
  ~ (forall (R : comUnitRingType) (g : 'M[R]_2) (d_y : 'I_2 -> derivation R) (rate : derivation R) velocity,
      (2%:R : R) \is a GRing.unit -> g^T = g -> g \in unitmx ->
      (forall a b, rate (g a b) = \sum_c velocity c * d_y c (g a b)) ->
      forall a, \sum_b g a b * printed_acceleration_summed g d_y rate velocity e b
        = rate (\sum_b g a b * velocity b) - 2%:R^-1 * \sum_b \sum_c d_y a (g b c) * velocity b * velocity c).
Proof. by refuted_by_shear e. Qed.

Theorem claim_6_2_material_acceleration_printed_fails_unsummed (e : 'I_2) :
  ~ (forall (R : comUnitRingType) (g : 'M[R]_2) (d_y : 'I_2 -> derivation R) (rate : derivation R) velocity,
      (2%:R : R) \is a GRing.unit -> g^T = g -> g \in unitmx ->
      (forall a b, rate (g a b) = \sum_c velocity c * d_y c (g a b)) ->
      forall a, \sum_b g a b * printed_acceleration_at g d_y rate velocity e b
        = rate (\sum_b g a b * velocity b) - 2%:R^-1 * \sum_b \sum_c d_y a (g b c) * velocity b * velocity c).
Proof. by refuted_by_shear e. Qed.

(** ** Fields along a section *)

Section AlongSection.

Variables (R : comUnitRingType) (n N : nat).

(** The derivatives \f$v^a{}_\mu\f$ of the fields and the total derivatives along a section. *)
Variables (v : 'I_N -> 'I_n.+1 -> R) (D : 'I_n.+1 -> derivation R).

(** The direction of the body with the number \f$k\f$, the velocity and the deformation gradient. *)
Definition along_body (k : 'I_n) : 'I_n.+1 := lift ord0 k.
Definition velocity_of a : R := v a ord0.
Definition gradient_of a k : R := v a (along_body k).

(** The metric of the body and the root \f$\sqrt{\det G}\f$. *)
Variables (G : 'M[R]_n) (vol : R).
Hypothesis unit2 : (2%:R : R) \is a GRing.unit.
Hypothesis symmetric_G : G^T = G.
Hypothesis root_of_G : vol ^+ 2 = \det G.
Hypothesis unit_volume : vol \is a GRing.unit.

(** The trace \f$\Gamma^k_{jk}\f$ of the Christoffel symbols of \f$G\f$. *)
Definition body_symbol j : R := \sum_k christoffel G (fun i => D (along_body i)) k j k.

(** It is \f$\frac1{\sqrt{\det G}}\frac{\partial\sqrt{\det G}}{\partial x^j}\f$. *)
Lemma body_symbol_of_root j : body_symbol j = vol^-1 * D (along_body j) vol.
Proof.
by rewrite /body_symbol (trace_of_christoffel _ unit2 symmetric_G j root_of_G unit_volume).
Qed.

(** \f$\mathcal P_a{}^i{}_{|i} = \frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal
P_a{}^j\,\Gamma^k_{jk} - \mathcal P_b{}^j\,\gamma^b_{ac}\,F^c{}_j\f$. C++: `actio::two_point_divergence`,
`continuum/two_point_divergence.hpp`. *)
Definition two_point_divergence (gamma : 'I_N -> 'I_N -> 'I_N -> R) (P : 'I_N -> 'I_n -> R) a : R :=
  \sum_i D (along_body i) (P a i) + \sum_j P a j * body_symbol j
  - \sum_b \sum_c \sum_j P b j * gamma b a c * gradient_of c j.

(** The covariant derivative of a vector field \f$w\f$ of space along a direction of the body,
\f$\nabla_jw^a = \frac{\partial w^a}{\partial x^j} + \gamma^a_{bc}\,w^bF^c{}_j\f$. *)
Definition covariant_derivative (gamma : 'I_N -> 'I_N -> 'I_N -> R) (w : 'I_N -> R) j a : R :=
  D (along_body j) (w a) + \sum_b \sum_c gamma a b c * w b * gradient_of c j.

(** ** The rule of Leibniz for the covariant divergence

What fixes the covariant divergence of section 6.2 is that for every vector field \f$w\f$ of space along the
section
\f[ \frac1{\sqrt{\det G}}\frac{\partial}{\partial x^i}\bigl(\sqrt{\det G}\,\mathcal P_a{}^iw^a\bigr) =
\mathcal P_a{}^i{}_{|i}\,w^a + \mathcal P_a{}^i\,\nabla_iw^a . \f]
It holds with \f$\mathcal P_b{}^j\,\gamma^b_{ac}\,F^c{}_j\f$ in the last term, for any symbols
\f$\gamma\f$. *)
Theorem claim_6_2_covariant_divergence gamma P w :
  vol^-1 * (\sum_i D (along_body i) (vol * \sum_a P a i * w a))
  = \sum_a two_point_divergence gamma P a * w a + \sum_a \sum_i P a i * covariant_derivative gamma w i a.
Proof.
have -> : vol^-1 * (\sum_i D (along_body i) (vol * \sum_a P a i * w a))
  = \sum_i \sum_a (D (along_body i) (P a i) * w a + P a i * body_symbol i * w a + P a i * D (along_body i)
    (w a)).
  rewrite mulr_sumr; apply: eq_bigr => i _; rewrite leibniz mulrDr [X in _ + X]mulrA mulVr ?unit_volume //.
  rewrite mul1r raddf_sum mulrA mulr_sumr -big_split; apply: eq_bigr => a _ /=.
  rewrite leibniz body_symbol_of_root; ring_identity.
rewrite exchange_big.
pose turned a := \sum_b \sum_c \sum_j P b j * gamma b a c * gradient_of c j.
have -> : \sum_a two_point_divergence gamma P a * w a
  = \sum_a (\sum_i (D (along_body i) (P a i) * w a + P a i * body_symbol i * w a) - turned a * w a).
  apply: eq_bigr => a _; rewrite /two_point_divergence big_split /= -!mulr_suml -/(turned a); ring_identity.
have turnedE : \sum_a turned a * w a
  = \sum_a \sum_i P a i * (\sum_b \sum_c gamma a b c * w b * gradient_of c i).
  rewrite /turned; under eq_bigr do rewrite mulr_suml.
  rewrite exchange_big; apply: eq_bigr => b _; under [RHS]eq_bigr do rewrite mulr_sumr.
  rewrite [RHS]exchange_big; apply: eq_bigr => a _; rewrite mulr_suml;
    under [RHS]eq_bigr do rewrite mulr_sumr.
  rewrite [RHS]exchange_big; apply: eq_bigr => c _; rewrite mulr_suml; apply: eq_bigr => i _.
  ring_identity.
have -> : \sum_a \sum_i P a i * covariant_derivative gamma w i a
  = \sum_a \sum_i P a i * D (along_body i) (w a) + \sum_a turned a * w a.
  rewrite turnedE -big_split; apply: eq_bigr => a _; rewrite -big_split; apply: eq_bigr => i _.
  by rewrite /covariant_derivative mulrDr.
have -> : \sum_a \sum_i (D (along_body i) (P a i) * w a + P a i * body_symbol i * w a + P a i * D
  (along_body i) (w a))
  = \sum_a \sum_i (D (along_body i) (P a i) * w a + P a i * body_symbol i * w a)
    + \sum_a \sum_i P a i * D (along_body i) (w a).
  by rewrite -big_split; apply: eq_bigr => a _; rewrite -big_split.
rewrite sumrB; ring_identity.
Qed.

End AlongSection.

(** ** The equation of motion *)

Section Motion.

Variables (R : comUnitRingType) (n N : nat).

(** The derivatives \f$v^a{}_\mu\f$ of the fields, the partial derivatives of functions on jets, and the total
derivatives along a section. *)
Variables (v : 'I_N -> 'I_n.+1 -> R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).

(** Mass density, \f$\sqrt{\det G}\f$, metric of space, stored energy, and the symmetric derivatives
\f$\partial W/\partial g_{bc}\f$. *)
Variables (rho vol : R) (g : 'M[R]_N) (W : R) (W_g : 'M[R]_N).

(** \f$\frac{\partial W}{\partial v^a{}_k}\f$. *)
Definition energy_slope a (k : 'I_n) : R := d_v a (along_body k) W.

(** The density (6.3) as a function on jets. *)
Definition medium_density : R := density rho vol g (velocity_of v) W.

(** What a medium is: \f$y^a\f$ and \f$v^a{}_\mu\f$ are coordinates; mass and volume are functions of the
point of the body, and \f$g\f$ is one of the point of space; the stored energy \f$W(x, G, g, F)\f$ does not
depend on the velocity, and on the point of space through \f$g\f$ alone. *)
Record is_medium : Prop := IsMedium {
  two_is_unit : (2%:R : R) \is a GRing.unit;
  volume_is_unit : vol \is a GRing.unit;
  metric_is_symmetric : g^T = g;
  metric_is_regular : g \in unitmx;
  velocity_coordinates : forall a mu b nu, d_v a mu (v b nu) = ((b == a) && (nu == mu))%:R;
  place_coordinates : forall a b nu, d_y a (v b nu) = 0;
  body_v : forall a mu, d_v a mu rho = 0 /\ d_v a mu vol = 0;
  body_y : forall a, d_y a rho = 0 /\ d_y a vol = 0;
  body_t : D ord0 rho = 0 /\ D ord0 vol = 0;
  space_v : forall a mu b c, d_v a mu (g b c) = 0;
  space_D : forall mu b c, D mu (g b c) = \sum_a v a mu * d_y a (g b c);
  energy_v : forall a, d_v a ord0 W = 0;
  energy_y : forall a, d_y a W = \sum_b \sum_c W_g b c * d_y a (g b c)
}.

Hypothesis medium : is_medium.

Lemma half_constant (d : derivation R) : d 2%:R^-1 = 0.
Proof. by rewrite derivative_of_inverse ?(two_is_unit medium) // derivative_of_nat !mul0r oppr0. Qed.

Lemma derivative_of_density (d : derivation R) : d rho = 0 -> d vol = 0 ->
  d medium_density = 2%:R^-1 * vol * rho * d (speed_squared g (velocity_of v)) - vol * rho * d W.
Proof.
move=> d_rho d_vol; rewrite /medium_density /density /kinetic /potential raddfB /= !leibniz half_constant
  d_rho d_vol.
ring_identity.
Qed.

Lemma derivative_of_speed (d : derivation R) :
  d (speed_squared g (velocity_of v))
  = \sum_b \sum_c d (g b c) * (velocity_of v) b * (velocity_of v) c
    + 2%:R * (\sum_b \sum_c g b c * d ((velocity_of v) b) * (velocity_of v) c).
Proof.
have -> : 2%:R * (\sum_b \sum_c g b c * d ((velocity_of v) b) * (velocity_of v) c)
  = \sum_b \sum_c g b c * d ((velocity_of v) b) * (velocity_of v) c
    + \sum_b \sum_c g b c * (velocity_of v) b * d ((velocity_of v) c).
  rewrite mulr_natl mulr2n; congr (_ + _); rewrite exchange_big.
  apply: eq_bigr => c _; apply: eq_bigr => b _; rewrite (metric_entry (metric_is_symmetric medium)) /=.
  ring_identity.
rewrite /speed_squared raddf_sum -!big_split; apply: eq_bigr => b _ /=.
rewrite raddf_sum -!big_split; apply: eq_bigr => c _; rewrite !leibniz /=; ring_identity.
Qed.

(** ** The momenta of a medium

(6.4): the partial derivatives of the density are
\f$p_a{}^0 = \rho\,g_{ab}v^b{}_0\sqrt{\det G}\f$ and
\f$p_a{}^j = -\rho\,\frac{\partial W}{\partial v^a{}_j}\sqrt{\det G}\f$. *)
Theorem eq_6_4 a :
  momentum d_v medium_density a ord0 = time_momentum rho vol g (velocity_of v) a
  /\ forall j, momentum d_v medium_density a (along_body j) = space_momentum rho vol energy_slope a j.
Proof.
have flat mu : \sum_b \sum_c d_v a mu (g b c) * (velocity_of v) b * (velocity_of v) c = 0.
  by rewrite big1 // => b _; rewrite big1 // => c _; rewrite (space_v medium) !mul0r.
split=> [|j]; rewrite /momentum derivative_of_density ?(body_v medium _ _).1 ?(body_v medium _ _).2 //.
  rewrite (energy_v medium) derivative_of_speed flat.
  have -> : \sum_b \sum_c g b c * d_v a ord0 ((velocity_of v) b) * (velocity_of v) c = \sum_c g a c *
    (velocity_of v) c.
    rewrite (bigD1 a) //= [X in _ + X]big1 => [|b ne].
      by rewrite addr0; apply: eq_bigr => c _; rewrite (velocity_coordinates medium) !eqxx mulr1.
    by rewrite big1 // => c _; rewrite (velocity_coordinates medium) (negbTE ne) mulr0 mul0r.
  set s := \sum_c _; rewrite /time_momentum -/s.
  have -> : 2%:R^-1 * vol * rho * (0 + 2%:R * s) - vol * rho * 0 = 2%:R^-1 * 2%:R * (rho * s * vol).
    ring_identity.
  by rewrite mulVr ?(two_is_unit medium) // mul1r.
rewrite derivative_of_speed flat add0r.
have -> : \sum_b \sum_c g b c * d_v a (along_body j) ((velocity_of v) b) * (velocity_of v) c = 0.
  rewrite big1 // => b _; rewrite big1 // => c _; rewrite (velocity_coordinates medium).
  by rewrite (negbTE (neq_lift _ _)) andbF mulr0 mul0r.
rewrite /space_momentum /energy_slope; ring_identity.
Qed.

(** \f$\rho\,\frac{\partial W}{\partial v^a{}_k}\f$, the first Piola-Kirchhoff stress (6.19).
C++: `actio::first_piola_kirchhoff_stress`, `continuum/stresses.hpp`. *)
Definition first_piola_kirchhoff_stress a k : R := rho * energy_slope a k.

Definition acceleration := material_acceleration g d_y (D ord0) (velocity_of v).

(** ** The equation of motion of a continuous medium

For the density (6.3) the Euler-Lagrange equations (6.12) are
\f[ \rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b - \frac{1}{\sqrt{\det G}}\frac{\partial}{\partial x^k}
\Bigl(\rho\,\frac{\partial W}{\partial v^a{}_k}\sqrt{\det G}\Bigr) = -\rho\,\frac{\partial W}{\partial
g_{bc}}\frac{\partial g_{bc}}{\partial y^a} . \f]
The Euler-Lagrange derivative is \f$-\sqrt{\det G}\f$ times the difference of the two sides, for every
section. *)
Theorem eq_6_13 a :
  euler_lagrange d_y d_v D medium_density a
  = - (vol * (rho * (\sum_b g a b * acceleration b)
      - vol^-1 * (\sum_k D (along_body k) (rho * energy_slope a k * vol))
      + rho * \sum_b \sum_c W_g b c * d_y a (g b c))).
Proof.
have motion b c : D ord0 (g b c) = \sum_e (velocity_of v) e * d_y e (g b c) by apply: (space_D medium).
have acc := claim_6_2_material_acceleration (two_is_unit medium) (metric_is_symmetric medium)
              (metric_is_regular medium) motion a.
rewrite /euler_lagrange big_ord_recl (eq_6_4 a).1.
have -> : \sum_(k < n) D (lift ord0 k) (momentum d_v medium_density a (lift ord0 k))
          = - \sum_k D (along_body k) (rho * energy_slope a k * vol).
  by rewrite -sumrN; apply: eq_bigr => k _; rewrite -/(along_body k) (eq_6_4 a).2 raddfN.
rewrite derivative_of_density ?(body_y medium _).1 ?(body_y medium _).2 // derivative_of_speed.
have -> : \sum_b \sum_c g b c * d_y a ((velocity_of v) b) * (velocity_of v) c = 0.
  by rewrite big1 // => b _; rewrite big1 // => c _; rewrite (place_coordinates medium) mulr0 mul0r.
rewrite (energy_y medium) acc /time_momentum !leibniz (body_t medium).1 (body_t medium).2 -/(acceleration _).
set S := \sum_b \sum_c d_y a (g b c) * _ * _; set T := D ord0 _; set Z := \sum_k D _ _.
rewrite -{1}(mulVKr (volume_is_unit medium) Z); ring_identity.
Qed.

(** ** The equation of motion with constant metrics

(6.15), for constant \f$g\f$ and \f$G\f$ and a mass density that may vary: \f$\rho\,\ddot\phi_a =
\frac{\partial}{\partial x^k}\bigl(\rho\,\frac{\partial W}{\partial v^a{}_k}\bigr)\f$. *)
Theorem eq_6_15 a :
    (forall e b c, d_y e (g b c) = 0) -> (forall k, D (along_body k) vol = 0) ->
  euler_lagrange d_y d_v D medium_density a
  = - (vol * (rho * (\sum_b g a b * D ord0 ((velocity_of v) b)) - \sum_k D (along_body k) (rho *
    energy_slope a k))).
Proof.
move=> constant_g constant_G; rewrite eq_6_13; congr (- (_ * _)).
have straight b : acceleration b = D ord0 ((velocity_of v) b).
  rewrite /acceleration /material_acceleration big1 ?addr0 // => e _; rewrite big1 // => c _.
  rewrite /christoffel big1 ?mulr0 ?mul0r // => h _.
  by rewrite /first_kind !constant_g !(addr0, subr0, mulr0).
rewrite (eq_bigr _ (fun b _ => congr1 (fun r => g a b * r) (straight b))).
rewrite [X in _ + rho * X]big1 ?mulr0 ?addr0 => [|b _]; last first.
  by rewrite big1 // => c _; rewrite constant_g mulr0.
congr (_ - _); rewrite mulr_sumr; apply: eq_bigr => k _.
by rewrite leibniz constant_G mulr0 addr0 mulrCA mulVr ?mulr1 ?(volume_is_unit medium).
Qed.

End Motion.

(** In the printed last term, \f$-\mathcal P_b{}^i\,\gamma^b_{ac}\,F_j{}^c\f$, the indices \f$i\f$ and \f$j\f$
are left over. The rule of Leibniz fails if both are summed, and whatever values they are given, in the plane
with the metric \f$(dy^1)^2 + (dy^2 + y^1dy^1)^2\f$ and its Christoffel symbols, for the shear \f$y = (x^1 +
x^2, x^2)\f$. *)
Definition divergence_with (R : comUnitRingType) n N (D : 'I_n.+1 -> derivation R) (G : 'M[R]_n) (P : 'I_N ->
  'I_n -> R)
    (last_term : 'I_N -> R) a :=
  \sum_i D (along_body i) (P a i) + \sum_j P a j * body_symbol D G j - last_term a.

(** What is asked of the last term: the rule of Leibniz, for the Christoffel symbols of a metric of the
plane. *)
Definition leibniz_rule_for (last_term : forall R : comUnitRingType,
    ('I_2 -> 'I_2 -> 'I_2 -> R) -> ('I_2 -> 'I_2 -> R) -> ('I_2 -> 'I_2 -> R) -> 'I_2 -> R) : Prop :=
  forall (R : comUnitRingType) (v : 'I_2 -> 'I_3 -> R) (D : 'I_3 -> derivation R) (d_y : 'I_2 -> derivation R)
    (g G : 'M[R]_2) (vol : R) (P : 'I_2 -> 'I_2 -> R) (w : 'I_2 -> R),
  (2%:R : R) \is a GRing.unit -> G^T = G -> vol ^+ 2 = \det G -> vol \is a GRing.unit ->
  g^T = g -> g \in unitmx ->
  (forall k b c, D (along_body k) (g b c) = \sum_e gradient_of v e k * d_y e (g b c)) ->
  (forall k e i, D (along_body k) (gradient_of v e i) = D (along_body i) (gradient_of v e k)) ->
  vol^-1 * (\sum_i D (along_body i) (vol * \sum_a P a i * w a))
  = \sum_a divergence_with D G P (last_term R (christoffel g d_y) P (gradient_of v)) a * w a
    + \sum_a \sum_i P a i * covariant_derivative v D (christoffel g d_y) w i a.

(** The corrected term obeys it. *)
Lemma leibniz_rule_corrected :
  leibniz_rule_for (fun R gamma P F a => \sum_b \sum_c \sum_j P b j * gamma b a c * F c j).
Proof.
by move=> R v D d_y g G vol P w unit2 sym_G root_G unit_vol _ _ _ _; apply: claim_6_2_covariant_divergence.
Qed.

Section ShearOfTheBody.

Variables (R : comUnitRingType) (c : coordinate_ring 1 R).
Hypothesis unit2 : (2%:R : R) \is a GRing.unit.

Definition shear_jet (a : 'I_2) (mu : 'I_3) : R := if a == 0 then 1 else (mu == along_body 1)%:R.

Lemma shear_last_term last_term (P : 'I_2 -> 'I_2 -> R) : leibniz_rule_for last_term ->
  (forall a i, partial c 0 (P a i) = 0) ->
  last_term R (christoffel (shear_metric c) (shear_derivative c)) P (gradient_of shear_jet) 0 = P 1 0 + P 1 1.
Proof.
move=> rule constant_P.
pose D (_ : 'I_3) := partial c 0; pose w (a : 'I_2) : R := (a == 0)%:R.
have motion k b e : D (along_body k) (shear_metric c b e)
    = \sum_h gradient_of shear_jet h k * shear_derivative c h (shear_metric c b e).
  by rewrite sum_in_plane /gradient_of /shear_jet /shear_derivative /= mul1r mulr0 addr0.
have mixed k e i : D (along_body k) (gradient_of shear_jet e i) = D (along_body i) (gradient_of shear_jet e
  k).
  by rewrite /gradient_of /shear_jet; case: (e == 0); rewrite ?derivative_of_one ?derivative_of_nat.
have root_one : 1 ^+ 2 = \det (1%:M : 'M[R]_2) by rewrite expr1n det1.
have := rule R shear_jet D (shear_derivative c) (shear_metric c) 1%:M 1 P w unit2 (trmx1 _ _) root_one
          (unitr1 _) (shear_symmetric c) (shear_regular c) motion mixed.
rewrite (leibniz_rule_corrected (D := D) P w unit2 (trmx1 _ _) root_one (unitr1 _) (shear_symmetric c)
  (shear_regular c) motion mixed).
move/addIr; rewrite !sum_in_plane /w /= !(mulr0, mulr1, addr0) /divergence_with.
move/addrI/oppr_inj => <-.
rewrite !sum_in_plane !shear_christoffel //= /gradient_of /shear_jet /=; ring_identity.
Qed.

End ShearOfTheBody.

Theorem claim_6_2_covariant_divergence_printed_fails :
  ~ leibniz_rule_for (fun R gamma P F a => \sum_b \sum_c \sum_i \sum_j P b i * gamma b a c * F c j).
Proof.
move=> rule; have [R [c]] := polynomials 1; have unit2 := unit2_of_coordinates c.
pose P (a i : 'I_2) : R := ((a == 1) && (i == 1))%:R.
have constant_P a i : partial c 0 (P a i) = 0 by apply: derivative_of_nat.
have := shear_last_term unit2 rule constant_P.
rewrite !sum_in_plane !shear_christoffel //= /gradient_of /shear_jet /P /=.
rewrite !(mulr0, mul0r, mulr1, addr0, add0r) => equal; apply: (one_is_not_zero c).
by apply: (addrI (1 : R)); rewrite equal addr0.
Qed.

Theorem claim_6_2_covariant_divergence_printed_fails_at (i j : 'I_2) :
  ~ leibniz_rule_for (fun R gamma P F a => \sum_b \sum_c P b i * gamma b a c * F c j).
Proof.
move=> rule; have [R [c]] := polynomials 1; have unit2 := unit2_of_coordinates c.
pose P (a k : 'I_2) : R := ((a == 1) && (k != i))%:R.
have constant_P a k : partial c 0 (P a k) = 0 by apply: derivative_of_nat.
have := shear_last_term unit2 rule constant_P.
rewrite !sum_in_plane !shear_christoffel //= /gradient_of /shear_jet /P /= eqxx /=.
rewrite !(mulr0, mul0r, mulr1, addr0, add0r) => equal; apply: (one_is_not_zero c); rewrite equal.
by case: (two_values i) => -> /=; rewrite ?addr0 ?add0r.
Qed.
