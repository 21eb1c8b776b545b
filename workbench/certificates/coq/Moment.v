(** What holds at one instant of a motion: the definitions are to be read where their words occur, the lemmas join
    the steps of a proof. *)
From Coq Require Import QArith Setoid Morphisms Ring_theory Reals Qreals Lra Ring Classical_Prop.
From Kin Require Import Kin Poly Symbols Smooth Time.
Open Scope Q_scope. Open Scope kin_scope.

(** What agrees in some respect, such as at an instant: a coarser equality that sums and products respect. *)
Record agreement (K : diff_ring) := {
  agree : K -> K -> Prop;
  agree_equiv : Equivalence agree;
  agree_add : Proper (agree ==> agree ==> agree) (@add K);
  agree_mul : Proper (agree ==> agree ==> agree) (@mul K);
  agree_opp : Proper (agree ==> agree) (@opp K);
  agree_same : forall a b, same a b -> agree a b }.
Arguments agree {K}.
Definition equal_in {K : diff_ring} (c : agreement K) {d k} : val (rng K d) k -> val (rng K d) k -> Prop :=
  match d with true => every (dual_same (agree c)) | false => every (agree c) end.

(** With it the same functions are a ring in which nothing changes: what is proved for every K holds there. *)
Section Zero.
Variable K : diff_ring.
Existing Instances same_Equivalence add_Proper mul_Proper opp_Proper dt_Proper num_Proper sub_Proper.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Lemma zero_sum : @same K (num 0) (add (num 0) (num 0)). Proof. ring. Qed.
Lemma zero_product (a b : K) : same (num 0) (add (mul (num 0) b) (mul a (num 0))). Proof. ring. Qed.
Lemma zero_times (a : K) : same (num 0) (mul a (num 0)). Proof. ring. Qed.
Lemma zero_minus (a : K) : same (num 0) (opp (mul a (num 0))). Proof. ring. Qed.
End Zero.
Definition still_ops (O : ops) : ops := {| car := O; num := @num O; add := @add O; mul := @mul O; opp := @opp O; dt _ := num 0 |}.
Definition still {K : diff_ring} (c : agreement K) : diff_ring.
Proof.
  refine {| op := still_ops K; same := agree c; same_equiv := agree_equiv K c; add_ext := agree_add K c;
    mul_ext := agree_mul K c; opp_ext := agree_opp K c |}; pose proof (agree_same K c) as W; cbn.
  - intros a b _. apply (agree_equiv K c).
  - destruct (laws K). split; intros; apply W; solve [auto | exact (Rsub_def _ _)].
  - intros p q E. now apply W, num_ext.
  - intros p q. apply W, num_add.
  - intros p q. apply W, num_mul.
  - intros p. apply W, num_opp.
  - intros p. apply (agree_equiv K c).
  - intros a b. apply W, zero_sum.
  - intros a b. apply W, zero_product.
Defined.
Section Agreement.
Variable K : diff_ring.
Variable c : agreement K.
Ltac parts := repeat match goal with H : _ /\ _ |- _ => destruct H end.
Lemma weaker d k (x y : val (rng K d) k) : equal x y -> equal_in c x y.
Proof. unfold equal_in. destruct d, k; cbn; unfold all3, dual_same; cbn; intros; parts; repeat split; now apply agree_same. Qed.
(** What is supposed of a symbol holds there, too. *)
Lemma rotation_now (x : tensor K) : rotation x -> @rotation (still c) x.
Proof. intros [A B]. exact (conj (weaker false Tensor _ _ A) (weaker false Scalar _ _ B)). Qed.
Lemma dual_rotation_now (x : dual_tensor K) : dual_rotation x -> @dual_rotation (still c) x.
Proof. intros [A B]. exact (conj (weaker true Tensor _ _ A) (weaker true Scalar _ _ B)). Qed.
Lemma unit_vector_now (u : vector K) : @unit_vector K false u -> @unit_vector (still c) false u.
Proof. exact (weaker false Scalar _ _). Qed.
Lemma dual_unit_vector_now (u : dual_vector K) : @unit_vector K true u -> @unit_vector (still c) true u.
Proof. exact (weaker true Scalar _ _). Qed.
Lemma constant_now k (x : val (rng K false) k) : @constant (still c) false k x.
Proof. pose proof (agree_equiv K c). destruct k; cbn; repeat split; reflexivity. Qed.
Lemma dual_constant_now k (x : val (rng K true) k) : @constant (still c) true k x.
Proof. pose proof (agree_equiv K c). destruct k; cbn; repeat split; cbn; reflexivity. Qed.
Lemma turn_now (a d s : scalar K) : @equal (still c) false Scalar (d • d + s • s) (num 1 : scalar K) -> @turn (still c) a d s.
Proof. intros A. repeat split; [exact A | exact (agree_same K c _ _ (zero_minus K s)) | exact (agree_same K c _ _ (zero_times K d))]. Qed.
Lemma turned_now (a d s : scalar K) : turn a d s -> @turn (still c) a d s.
Proof. intros (A & _). apply turn_now. exact (weaker false Scalar _ _ A). Qed.
End Agreement.

Local Notation K := smooth_functions.
Definition instant := R.
Definition alike_at (t : instant) (f g : smooth) : Prop := F f 0 t = F g 0 t.
Definition at_instant (t : instant) : agreement smooth_functions.
Proof.
  refine (@Build_agreement smooth_functions (alike_at t) _ _ _ _ _).
  - split; [intros f | intros f g E | intros f g h E G]; unfold alike_at in *; congruence.
  - intros f f' E g g' G. change (F f 0 t + F g 0 t = F f' 0 t + F g' 0 t)%R. unfold alike_at in *. congruence.
  - intros f f' E g g' G. change (F f 0 t * F g 0 t = F f' 0 t * F g' 0 t)%R. unfold alike_at in *. congruence.
  - intros f f' E. change (- F f 0 t = - F f' 0 t)%R. unfold alike_at in *. congruence.
  - intros f g E. exact (E 0%nat t).
Defined.
Definition equal_at (t : instant) {d k} (x y : val (rng K d) k) : Prop := equal_in (at_instant t) x y.
(** ≥; 1/x, which means something where x is not 0; the length; cosine and sine. All of them are numbers. *)
Definition at_least (t : instant) (x y : scalar K) : Prop := (F (y : smooth) 0 t <= F (x : smooth) 0 t)%R.
Definition over (t : instant) (x : scalar K) : scalar K := const (/ F (x : smooth) 0 t)%R.
Definition length (t : instant) (u : vector K) : scalar K := const (sqrt (F (square u : smooth) 0 t)).
Definition cosine_of (t : instant) (x : scalar K) : scalar K := const (cos (F (x : smooth) 0 t)).
Definition sine_of (t : instant) (x : scalar K) : scalar K := const (sin (F (x : smooth) 0 t)).

Section At.
Variable t : instant.
Ltac parts := repeat match goal with H : _ /\ _ |- _ => destruct H end.
Ltac open d k := destruct d, k; cbn; unfold all3, dual_same, alike_at; cbn.
Lemma always d k (x y : val (rng K d) k) : equal x y -> equal_at t x y.
Proof. unfold equal_at, equal_in. open d k; intros; parts; repeat split; match goal with H : same_fun ?f ?g |- F ?f 0 _ = F ?g 0 _ => exact (H 0%nat t) end. Qed.
Lemma same_at d k (x : val (rng K d) k) : equal_at t x x.
Proof. unfold equal_at, equal_in. open d k; auto 12. Qed.
Lemma back_at d k (x y : val (rng K d) k) : equal_at t x y -> equal_at t y x.
Proof. unfold equal_at, equal_in. open d k; intros; parts; auto 12. Qed.
Lemma then_at d k (x y z : val (rng K d) k) : equal_at t x y -> equal_at t y z -> equal_at t x z.
Proof. unfold equal_at, equal_in. open d k; intros; parts; repeat split; congruence. Qed.
Lemma embedded_at k (x y : val (rng K false) k) : equal_at t x y -> equal_at (d := true) (k := k) t (embed x) (embed y).
Proof. unfold equal_at, equal_in. destruct k; cbn; unfold all3, dual_same, alike_at; cbn; intros; parts; auto 12. Qed.
Lemma or_not d k (x y : val (rng K d) k) : equal_at t x y \/ ~ equal_at t x y.
Proof. apply classic. Qed.

(** Each quantity has a value, which is a constant. *)
Definition frozen (f : smooth) : smooth := const (F f 0 t).
Definition freeze {d k} : val (rng K d) k -> val (rng K d) k :=
  match d with true => each (fun a => Dual (frozen (re a)) (frozen (du a))) | false => each frozen end.
Lemma freeze_at d k (x : val (rng K d) k) : equal_at t (freeze x) x.
Proof. unfold equal_at, equal_in. open d k; auto 12. Qed.
Lemma freeze_constant d k (x : val (rng K d) k) : constant (K := K) (d := d) (k := k) (freeze x).
Proof.
  unfold constant. destruct d, k; cbn; unfold all3, dual_same; cbn; repeat split; apply by_values; intros s; cbn;
    unfold Q2R; cbn; lra.
Qed.
Lemma value d k (x : val (rng K d) k) : exists y, constant (K := K) (d := d) (k := k) y /\ equal_at t y x.
Proof. exists (freeze x). split; [apply freeze_constant | apply freeze_at]. Qed.
Ltac steady := unfold equal_at, equal_in in *; cbn in *; unfold all3, dual_same, alike_at in *; cbn in *; parts; repeat split; apply by_values;
  intros ?; cbn; assumption.
Lemma value_rotation (x : tensor K) : equal_at t (x ∘ transpose x) (ident : tensor K) -> equal_at t (det x) (number 1 : scalar K) ->
  exists y, (constant (K := K) (d := false) y /\ rotation y) /\ equal_at t y x.
Proof.
  intros A B. exists (freeze (d := false) (k := Tensor) x).
  split; [split; [apply freeze_constant|] | apply (freeze_at false Tensor)].
  destruct x as [[] [] []]. split; steady.
Qed.
Lemma value_dual_rotation (x : dual_tensor K) : equal_at (d := true) t (x ∘ transpose x) (ident : dual_tensor K) ->
  equal_at (d := true) t (det x) (number 1 : dual_scalar K) ->
  exists y, (constant (K := K) (d := true) (k := Tensor) y /\ dual_rotation y) /\ equal_at (d := true) (k := Tensor) t y x.
Proof.
  intros A B. exists (freeze (d := true) (k := Tensor) x).
  split; [split; [apply freeze_constant|] | apply (freeze_at true Tensor)].
  destruct x as [[[][][]] [[][][]] [[][][]]]. split; steady.
Qed.
Lemma value_unit (x : vector K) : equal_at t (x · x) (number 1 : scalar K) ->
  exists y, (constant (K := K) (d := false) y /\ unit_vector (K := K) (d := false) y) /\ equal_at t y x.
Proof.
  intros A. exists (freeze (d := false) (k := Vector) x).
  split; [split; [apply freeze_constant|] | apply (freeze_at false Vector)]. destruct x as []. steady.
Qed.

(** What is not 0. *)
Let at_t (f : scalar K) : R := F (f : smooth) 0 t.
Lemma zero_at (x : scalar K) : equal_at t x (zero : scalar K) <-> at_t x = 0%R.
Proof. unfold at_t, equal_at, equal_in. cbn. unfold alike_at. cbn. unfold Q2R; cbn. split; intros; lra. Qed.
Lemma over_is (x : scalar K) : ~ equal_at t x (zero : scalar K) -> @reciprocal (still (at_instant t)) x (over t x).
Proof. rewrite zero_at. intros N. cbn. unfold alike_at, at_t in *. cbn. rewrite Rinv_r by exact N. unfold Q2R; cbn; lra. Qed.
Lemma square_at (u : vector K) : at_t (square u) = (at_t (x1 u) * at_t (x1 u) + at_t (x2 u) * at_t (x2 u) + at_t (x3 u) * at_t (x3 u))%R.
Proof. reflexivity. Qed.
Lemma not_negative (u : vector K) : (0 <= at_t (square u))%R.
Proof.
  rewrite square_at. pose proof (Rle_0_sqr (at_t (x1 u))). pose proof (Rle_0_sqr (at_t (x2 u))). pose proof (Rle_0_sqr (at_t (x3 u))).
  unfold Rsqr in *. lra.
Qed.
Lemma by_length (u : vector K) : equal_at t (square u) (zero : scalar K) -> equal_at t u (zero : vector K).
Proof.
  assert (W : forall a b c : R, (a * a + b * b + c * c = 0)%R -> a = 0%R /\ b = 0%R /\ c = 0%R).
  { intros a b c E. pose proof (Rle_0_sqr a) as A. pose proof (Rle_0_sqr b) as B. pose proof (Rle_0_sqr c) as C.
    unfold Rsqr in *. repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra. }
  rewrite zero_at, square_at. intros E. destruct (W _ _ _ E) as (A & B & C).
  exact (conj (proj2 (zero_at _) A) (conj (proj2 (zero_at _) B) (proj2 (zero_at _) C))).
Qed.
Lemma by_scalar_length (x : scalar K) : equal_at t (spower x 2) (zero : scalar K) -> equal_at t x (zero : scalar K).
Proof. rewrite !zero_at. change (at_t x * at_t x = 0 -> at_t x = 0)%R. intros E. now apply Rsqr_0_uniq. Qed.
Lemma nonzero_scale (x y : scalar K) : ~ equal_at t x (zero : scalar K) -> ~ equal_at t y (zero : scalar K) ->
  ~ equal_at t (x • y) (zero : scalar K).
Proof. rewrite !zero_at. intros A B. now apply Rmult_integral_contrapositive_currified. Qed.
Lemma nonzero_square (u : vector K) : ~ equal_at t u (zero : vector K) -> ~ equal_at t (square u) (zero : scalar K).
Proof. intros N E. now apply N, by_length. Qed.
Lemma nonzero_power (x : scalar K) n : ~ equal_at t x (zero : scalar K) -> ~ equal_at t (spower x n) (zero : scalar K).
Proof.
  intros N. induction n as [|[|n] IH]; [rewrite zero_at; unfold at_t; cbn; unfold Q2R; cbn; lra | exact N|].
  exact (nonzero_scale _ _ N IH).
Qed.
Lemma nonzero_number (q : Q) : ~ (q == 0)%Q -> ~ equal_at t (number q : scalar K) (zero : scalar K).
Proof. rewrite zero_at. intros N E. apply N, eqR_Qeq. unfold at_t in E. cbn in E. rewrite E. unfold Q2R; cbn; lra. Qed.
Lemma length_is (u : vector K) : @equal (still (at_instant t)) false Scalar (length t u • length t u) (square u).
Proof. cbn. unfold alike_at. cbn. apply sqrt_sqrt. exact (not_negative u). Qed.
Lemma nonzero_length (u : vector K) : ~ equal_at t u (zero : vector K) -> ~ equal_at t (length t u) (zero : scalar K).
Proof.
  intros N. rewrite zero_at. change (sqrt (at_t (square u)) <> 0)%R. intros E. apply sqrt_eq_0 in E; [|apply not_negative].
  apply (nonzero_square u N). now rewrite zero_at.
Qed.
Lemma by_square (x y : scalar K) (u : vector K) : equal_at t x (y + square u) -> at_least t x y.
Proof.
  intros E. unfold at_least. unfold equal_at, equal_in in E. cbn in E. unfold alike_at in E. cbn in E. rewrite E. pose proof (not_negative u) as P.
  unfold at_t in P. cbn in P. lra.
Qed.

(** Tensors are equal if they take each vector to the same, vectors if their products with each are equal. *)
Lemma by_products d (u v : val (rng K d) Vector) :
  (forall c, constant (K := K) (d := d) (k := Vector) c -> equal_at t (dot c u) (dot c v)) -> equal_at t u v.
Proof.
  intros H. destruct d.
  - assert (C : forall i, constant (K := K) (d := true) (k := Vector) (axis (O := dual_ops smooth_ops) i)) by
      (intros [|[|i]]; cbn; repeat split; apply by_values; intros; cbn; unfold Q2R; cbn; lra).
    pose proof (H _ (C 0%nat)) as A. pose proof (H _ (C 1%nat)) as B. pose proof (H _ (C 2%nat)) as D'.
    destruct u as [[][][]], v as [[][][]]. cbn in *. unfold equal_at, equal_in, dual_same, all3 in *. cbn in *. unfold dual_same, all3 in *. unfold alike_at in *. cbn in *. unfold Q2R in *; cbn in *. intuition lra.
  - assert (C : forall i, constant (K := K) (d := false) (k := Vector) (axis (O := smooth_ops) i)) by
      (intros [|[|i]]; cbn; repeat split; apply by_values; intros; cbn; unfold Q2R; cbn; lra).
    pose proof (H _ (C 0%nat)) as A. pose proof (H _ (C 1%nat)) as B. pose proof (H _ (C 2%nat)) as D'.
    destruct u, v. cbn in *. unfold equal_at, equal_in in *. cbn in *. unfold all3, alike_at in *. cbn in *. unfold Q2R in *; cbn in *. intuition lra.
Qed.
Lemma by_vectors d (a b : val (rng K d) Tensor) :
  (forall c, constant (K := K) (d := d) (k := Vector) c -> equal_at t (act a c) (act b c)) -> equal_at t a b.
Proof.
  intros H.
  assert (S : forall c u : val (rng K d) Vector, equal_at t (dot c u) (dot u c)).
  { intros. destruct d; cbn; unfold dual_same, alike_at; cbn; repeat split; ring. }
  assert (P : forall i : nat, forall c, constant (K := K) (d := d) (k := Vector) c -> equal_at t (dot c (part a i)) (dot c (part b i))).
  { intros i c C. specialize (H c C). apply (then_at _ _ _ _ _ (S _ _)). refine (then_at _ _ _ _ _ _ (S _ _)).
    destruct d, i as [|[|i]]; cbn in *; unfold all3 in H; tauto. }
  pose proof (by_products d _ _ (P 0%nat)) as A. pose proof (by_products d _ _ (P 1%nat)) as B. pose proof (by_products d _ _ (P 2%nat)) as C.
  destruct d; exact (conj A (conj B C)).
Qed.
End At.
Arguments always t {d k x y}. Arguments same_at t {d k} x. Arguments back_at t {d k x y}. Arguments then_at t {d k x y z}.
Arguments embedded_at t {k x y}. Arguments or_not t {d k} x y. Arguments freeze t {d k} x. Arguments value t {d k} x.
(** That something which is divided by is not 0: by what is supposed not to be 0. *)
Ltac plainly := unfold equal_at, equal_in; cbn; unfold all3, dual_same, alike_at; cbn; repeat split; unfold Q2R; cbn; lra.
Ltac not_zero := first [ assumption | apply nonzero_scale; not_zero | apply nonzero_square; not_zero
  | apply nonzero_power; not_zero | apply nonzero_length; not_zero | apply nonzero_number; intros no; discriminate no
  | match goal with N : ~ equal_at ?t ?v _ |- ~ equal_at ?t ?u _ =>
      intros none; apply N; refine (then_at t (y := u) _ none); clear; plainly end ].
Ltac nonzero := repeat match goal with H : _ /\ _ |- _ => destruct H end; not_zero.
