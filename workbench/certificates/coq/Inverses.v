(** Inverses of matrices (the first two definitions are to be read together with Kin.v and Forms.v where their words occur). *)
From Coq Require Import QArith Setoid Morphisms Ring Arith Lia Bool.
From Kin Require Import Kin Poly Terms Certify Forms.
Set Implicit Arguments.
Open Scope Q_scope. Open Scope kin_scope.

Definition unit_matrix {O : ops} : @matrix O := fun i j => if Nat.eqb i j then num 1 else num 0.
Definition inverse_matrix {K : diff_ring} (n : nat) (a b : @matrix K) : Prop :=
  matrix_equal n n (mprod n a b) unit_matrix /\ matrix_equal n n (mprod n b a) unit_matrix.

(** An inverse b of a is any y for which a y is the unit matrix: b = b (a y) = (b a) y = y. *)
Section Inverses.
Variable K : diff_ring.
Existing Instances same_Equivalence add_Proper mul_Proper opp_Proper dt_Proper num_Proper sub_Proper.
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Notation "a == b" := (@same K a b) (at level 70).
Lemma sum_next n (f : nat -> K) : sum_to (S n) f == add (sum_to n f) (f n).
Proof. destruct n; cbn; [ring | reflexivity]. Qed.
Lemma sum_same n (f g : nat -> K) : (forall k, (k < n)%nat -> f k == g k) -> sum_to n f == sum_to n g.
Proof. induction n as [|n IH]; intros E; [reflexivity|]. rewrite !sum_next, IH, E; [reflexivity | lia | intros; apply E; lia]. Qed.
Lemma sum_add n (f g : nat -> K) : sum_to n (fun k => add (f k) (g k)) == add (sum_to n f) (sum_to n g).
Proof. induction n as [|n IH]; [cbn; ring|]. rewrite !sum_next, IH. ring. Qed.
Lemma sum_times n (f : nat -> K) c : mul c (sum_to n f) == sum_to n (fun k => mul c (f k)).
Proof. induction n as [|n IH]; [cbn; ring|]. rewrite !sum_next, <- IH. ring. Qed.
Lemma sum_none n (f : nat -> K) : (forall k, (k < n)%nat -> f k == num 0) -> sum_to n f == num 0.
Proof. induction n as [|n IH]; intros E; [reflexivity|]. rewrite sum_next, IH, E; [ring | lia | intros; apply E; lia]. Qed.
Lemma sum_swap m n (f : nat -> nat -> K) : sum_to m (fun i => sum_to n (f i)) == sum_to n (fun j => sum_to m (fun i => f i j)).
Proof.
  induction m as [|m IH].
  - symmetry. now apply sum_none.
  - rewrite sum_next, IH, <- sum_add. apply sum_same. intros k _. now rewrite sum_next.
Qed.
Lemma sum_unit n (f : nat -> K) i : (i < n)%nat -> sum_to n (fun k => mul (unit_matrix (O := K) i k) (f k)) == f i.
Proof.
  unfold unit_matrix. induction n as [|n IH]; intros L; [lia|]. rewrite sum_next. destruct (Nat.eq_dec i n) as [->|N].
  - rewrite sum_none, Nat.eqb_refl; [ring|]. intros k H. replace (Nat.eqb n k) with false by (symmetry; apply Nat.eqb_neq; lia). ring.
  - rewrite IH by lia. apply Nat.eqb_neq in N. rewrite N. ring.
Qed.
Lemma unit_swapped i k : @unit_matrix K i k = unit_matrix k i.
Proof. unfold unit_matrix. now rewrite Nat.eqb_sym. Qed.
Lemma upto_ok n p : upto n p -> forall i, (i < n)%nat -> p i.
Proof.
  induction n as [|[|n] IH]; intros H i L; [lia | now replace i with 0%nat by lia|]. destruct H as [A B].
  destruct (Nat.eq_dec i (S n)) as [->|N]; [exact B | apply IH; [exact A | lia]].
Qed.
Lemma same_inverse n (a b y : @matrix K) : inverse_matrix n a b -> matrix_equal n n (mprod n a y) unit_matrix ->
  forall i j, Nat.ltb i n && Nat.ltb j n = true -> b i j == y i j.
Proof.
  intros [_ BA] AY i j L. apply andb_true_iff in L as [I J]. apply Nat.ltb_lt in I, J.
  assert (A : forall k l, (k < n)%nat -> (l < n)%nat -> sum_to n (fun m => mul (a k m) (y m l)) == unit_matrix k l)
    by (intros k l X Y; exact (@upto_ok n _ (@upto_ok n _ AY k X) l Y)).
  assert (B : forall k l, (k < n)%nat -> (l < n)%nat -> sum_to n (fun m => mul (b k m) (a m l)) == unit_matrix k l)
    by (intros k l X Y; exact (@upto_ok n _ (@upto_ok n _ BA k X) l Y)).
  transitivity (sum_to n (fun k => mul (b i k) (sum_to n (fun m => mul (a k m) (y m j))))).
  - transitivity (sum_to n (fun k => mul (unit_matrix j k) (b i k))); [symmetry; exact (sum_unit (b i) J)|].
    apply sum_same. intros k X. rewrite A by assumption. rewrite (unit_swapped j k). ring.
  - transitivity (sum_to n (fun m => mul (sum_to n (fun k => mul (b i k) (a k m))) (y m j))).
    + transitivity (sum_to n (fun k => sum_to n (fun m => mul (mul (b i k) (a k m)) (y m j)))).
      * apply sum_same. intros k X. rewrite sum_times. apply sum_same. intros m _. ring.
      * rewrite sum_swap. apply sum_same. intros m _.
        transitivity (mul (y m j) (sum_to n (fun k => mul (b i k) (a k m)))); [|ring]. rewrite sum_times. apply sum_same. intros k _. ring.
    + transitivity (sum_to n (fun m => mul (unit_matrix i m) (y m j))); [|exact (sum_unit (fun m => y m j) I)].
      apply sum_same. intros m X. now rewrite B.
Qed.
End Inverses.
Arguments same_inverse {K n a b y}.
