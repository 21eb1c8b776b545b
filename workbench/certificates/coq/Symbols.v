(** What symbols of a statement can be supposed to be (to be read together with Kin.v). *)
From Coq Require Import QArith.
From Kin Require Import Kin.
Open Scope Q_scope. Open Scope kin_scope.

Definition dual_rotation {K : diff_ring} (R : val (dual_ops K) Tensor) : Prop :=
  @equal K true Tensor (prod R (transpose R)) ident /\ @equal K true Scalar (det R) (num 1).
Definition unit_vector {K : diff_ring} {d} (u : val (rng K d) Vector) : Prop :=
  @equal K d Scalar (dot u u) (num 1).
Definition constant {K : diff_ring} {d k} (x : val (rng K d) k) : Prop := @equal K d k (D x) zero.

(** c and s are cosine and sine of the angle a, by all that identities need of them. *)
Definition turn {K : diff_ring} (a c s : scalar K) : Prop :=
  c • c + s • s ≡ (num 1 : scalar K) /\ D c ≡ - (s • D a) /\ D s ≡ c • D a.
(** Cosine and sine of the dual angle a, where c and s are those of its real part. *)
Definition dual_cos {K : diff_ring} (a : dual_scalar K) (c s : scalar K) : dual_scalar K :=
  embed c - eps • embed ((dual_part a : scalar K) • s).
Definition dual_sin {K : diff_ring} (a : dual_scalar K) (c s : scalar K) : dual_scalar K :=
  embed s + eps • embed ((dual_part a : scalar K) • c).
(** Rodrigues' formula: the exponential of an angle (with cosine c and sine s) times the skew tensor of a unit vector. *)
Definition rodrigues {O : ops} (c s : val O Scalar) (u : val O Vector) : val O Tensor :=
  ident + s • skew u + (sub (num 1) c) • (skew u ∘ skew u).
(** exp(ε X) = I + ε X, since (ε X)² = 0. *)
Definition exp_eps {O : ops} (x : val O Tensor) : val (dual_ops O) Tensor := ident + @scale (dual_ops O) Tensor eps (embed x).
