"""The simulated operator in a performance test: does the work of each step."""

from crenel.gauges import guide_tasks as tasks
from crenel.gauges.contact.guide_simulation import CONTACT_WORK
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.length.guide_simulation import LENGTH_WORK
from crenel.gauges.plane.guide_simulation import PLANE_WORK
from crenel.gauges.session.simulation import confirm
from crenel.gauges.sphere.guide_simulation import SPHERE_WORK
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import StepWork, act_as_operator, work_on_steps
from crenel.station.jobs import Progress


def simulate(
    guide: PerformanceGuide, operator: SimulatedOperator, whole: bool, progress: Progress
) -> None:
    """Does the present step, or goes on up to the result."""
    work_on_steps(STEPS, guide, operator, whole, progress)


def _confirm_artefact(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    act_as_operator(guide, "confirm_artefact", lambda: tasks.confirm_artefact(guide, None))


def _confirm_temperatures(
    guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress
) -> None:
    confirm(guide)
    if guide.state.step == "review":
        tasks.evaluate(guide, progress)


STEPS: dict[str, StepWork[PerformanceGuide]] = {
    "artefact": _confirm_artefact,
    **SPHERE_WORK,
    **LENGTH_WORK,
    **PLANE_WORK,
    **CONTACT_WORK,
    "temperatures": _confirm_temperatures,
}
