"""Every figure that is measured again, and the commands and rows that are not, with the reason."""

from tests.bench.figures import blocks, claims, performance_tests, pictures, stripes

FIGURES = (
    *blocks.FIGURES,
    *claims.FIGURES,
    *pictures.FIGURES,
    *stripes.FIGURES,
    *performance_tests.FIGURES,
)

IDLE = "its times and its lost frames are those of a machine that does nothing else"
FAULTS_TESTED = "what must not be lost is tested (tests/bench/test_faults_*.py); the rest are times"
NO_FIGURE = "no figure of it is printed"
NOT_MEASURED = {
    "python -m tests.bench lit-boards 10 --first 20": "ten sessions say little; it takes minutes",
    "python -m tests.bench hard-lines --count 24": "it takes minutes",
    "python -m tests.bench parts": "tested with fewer draws (tests/parts/test_inspection.py)",
    "python -m tests.bench deviation --draws 10": "tested with fewer draws "
    "(tests/parts/test_deviation.py)",
    "python -m tests.bench elements --draws 12": "tested with fewer draws "
    "(tests/parts/test_elements.py)",
    "python -m tests.bench closest-points": "it needs libigl",
    "python -m tests.bench lit-lines FOLDER --seed 700000": "photographs that are not ours",
    "python -m tests.bench sync": NO_FIGURE,
    "python -m tests.bench robot-poses": NO_FIGURE,
    "python -m tests.bench pose-explanations": NO_FIGURE,
    "python -m tests.bench held-out": NO_FIGURE,
    "python -m tests.bench live --seconds 600": IDLE,
    "python -m tests.bench view": IDLE,
    "python -m tests.bench viewers": IDLE,
    "python -m tests.bench camera --minutes 10": IDLE,
    "python -m tests.bench faults": FAULTS_TESTED,
    "python -m tests.bench faults --only kills-in-scans": FAULTS_TESTED,
    "python -m tests.bench faults --only floods": FAULTS_TESTED,
    "python -m tests.bench faults --only broker": FAULTS_TESTED,
    "python -m tests.bench start --session SAMPLES/one-pose": IDLE,
    "python -m tests.bench extraction --against PYTHON": "it needs another checkout's Python",
    "python -m tests.bench design-block": "tested with two sensors "
    "(tests/bench/test_design_block.py); all take more than an hour",
    "python -m tests.bench hostile-inputs": FAULTS_TESTED,
    "python -m tests.bench design-board": "tested with four boards "
    "(tests/bench/test_design_board.py), to the same limit",
    "pytest -n0 -s tests/e2e/test_picture.py": "a test, which states its own bound",
    "pytest tests/metrology/test_coordinates.py": "a test, which compares with least squares",
}
"""Commands of docs/accuracy.md."""

README_NOT_MEASURED = {
    "Live scanning with recording": IDLE,
    "Industrial cameras by GigE Vision": "of the tests of the drivers, by the simulated robot",
    "Reports as a page": "no figure",
    "Accounts, control": "no figure",
    "English and German": "no figure",
}
"""Rows of the README's table, by their beginning."""
