(** Proof machinery: terms of the claim language, their value over any operations, and that related
    operations give related values. *)
From Coq Require Import QArith List Bool Setoid Morphisms Ring Ring_theory BinPos.
From Coq.micromega Require Import EnvRing Env.
From Kin Require Import Kin Poly.
Set Implicit Arguments.

Inductive tm : bool -> kind -> Type :=
| Var d k (i : nat) : tm d k
| Num d (q : Q) : tm d Scalar
| Zer d k : tm d k
| Idt d : tm d Tensor
| Eps : tm true Scalar
| Plus d k (a b : tm d k) : tm d k
| Minus d k (a b : tm d k) : tm d k
| Neg d k (a : tm d k) : tm d k
| Scale d k (s : tm d Scalar) (a : tm d k) : tm d k
| Act d (a : tm d Tensor) (u : tm d Vector) : tm d Vector
| Prod d (a b : tm d Tensor) : tm d Tensor
| Dot d (u v : tm d Vector) : tm d Scalar
| Cross d (u v : tm d Vector) : tm d Vector
| Outer d (u v : tm d Vector) : tm d Tensor
| Skew d (u : tm d Vector) : tm d Tensor
| Vect d (a : tm d Tensor) : tm d Vector
| Sym d (a : tm d Tensor) : tm d Tensor
| Anti d (a : tm d Tensor) : tm d Tensor
| Axis d (i : nat) : tm d Vector
| Comp d (i : nat) (u : tm d Vector) : tm d Scalar
| Triad d (a b c : tm d Scalar) : tm d Vector
| Row d (i : nat) (a : tm d Tensor) : tm d Vector
| Transpose d (a : tm d Tensor) : tm d Tensor
| Adj d (a : tm d Tensor) : tm d Tensor
| Det d (a : tm d Tensor) : tm d Scalar
| Trace d (a : tm d Tensor) : tm d Scalar
| Triple d (u v w : tm d Vector) : tm d Scalar
| DD d k (a : tm d k) : tm d k
| Re k (a : tm true k) : tm false k
| Du k (a : tm true k) : tm false k
| Emb k (a : tm false k) : tm true k
| Let d k d' k' (i : nat) (a : tm d k) (b : tm d' k') : tm d' k'.

Definition env (O : ops) := forall d k, nat -> val (rng O d) k.
Definition kind_dec (a b : kind) : {a = b} + {a <> b}. Proof. decide equality. Defined.
Definition upd {O} (e : env O) d k i (v : val (rng O d) k) : env O := fun d' k' j =>
  match Bool.bool_dec d d', kind_dec k k' with
  | left p, left q => if Nat.eqb i j
      then eq_rect d (fun d => val (rng O d) k') (eq_rect k (fun k => val (rng O d) k) v k' q) d' p
      else e d' k' j
  | _, _ => e d' k' j end.

Fixpoint den {O : ops} (e : env O) {d k} (t : tm d k) : val (rng O d) k :=
  match t with
  | Var d k i => e d k i
  | Num d q => num q
  | Zer d k => zero
  | Idt d => ident
  | Eps => eps
  | Plus a b => plus (den e a) (den e b)
  | Minus a b => minus (den e a) (den e b)
  | Neg a => neg (den e a)
  | Scale s a => scale (den e s) (den e a)
  | Act a u => act (den e a) (den e u)
  | Prod a b => prod (den e a) (den e b)
  | Dot a b => dot (den e a) (den e b)
  | Cross a b => cross (den e a) (den e b)
  | Outer a b => outer (den e a) (den e b)
  | Skew a => skew (den e a)
  | Vect a => vect (den e a)
  | Sym a => sym (den e a)
  | Anti a => anti (den e a)
  | Axis d i => axis i
  | Triad a b c => V (den e a) (den e b) (den e c)
  | Comp i u => part (den e u) i
  | Row i a => part (den e a) i
  | Transpose a => transpose (den e a)
  | Adj a => adj (den e a)
  | Det a => det (den e a)
  | Trace a => trace (den e a)
  | Triple a b c => triple (den e a) (den e b) (den e c)
  | DD a => D (den e a)
  | Re a => real_part (den e a)
  | Du a => dual_part (den e a)
  | Emb a => embed (den e a)
  | Let i a b => den (upd e _ _ i (den e a)) b
  end.

(** Operations that a relation respects are respected by everything that is made of them. *)
Record hom (A B : ops) (R : A -> B -> Prop) : Prop := {
  h_num : forall q, R (num q) (num q);
  h_add : forall a b x y, R a x -> R b y -> R (add a b) (add x y);
  h_mul : forall a b x y, R a x -> R b y -> R (mul a b) (mul x y);
  h_opp : forall a x, R a x -> R (opp a) (opp x);
  h_dt : forall a x, R a x -> R (dt a) (dt x) }.
Definition drel {A B : ops} (R : A -> B -> Prop) d : rng A d -> rng B d -> Prop :=
  match d with true => dual_same R | false => R end.
Lemma hom_dual A B R : hom A B R -> hom (dual_ops A) (dual_ops B) (dual_same R).
Proof.
  intros [N P M O T]. split; cbn; intros; repeat match goal with H : dual_same _ _ _ |- _ => destruct H end;
    split; cbn; auto.
Qed.
Lemma hom_same (K : diff_ring) : hom K K same.
Proof. split; intros; [apply (same_equiv K) | now apply (add_ext K) | now apply (mul_ext K) | now apply (opp_ext K) | now apply (dt_ext K)]. Qed.
Lemma hom_rng A B R d : hom A B R -> hom (rng A d) (rng B d) (drel R d).
Proof. destruct d; [apply hom_dual | auto]. Qed.

Section Homomorphism.
Variables (A B : ops) (R : A -> B -> Prop).
Hypothesis H : hom A B R.
Ltac split3 := repeat match goal with
  | x : three _ |- _ => destruct x | h : all3 _ _ _ |- _ => destruct h as (?&?&?)
  | h : every _ ?a ?b |- _ => progress cbn in h end.
Ltac done3 := cbn in *; unfold all3, sub in *; cbn in *; intuition;
  repeat first [apply (h_add H) | apply (h_mul H) | apply (h_opp H) | apply (h_dt H) | apply (h_num H) | assumption].
Ltac crush := intros; split3; unfold plus, minus, neg, scale, D, zero, sum, dot, cross, skew, ident, transpose, act,
  prod, outer, trace, triple, det, adj, sym, anti, vect, half in *; cbn in *;
  repeat match goal with k : kind |- _ => destruct k end; cbn in *; unfold all3 in *; cbn in *; done3.
Notation rel := (every R).
Lemma r_plus k (a b : val A k) x y : rel a x -> rel b y -> rel (plus a b) (plus x y).
Proof. destruct k; crush. Qed.
Lemma r_minus k (a b : val A k) x y : rel a x -> rel b y -> rel (minus a b) (minus x y).
Proof. destruct k; crush. Qed.
Lemma r_neg k (a : val A k) x : rel a x -> rel (neg a) (neg x).
Proof. destruct k; crush. Qed.
Lemma r_scale k s t (a : val A k) x : R s t -> rel a x -> rel (scale s a) (scale t x).
Proof. destruct k; crush. Qed.
Lemma r_D k (a : val A k) x : rel a x -> rel (D a) (D x).
Proof. destruct k; crush. Qed.
Lemma r_zero k : @every A B R k zero zero.
Proof. destruct k; crush. Qed.
Lemma r_ident : @every A B R Tensor ident ident.
Proof. crush. Qed.
Notation rV := (@every A B R Vector). Notation rT := (@every A B R Tensor). Notation rS := (@every A B R Scalar).
Lemma r_act a x u v : rT a x -> rV u v -> rV (act a u) (act x v).
Proof. crush. Qed.
Lemma r_prod a x b y : rT a x -> rT b y -> rT (prod a b) (prod x y).
Proof. crush. Qed.
Lemma r_dot a x b y : rV a x -> rV b y -> rS (dot a b) (dot x y).
Proof. crush. Qed.
Lemma r_cross a x b y : rV a x -> rV b y -> rV (cross a b) (cross x y).
Proof. crush. Qed.
Lemma r_outer a x b y : rV a x -> rV b y -> rT (outer a b) (outer x y).
Proof. crush. Qed.
Lemma r_skew a x : rV a x -> rT (skew a) (skew x).
Proof. crush. Qed.
Lemma r_vect a x : rT a x -> rV (vect a) (vect x).
Proof. crush. Qed.
Lemma r_sym a x : rT a x -> rT (sym a) (sym x).
Proof. crush. Qed.
Lemma r_anti a x : rT a x -> rT (anti a) (anti x).
Proof. crush. Qed.
Lemma r_axis i : @every A B R Vector (axis i) (axis i).
Proof. destruct i as [|[|i]]; crush. Qed.
Lemma r_triad (a b c : A) x y z : R a x -> R b y -> R c z -> all3 R (V a b c) (V x y z).
Proof. repeat split; assumption. Qed.
Lemma r_part {X Y} (P : X -> Y -> Prop) (u : three X) (v : three Y) i : all3 P u v -> P (part u i) (part v i).
Proof. intros (E & F & G). destruct i as [|[|i]]; assumption. Qed.
Lemma r_transpose a x : rT a x -> rT (transpose a) (transpose x).
Proof. crush. Qed.
Lemma r_adj a x : rT a x -> rT (adj a) (adj x).
Proof. crush. Qed.
Lemma r_det a x : rT a x -> rS (det a) (det x).
Proof. crush. Qed.
Lemma r_trace a x : rT a x -> rS (trace a) (trace x).
Proof. crush. Qed.
Lemma r_triple a x b y c z : rV a x -> rV b y -> rV c z -> rS (triple a b c) (triple x y z).
Proof. crush. Qed.
Lemma r_re k (a : val (dual_ops A) k) (x : val (dual_ops B) k) : every (dual_same R) a x -> rel (real_part a) (real_part x).
Proof. destruct k; cbn; unfold all3, dual_same; cbn; intuition. Qed.
Lemma r_du k (a : val (dual_ops A) k) (x : val (dual_ops B) k) : every (dual_same R) a x -> rel (dual_part a) (dual_part x).
Proof. destruct k; cbn; unfold all3, dual_same; cbn; intuition. Qed.
Lemma r_emb k (a : val A k) x : rel a x -> @every (dual A) (dual B) (dual_same R) k (embed a) (embed x).
Proof. pose proof (h_num H). destruct k; cbn; unfold all3, dual_same; cbn; intuition. Qed.
End Homomorphism.

Definition related {A B : ops} (R : A -> B -> Prop) d k (a : val (rng A d) k) (x : val (rng B d) k) : Prop :=
  every (drel R d) a x.
Definition env_related {A B : ops} (R : A -> B -> Prop) (e : env A) (f : env B) :=
  forall d k i, related R d k (e d k i) (f d k i).
Theorem den_related A B R : hom A B R -> forall d k (t : tm d k) e f, env_related R e f ->
  related R d k (den e t) (den f t).
Proof.
  intros H d k t. pose proof (fun d => hom_rng d H) as Hd.
  induction t; intros e f E; unfold related in *; cbn [den];
    first [ apply E | apply (h_num (Hd _)) | apply (r_zero (Hd _)) | apply (r_ident (Hd _))
          | split; apply (h_num H)
          | apply (r_anti (Hd _)) | apply (r_axis (Hd _)) | apply (@r_part _ _ (drel R d)) | apply (@r_part _ _ (all3 (drel R d)))
          | apply (r_vect (Hd _)) | apply (r_sym (Hd _)) | apply (r_adj (Hd _)) | apply (r_det (Hd _)) | apply (r_triple (Hd _))
          | apply (r_plus (Hd _)) | apply (r_minus (Hd _)) | apply (r_neg (Hd _)) | apply (r_scale (Hd _))
          | apply (r_act (Hd _)) | apply (r_prod (Hd _)) | apply (r_dot (Hd _)) | apply (r_cross (Hd _))
          | apply (r_outer (Hd _)) | apply (r_skew (Hd _)) | apply (r_vect (Hd _)) | apply (r_sym (Hd _))
          | apply r_transpose | apply (r_adj (Hd _)) | apply (r_det (Hd _)) | apply (r_trace (Hd _))
          | apply (r_triple (Hd _)) | apply (r_D (Hd _)) | apply r_re | apply r_du | apply (r_emb H) | apply r_triad | idtac ];
    try solve [exact (IHt e f E) | exact (IHt1 e f E) | exact (IHt2 e f E) | exact (IHt3 e f E) | apply r_transpose; exact (IHt e f E)].
  apply IHt2. intros d0 k0 j. unfold upd.
  destruct (Bool.bool_dec d d0) as [p|]; [|apply E]. destruct (kind_dec k k0) as [q|]; [|apply E].
  destruct (Nat.eqb i j); [|apply E]. destruct p, q. cbn. apply IHt1. auto.
Qed.

(** Polynomials as operations. *)
Section Polynomials.
Variable table : positive -> pol.
Definition pol_ops : ops := {| car := pol; num q := Pc (Qred q); add := padd; mul := pmul; opp := popp; dt := deriv table 1 |}.
Variable K : diff_ring.
Variable l : Env K.
Definition stands (p : pol) (x : K) : Prop := same (value K l p) x.
Hypothesis table_ok : forall i, same (value K l (table i)) (dt (l i)).
Lemma pol_hom : hom pol_ops K stands.
Proof.
  unfold stands. split; cbn; intros.
  - change (same (@num K (Qred q)) (num q)). apply num_ext. apply Qred_correct.
  - etransitivity; [apply value_add|]. apply add_ext; assumption.
  - etransitivity; [apply value_mul|]. apply mul_ext; assumption.
  - etransitivity; [apply value_opp|]. apply opp_ext; assumption.
  - etransitivity; [apply value_dt, table_ok|]. apply dt_ext; assumption.
Qed.
End Polynomials.
