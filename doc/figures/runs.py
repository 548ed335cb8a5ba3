"""The runs that the documentation shows, and how they are made."""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUTPUT = ROOT / "build" / "figures"
SANDGLASS = ROOT / "build" / "release" / "sandglass"

SILOS = ("plane-flat-bottom", "plane-hopper",
         "axisymmetric-flat-bottom", "axisymmetric-hopper")
MESHES = (1, 2, 3)
DENSITY_UPDATES = ("paper", "separation")


class Run(NamedTuple):
    name: str
    scene: str  # a file of prm/paper without .prm
    settings: tuple = ()
    output: pathlib.Path = OUTPUT
    mode: tuple = ()  # arguments that make the program do another thing

    @property
    def directory(self):
        return self.output / self.name

    @property
    def prm(self):
        return ROOT / "prm" / "paper" / (self.scene + ".prm")


def scene_name(silo, mesh, is_automatic):
    return f"{silo}-mesh-{mesh}" + ("-auto" if is_automatic else "")


def paper_runs():
    """Tables I to IV and Section 5.3, each with both kinds of time step."""
    names = [scene_name(silo, mesh, is_automatic)
             for mesh in reversed(MESHES) for silo in reversed(SILOS)
             for is_automatic in (False, True)]
    names += ["plane-section-5.3", "plane-section-5.3-auto"]
    return [Run(name, name) for name in names]


def density_run(silo, update, is_automatic):
    """The default update is that of the scene's own run."""
    scene = scene_name(silo, 3, is_automatic)
    if update == "separation":
        return Run(scene, scene)
    settings = [f"Particle stage/Density update={update}"]
    if silo.startswith("axisymmetric"):
        settings.append("Particle stage/End time=1.2")
    return Run(f"{scene}-density-{update}", scene, tuple(settings))


def density_runs():
    return [density_run(silo, update, is_automatic)
            for silo in ("axisymmetric-flat-bottom", "plane-flat-bottom")
            for is_automatic in (False, True) for update in DENSITY_UPDATES]


def lip_run(mesh, lip):
    """The free lip is that of the scene's own run."""
    scene = scene_name("plane-flat-bottom", mesh, True)
    if lip == "free":
        return Run(scene, scene)
    return Run(f"{scene}-{lip}-lip", scene, (f"Walls/Outlet lip={lip}",))


def all_runs():
    lips = [lip_run(mesh, "floor") for mesh in reversed(MESHES)]
    return list(dict.fromkeys(paper_runs() + density_runs() + lips))


def input_text(run):
    """What decides the result besides the program: no comments."""
    lines = (line.split("#")[0].strip()
             for line in run.prm.read_text(encoding="utf-8").splitlines())
    return "\n".join([line for line in lines if line] + list(run.settings) +
                     list(run.mode))


def is_up_to_date(run):
    """Whether there is a result of this input, newer than the program."""
    summary = run.directory / "summary.json"
    record = run.directory / "input.txt"  # written when the run has ended
    return (record.exists() and summary.exists() and
            record.read_text(encoding="utf-8") == input_text(run) and
            summary.stat().st_mtime > SANDGLASS.stat().st_mtime)


def make(run):
    """Run it. Runs may break down: then that is what the page shows."""
    if is_up_to_date(run):
        return
    text = input_text(run)
    arguments = [str(SANDGLASS), *run.mode, str(run.prm), "--quiet", "-o",
                 str(run.directory)]
    for setting in run.settings:
        arguments += ["-s", setting]
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    done = subprocess.run(arguments, env=environment, capture_output=True,
                          text=True, check=False)
    print(f"{run.name}: " + ("done" if done.returncode == 0
                             else done.stderr.strip()), file=sys.stderr)
    if done.returncode not in (0, 1):  # refused input leaves nothing to show
        raise SystemExit(1)
    (run.directory / "input.txt").write_text(text, encoding="utf-8")


def make_all(runs):
    jobs = int(os.environ.get("JOBS", os.cpu_count() or 1))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(make, runs))
