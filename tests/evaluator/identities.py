"""Identities of every kind that the judge knows, which tests transform and mutate."""

from dataclasses import replace

from workbench.language.naming.reading_conventions import Conventions, Gradient
from workbench.language.naming.symbols import SymbolTable

TABLE = replace(
    SymbolTable.build(
        {
            **{name: {"kind": "vector"} for name in ("a", "b", "x", "a_n")},
            **{name: {"kind": "scalar"} for name in ("f", "g", "s_n", "k_{m,n}", r"\alpha")},
            **{name: {"kind": "tensor"} for name in ("T", "S")},
            "R": {"kind": "rotation"},
            "u": {"kind": "vector", "unit": True},
            "c": {"kind": "vector", "constant": True},
            r"\underline{a}": {"kind": "dual vector"},
            r"\underline{b}": {"kind": "dual vector"},
            **{name: {"kind": "hamilton quaternion"} for name in ("p", "q", "r")},
            r"\underline{q}": {"kind": "dual hamilton quaternion"},
            "e": {"kind": "hamilton quaternion", "unit": True},
            r"\underline{e}": {"kind": "dual hamilton quaternion", "unit": True},
            **{name: {"kind": "transform"} for name in ("G", "H")},
            "J": {"kind": "tensor", "symmetric": True},
            "L": {"kind": "tensor", "diagonal": True},
            "M": {"kind": "matrix 6×6"},
            "N": {"kind": "matrix 2×4"},
            **{name: {"kind": "matrix 6×1"} for name in ("V", "W")},
            **{name: {"kind": "scalar"} for name in ("y", "z", r"\theta")},
            "w": {"kind": "vector"},
            r"\omega": {"kind": "scalar", "constant": True},
            "A": {"kind": "scalar", "of": ["y", "z"]},
            "B": {"kind": "vector", "of": ["y", r"\theta"]},
            "C": {"kind": "scalar", "of": ["w", "t"]},
            "D": {"kind": "vector", "of": ["w"]},
        }
    ),
    conventions=Conventions(gradient=Gradient.ROW),
)

IDENTITIES = r"""
a \times b = -b \times a
a \times (b \times x) = (a \cdot x) b - (a \cdot b) x
\tilde{a} b = a \times b
\tilde{a}^2 = a \otimes a - a^2 \mathbf{I}
(T S)^T = S^T T^T
\operatorname{trace}(T S) = \operatorname{trace}(S T)
\det(T S) = \det T \det S
T T^* = (\det T) \mathbf{I}
T^* T = (\det T) \mathbf{I}
R^T R = \mathbf{I}
R (a \times b) = (R a) \times (R b)
R \tilde{a} R^T = \widetilde{R a}
\operatorname{vect} T \times a = \operatorname{skew} T a
\operatorname{vect}(a \otimes b) = -\frac{1}{2} a \times b
\operatorname{sym} T + \operatorname{skew} T = T
\operatorname{trace} \tilde{a} = 0 f
(a, b, x) = (b, x, a)
(a, b, x) = a \cdot (b \times x)
(a \times b)^2 = a^2 b^2 - (a \cdot b)^2
u^2 = 1
u \cdot \dot{u} = 0 f
\frac{d}{dt}(a \cdot b) = \dot{a} \cdot b + a \cdot \dot{b}
\frac{d}{dt}(T a) = \dot{T} a + T \dot{a}
\frac{d}{dt}(T S) = \dot{T} S + T \dot{S}
\frac{d^2}{dt^2}(f a) = \ddot{f} a + 2 \dot{f} \dot{a} + f \ddot{a}
\dot{R} R^T = -R \dot{R}^T
\sin^2 \alpha + \cos^2 \alpha = 1
\frac{d}{dt} \sin \alpha = \dot{\alpha} \cos \alpha
\frac{f + g}{f} = 1 + \frac{g}{f}
\frac{d}{dt} \frac{f}{g} = \frac{\dot{f} g - f \dot{g}}{g^2}
f^3 - g^3 = (f - g)(f^2 + f g + g^2)
\tilde{a} T + T^T \tilde{a} + \tilde{a}^T \mathbf{I} = \tilde{a} T + T^T \tilde{a} - \tilde{a}
\operatorname{Du}(\underline{a} \cdot \underline{b}) = \operatorname{Re} \underline{a} \cdot \operatorname{Du} \underline{b} + \operatorname{Du} \underline{a} \cdot \operatorname{Re} \underline{b}
\underline{a} \times \underline{b} = -\underline{b} \times \underline{a}
(a \otimes b) T = a \otimes (T^T b)
\dot{c} = 0 c
\sin \alpha = 2 \sin \frac{\alpha}{2} \cos \frac{\alpha}{2}
\cos \frac{\alpha}{3} = 4 \cos^3 \frac{\alpha}{9} - 3 \cos \frac{\alpha}{9}
\frac{d}{dt} \sin \frac{\alpha}{2} = \frac{1}{2} \dot{\alpha} \cos \frac{\alpha}{2}
\tan \alpha \cos \alpha = \sin \alpha
\frac{1}{\cos^2 \alpha} = 1 + \tan^2 \alpha
\|q\| = \sqrt{(\operatorname{Sc} q)^2 + \operatorname{Vec} q \cdot \operatorname{Vec} q}
\frac{d}{dt} (\sqrt{f^2 + g^2}) \sqrt{f^2 + g^2} = f \dot{f} + g \dot{g}
(p q) r = p (q r)
(p + q) r = p r + q r
(p q)^* = q^* p^*
(p q)^{-1} = q^{-1} p^{-1}
q q^* = \|q\|^2
\|p q\|^2 = \|p\|^2 \|q\|^2
\operatorname{quat}(f, a) \operatorname{quat}(g, b) = \operatorname{quat}(f g - a \cdot b, f b + g a + a \times b)
q = \begin{bmatrix} \operatorname{Sc} q \\ \operatorname{Vec} q \end{bmatrix}
\operatorname{Sc} (p q) = \operatorname{Sc} (q p)
\operatorname{Vec} (q a q^*) \cdot \operatorname{Vec} (q b q^*) = \|q\|^4 (a \cdot b)
\frac{d}{dt}(p q) = \dot{p} q + p \dot{q}
e^* = e^{-1}
\operatorname{Sc} (\dot{e} e^*) = 0 f
\dot{e} e^* = -e (\dot{e})^*
\operatorname{Vec} (e a e^*) \times \operatorname{Vec} (e b e^*) = \operatorname{Vec} (e (a \times b) e^*)
\underline{e} \, \underline{e}^* = 1
(\underline{q} p)^* = p^* \underline{q}^*
p^3 = p p^2
J^T = J
L^T = L
\dot{J} = \dot{J}^T
a \cdot (J b) = b \cdot (J a)
\operatorname{trace} (J \tilde{a}) = 0 f
\det H = 1
H^{-1} \dot{H} + \frac{d}{dt} (H^{-1}) H = 0 H
M V \cdot W = V \cdot (M^T W)
N^T = (\mathbf{I} N)^T
\frac{d}{dt} (M V) = \dot{M} V + M \dot{V}
\operatorname{trace} (V W^T) = V \cdot W
V^2 W = (V \cdot V) W
\begin{bmatrix} \cos \alpha & -\sin \alpha \\ \sin \alpha & \cos \alpha \end{bmatrix} \begin{bmatrix} \cos \alpha & \sin \alpha \\ -\sin \alpha & \cos \alpha \end{bmatrix} = \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}
\begin{bmatrix} 0 & -f & g \\ f & 0 & -s_1 \\ -g & s_1 & 0 \end{bmatrix} a = \begin{bmatrix} s_1 \\ g \\ f \end{bmatrix} \times a
\begin{bmatrix} f & g \\ s_1 & s_2 \end{bmatrix} \begin{bmatrix} a \\ b \end{bmatrix} = \begin{bmatrix} f a + g b \\ s_1 a + s_2 b \end{bmatrix}
\det \begin{bmatrix} f & g \\ s_1 & s_2 \end{bmatrix} = f s_2 - g s_1
\dot{A} = \frac{\partial A}{\partial y} \dot{y} + \frac{\partial A}{\partial z} \dot{z}
\dot{C} = \frac{\partial C}{\partial w} \dot{w} + \frac{\partial C}{\partial t}
\dot{D} = \frac{\partial D}{\partial w} \dot{w}
\frac{\partial \dot{A}}{\partial y} = \frac{d}{dt} \frac{\partial A}{\partial y}
\frac{\partial \dot{B}}{\partial \dot{y}} = \frac{\partial B}{\partial y}
\frac{d}{dt} \frac{\partial \dot{A}}{\partial \dot{z}} = \frac{\partial \dot{A}}{\partial z}
\frac{\partial \ddot{B}}{\partial \dot{y}} = 2 \frac{\partial \dot{B}}{\partial y}
\frac{\partial (A \sin \theta)}{\partial \theta} = A \cos \theta
\frac{\partial (B \cos \theta)}{\partial \theta} = \frac{\partial B}{\partial \theta} \cos \theta - B \sin \theta
\frac{\partial}{\partial \theta} \sin \frac{\theta}{2} = \frac{1}{2} \cos \frac{\theta}{2}
\frac{\partial (C D)}{\partial w} = D \frac{\partial C}{\partial w} + C \frac{\partial D}{\partial w}
\frac{\partial (w \cdot w)}{\partial w} = 2 w^T
\frac{\partial (w \times D)}{\partial w} = \tilde{w} \frac{\partial D}{\partial w} - \tilde{D}
\frac{\partial \|w\|}{\partial w} \|w\| = w^T
\frac{d}{dt} (t a) = a + t \dot{a}
\frac{d}{dt} \sin(\omega t + \alpha) = (\omega + \dot{\alpha}) \cos(\omega t + \alpha)
\cos(f g + \alpha) = \cos(f g) \cos \alpha - \sin(f g) \sin \alpha
\sin(f g) = 2 \sin \frac{f g}{2} \cos \frac{f g}{2}
\frac{\partial}{\partial y} \cos(\omega y) = -\omega \sin(\omega y)
\frac{\partial}{\partial y} \sin A = \frac{\partial A}{\partial y} \cos A
\exp(\tilde{a}) a = a
\exp(\tilde{a}) (\exp(\tilde{a}))^T = \mathbf{I}
\exp(\alpha \tilde{u}) = \mathbf{I} + \sin \alpha \tilde{u} + (1 - \cos \alpha) \tilde{u}^2
\exp(\tilde{a}) \exp(2 \tilde{a}) = \exp(3 \tilde{a})
\det \exp(\tilde{a}) = 1
\exp(\tilde{a}) \tilde{b} (\exp(\tilde{a}))^T = \widetilde{\exp(\tilde{a}) b}
\|a\|^2 \exp(\tilde{a}) = a^2 \mathbf{I} + \|a\| \sin(\|a\|) \tilde{a} + (1 - \cos(\|a\|)) \tilde{a}^2
\exp(\alpha \operatorname{quat}(0, u)) = \cos \alpha + u \sin \alpha
\|\exp(\operatorname{quat}(0, a))\| = 1
\exp(\operatorname{quat}(0, \frac{a}{2})) b (\exp(\operatorname{quat}(0, \frac{a}{2})))^* = \operatorname{quat}(0, \exp(\tilde{a}) b)
(\exp(\operatorname{quat}(0, a)))^* = \exp(-\operatorname{quat}(0, a))
\frac{d}{dt} \exp(\alpha \tilde{u}) = \dot{\alpha} \tilde{u} \exp(\alpha \tilde{u}) + \sin \alpha \tilde{\dot{u}} + (1 - \cos \alpha) (\tilde{\dot{u}} \tilde{u} + \tilde{u} \tilde{\dot{u}})
\begin{bmatrix} J & \tilde{a} \\ -\tilde{a} & L \end{bmatrix}^T = \begin{bmatrix} J & \tilde{a} \\ -\tilde{a} & L \end{bmatrix}
""".strip().splitlines()  # fmt: skip
