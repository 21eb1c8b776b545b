(** What the statements mean: all of this is to be read, nothing of it is proof machinery.
    A differential ring is a commutative ring that contains the rationals and has a derivation D = d/dt;
    Smooth.v shows that the smooth functions of time are one. *)
From Coq Require Import QArith Setoid Morphisms Ring_theory.
Set Implicit Arguments.

Record ops := { car :> Type; num : Q -> car; add : car -> car -> car; mul : car -> car -> car;
                opp : car -> car; dt : car -> car }.
Arguments num {o}. Arguments add {o}. Arguments mul {o}. Arguments opp {o}. Arguments dt {o}.
Definition sub {O : ops} (a b : O) : O := add a (opp b).

Record diff_ring := {
  op :> ops;
  same : op -> op -> Prop;
  same_equiv : Equivalence same;
  add_ext : Proper (same ==> same ==> same) (@add op);
  mul_ext : Proper (same ==> same ==> same) (@mul op);
  opp_ext : Proper (same ==> same) (@opp op);
  dt_ext : Proper (same ==> same) (@dt op);
  laws : ring_theory (num 0) (num 1) (@add op) (@mul op) (@sub op) (@opp op) same;
  num_ext : forall p q, (p == q)%Q -> same (num p) (num q);
  num_add : forall p q, same (num (p + q)) (add (num p) (num q));
  num_mul : forall p q, same (num (p * q)) (mul (num p) (num q));
  num_opp : forall p, same (num (- p)) (opp (num p));
  dt_num : forall p, same (dt (num p)) (num 0);
  dt_add : forall a b, same (dt (add a b)) (add (dt a) (dt b));
  dt_mul : forall a b, same (dt (mul a b)) (add (mul (dt a) b) (mul a (dt b))) }.
Arguments same {d}.

(** Scalars, vectors, and tensors as rows of their 3×3 matrices. *)
Record three (A : Type) := V { x1 : A; x2 : A; x3 : A }.
Inductive kind := Scalar | Vector | Tensor.
Definition val (A : Type) (k : kind) : Type :=
  match k with Scalar => A | Vector => three A | Tensor => three (three A) end.
Definition map {A B} (f : A -> B) (u : three A) := V (f (x1 u)) (f (x2 u)) (f (x3 u)).
Definition zip {A B C} (f : A -> B -> C) (u : three A) (v : three B) :=
  V (f (x1 u) (x1 v)) (f (x2 u) (x2 v)) (f (x3 u) (x3 v)).
Definition each {A B} (f : A -> B) {k} : val A k -> val B k :=
  match k with Scalar => f | Vector => map f | Tensor => map (map f) end.
Definition both {A B C} (f : A -> B -> C) {k} : val A k -> val B k -> val C k :=
  match k with Scalar => f | Vector => zip f | Tensor => zip (zip f) end.
Definition fill {A} (a : A) {k} : val A k :=
  match k with Scalar => a | Vector => V a a a | Tensor => let r := V a a a in V r r r end.

(** Dual numbers a + ε a₀ over any differential ring. *)
Record dual (A : Type) := Dual { re : A; du : A }.
Definition dual_ops (O : ops) : ops := {| car := dual O;
  num q := Dual (num q) (num 0);
  add a b := Dual (add (re a) (re b)) (add (du a) (du b));
  mul a b := Dual (mul (re a) (re b)) (add (mul (re a) (du b)) (mul (du a) (re b)));
  opp a := Dual (opp (re a)) (opp (du a));
  dt a := Dual (dt (re a)) (dt (du a)) |}.
Definition rng (O : ops) (d : bool) : ops := if d then dual_ops O else O.
Definition eps {O : ops} : dual_ops O := @Dual O (num 0) (num 1).

Section Operations.
Context {O : ops}.
Notation val k := (val (car O) k).
Infix "+" := add. Infix "*" := mul. Infix "-" := sub. Notation "- a" := (opp a).
Definition plus {k} : val k -> val k -> val k := both add.
Definition minus {k} : val k -> val k -> val k := both sub.
Definition neg {k} : val k -> val k := each opp.
Definition scale {k} (s : val Scalar) : val k -> val k := each (mul s).
Definition D {k} : val k -> val k := each dt.
Definition zero {k} : val k := fill (num 0).
Definition sum (u : val Vector) : O := x1 u + x2 u + x3 u.
Definition dot (u v : val Vector) : val Scalar := sum (zip mul u v).
Definition cross (u v : val Vector) : val Vector :=
  V (x2 u * x3 v - x3 u * x2 v) (x3 u * x1 v - x1 u * x3 v) (x1 u * x2 v - x2 u * x1 v).
Definition skew (u : val Vector) : val Tensor := let o := num 0 in
  V (V o (- x3 u) (x2 u)) (V (x3 u) o (- x1 u)) (V (- x2 u) (x1 u) o).
Definition ident : val Tensor := let o := num 0 in let i := num 1 in V (V i o o) (V o i o) (V o o i).
Definition transpose (a : val Tensor) : val Tensor := V (map (@x1 O) a) (map (@x2 O) a) (map (@x3 O) a).
Definition act (a : val Tensor) (u : val Vector) : val Vector := map (fun row => dot row u) a.
Definition prod (a b : val Tensor) : val Tensor := map (fun row => map (dot row) (transpose b)) a.
Definition outer (u v : val Vector) : val Tensor := map (fun a => map (mul a) v) u.
Definition trace (a : val Tensor) : val Scalar := x1 (x1 a) + x2 (x2 a) + x3 (x3 a).
Definition triple (u v w : val Vector) : val Scalar := dot u (cross v w).
Definition det (a : val Tensor) : val Scalar := triple (x1 a) (x2 a) (x3 a).
Definition adj (a : val Tensor) : val Tensor :=
  transpose (V (cross (x2 a) (x3 a)) (cross (x3 a) (x1 a)) (cross (x1 a) (x2 a))).
Definition number (q : Q) : val Scalar := num q.
Definition half : val Scalar := num (1 # 2).
Definition sym (a : val Tensor) : val Tensor := scale half (plus a (transpose a)).
Definition anti (a : val Tensor) : val Tensor := scale half (minus a (transpose a)).
Definition vect (a : val Tensor) : val Vector := @scale Vector half
  (V (x3 (x2 (transpose a)) - x3 (x2 a)) (x1 (x3 (transpose a)) - x1 (x3 a)) (x2 (x1 (transpose a)) - x2 (x1 a))).
Definition square (u : val Vector) : val Scalar := dot u u.
Fixpoint spower (s : val Scalar) (n : nat) : val Scalar :=
  match n with 0%nat => num 1 | 1%nat => s | S m => scale s (spower s m) end.
Fixpoint tpower (a : val Tensor) (n : nat) : val Tensor :=
  match n with 0%nat => ident | 1%nat => a | S m => prod a (tpower a m) end.
Definition axis (i : nat) : val Vector := match i with
  | 0%nat => V (num 1) (num 0) (num 0) | 1%nat => V (num 0) (num 1) (num 0) | _ => V (num 0) (num 0) (num 1) end.
(** Polynomials in D = d/dt act on vectors, and on tensors column by column: [times a] multiplies by the tensor a. *)
Definition times (a : val Tensor) {k} : val k -> val k :=
  match k with Scalar => fun s => s | Vector => act a | Tensor => prod a end.
Definition add_op {k} (p q : val k -> val k) x := plus (p x) (q x).
Definition neg_op {k} (p : val k -> val k) x := neg (p x).
Definition after {k} (p q : val k -> val k) x := p (q x).
Definition unit_op {k} (x : val k) := x.
Fixpoint power_op {k} (p : val k -> val k) (n : nat) x := match n with 0%nat => x | S m => p (power_op p m x) end.
Fixpoint der (n : nat) {k} (x : val k) : val k := match n with 0%nat => x | S m => D (der m x) end.
Definition part {A} (u : three A) (i : nat) := match i with 0%nat => x1 u | 1%nat => x2 u | _ => x3 u end.
End Operations.

Definition real_part {O : ops} {k} : val (dual_ops O) k -> val O k := each (@re O).
Definition dual_part {O : ops} {k} : val (dual_ops O) k -> val O k := each (@du O).
Definition embed {O : ops} {k} : val O k -> val (dual_ops O) k := each (fun a => @Dual O a (num 0)).

(** Equality: of all components. *)
Definition all3 {A B} (R : A -> B -> Prop) (u : three A) (v : three B) : Prop :=
  R (x1 u) (x1 v) /\ R (x2 u) (x2 v) /\ R (x3 u) (x3 v).
Definition every {A B} (R : A -> B -> Prop) {k} : val A k -> val B k -> Prop :=
  match k with Scalar => R | Vector => all3 R | Tensor => all3 (all3 R) end.
Definition dual_same {A B} (R : A -> B -> Prop) (a : dual A) (b : dual B) := R (re a) (re b) /\ R (du a) (du b).
Definition equal {K : diff_ring} {d k} : val (rng K d) k -> val (rng K d) k -> Prop :=
  match d with true => every (dual_same same) | false => every same end.

(** What the symbols can be supposed to be. *)
Definition rotation {K : diff_ring} (R : val K Tensor) : Prop :=
  @equal K false Tensor (prod R (transpose R)) ident /\ @equal K false Scalar (det R) (num 1).
Definition inverse {K : diff_ring} (a b : val K Tensor) : Prop :=
  @equal K false Tensor (prod a b) ident /\ @equal K false Tensor (prod b a) ident.
Definition reciprocal {K : diff_ring} (a b : val K Scalar) : Prop := @equal K false Scalar (scale a b) (number 1).
(** How the statements are written. *)
Declare Scope kin_scope.
Delimit Scope kin_scope with kin.
Infix "+" := plus : kin_scope.
Infix "-" := minus : kin_scope.
Notation "- a" := (neg a) : kin_scope.
Infix "•" := scale (at level 40, left associativity) : kin_scope.
Infix "·" := dot (at level 40, left associativity) : kin_scope.
Infix "×" := cross (at level 40, left associativity) : kin_scope.
Infix "⊗" := outer (at level 40, left associativity) : kin_scope.
Infix "∘" := prod (at level 40, left associativity) : kin_scope.
Infix "⊕" := add_op (at level 50, left associativity) : kin_scope.
Infix "⊚" := after (at level 40, left associativity) : kin_scope.
Infix "@" := act (at level 40, left associativity) : kin_scope.
Notation "a 'ᵀ'" := (transpose a) (at level 1, left associativity, format "a 'ᵀ'") : kin_scope.
Notation "a ≡ b" := (@equal _ false _ a b) (at level 70) : kin_scope.
Notation "a ≡ε b" := (@equal _ true _ a b) (at level 70) : kin_scope.
Notation scalar K := (val (rng K false) Scalar).
Notation vector K := (val (rng K false) Vector).
Notation tensor K := (val (rng K false) Tensor).
Notation dual_scalar K := (val (rng K true) Scalar).
Notation dual_vector K := (val (rng K true) Vector).
Notation dual_tensor K := (val (rng K true) Tensor).
