"""Notations of every kind with identities in them, which tests transform and mutate; true as they stand."""

from __future__ import annotations

from evaluator.fields import DUAL_QUATERNIONS, DUAL_ROOTS, NABLA
from evaluator.kit import Kit, lines
from evaluator.rigid_motions import SCREWS, TWISTS

SMALL = Kit(
    r"""
[symbols]
'\theta' = { kind = "scalar", small = true }
'\phi' = { kind = "scalar", small = true }
'\delta' = { kind = "vector", small = true }
a = "scalar"
b = "scalar"
'\alpha' = "scalar"
u = { kind = "vector", unit = true }
v = "vector"
w = "vector"
R = "rotation"
T = "tensor"
p = "hamilton quaternion"
""",
    lines(r"""
\sin\theta \approx \theta
\cos\theta \approx 1
\tan\theta \approx \sin\theta
\exp(\tilde{\delta}) \approx \mathbf{I} + \tilde{\delta}
R \exp(\tilde{\delta}) v \approx R v + R (\delta \times v)
\sin(\alpha + \theta) \approx \sin\alpha + \theta \cos\alpha
\cos(\alpha - \phi) \approx \cos\alpha + \phi \sin\alpha
\sin\frac{\alpha + \theta}{2} \approx \sin\frac{\alpha}{2} + \frac{\theta}{2} \cos\frac{\alpha}{2}
\frac{1}{1 + \theta} \approx 1 - \theta
\frac{a}{b + \phi} \approx \frac{a}{b} - \frac{a}{b^2} \phi
(a + \theta)^2 \approx a^2 + 2 a \theta
(a + \theta)^3 \approx a^3 + 3 a^2 \theta
(v + \delta) \cdot (v + \delta) \approx v \cdot v + 2 v \cdot \delta
(v + \delta) \times (w + \delta) \approx v \times w + v \times \delta + \delta \times w
\exp(\theta \tilde{u}) v \approx v + \theta u \times v
\frac{d}{dt} (\theta^2 + \theta a) \approx \dot{\theta} a + \theta \dot{a}
\frac{d}{dt} \sin(\alpha + \theta) \approx \dot{\alpha} \cos\alpha + \dot{\theta} \cos\alpha - \theta \dot{\alpha} \sin\alpha
(\mathbf{I} + \tilde{\delta})^T (\mathbf{I} + \tilde{\delta}) \approx \mathbf{I} + \theta \tilde{\delta}
\operatorname{quat}(1, \frac{1}{2} \delta) v (\operatorname{quat}(1, \frac{1}{2} \delta))^* \approx \operatorname{quat}(0, v + \delta \times v)
\exp(\operatorname{quat}(0, \frac{1}{2} \delta)) \approx \operatorname{quat}(1, \frac{1}{2} \delta)
\det(\mathbf{I} + \theta T) \approx 1 + \theta \operatorname{trace} T
(\mathbf{I} + \tilde{\delta})^{-1} \approx \mathbf{I} - \tilde{\delta}
\theta \phi v \approx \theta \phi w + 0 v
\exp(\tilde{\delta}) T (\exp(\tilde{\delta}))^T \approx T + \tilde{\delta} T - T \tilde{\delta}
\tan(\alpha + \theta) \approx \tan\alpha + \frac{\theta}{\cos^2 \alpha}
"""),
)

SUMS = Kit(
    r"""
[symbols]
f_n = "scalar"
g_n = "scalar"
a_n = "vector"
b_n = "vector"
T_n = "tensor"
q_n = "hamilton quaternion"
v = "vector"
s = "scalar"
c = { kind = "scalar", constant = true }
S = "tensor"
""",
    lines(r"""
\sum_{i=1}^{n} (f_i + g_i) = \sum_{i=1}^{n} f_i + \sum_{i=1}^{n} g_i
\sum_{i=1}^{n} f_i (a_i \times b_i) = -\sum_{i=1}^{n} b_i \times (f_i a_i) + \sum_{i=1}^{n} 0 a_i
S \sum_{i=1}^{n} a_i = \sum_{i=1}^{n} S a_i
v \times \sum_{i=1}^{n} f_i a_i = -\left(\sum_{i=1}^{n} f_i a_i\right) \times v
\frac{d}{dt} \sum_{i=1}^{n} f_i a_i = \sum_{i=1}^{n} (\dot{f}_i a_i + f_i \dot{a}_i)
\sum_{i=1}^{n} a_i \times (v \times a_i) = \sum_{i=1}^{n} ((a_i \cdot a_i) v - (a_i \cdot v) a_i)
\operatorname{trace} \sum_{i=1}^{n} a_i \otimes b_i = \sum_{i=1}^{n} a_i \cdot b_i
\left(\sum_{i=1}^{n} f_i a_i \otimes b_i\right)^T = \sum_{i=1}^{n} f_i b_i \otimes a_i
-\sum_{i=1}^{n} f_i \tilde{a}_i \tilde{a}_i v = \sum_{i=1}^{n} f_i ((a_i \cdot a_i) v - (a_i \cdot v) a_i)
\sum_{i=0}^{n} s f_i = s \sum_{i=0}^{n} f_i
\sum_{i=1}^{n} f_i a_i + \sum_{i=1}^{n} g_i a_i = \sum_{i=1}^{n} (f_i + g_i) a_i
\sum_{k=0}^{3} f_k a_k = f_0 a_0 + f_1 a_1 + f_2 a_2 + f_3 a_3
\sum_{i=1}^{n} T_i v = \left(\sum_{i=1}^{n} T_i\right) v
\sum_{i=1}^{n} (q_i)^* = \left(\sum_{i=1}^{n} q_i\right)^*
\frac{d^2}{dt^2} \sum_{i=1}^{n} c f_i = c \sum_{i=1}^{n} \ddot{f}_i
\operatorname{vect} \sum_{i=1}^{n} a_i \otimes b_i = -\frac{1}{2} \sum_{i=1}^{n} a_i \times b_i
\widetilde{\sum_{i=1}^{n} a_i} v = \sum_{i=1}^{n} a_i \times v
\sum_{k=1}^{4} (f_{k+1} - f_k) = f_5 - f_1
\sum_{i=1}^{2} \sum_{j=1}^{2} f_i g_j = (f_1 + f_2) (g_1 + g_2)
"""),
)
EXPONENTIALS = Kit(
    r"""
[symbols]
f = "scalar"
g = "scalar"
a = "vector"
'\omega' = { kind = "scalar", constant = true }
y = "scalar"
z = "scalar"
A = { kind = "scalar", of = ["y", "z"] }
""",
    lines(r"""
e^{f + g} = e^f e^g
e^{f} e^{-f} = 1
\frac{d}{dt} e^{2 f} = 2 \dot{f} e^{2 f}
(e^{f})^2 = e^{2 f}
\frac{d^2}{dt^2} e^{f} = (\ddot{f} + \dot{f}^2) e^f
\frac{d}{dt} (e^{f g} a) = e^{f g} (\dot{a} + (\dot{f} g + f \dot{g}) a)
\frac{d}{dt} e^{-\omega t} = -\omega e^{-\omega t}
e^{\frac{f}{2}} e^{\frac{f}{2}} = e^{f}
\frac{e^{f}}{e^{g}} = e^{f - g}
(e^{f} + e^{-f})^2 - (e^{f} - e^{-f})^2 = 4
\frac{d}{dt} \frac{1}{1 + e^{-f}} = \dot{f} \frac{e^{-f}}{(1 + e^{-f})^2}
\frac{\partial}{\partial y} e^{2 y} = 2 e^{2 y}
\frac{\partial}{\partial y} e^{A} = \frac{\partial A}{\partial y} e^{A}
\frac{\partial}{\partial z} (y e^{y z}) = y^2 e^{y z}
\frac{\partial}{\partial y} \frac{1}{1 + e^{-y}} = \frac{e^{-y}}{(1 + e^{-y})^2}
\frac{d}{dt} (\frac{\partial}{\partial y} e^{\omega y}) = \omega^2 \dot{y} e^{\omega y}
\frac{d}{dt} (e^{-\omega t} \sin f) = e^{-\omega t} (\dot{f} \cos f - \omega \sin f)
"""),
)

JACOBIANS = Kit(
    r"""
[symbols]
x = "vector"
v = "vector"
w = "vector"
[definitions]
E = '\exp(\tilde{x})'
J = '\mathbf{I} + \frac{1 - \cos\|x\|}{\|x\|^2} \tilde{x} + \frac{\|x\| - \sin\|x\|}{\|x\|^3} \tilde{x}^2'
K = '\mathbf{I} - \frac{1 - \cos\|x\|}{\|x\|^2} \tilde{x} + \frac{\|x\| - \sin\|x\|}{\|x\|^3} \tilde{x}^2'
L = '\mathbf{I} - \frac{1}{2} \tilde{x} + \left(\frac{1}{\|x\|^2} - \frac{1 + \cos\|x\|}{2 \|x\| \sin\|x\|}\right) \tilde{x}^2'
""",
    lines(r"""
J = E K
J x = x
K x = E x
\dot{E} = \widetilde{J \dot{x}} E
\dot{E} = E \widetilde{K \dot{x}}
J^T = K
J K = K J
\operatorname{vect}(\dot{E} E^T) = J \dot{x}
E = \mathbf{I} + \tilde{x} J
E = \mathbf{I} + J \tilde{x}
E^T J = K
J v - K v = 2 \frac{1 - \cos\|x\|}{\|x\|^2} x \times v
L J = \mathbf{I}
L x = x
E (v \times w) = (E v) \times (E w)
E \dot{x} = \dot{x} + x \times (J \dot{x})
\det E = 1
\operatorname{trace} E = 1 + 2 \cos\|x\|
\operatorname{vect} E = \frac{\sin\|x\|}{\|x\|} x
"""),
)

QUATERNIONS = Kit(
    r"""
[conventions]
quaternion = "hamilton, scalar first"
[symbols]
p = "quaternion"
q = "quaternion"
e = { kind = "quaternion", unit = true }
a = "vector"
b = "vector"
u = { kind = "vector", unit = true }
'\alpha' = "scalar"
f = "scalar"
[definitions]
s = '\operatorname{Sc} e'
x = '\operatorname{Vec} e'
C = '(s^2 - x \cdot x) \mathbf{I} + 2 x \otimes x + 2 s \tilde{x}'
w = '2 \operatorname{Vec}(\dot{e} e^*)'
o = '2 \operatorname{Vec}(e^* \dot{e})'
""",
    lines(r"""
C a = \operatorname{Vec}(e a e^*)
C^T C = \mathbf{I}
\det C = 1
\dot{e} = \frac{1}{2} w e
\dot{e} = \frac{1}{2} e o
\operatorname{vect}(\dot{C} C^T) = w
w = C o
\ddot{e} = \frac{1}{2} \dot{w} e - \frac{1}{4} (w \cdot w) e
\|\dot{e}\|^2 = \frac{1}{4} w \cdot w
p q + q p = 2 \operatorname{quat}(\operatorname{Sc}(p) \operatorname{Sc}(q) - \operatorname{Vec}(p) \cdot \operatorname{Vec}(q), \operatorname{Sc}(p) \operatorname{Vec}(q) + \operatorname{Sc}(q) \operatorname{Vec}(p))
p q - q p = \operatorname{quat}(0, 2 \operatorname{Vec}(p) \times \operatorname{Vec}(q))
\begin{bmatrix} \operatorname{Sc} p & -(\operatorname{Vec} p)^T \\ \operatorname{Vec} p & \operatorname{Sc}(p) \mathbf{I} + \operatorname{skew}(\operatorname{Vec} p) \end{bmatrix} q = p q
\begin{bmatrix} \operatorname{Sc} p & -(\operatorname{Vec} p)^T \\ \operatorname{Vec} p & \operatorname{Sc}(p) \mathbf{I} - \operatorname{skew}(\operatorname{Vec} p) \end{bmatrix} q = q p
\frac{d}{dt} (q^{-1}) = -q^{-1} \dot{q} q^{-1}
\frac{d}{dt} (q^*) = (\dot{q})^*
(\cos\frac{\alpha}{2} + u \sin\frac{\alpha}{2}) a (\cos\frac{\alpha}{2} - u \sin\frac{\alpha}{2}) = \operatorname{quat}(0, \cos\alpha a + \sin\alpha u \times a + (1 - \cos\alpha) (u \cdot a) u)
\operatorname{quat}(0, a) \operatorname{quat}(0, b) = \operatorname{quat}(-a \cdot b, a \times b)
q^2 = 2 \operatorname{Sc}(q) q - \|q\|^2
e^* (C a) e = \operatorname{quat}(0, a)
"""),
)

ANGLES = Kit(
    r"""
[symbols]
f = "scalar"
g = "scalar"
'\alpha' = "scalar"
'\beta' = "scalar"
a = "vector"
b = "vector"
""",
    lines(r"""
\sec^2 \alpha = 1 + \tan^2 \alpha
\cot \alpha \tan \alpha = 1
\csc \alpha \sin \alpha = 1
\sin(\alpha + \beta) = \sin\alpha \cos\beta + \cos\alpha \sin\beta
\cos(\alpha - \beta) = \cos\alpha \cos\beta + \sin\alpha \sin\beta
\sin 3 \alpha = 3 \sin\alpha - 4 \sin^3 \alpha
\tan(\alpha + \beta) = \frac{\tan\alpha + \tan\beta}{1 - \tan\alpha \tan\beta}
\frac{d}{dt} \tan\alpha = \frac{\dot{\alpha}}{\cos^2 \alpha}
\frac{d}{dt} \cot\alpha = -\dot{\alpha} \csc^2 \alpha
\cos^2 \frac{\alpha}{2} = \frac{1 + \cos\alpha}{2}
2 \sin\frac{\alpha + \beta}{2} \cos\frac{\alpha - \beta}{2} = \sin\alpha + \sin\beta
\left(\sqrt{f^2 + g^2}\right)^2 = f^2 + g^2
\frac{d}{dt} ((f^2 + 1)^{1/2}) = f \dot{f} (f^2 + 1)^{-1/2}
\frac{d}{dt} \frac{1}{\sqrt{f^2 + g^2}} = -\frac{f \dot{f} + g \dot{g}}{(f^2 + g^2)^{3/2}}
\frac{d}{dt} \|a\| = \frac{a \cdot \dot{a}}{\|a\|}
\frac{d}{dt} \frac{a}{\|a\|} = \frac{a \times (\dot{a} \times a)}{\|a\|^3}
\|a \times b\|^2 = \|a\|^2 \|b\|^2 - (a \cdot b)^2
\|a + b\|^2 + \|a - b\|^2 = 2 \|a\|^2 + 2 \|b\|^2
\sin(f t) = 2 \sin\frac{f t}{2} \cos\frac{f t}{2}
\frac{d}{dt} \cos(f t) = -(\dot{f} t + f) \sin(f t)
\begin{bmatrix} \cos\alpha & -\sin\alpha \\ \sin\alpha & \cos\alpha \end{bmatrix}^{-1} = \begin{bmatrix} \cos\alpha & \sin\alpha \\ -\sin\alpha & \cos\alpha \end{bmatrix}
"""),
)

ORIENTED = Kit(
    r"""
[symbols]
a = "vector"
b = "vector"
c = "vector"
n = "vector"
f = "scalar"
T = "tensor"
""",
    lines(r"""
a \times (n \times c) = (a \cdot c) n \text{ for } a \perp n
(a \cdot b) a = (a \cdot a) b \text{ for } a \parallel b
(a \cdot b)^2 = a^2 b^2 \text{ for } a \parallel b
(a + n)^2 = a^2 + n^2 \text{ for } a \perp n
\|a - n\|^2 = \|a\|^2 + \|n\|^2 \text{ for } a \perp n
\tilde{n} \tilde{n} a = -n^2 a \text{ for } a \perp n
(a \times c) \cdot b = 0 f \text{ for } a \parallel b
a \otimes b = b \otimes a \text{ for } a \parallel b
\tilde{a} \tilde{b} = \tilde{b} \tilde{a} \text{ for } a \parallel b
(a \times n)^2 = a^2 n^2 \text{ for } a \perp n
\operatorname{trace}(a \otimes n + T) = \operatorname{trace} T \text{ for } a \perp n
a \times c = \frac{a \cdot b}{b \cdot b} b \times c \text{ for } a \parallel b
"""),
    supposing={"b": "f a", "n": r"a \times c"},
)

CONDITIONS = Kit(
    r"""
[symbols]
f = "scalar"
g = "scalar"
x = "scalar"
y = "scalar"
h = "scalar"
a = "vector"
b = "vector"
c = "vector"
u = "vector"
T = "tensor"
S = "tensor"
U = "tensor"
R = "rotation"
""",
    lines(r"""
f^2 g = f \text{ for } f g = 1
(f + g)^2 = f^2 + g^2 + 2 \text{ for } f g = 1
\frac{1}{f} + \frac{1}{g} = f + g \text{ for } f g = 1
(x^2 - y^2)^2 + 4 x^2 y^2 = 1 \text{ for } x^2 + y^2 = 1
x^4 - y^4 = x^2 - y^2 \text{ for } x^2 + y^2 = 1
\frac{x}{1 - y} = \frac{1 + y}{x} \text{ for } x^2 + y^2 = 1
T^{-1} = T^T \text{ for } T^T T = \mathbf{I}
(T a) \cdot (T b) = a \cdot b \text{ for } T^T T = \mathbf{I}
T (a \times b) = \det(T) (T a) \times (T b) \text{ for } T^T T = \mathbf{I}
a \cdot (S b) = b \cdot (S a) \text{ for } S = S^T
\operatorname{vect}(S + \tilde{a}) = a \text{ for } S = S^T
a \times b = b \times c \text{ for } a + b + c = 0
a^2 - b^2 = c \cdot (b - a) \text{ for } a + b + c = 0
(a, b, c) = 0 f \text{ for } a + b + c = 0
u \times (u \times b) = (u \cdot b) u - b \text{ for } \|u\| = 1
(\tilde{u})^3 = -\tilde{u} \text{ for } \|u\| = 1
U^2 = U \text{ for } U = u \otimes u, \|u\| = 1
"""),
    supposing={
        "g": r"\frac{1}{f}",
        "x": r"\frac{1 - h^2}{1 + h^2}",
        "y": r"\frac{2 h}{1 + h^2}",
        "T": "-R",
        "S": r"a \otimes b + b \otimes a + h \mathbf{I}",
        "c": "-a - b",
        "u": r"R \frac{b}{\|b\|}",
        "U": r"u \otimes u",
    },
)

SLOPES = Kit(
    r"""
[conventions]
gradient = "column"
[symbols]
y = "scalar"
z = "scalar"
w = "vector"
'\theta' = "scalar"
A = { kind = "scalar", of = ["y", "z"] }
B = { kind = "vector", of = ["y", '\theta'] }
C = { kind = "scalar", of = ["w", "t"] }
D = { kind = "vector", of = ["w"] }
F = { kind = "scalar", of = ["y"] }
T = { kind = "tensor", constant = true }
""",
    lines(r"""
\dot{A} = \frac{\partial A}{\partial y} \dot{y} + \frac{\partial A}{\partial z} \dot{z}
\dot{C} = \frac{\partial C}{\partial w} \cdot \dot{w} + \frac{\partial C}{\partial t}
\dot{D} = \frac{\partial D}{\partial w} \dot{w}
\frac{\partial (w \cdot w)}{\partial w} = 2 w
\frac{\partial (w \cdot (T w))}{\partial w} = (T + T^T) w
\frac{\partial (T w)}{\partial w} = T
\frac{\partial \dot{A}}{\partial \dot{y}} = \frac{\partial A}{\partial y}
\frac{\partial (A F)}{\partial y} = F \frac{\partial A}{\partial y} + A \frac{\partial F}{\partial y}
\frac{\partial (C D)}{\partial w} = D \otimes \frac{\partial C}{\partial w} + C \frac{\partial D}{\partial w}
\frac{\partial \|w\|}{\partial w} = \frac{w}{\|w\|}
\frac{\partial}{\partial y} \frac{1}{F} = -\frac{1}{F^2} \frac{\partial F}{\partial y}
\frac{\partial}{\partial y} \sin(y \theta) = \theta \cos(y \theta)
\frac{dF}{dy} \dot{y} = \dot{F}
\frac{\partial (B \cdot B)}{\partial \theta} = 2 B \cdot \frac{\partial B}{\partial \theta}
\frac{\partial \dot{C}}{\partial \dot{w}} = \frac{\partial C}{\partial w}
\frac{d}{dt} \frac{\partial (\dot{y}^2 \theta)}{\partial \dot{y}} = 2 \ddot{y} \theta + 2 \dot{y} \dot{\theta}
\frac{\partial (\tilde{w} D)}{\partial w} = \tilde{w} \frac{\partial D}{\partial w} - \tilde{D}
\frac{\partial}{\partial y} \sqrt{y^2 + z^2} = \frac{y}{\sqrt{y^2 + z^2}}
"""),
)

FRAMES = Kit(
    r"""
[frames]
base = "N"
names = ["A", "B"]
dot = "N"
'{}^F\omega^G' = "angular velocity of G in F"
'{}^F\alpha^G' = "angular acceleration of G in F"
'{}^F R^G' = "rotation to F from G"
[points]
names = ["O", "P", "Q"]
fixed = { O = "N", Q = "B" }
'r^{P/O}' = "to P from O"
'{}^F v^P' = "velocity of P in F"
'{}^F a^P' = "acceleration of P in F"
[symbols]
x = "vector"
f = "scalar"
""",
    lines(r"""
\frac{{}^A d x}{dt} = \frac{{}^B d x}{dt} + {}^A\omega^B \times x
{}^N\omega^B = {}^N\omega^A + {}^A\omega^B
{}^A\omega^B = -{}^B\omega^A
{}^N R^B = {}^N R^A {}^A R^B
{}^B R^A = ({}^A R^B)^T
r^{P/O} = -r^{O/P}
r^{P/Q} = r^{P/O} - r^{Q/O}
{}^N v^P = {}^B v^P + {}^N v^Q + {}^N\omega^B \times r^{P/Q}
{}^N v^Q = \dot{r}^{Q/O}
{}^A\alpha^B = \frac{{}^B d {}^A\omega^B}{dt}
{}^A\alpha^B = \frac{{}^A d {}^A\omega^B}{dt}
{}^N a^P = {}^B a^P + {}^N a^Q + {}^N\alpha^B \times r^{P/Q} + {}^N\omega^B \times ({}^N\omega^B \times r^{P/Q}) + 2 {}^N\omega^B \times {}^B v^P
{}^N a^P = \frac{{}^N d {}^N v^P}{dt}
\frac{{}^A d}{dt} (f x) = \dot{f} x + f \frac{{}^A d x}{dt}
\dot{x} = \frac{{}^B d x}{dt} + {}^N\omega^B \times x
\frac{{}^A d (x \times r^{P/O})}{dt} = \frac{{}^A d x}{dt} \times r^{P/O} + x \times \frac{{}^A d r^{P/O}}{dt}
{}^B a^P = \frac{{}^B d {}^B v^P}{dt}
{}^N\alpha^B = {}^N\alpha^A + {}^A\alpha^B + {}^N\omega^A \times {}^A\omega^B
\det {}^A R^B = 1
"""),
    places={"O": "", "P": r"\mathsf{p}_{P}", "Q": r"\mathsf{o}_{B}"},
)

HOMOGENEOUS = Kit(
    r"""
[conventions]
points = "homogeneous"
[frames]
base = "U"
names = ["A", "B", "C"]
'{}^F_G R' = "rotation to F from G"
'{}^F_G T' = "transform to F from G"
'{}^F P_{XORG}' = "origin of X in F"
[points]
names = ["P"]
'{}^F P' = "place of P in F"
""",
    lines(r"""
{}^A P = {}^A_B R\, {}^B P + {}^A P_{BORG}
{}^A_B T = {}^A_C T\, {}^C_B T
{}^B_A T = {}^A_B T^{-1}
{}^B_A T = \begin{bmatrix} {}^A_B R^T & -{}^A_B R^T {}^A P_{BORG} \\ 0 & 1 \end{bmatrix}
{}^A_C R = {}^A_B R\, {}^B_C R
{}^A P = {}^A_B T\, {}^B P
{}^A P = {}^A_B T\, {}^B_C T\, {}^C P
{}^A P_{CORG} = {}^A_B R\, {}^B P_{CORG} + {}^A P_{BORG}
{}^A P_{BORG} = -{}^A_B R\, {}^B P_{AORG}
{}^U P = {}^U_A T\, {}^A P
\det {}^A_B T = 1
"""),
    places={"P": r"\mathsf{p}_{P}"},
)

KITS = {
    "small": SMALL, "sums": SUMS, "exponentials": EXPONENTIALS, "jacobians": JACOBIANS, "twists": TWISTS,
    "screws": SCREWS,
    "quaternions": QUATERNIONS, "angles": ANGLES, "oriented": ORIENTED, "conditions": CONDITIONS, "slopes": SLOPES, "frames": FRAMES,
    "homogeneous": HOMOGENEOUS, "nabla": NABLA, "dual roots": DUAL_ROOTS, "dual quaternions": DUAL_QUATERNIONS,
}  # fmt: skip
