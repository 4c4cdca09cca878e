"""Fits against NumPy, SciPy and elements that are known."""

import inspect
import pickle
import warnings

import numpy as np
import pytest

import etalon
from etalon import fit

noise = np.random.default_rng(7)


def test_a_plane_is_that_of_the_singular_value_decomposition():
    points = noise.normal(size=(200, 3)) @ np.diag([50.0, 40.0, 0.02]) + [10.0, 20.0, 30.0]
    turned = points @ np.linalg.qr(noise.normal(size=(3, 3)))[0]
    found = fit.plane(turned)
    centred = turned - turned.mean(axis=0)
    normal = np.linalg.svd(centred)[2][2]
    assert abs(abs(np.dot(found.normal, normal)) - 1) < 1e-12
    assert found.rms_mm == pytest.approx(np.sqrt(np.mean((centred @ normal) ** 2)), rel=1e-9)
    assert np.abs(found.residuals_mm) == pytest.approx(np.abs(centred @ normal), abs=1e-9)


def test_a_sphere_is_that_of_scipy():
    optimize = pytest.importorskip("scipy.optimize")
    direction = noise.normal(size=(300, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    points = [100.0, -50.0, 20.0] + 12.7 * direction + noise.normal(0, 0.005, (300, 3))
    found = fit.sphere(points)
    solved = optimize.least_squares(
        lambda p: np.linalg.norm(points - p[:3], axis=1) - p[3], [100, -50, 20, 12], xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    assert found.center_mm == pytest.approx(solved.x[:3], abs=1e-7)
    assert found.radius_mm == pytest.approx(solved.x[3], abs=1e-7)


def test_a_cylinder_without_noise_is_found():
    angle, height = noise.uniform(0, 2 * np.pi, 100), noise.uniform(-40, 40, 100)
    points = np.column_stack([25 * np.cos(angle), 25 * np.sin(angle), height])
    turn = np.linalg.qr(noise.normal(size=(3, 3)))[0]
    found = fit.cylinder(points @ turn.T + [5.0, 6.0, 7.0])
    assert found.radius_mm == pytest.approx(25.0, abs=1e-9)
    assert abs(np.dot(found.axis, turn[:, 2])) == pytest.approx(1.0, abs=1e-12)


def test_arrays_are_read_where_they_are():
    points = noise.normal(size=(50, 3))
    assert fit.points_of(points) is points
    points.flags.writeable = False
    before = points.copy()
    fit.plane(points)
    assert (points == before).all()
    whole = noise.normal(size=(100, 4))
    assert fit.plane(whole[::2, :3]).rms_mm == pytest.approx(fit.plane(whole[::2, :3].copy()).rms_mm, abs=0)


def test_what_is_no_array_of_points_is_refused():
    with pytest.raises(etalon.Error, match="shape"):
        fit.plane(np.zeros((5, 4)))
    with pytest.raises(etalon.Error) as raised:
        fit.sphere(np.zeros((3, 3)))
    assert raised.value.message and raised.value.messages[0].severity == "error"
    assert str(pickle.loads(pickle.dumps(raised.value))) == str(raised.value)
    with pytest.raises(etalon.Error):
        fit.plane([[0, 0, 0], [1, 0, float("nan")], [0, 1, 0], [1, 1, 0]])
    with pytest.raises(etalon.Error, match="side"):
        fit.sphere(noise.normal(size=(20, 3)), probe_radius_mm=1.0)


@pytest.mark.parametrize(
    "options, id",
    [
        ({"probe_radius_mm": 1.0}, "probe-side-missing"),
        ({"probe_side": "inside"}, "probe-radius-missing"),
        ({"probe_radius_mm": 1.0, "probe_side": "left"}, "probe-side-unknown"),
    ],
)
def test_a_probe_is_refused_as_on_the_command_line(options, id):
    with pytest.raises(etalon.Error) as raised:
        fit.sphere(noise.normal(size=(20, 3)), **options)
    assert raised.value.id == id


def test_a_minimum_zone_is_no_wider_than_the_form_of_least_squares():
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    points = np.column_stack([np.cos(angle), np.sin(angle)]) * (10 + noise.normal(0, 0.01, (40, 1)))
    assert fit.circle2d(points, minimum_zone=True).form_mm <= fit.circle2d(points).form_mm


def test_documents_can_be_read_shown_and_pickled():
    found = fit.sphere(noise.normal(size=(20, 3)))
    assert found.to_dict()["element"] == "sphere" and found["element"] == "sphere"
    assert "<table>" in found._repr_html_()
    again = pickle.loads(pickle.dumps(found))
    assert again.to_dict() == found.to_dict() and (again.residuals_mm == found.residuals_mm).all()
    with pytest.raises(AttributeError):
        found.no_such_member
    with pytest.raises(AttributeError):
        found.element = "plane"


def test_a_rigid_transform_is_found():
    points = noise.normal(size=(6, 3)) * 100
    turn = np.linalg.qr(noise.normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    found = etalon.frames.rigid(points, points @ turn.T + [1.0, 2.0, 3.0])
    assert found.matrix[:3, :3] == pytest.approx(turn, abs=1e-12)
    assert found(points) == pytest.approx(points @ turn.T + [1.0, 2.0, 3.0], abs=1e-10)
    assert found.rms_mm < 1e-10


def test_residuals_of_a_circle_by_orthogonal_distances_are_distances_from_the_curve():
    drawn = np.random.default_rng(5)
    angle = drawn.uniform(0, 2 * np.pi, 400)
    points = np.column_stack([20 * np.cos(angle), 20 * np.sin(angle), drawn.normal(0, 0.1, 400)])
    points[:, :2] += drawn.normal(0, 0.001, (400, 2))
    found = fit.circle(points, orthogonal=True)
    offset = points - found.center_mm
    along = offset @ found.normal
    across = np.linalg.norm(offset - np.outer(along, found.normal), axis=1) - found.radius_mm
    distance = np.hypot(along, across)
    assert found.rms_mm == pytest.approx(np.sqrt(np.mean(distance**2)), rel=1e-9)
    assert found.max_mm == pytest.approx(distance.max(), rel=1e-9)
    assert found.residuals_mm == pytest.approx(distance, abs=1e-9)


def test_a_minimum_zone_has_the_warnings_of_least_squares():
    corners = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    for minimum_zone in (False, True):
        found = fit.plane(corners, minimum_zone=minimum_zone)
        assert "element-ambiguous" in [message.id for message in found.messages]


def test_a_robust_fit_marks_the_points_that_it_leaves_out():
    noise = np.random.default_rng(8)
    points = noise.normal(size=(40, 3))
    points *= 12.7 / np.linalg.norm(points, axis=1, keepdims=True)
    points += noise.normal(0, 0.001, (40, 3))
    points[[3, 17]] *= 1.05
    with pytest.warns(etalon.MessageWarning):
        found = fit.sphere(points, robust=True)
    assert np.flatnonzero(found.is_set_aside).tolist() == [3, 17]
    assert found.radius_mm == pytest.approx(fit.sphere(points[~found.is_set_aside]).radius_mm, abs=1e-9)
    # 5 % of the radius, outside
    assert found.residuals_mm[[3, 17]] == pytest.approx(0.05 * 12.7, abs=0.01)
    assert not fit.sphere(points[:3].repeat(4, axis=0) + noise.normal(size=(12, 3))).is_set_aside.any()


@pytest.mark.parametrize("option", [{"radius_mm": 5.0}, {"weights": np.ones(12)}, {"probe_radius_mm": 1.0, "probe_side": "inside"}, {"robust": True}])
def test_a_minimum_zone_refuses_what_it_would_not_use(option):
    turn = np.linspace(0, 6, 12)
    with pytest.raises(etalon.Error, match=f"`{next(iter(option))}`"):
        fit.circle(np.column_stack([np.cos(turn), np.sin(turn), 0 * turn]), minimum_zone=True, **option)


def test_functions_document_their_own_arguments():
    assert "radius_mm: Holds" in fit.sphere.__doc__ and "axis: Holds" not in fit.sphere.__doc__
    for function in (fit.line, fit.plane, fit.circle, fit.circle2d, fit.sphere, fit.cylinder, fit.cone, fit.torus):
        for name in inspect.signature(function).parameters:
            assert f"\n        {name}: " in function.__doc__, (function.__name__, name)


def test_a_rigid_transform_carries_points_and_a_single_point():
    points = np.array([[0.0, 0, 0], [100, 0, 0], [0, 100, 0], [0, 0, 100]])
    # a quarter turn about z, then (1, 2, 3)
    moved = points[:, [1, 0, 2]] * [-1, 1, 1] + [1.0, 2, 3]
    found = etalon.frames.rigid(points, onto=moved)
    assert found(points) == pytest.approx(moved, abs=1e-9) and found(points[1]) == pytest.approx(moved[1], abs=1e-9)
    assert found(points[1]).shape == (3,) and "rms_mm" in repr(found) and found != 5


def ball(count, seed, scatter=0.003):
    """Touches of a ball of 25.4 mm."""
    drawn = np.random.default_rng(seed)
    direction = drawn.normal(size=(count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    return [100.0, -50, 20] + direction * (12.7 + drawn.normal(0, scatter, (count, 1)))


def test_a_stated_uncertainty_of_a_touch_gives_that_of_the_ball():
    points = ball(12, 0)
    found = fit.sphere(points, standard_uncertainty_um=4)
    away = points - found.center_mm
    jacobian = np.column_stack([-away / np.linalg.norm(away, axis=1, keepdims=True), -np.ones(12)])
    covariance = 0.004**2 * np.linalg.inv(jacobian.T @ jacobian)
    u = found.standard_uncertainty
    assert u.radius_mm == pytest.approx(covariance[3, 3] ** 0.5, rel=1e-6)
    assert u.point_mm == pytest.approx(np.linalg.eigvalsh(covariance[:3, :3]).max() ** 0.5, rel=1e-6)
    assert u.coverage_factor == 2 and found.expanded_uncertainty.radius_mm == pytest.approx(2 * u.radius_mm)
    assert np.isnan(found.expanded_uncertainty.direction_deg)
    # as many touches as parameters
    with pytest.warns(etalon.warning_class("element-without-redundancy")):
        few = fit.sphere(points[:4], standard_uncertainty_um=4)
    assert few.standard_uncertainty.radius_mm > 0
    with pytest.warns(etalon.warning_class("residuals-exceed-points")):
        fit.sphere(points, standard_uncertainty_um=0.1)
    for wrong in (0, -1, "x"):
        with pytest.raises(etalon.Error):
            fit.sphere(points, standard_uncertainty_um=wrong)
    with pytest.raises(etalon.Error, match="`standard_uncertainty_um`"):
        fit.circle(points, minimum_zone=True, standard_uncertainty_um=1)


@pytest.mark.parametrize("count", [5, 6, 8])
def test_expanded_uncertainties_of_few_touches_cover_the_radius(count):
    """Twice the standard uncertainty of five touches contains the radius in two of three balls only."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        balls = [fit.sphere(ball(count, seed)) for seed in range(600)]
    errors = np.array([found.radius_mm - 12.7 for found in balls])
    covered = np.mean([abs(error) < found.expanded_uncertainty.radius_mm for error, found in zip(errors, balls)])
    twice = np.mean([abs(error) < 2 * found.standard_uncertainty.radius_mm for error, found in zip(errors, balls)])
    assert 0.92 < covered < 0.985 and twice < 0.92, (covered, twice)


def test_touches_that_were_copied_are_named():
    points = ball(12, 1)
    with pytest.warns(etalon.warning_class("points-repeated")):
        found = fit.sphere(np.vstack([points] * 3))
    assert next(message for message in found.messages if message.id == "points-repeated").arguments["count"] == 24
    # a scan that is rounded to 0.01 mm
    drawn = np.random.default_rng(2)
    grid = np.round(drawn.uniform(-2, 2, (400, 3)) * [1, 1, 0.002], 2)
    assert "points-repeated" not in {message.id for message in fit.plane(grid).messages}
