(** * Relabelling and currents

Chapter 9: relabellings of the body act on jets, finite ones by the determinant of their tangent maps; the two
Lagrangians of section 9.1 and the multiplier that goes over as a density; the currents of relabelling and of
time. Body and space have one dimension \f$n\f$, any. *)

From mathcomp Require Import all_ssreflect all_algebra.
From actio Require Import matrices ring_identities derivations fields.
From actio Require Import continuum stresses fluids incompressible.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(** ** Prolongation in coordinates *)

Section Prolongation.

Variables (R : comUnitRingType) (n N : nat).

(** The jet \f$\gamma\f$ of a section as a linear map from space-time, body and time, to \f$Y\f$: the
identity, and the gradient beside the velocity. *)
Definition jet_map (F : 'M[R]_(N, n)) (velocity : 'cV[R]_N) : 'M[R]_(n + 1 + N, n + 1) :=
  col_mx 1%:M (row_mx F velocity).

(** The tangent maps of a relabelling of space-time, with the tangent map \f$B\f$ of the body, and of its lift
to \f$Y\f$, which is the identity on the fibres. *)
Definition tangent_of_base (B : 'M[R]_n) : 'M[R]_(n + 1) := block_mx B 0 0 1%:M.
Definition tangent_of_lift (B : 'M[R]_n) : 'M[R]_(n + 1 + N) := block_mx (tangent_of_base B) 0 0 1%:M.

(** Section 9.1: the prolongation \f$T\eta_Y\circ\gamma\circ T\eta_X^{-1}\f$ (9.2) has the velocity of
\f$\gamma\f$ and the gradient \f$v^a{}_m\,\bigl((\partial\eta/\partial x)^{-1}\bigr)^m{}_j\f$. *)
Theorem claim_9_1_prolongation_coordinates (B : 'M[R]_n) F velocity : B \in unitmx ->
  tangent_of_lift B *m jet_map F velocity *m invmx (tangent_of_base B) = jet_map (F *m invmx B) velocity.
Proof.
move=> unit_B.
have inverse : invmx (tangent_of_base B) = tangent_of_base (invmx B).
  have product : tangent_of_base (invmx B) *m tangent_of_base B = 1%:M.
    by rewrite /tangent_of_base mulmx_block !mulmx0 !mul0mx !mulmx1 !addr0 add0r mulVmx // -scalar_mx_block.
  by rewrite -[RHS]mulmx1 -(mulmxV (mulmx1_unit product).2) mulmxA product mul1mx.
have unit_base : tangent_of_base B \in unitmx.
  by rewrite unitmxE /tangent_of_base det_ublock det1 mulr1 -unitmxE.
rewrite /jet_map /tangent_of_lift mul_block_col !(mul0mx, mulmx1, mul1mx, add0r, addr0).
rewrite mul_col_mx mulmxV //; congr (col_mx _ _).
by rewrite inverse /tangent_of_base mul_row_block !(mulmx0, mulmx1, add0r, addr0).
Qed.

(** The prolongation of a composition is the composition of the prolongations. *)
Theorem claim_9_1_prolongation_functorial_coordinates (A B : 'M[R]_n) (F : 'M[R]_(N, n)) :
  A \in unitmx -> B \in unitmx -> F *m invmx (A *m B) = F *m invmx B *m invmx A.
Proof.
move=> unit_A unit_B; rewrite -mulmxA; congr (_ *m _).
have product : invmx B *m invmx A *m (A *m B) = 1%:M by rewrite !mulmxA mulmxKV // mulVmx.
by rewrite -[RHS]mulmx1 -(mulmxV (mulmx1_unit product).2) mulmxA product mul1mx.
Qed.

(** ** Infinitesimal prolongation

(9.3): along the flow of a field \f$\xi\f$ on the body, whose tangent map obeys
\f$\dot B = \frac{\partial\xi}{\partial x}B\f$, the gradient of the prolonged jet obeys \f$\dot v^a{}_j =
-v^a{}_m\,\frac{\partial\xi^m}{\partial x^j}\f$. The field need not be free of divergence. *)
Theorem eq_9_3 (d : derivation R) (B Xi : 'M[R]_n) (F : 'M[R]_(N, n)) :
    B \in unitmx -> derivative_of d F = 0 -> derivative_of d B = Xi *m B ->
  derivative_of d (F *m invmx B) = - (F *m invmx B *m Xi).
Proof.
move=> unit_B constant flow; rewrite derivative_of_matrix_product constant mul0mx add0r.
by rewrite derivative_of_inverse_matrix // flow mulmxN !mulmxA mulmxK.
Qed.

End Prolongation.

(** ** Equivariance of the two Lagrangians *)

Section Equivariance.

Variables (R : comUnitRingType) (n : nat).

(** A jet and a relabelling at it: gradient and velocity, the metric of space at the point of space and its
root, the root of \f$\det G\f$ at the point of the body and at its image, and the tangent map of the
relabelling. *)
Variables (F g : 'M[R]_n) (velocity : 'I_n -> R) (root_g root_G root_G' : R) (B : 'M[R]_n).
Hypothesis unit_G : root_G \is a GRing.unit.
Hypothesis unit_G' : root_G' \is a GRing.unit.
Hypothesis unit_B : B \in unitmx.

(** It preserves the volume of the body where \f$\sqrt{\det G(\eta(x))}\,\det\partial\eta = \sqrt{\det
G(x)}\f$. *)
Hypothesis preserves_volume : root_G' * \det B = root_G.

(** The gradient of the prolonged jet. *)
Let F' := F *m invmx B.

Lemma jacobian_preserved : jacobian F' root_g root_G' = jacobian F root_g root_G.
Proof.
have unit_det : \det B \is a GRing.unit by rewrite -unitmxE.
rewrite /jacobian /F' det_mulmx det_inv -preserves_volume invrM //; ring_identity.
Qed.

Lemma root_divided : root_G' = root_G / \det B.
Proof. by rewrite -preserves_volume mulrK // -unitmxE. Qed.

(** ** Functions of the Jacobian

A form on space-time is pushed forward by \f$\eta\f$ by dividing its coefficient by \f$\det\partial\eta\f$.
For a relabelling that preserves volume \f$J\f$ is the same before and after, and
\f[ f(J(\eta_{J^1E}(\bar\gamma)))\sqrt{\det G}\,d^{n+1}x = (\eta_X^{-1})^*\bigl(f(J(\bar\gamma))\sqrt{\det
G}\,d^{n+1}x\bigr) \f]
for every function \f$f\f$, with \f$\det\partial\eta = \sqrt{\det G}/(\sqrt{\det G}\circ\eta)\f$. *)
Theorem claim_9_1_jacobian_functions (f : R -> R) :
  \det B = root_G / root_G'
  /\ f (jacobian F' root_g root_G') * root_G' = f (jacobian F root_g root_G) * root_G / \det B.
Proof.
split; first by rewrite -preserves_volume mulrAC divrr // mul1r.
by rewrite jacobian_preserved [X in _ * X = _]root_divided mulrA.
Qed.

(** ** The barotropic fluid is equivariant under relabelling

For every metric of the body: with a constant mass density and a stored energy \f$w(J)\f$ the density (6.3) at
the prolonged jet is that at the jet, divided by \f$\det\partial\eta\f$. *)
Theorem claim_9_1_barotropic_equivariance (rho : R) (w : R -> R) :
  density rho root_G' g velocity (w (jacobian F' root_g root_G'))
  = density rho root_G g velocity (w (jacobian F root_g root_G)) / \det B.
Proof. rewrite jacobian_preserved /density /kinetic /potential root_divided; ring_identity. Qed.

(** ** The multiplier goes over as a density

(9.1): with \f$\lambda = \sqrt{\det G}\,P\f$ (8.2) the lift that leaves the pressure \f$P\f$ of a particle as
it is takes \f$\lambda\f$ to \f$\lambda/\det\partial\eta\f$. *)
Theorem eq_9_1 (P : R) : multiplier root_G' P = multiplier root_G P / \det B.
Proof. rewrite /multiplier root_divided; ring_identity. Qed.

(** ** The incompressible fluid is equivariant under relabelling

Proposition 9.1.1 for the density (8.3), at every jet, whether \f$J = 1\f$ or not, with the multiplier divided
by \f$\det\partial\eta\f$; and with no other multiplier where \f$J - 1\f$ has an inverse. *)
Definition incompressible_at_jet (rho root W lambda J : R) :=
  density rho root g velocity W + lambda * (J - 1).

Theorem claim_9_1_incompressible_equivariance (rho W lambda : R) :
  incompressible_at_jet rho root_G' W (lambda / \det B) (jacobian F' root_g root_G')
  = incompressible_at_jet rho root_G W lambda (jacobian F root_g root_G) / \det B.
Proof.
rewrite jacobian_preserved /incompressible_at_jet /density /kinetic /potential root_divided; ring_identity.
Qed.

Theorem claim_9_1_incompressible_equivariance_only (rho W lambda lambda' : R) :
    jacobian F root_g root_G - 1 \is a GRing.unit ->
    incompressible_at_jet rho root_G' W lambda' (jacobian F' root_g root_G')
    = incompressible_at_jet rho root_G W lambda (jacobian F root_g root_G) / \det B ->
  lambda' = lambda / \det B.
Proof.
move=> off_constraint; rewrite -claim_9_1_incompressible_equivariance => /addrI.
by rewrite jacobian_preserved => /(mulIr off_constraint).
Qed.

(** Proposition 9.1.1: both together, with the lift of (9.1) corrected. *)
Theorem prop_9_1_1 (rho : R) (w : R -> R) (lambda : R) :
  density rho root_G' g velocity (w (jacobian F' root_g root_G'))
    = density rho root_G g velocity (w (jacobian F root_g root_G)) / \det B
  /\ incompressible_at_jet rho root_G' (w 1) (lambda / \det B) (jacobian F' root_g root_G')
    = incompressible_at_jet rho root_G (w 1) lambda (jacobian F root_g root_G) / \det B.
Proof.
by split; [exact: claim_9_1_barotropic_equivariance | exact: claim_9_1_incompressible_equivariance].
Qed.

End Equivariance.

(** As printed, volume-preserving relabellings have the determinant 1, and the functions of \f$J\f$ without
\f$\sqrt{\det G}\f$ go over into each other as forms. Both need coordinates in which \f$\det G\f$ is constant:
they fail on a line where a particle with \f$\sqrt{\det G} = 2\f$ goes to a place with
\f$\sqrt{\det G} = 1\f$. *)
Theorem claim_9_1_jacobian_functions_printed_fails :
  ~ (forall n (B : 'M[rat]_n) (root_G root_G' : rat),
      0 < root_G -> 0 < root_G' -> root_G' * \det B = root_G ->
      \det B = 1).
Proof.
move=> claim; have := claim 1%N 2%:R%:M 2%:R 1 isT isT; rewrite det_scalar1 mul1r => /(_ erefl) /eqP.
by vm_compute.
Qed.

Theorem claim_9_1_jacobian_functions_printed_fails_as_forms :
  ~ (forall n (F B : 'M[rat]_n) (root_g root_G root_G' : rat) (f : rat -> rat),
      0 < root_g -> 0 < root_G -> 0 < root_G' -> B \in unitmx -> root_G' * \det B = root_G ->
      f (jacobian (F *m invmx B) root_g root_G') = f (jacobian F root_g root_G) / \det B).
Proof.
move=> claim; have := claim 1%N 1%:M 2%:R%:M 1 2%:R 1 (fun _ => 1) isT isT isT.
rewrite unitmxE det_scalar1 mul1r => /(_ isT erefl) /eqP.
by vm_compute.
Qed.

(** With the printed lift (9.1), which leaves \f$\lambda\f$ as it is, the pressure of a particle does not
stay. *)
Theorem eq_9_1_printed_fails :
  ~ (forall n (B : 'M[rat]_n) (root_G root_G' P : rat),
      0 < root_G -> 0 < root_G' -> root_G' * \det B = root_G ->
      multiplier root_G P = multiplier root_G' P).
Proof.
move=> claim; have := claim 1%N 2%:R%:M 2%:R 1 1 isT isT; rewrite det_scalar1 mul1r => /(_ erefl) /eqP.
by vm_compute.
Qed.

(** And the Lagrangian of the incompressible fluid is not equivariant under it: at a jet with \f$J = 2\f$. *)
Theorem prop_9_1_1_printed_fails :
  ~ (forall n (F g B : 'M[rat]_n) velocity (root_g root_G root_G' rho W lambda : rat),
      0 < root_g -> 0 < root_G -> 0 < root_G' -> 0 < rho -> root_g ^+ 2 = \det g -> g^T = g ->
      B \in unitmx -> root_G' * \det B = root_G ->
      incompressible_at_jet g velocity rho root_G' W lambda (jacobian (F *m invmx B) root_g root_G')
      = incompressible_at_jet g velocity rho root_G W lambda (jacobian F root_g root_G) / \det B).
Proof.
move=> claim; have := claim 1%N 4%:R%:M 1%:M 2%:R%:M (fun _ => 0) 1 2%:R 1 1 0 1 isT isT isT isT.
rewrite det1 expr1n trmx1 unitmxE det_scalar1 mul1r => /(_ erefl erefl isT erefl).
have unit_B : (2%:R%:M : 'M[rat]_1) \in unitmx by rewrite unitmxE det_scalar1.
have volume : 1 * \det (2%:R%:M : 'M[rat]_1) = 2%:R by rewrite det_scalar1 mul1r.
rewrite (jacobian_preserved _ _ _ unit_B volume) //.
rewrite /incompressible_at_jet /density /kinetic /potential /speed_squared /jacobian !big_ord1 det_scalar1.
rewrite !mulr0 subrr.
by rewrite !add0r !mul1r => /eqP; vm_compute.
Qed.

(** *** Currents of relabelling *)

Section Currents.

Variables (R : comUnitRingType) (n : nat).
Variables (x : 'I_n.+1 -> R) (y : 'I_n -> R) (v : 'I_n -> 'I_n.+1 -> R).
Variables (d_x : 'I_n.+1 -> derivation R) (d_y : 'I_n -> derivation R) (d_v : 'I_n -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).
Variables (rho : R) (g : 'M[R]_n) (root_g root_G W W_J : R) (W_g : 'M[R]_n).
Hypothesis medium : is_medium v d_y d_v D rho root_G g W W_g.
Hypothesis root_of_g : root_g ^+ 2 = \det g.
Hypothesis unit_g : root_g \is a GRing.unit.
Hypothesis root_g_v : forall a mu, d_v a mu root_g = 0.

Let F := gradient_matrix v.
Let J := jacobian F root_g root_G.
Let areas := area_transformation F root_g root_G.

(** The prolongation \f$X\f$ of a field \f$\xi\f$ on the body. *)
Variables (X : derivation R) (xi : 'I_n -> R).
Hypothesis time_part : X (x ord0) = 0.
Hypothesis body_part : forall k, X (x (along_body k)) = xi k.
Hypothesis field_part : forall a, X (y a) = 0.

Lemma displacement a : X (y a) - \sum_mu v a mu * X (x mu) = - \sum_k gradient_of v a k * xi k.
Proof.
rewrite field_part sub0r big_ord_recl time_part mulr0 add0r; congr (- _).
by apply: eq_bigr => k _; rewrite -/(along_body k) body_part.
Qed.

Lemma areas_of_gradient k i : \sum_a areas k a * gradient_of v a i = (k == i)%:R * J.
Proof.
have -> : \sum_a areas k a * gradient_of v a i = root_g / root_G * (\adj F *m F) k i.
  rewrite mxE mulr_sumr; apply: eq_bigr => a _.
  by rewrite /areas /area_transformation [X in X * _ = _]mxE [F a i]mxE mulrA.
rewrite mul_adj_mx mxE /J /jacobian; case: (k == i) => /=; ring_identity.
Qed.

(** The momentum of the current: it is common to all fluids. *)
Definition momentum_part : R :=
  - (rho * root_G * \sum_k (\sum_a \sum_b g a b * velocity_of v b * gradient_of v a k) * xi k).

Lemma time_current L :
    (forall a, momentum d_v L a ord0 = time_momentum rho root_G g (velocity_of v) a) ->
  noether_current x y v d_v L X ord0 = momentum_part.
Proof.
move=> momenta; rewrite /noether_current time_part mulr0 addr0.
under eq_bigr do rewrite momenta displacement mulrN mulr_sumr.
rewrite sumrN /momentum_part; congr (- _); rewrite exchange_big mulr_sumr; apply: eq_bigr => k _.
rewrite mulr_suml mulr_sumr; apply: eq_bigr => a _; rewrite /time_momentum mulr_suml mulr_sumr.
rewrite mulr_sumr mulr_suml mulr_suml; apply: eq_bigr => b _; ring_identity.
Qed.

Lemma space_current L Q k :
    (forall a j, momentum d_v L a (along_body j) = Q * areas j a) ->
  noether_current x y v d_v L X (along_body k) = (L - Q * J) * xi k.
Proof.
move=> momenta; rewrite /noether_current body_part.
have -> : \sum_a momentum d_v L a (along_body k) * (X (y a) - \sum_nu v a nu * X (x nu)) = - (Q * J * xi k).
  have -> : Q * J * xi k = Q * (\sum_i (\sum_a areas k a * gradient_of v a i) * xi i).
    rewrite (bigD1 k) //= areas_of_gradient eqxx mul1r big1 => [|i ne]; first by ring_identity.
    by rewrite areas_of_gradient eq_sym (negbTE ne) !mul0r.
  under eq_bigr do rewrite momenta displacement mulrN mulr_sumr.
  rewrite sumrN exchange_big mulr_sumr; congr (- _); apply: eq_bigr => i _.
  by rewrite mulr_suml mulr_sumr; apply: eq_bigr => a _; ring_identity.
ring_identity.
Qed.

(** ** The relabelling current of a barotropic fluid

(9.8): the current \f$(j^1\phi)^*J_{\mathcal L}(\xi)\f$, with \f$P = -\rho\,\partial W/\partial J\f$, is
\f[ \Bigl(\tfrac12\rho\,g_{ab}\dot\phi^a\dot\phi^b - \rho W - PJ\Bigr)\sqrt{\det G}\,\xi^k\,d^nx_k -
\bigl(g_{ab}\dot\phi^b\phi^a{}_{,k}\bigr)\rho\sqrt{\det G}\,\xi^k\,d^nx_0 . \f] *)
Theorem eq_9_8 :
    (forall a k, d_v a (along_body k) W = W_J * d_v a (along_body k) J) ->
  let L := medium_density v rho root_G g W in
  noether_current x y v d_v L X ord0 = momentum_part
  /\ forall k, noether_current x y v d_v L X (along_body k)
      = (2%:R^-1 * rho * speed_squared g (velocity_of v) - rho * W - material_pressure rho W_J * J)
        * root_G * xi k.
Proof.
move=> chain_v L; split=> [|k]; first by apply: time_current => a; exact: (eq_6_4 medium a).1.
rewrite (space_current (Q := material_pressure rho W_J * root_G)) => [|a j].
  rewrite /L /medium_density /density /kinetic /potential; ring_identity.
rewrite (eq_6_4 medium a).2 /space_momentum /energy_slope chain_v.
rewrite (jacobian_in_gradient medium root_g_v) -/areas /material_pressure; ring_identity.
Qed.

(** ** The relabelling current of an incompressible fluid

(9.9): with the density (8.3) and the stored energy put to zero the coefficient of
\f$\sqrt{\det G}\,\xi^k\,d^nx_k\f$ is \f$\frac12\rho\,g_{ab}\dot\phi^a\dot\phi^b - P\f$, off the constraint
too, because \f$P(J - 1) - PJ = -P\f$. *)
Theorem eq_9_9 (P : R) :
    (forall a mu, d_v a mu (multiplier root_G P) = 0) ->
    W = 0 -> (forall a k, d_v a (along_body k) W = 0) ->
  let L := incompressible_density v rho g root_g root_G W P in
  noether_current x y v d_v L X ord0 = momentum_part
  /\ forall k, noether_current x y v d_v L X (along_body k)
      = (2%:R^-1 * rho * speed_squared g (velocity_of v) - P) * root_G * xi k.
Proof.
move=> multiplier_v no_energy no_stress L; split=> [|k].
  by apply: time_current => a; exact: (eq_8_4 medium root_g_v multiplier_v a).1.
rewrite (space_current (Q := P * root_G)) => [|a j].
  rewrite /L /incompressible_density /medium_density /density /kinetic /potential /multiplier no_energy -/J.
  ring_identity.
rewrite (eq_8_4 medium root_g_v multiplier_v a).2 /energy_slope no_stress -/areas; ring_identity.
Qed.

(** The two currents have the momentum in common and differ by \f$(P_\lambda - \rho W - P_WJ)\sqrt{\det
G}\,\xi^k\,d^nx_k\f$, the stored energy of the incompressible fluid being zero. *)
Theorem claim_9_1_currents_differ (P : R) W_g0 k :
    is_medium v d_y d_v D rho root_G g 0 W_g0 ->
    (forall a k, d_v a (along_body k) W = W_J * d_v a (along_body k) J) ->
    (forall a mu, d_v a mu (multiplier root_G P) = 0) ->
  let L := medium_density v rho root_G g W in
  let L_Phi := incompressible_density v rho g root_g root_G 0 P in
  noether_current x y v d_v L X ord0 = noether_current x y v d_v L_Phi X ord0
  /\ noether_current x y v d_v L X (along_body k) - noether_current x y v d_v L_Phi X (along_body k)
     = (P - rho * W - material_pressure rho W_J * J) * root_G * xi k.
Proof.
move=> medium0 chain_v multiplier_v L L_Phi; have [time space] := eq_9_8 chain_v.
have momenta a : momentum d_v L_Phi a ord0 = time_momentum rho root_G g (velocity_of v) a.
  exact: (eq_8_4 medium0 root_g_v multiplier_v a).1.
split; first by rewrite time (time_current momenta).
rewrite space (space_current (Q := P * root_G)) => [|a j]; last first.
  rewrite (eq_8_4 medium0 root_g_v multiplier_v a).2 /energy_slope raddf0 -/areas; ring_identity.
rewrite /L_Phi /incompressible_density /medium_density /density /kinetic /potential /multiplier -/J.
ring_identity.
Qed.

(** ** The two fluids are equivariant, infinitesimally

The rate of equivariance of the barotropic Lagrangian vanishes along the prolongation of every field with
\f$\partial_k(\sqrt{\det G}\,\xi^k) = 0\f$ that does not depend on time: \f$J\f$ stays and
\f$\sqrt{\det G}\,d^{n+1}x\f$ stays. The mass density is constant along the field. *)
Hypothesis prolonged_X : prolonged x y v D X.
Hypothesis steady : forall k, D ord0 (xi k) = 0.
Hypothesis mass_constant : X rho = 0.
Hypothesis volume_kept : X root_G + root_G * (\sum_k D (along_body k) (xi k)) = 0.
Hypothesis metric_constant : forall a b, X (g a b) = 0.

Lemma velocity_constant a : X (velocity_of v a) = 0.
Proof.
rewrite /velocity_of prolonged_X field_part raddf0 sub0r big_ord_recl time_part raddf0 mulr0 add0r.
rewrite big1 ?oppr0 // => k _.
by rewrite -/(along_body k) body_part steady mulr0.
Qed.

Lemma jacobian_constant : X J = 0.
Proof.
have unit_G := volume_is_unit medium.
pose Xi : 'M[R]_n := \matrix_(m, j) D (along_body j) (xi m).
have gradient_rate : derivative_of X F = - (F *m Xi).
  apply/matrixP => a j; rewrite [LHS]mxE (mxE matrix_key) /gradient_of prolonged_X field_part raddf0 sub0r.
  rewrite big_ord_recl time_part raddf0 mulr0 add0r [RHS]mxE [in RHS]mxE; congr (- _); apply: eq_bigr => m _.
  by rewrite -/(along_body m) body_part !mxE.
have metric_rate : derivative_of X g = 0 by apply/matrixP => a b; rewrite !mxE metric_constant.
have root_constant : X root_g = 0.
  have := derivative_of_root X root_of_g unit_g; rewrite metric_rate mulmx0 mxtrace0 mulr0 => twice.
  by rewrite -[LHS]mul1r -(mulVr (two_is_unit medium)) -mulrA twice mulr0.
have divergence : X root_G = - (root_G * \sum_k D (along_body k) (xi k)).
  by apply/eqP; rewrite -addr_eq0 volume_kept.
rewrite /J /jacobian !leibniz derivative_of_inverse // divergence root_constant derivative_of_determinant.
rewrite gradient_rate mulmxN raddfN /= mulmxA mul_adj_mx mul_scalar_mx mxtraceZ.
have -> : \tr Xi = \sum_k D (along_body k) (xi k) by apply: eq_bigr => k _; rewrite mxE.
set s := \sum_k _.
have -> : (- (\det F * s) * root_g + \det F * 0) / root_G
            + \det F * root_g * - (- (root_G * s) / root_G / root_G)
          = \det F * root_g / root_G * s * (root_G / root_G - 1) by ring_identity.
by rewrite divrr // subrr mulr0.
Qed.

Theorem claim_9_1_barotropic_equivariance_rate : X W = W_J * X J ->
  equivariance_rate x D (medium_density v rho root_G g W) X = 0.
Proof.
move=> of_jacobian; rewrite /equivariance_rate /medium_density /density /kinetic /potential.
have no_time : X 2%:R^-1 = 0.
  by rewrite derivative_of_inverse ?(two_is_unit medium) // derivative_of_nat !mul0r oppr0.
have speed : X (speed_squared g (velocity_of v)) = 0.
  rewrite /speed_squared raddf_sum big1 // => a _; rewrite raddf_sum big1 // => b _.
  by rewrite !leibniz metric_constant !velocity_constant !(mul0r, mulr0, addr0).
have divergence : X root_G = - (root_G * \sum_k D (along_body k) (xi k)).
  by apply/eqP; rewrite -addr_eq0 volume_kept.
have -> : \sum_mu D mu (X (x mu)) = \sum_k D (along_body k) (xi k).
  by rewrite big_ord_recl time_part raddf0 add0r; apply: eq_bigr => k _; rewrite -/(along_body k) body_part.
rewrite raddfB /= !leibniz no_time speed mass_constant of_jacobian jacobian_constant divergence.
ring_identity.
Qed.

(** ** The differential of the relabelling current of a barotropic fluid

Off shell it is
\f[ -\sqrt{\det G}\,\xi^k\Bigl(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b\phi^a{}_{,k} +
J\,\frac{\partial P}{\partial x^k}\Bigr)d^{n+1}x , \f]
with the density beside the acceleration, for every such field and every section. *)
Hypothesis along_x : forall mu nu, D nu (x mu) = (mu == nu)%:R.
Hypothesis along_y : forall a mu, D mu (y a) = v a mu.
Hypothesis mixed : forall a mu nu, D mu (v a nu) = D nu (v a mu).

Lemma work_of_field_equations (E acc slope : 'I_n -> R) :
    (forall a, E a = - (root_G * (rho * acc a + \sum_j slope j * areas j a))) ->
  \sum_a E a * (X (y a) - \sum_mu v a mu * X (x mu))
  = root_G * (\sum_k xi k * (rho * (\sum_a acc a * gradient_of v a k) + J * slope k)).
Proof.
move=> field.
have -> : \sum_a E a * (X (y a) - \sum_mu v a mu * X (x mu))
  = root_G * (\sum_k xi k * \sum_a (rho * acc a + \sum_j slope j * areas j a) * gradient_of v a k).
  rewrite mulr_sumr; under [RHS]eq_bigr do rewrite mulr_sumr mulr_sumr.
  rewrite [RHS]exchange_big; apply: eq_bigr => a _; rewrite field displacement mulrNN mulr_sumr.
  by apply: eq_bigr => k _; ring_identity.
congr (_ * _); apply: eq_bigr => k _; congr (_ * _).
have -> : \sum_a (rho * acc a + \sum_j slope j * areas j a) * gradient_of v a k
  = rho * (\sum_a acc a * gradient_of v a k) + \sum_j slope j * (\sum_a areas j a * gradient_of v a k).
  have -> : \sum_j slope j * (\sum_a areas j a * gradient_of v a k)
            = \sum_a (\sum_j slope j * areas j a) * gradient_of v a k.
    under eq_bigr do rewrite mulr_sumr.
    rewrite exchange_big; apply: eq_bigr => a _; rewrite mulr_suml; apply: eq_bigr => j _.
    by rewrite mulrA.
  rewrite mulr_sumr -big_split; apply: eq_bigr => a _ /=; ring_identity.
congr (_ + _); rewrite (bigD1 k) //= areas_of_gradient eqxx mul1r big1 => [|j ne]; last first.
  by rewrite areas_of_gradient (negbTE ne) mul0r mulr0.
by rewrite addr0 mulrC.
Qed.

Theorem claim_9_1_barotropic_current_differential :
    (forall b k, d_v b (along_body k) W = W_J * d_v b (along_body k) J) ->
    (forall b, d_y b W = W_J * d_y b J) -> X W = W_J * X J ->
  let L := medium_density v rho root_G g W in
    chain_rule x y v d_x d_y d_v L X -> (forall mu, chain_rule x y v d_x d_y d_v L (D mu)) ->
  \sum_kappa D kappa (noether_current x y v d_v L X kappa)
  = - (root_G * \sum_k xi k * (rho * (\sum_a (\sum_b g a b * acceleration v d_y D g b) * gradient_of v a k)
                               + J * D (along_body k) (material_pressure rho W_J))).
Proof.
move=> chain_v chain_y chain_X L along_X along_D.
rewrite (thm_9_1_1 along_x along_y mixed prolonged_X along_X along_D).
rewrite claim_9_1_barotropic_equivariance_rate // sub0r.
pose acc a := \sum_b g a b * acceleration v d_y D g b.
pose slope k := D (along_body k) (material_pressure rho W_J).
have field a : euler_lagrange d_y d_v D L a = - (root_G * (rho * acc a + \sum_j slope j * areas j a)).
  by apply: (eq_6_18 medium root_of_g unit_g root_g_v) => // k b i; apply: mixed.
by rewrite (work_of_field_equations field).
Qed.

(** ** The differential of the relabelling current of an incompressible fluid

Off shell, constraint or not, it is
\f[ -\sqrt{\det G}\,\xi^k\Bigl(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b\phi^a{}_{,k} + \frac{\partial
P}{\partial x^k}\Bigr)d^{n+1}x , \f]
without \f$J\f$ and with the density beside the acceleration. The stored energy is zero, and the multiplier
and \f$\sqrt{\det G}\f$ are functions of space-time and of the body, so that \f$X\f$ differentiates them along
\f$\xi\f$. *)
Theorem claim_9_1_incompressible_current_differential (P : R) :
    W = 0 -> (forall a mu, d_v a mu (multiplier root_G P) = 0) ->
    (forall a, d_y a (multiplier root_G P) = 0) ->
    X P = \sum_k xi k * D (along_body k) P ->
  let L := incompressible_density v rho g root_g root_G W P in
    chain_rule x y v d_x d_y d_v L X -> (forall mu, chain_rule x y v d_x d_y d_v L (D mu)) ->
  \sum_kappa D kappa (noether_current x y v d_v L X kappa)
  = - (root_G * \sum_k xi k * (rho * (\sum_a (\sum_b g a b * acceleration v d_y D g b) * gradient_of v a k)
                               + D (along_body k) P)).
Proof.
move=> no_energy multiplier_v multiplier_y along_P L along_X along_D.
pose acc a := \sum_b g a b * acceleration v d_y D g b.
pose slope k := D (along_body k) P.
have divergence : X root_G = - (root_G * \sum_k D (along_body k) (xi k)).
  by apply/eqP; rewrite -addr_eq0 volume_kept.
have base : \sum_mu D mu (X (x mu)) = \sum_k D (along_body k) (xi k).
  by rewrite big_ord_recl time_part raddf0 add0r; apply: eq_bigr => k _; rewrite -/(along_body k) body_part.
have rate : equivariance_rate x D L X = root_G * (\sum_k xi k * slope k) * (J - 1).
  have of_medium : equivariance_rate x D (medium_density v rho root_G g W) X = 0.
    by apply: claim_9_1_barotropic_equivariance_rate; rewrite no_energy jacobian_constant raddf0 mulr0.
  have -> : equivariance_rate x D L X = equivariance_rate x D (medium_density v rho root_G g W) X
      + (X (multiplier root_G P * (J - 1)) + multiplier root_G P * (J - 1) * \sum_mu D mu (X (x mu))).
    by rewrite /equivariance_rate /L /incompressible_density raddfD /= -/J; ring_identity.
  rewrite of_medium add0r base /multiplier !leibniz raddfB /= derivative_of_one jacobian_constant.
  rewrite along_P divergence.
  rewrite /slope; ring_identity.
have field a : euler_lagrange d_y d_v D L a = - (root_G * (rho * acc a + \sum_j slope j * areas j a)).
  apply: (claim_8_3_inhomogeneous_density medium root_of_g unit_g root_g_v multiplier_y multiplier_v) => //.
  - by move=> k b i; apply: mixed.
  - by move=> b k; rewrite /energy_slope no_energy raddf0.
  - by rewrite no_energy raddf0.
rewrite (thm_9_1_1 along_x along_y mixed prolonged_X along_X along_D) rate.
have -> : \sum_a euler_lagrange d_y d_v D L a * (X (y a) - \sum_mu v a mu * X (x mu))
  = root_G * (\sum_k xi k * (rho * (\sum_a acc a * gradient_of v a k) + J * slope k)).
  exact: work_of_field_equations.
rewrite -mulrA -mulrBr -mulrN; congr (_ * _); rewrite mulr_suml -sumrB -sumrN; apply: eq_bigr => k _.
rewrite -/(acc _) -/(slope k); ring_identity.
Qed.

End Currents.

(** The thesis prints the equation that closed currents give back without the density,
\f$g_{ab}(D_g\dot\phi/Dt)^b = -\frac{\partial P}{\partial x^k}\,J\,(F^{-1})^k{}_a\f$. It does not follow from
closed currents where the density, though constant, is not 1: with \f$\rho = 2\f$ on a line, \f$F = 1\f$, the
acceleration 1 and the slope \f$-2\f$ of the pressure. *)
Theorem claim_9_1_barotropic_current_differential_printed_fails :
  ~ (forall n (F : 'M[rat]_n) (root_g root_G rho : rat) (lowered_acceleration slope : 'I_n -> rat),
      0 < root_g -> 0 < root_G -> 0 < rho -> F \in unitmx ->
      (forall xi : 'I_n -> rat,
        root_G * (\sum_k xi k * (rho * (\sum_a lowered_acceleration a * F a k)
                                 + jacobian F root_g root_G * slope k)) = 0) ->
      forall a, lowered_acceleration a = - \sum_k slope k * area_transformation F root_g root_G k a).
Proof.
move=> claim.
have closed (xi : 'I_1 -> rat) : 1 * (\sum_k xi k * (2%:R * (\sum_a 1 * (1%:M : 'M[rat]_1) a k)
    + jacobian (1%:M : 'M[rat]_1) 1 1 * - 2%:R)) = 0.
  by rewrite !big_ord1 mxE /jacobian det1 /= divr1 !mulr1 mul1r subrr mulr0.
have := claim 1%N 1%:M 1 1 2%:R (fun _ => 1) (fun _ => - 2%:R) isT isT isT (unitmx1 _ _) closed 0.
by rewrite big_ord1 /area_transformation adjugate_of_one divr1 scale1r mxE mulr1 opprK => /eqP; vm_compute.
Qed.

(** The corrected equation does follow, and gives closed currents: at a point the current is closed for all
fields \f$\xi\f$ if and only if \f$\rho\,a_aF^a{}_k = -J\,\partial_kP\f$. *)
Theorem claim_9_1_barotropic_current_differential_converse (R : comUnitRingType) n (F : 'M[R]_n)
    (J root_G rho : R) (lowered_acceleration slope : 'I_n -> R) : root_G \is a GRing.unit ->
  (forall xi : 'I_n -> R,
     root_G * (\sum_k xi k * (rho * (\sum_a lowered_acceleration a * F a k) + J * slope k)) = 0)
  <-> (forall k, rho * (\sum_a lowered_acceleration a * F a k) = - (J * slope k)).
Proof.
move=> unit_G; split=> [closed k|equation xi]; last first.
  by rewrite big1 ?mulr0 // => k _; rewrite equation addNr mulr0.
have := closed (fun i => (i == k)%:R).
rewrite (bigD1 k) //= eqxx mul1r [X in _ + X]big1 ?addr0 => [|i ne]; last first.
  by rewrite (negbTE ne) mul0r.
by move/(congr1 ( *%R root_G^-1)); rewrite mulKr // mulr0 => /eqP; rewrite addr_eq0 => /eqP.
Qed.

(** Without \f$J\f$, as section 9.1 prints the equation for the incompressible fluid, and without the density:
the same motion refutes it. *)
Theorem claim_9_1_incompressible_current_differential_printed_fails :
  ~ (forall n (F : 'M[rat]_n) (root_G rho : rat) (lowered_acceleration slope : 'I_n -> rat),
      0 < root_G -> 0 < rho -> F \in unitmx ->
      (forall xi : 'I_n -> rat,
        root_G * (\sum_k xi k * (rho * (\sum_a lowered_acceleration a * F a k) + slope k)) = 0) ->
      forall a, lowered_acceleration a = - \sum_k slope k * invmx F k a).
Proof.
move=> claim.
have closed (xi : 'I_1 -> rat) :
    1 * (\sum_k xi k * (2%:R * (\sum_a 1 * (1%:M : 'M[rat]_1) a k) + - 2%:R)) = 0.
  by rewrite !big_ord1 mxE /= !mulr1 mul1r subrr mulr0.
have := claim 1%N 1%:M 1 2%:R (fun _ => 1) (fun _ => - 2%:R) isT isT (unitmx1 _ _) closed 0.
by rewrite big_ord1 invmx1 mxE mulr1 opprK => /eqP; vm_compute.
Qed.

(** ** The continuity of energy of fluids and solids

Section 9.2: with \f$\mathrm{DIV}\,u = \frac1{\sqrt{\det G}}\partial_j(\sqrt{\det G}\,u^j)\f$ the energy
density of a medium changes along its motions by the power of its stress, \f$\dot e = \sqrt{\det
G}\,\mathrm{DIV}(\mathcal P_a{}^j\dot\phi^a)\f$, and for a barotropic fluid \f$\dot e = -\sqrt{\det
G}\,\mathrm{DIV}\bigl(P\,J\,(F^{-1})^j{}_a\,\dot\phi^a\bigr)\f$. The hypothesis `energy_balance` is what
`claim_9_2_energy_converse` shows of every density that does not depend on time. *)
Section Energies.

Variables (R : comUnitRingType) (n N : nat).
Variables (v : 'I_N -> 'I_n.+1 -> R) (d_y : 'I_N -> derivation R) (d_v : 'I_N -> 'I_n.+1 -> derivation R)
          (D : 'I_n.+1 -> derivation R).
Variables (rho vol W : R) (g W_g : 'M[R]_N).
Hypothesis medium : is_medium v d_y d_v D rho vol g W W_g.

(** \f$\mathrm{DIV}\f$ of a vector field on the body. *)
Definition body_divergence (u : 'I_n -> R) : R := vol^-1 * \sum_j D (along_body j) (vol * u j).

Let L := medium_density v rho vol g W.
Hypothesis balance : energy_balance v d_y d_v D L.
Hypothesis solution : forall a, euler_lagrange d_y d_v D L a = 0.

Theorem claim_9_2_elastic_energy_from_the_balance :
  D ord0 (energy_density v d_v L)
  = vol * body_divergence (fun j => \sum_a first_piola_kirchhoff_stress d_v rho W a j * velocity_of v a).
Proof.
have unit_vol := volume_is_unit medium.
rewrite /body_divergence mulrA mulrV // mul1r.
move: balance; rewrite /energy_balance [X in - X]big1 ?oppr0 => [|a _]; last by rewrite solution mulr0.
move/eqP; rewrite addr_eq0 => /eqP ->; rewrite -sumrN; apply: eq_bigr => j _.
rewrite -raddfN /= -/(along_body j); congr (D _ _); rewrite -sumrN mulr_sumr; apply: eq_bigr => a _.
rewrite (eq_6_4 medium a).2 /space_momentum /first_piola_kirchhoff_stress /velocity_of; ring_identity.
Qed.

End Energies.

Theorem claim_9_2_fluid_energy_from_the_balance (R : comUnitRingType) n (v : 'I_n -> 'I_n.+1 ->
  R) (d_y : 'I_n -> derivation R)
    (d_v : 'I_n -> 'I_n.+1 -> derivation R) (D : 'I_n.+1 -> derivation R) (rho root_g root_G W W_J : R)
    (g W_g : 'M[R]_n) :
    is_medium v d_y d_v D rho root_G g W W_g -> (forall a mu, d_v a mu root_g = 0) ->
    (forall a k, d_v a (along_body k) W
      = W_J * d_v a (along_body k) (jacobian (gradient_matrix v) root_g root_G)) ->
  let L := medium_density v rho root_G g W in
    energy_balance v d_y d_v D L -> (forall a, euler_lagrange d_y d_v D L a = 0) ->
  D ord0 (energy_density v d_v L)
  = - (root_G * body_divergence D root_G
         (fun j => \sum_a material_pressure rho W_J
                          * area_transformation (gradient_matrix v) root_g root_G j a * velocity_of v a)).
Proof.
move=> medium root_g_v chain_v L balance solution.
rewrite (claim_9_2_elastic_energy_from_the_balance medium balance solution) /body_divergence.
rewrite -!mulrN -sumrN; congr (_ * (_ * _)); apply: eq_bigr => j _; rewrite -raddfN /=; congr (D _ _).
rewrite -mulrN -sumrN; congr (_ * _); apply: eq_bigr => a _.
rewrite /first_piola_kirchhoff_stress /energy_slope chain_v (jacobian_in_gradient medium root_g_v).
rewrite /material_pressure; ring_identity.
Qed.
