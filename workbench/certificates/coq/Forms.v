(** Block matrices, fields and recurrences (to be read together with Kin.v where their words occur). *)
From Coq Require Import QArith.
From Kin Require Import Kin.
Open Scope Q_scope. Open Scope kin_scope.

Section Matrices.
Context {O : ops}.
Infix "+" := add. Infix "*" := mul. Notation "- a" := (opp a).
Notation val k := (val (car O) k).
(** Matrices of any size by row and column, made of blocks [beside] and [above] each other. *)
Definition matrix := nat -> nat -> O.
Definition cell {k} : val k -> matrix := match k with
  | Scalar => fun s _ _ => s | Vector => fun u i _ => part u i | Tensor => fun a i => part (part a i) end.
Definition covector (u : val Vector) : matrix := fun _ j => part u j.
Definition void : matrix := fun _ _ => num 0.
Definition beside (n : nat) (a b : matrix) : matrix := fun i j => if Nat.ltb j n then a i j else b i (Nat.sub j n).
Definition above (n : nat) (a b : matrix) : matrix := fun i j => if Nat.ltb i n then a i j else b (Nat.sub i n) j.
Fixpoint sum_to (n : nat) (f : nat -> O) : O :=
  match n with 0%nat => num 0 | 1%nat => f 0%nat | S m => sum_to m f + f m end.
Definition mplus (a b : matrix) : matrix := fun i j => a i j + b i j.
Definition mneg (a : matrix) : matrix := fun i j => - a i j.
Definition mscale (s : val Scalar) (a : matrix) : matrix := fun i j => s * a i j.
Definition mdot (a : matrix) : matrix := fun i j => dt (a i j).
Definition mprod (n : nat) (a b : matrix) : matrix := fun i j => sum_to n (fun k => a i k * b k j).
End Matrices.
Fixpoint upto (n : nat) (p : nat -> Prop) : Prop :=
  match n with 0%nat => True | 1%nat => p 0%nat | S m => upto m p /\ p m end.
Definition matrix_equal {K : diff_ring} m n (a b : @matrix K) : Prop := upto m (fun i => upto n (fun j => same (a i j) (b i j))).


(** A field f is written over dual numbers; ∂f/∂ρ along e is the dual part of f (ρ + ε e). *)
Definition along {O : ops} (f : val (dual_ops O) Vector -> val (dual_ops O) Vector) (x : val O Vector) i : val O Vector :=
  dual_part (f (plus (embed x) (@scale (dual_ops O) Vector eps (embed (axis i))))).
Definition divergence {O : ops} f (x : val O Vector) : val O Scalar :=
  add (add (x1 (along f x 0)) (x2 (along f x 1))) (x3 (along f x 2)).
Definition curl {O : ops} f (x : val O Vector) : val O Vector :=
  V (sub (x3 (along f x 1)) (x2 (along f x 2))) (sub (x1 (along f x 2)) (x3 (along f x 0)))
    (sub (x2 (along f x 0)) (x1 (along f x 1))).

(** A family by its first member and by the step from the n-th to the next. *)
Definition from_zero {A} (base : A) (next : nat -> A -> A) : nat -> A := nat_rect (fun _ => A) base next.
Definition from_one {A} (base : A) (next : nat -> A -> A) (n : nat) : A :=
  match n with 0%nat => base | S m => nat_rect (fun _ => A) base (fun k => next (S k)) m end.
