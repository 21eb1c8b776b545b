"""Identities of rigid motions: adjoint matrices, transforms, and exponentials of twists."""

from __future__ import annotations

from evaluator.kit import Kit, lines

TWISTS = Kit(
    r"""
[symbols]
R = "rotation"
S = "rotation"
p = "vector"
q = "vector"
x = "vector"
a = "vector"
b = "vector"
V = "matrix 6×1"
W = "matrix 6×1"
H = "transform"
G = "transform"
[definitions]
A = '\begin{bmatrix} R & 0 \\ \tilde{p} R & R \end{bmatrix}'
B = '\begin{bmatrix} S & 0 \\ \tilde{q} S & S \end{bmatrix}'
C = '\begin{bmatrix} R S & 0 \\ \widetilde{p + R q} R S & R S \end{bmatrix}'
N = '\begin{bmatrix} \tilde{a} & 0 \\ \tilde{b} & \tilde{a} \end{bmatrix}'
M = '\begin{bmatrix} \tilde{x} & 0 \\ \tilde{q} & \tilde{x} \end{bmatrix}'
K = '\begin{bmatrix} \widetilde{a \times x} & 0 \\ \widetilde{a \times q + b \times x} & \widetilde{a \times x} \end{bmatrix}'
'\omega' = '\operatorname{vect}(\dot{R} R^T)'
T = '\begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix}'
""",
    lines(r"""
A B = C
A^{-1} = \begin{bmatrix} R^T & 0 \\ -R^T \tilde{p} & R^T \end{bmatrix}
N M - M N = K
A N A^{-1} = \begin{bmatrix} \widetilde{R a} & 0 \\ \widetilde{R b + p \times (R a)} & \widetilde{R a} \end{bmatrix}
N \begin{bmatrix} a \\ b \end{bmatrix} = 0 V
M \begin{bmatrix} a \\ b \end{bmatrix} = -N \begin{bmatrix} x \\ q \end{bmatrix}
\dot{A} = \begin{bmatrix} \tilde{\omega} & 0 \\ \widetilde{\dot{p} - \omega \times p} & \tilde{\omega} \end{bmatrix} A
A^T \begin{bmatrix} a \\ b \end{bmatrix} \cdot \begin{bmatrix} x \\ q \end{bmatrix} = \begin{bmatrix} a \\ b \end{bmatrix} \cdot (A \begin{bmatrix} x \\ q \end{bmatrix})
T^{-1} = \begin{bmatrix} R^T & -R^T p \\ 0 & 1 \end{bmatrix}
\dot{T} T^{-1} = \begin{bmatrix} \tilde{\omega} & \dot{p} - \omega \times p \\ 0 & 0 \end{bmatrix}
T^{-1} \dot{T} = \begin{bmatrix} \widetilde{R^T \omega} & R^T \dot{p} \\ 0 & 0 \end{bmatrix}
T \begin{bmatrix} x \\ 1 \end{bmatrix} = \begin{bmatrix} R x + p \\ 1 \end{bmatrix}
T \begin{bmatrix} x \\ 0 \end{bmatrix} = \begin{bmatrix} R x \\ 0 \end{bmatrix}
(G H)^{-1} = H^{-1} G^{-1}
\frac{d}{dt} (H^{-1}) = -H^{-1} \dot{H} H^{-1}
\frac{d}{dt} (A V) = \dot{A} V + A \dot{V}
\det(G H) = 1
\operatorname{trace}(V W^T) = V^T W
"""),
)

#: A and B turn about u and w, C about a line through q; E is B seen through T.
SCREWS = Kit(
    r"""
[symbols]
u = { kind = "vector", unit = true }
w = "vector"
v = "vector"
q = "vector"
R = "rotation"
p = "vector"
'\theta' = "scalar"
'\phi' = "scalar"
[definitions]
A = '\begin{bmatrix} \operatorname{skew}(u) & v \\ 0 & 0 \end{bmatrix}'
B = '\begin{bmatrix} \operatorname{skew}(w) & v \\ 0 & 0 \end{bmatrix}'
C = '\begin{bmatrix} \operatorname{skew}(w) & -w \times q \\ 0 & 0 \end{bmatrix}'
E = '\begin{bmatrix} \operatorname{skew}(R w) & R v - (R w) \times p \\ 0 & 0 \end{bmatrix}'
T = '\begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix}'
""",
    lines(r"""
e^{A \theta} = \begin{bmatrix} e^{\operatorname{skew}(u) \theta} & (\theta \mathbf{I} + (1 - \cos\theta) \operatorname{skew}(u) + (\theta - \sin\theta) \operatorname{skew}(u) \operatorname{skew}(u)) v \\ 0 & 1 \end{bmatrix}
\exp(A \theta) \exp(A \phi) = \exp(A [\theta + \phi])
\exp(B) B = B \exp(B)
\exp(B) \exp(-B) = \mathbf{I}_{4 \times 4}
\exp(2 B) = \exp(B) \exp(B)
\exp(C) \begin{bmatrix} q \\ 1 \end{bmatrix} = \begin{bmatrix} q \\ 1 \end{bmatrix}
\exp(B) \begin{bmatrix} w \\ 0 \end{bmatrix} = \begin{bmatrix} w \\ 0 \end{bmatrix}
\exp(E) = T \exp(B) T^{-1}
\det \exp(B) = 1
(w \cdot w) \left(\exp(B) - \mathbf{I}_{4 \times 4} - B\right) = (1 - \cos \|w\|) B B + \left(1 - \frac{\sin \|w\|}{\|w\|}\right) B B B
"""),
)
