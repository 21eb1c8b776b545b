(** That the suppositions of claims can be satisfied. *)
From Coq Require Import QArith List.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Facts Smooth Witness.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.
Notation T i := (Var false Tensor i). Notation U i := (Var false Vector i). Notation S_ i := (Var false Scalar i).
(* the premises of 10 can be satisfied: R tumbling, y = 1/2 *)
Example w_10 : exists (R : tensor smooth_functions) (y : scalar smooth_functions), rotation R /\
  let omega := vect (D R ∘ transpose R) in let epsilon := D omega in
  y • ((omega × epsilon) · (omega × epsilon)) ≡ (num 1 : scalar smooth_functions).
Proof.
  exists tumbling, (num (1 # 2)). split; [exact tumbling_rotation|].
  under tumbling_at tumbling_shapes tumbling_slots
    (Let 100 (Vect (Prod (DD (T 3)) (Transpose (T 3)))) (Let 101 (Cross (U 100) (DD (U 100))) (Scale (Num false (1 # 2)) (Dot (U 101) (U 101)))))
    (Num false 1).
Qed.
