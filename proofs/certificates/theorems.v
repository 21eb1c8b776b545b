(** Theorems of the chapter that one identity cannot state, each as one theorem of Coq. *)
From Coq Require Import QArith List Lia.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Facts Orders.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.
Notation T i := (Var false Tensor i). Notation U i := (Var false Vector i). Notation S_ i := (Var false Scalar i).
Notation DT i := (Var true Tensor i). Notation DU i := (Var true Vector i). Notation DS i := (Var true Scalar i).
(* on 14: for every n *)
Theorem c_14_all (K : diff_ring) (R : tensor K) (rho_Q r : vector K) (R_ok : rotation R) (r_ok : constant (K := K) (d := false) r) :
  forall n : nat, (der n (rho_Q + R @ r) : vector K) - der n rho_Q ≡ ((der n R : tensor K) ∘ transpose R) @ ((rho_Q + R @ r) - rho_Q).
Proof.
  intros n.
  assert (A : (der n (rho_Q + R @ r) : vector K) ≡ (der n rho_Q : vector K) + (der n R : tensor K) @ r).
  { induction n as [|n IH].
    - under (@nil premise) [(false, Tensor); (false, Vector); (false, Vector)] [as_slot false Tensor R; as_slot false Vector rho_Q; as_slot false Vector r]
        (Plus (U 1) (Act (T 0) (U 2))) (Plus (U 1) (Act (T 0) (U 2))).
    - under [@Value false Vector 0 (Plus (U 1) (Act (T 2) (U 3))); Rate 3 (Zer false Vector)]
        [(false, Vector); (false, Vector); (false, Tensor); (false, Vector)]
        [as_slot false Vector (der n (rho_Q + R @ r) : vector K); as_slot false Vector (der n rho_Q : vector K); as_slot false Tensor (der n R : tensor K); as_slot false Vector r]
        (DD (U 0)) (Plus (DD (U 1)) (Act (DD (T 2)) (U 3))). }
  under (rotation_at 0 1 ++ [@Value false Vector 2 (Plus (U 3) (Act (T 4) (U 5))); Rate 5 (Zer false Vector)])
    [(false, Tensor); (false, Vector); (false, Vector); (false, Vector); (false, Tensor); (false, Vector); (false, Vector)]
    [as_slot false Tensor R; as_slot false Vector (spin R); as_slot false Vector (der n (rho_Q + R @ r) : vector K); as_slot false Vector (der n rho_Q : vector K); as_slot false Tensor (der n R : tensor K); as_slot false Vector r; as_slot false Vector rho_Q]
    (Minus (U 2) (U 3)) (Act (Prod (T 4) (Transpose (T 0))) (Minus (Plus (U 6) (Act (T 0) (U 5))) (U 6))).
Qed.
(* on 20.Phi: for every n, without induction: the n-th derivative of R is a symbol of its own *)
Theorem c_20_Phi_all (K : diff_ring) (R : tensor K) (R_ok : rotation R) : 
  let Phi := fun n => (der n R : tensor K) ∘ transpose R in forall n : nat, Phi (S n) ≡ D (Phi n) + Phi n ∘ Phi 1%nat.
Proof.
  intros Phi n.
  under (rotation_at 0 1) [(false, Tensor); (false, Vector); (false, Tensor)] [as_slot false Tensor R; as_slot false Vector (spin R); as_slot false Tensor (der n R : tensor K)]
   (Prod (DD (T 2)) (Transpose (T 0))) (Plus (DD (Prod (T 2) (Transpose (T 0)))) (Prod (Prod (T 2) (Transpose (T 0))) (Prod (DD (T 0)) (Transpose (T 0))))).
Qed.
(* on 21.every_n, 21.Phi: for every n, the recurrence unrolled *)
Theorem c_21_all (K : diff_ring) (R : tensor K) (R_ok : rotation R) :
  let Phi := fun n => (der n R : tensor K) ∘ transpose R in
  forall n : nat, (2 <= n)%nat ->
  Phi n ≡ (Phi (n - 1)%nat ∘ Phi 1%nat) + (der (n - 1) (Phi 1%nat) : tensor K) +
    @sum_of K Tensor 1 (n - 2) (fun k => der k (Phi (n - k - 1)%nat ∘ Phi 1%nat)).
Proof.
  intros Phi n L. apply (@unrolled K false Tensor Phi (fun n => Phi n ∘ Phi 1%nat)); [|exact L].
  intros m _. exact (@c_20_Phi_all K R R_ok m).
Qed.
(* The polynomials of a recursion with P_1 = I, P_(n+1) = D P_n + P_n(ω̃), on tensors and on vectors. *)
Fixpoint PT {K : diff_ring} (w : tensor K) (n : nat) (x : tensor K) : tensor K :=
  match n with 0%nat => x | S m => D (PT w m x) + PT w m w ∘ x end.
Fixpoint PV {K : diff_ring} (w : tensor K) (n : nat) (x : vector K) : vector K :=
  match n with 0%nat => x | S m => D (PV w m x) + PT w m w @ x end.
(* on 38.a, 38.Phi: for every n *)
Theorem c_38_all (K : diff_ring) (omega v : vector K) (Phi : nat -> tensor K) (a : nat -> vector K)
  (Phi_base : Phi 1%nat ≡ skew omega) (Phi_step : forall n, (1 <= n)%nat -> Phi (S n) ≡ D (Phi n) + Phi n ∘ Phi 1%nat)
  (a_base : a 1%nat ≡ v) (a_step : forall n, (1 <= n)%nat -> a (S n) ≡ D (a n) + Phi n @ a 1%nat) :
  forall n, (1 <= n)%nat -> Phi n ≡ PT (skew omega) (n - 1) (skew omega) /\ a n ≡ PV (skew omega) (n - 1) v.
Proof.
  apply from_lowest; [split; assumption|]. intros n L [IH1 IH2].
  pose proof (Phi_step n L) as s1. pose proof (a_step n L) as s2.
  replace (S n - 1)%nat with (S (n - 1)) by lia. split; cbn [PT PV].
  - under [Value 2 (Skew (U 0)); Value 3 (T 4); Value 5 (Plus (DD (T 3)) (Prod (T 3) (T 2)))]
     [(false, Vector); (false, Vector); (false, Tensor); (false, Tensor); (false, Tensor); (false, Tensor)]
     [as_slot false Vector omega; as_slot false Vector v; as_slot false Tensor (Phi 1%nat); as_slot false Tensor (Phi n);
      as_slot false Tensor (PT (skew omega) (n - 1) (skew omega)); as_slot false Tensor (Phi (S n))]
     (T 5) (Plus (DD (T 4)) (Prod (T 4) (Skew (U 0)))).
  - under [@Value false Vector 2 (U 1); @Value false Vector 3 (U 4); @Value false Tensor 6 (T 7); @Value false Vector 5 (Plus (DD (U 3)) (Act (T 6) (U 2)))]
     [(false, Vector); (false, Vector); (false, Vector); (false, Vector); (false, Vector); (false, Vector); (false, Tensor); (false, Tensor)]
     [as_slot false Vector omega; as_slot false Vector v; as_slot false Vector (a 1%nat); as_slot false Vector (a n);
      as_slot false Vector (PV (skew omega) (n - 1) v); as_slot false Vector (a (S n)); as_slot false Tensor (Phi n);
      as_slot false Tensor (PT (skew omega) (n - 1) (skew omega))]
     (U 5) (Plus (DD (U 4)) (Act (T 7) (U 1))).
Qed.
(* on 123.all_n: for every n, D^n (R Ω) = Σ C(n,k) Φ_(n-k) R D^k Ω *)
Theorem c_123_all (K : diff_ring) (R : dual_tensor K) (Omega : dual_vector K) (R_ok : dual_rotation R) :
  let Phi := fun n => (der n R : dual_tensor K) ∘ transpose R in
  forall n : nat, (der n (R @ Omega) : dual_vector K) ≡ε
    @sum_of (dual_ops K) Vector 0 n (fun k => whole (choose n k) • (Phi (n - k)%nat @ (R @ (der k Omega : dual_vector K)))).
Proof.
  intros Phi n.
  pose proof (@leibniz K true Vector (fun a b => (der a R : dual_tensor K) @ (der b Omega : dual_vector K))) as L.
  transitivity (@sum_of (dual_ops K) Vector 0 n (fun j => whole (choose n j) • ((der (n - j) R : dual_tensor K) @ (der j Omega : dual_vector K)))).
  - refine (L _ n 0%nat 0%nat). intros a b.
    under (@nil premise) [(true, Tensor); (true, Vector)] [as_slot true Tensor (der a R : dual_tensor K); as_slot true Vector (der b Omega : dual_vector K)]
      (DD (Act (DT 0) (DU 1))) (Plus (Act (DD (DT 0)) (DU 1)) (Act (DT 0) (DD (DU 1)))).
  - apply (@total_ext K true Vector). intros j J. cbn [Nat.add].
    under (dual_rotation_at 0 1 2 3) [(true, Tensor); (false, Tensor); (false, Vector); (false, Vector); (true, Tensor); (true, Vector); (true, Scalar)]
      [as_slot true Tensor R; as_slot false Tensor (real_part R); as_slot false Vector (spin (real_part R)); as_slot false Vector (shift R);
       as_slot true Tensor (der (n - j) R : dual_tensor K); as_slot true Vector (der j Omega : dual_vector K); as_slot true Scalar (whole (choose n j) : dual_scalar K)]
      (Scale (DS 6) (Act (DT 4) (DU 5)))
      (Scale (DS 6) (Act (Prod (DT 4) (Transpose (DT 0))) (Act (DT 0) (DU 5)))).
Qed.
(* on Theorem_11, 127: for every m and n; R p moves the frame of body p, Omega p is the twist of body p+1 in it *)
Theorem c_Theorem_11 (K : diff_ring) (R : nat -> dual_tensor K) (Omega : nat -> dual_vector K) (R_ok : forall p, dual_rotation (R p)) :
  forall m n : nat, (der n (total m (fun p => R p @ Omega p)) : dual_vector K) ≡ε
    @total (dual_ops K) Vector m (fun p => @sum_of (dual_ops K) Vector 0 n (fun k =>
      whole (choose n k) • (((der (n - k) (R p) : dual_tensor K) ∘ transpose (R p)) @ (R p @ (der k (Omega p) : dual_vector K))))).
Proof.
  intros m n. etransitivity; [apply (@der_total K true Vector)|]. apply (@total_ext K true Vector). intros p _.
  exact (c_123_all K (R p) (Omega p) (R_ok p) n).
Qed.
(* on 89.skew: the derivative of R̲ is ω̲̃ R̲ *)
Theorem c_89_skew (K : diff_ring) (R : dual_tensor K) (R_ok : dual_rotation R) :
  let omega := vect (D R ∘ transpose R) in (D R ∘ transpose R ≡ε skew omega) /\ (D R ≡ε skew omega ∘ R).
Proof.
  split.
  - under (dual_rotation_at 0 1 2 3) [(true, Tensor); (false, Tensor); (false, Vector); (false, Vector)]
      [as_slot true Tensor R; as_slot false Tensor (real_part R); as_slot false Vector (spin (real_part R)); as_slot false Vector (Facts.shift R)]
      (Prod (DD (DT 0)) (Transpose (DT 0))) (Skew (Vect (Prod (DD (DT 0)) (Transpose (DT 0))))).
  - under (dual_rotation_at 0 1 2 3) [(true, Tensor); (false, Tensor); (false, Vector); (false, Vector)]
      [as_slot true Tensor R; as_slot false Tensor (real_part R); as_slot false Vector (spin (real_part R)); as_slot false Vector (Facts.shift R)]
      (DD (DT 0)) (Prod (Skew (Vect (Prod (DD (DT 0)) (Transpose (DT 0))))) (DT 0)).
Qed.
(* Two sequences with the same beginning and the same recursion agree. *)
Lemma one_sequence (K : diff_ring) d k (s t : nat -> val (rng K d) k) (next : nat -> val (rng K d) k -> val (rng K d) k) m :
  (forall n x y, equal x y -> equal (next n x) (next n y)) -> equal (s m) (t m) ->
  (forall n, (m <= n)%nat -> equal (s (S n)) (next n (s n))) -> (forall n, (m <= n)%nat -> equal (t (S n)) (next n (t n))) ->
  forall n, (m <= n)%nat -> equal (s n) (t n).
Proof. intros E B HS HT. apply from_lowest; [exact B|]. intros n L IH. rewrite (HS n L), (HT n L). now apply E. Qed.
(* on 130.from_twist: the recurrence determines every Φₙ = R⁽ⁿ⁾Rᵀ from ω alone *)
Theorem c_130_from_twist (K : diff_ring) (omega : dual_vector K) (Phi Psi : nat -> dual_tensor K)
  (P0 : Phi 0%nat ≡ε ident) (P : forall n, Phi (S n) ≡ε D (Phi n) + Phi n ∘ skew omega)
  (Q0 : Psi 0%nat ≡ε ident) (Q : forall n, Psi (S n) ≡ε D (Psi n) + Psi n ∘ skew omega) : forall n, Phi n ≡ε Psi n.
Proof.
  intros n. apply (@one_sequence K true Tensor Phi Psi (fun _ X => D X + X ∘ skew omega) 0%nat); auto with arith.
  - intros _ X Y E. cbn beta. now rewrite E.
  - now rewrite P0, Q0.
Qed.
(* on 80: Rodrigues' formula gives a rotation about a unit vector *)
Theorem rodrigues_rotation (K : diff_ring) (a c s : scalar K) (u : vector K) (t_ok : turn a c s) (u_ok : unit_vector (K := K) (d := false) u) :
  rotation (rodrigues c s u).
Proof.
  pose (R := Plus (Plus (Idt false) (Scale (S_ 1) (Skew (U 2)))) (Scale (Minus (Num false 1) (S_ 0)) (Prod (Skew (U 2)) (Skew (U 2))))).
  split.
  - under (turn_at (S_ 4) 0 1 ++ unit_at 2 3) [(false, Scalar); (false, Scalar); (false, Vector); (false, Vector); (false, Scalar)]
     [as_slot false Scalar c; as_slot false Scalar s; as_slot false Vector u; as_slot false Vector (u × D u); as_slot false Scalar a]
     (Prod R (Transpose R)) (Idt false).
  - under (turn_at (S_ 4) 0 1 ++ unit_at 2 3) [(false, Scalar); (false, Scalar); (false, Vector); (false, Vector); (false, Scalar)]
     [as_slot false Scalar c; as_slot false Scalar s; as_slot false Vector u; as_slot false Vector (u × D u); as_slot false Scalar a]
     (Det R) (Num false 1).
Qed.
