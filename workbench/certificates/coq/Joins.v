(** How steps join to one theorem: uniqueness, recursions, axes. *)
From Coq Require Import QArith List Setoid Morphisms Ring Arith Lia.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols Facts Orders.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** There is one pair x, x' with P and, up to ≡, no other. *)
Definition exactly_one_pair {K : diff_ring} {d k d' k'} (P : val (rng K d) k -> val (rng K d') k' -> Prop) : Prop :=
  exists x x', P x x' /\ forall y y', P y y' -> equal y x /\ equal y' x'.

Section Joins.
Variable K : diff_ring.
(** From a witness, and that any two solutions agree. *)
Lemma one_pair_by_witness d k d' k' (P : val (rng K d) k -> val (rng K d') k' -> Prop) x x' :
  P x x' -> (forall y y' z z', P y y' -> P z z' -> equal y z /\ equal y' z') -> exactly_one_pair P.
Proof. intros W U. exists x, x'. split; [exact W|]. intros y y' Y. now apply U. Qed.
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
