"""What the reference shows: public names by topic, from their docstrings by mkdocstrings, which imports nothing."""

TOPICS: dict[str, list[str]] = {
    "Scenes and code": [
        "symgen.scene.builder.Scene",
        "symgen.scene.scene.SceneRecord",
        "symgen.schema.errors.SceneError",
        "symgen.generate.generate",
        "symgen.fe.body.FlexibleBody",
    ],
    "Models and runs": [
        "runtime.contract.loading.load_model",
        "runtime.contract.model.Model",
        "runtime.running.simulate.simulate",
        "runtime.running.resume.resume",
        "runtime.solutions.solution.Solution",
        "runtime.results.samples.Samples",
        "runtime.contract.status.Status",
        "runtime.schemes.stepper.Stepper",
    ],
    "Working points": [
        "runtime.operating.equilibrium.equilibrium",
        "runtime.operating.equilibrium.Equilibrium",
        "runtime.operating.linearise.linearise",
        "runtime.operating.linearisation.Linearisation",
        "runtime.operating.modes.modes",
        "runtime.operating.campbell.campbell",
        "runtime.operating.campbell.unbalance_response",
        "runtime.operating.modes.mode_motion",
        "runtime.running.driven.quasi_static_motion",
    ],
    "Judging": [
        "runtime.studies.advice.advise.advise",
        "runtime.baselines.scipy_methods.reference_solution",
    ],
    "Pictures": [
        "runtime.views.plots",
        "runtime.views.animation.snapshots",
        "runtime.views.animation.animate",
        "runtime.views.plots.campbell_picture",
    ],
}
HEAD = """# {topic}

From the docstrings, as `help(...)` shows them. Quantities are in SI units; n, n_i and N are the numbers of coordinates,
of independent coordinates and of samples.
"""


def pages() -> dict[str, str]:
    """Markdown of each topic's page by its name."""
    return {
        f"{topic.lower().replace(' ', '-')}.md": HEAD.format(topic=topic) + "".join(f"\n::: {name}\n" for name in names)
        for topic, names in TOPICS.items()
    }
