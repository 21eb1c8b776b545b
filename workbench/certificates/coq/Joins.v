(** How steps join to one theorem: uniqueness, maps with an inverse, cases, recursions. *)
From Coq Require Import QArith List Setoid Morphisms Ring Arith Lia.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols Facts Orders.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** There is one x with P and, up to ≡, no other. *)
Definition exactly_one {K : diff_ring} {d k} (P : val (rng K d) k -> Prop) : Prop :=
  exists x, P x /\ forall y, P y -> equal y x.
Definition exactly_one_pair {K : diff_ring} {d k d' k'} (P : val (rng K d) k -> val (rng K d') k' -> Prop) : Prop :=
  exists x x', P x x' /\ forall y y', P y y' -> equal y x /\ equal y' x'.

Section Joins.
Variable K : diff_ring.
(** From a witness, and that any two solutions agree. *)
Lemma one_by_witness d k (P : val (rng K d) k -> Prop) x :
  P x -> (forall y z, P y -> P z -> equal y z) -> exactly_one P.
Proof. intros W U. exists x. split; [exact W|]. intros y Y. now apply U. Qed.
Lemma one_pair_by_witness d k d' k' (P : val (rng K d) k -> val (rng K d') k' -> Prop) x x' :
  P x x' -> (forall y y' z z', P y y' -> P z z' -> equal y z /\ equal y' z') -> exactly_one_pair P.
Proof. intros W U. exists x, x'. split; [exact W|]. intros y y' Y. now apply U. Qed.
(** A map that has an inverse takes each value once: both compositions, and that the inverse respects ≡. *)
Lemma one_by_inverse d k d' k' (f : val (rng K d) k -> val (rng K d') k') g :
  (forall y z, equal y z -> equal (g y) (g z)) -> (forall y, equal (f (g y)) y) -> (forall x, equal (g (f x)) x) ->
  forall y, exactly_one (fun x => equal (f x) y).
Proof. intros E FG GF y. exists (g y). split; [apply FG|]. intros x X. rewrite <- (GF x). now apply E. Qed.
(** The solution of A x = b, where B is the inverse of A. *)
Lemma one_solution (A B : tensor K) (b : vector K) : A ∘ B ≡ ident -> B ∘ A ≡ ident ->
  exactly_one (fun x : vector K => A @ x ≡ b) /\ A @ (B @ b) ≡ b.
Proof.
  intros AB BA. assert (W : forall (X Y : tensor K) (u : vector K), X ∘ Y ≡ ident -> X @ (Y @ u) ≡ u).
  { intros X Y u E. transitivity ((X ∘ Y) @ u).
    - under (@nil premise) [(false, Tensor); (false, Tensor); (false, Vector)]
        [as_slot false Tensor X; as_slot false Tensor Y; as_slot false Vector u]
        (Act (Var false Tensor 0) (Act (Var false Tensor 1) (Var false Vector 2)))
        (Act (Prod (Var false Tensor 0) (Var false Tensor 1)) (Var false Vector 2)).
    - under [Value 0 (Idt false)] [(false, Tensor); (false, Vector)] [as_slot false Tensor (X ∘ Y); as_slot false Vector u]
        (Act (Var false Tensor 0) (Var false Vector 1)) (Var false Vector 1). }
  split; [|now apply W]. exists (B @ b). split; [now apply W|]. intros y Y. transitivity (B @ (A @ y)).
  - symmetry. now apply W.
  - under [@Value false Vector 0 (Var false Vector 1)] [(false, Vector); (false, Vector); (false, Tensor)]
      [as_slot false Vector (A @ y); as_slot false Vector b; as_slot false Tensor B]
      (Act (Var false Tensor 2) (Var false Vector 0)) (Act (Var false Tensor 2) (Var false Vector 1)).
Qed.
(** Cases that cover. *)
Lemma by_cases (A B S : Prop) : A \/ B -> (A -> S) -> (B -> S) -> S.
Proof. tauto. Qed.
(** Two sequences with the same beginning and the same recursion agree. *)
Lemma one_sequence d k (s t : nat -> val (rng K d) k) (next : nat -> val (rng K d) k -> val (rng K d) k) m :
  (forall n x y, equal x y -> equal (next n x) (next n y)) -> equal (s m) (t m) ->
  (forall n, (m <= n)%nat -> equal (s (S n)) (next n (s n))) -> (forall n, (m <= n)%nat -> equal (t (S n)) (next n (t n))) ->
  forall n, (m <= n)%nat -> equal (s n) (t n).
Proof. intros E B HS HT. apply from_lowest; [exact B|]. intros n L IH. rewrite (HS n L), (HT n L). now apply E. Qed.
(** A tensor is known by what it does to the three axes, which are constant. *)
Definition axes {O : ops} : three (val O Vector) := ident.
Lemma axes_constant (u : vector K) : u = x1 axes \/ u = x2 axes \/ u = x3 axes -> constant (d := false) u.
Proof. intros [ -> | [ -> | -> ] ]; repeat split; apply dt_num. Qed.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Lemma by_axes (A B : tensor K) : A @ x1 axes ≡ B @ x1 axes -> A @ x2 axes ≡ B @ x2 axes -> A @ x3 axes ≡ B @ x3 axes -> A ≡ B.
Proof.
  destruct A as [[] [] []], B as [[] [] []]. cbn. unfold all3. cbn. intros (A1 & A2 & A3) (B1 & B2 & B3) (C1 & C2 & C3).
  assert (Z : forall a b c x y z : K, same (add (add (mul a (num 1)) (mul b (num 0))) (mul c (num 0)))
    (add (add (mul x (num 1)) (mul y (num 0))) (mul z (num 0))) -> same a x).
  { intros a b c x y z H. transitivity (add (add (mul a (num 1)) (mul b (num 0))) (mul c (num 0))); [ring | rewrite H; ring]. }
  assert (Y : forall a b c x y z : K, same (add (add (mul a (num 0)) (mul b (num 1))) (mul c (num 0)))
    (add (add (mul x (num 0)) (mul y (num 1))) (mul z (num 0))) -> same b y).
  { intros a b c x y z H. transitivity (add (add (mul a (num 0)) (mul b (num 1))) (mul c (num 0))); [ring | rewrite H; ring]. }
  assert (X : forall a b c x y z : K, same (add (add (mul a (num 0)) (mul b (num 0))) (mul c (num 1)))
    (add (add (mul x (num 0)) (mul y (num 0))) (mul z (num 1))) -> same c z).
  { intros a b c x y z H. transitivity (add (add (mul a (num 0)) (mul b (num 0))) (mul c (num 1))); [ring | rewrite H; ring]. }
  repeat split; [eapply Z, A1 | eapply Y, B1 | eapply X, C1 | eapply Z, A2 | eapply Y, B2 | eapply X, C2 | eapply Z, A3
    | eapply Y, B3 | eapply X, C3].
Qed.
End Joins.
