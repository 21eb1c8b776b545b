"""Fields under ∇, roots and norms of dual numbers, dual quaternions: each with identities that are true."""

from __future__ import annotations

from evaluator.kit import Kit, lines

NABLA = Kit(
    r"""
[conventions]
gradient = "column"
[symbols]
'\rho' = { kind = "vector", coordinate = true }
F = { kind = "scalar", of = ['\rho'] }
G = { kind = "scalar", of = ['\rho'] }
H = { kind = "scalar", of = ['\rho', "t"] }
W = { kind = "vector", of = ['\rho'] }
Z = { kind = "vector", of = ['\rho'] }
w = { kind = "vector", uniform = true }
s = { kind = "scalar", uniform = true }
M = { kind = "tensor", uniform = true }
""",
    lines(r"""
\nabla (F G) = G \nabla F + F \nabla G
\nabla \cdot (F W) = W \cdot (\nabla F) + F \nabla \cdot W
\nabla \times (F W) = F \nabla \times W - W \times (\nabla F)
\nabla \cdot (W \times Z) = Z \cdot (\nabla \times W) - W \cdot (\nabla \times Z)
\nabla \times (W \times Z) = (\nabla \cdot Z) W - (\nabla \cdot W) Z + (Z \cdot \nabla) W - (W \cdot \nabla) Z
\nabla (W \cdot Z) = (W \cdot \nabla) Z + (Z \cdot \nabla) W + W \times (\nabla \times Z) + Z \times (\nabla \times W)
\nabla \times (\nabla F) = 0 w
\nabla \cdot (\nabla \times W) = 0 s
\nabla^2 (F G) = G \nabla^2 F + F \nabla^2 G + 2 (\nabla F) \cdot (\nabla G)
\nabla \cdot (F \nabla G - G \nabla F) = F \nabla^2 G - G \nabla^2 F
\nabla \cdot (\nabla F \times \nabla G) = 0 s
\nabla (w \cdot \rho) = w
\nabla (\rho \cdot \rho) = 2 \rho
\nabla \|\rho\| = \frac{\rho}{\|\rho\|}
\nabla \cdot (M \rho) = \operatorname{trace} M
\nabla \times (M \rho) = 2 \operatorname{vect} M
\nabla \times (w \times \rho) = 2 w
(w \cdot \nabla) \rho = w
(w \cdot \nabla) (F \rho) = (w \cdot \nabla F) \rho + F w
(\rho \cdot \nabla) (\rho \cdot \rho) = 2 \rho \cdot \rho
\nabla \frac{1}{F} = -\frac{1}{F^2} \nabla F
\nabla \sqrt{1 + F^2} = \frac{F}{\sqrt{1 + F^2}} \nabla F
\nabla \sin F = \cos F \nabla F
\nabla (s F) = s \nabla F
\nabla^2 (\rho \cdot (M \rho)) = 2 \operatorname{trace} M
\nabla^2 \frac{1}{\|\rho\|} = 0 s
\dot{F} = \dot{\rho} \cdot (\nabla F)
\dot{H} = \dot{\rho} \cdot (\nabla H) + \frac{\partial H}{\partial t}
\dot{W} = (\dot{\rho} \cdot \nabla) W
(W \cdot \nabla) W = \frac{1}{2} \nabla (W \cdot W) - W \times (\nabla \times W)
\operatorname{trace} \frac{\partial (F W)}{\partial \rho} = F \nabla \cdot W + W \cdot \nabla F
\nabla \times (\rho^2 w) = 2 \rho \times w
"""),
)

DUAL_ROOTS = Kit(
    r"""
[symbols]
'\underline{f}' = "dual scalar"
'\underline{g}' = "dual scalar"
'\underline{a}' = "dual vector"
'\underline{b}' = "dual vector"
'\underline{u}' = { kind = "dual vector", unit = true }
'\underline{R}' = "dual rotation"
f = "scalar"
g = "scalar"
a = "vector"
b = "vector"
""",
    lines(r"""
(\sqrt{\underline{f}^2 + 1})^2 = \underline{f}^2 + 1
\sqrt{\underline{f}^2} \sqrt{\underline{g}^2} = \sqrt{\underline{f}^2 \underline{g}^2}
\operatorname{Re} \sqrt{\underline{f}^2 + 1} = \sqrt{(\operatorname{Re} \underline{f})^2 + 1}
\operatorname{Du} \sqrt{\underline{f}^2 + 1} = \frac{(\operatorname{Re} \underline{f}) (\operatorname{Du} \underline{f})}{\sqrt{(\operatorname{Re} \underline{f})^2 + 1}}
\frac{d}{dt} \sqrt{\underline{f}^2 + \underline{g}^2} = \frac{\underline{f} \dot{\underline{f}} + \underline{g} \dot{\underline{g}}}{\sqrt{\underline{f}^2 + \underline{g}^2}}
\sqrt{1 + \varepsilon f} = 1 + \varepsilon \frac{f}{2}
\sqrt{4 + \varepsilon f} = 2 + \varepsilon \frac{f}{4}
\frac{1}{\sqrt{1 + \varepsilon f}} = 1 - \varepsilon \frac{f}{2}
\sqrt{f^2 + 1 + 2 \varepsilon g} = \sqrt{f^2 + 1} + \frac{\varepsilon g}{\sqrt{f^2 + 1}}
(\underline{f}^2 + 1)^{3/2} = (\underline{f}^2 + 1) \sqrt{\underline{f}^2 + 1}
\|\underline{a}\|^2 = \underline{a} \cdot \underline{a}
\|\underline{a}\| = \|\operatorname{Re} \underline{a}\| + \varepsilon \frac{(\operatorname{Re} \underline{a}) \cdot (\operatorname{Du} \underline{a})}{\|\operatorname{Re} \underline{a}\|}
\|a + \varepsilon b\| = \|a\| + \varepsilon \frac{a \cdot b}{\|a\|}
\|\underline{R} \underline{a}\| = \|\underline{a}\|
\|\underline{a} \times \underline{b}\|^2 = \|\underline{a}\|^2 \|\underline{b}\|^2 - (\underline{a} \cdot \underline{b})^2
\frac{d}{dt} \|\underline{a}\| = \frac{\underline{a} \cdot \dot{\underline{a}}}{\|\underline{a}\|}
\frac{d}{dt} \frac{\underline{a}}{\|\underline{a}\|} = \frac{\underline{a} \times (\dot{\underline{a}} \times \underline{a})}{\|\underline{a}\|^3}
\left\|\underline{f}\, \underline{u}\right\| = \left|\underline{f}\right|
\sqrt{\underline{a} \cdot \underline{a}} = \|\underline{a}\|
\frac{\sqrt{\underline{f}^2 + 1} - 1}{\underline{f}^2} = \frac{1}{\sqrt{\underline{f}^2 + 1} + 1}
"""),
)

DUAL_QUATERNIONS = Kit(
    r"""
[symbols]
p = "dual hamilton quaternion"
q = "dual hamilton quaternion"
e = { kind = "dual hamilton quaternion", unit = true }
'\underline{a}' = "dual vector"
'\underline{u}' = { kind = "dual vector", unit = true }
'\underline{\alpha}' = "dual scalar"
r = "hamilton quaternion"
a = "vector"
b = "vector"
[definitions]
w = '2 \operatorname{Vec}(\dot{e} e^*)'
""",
    lines(r"""
(p q)^* = q^* p^*
e^* e = 1
\dot{e} = \frac{1}{2} w e
\operatorname{Sc}(\dot{e} e^*) = 0
(p q)^{-1} = q^{-1} p^{-1}
\frac{d}{dt} (q^{-1}) = -q^{-1} \dot{q} q^{-1}
\varepsilon \operatorname{Du}(p q) = \varepsilon ((\operatorname{Du} p) q + p (\operatorname{Du} q))
\varepsilon q = \varepsilon (q + \varepsilon p)
\|p q\|^2 = \|p\|^2 \|q\|^2
\|e \underline{a} e^*\|^2 = \underline{a} \cdot \underline{a}
e \underline{a} e^* = \underline{a} + 2 (\operatorname{Sc} e) (\operatorname{Vec} e) \times \underline{a} + 2 (\operatorname{Vec} e) \times ((\operatorname{Vec} e) \times \underline{a})
q^2 = 2 (\operatorname{Sc} q) q - q q^*
(\cos\underline{\alpha} + \underline{u} \sin\underline{\alpha}) (\cos\underline{\alpha} - \underline{u} \sin\underline{\alpha}) = 1
\operatorname{quat}(0, a + \varepsilon b) \operatorname{quat}(0, a - \varepsilon b) = \operatorname{quat}(-a \cdot a, -2 \varepsilon a \times b)
p q - q p = \operatorname{quat}(0, 2 (\operatorname{Vec} p) \times (\operatorname{Vec} q))
"""),
)
