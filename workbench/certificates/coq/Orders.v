(** Statements for every order n: n-th derivatives, sums over k, binomial coefficients, and what holds of them;
    the definitions are part of the statements, the lemmas are proof machinery. *)
From Coq Require Import QArith List Setoid Morphisms Ring Arith Lia.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols Facts.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** The n-th derivative; the sum of f k over a ≤ k ≤ b (empty if b < a); n over k. *)
Fixpoint Dn {O : ops} {k} (n : nat) (x : val O k) : val O k := match n with 0%nat => x | S m => D (Dn m x) end.
Fixpoint total {O : ops} {k} (n : nat) (f : nat -> val O k) : val O k :=
  match n with 0%nat => zero | S m => total m f + f m end.
Definition sum_of {O : ops} {k} (a b : nat) (f : nat -> val O k) : val O k := total (S b - a) (fun i => f (a + i)%nat).
Fixpoint choose (n k : nat) : nat := match n, k with
  | _, 0%nat => 1%nat | 0%nat, _ => 0%nat | S m, S j => choose m j + choose m k end.
Definition whole {O : ops} (n : nat) : val O Scalar := num (Z.of_nat n # 1).

Lemma hom_same (K : diff_ring) : hom K K (@same K).
Proof.
  split; intros.
  - apply (same_equiv K).
  - now apply (add_ext K).
  - now apply (mul_ext K).
  - now apply (opp_ext K).
  - now apply (dt_ext K).
Qed.

(** Operations respect ≡, so that hypotheses can be rewritten with. *)
Section Respect.
Variable K : diff_ring.
Variable d : bool.
Notation same_ k := (@equal K d k).
Ltac respects lemma := pose proof (fun k => lemma (rng K d) (rng K d) _ (hom_rng d (hom_same K)) k) as H; destruct d;
  repeat intro; apply H; assumption.
Ltac respects_ lemma := pose proof (lemma (rng K d) (rng K d) _ (hom_rng d (hom_same K))) as H; destruct d;
  repeat intro; apply H; assumption.
Global Instance plus_ext k : Proper (same_ k ==> same_ k ==> same_ k) (@plus (rng K d) k). Proof. respects @r_plus. Qed.
Global Instance minus_ext k : Proper (same_ k ==> same_ k ==> same_ k) (@minus (rng K d) k). Proof. respects @r_minus. Qed.
Global Instance neg_ext k : Proper (same_ k ==> same_ k) (@neg (rng K d) k). Proof. respects @r_neg. Qed.
Global Instance scale_ext k : Proper (same_ Scalar ==> same_ k ==> same_ k) (@scale (rng K d) k). Proof. respects @r_scale. Qed.
Global Instance D_ext k : Proper (same_ k ==> same_ k) (@D (rng K d) k). Proof. respects @r_D. Qed.
Global Instance act_ext : Proper (same_ Tensor ==> same_ Vector ==> same_ Vector) (@act (rng K d)). Proof. respects_ @r_act. Qed.
Global Instance prod_ext : Proper (same_ Tensor ==> same_ Tensor ==> same_ Tensor) (@prod (rng K d)). Proof. respects_ @r_prod. Qed.
Global Instance dot_ext : Proper (same_ Vector ==> same_ Vector ==> same_ Scalar) (@dot (rng K d)). Proof. respects_ @r_dot. Qed.
Global Instance cross_ext : Proper (same_ Vector ==> same_ Vector ==> same_ Vector) (@cross (rng K d)). Proof. respects_ @r_cross. Qed.
Global Instance outer_ext : Proper (same_ Vector ==> same_ Vector ==> same_ Tensor) (@outer (rng K d)). Proof. respects_ @r_outer. Qed.
Global Instance skew_ext : Proper (same_ Vector ==> same_ Tensor) (@skew (rng K d)). Proof. respects_ @r_skew. Qed.
Global Instance vect_ext : Proper (same_ Tensor ==> same_ Vector) (@vect (rng K d)). Proof. respects_ @r_vect. Qed.
Global Instance det_ext : Proper (same_ Tensor ==> same_ Scalar) (@det (rng K d)). Proof. respects_ @r_det. Qed.
Global Instance adj_ext : Proper (same_ Tensor ==> same_ Tensor) (@adj (rng K d)). Proof. respects_ @r_adj. Qed.
End Respect.

(** From the lowest order on. *)
Lemma from_lowest (P : nat -> Prop) m : P m -> (forall n, (m <= n)%nat -> P n -> P (S n)) -> forall n, (m <= n)%nat -> P n.
Proof. intros B H n L. induction L; auto. Qed.
(** Sequences by recursion exist, so a theorem about all sequences with a recursion is not empty. *)
Lemma sequence_exists (X : Type) (m : nat) (first : X) (next : nat -> X -> X) :
  exists s : nat -> X, s m = first /\ forall n, (m <= n)%nat -> s (S n) = next n (s n).
Proof.
  exists (fun n => nat_rect (fun _ => X) first (fun i x => next (m + i)%nat x) (n - m)). split.
  - now rewrite Nat.sub_diag.
  - intros n L. rewrite Nat.sub_succ_l by exact L. cbn. now replace (m + (n - m))%nat with n by lia.
Qed.

Section Every.
Variable K : diff_ring.
Variables (d : bool) (k : kind).
Notation X := (val (rng K d) k).
Notation "a == b" := (@equal K d k a b) (at level 70).
Add Ring K_ring : (laws K) (setoid (same_equiv K) (reqe K)).
Ltac pure := destruct d, k; cbn; unfold all3, dual_same, sub; cbn; intros; repeat split;
  first [ring | apply dt_add | apply dt_num].
Lemma plus_assoc (a b c : X) : a + (b + c) == (a + b) + c. Proof. pure. Qed.
Lemma plus_comm (a b : X) : a + b == b + a. Proof. pure. Qed.
Lemma zero_plus (a : X) : zero + a == a. Proof. pure. Qed.
Lemma plus_zero (a : X) : a + zero == a. Proof. pure. Qed.
Lemma D_plus (a b : X) : D (a + b) == D a + D b. Proof. pure. Qed.
Lemma D_zero : D zero == zero. Proof. pure. Qed.
Lemma plus_swap (a b c e : X) : (a + b) + (c + e) == (a + c) + (b + e). Proof. pure. Qed.
Lemma scale_plus (s t : val (rng K d) Scalar) (a : X) : (s + t) • a == s • a + t • a. Proof. pure. Qed.
Lemma one_scale (a : X) : (num 1 : val (rng K d) Scalar) • a == a. Proof. pure. Qed.
Lemma zero_scale (a : X) : (num 0 : val (rng K d) Scalar) • a == zero. Proof. pure. Qed.

Lemma total_ext n (f g : nat -> X) : (forall i, (i < n)%nat -> f i == g i) -> total n f == total n g.
Proof. induction n as [|n IH]; cbn [total]; intros H; [reflexivity|]. now rewrite IH, H by auto. Qed.
Lemma total_shift n (f : nat -> X) : total (S n) f == f 0%nat + total n (fun i => f (S i)).
Proof.
  induction n as [|n IH]; [cbn [total]; now rewrite zero_plus, plus_zero|].
  change (total (S (S n)) f) with (total (S n) f + f (S n)). rewrite IH. cbn [total]. now rewrite plus_assoc.
Qed.
Lemma total_plus n (f g : nat -> X) : total n (fun i => f i + g i) == total n f + total n g.
Proof. induction n as [|n IH]; cbn [total]; [now rewrite zero_plus|]. rewrite IH. apply plus_swap. Qed.
Lemma D_total n (f : nat -> X) : D (total n f) == total n (fun i => D (f i)).
Proof. induction n as [|n IH]; cbn [total]; [apply D_zero|]. now rewrite D_plus, IH. Qed.
Lemma Dn_plus n : forall a b : X, Dn n (a + b) == Dn n a + Dn n b.
Proof. induction n as [|n IH]; intros; cbn [Dn]; [reflexivity|]. now rewrite IH, D_plus. Qed.
Lemma Dn_zero n : Dn n (zero : X) == zero.
Proof. induction n as [|n IH]; cbn [Dn]; [reflexivity|]. rewrite IH. apply D_zero. Qed.
Lemma Dn_total n m (f : nat -> X) : Dn n (total m f) == total m (fun i => Dn n (f i)).
Proof. induction m as [|m IH]; cbn [total]; [apply Dn_zero|]. now rewrite Dn_plus, IH. Qed.
Lemma Dn_ext n (a b : X) : a == b -> Dn n a == Dn n b.
Proof. intros E. induction n; cbn [Dn]; [exact E | now apply D_ext]. Qed.
Lemma Dn_D n (a : X) : Dn n (D a) = Dn (S n) a.
Proof. induction n as [|n IH]; cbn [Dn] in *; [reflexivity | now rewrite IH]. Qed.

(** x₍ₙ₊₁₎ = ẋₙ + gₙ, added up. *)
Theorem unrolled (x g : nat -> X) : (forall n, (1 <= n)%nat -> x (S n) == D (x n) + g n) -> forall n, (2 <= n)%nat ->
  x n == g (n - 1)%nat + Dn (n - 1) (x 1%nat) + sum_of 1 (n - 2) (fun j => Dn j (g (n - j - 1)%nat)).
Proof.
  intros H.
  assert (A : forall m, x (S m) == Dn m (x 1%nat) + total m (fun j => Dn j (g (m - j)%nat))).
  { induction m as [|m IH]; [cbn [total Dn]; now rewrite plus_zero|].
    rewrite H, IH, D_plus, D_total by lia. cbn [Dn]. rewrite total_shift. cbn [Dn].
    replace (S m - 0)%nat with (S m) by lia. rewrite <- plus_assoc. apply plus_ext; [reflexivity | apply plus_comm]. }
  intros n L. destruct n as [|[|m]]; try lia. rewrite A, total_shift. cbn [Dn]. unfold sum_of.
  replace (S (S (S m) - 2) - 1)%nat with m by lia. replace (S (S m) - 1)%nat with (S m) by lia.
  replace (S m - 0)%nat with (S m) by lia. rewrite plus_assoc. apply plus_ext; [apply plus_comm|].
  apply total_ext. intros i I. cbn [plus Nat.add]. replace (S (S m) - S i - 1)%nat with (S m - S i)%nat by lia. reflexivity.
Qed.

Lemma whole_add m n : @equal K d Scalar (whole (m + n)) (whole m + whole n).
Proof.
  unfold whole. assert (E : same (@num K (Z.of_nat (m + n) # 1)) (add (num (Z.of_nat m # 1)) (num (Z.of_nat n # 1)))).
  { etransitivity; [apply num_ext | apply num_add]. unfold Qeq, Qplus. cbn. rewrite Nat2Z.inj_add. ring. }
  destruct d; [|exact E]. split; [exact E|]. cbn. etransitivity; [|apply num_add]. now apply num_ext.
Qed.
(** Leibniz' rule for any F with the derivative of a product: F a b is the product of an a-th and a b-th derivative. *)
Theorem leibniz (F : nat -> nat -> X) : (forall a b, D (F a b) == F (S a) b + F a (S b)) -> forall n a b,
  Dn n (F a b) == sum_of 0 n (fun j => whole (choose n j) • F (a + (n - j))%nat (b + j)%nat).
Proof.
  intros H. unfold sum_of. cbn [Nat.sub Nat.add]. induction n as [|n IH]; intros a b.
  - cbn [Dn total choose]. rewrite zero_plus. unfold whole. cbn [Z.of_nat].
    rewrite !Nat.add_0_r. symmetry. apply one_scale.
  - rewrite <- Dn_D. rewrite (@Dn_ext n _ _ (H a b)), Dn_plus, !IH.
    rewrite (total_shift n), (total_shift (S n)).
    transitivity ((whole (choose n 0) • F (S a + (n - 0))%nat (b + 0)%nat) +
      (total (S n) (fun i => whole (choose n (S i)) • F (a + (n - i))%nat (b + S i)%nat) +
       total (S n) (fun i => whole (choose n i) • F (a + (n - i))%nat (b + S i)%nat))).
    + rewrite <- plus_assoc. apply plus_ext; [reflexivity|]. apply plus_ext.
      * cbn [total]. replace (choose n (S n)) with 0%nat.
        -- transitivity (total n (fun i => whole (choose n (S i)) • F (a + (n - i))%nat (b + S i)%nat) + zero).
           ++ rewrite plus_zero. apply total_ext. intros i I. now replace (S a + (n - S i))%nat with (a + (n - i))%nat by lia.
           ++ apply plus_ext; [reflexivity | symmetry; apply zero_scale].
        -- symmetry. clear. assert (Z : forall p j, (p < j)%nat -> choose p j = 0%nat).
           { induction p as [|m IH]; intros [|j] L; try lia; cbn [choose]; [reflexivity|]. now rewrite !IH by lia. }
           apply Z. lia.
      * apply total_ext. intros i I. now replace (S b + i)%nat with (b + S i)%nat by lia.
    + apply plus_ext.
      * replace (S a + (n - 0))%nat with (a + (S n - 0))%nat by lia. destruct n; reflexivity.
      * rewrite <- total_plus. apply total_ext. intros i I. replace (S n - S i)%nat with (n - i)%nat by lia.
        cbn [choose]. rewrite whole_add, scale_plus. apply plus_comm.
Qed.
End Every.
