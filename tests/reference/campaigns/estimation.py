"""Least squares of the reference campaigns, from the definitions, in the precision of mpmath.

An estimate minimises sum((residual / u)^2) + sum(((p - p0) / s)^2). Derivatives are central differences of order two: with a
step of 10^-30 in 110 digits (kinematics.py) their error is 10^-60. Normal equations lose twice the digits of the condition number, at most 12.
"""

from collections import namedtuple

from mpmath import matrix, mp, mpf, sqrt

from kinematics import apply, norm, product, of_vector, sub, transposed, vector_of

STEP = mpf(10) ** -30
CONVERGED = mpf(10) ** -45
"""Largest last step, in standard uncertainties."""
DEPENDENT = mpf(10) ** -40
"""Distance of a column of unit length from the span of others below which it depends on them."""

Position = namedtuple("Position", "target at u")
Orientation = namedtuple("Orientation", "target rotation u")
Distance = namedtuple("Distance", "target other length u")
Contact = namedtuple("Contact", "target socket u")
KnownDistance = namedtuple("KnownDistance", "one other length u")
Group = namedtuple("Group", "pose joints readings")
"""Readings at the same joint values."""


def point(p, name):
    return [p[f"{name}_{k}"] for k in "xyz"]


def errors(model, p, group, flange=None):
    """Observed minus predicted values of each reading of a group: (reading, list)."""
    if model.dimension == 2:
        at = model.positions(p, group.joints)
        return [(r, sub(r.at, at[r.target])) for r in group.readings]
    found = []
    for r in group.readings:
        if isinstance(r, KnownDistance):
            found.append((r, [r.length - norm(sub(point(p, r.one), point(p, r.other)))]))
            continue
        if isinstance(r, Orientation):
            body = product(flange[0], of_vector([p[f"{r.target}_r{k}"] for k in "xyz"]))
            # the rotation vector from the model to the observation; its size is that of the inverse
            turned = vector_of(product(body, transposed(r.rotation)))
            found.append((r, [-v for v in turned]))
            continue
        at = apply(flange, point(p, r.target))
        if isinstance(r, Position):
            found.append((r, sub(r.at, at)))
        elif isinstance(r, Contact):
            found.append((r, sub(point(p, r.socket), at)))
        else:
            found.append((r, [r.length - norm(sub(at, point(p, r.other)))]))
    return found


def weighted(model, p, group, flange):
    """Residuals over their standard uncertainties."""
    return [-v / r.u for r, e in errors(model, p, group, flange) for v in e]


def has_flange(model, group):
    """False for planar robots and for rows without joints."""
    return model.dimension == 3 and group.joints is not None


def flange_at(model, p, group, in_base=None):
    """Pose of the flange, if there is one."""
    return model.flange(p, group.joints, in_base) if has_flange(model, group) else None


class Problem:
    """Readings in groups, parameters `free` and tolerances `priors` (name to (p0, s))."""

    def __init__(self, model, groups, free, priors=None):
        self.model, self.groups, self.free, self.priors = model, groups, free, priors or {}
        roles = {p.name: p.role for p in model.parameters}
        self.roles = {name: roles[name] for name in free}

    def residuals(self, p):
        return [v for g in self.groups for v in weighted(self.model, p, g, flange_at(self.model, p, g))]

    def prior_residuals(self, p):
        return [(p[n] - p0) / s for n, (p0, s) in self.priors.items() if n in self.free]

    def jacobian(self, p):
        rows = []
        for g in self.groups:
            # what a parameter does not move is not computed again
            in_base = self.model.in_base(p, g.joints) if has_flange(self.model, g) else None
            flange = flange_at(self.model, p, g, in_base)
            columns = []
            for name in self.free:
                ends = []
                for h in (STEP, -STEP):
                    moved = dict(p)
                    moved[name] = p[name] + h
                    there = {"robot": lambda: flange_at(self.model, moved, g), "base": lambda: flange_at(self.model, moved, g, in_base)}
                    there = there.get(self.roles[name], lambda: flange)()
                    ends.append(weighted(self.model, moved, g, there))
                columns.append([(a - b) / (2 * STEP) for a, b in zip(*ends)])
            rows += [list(row) for row in zip(*columns)]
        for n in (n for n in self.priors if n in self.free):
            rows.append([1 / self.priors[n][1] if m == n else mpf(0) for m in self.free])
        return rows


def normal(jacobian):
    columns = list(zip(*jacobian))
    n = len(columns)
    A = [[None] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            A[i][j] = A[j][i] = mp.fdot(columns[i], columns[j])
    return A


def cholesky(A):
    n = len(A)
    L = [[mpf(0)] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            rest = A[i][j] - mp.fdot(L[i][:j], L[j][:j])
            L[i][j] = sqrt(rest) if i == j else rest / L[j][j]
    return L


def solve(L, b):
    n, y = len(b), []
    for i in range(n):
        y.append((b[i] - mp.fdot(L[i][:i], y)) / L[i][i])
    x = [mpf(0)] * n
    for i in reversed(range(n)):
        x[i] = (y[i] - mp.fdot([L[k][i] for k in range(i + 1, n)], x[i + 1 :])) / L[i][i]
    return x


def inverse(L):
    n = len(L)
    columns = [solve(L, [mpf(i == j) for i in range(n)]) for j in range(n)]
    return [[columns[j][i] for j in range(n)] for i in range(n)]


def scaled(jacobian):
    """Columns of unit length, and their lengths."""
    columns = list(zip(*jacobian))
    sizes = [sqrt(mp.fdot(c, c)) for c in columns]
    return sizes, [[v / s if s else v for v, s in zip(row, sizes)] for row in jacobian]


def dependent(jacobian, names):
    """Names of columns that depend on the previous ones (Gram-Schmidt, in the order of `names`)."""
    basis, found = [], []
    for name, column in zip(names, zip(*jacobian)):
        size = sqrt(mp.fdot(column, column))
        rest = [v / size for v in column] if size else list(column)
        for _ in range(2):
            for q in basis:
                along = mp.fdot(q, rest)
                rest = [v - along * w for v, w in zip(rest, q)]
        left = sqrt(mp.fdot(rest, rest))
        if left < DEPENDENT:
            found.append(name)
        else:
            basis.append([v / left for v in rest])
    return found


def minimise(problem, start):
    """Gauss-Newton from `start` to a last step below CONVERGED; returns values, covariance and the Jacobian's scaled rows."""
    p = dict(start)
    for _ in range(60):
        r = problem.residuals(p) + problem.prior_residuals(p)
        sizes, J = scaled(problem.jacobian(p))
        L = cholesky(normal(J))
        step = [-v for v in solve(L, [mp.fdot(c, r) for c in zip(*J)])]
        C = inverse(L)
        longest = max(abs(s) / sqrt(C[i][i]) for i, s in enumerate(step))
        for name, s, size in zip(problem.free, step, sizes):
            p[name] += s / size
        if longest < CONVERGED:
            n = range(len(step))
            return p, [[C[i][j] / sizes[i] / sizes[j] for j in n] for i in n]
    raise ArithmeticError("the search did not end")


def statistics(values):
    """Mean, root mean square and maximum."""
    n = len(values)
    return {"mean": sum(values) / n, "rms": sqrt(sum(v * v for v in values) / n), "max": max(values)}
