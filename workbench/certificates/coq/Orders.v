(** Statements for every order n: sums over k, binomial coefficients, and what holds of them;
    the definitions are part of the statements, the lemmas are proof machinery. *)
From Coq Require Import QArith List Setoid Morphisms Ring Arith Lia.
From Kin Require Import Kin Poly Divide Terms Certify Modulo Symbols Facts.
Set Implicit Arguments.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.

(** n + m and n - m; the sum of n values, f a and those that follow it, and that of f k over a ≤ k ≤ b (empty if
    b < a); n over k. *)
Notation nat_plus := Nat.add (only parsing).
Notation nat_minus := Nat.sub (only parsing).
Fixpoint total {O : ops} {k} (n : nat) (f : nat -> val O k) : val O k :=
  match n with 0%nat => zero | S m => total m f + f m end.
Definition sum_from {O : ops} {k} (a n : nat) (f : nat -> val O k) : val O k := total n (fun i => f (a + i)%nat).
Definition sum_of {O : ops} {k} (a b : nat) (f : nat -> val O k) : val O k := sum_from a (S b - a) f.
Fixpoint choose (n k : nat) : nat := match n, k with
  | _, 0%nat => 1%nat | 0%nat, _ => 0%nat | S m, S j => choose m j + choose m k end.
Definition whole {O : ops} (n : nat) : val O Scalar := num (Z.of_nat n # 1).

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
Lemma D_neg (a : X) : D (- a) == - D a.
Proof.
  assert (E : forall x : K, same (dt (opp x)) (opp (dt x))).
  { intros x. transitivity (add (dt (opp x)) (add (dt x) (opp (dt x)))); [ring|].
    transitivity (add (dt (add (opp x) x)) (opp (dt x))); [rewrite dt_add; ring|].
    assert (Z : same (add (opp x) x) (num 0)) by ring. rewrite (dt_ext K _ _ Z), dt_num. ring. }
  destruct d, k; cbn; unfold all3, dual_same; cbn; repeat split; apply E.
Qed.
Lemma minus_is (a b : X) : a - b == a + - b. Proof. destruct d, k; reflexivity. Qed.
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
Lemma der_plus n : forall a b : X, der n (a + b) == der n a + der n b.
Proof. induction n as [|n IH]; intros; cbn [der]; [reflexivity|]. now rewrite IH, D_plus. Qed.
Lemma der_zero n : der n (zero : X) == zero.
Proof. induction n as [|n IH]; cbn [der]; [reflexivity|]. rewrite IH. apply D_zero. Qed.
Lemma der_total n m (f : nat -> X) : der n (total m f) == total m (fun i => der n (f i)).
Proof. induction m as [|m IH]; cbn [total]; [apply der_zero|]. now rewrite der_plus, IH. Qed.
Lemma der_ext n (a b : X) : a == b -> der n a == der n b.
Proof. intros E. induction n; cbn [der]; [exact E | now apply D_ext]. Qed.
Lemma der_nothing n (a : X) : a == zero -> der n a == zero.
Proof. intros E. rewrite (@der_ext n _ _ E). apply der_zero. Qed.
Lemma der_D n (a : X) : der n (D a) = der (S n) a.
Proof. induction n as [|n IH]; cbn [der] in *; [reflexivity | now rewrite IH]. Qed.
Lemma der_der n m (a : X) : der n (der m a) = der m (der n a).
Proof. induction m as [|m IH]; cbn [der]; [reflexivity|]. rewrite der_D. cbn [der]. now rewrite IH. Qed.
Lemma every_der n m (a : X) : der n (der m a) == der m (der n a).
Proof. now rewrite der_der. Qed.
Lemma der_neg n : forall a : X, der n (- a) == - der n a.
Proof. induction n as [|n IH]; intros; cbn [der]; [reflexivity|]. rewrite IH. apply D_neg. Qed.
Lemma der_minus n (a b : X) : der n (a - b) == der n a - der n b.
Proof. rewrite (@der_ext n _ _ (minus_is a b)), der_plus, der_neg. symmetry. apply minus_is. Qed.
(** A map that the derivative passes. *)
Lemma der_through d' k' (f : val (rng K d') k' -> X) n (a : val (rng K d') k') :
  (forall x y, equal x y -> f x == f y) -> (forall x, D (f x) == f (D x)) -> der n (f a) == f (der n a).
Proof. intros E H. induction n as [|n IH]; cbn [der]; [reflexivity|]. rewrite IH. apply H. Qed.
Lemma D_whole n : @equal K d Scalar (D (whole n)) (num 0).
Proof. unfold whole. destruct d; cbn; unfold dual_same; cbn; repeat split; apply dt_num. Qed.

(** Sums that go over alike values, or further at an end. *)
Lemma like n a b (f g : nat -> X) : (forall i, (i < n)%nat -> f (a + i)%nat == g (b + i)%nat) -> sum_from a n f == sum_from b n g.
Proof. apply total_ext. Qed.
Lemma first_of a n (f : nat -> X) x y : f a == x -> sum_from (S a) n f == y -> sum_from a (S n) f == x + y.
Proof.
  intros A B. unfold sum_from. rewrite total_shift. apply plus_ext; [now rewrite Nat.add_0_r|].
  rewrite <- B. apply total_ext. intros i _. now rewrite Nat.add_succ_r.
Qed.
Lemma last_of a n (f : nat -> X) x y : f (a + n)%nat == x -> sum_from a n f == y -> sum_from a (S n) f == y + x.
Proof. intros A B. now apply plus_ext. Qed.
Lemma D_sum a n (f g : nat -> X) : (forall i, (i < n)%nat -> D (f (a + i)%nat) == g (a + i)%nat) -> D (sum_from a n f) == sum_from a n g.
Proof. intros H. unfold sum_from. rewrite D_total. now apply total_ext. Qed.
Lemma der_sum m a n (f : nat -> X) : der m (sum_from a n f) == sum_from a n (fun i => der m (f i)).
Proof. apply der_total. Qed.

(** x₍ₙ₊₁₎ = ẋₙ + gₙ, added up. *)
Theorem unrolled (x g : nat -> X) : (forall n, (1 <= n)%nat -> x (S n) == D (x n) + g n) -> forall n, (2 <= n)%nat ->
  x n == g (n - 1)%nat + der (n - 1) (x 1%nat) + sum_of 1 (n - 2) (fun j => der j (g (n - j - 1)%nat)).
Proof.
  intros H.
  assert (A : forall m, x (S m) == der m (x 1%nat) + total m (fun j => der j (g (m - j)%nat))).
  { induction m as [|m IH]; [cbn [total der]; now rewrite plus_zero|].
    rewrite H, IH, D_plus, D_total by lia. cbn [der]. rewrite total_shift. cbn [der].
    replace (S m - 0)%nat with (S m) by lia. rewrite <- plus_assoc. apply plus_ext; [reflexivity | apply plus_comm]. }
  intros n L. destruct n as [|[|m]]; try lia. rewrite A, total_shift. cbn [der]. unfold sum_of, sum_from.
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
  der n (F a b) == sum_of 0 n (fun j => whole (choose n j) • F (a + (n - j))%nat (b + j)%nat).
Proof.
  intros H. unfold sum_of, sum_from. cbn [Nat.sub Nat.add]. induction n as [|n IH]; intros a b.
  - cbn [der total choose]. rewrite zero_plus. unfold whole. cbn [Z.of_nat].
    rewrite !Nat.add_0_r. symmetry. apply one_scale.
  - rewrite <- der_D. rewrite (@der_ext n _ _ (H a b)), der_plus, !IH.
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

(** Leibniz' rule for each product, and what the derivative passes. *)
Section Products.
Variable K : diff_ring.
Ltac binary ps x y l r := intros d; destruct d; intros u v;
  [ under (ps true) [(true, x); (true, y)] [as_slot true x u; as_slot true y v] (l true) (r true)
  | under (ps false) [(false, x); (false, y)] [as_slot false x u; as_slot false y v] (l false) (r false) ].
Ltac unary x l r := intros d; destruct d; intros u;
  [ under (@nil premise) [(true, x)] [as_slot true x u] (l true) (r true)
  | under (@nil premise) [(false, x)] [as_slot false x u] (l false) (r false) ].
Ltac product x y op := binary (fun c : bool => @nil premise) x y
  (fun c => DD (op c (Var c x 0) (Var c y 1)))
  (fun c => Plus (op c (DD (Var c x 0)) (Var c y 1)) (op c (Var c x 0) (DD (Var c y 1)))).
Notation "a == b" := (@equal K _ _ a b) (at level 70).
Notation S_ d := (val (rng K d) Scalar). Notation V_ d := (val (rng K d) Vector). Notation T_ d := (val (rng K d) Tensor).
Lemma D_scale_s : forall d (u v : S_ d), D (u • v : S_ d) == (D u : S_ d) • v + u • D v. Proof. product Scalar Scalar (fun c => @Scale c Scalar). Qed.
Lemma D_scale_v : forall d (u : S_ d) (v : V_ d), D (u • v) == (D u : S_ d) • v + u • D v. Proof. product Scalar Vector (fun c => @Scale c Vector). Qed.
Lemma D_scale_t : forall d (u : S_ d) (v : T_ d), D (u • v) == (D u : S_ d) • v + u • D v. Proof. product Scalar Tensor (fun c => @Scale c Tensor). Qed.
Lemma D_act : forall d (u : T_ d) (v : V_ d), D (u @ v) == D u @ v + u @ D v. Proof. product Tensor Vector Act. Qed.
Lemma D_prod : forall d (u v : T_ d), D (u ∘ v) == D u ∘ v + u ∘ D v. Proof. product Tensor Tensor Prod. Qed.
Lemma D_dot : forall d (u v : V_ d), (D (u · v) : S_ d) == (D u · v) + (u · D v). Proof. product Vector Vector Dot. Qed.
Lemma D_cross : forall d (u v : V_ d), D (u × v) == D u × v + u × D v. Proof. product Vector Vector Cross. Qed.
Lemma D_outer : forall d (u v : V_ d), D (u ⊗ v) == D u ⊗ v + u ⊗ D v. Proof. product Vector Vector Outer. Qed.
Lemma leibniz_scale_s d n (u v : S_ d) : (der n (u • v : S_ d) : S_ d) == sum_from 0 (S n) (fun j => whole (choose n j) • ((der (n - j) u : S_ d) • der j v)).
Proof. exact (@leibniz K d Scalar (fun a b => (der a u : S_ d) • der b v) (fun a b => D_scale_s d _ _) n 0 0). Qed.
Lemma leibniz_scale_v d n (u : S_ d) (v : V_ d) : der n (u • v) == sum_from 0 (S n) (fun j => whole (choose n j) • ((der (n - j) u : S_ d) • der j v)).
Proof. exact (@leibniz K d Vector (fun a b => (der a u : S_ d) • der b v) (fun a b => D_scale_v d _ _) n 0 0). Qed.
Lemma leibniz_scale_t d n (u : S_ d) (v : T_ d) : der n (u • v) == sum_from 0 (S n) (fun j => whole (choose n j) • ((der (n - j) u : S_ d) • der j v)).
Proof. exact (@leibniz K d Tensor (fun a b => (der a u : S_ d) • der b v) (fun a b => D_scale_t d _ _) n 0 0). Qed.
Lemma leibniz_act d n (u : T_ d) (v : V_ d) : der n (u @ v) == sum_from 0 (S n) (fun j => whole (choose n j) • (der (n - j) u @ der j v)).
Proof. exact (@leibniz K d Vector (fun a b => der a u @ der b v) (fun a b => D_act d _ _) n 0 0). Qed.
Lemma leibniz_prod d n (u v : T_ d) : der n (u ∘ v) == sum_from 0 (S n) (fun j => whole (choose n j) • (der (n - j) u ∘ der j v)).
Proof. exact (@leibniz K d Tensor (fun a b => der a u ∘ der b v) (fun a b => D_prod d _ _) n 0 0). Qed.
Lemma leibniz_dot d n (u v : V_ d) : (der n (u · v : S_ d) : S_ d) == sum_from 0 (S n) (fun j => whole (choose n j) • (der (n - j) u · der j v)).
Proof. exact (@leibniz K d Scalar (fun a b => der a u · der b v) (fun a b => D_dot d _ _) n 0 0). Qed.
Lemma leibniz_cross d n (u v : V_ d) : der n (u × v) == sum_from 0 (S n) (fun j => whole (choose n j) • (der (n - j) u × der j v)).
Proof. exact (@leibniz K d Vector (fun a b => der a u × der b v) (fun a b => D_cross d _ _) n 0 0). Qed.
Lemma leibniz_outer d n (u v : V_ d) : der n (u ⊗ v) == sum_from 0 (S n) (fun j => whole (choose n j) • (der (n - j) u ⊗ der j v)).
Proof. exact (@leibniz K d Tensor (fun a b => der a u ⊗ der b v) (fun a b => D_outer d _ _) n 0 0). Qed.
(** Linear maps are passed. *)
Lemma der_skew d n (u : V_ d) : der n (skew u : T_ d) == skew (der n u).
Proof.
  apply (@der_through K d Tensor d Vector (@skew (rng K d))); [intros x y E; now rewrite E|]. revert d n u.
  intros d _ _. revert d. unary Vector (fun c => DD (Skew (Var c Vector 0))) (fun c => Skew (DD (Var c Vector 0))).
Qed.
Lemma der_vect d n (u : T_ d) : der n (vect u : V_ d) == vect (der n u).
Proof.
  apply (@der_through K d Vector d Tensor (@vect (rng K d))); [intros x y E; now rewrite E|]. revert d n u.
  intros d _ _. revert d. unary Tensor (fun c => DD (Vect (Var c Tensor 0))) (fun c => Vect (DD (Var c Tensor 0))).
Qed.
(** A right factor that does not change is passed. *)
Lemma still_act d n (u : T_ d) (v : V_ d) : equal (D v) zero -> der n (u @ v) == der n u @ v.
Proof.
  intros H. apply (@der_through K d Vector d Tensor (fun u : T_ d => u @ v)); [intros x y E; now rewrite E|].
  intros x. rewrite D_act, H. revert x v H. destruct d; intros x v _;
    [ under (@nil premise) [(true, Tensor); (true, Vector)] [as_slot true Tensor x; as_slot true Vector v]
        (Plus (Act (DD (Var true Tensor 0)) (Var true Vector 1)) (Act (Var true Tensor 0) (Zer true Vector))) (Act (DD (Var true Tensor 0)) (Var true Vector 1))
    | under (@nil premise) [(false, Tensor); (false, Vector)] [as_slot false Tensor x; as_slot false Vector v]
        (Plus (Act (DD (Var false Tensor 0)) (Var false Vector 1)) (Act (Var false Tensor 0) (Zer false Vector))) (Act (DD (Var false Tensor 0)) (Var false Vector 1)) ].
Qed.
End Products.

(** The same up to how indices are written. *)
Ltac indices := intros; cbn [Nat.add der];
  match goal with |- equal ?x ?y => replace x with y; [reflexivity|] end;
  first [reflexivity | repeat match goal with x := _ |- _ => subst x end; cbv beta; repeat first [reflexivity | lia | f_equal]].
Ltac linear := repeat first [rewrite der_plus | rewrite der_minus | rewrite der_neg]; reflexivity.
