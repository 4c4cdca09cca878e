"""Calls in forked processes, in pools, and computations that end early. Each runs in a process of its own, which a hang would not end."""

import os
import signal
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

HEAD = """
import sys, warnings
import numpy as np
import etalon
warnings.simplefilter("ignore")
noise = np.random.default_rng(0)
Q = noise.uniform(-90, 90, (50, 6))
P = etalon.kinematics.direct("ur5", Q)
T = {"pose": np.arange(50), "target": ["SMR"] * 50} | {f"q{i + 1}_deg": Q[:, i] for i in range(6)}
T |= {f"{axis}_mm": P.xyz_mm[:, k] + noise.normal(0, 0.01, 50) for k, axis in enumerate("xyz")}
S = noise.normal(size=(50_000, 3))

def identify(_=0):
    return etalon.identify("ur5", T).residuals.position_rms_mm

def plan(_=0):
    return etalon.plan("ur5", T, 20, targets={"SMR": (10, 0, 30)}, starts=4, nodes=50).value

def sphere(_=0):
    return etalon.fit.sphere(S).radius_mm

def run(_=0):
    return etalon.run(sys.argv[1]).parameters.parameters[0].value

def batch(_=0):
    return len(etalon.batch([sys.argv[1]]).campaigns)

"""


def ran(script, *arguments, seconds=120, **options):
    """Standard output of a script that ends in time."""
    text = HEAD + textwrap.dedent(script)
    done = subprocess.run([sys.executable, "-c", text, *map(str, arguments)], capture_output=True, text=True, timeout=seconds, cwd=Path(__file__).parent, **options)
    assert done.returncode == 0, done.stderr
    return done.stdout


FORK = pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")


@FORK
@pytest.mark.parametrize("task", ["identify", "plan", "sphere"])
def test_a_forked_pool_computes_what_its_parent_has_computed(task):
    """The parent has started the threads of the library, which its children do not have."""
    found = ran(f"""
        import multiprocessing
        own = {task}()
        with multiprocessing.get_context("fork").Pool(2) as pool:
            print(pool.map_async({task}, range(4)).get(60) == [own] * 4)
    """)
    assert found.strip() == "True"


@FORK
@pytest.mark.parametrize("task", ["run", "batch"])
def test_a_forked_pool_runs_campaigns(task, sample):
    """Tables of points and observations are written by another library with threads of its own."""
    found = ran(
        f"""
        import multiprocessing
        own = {task}()
        with multiprocessing.get_context("fork").Pool(1) as pool:
            print(pool.map_async({task}, range(2)).get(60) == [own] * 2)
    """,
        sample("prexyt-cmm"),
    )
    assert found.strip() == "True"


@FORK
def test_a_child_of_a_child_computes():
    found = ran("""
        import os
        own = identify()
        def forked(work):
            read, write = os.pipe()
            if os.fork() == 0:
                os.write(write, repr(work()).encode())
                os._exit(0)
            os.wait()
            return os.read(read, 1000).decode()
        print(forked(lambda: (identify(), forked(identify))))
        print(repr(own))
    """)
    answers, own = found.strip().splitlines()
    assert answers.count(own) == 2, found


def test_process_pool_executor_computes():
    found = ran("""
        import multiprocessing
        from concurrent.futures import ProcessPoolExecutor
        own = identify()
        methods = [m for m in multiprocessing.get_all_start_methods() if m == "fork"]
        context = multiprocessing.get_context(methods[0]) if methods else None
        with ProcessPoolExecutor(2, mp_context=context) as pool:
            print(list(pool.map(identify, range(3))) == [own] * 3)
    """)
    assert found.strip() == "True"


@pytest.mark.parametrize("backend", ["loky", "multiprocessing", "threading"])
def test_joblib_computes(backend):
    pytest.importorskip("joblib")
    found = ran(f"""
        import joblib
        own = identify()
        print(joblib.Parallel(2, backend={backend!r})(joblib.delayed(identify)(i) for i in range(3)) == [own] * 3)
    """)
    assert found.strip() == "True"


def test_an_exception_of_progress_ends_a_search():
    found = ran("""
        def stop(done, whole):
            raise RuntimeError("enough")
        try:
            etalon.plan("ur5", T, 20, targets={"SMR": (10, 0, 30)}, progress=stop)
        except RuntimeError as error:
            print(error)
        print(identify() > 0)
    """)
    assert found.split() == ["enough", "True"]


def interrupted(script):
    """Words that a script prints after Ctrl-C, which comes when it has printed that it begins."""
    process = subprocess.Popen([sys.executable, "-c", HEAD + textwrap.dedent(script)], stdout=subprocess.PIPE, text=True, cwd=Path(__file__).parent)
    try:
        assert process.stdout.readline().strip() == "begins"
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
    finally:
        process.kill()
    return out.split()


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_ctrl_c_ends_a_search():
    script = """
        begun = []

        def progress(done, whole):
            if not begun:
                begun.append(True)
                print("begins", flush=True)

        big = {name: np.resize(column, 3000) for name, column in T.items()}
        big |= {f"q{i + 1}_deg": noise.uniform(-90, 90, 3000) for i in range(6)} | {"pose": np.arange(3000)}
        try:
            etalon.plan("ur5", big, 60, targets={"SMR": (10, 0, 30)}, starts=20_000, nodes=1_000_000, progress=progress)
        except KeyboardInterrupt:
            print("ended")
        # the module computes on
        print(identify() > 0)
    """
    assert interrupted(script) == ["ended", "True"]


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_ctrl_c_ends_inverse_kinematics():
    script = """
        poses = etalon.kinematics.direct("panda", noise.uniform(-80, -10, (1_000_000, 7)))
        try:
            print("begins", flush=True)
            etalon.kinematics.inverse("panda", poses)
        except KeyboardInterrupt:
            print("ended")
    """
    assert interrupted(script) == ["ended"]
