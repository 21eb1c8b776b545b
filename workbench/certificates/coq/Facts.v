(** Proof machinery: what the suppositions about symbols imply, in the form that Modulo.v takes. *)
From Coq Require Import QArith List Setoid Morphisms Ring Arith Lia.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

Create HintDb facts.
Ltac settle := lazymatch goal with
  | |- Forall _ nil => apply Forall_nil
  | |- Forall _ (Complete _ :: _) => apply Forall_cons; [exact I | settle]
  | |- Forall _ (_ :: _) => apply Forall_cons; [try assumption | settle]
  | |- Forall _ (_ ++ _) => apply Forall_app; split; settle
  | |- Forall _ _ => try solve [eauto with facts nocore]
  end.
(** [under premises shapes slots lhs rhs] leaves the truth of the premises to be shown. *)
Ltac under ps shapes slots lhs rhs :=
  intros; refine (@modulo shapes _ slots eq_refl _ ps _ _ lhs rhs _ _);
  [ repeat constructor | settle | vm_compute; reflexivity ].

Section Equality.
Variable K : diff_ring.
Global Instance equal_Equivalence d k : Equivalence (@equal K d k).
Proof.
  pose proof (same_equiv K) as [R S T].
  split; red; destruct d, k; cbn; unfold all3, dual_same; cbn; intros;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; repeat split; eauto.
Qed.
End Equality.

Local Notation T i := (Var false Tensor i). Local Notation U i := (Var false Vector i). Local Notation S_ i := (Var false Scalar i).
Local Notation DT i := (Var true Tensor i). Local Notation DU i := (Var true Vector i). Local Notation DS i := (Var true Scalar i).
Definition spin {K : diff_ring} (R : tensor K) : vector K := vect (D R ∘ transpose R).
Section Rotations.
Variable K : diff_ring.
Variable R : tensor K.
Hypothesis rot : rotation R.
Let rows : R ∘ transpose R ≡ ident := proj1 rot.
Let unimodular : det R ≡ (num 1 : scalar K) := proj2 rot.

Lemma rotation_adj : adj R ≡ transpose R.
Proof.
  transitivity (adj R ∘ (R ∘ transpose R)); [|transitivity (det R • transpose R)].
  - under [Value 1 (Idt false)] [(false, Tensor); (false, Tensor)] [as_slot false Tensor R; as_slot false Tensor (R ∘ transpose R)]
      (Adj (T 0)) (Prod (Adj (T 0)) (T 1)).
  - under (@nil premise) [(false, Tensor)] [as_slot false Tensor R]
      (Prod (Adj (T 0)) (Prod (T 0) (Transpose (T 0)))) (Scale (Det (T 0)) (Transpose (T 0))).
  - under [@Value false Scalar 1 (Num false 1)] [(false, Tensor); (false, Scalar)] [as_slot false Tensor R; as_slot false Scalar (det R)]
      (Scale (S_ 1) (Transpose (T 0))) (Transpose (T 0)).
Qed.
Lemma rotation_columns : transpose R ∘ R ≡ ident.
Proof.
  transitivity (adj R ∘ R); [|transitivity (det R • (ident : tensor K))].
  - under [@Value false Tensor 1 (Transpose (T 0))] [(false, Tensor); (false, Tensor)] [as_slot false Tensor R; as_slot false Tensor (adj R)]
      (Prod (Transpose (T 0)) (T 0)) (Prod (T 1) (T 0)). exact rotation_adj.
  - under (@nil premise) [(false, Tensor)] [as_slot false Tensor R] (Prod (Adj (T 0)) (T 0)) (Scale (Det (T 0)) (Idt false)).
  - under [@Value false Scalar 1 (Num false 1)] [(false, Tensor); (false, Scalar)] [as_slot false Tensor R; as_slot false Scalar (det R)]
      (Scale (S_ 1) (Idt false)) (Idt false).
Qed.
Lemma skew_of (W : tensor K) : W + transpose W ≡ zero -> skew (vect W) ≡ W.
Proof.
  under [Rule (Plus (T 0) (Transpose (T 0))) (Zer false Tensor)] [(false, Tensor)] [as_slot false Tensor W]
    (Skew (Vect (T 0))) (T 0).
Qed.
Lemma times_columns (W : tensor K) : (W ∘ transpose R) ∘ R ≡ W.
Proof.
  transitivity (W ∘ (transpose R ∘ R)).
  - under (@nil premise) [(false, Tensor); (false, Tensor)] [as_slot false Tensor R; as_slot false Tensor W]
      (Prod (Prod (T 1) (Transpose (T 0))) (T 0)) (Prod (T 1) (Prod (Transpose (T 0)) (T 0))).
  - under [Value 1 (Idt false)] [(false, Tensor); (false, Tensor)] [as_slot false Tensor W; as_slot false Tensor (transpose R ∘ R)]
      (Prod (T 0) (T 1)) (T 0). exact rotation_columns.
Qed.
Lemma factor (X W : tensor K) : X ∘ transpose R ≡ W -> W ∘ R ≡ X.
Proof.
  intros E. transitivity ((X ∘ transpose R) ∘ R); [|apply times_columns].
  under [@Value false Tensor 2 (T 1)] [(false, Tensor); (false, Tensor); (false, Tensor)]
    [as_slot false Tensor R; as_slot false Tensor W; as_slot false Tensor (X ∘ transpose R)] (Prod (T 1) (T 0)) (Prod (T 2) (T 0)).
Qed.
Lemma rotation_rate : D R ≡ skew (spin R) ∘ R.
Proof.
  symmetry. apply factor. symmetry. apply skew_of.
  transitivity (D (R ∘ transpose R)).
  - under (@nil premise) [(false, Tensor)] [as_slot false Tensor R]
      (Plus (Prod (DD (T 0)) (Transpose (T 0))) (Transpose (Prod (DD (T 0)) (Transpose (T 0))))) (DD (Prod (T 0) (Transpose (T 0)))).
  - under [Value 0 (Idt false)] [(false, Tensor)] [as_slot false Tensor (R ∘ transpose R)] (DD (T 0)) (Zer false Tensor).
Qed.
End Rotations.

(** Premises for a rotation R (symbol i) with its angular velocity s = vect(Ṙ Rᵀ) (symbol s). *)
Definition orthogonal (R : tm false Tensor) : list premise :=
  [Rule (Prod R (Transpose R)) (Idt false); Rule (Prod (Transpose R) R) (Idt false); Rule (Adj R) (Transpose R)].
Definition rotation_at (i s : nat) : list premise :=
  Rate i (Prod (Skew (U s)) (T i)) :: orthogonal (T i).
Lemma rotation_at_ok (K : diff_ring) (e : env K) i s : rotation (e false Tensor i) ->
  e false Vector s = spin (e false Tensor i) -> Forall (holds e) (rotation_at i s).
Proof.
  intros R S. repeat apply Forall_cons; try apply Forall_nil; cbn [holds den].
  - rewrite S. exact (rotation_rate R).
  - exact (proj1 R).
  - exact (rotation_columns R).
  - exact (rotation_adj R).
Qed.

(** A dual rotation R̲ (symbol i) is (I + ε ρ̃) R with its real part R and ρ = vect(Du R̲ Rᵀ). *)
Definition shift {K : diff_ring} (R : dual_tensor K) : vector K := vect (dual_part R ∘ transpose (real_part R)).
Lemma dual_rotation_real (K : diff_ring) (R : dual_tensor K) : dual_rotation R -> rotation (real_part R : tensor K).
Proof.
  intros [O N]. destruct R as [[[] [] []] [[] [] []] [[] [] []]]. cbn in O, N. unfold all3, dual_same in O, N.
  split; cbn; unfold all3; cbn in *; tauto.
Qed.
Lemma dual_rotation_shift (K : diff_ring) (R : dual_tensor K) : dual_rotation R ->
  (dual_part R : tensor K) ≡ skew (shift R) ∘ real_part R.
Proof.
  intros H. pose proof (dual_rotation_real H) as rot. symmetry. apply (factor rot). symmetry. apply skew_of.
  transitivity (dual_part (R ∘ transpose R) : tensor K).
  - under (@nil premise) [(true, Tensor)] [as_slot true Tensor R]
      (let W := Prod (Du (DT 0)) (Transpose (Re (DT 0))) in Plus W (Transpose W))
      (Du (Prod (DT 0) (Transpose (DT 0)))).
  - destruct H as [O _]. cbn in *. unfold all3, dual_same in *. cbn in *. tauto.
Qed.
Definition dual_rotation_at (i r s p : nat) : list premise := rotation_at r s ++
  [@Value true Tensor i (Plus (Emb (T r)) (Scale Eps (Emb (Prod (Skew (U p)) (T r)))))].
Lemma dual_rotation_at_ok (K : diff_ring) (e : env K) i r s p : dual_rotation (e true Tensor i) ->
  e false Tensor r = real_part (e true Tensor i) -> e false Vector s = spin (e false Tensor r) ->
  e false Vector p = shift (e true Tensor i) -> Forall (holds e) (dual_rotation_at i r s p).
Proof.
  intros H E S P. apply Forall_app. split.
  - apply rotation_at_ok; [rewrite E; now apply dual_rotation_real | exact S].
  - apply Forall_cons; [|apply Forall_nil]. cbn [holds den]. rewrite P.
    transitivity (embed (e false Tensor r) + @scale (dual_ops K) Tensor eps (embed (dual_part (e true Tensor i) : tensor K)))%kin.
    + rewrite E. under (@nil premise) [(true, Tensor)] [as_slot true Tensor (e true Tensor i)] (DT 0)
        (Plus (Emb (Re (DT 0))) (Scale Eps (Emb (Du (DT 0))))).
    + pose proof (dual_rotation_shift H) as F. rewrite <- E in F.
      under [@Value false Tensor 2 (Prod (Skew (U 1)) (T 0))] [(false, Tensor); (false, Vector); (false, Tensor)]
        [as_slot false Tensor (e false Tensor r); as_slot false Vector (shift (e true Tensor i)); as_slot false Tensor (dual_part (e true Tensor i))]
        (Plus (Emb (T 0)) (Scale Eps (Emb (T 2)))) (Plus (Emb (T 0)) (Scale Eps (Emb (Prod (Skew (U 1)) (T 0))))).
Qed.

(** A unit vector u (symbol i) turns with w = u × u̇ (symbol w). *)
Definition unit_at (i w : nat) : list premise :=
  [Rule (Dot (U i) (U i)) (Num false 1); Rate i (Cross (U w) (U i))].
Section Unit.
Variable K : diff_ring.
Variable u : vector K.
Hypothesis one : unit_vector u.
Lemma unit_rate : D u ≡ (u × D u) × u.
Proof.
  transitivity ((u · u) • D u - (u · D u) • u); [transitivity ((u · u) • D u - half • D (u · u) • u)|].
  - symmetry. under [@Value false Scalar 1 (Num false 1)] [(false, Vector); (false, Scalar)] [as_slot false Vector u; as_slot false Scalar (u · u)]
      (Minus (Scale (S_ 1) (DD (U 0))) (Scale (Scale (Num false (1 # 2)) (DD (S_ 1))) (U 0))) (DD (U 0)).
  - under (@nil premise) [(false, Vector)] [as_slot false Vector u]
      (Minus (Scale (Dot (U 0) (U 0)) (DD (U 0))) (Scale (Scale (Num false (1 # 2)) (DD (Dot (U 0) (U 0)))) (U 0)))
      (Minus (Scale (Dot (U 0) (U 0)) (DD (U 0))) (Scale (Dot (U 0) (DD (U 0))) (U 0))).
  - under (@nil premise) [(false, Vector)] [as_slot false Vector u]
      (Minus (Scale (Dot (U 0) (U 0)) (DD (U 0))) (Scale (Dot (U 0) (DD (U 0))) (U 0)))
      (Cross (Cross (U 0) (DD (U 0))) (U 0)).
Qed.
End Unit.
Lemma unit_at_ok (K : diff_ring) (e : env K) i w : unit_vector (e false Vector i) ->
  e false Vector w = e false Vector i × D (e false Vector i) -> Forall (holds e) (unit_at i w).
Proof.
  intros H W. repeat apply Forall_cons; try apply Forall_nil; cbn [holds den]; [exact H|]. rewrite W. now apply unit_rate.
Qed.
(** A dual unit vector u̲ (symbol i) is u + ε m × u with its real part u (a unit vector) and m = u × Du u̲. *)
Definition dual_unit_at (i u w m : nat) : list premise := unit_at u w ++
  [@Value true Vector i (Plus (Emb (U u)) (Scale Eps (Emb (Cross (U m) (U u)))))].
Definition moment {K : diff_ring} (u : dual_vector K) : vector K := (real_part u : vector K) × (dual_part u : vector K).
Lemma dual_unit_real (K : diff_ring) (u : dual_vector K) : unit_vector (K := K) (d := true) u ->
  unit_vector (real_part u : vector K) /\ (real_part u : vector K) · (dual_part u : vector K) ≡ (num 0 : scalar K).
Proof.
  intros [O N]. split; [exact O|].
  transitivity (half • (dual_part (u · u : dual_scalar K) : scalar K)).
  - under (@nil premise) [(true, Vector)] [as_slot true Vector u] (Dot (Re (DU 0)) (Du (DU 0)))
      (Scale (Num false (1 # 2)) (Du (Dot (DU 0) (DU 0)))).
  - under [@Value false Scalar 0 (Num false 0)] [(false, Scalar)] [as_slot false Scalar (dual_part (u · u : dual_scalar K))]
      (Scale (Num false (1 # 2)) (S_ 0)) (Num false 0).
Qed.
Lemma dual_unit_value (K : diff_ring) (x : dual_vector K) : unit_vector (real_part x : vector K) ->
  (real_part x : vector K) · (dual_part x : vector K) ≡ (num 0 : scalar K) ->
  x ≡ε embed (real_part x : vector K) + @scale (dual_ops K) Vector eps (embed (moment x × (real_part x : vector K))).
Proof.
  intros O N. pose (a := real_part x : vector K). pose (b := dual_part x : vector K).
  transitivity (embed a + @scale (dual_ops K) Vector eps (embed ((a · a) • b - (a · b) • a)))%kin.
  - under [@Value false Scalar 1 (Num false 1); @Value false Scalar 2 (Num false 0)]
      [(true, Vector); (false, Scalar); (false, Scalar)]
      [as_slot true Vector x; as_slot false Scalar (a · a); as_slot false Scalar (a · b)]
      (DU 0) (Plus (Emb (Re (DU 0))) (Scale Eps (Emb (Minus (Scale (S_ 1) (Du (DU 0))) (Scale (S_ 2) (Re (DU 0))))))).
  - under (@nil premise) [(false, Vector); (false, Vector)] [as_slot false Vector a; as_slot false Vector b]
      (Plus (Emb (U 0)) (Scale Eps (Emb (Minus (Scale (Dot (U 0) (U 0)) (U 1)) (Scale (Dot (U 0) (U 1)) (U 0))))))
      (Plus (Emb (U 0)) (Scale Eps (Emb (Cross (Cross (U 0) (U 1)) (U 0))))).
Qed.
Lemma dual_unit_at_ok (K : diff_ring) (e : env K) i u w m : unit_vector (e true Vector i) ->
  e false Vector u = real_part (e true Vector i) -> e false Vector w = e false Vector u × D (e false Vector u) ->
  e false Vector m = moment (e true Vector i) -> Forall (holds e) (dual_unit_at i u w m).
Proof.
  intros H E W M. destruct (dual_unit_real H) as [O N]. apply Forall_app. split.
  - apply unit_at_ok; [now rewrite E | exact W].
  - apply Forall_cons; [|apply Forall_nil]. cbn [holds den]. rewrite M, E. now apply dual_unit_value.
Qed.
(** The same vectors where they are constant. *)
Definition fixed_unit_at (i : nat) : list premise := [Rule (Dot (U i) (U i)) (Num false 1); Rate i (Zer false Vector)].
Lemma fixed_unit_at_ok (K : diff_ring) (e : env K) i : unit_vector (e false Vector i) ->
  constant (e false Vector i) -> Forall (holds e) (fixed_unit_at i).
Proof. intros H C. repeat apply Forall_cons; try apply Forall_nil; assumption. Qed.
Definition fixed_dual_unit_at (i u m : nat) : list premise := fixed_unit_at u ++
  [Rate m (Zer false Vector); @Value true Vector i (Plus (Emb (U u)) (Scale Eps (Emb (Cross (U m) (U u)))))].
Lemma fixed_dual_unit_at_ok (K : diff_ring) (e : env K) i u m : unit_vector (e true Vector i) ->
  constant (e true Vector i) -> e false Vector u = real_part (e true Vector i) ->
  e false Vector m = moment (e true Vector i) -> Forall (holds e) (fixed_dual_unit_at i u m).
Proof.
  intros H C E M. destruct (dual_unit_real H) as [O N]. destruct C as ((C1 & C2) & (C3 & C4) & (C5 & C6)).
  assert (R : D (real_part (e true Vector i) : vector K) ≡ zero) by (repeat split; assumption).
  assert (B : D (dual_part (e true Vector i) : vector K) ≡ zero) by (repeat split; assumption).
  apply Forall_app. split; [apply fixed_unit_at_ok; [now rewrite E | red; now rewrite E]|].
  apply Forall_cons; [|apply Forall_cons; [|apply Forall_nil]]; cbn [holds den]; rewrite M.
  - under [Rate 0 (Zer false Vector); Rate 1 (Zer false Vector)] [(false, Vector); (false, Vector)]
      [as_slot false Vector (real_part (e true Vector i) : vector K); as_slot false Vector (dual_part (e true Vector i) : vector K)]
      (DD (Cross (U 0) (U 1))) (Zer false Vector).
  - rewrite E. apply dual_unit_value; assumption.
Qed.

(** Cosine c and sine s of an angle, which may be any term. *)
Definition turn_at (a : tm false Scalar) (c s : nat) : list premise :=
  [Rate c (Neg (Scale (S_ s) (DD a))); Rate s (Scale (S_ c) (DD a));
   Rule (Plus (Scale (S_ c) (S_ c)) (Scale (S_ s) (S_ s))) (Num false 1)].
Lemma turn_at_ok (K : diff_ring) (e : env K) (a : tm false Scalar) c s :
  turn (den e a) (e false Scalar c) (e false Scalar s) -> Forall (holds e) (turn_at a c s).
Proof. intros (N & C & S). repeat apply Forall_cons; try apply Forall_nil; assumption. Qed.

(** y = 1/x for a term x, given by x y = 1; and n = √q for a term q, given by n² = q with m = 1/n. *)
Definition reciprocal_at (x : tm false Scalar) (y : nat) : list premise :=
  [Rate y (Neg (Scale (Scale (S_ y) (S_ y)) (DD x))); Rule (Scale x (S_ y)) (Num false 1)].
Section Reciprocal.
Variable K : diff_ring.
Lemma reciprocal_rate (x y : scalar K) : x • y ≡ (num 1 : scalar K) -> D y ≡ - ((y • y) • D x).
Proof.
  intros E. transitivity (y • D (x • y) - (y • y) • D x); [transitivity ((x • y) • D y)|].
  - under [@Value false Scalar 1 (Num false 1)] [(false, Scalar); (false, Scalar)] [as_slot false Scalar y; as_slot false Scalar (x • y)]
      (DD (S_ 0)) (Scale (S_ 1) (DD (S_ 0))).
  - under (@nil premise) [(false, Scalar); (false, Scalar)] [as_slot false Scalar x; as_slot false Scalar y]
      (Scale (Scale (S_ 0) (S_ 1)) (DD (S_ 1)))
      (Minus (Scale (S_ 1) (DD (Scale (S_ 0) (S_ 1)))) (Scale (Scale (S_ 1) (S_ 1)) (DD (S_ 0)))).
  - under [@Value false Scalar 2 (Num false 1)] [(false, Scalar); (false, Scalar); (false, Scalar)]
      [as_slot false Scalar x; as_slot false Scalar y; as_slot false Scalar (x • y)]
      (Minus (Scale (S_ 1) (DD (S_ 2))) (Scale (Scale (S_ 1) (S_ 1)) (DD (S_ 0)))) (Neg (Scale (Scale (S_ 1) (S_ 1)) (DD (S_ 0)))).
Qed.
Lemma root_rate (q n m : scalar K) : n • n ≡ q -> n • m ≡ (num 1 : scalar K) -> D n ≡ (half • m) • D q.
Proof.
  intros Q M. transitivity ((half • m) • D (n • n)).
  - under [Rule (Scale (S_ 0) (S_ 1)) (Num false 1)] [(false, Scalar); (false, Scalar)] [as_slot false Scalar n; as_slot false Scalar m]
      (DD (S_ 0)) (Scale (Scale (Num false (1 # 2)) (S_ 1)) (DD (Scale (S_ 0) (S_ 0)))).
  - under [@Value false Scalar 1 (S_ 2)] [(false, Scalar); (false, Scalar); (false, Scalar)]
      [as_slot false Scalar m; as_slot false Scalar (n • n); as_slot false Scalar q]
      (Scale (Scale (Num false (1 # 2)) (S_ 0)) (DD (S_ 1))) (Scale (Scale (Num false (1 # 2)) (S_ 0)) (DD (S_ 2))).
Qed.
End Reciprocal.
Lemma reciprocal_at_ok (K : diff_ring) (e : env K) (x : tm false Scalar) y :
  (den e x : scalar K) • e false Scalar y ≡ (num 1 : scalar K) -> Forall (holds e) (reciprocal_at x y).
Proof. intros H. repeat apply Forall_cons; try apply Forall_nil; [now apply reciprocal_rate | exact H]. Qed.
Definition root_at (q : tm false Scalar) (n m : nat) : list premise :=
  [Rate n (Scale (Scale (Num false (1 # 2)) (S_ m)) (DD q));
   Rate m (Neg (Scale (Scale (S_ m) (S_ m)) (Scale (Scale (Num false (1 # 2)) (S_ m)) (DD q))));
   Rule (Scale (S_ n) (S_ m)) (Num false 1); Rule (Scale (S_ n) (S_ n)) q].
Lemma root_at_ok (K : diff_ring) (e : env K) (q : tm false Scalar) n m :
  e false Scalar n • e false Scalar n ≡ (den e q : scalar K) ->
  e false Scalar n • e false Scalar m ≡ (num 1 : scalar K) -> Forall (holds e) (root_at q n m).
Proof.
  intros Q M. repeat apply Forall_cons; try apply Forall_nil; [now apply root_rate | | exact M | exact Q].
  cbn [holds]. transitivity (- ((e false Scalar m • e false Scalar m) • D (e false Scalar n))); [now apply reciprocal_rate|].
  pose proof (@root_rate K _ _ _ Q M) as F.
  under [@Value false Scalar 1 (Scale (Scale (Num false (1 # 2)) (S_ 0)) (DD (S_ 2)))]
    [(false, Scalar); (false, Scalar); (false, Scalar)]
    [as_slot false Scalar (e false Scalar m); as_slot false Scalar (D (e false Scalar n)); as_slot false Scalar (den e q)]
    (Neg (Scale (Scale (S_ 0) (S_ 0)) (S_ 1))) (Neg (Scale (Scale (S_ 0) (S_ 0)) (Scale (Scale (Num false (1 # 2)) (S_ 0)) (DD (S_ 2))))).
Qed.
#[global] Hint Extern 1 (Forall _ (rotation_at _ _)) => apply rotation_at_ok; [assumption | reflexivity] : facts.
#[global] Hint Extern 1 (Forall _ (dual_rotation_at _ _ _ _)) => apply dual_rotation_at_ok; [assumption | reflexivity ..] : facts.
#[global] Hint Extern 1 (Forall _ (unit_at _ _)) => apply unit_at_ok; [assumption | reflexivity] : facts.
#[global] Hint Extern 1 (Forall _ (dual_unit_at _ _ _ _)) => apply dual_unit_at_ok; [assumption | reflexivity ..] : facts.
#[global] Hint Extern 1 (Forall _ (turn_at _ _ _)) => apply turn_at_ok; assumption : facts.
#[global] Hint Extern 1 (Forall _ (reciprocal_at _ _)) => apply reciprocal_at_ok; assumption : facts.
#[global] Hint Extern 1 (Forall _ (root_at _ _ _)) => apply root_at_ok; assumption : facts.
#[global] Hint Extern 1 (Forall _ (fixed_unit_at _)) => apply fixed_unit_at_ok; assumption : facts.
#[global] Hint Extern 1 (Forall _ (fixed_dual_unit_at _ _ _)) => apply fixed_dual_unit_at_ok; [assumption | assumption | reflexivity ..] : facts.
